"""Blocks, threads, forks and interruptions."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import TIMES_S

import bouncelab as bl


def test_a_detector_gives_each_drop_once_when_it_is_over(sound: bl.Sound) -> None:
    silence = np.zeros(6 * sound.sample_rate_hz, dtype=np.float32)
    both = np.concatenate([sound.samples, silence, sound.samples, silence])
    detector = bl.Detector(sound.sample_rate_hz, draws=None)
    drops = [drop for block in np.array_split(both, 301) for drop in detector.push(block)]
    whole = detector.finish()
    assert len(drops) == len(whole.drops) == 2
    for drop, other in zip(drops, whole.drops, strict=True):
        assert drop.impacts["time_s"].tolist() == other.impacts["time_s"].tolist()


def test_threads_analyse_side_by_side(sound: bl.Sound) -> None:
    expected = bl.analyze(sound.samples, sound.sample_rate_hz, draws=200)
    found: list[bl.Recording] = []

    def work() -> None:
        found.append(bl.analyze(sound.samples, sound.sample_rate_hz, draws=200))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 4


def _forked(_: int) -> float:
    drop = bl.analyze_times(TIMES_S, draws=100, restitution_laws=["constant"]).drops[0]
    return drop.restitution.value


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_pool_forked_after_use_works() -> None:
    """A hundred processes, each forked for one call: one that waited for a thread lost in the fork would hang."""
    expected = _forked(0)
    with multiprocessing.get_context("fork").Pool(2, maxtasksperchild=1) as pool:
        assert pool.map_async(_forked, range(100), chunksize=1).get(timeout=600) == [expected] * 100


def test_a_detector_goes_on_where_it_was_pickled(sound: bl.Sound) -> None:
    silence = np.zeros(6 * sound.sample_rate_hz, dtype=np.float32)
    both = np.concatenate([sound.samples, silence, sound.samples, silence])
    detector, whole = (bl.Detector(sound.sample_rate_hz, draws=None) for _ in range(2))
    drops: list[bl.Drop] = []
    for block in np.array_split(both, 50):
        detector = pickle.loads(pickle.dumps(detector))
        drops += detector.push(block)
    assert [drop.impacts for drop in drops] == [drop.impacts for drop in whole.push(both)]
    assert len(drops) == 2
    assert detector.finish() == whole.finish()


INTERRUPTED = """
import signal
import bouncelab as bl, numpy as np

# What runs in the background of a shell may have been told to ignore it.
signal.signal(signal.SIGINT, signal.default_int_handler)

class Bar:
    def __init__(self, *, desc, **_):
        print(desc, flush=True)
    def update(self, n):
        pass
    def close(self):
        pass

sound = bl.synthesize(bounces=20, restitution=0.9)
samples = np.tile(sound.samples, 1 + SECONDS * sound.sample_rate_hz // len(sound.samples))
try:
    bl.analyze(samples, sound.sample_rate_hz, progress=Bar)
except KeyboardInterrupt:
    print("interrupted")
"""


#: Calls that take long, with what they take.
LONG = {
    "a long silence": "bl.synthesize(tail_s=3600.0)",
    "many draws": "bl.analyze_times(TIMES_S, draws=100_000)",
    "many draws of a session": "bl.session(folder, ball='tennis', draws=100_000, jobs=1)",
    "what a pickle lacks": "again.report()",
}

INTERRUPTED_CALL = """
import pickle, signal, sys, tempfile, warnings
import bouncelab as bl

signal.signal(signal.SIGINT, signal.default_int_handler)
TIMES_S = TIMES
work = sys.argv[1]
folder = tempfile.mkdtemp()
bl.synthesize(bounces=30, restitution=0.9).save(folder + "/drop.wav")
again = pickle.loads(pickle.dumps(bl.analyze_times(TIMES_S, draws=20_000))) if work == "again.report()" else None
print("begun", flush=True)
try:
    eval(work)
    print("done")
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent in another way")
@pytest.mark.parametrize("work", LONG.values(), ids=LONG)
def test_an_interruption_ends_every_call(work: str) -> None:
    code = INTERRUPTED_CALL.replace("= TIMES", f"= {TIMES_S}")
    with subprocess.Popen([sys.executable, "-c", code, work], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None and child.stdout.readline().strip() == "begun"
        # The signal arrives when the call has begun: sooner it would end the line before it, with the same effect.
        time.sleep(0.2)
        sent = time.perf_counter()
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline().strip() == "interrupted"
        print(f"{work}: {time.perf_counter() - sent:.2f} s from the signal to the exception")


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent in another way")
@pytest.mark.parametrize(("work", "seconds"), [("detecting", 3600), ("inferring", 300)])
def test_an_interruption_ends_long_work(work: str, seconds: int) -> None:
    code = INTERRUPTED.replace("SECONDS", str(seconds))
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        while (line := child.stdout.readline().strip()) != work:
            assert line == "detecting"
        sent = time.perf_counter()
        child.send_signal(signal.SIGINT)
        while (line := child.stdout.readline().strip()) == "inferring":
            pass
        assert line == "interrupted"
        print(f"{work}: {time.perf_counter() - sent:.2f} s from the signal to the exception")
