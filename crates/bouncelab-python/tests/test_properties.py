"""What holds for any drop, by Hypothesis."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import bouncelab as bl

heights_m = st.floats(0.1, 1.0)
restitutions = st.floats(0.7, 0.95)
few = settings(max_examples=25, deadline=None, derandomize=True)


@few
@given(heights_m, restitutions, st.integers(0, 1000))
def test_what_was_synthesised_is_found(height_m: float, restitution: float, seed: int) -> None:
    sound = bl.synthesize(height_m=height_m, restitution=restitution, bounces=12, seed=seed)
    recording = bl.analyze(sound.samples, sound.sample_rate_hz, draws=None)
    drop = recording.drops[0]
    assert drop.per_impact is not None and drop.per_impact.restitution is not None
    assert abs(drop.per_impact.restitution.value - restitution) < 0.01
    truth = sound.impacts["time_s"]
    nearest = np.abs(drop.impacts["time_s"][:, None] - truth).min(axis=1)
    assert nearest.max() < 1e-3


@few
@given(heights_m, restitutions)
def test_what_was_simulated_is_inferred(height_m: float, restitution: float) -> None:
    drop = bl.simulate(height_m=height_m, restitution=restitution, bounces=12)
    found = bl.analyze_times(drop.bounces["time_s"], draws=None).drops[0].per_impact
    assert found is not None and found.restitution is not None
    assert abs(found.restitution.value - restitution) < 1e-6


@few
@given(st.lists(st.integers(0, 200_000), max_size=30))
def test_the_blocks_make_no_difference(cuts: list[int]) -> None:
    sound = bl.synthesize(bounces=10, restitution=0.85)
    expected = bl.analyze(sound.samples, sound.sample_rate_hz, draws=None, name="live")
    detector = bl.Detector(sound.sample_rate_hz, draws=None)
    for block in np.split(sound.samples, sorted(cut for cut in cuts if cut < len(sound.samples))):
        if len(block):
            detector.push(block)
    assert detector.finish() == expected
