"""The likelihood for models of a researcher's own."""

from __future__ import annotations

import math
import time

import numpy as np
import pytest

import bouncelab as bl

BALL = "table-tennis-40"
LAW = "linear:0.95,0.01"
TRUE = bl.simulate(height_m=0.305, restitution=LAW, bounces=12, ball=BALL)
TIMES_S = TRUE.bounces["time_s"]
RESTITUTIONS = TRUE.bounces["restitution"][:-1].astype(float)
SIGMA_S = 2e-5


@pytest.mark.parametrize("drag", ["standard", "constant:0.5", "none"])
def test_the_times_of_a_simulation_have_no_residuals(drag: str) -> None:
    """The simulation integrates each flight by itself; here polynomials stand for all of them."""
    drop = bl.simulate(height_m=0.4, restitution=0.9, bounces=15, ball=BALL, drag=drag)
    likelihood = bl.LogLikelihood(drop.bounces["time_s"], SIGMA_S, ball=BALL, drag=drag)
    count = len(drop.bounces)
    least = -0.5 * count * math.log(2 * math.pi * SIGMA_S**2) + 0.5 * math.log(2 * math.pi * SIGMA_S**2 / count)
    assert float(likelihood(np.full(count - 1, 0.9), 0.4)) == pytest.approx(least, abs=0.01)


def test_it_is_the_density_of_the_times() -> None:
    """Integrated over the time of the first impact by quadrature, from the times of a simulation."""
    rng = np.random.default_rng(1)
    sigmas = rng.uniform(1e-4, 3e-4, len(TIMES_S))
    measured = TIMES_S + sigmas * rng.standard_normal(len(TIMES_S))
    other = bl.simulate(height_m=0.3052, restitution=LAW, bounces=12, ball=BALL).bounces
    kept, other_s = other["restitution"][:-1], other["time_s"]
    shifts = np.linspace(-3e-3, 3e-3, 20_001)
    residuals = (measured - measured[0] - (other_s - other_s[0]))[None, :] - shifts[:, None]
    logs = -0.5 * (residuals / sigmas) ** 2 - 0.5 * np.log(2 * np.pi * sigmas**2)
    expected = math.log(np.trapezoid(np.exp(logs.sum(axis=1) - logs.sum(axis=1).max()), shifts)) + logs.sum(axis=1).max()
    found = bl.LogLikelihood(measured, sigmas, ball=BALL)(kept, 0.3052)
    assert float(found) == pytest.approx(expected, abs=1e-3)


def test_the_gradient_is_that_of_differences() -> None:
    likelihood = bl.LogLikelihood(TIMES_S, 1e-3, ball=BALL)
    rng = np.random.default_rng(2)
    count = len(RESTITUTIONS)
    start = np.concatenate([RESTITUTIONS * (1 + 1e-3 * rng.standard_normal(count)), [0.304, 1.05, 0.0008]])

    def value(parameters: np.ndarray) -> np.ndarray:
        return likelihood(parameters[..., :count], *np.moveaxis(parameters[..., count:], -1, 0))

    _, gradient = likelihood.with_gradient(start[:count], *start[count:])
    found = [*gradient.restitution, gradient.height_m, gradient.drag_scale, gradient.contact_time_s]
    steps = np.diag(1e-6 * start)
    expected = (value(start + steps) - value(start - steps)) / (2e-6 * start)
    assert np.allclose(found, expected, rtol=1e-5, atol=1e-5 * np.abs(expected).max())


def test_parameters_broadcast_and_a_law_is_followed() -> None:
    likelihood = bl.LogLikelihood(TIMES_S, SIGMA_S, ball=BALL)
    heights_m = np.linspace(0.29, 0.32, 5)
    by_impact = likelihood(RESTITUTIONS, heights_m)
    assert by_impact.shape == (5,)
    assert likelihood(np.tile(RESTITUTIONS, (3, 1, 1)), heights_m, np.ones((3, 1))).shape == (3, 5)
    law = likelihood(lambda v_m_s: 0.95 - 0.01 * v_m_s, 0.305)
    assert float(law) == pytest.approx(float(likelihood(RESTITUTIONS, 0.305)), abs=1e-3)
    assert float(likelihood(RESTITUTIONS, -1.0)) == float(likelihood(RESTITUTIONS, 0.305, 9.0)) == -math.inf


def test_a_thousand_at_once(capsys: pytest.CaptureFixture[str]) -> None:
    likelihood = bl.LogLikelihood(TIMES_S, SIGMA_S, ball=BALL)
    heights_m = np.linspace(0.3, 0.31, 1000)
    for name, call in (("values", likelihood), ("gradients", likelihood.with_gradient)):
        taken = []
        for _ in range(10):
            begun = time.process_time()
            assert np.shape(call(RESTITUTIONS, heights_m)[0]) in ((), (1000,))
            taken.append(time.process_time() - begun)
        with capsys.disabled():
            print(f"\n1,000 {name} of {len(TIMES_S)} impacts: {1e3 * min(taken):.1f} ms of processor time")


@pytest.mark.parametrize("times_s", [[0.0], [0.0, 0.0], [[0.0, 1.0]]])
def test_what_is_no_drop_is_refused(times_s: list[float]) -> None:
    with pytest.raises(bl.InputError):
        bl.LogLikelihood(times_s, SIGMA_S, ball=BALL)


def test_what_it_takes_is_said() -> None:
    with pytest.raises(bl.InputError, match="ball="):
        bl.LogLikelihood(TIMES_S, SIGMA_S)
    likelihood = bl.LogLikelihood(TIMES_S, SIGMA_S, ball=BALL)
    with pytest.raises(bl.InputError, match="11 restitutions"):
        likelihood([0.9], 0.3)
    with pytest.raises(bl.InputError, match="broadcast"):
        likelihood(np.full((2, 11), 0.9), [0.3, 0.3, 0.3])
    with pytest.raises(bl.InputError, match="gradient"):
        likelihood.with_gradient(lambda v_m_s: v_m_s, 0.3)  # type: ignore[arg-type,return-value]
