"""What several tests use."""

from __future__ import annotations

import sys

import pytest

import bouncelab as bl

#: The program, in this interpreter.
PROGRAM = [sys.executable, "-m", "bouncelab"]

#: Of a real drop of a table-tennis ball: paper, Table 1.
TIMES_S = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984]


@pytest.fixture(scope="session")
def sound() -> bl.Sound:
    return bl.synthesize(height_m=0.305, restitution=0.95, ball="table-tennis-38", seed=1)


@pytest.fixture(scope="session")
def recording(sound: bl.Sound) -> bl.Recording:
    return bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-38", draws=500)


@pytest.fixture(scope="session")
def times() -> bl.Recording:
    return bl.analyze_times(TIMES_S, draws=500)
