"""Bad input is an exception of the package that says what to do, and nothing else."""

from __future__ import annotations

import tarfile
from collections.abc import Callable
from os import environ
from pathlib import Path

import numpy as np
import pytest
from conftest import TIMES_S

import bouncelab as bl
from bouncelab import batch

SAMPLES = np.zeros(4410, dtype=np.float32)

WRONG: dict[str, Callable[[], object]] = {
    "no source": lambda: bl.analyze(None),  # type: ignore[arg-type]
    "a number": lambda: bl.analyze(3),  # type: ignore[arg-type]
    "a list": lambda: bl.analyze([0.0, 1.0], 44_100),  # type: ignore[arg-type]
    "no such file": lambda: bl.analyze("nowhere.wav"),
    "a folder": lambda: bl.analyze("."),
    "no bytes": lambda: bl.analyze(b""),
    "no sound": lambda: bl.analyze(b"no sound at all"),
    "text": lambda: bl.analyze(open(__file__)),  # type: ignore[arg-type]  # noqa: SIM115
    "a rate for a file": lambda: bl.analyze("drop.wav", 44_100),
    "no rate": lambda: bl.analyze(SAMPLES),
    "a rate of text": lambda: bl.analyze(SAMPLES, "44100"),  # type: ignore[arg-type]
    "half a rate": lambda: bl.analyze(SAMPLES, 44_100.5),
    "a negative rate": lambda: bl.analyze(SAMPLES, -44_100),
    "no rate at all": lambda: bl.analyze(SAMPLES, float("nan")),
    "a low rate": lambda: bl.analyze(SAMPLES, 100),
    "a huge rate": lambda: bl.analyze(SAMPLES, 2e9),
    "three dimensions": lambda: bl.analyze(np.zeros((10, 2, 2)), 44_100),
    "no dimension": lambda: bl.analyze(np.float32(1.0), 44_100),  # type: ignore[arg-type]
    "channels first": lambda: bl.analyze(np.zeros((2, 44_100)), 44_100),
    "too many channels": lambda: bl.analyze(np.zeros((1000, 100)), 44_100),
    "no samples": lambda: bl.analyze(np.zeros(0), 44_100),
    "a sample that is no number": lambda: bl.analyze(np.where(np.arange(4410) == 3, np.nan, SAMPLES), 44_100),
    "an infinite sample": lambda: bl.Detector(44_100).push(np.full(4410, np.inf)),
    "a pattern of nothing": lambda: bl.analyze("no/*.wav"),
    "a store that is not": lambda: bl.analyze("nostore://drop.wav"),
    "nothing in a store": lambda: bl.analyze("memory://nowhere.wav"),
    "a diameter without mass": lambda: bl.analyze_times(TIMES_S, diameter_m=0.04),
    "a sound as FLAC": lambda: bl.synthesize(bounces=2).save("drop.flac"),
    "a manifest of nowhere": lambda: batch.manifest("nowhere", "manifest.parquet"),
    "no channels": lambda: bl.analyze(np.zeros((10, 0)), 44_100),
    "complex samples": lambda: bl.analyze(np.zeros(10, dtype=complex), 44_100),
    "samples of text": lambda: bl.analyze(np.array(["a", "b"]), 44_100),
    "samples of objects": lambda: bl.analyze(np.array([None, 1]), 44_100),
    "flags": lambda: bl.analyze(np.zeros(10, dtype=bool), 44_100),
    "a missing channel": lambda: bl.analyze(SAMPLES, 44_100, channel=2),
    "channel 0": lambda: bl.analyze(SAMPLES, 44_100, channel=0),
    "no band": lambda: bl.analyze(SAMPLES, 44_100, band_hz=(1.0, 2.0)),
    "a band upside down": lambda: bl.analyze(SAMPLES, 44_100, band_hz=(2000.0, 400.0)),
    "progress that is a number": lambda: bl.analyze(SAMPLES, 44_100, progress=3),  # type: ignore[arg-type]
    "a name of bytes": lambda: bl.analyze(SAMPLES, 44_100, name=b"x"),  # type: ignore[arg-type]
    "times that fall": lambda: bl.analyze_times([1.0, 0.5, 2.0]),
    "a time twice": lambda: bl.analyze_times([0.0, 0.5, 0.5]),
    "no time": lambda: bl.analyze_times([0.0, float("nan")]),
    "an endless time": lambda: bl.analyze_times([0.0, float("inf")]),
    "times of text": lambda: bl.analyze_times(["a", "b"]),  # type: ignore[list-item]
    "times in rows": lambda: bl.analyze_times([[0.0, 1.0]]),  # type: ignore[list-item]
    "ragged times": lambda: bl.analyze_times([[0.0], [1.0, 2.0]]),  # type: ignore[list-item]
    "no list": lambda: bl.analyze_times(None),  # type: ignore[arg-type]
    "an unknown ball": lambda: bl.analyze_times(TIMES_S, ball="tenniss"),
    "a ball of 3": lambda: bl.analyze_times(TIMES_S, ball=3),  # type: ignore[arg-type]
    "a ball without size": lambda: bl.analyze_times(TIMES_S, mass_kg=0.0027),
    "a ball below nothing": lambda: bl.analyze_times(TIMES_S, mass_kg=-1.0, diameter_m=0.04),
    "steel of text": lambda: bl.analyze_times(TIMES_S, ball="steel:thick"),
    "a balloon": lambda: bl.analyze_times(TIMES_S, mass_kg=1e-6, diameter_m=0.04),
    "air of numbers": lambda: bl.analyze_times(TIMES_S, air=1.2),  # type: ignore[arg-type]
    "air below nothing": lambda: bl.analyze_times(TIMES_S, air=bl.Air(-1.0, 1e-5)),
    "an unknown drag law": lambda: bl.analyze_times(TIMES_S, drag="heavy"),
    "an unknown option": lambda: bl.analyze_times(TIMES_S, hight_m=0.3),  # type: ignore[call-arg]
    "a height of text": lambda: bl.analyze_times(TIMES_S, height_m="30 cm"),  # type: ignore[arg-type]
    "a height of arrays": lambda: bl.analyze_times(TIMES_S, height_m=np.ones(2)),  # type: ignore[arg-type]
    "no height": lambda: bl.analyze_times(TIMES_S, height_m=float("nan")),
    "a height below 0": lambda: bl.analyze_times(TIMES_S, height_m=-0.3),
    "few draws": lambda: bl.analyze_times(TIMES_S, draws=10),
    "a million draws": lambda: bl.analyze_times(TIMES_S, draws=1_000_000),
    "half a draw": lambda: bl.analyze_times(TIMES_S, draws=100.5),  # type: ignore[arg-type]
    "draws of truth": lambda: bl.analyze_times(TIMES_S, draws=True),
    "a negative seed": lambda: bl.analyze_times(TIMES_S, seed=-1),
    "an unknown law": lambda: bl.analyze_times(TIMES_S, restitution_laws=["cubic"]),
    "a law as text": lambda: bl.analyze_times(TIMES_S, restitution_laws="linear"),
    "an unknown question": lambda: bl.analyze_times(TIMES_S, infer=["mass"]),
    "flights upside down": lambda: bl.analyze_times(TIMES_S, flights=(10, 1)),
    "one flight end": lambda: bl.analyze_times(TIMES_S, flights=(1,)),  # type: ignore[arg-type]
    "a target of text": lambda: bl.analyze_times(TIMES_S, reach=[("a", 1.0)]),  # type: ignore[list-item]
    "a target of one": lambda: bl.analyze_times(TIMES_S, reach=[(1,)]),  # type: ignore[list-item]
    "an unknown language": lambda: bl.analyze_times(TIMES_S, draws=None).to_dict("xx"),
    "an unknown figure": lambda: bl.analyze_times(TIMES_S, draws=None).figure("posterior"),
    "a figure of bytes": lambda: bl.analyze_times(TIMES_S, draws=None).figure(b"drag"),  # type: ignore[arg-type]
    "an unknown ending": lambda: bl.analyze_times(TIMES_S, draws=None).figure("drag").save("drag.bmp"),
    "a folder that is not": lambda: bl.analyze_times(TIMES_S, draws=None).figure("drag").save("no/where.svg"),
    "a huge picture": lambda: bl.analyze_times(TIMES_S, draws=None).figure("drag").png(10_000_000),
    "a panel that is not": lambda: bl.analyze_times(TIMES_S, draws=None).figure("drag").to_matplotlib(panel=9),
    "a negative Reynolds number": lambda: bl.drag_coefficient([-1.0]),
    "no Reynolds number": lambda: bl.drag_coefficient(["a"]),
    "a table beyond its end": lambda: bl.drag_coefficient([1e9], law="table:1000=0.5"),
    "air of shapes": lambda: bl.air_density_kg_m3([290.0, 300.0], [1e5, 1e5, 1e5]),
    "cold airs": lambda: bl.air_viscosity_pa_s([290.0, 10.0]),
    "two quantities of a flight": lambda: bl.flights([1.0], apex_m=[0.1]),
    "no quantity of a flight": lambda: bl.flights(),
    "a flight downwards": lambda: bl.flights([-1.0]),
    "flights in rows": lambda: bl.flights([[1.0]]),
    "a fall from below": lambda: bl.falls([-1.0]),
    "a fall of text": lambda: bl.falls(["high"]),
    "an unknown ball falls": lambda: bl.terminal_speed_m_s(ball="tenniss"),
    "cold air": lambda: bl.air(-1.0),
    "wet air": lambda: bl.air(293.0, 101_325.0, 2.0),
    "air of text": lambda: bl.air("warm"),  # type: ignore[arg-type]
    "beyond the pole": lambda: bl.gravity_m_s2(91.0),
    "a drop that gains": lambda: bl.simulate(restitution=1.2),
    "an endless drop": lambda: bl.simulate(restitution=1.0, drag="none"),
    "a drop from below": lambda: bl.simulate(height_m=-1.0),
    "bounces of text": lambda: bl.simulate(bounces="ten"),  # type: ignore[arg-type]
    "an unknown voice": lambda: bl.synthesize(voice="bell"),
    "an unknown noise": lambda: bl.synthesize(noise="brown"),
    "a lost share above 1": lambda: bl.synthesize(lost=2.0),
    "a detector without channels": lambda: bl.Detector(44_100, 0),
    "a block of other channels": lambda: bl.Detector(44_100, 2).push(SAMPLES),
}


@pytest.mark.parametrize("wrong", WRONG.values(), ids=WRONG.keys())
def test_only_exceptions_of_the_package_come_out(wrong: Callable[[], object]) -> None:
    with pytest.raises(bl.BouncelabError) as raised:
        wrong()
    assert len(str(raised.value)) > 15, "it says what to do"


def test_the_kinds_are_those_of_python_too() -> None:
    with pytest.raises(FileNotFoundError):
        bl.analyze("nowhere.wav")
    with pytest.raises(ValueError, match="tennis"):
        bl.analyze_times(TIMES_S, ball="tenniss")


@pytest.mark.parametrize("value", [1e30, -1e-40])
def test_odd_samples_are_no_drop_and_no_failure(value: float) -> None:
    samples = np.full(44_100, value, dtype=np.float64)
    assert bl.analyze(samples, 44_100).no_drop is not None


@pytest.mark.skipif("BOUNCELAB_ROOT" not in environ, reason="the corpus is part of the repository")
def test_the_corpus_of_fuzzing_raises_nothing_else() -> None:
    with tarfile.open(Path(environ["BOUNCELAB_ROOT"]) / "fuzz" / "corpus.tar.gz") as corpus:
        files = [(file.name, corpus.extractfile(file)) for file in corpus if file.isfile()]
        refused = 0
        for name, content in files:
            assert content is not None
            kind = name.split("/")[1]
            called = f"x.{kind}" if kind in ("csv", "txt", "json") else f"{kind}.wav"
            try:
                bl.analyze(content.read(), name=called, draws=None)
            except bl.BouncelabError:
                refused += 1
    assert 0 < refused < len(files)
