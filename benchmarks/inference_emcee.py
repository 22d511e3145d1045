"""The posterior of one drop by emcee, on the same model as `bouncelab analyze`.

Constant restitution, constant drag coefficient with a prior, scatter of the impacts as Student's t,
normal errors of the times, contact time with a prior. Written with NumPy and a dense covariance, as
one would write it for one evening's use. Prints both answers and both times.

    python benchmarks/inference_emcee.py [path of the program]
"""

import json
import subprocess
import sys
import tempfile
import time

import emcee
import numpy as np
from scipy.linalg import cholesky, solve_triangular
from scipy.special import gammaln

G0 = 9.80665
MASS, DIAMETER, DENSITY = 2.7e-3, 40e-3, 1.1993139
CONTACT = 1e-3
SIGMA = 5e-5
C_D, C_D_SD = 0.4, 0.04
# Scatter of restitution: ln of it over the typical one is A z + B ((1 + z^2)^1/2 - 1), z standard normal.
SCATTER, SCATTER_A, SCATTER_B = 0.006, 0.85, 0.15
DRAWS = 4000

VOLUME = np.pi * DIAMETER**3 / 6
R = DENSITY * VOLUME / MASS
GRAVITY = G0 * (1 - R) / (1 + R / 2)


def terminal_speed(drag):
    area = np.pi * DIAMETER**2 / 4
    return np.sqrt(2 * (MASS - DENSITY * VOLUME) * G0 / (DENSITY * area * drag))


def scatter_of(z):
    return SCATTER * np.exp(SCATTER_A * z + SCATTER_B * (np.hypot(1, z) - 1))


def launch_speeds(times, terminal):
    """Launch speeds of flights with these times, by Newton on the closed form."""
    theta = GRAVITY * times / terminal
    x = theta / 2
    for _ in range(30):
        f = np.arctan(x) + np.arcsinh(x) - theta
        slope = 1 / (1 + x * x) + 1 / np.sqrt(1 + x * x)
        step = f / slope
        x = x - step
        if np.all(np.abs(step) < 1e-12 * x):
            break
    return x * terminal


def simulate(seed=1):
    rng = np.random.default_rng(seed)
    terminal = terminal_speed(C_D)
    speed = terminal * np.sqrt(1 - np.exp(-2 * GRAVITY * 0.5 / terminal**2))
    t, times = 0.0, []
    for _ in range(40):
        times.append(t + SIGMA * rng.standard_normal())
        launch = speed * 0.945 * np.exp(0.003 * rng.standard_normal())
        x = launch / terminal
        t += terminal / GRAVITY * (np.arctan(x) + np.arcsinh(x)) + CONTACT
        speed = launch / np.sqrt(1 + x * x)
    return np.array(times)


def log_posterior(theta, times):
    logit_e, log_drag, scatter_z, log_timing, log_contact, off = theta
    # Priors: e flat from 0 to 1; the rest normal in the logarithm.
    prior = -np.logaddexp(0, logit_e) - np.logaddexp(0, -logit_e)
    prior -= 0.5 * ((log_drag / C_D_SD) ** 2 + scatter_z**2)
    prior -= 0.5 * ((log_timing / 0.3) ** 2 + (log_contact / 0.5) ** 2)
    e = 1 / (1 + np.exp(-logit_e))
    scatter = scatter_of(scatter_z)
    sigma = SIGMA * np.exp(log_timing)
    terminal = terminal_speed(C_D * np.exp(log_drag))
    flights = np.diff(times) - CONTACT * np.exp(log_contact)
    if np.any(flights <= 0):
        return -np.inf
    launch = launch_speeds(flights, terminal)
    x = launch / terminal
    root = np.sqrt(1 + x * x)
    impact = launch / root
    slope_t = (terminal / GRAVITY) * (1 / (1 + x * x) + 1 / root) / terminal
    log_launch = 1 / (launch * slope_t)
    log_impact = log_launch / (1 + x * x)
    n = len(launch)
    # Row 0 is the drop itself: its height is what the first flight suggests, but for noise.
    residual = np.empty(n)
    residual[0] = off * scatter
    residual[1:] = np.log(launch[1:] / impact[:-1]) - np.log(e)
    jacobian = np.zeros((n, n + 1))
    rows = np.arange(n)
    jacobian[rows, rows] = -log_launch
    jacobian[rows, rows + 1] = log_launch
    jacobian[rows[1:], rows[1:] - 1] += log_impact[:-1]
    jacobian[rows[1:], rows[1:]] -= log_impact[:-1]
    covariance = scatter**2 * np.eye(n) + sigma**2 * jacobian @ jacobian.T
    lower = cholesky(covariance, lower=True)
    z = solve_triangular(lower, residual, lower=True)
    share = scatter**2 / np.diag(covariance)
    nu = np.minimum(4 + 2 / share**2, 1e6)
    density = gammaln((nu + 1) / 2) - gammaln(nu / 2) - 0.5 * np.log(nu - 2)
    density -= 0.5 * (nu + 1) * np.log1p(z**2 / (nu - 2))
    total = density.sum() - np.log(np.diag(lower)).sum() + np.log(log_launch).sum()
    return prior + total + np.log(scatter)


def heights(chain, times):
    out = []
    for logit_e, log_drag, scatter_z, _, log_contact, off in chain:
        e = 1 / (1 + np.exp(-logit_e))
        terminal = terminal_speed(C_D * np.exp(log_drag))
        first = times[1] - times[0] - CONTACT * np.exp(log_contact)
        launch = launch_speeds(np.array([first]), terminal)[0]
        impact = launch / e * np.exp(-off * scatter_of(scatter_z))
        out.append(-(terminal**2) / (2 * GRAVITY) * np.log1p(-((impact / terminal) ** 2)))
    return np.array(out)


def by_emcee(times):
    walkers, dimensions = 32, 6
    rng = np.random.default_rng(1)
    start = np.array([np.log(0.945 / 0.055), 0, 0, 0, 0, 0])
    spread = np.array([0.02, 0.02, 0.1, 0.1, 0.1, 0.3])
    sampler = emcee.EnsembleSampler(walkers, dimensions, log_posterior, args=(times,))
    begin = time.perf_counter()
    state = sampler.run_mcmc(start + spread * rng.standard_normal((walkers, dimensions)), 500)
    sampler.reset()
    steps, effective = 0, 0.0
    while effective < DRAWS and steps < 40000:
        state = sampler.run_mcmc(state, 2000)
        steps += 2000
        tau = sampler.get_autocorr_time(tol=0).max()
        effective = steps * walkers / tau
    seconds = time.perf_counter() - begin
    chain = sampler.get_chain(flat=True, thin=20)
    e = 1 / (1 + np.exp(-chain[:, 0]))
    return seconds, effective, e, C_D * np.exp(chain[:, 1]), heights(chain, times)


def by_bouncelab(program, times):
    with tempfile.NamedTemporaryFile("w", suffix=".txt", delete=False) as file:
        file.write("\n".join(f"{t + 1:.9f}" for t in times))
    arguments = ["--law", "constant", "--drag", f"constant:{C_D}", "--format", "json"]
    begin = time.perf_counter()
    output = subprocess.run([program, "analyze", file.name, *arguments], capture_output=True, check=True)
    seconds = time.perf_counter() - begin
    return seconds, json.loads(output.stdout)["drops"][0]["posterior"]


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "target/release/bouncelab"
    times = simulate()
    theirs, effective, e, drag, height = by_emcee(times)
    ours, found = by_bouncelab(program, times)
    print("| | emcee | bouncelab |")
    print("|---|---|---|")
    for name, values, key in [
        ("e", e, "restitution"),
        ("h0 in m", height, "drop_height_m"),
        ("C_D", drag, "drag_coefficient"),
    ]:
        answer = found[key]
        print(f"| {name} | {np.median(values):.5f} +- {values.std():.5f} | {answer['value']:.5f} +- {answer['sd']:.5f} |")
    print(f"| effective draws | {effective:.0f} | {found['sampling']['effective_draws']:.0f} |")
    print(f"| seconds | {theirs:.1f} | {ours:.3f} (with starting the program) |")


if __name__ == "__main__":
    main()
