"""What goes in: paths, bytes, files, arrays, lists of times."""

from __future__ import annotations

import io
import wave
from pathlib import Path

import numpy as np
import pytest
from conftest import TIMES_S

import bouncelab as bl
from bouncelab._core import setting_names
from bouncelab._settings import GROUPS
from bouncelab._analyze import as_samples


def restitution(recording: bl.Recording) -> float:
    found = recording.drops[0].per_impact
    assert found is not None and found.restitution is not None
    return found.restitution.value


def test_every_kind_of_source_says_the_same(sound: bl.Sound, tmp_path: Path) -> None:
    file = tmp_path / "drop.wav"
    sound.save(file)
    with file.open("rb") as opened:
        given = [str(file), file, file.read_bytes(), io.BytesIO(file.read_bytes()), opened]
        found = [bl.analyze(source, draws=None) for source in given]
    assert len({restitution(recording) for recording in found}) == 1
    assert {recording.source.format for recording in found} == {"16-bit WAV"}


def test_an_array_says_what_it_was_made_of(sound: bl.Sound) -> None:
    recording = bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-38", draws=500)
    drop = recording.drops[0]
    assert abs(drop.restitution.value - 0.95) < 4 * drop.restitution.sd + 0.002
    # The first fall is not heard: its height is that before the first impact.
    assert drop.drop_height_m.interval95[0] < 0.305 < drop.drop_height_m.interval95[1]
    truth = sound.impacts["time_s"][: len(drop.impacts)]
    assert np.allclose(drop.impacts["time_s"], truth, atol=1e-3)


@pytest.mark.parametrize("dtype", ["int64", "uint64"])
def test_64_bit_integers_have_no_full_scale(dtype: str) -> None:
    """NumPy makes them of lists of 16-bit samples."""
    with pytest.raises(bl.InputError, match="samples / 32768"):
        bl.analyze(np.arange(1000, dtype=dtype), 44_100)


@pytest.mark.parametrize("dtype", ["float64", ">f4", "float16", "int16", "int32", "uint8"])
def test_types_of_samples_make_no_difference(sound: bl.Sound, dtype: str) -> None:
    scale = {"int16": 2**15, "int32": 2**31, "uint8": 2**7}.get(dtype, 1)
    offset = 128 if dtype == "uint8" else 0
    samples = np.clip(sound.samples * (scale * 0.99) + offset, -(2**31), 2**31 - 1).astype(dtype)
    recording = bl.analyze(samples, sound.sample_rate_hz, draws=None)
    expected = bl.analyze(sound.samples, sound.sample_rate_hz, draws=None)
    assert restitution(recording) == pytest.approx(restitution(expected), abs=0.005)


def test_the_channel_with_the_drop_is_found(sound: bl.Sound) -> None:
    both = np.stack([np.zeros_like(sound.samples), sound.samples], axis=1)
    recording = bl.analyze(both, sound.sample_rate_hz, draws=None)
    assert recording.source.channel == 2
    assert bl.analyze(both, sound.sample_rate_hz, draws=None, channel=1).no_drop is not None


def test_strided_and_read_only_arrays_are_read(sound: bl.Sound) -> None:
    expected = bl.analyze(sound.samples, sound.sample_rate_hz, draws=None)
    twice = np.repeat(sound.samples, 2)[::2]
    fixed = sound.samples.copy()
    fixed.flags.writeable = False
    for samples in (twice, fixed, memoryview(fixed)):
        assert restitution(bl.analyze(samples, sound.sample_rate_hz, draws=None)) == restitution(expected)


def test_contiguous_floats_are_read_in_place() -> None:
    samples = np.zeros((44_100, 2), dtype=np.float32)
    samples.flags.writeable = False
    assert np.shares_memory(as_samples(samples), samples)
    assert not np.shares_memory(as_samples(samples[:, 0]), samples)


@pytest.mark.parametrize("channel", [None, 1, 2])
def test_channels_of_an_array_are_those_of_its_file(sound: bl.Sound, tmp_path: Path, channel: int | None) -> None:
    """Sound that goes on for longer than is remembered, in which the second channel parts company late."""
    left = np.tile(sound.samples[::4], 25)
    right = left.copy()
    right[len(right) // 2 :] *= 0.5
    both = (np.stack([left, right], axis=1) * 2**15).round().clip(-(2**15), 2**15 - 1).astype("<i2")
    with wave.open(str(tmp_path / "both.wav"), "wb") as file:
        file.setnchannels(2)
        file.setsampwidth(2)
        file.setframerate(11_025)
        file.writeframes(both.tobytes())
    from_file = bl.analyze(tmp_path / "both.wav", draws=None, channel=channel)
    from_array = bl.analyze(both, 11_025, draws=None, channel=channel)
    assert len(from_array.drops) > 10
    assert from_array.drops == from_file.drops


def test_options_are_the_settings_of_the_science() -> None:
    """Names and groups are those of `Settings` in Rust, but for what Python states in another way."""
    options = {group: set(names) for group, names in GROUPS.items()}
    options["ball"] = options["ball"] - {"ball"} | {"kind"}
    options["air"] -= {"air"}
    options["inference"] |= {"enabled"}
    assert options == {group: set(names) for group, names in setting_names().items()}


def test_air_may_be_a_density() -> None:
    by_object = bl.analyze_times(TIMES_S, draws=None, air=bl.Air(density_kg_m3=1.1, viscosity_pa_s=1.8e-5))
    by_number = bl.analyze_times(TIMES_S, draws=None, density_kg_m3=1.1, viscosity_pa_s=1.8e-5)
    assert by_object.settings == by_number.settings


def test_settings_reach_the_physics() -> None:
    known = dict(mass_kg=0.0025, diameter_m=0.038, gravity_m_s2=9.81, drag="constant:0.4", contact_time_s=5e-4)
    used = bl.analyze_times(TIMES_S, draws=None, air=bl.air(300.0), **known).settings
    assert (used.ball.mass_kg, used.ball.diameter_m, used.gravity.gravity_m_s2) == (0.0025, 0.038, 9.81)
    assert (used.air.drag, used.ball.contact_time_s) == ("constant:0.4", 5e-4)
    assert used.air.density_kg_m3 == bl.air(300.0).density_kg_m3
    assert used.assumptions == ()


def test_edits_and_questions_are_heeded() -> None:
    extra = sorted([*TIMES_S, 0.8])
    recording = bl.analyze_times(extra, draws=200, exclude_s=[0.8], reach=[(2, 0.2)], first_detected=True)
    assert recording.impacts["time_s"].tolist() == TIMES_S
    [prediction] = recording.drops[0].posterior.predictions
    assert prediction.drop_height_m is not None
    assert 0.2 < prediction.drop_height_m.value < 0.4


def test_tqdm_shows_the_progress(sound: bl.Sound, capsys: pytest.CaptureFixture[str]) -> None:
    tqdm = pytest.importorskip("tqdm").tqdm
    long = np.tile(sound.samples, 80)
    bl.analyze(long, sound.sample_rate_hz, draws=None, progress=tqdm)
    assert "detecting" in capsys.readouterr().err


def test_progress_is_that_of_tqdm(sound: bl.Sound) -> None:
    class Bar:
        made: list[Bar] = []

        def __init__(self, *, total: float | None, desc: str, unit: str) -> None:
            self.total, self.unit, self.done, self.closed = total, unit, 0.0, False
            self.made.append(self)

        def update(self, n: float) -> None:
            assert n >= 0
            self.done += n

        def close(self) -> None:
            self.closed = True

    long = np.tile(sound.samples, 80)
    bl.analyze(long, sound.sample_rate_hz, draws=None, progress=Bar)
    assert all(bar.closed for bar in Bar.made)
    assert [bar.unit for bar in Bar.made][:1] == ["s"]
    assert 0 < Bar.made[0].done <= len(long) / sound.sample_rate_hz


def test_paths_may_be_lists_patterns_and_urls(sound: bl.Sound, tmp_path: Path) -> None:
    sound.save(tmp_path / "a.wav")
    bl.synthesize(bounces=12, seed=2).save(tmp_path / "b.wav")
    alone = bl.analyze(tmp_path / "a.wav", draws=None)
    several = bl.analyze([tmp_path / "a.wav", tmp_path / "b.wav"], draws=None)
    assert several == (alone, bl.analyze(tmp_path / "b.wav", draws=None))
    assert bl.analyze(str(tmp_path / "a*.wav"), draws=None) == alone
    with pytest.raises(bl.InputError, match="matches 2 files"):
        bl.analyze(str(tmp_path / "*.wav"), draws=None)
    study = bl.session(str(tmp_path / "*.wav"), ball="table-tennis-38", draws=None)
    assert len(study.drops) == 2
    with pytest.raises(bl.SessionError, match='"surface"'):
        bl.session(str(tmp_path / "*.wav"), ball="table-tennis-38", draws=None, by="surface")
    fsspec = pytest.importorskip("fsspec")
    memory = fsspec.filesystem("memory")
    memory.put(str(tmp_path / "a.wav"), "/folder/a.wav")
    memory.put(str(tmp_path / "b.wav"), "/folder/b.wav")
    assert bl.analyze("memory://folder/a.wav", draws=None).drops[0] == alone.drops[0]
    assert len(bl.session("memory://folder", ball="table-tennis-38", draws=None).drops) == 2
    assert bl.verdict(str(tmp_path / "a.wav"), "ittf-ball", draws=200).outcome in ("pass", "fail", "cannot-decide")


def test_drag_is_a_table_of_ones_own() -> None:
    """As text, mapping, pairs, array, and a function: all the same; one that is the usual law, nearly the usual numbers."""
    numpy = pytest.importorskip("numpy")
    points = {1e2: 1.1, 1e4: 0.64, 1e5: 0.58}
    reynolds = [1e3, 2e4, 9e4]
    expected = bl.drag_coefficient(reynolds, "table:100=1.1,10000=0.64,100000=0.58")
    for law in (points, list(points.items()), numpy.array([*points.items()])):
        assert (bl.drag_coefficient(reynolds, law) == expected).all()
    fall = bl.simulate(bounces=5, drag=lambda reynolds: float(bl.drag_coefficient(reynolds)))
    assert fall.bounces["apex_m"] == pytest.approx(bl.simulate(bounces=5).bounces["apex_m"], rel=1e-4)
    drop = bl.analyze_times(TIMES_S, ball="table-tennis-40", drag=lambda reynolds: 0.5, draws=None)
    assert "table:" in drop.settings.air.drag
    for wrong in ([1.0], {1e4: "thick"}, {}, [(1e4, 0.6, 1.0)]):
        with pytest.raises(bl.BouncelabError):
            bl.drag_coefficient(reynolds, wrong)  # type: ignore[arg-type]


def test_a_simulation_has_restitutions_of_its_own_and_scatter() -> None:
    numpy = pytest.importorskip("numpy")
    each = [0.9, 0.8, 0.7]
    made = bl.simulate(restitution=each)
    assert made.bounces["restitution"].tolist() == each
    assert bl.simulate(restitution=numpy.array(each), bounces=2).bounces["restitution"].tolist() == each[:2]
    for law in bl.restitution_laws():
        assert len(bl.simulate(restitution=law.example, bounces=3).bounces) == 3
    scattered = [bl.simulate(restitution=[0.8] * 50, scatter=0.01, seed=seed).bounces for seed in range(20)]
    logs = numpy.log(numpy.concatenate([it["restitution"] for it in scattered]) / 0.8)
    assert len(logs) == 1000 and abs(logs.mean()) < 0.0015 and 0.009 < logs.std() < 0.011
    assert bl.simulate(scatter=0.01, seed=1) == bl.simulate(scatter=0.01, seed=1) != bl.simulate(scatter=0.01, seed=2)
    ball = bl.simulate(restitution=each, ball="table-tennis-40", contact_time_s=0.002)
    assert ball.contact_time_s == 0.002
    still = bl.simulate(restitution=each, ball="table-tennis-40", contact_time_s=0.0)
    assert ball.bounces["time_s"] - still.bounces["time_s"] == pytest.approx([0.0, 0.002, 0.004])
    for wrong in ({"restitution": []}, {"restitution": [1.5]}, {"scatter": -1.0}):
        with pytest.raises(bl.InputError):
            bl.simulate(**wrong)  # type: ignore[arg-type]
