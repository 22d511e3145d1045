"""Measure what the package takes: `python benchmarks/measure.py [WHAT...] [--call PROGRAM] [--wheel WHEEL]`.

Run it with a Python in which the wheel is installed, on a machine that does nothing else: the load is printed.
`docs/python.md` has the results.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from multiprocessing.process import BaseProcess
from pathlib import Path
from statistics import median

import numpy as np

import bouncelab as bl

#: As of the usual recording in Python: ten seconds, a thousand draws.
DRAWS = 1000
MB = 2**20


def ten_seconds() -> bl.Sound:
    return bl.synthesize(
        height_m=0.305, restitution=0.93, ball="table-tennis-40", seed=1, lead_in_s=1.0, tail_s=3.2
    )


def wheel(wheel: Path) -> None:
    """Size of the wheel."""
    print(f"wheel: {wheel.stat().st_size / 1e6:.2f} MB")


def importing() -> None:
    """Time of the import, in interpreters of its own."""
    code = (
        "import sys, time; clock, work = time.perf_counter(), time.process_time(); import bouncelab; "
        "print(time.perf_counter() - clock, time.process_time() - work)"
    )
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True) for _ in range(20)]
    times = [tuple(map(float, run.stdout.split())) for run in runs]
    clock, work = (1e3 * median(each) for each in zip(*times, strict=True))
    print(f"import: {clock:.1f} ms, {work:.1f} ms of processor time (median of {len(times)})")


def overhead(call: Path) -> None:
    """A call against one of Rust, in turn, so that other load is on both."""
    sound = ten_seconds()
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "drop.f32"
        sound.samples.tofile(file)
        command = [call, "call", file, str(sound.sample_rate_hz), str(DRAWS), "10"]
        for _ in range(15):
            shown = subprocess.run(command, capture_output=True, text=True, check=True).stdout
            rust = min(map(float, shown.split()))
            python = min(timed(lambda: analyze(sound)) for _ in range(10))
            ratios.append((python / rust, python, rust))
    ratio, python, rust = sorted(ratios)[len(ratios) // 2]
    seconds = len(sound.samples) / sound.sample_rate_hz
    print(
        f"overhead: {100 * (ratio - 1):.1f} % ({1e3 * python:.1f} ms, of Rust {1e3 * rust:.1f} ms; "
        f"{seconds:.1f} s of sound, {DRAWS} draws; median of {len(ratios)} pairs of the best of 10)"
    )


def threads() -> None:
    """What two threads do in the time of one, and two processes, which share nothing."""
    sound = ten_seconds()

    def work() -> None:
        for _ in range(10):
            analyze(sound)

    def together(kind: Callable[..., threading.Thread | BaseProcess], count: int) -> float:
        workers = [kind(target=work) for _ in range(count)]
        start = time.perf_counter()
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        return time.perf_counter() - start

    def ratio(kind: Callable[..., threading.Thread | BaseProcess]) -> float:
        return 2 * together(kind, 1) / together(kind, 2)

    process = multiprocessing.get_context("fork").Process
    ratios = [(ratio(threading.Thread), ratio(process)) for _ in range(9)]
    of_threads, of_processes = (median(each) for each in zip(*ratios, strict=True))
    print(
        f"two threads: {of_threads:.2f} times one; two processes: {of_processes:.2f} times one "
        f"(medians of {len(ratios)})"
    )


def memory() -> None:
    """Peak memory while ten minutes of contiguous float32 are analysed, above that before."""
    if not Path("/proc/self/clear_refs").exists():
        print("memory: this system does not tell the peak")
        return
    sound = ten_seconds()
    frames = 600 * sound.sample_rate_hz
    noise = np.random.default_rng(1).standard_normal(frames, dtype=np.float32)
    noise *= 1e-3
    drops = np.tile(sound.samples, 1 + frames // len(sound.samples))[:frames].copy()
    dense = np.tile(sound.samples[: -2 * sound.sample_rate_hz], 200)[:frames].copy()
    one = noise.copy()
    one[frames // 2 :][: len(sound.samples)] += sound.samples
    for name, samples, draws in (
        ("noise", noise, None),
        ("a drop in noise", one, DRAWS),
        ("drops, pauses of 4 s", drops, None),
        ("drops, pauses of 2 s", dense, None),
    ):
        before = held_mb("VmRSS", reset=True)
        found = bl.analyze(samples, sound.sample_rate_hz, draws=draws)
        more = held_mb("VmHWM") - before
        print(f"memory, {name}: {more:.1f} MB more than the array of {samples.nbytes / MB:.0f} MB; {found!r}")


def forks() -> None:
    """Pools forked after use in the parent."""
    sound = ten_seconds()
    analyze(sound)
    finished = 0
    for _ in range(100):
        with multiprocessing.get_context("fork").Pool(2) as pool:
            pool.map_async(restitution, [sound.samples] * 2).get(timeout=60)
            finished += 1
    print(f"forks: {finished} of 100 pools without a hang")


def restitution(samples: np.ndarray[tuple[int, ...], np.dtype[np.float32]]) -> float:
    return bl.analyze(samples, 44_100, draws=200).drops[0].restitution.value


def analyze(sound: bl.Sound) -> bl.Recording:
    return bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-40", draws=DRAWS)


def timed(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def held_mb(what: str, *, reset: bool = False) -> float:
    """Memory of this process as Linux tells it; the peak can be set to what is held now."""
    if reset:
        Path("/proc/self/clear_refs").write_text("5")
    status = Path("/proc/self/status").read_text()
    return int(status.split(f"{what}:")[1].split()[0]) / 1024


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    free: dict[str, Callable[[], None]] = {
        "import": importing, "threads": threads, "memory": memory, "forks": forks,
    }  # fmt: skip
    parser.add_argument("what", nargs="*", help=f"{', '.join(free)}; all if left out")
    parser.add_argument("--call", type=Path, help="the measuring programs, `bouncelab-bench`")
    parser.add_argument("--wheel", type=Path, help="the wheel that is installed")
    asked = parser.parse_args()
    load, cores = os.getloadavg()[0], os.cpu_count()
    print(f"bouncelab {bl.__version__}, Python {sys.version.split()[0]}, {cores} cores, load before {load:.1f}")
    if asked.wheel:
        wheel(asked.wheel)
    if asked.call:
        overhead(asked.call)
    for name in asked.what or free:
        free[name]()


if __name__ == "__main__":
    main()
