"""Public objects can be pickled, copied, compared and shown."""

from __future__ import annotations

import copy
import dataclasses
import pickle
import tempfile
from pathlib import Path

import cloudpickle
import pytest
from conftest import TIMES_S

import bouncelab as bl


def study() -> bl.Study:
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(2):
            sound = bl.synthesize(bounces=8, restitution=0.8, seed=seed)
            sound.save(Path(folder) / f"{seed}.wav")
        return bl.session(folder, ball="table-tennis-40", draws=100)


def everything() -> dict[str, object]:
    """An object of every public class."""
    recording = bl.analyze_times(TIMES_S, draws=200, reach=[(2, 0.2)], compare_balls=True)
    sound = bl.synthesize(bounces=5, restitution=0.8)
    drop = recording.drops[0]
    posterior = drop.posterior
    band = bl.analyze(sound.samples, sound.sample_rate_hz, draws=None).strongest_band
    exceptions = [getattr(bl, name)("what was wrong") for name in bl.__all__ if name.endswith("Error")]
    objects = [
        *exceptions, bl.air(), bl.presets()[0], bl.restitution_laws()[0], recording, recording.source,
        recording.settings, recording.settings.ball, recording.settings.air, recording.settings.gravity, recording.drops,
        recording.impacts, recording.impacts.columns[0], drop, drop.draws, drop.balls[0],
        drop.figure("height"), drop.log_linear_fit, drop.per_impact, posterior, posterior.restitution,
        posterior.drag_coefficient_prior, posterior.impacts[0], posterior.models[0], posterior.budget,
        posterior.budget.restitution[0], posterior.predictions[0], posterior.prior_contraction[0],
        bl.LogLikelihood(TIMES_S, 1e-4, ball="tennis"), posterior.correlations, posterior.sampling, posterior.band[0], posterior.priors[0], band, sound,
        sound.simulation, bl.rules()[0],
        bl.verdict([sound.samples], "ittf-ball", sample_rate_hz=44_100, draws=100), study(),
    ]  # fmt: skip
    assert drop.per_impact is not None
    objects.append(drop.per_impact.impacts[0])
    detector = bl.Detector(sound.sample_rate_hz, draws=None)
    detector.push(sound.samples[: len(sound.samples) // 2])
    objects.append(detector)
    return {type(it).__name__: it for it in objects}


OBJECTS = everything()
#: Kinds of arguments, which have no objects of their own, a warning, and a tuple of arrays.
WITHOUT = {"BouncelabWarning", "Gradient", "Options", "PhysicsOptions", "Progress", "ProgressBar", "SimulationOptions"}


def test_every_public_class_is_among_them() -> None:
    classes = {name for name in bl.__all__ if isinstance(getattr(bl, name), type)}
    assert classes - WITHOUT == OBJECTS.keys()


@pytest.mark.parametrize("name", OBJECTS)
def test_a_copy_is_equal(name: str) -> None:
    it = OBJECTS[name]
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        assert pickle.loads(pickle.dumps(it, protocol)) == it
    assert pickle.loads(cloudpickle.dumps(it)) == it
    assert copy.copy(it) == it and copy.deepcopy(it) == it
    assert it != "something else"
    assert type(it).__name__ in repr(it)


def test_a_pickle_keeps_every_digit() -> None:
    recording = bl.analyze_times(TIMES_S, draws=300, ball="tennis", exclude_s=[0.8877])
    again = pickle.loads(pickle.dumps(recording))
    assert again.to_dict() == recording.to_dict()
    assert again.drops[0].draws == recording.drops[0].draws
    assert again.drops[0].figure("posterior").svg() == recording.drops[0].figure("posterior").svg()


def test_a_pickle_infers_nothing_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its core, which would infer, is asked for nothing that a person reads first."""
    recording = bl.analyze_times(TIMES_S, draws=300, ball="tennis")
    again = pickle.loads(pickle.dumps(recording))
    monkeypatch.setattr(again, "_core", None)
    drop, other = recording.drops[0], again.drops[0]
    assert again == recording and repr(again) == repr(recording) and again._repr_html_() == recording._repr_html_()
    assert other.draws == drop.draws and other.posterior == drop.posterior and repr(other) == repr(drop)
    assert other.impacts == drop.impacts and again.flights == recording.flights
    assert pickle.loads(pickle.dumps(other.draws)) == drop.draws


def test_a_recording_of_sound_keeps_its_waveform(sound: bl.Sound) -> None:
    recording = bl.analyze(sound.samples, sound.sample_rate_hz, draws=None)
    again = pickle.loads(pickle.dumps(recording))
    assert again == recording
    assert again.figure("waveform").svg() == recording.figure("waveform").svg()


def test_other_words_in_any_case_mean_the_same_ball() -> None:
    by_name = bl.analyze_times(TIMES_S, ball="table-tennis-40", draws=200).drops[0]
    for words in ("ping pong", "Tischtennis", "TENIS DE MESA"):
        assert bl.analyze_times(TIMES_S, ball=words, draws=200).drops[0] == by_name


@pytest.mark.parametrize("ball", bl.presets(), ids=lambda ball: ball.name)
def test_a_preset_means_the_same_as_its_name(ball: bl.Ball) -> None:
    """What nobody measured stays as uncertain as the preset says, its contact time above all."""
    by_name, by_object = (bl.analyze_times(TIMES_S, ball=it, draws=200).drops[0] for it in (ball.name, ball))
    assert by_object.posterior == by_name.posterior
    heavier = bl.analyze_times(TIMES_S, ball=dataclasses.replace(ball, mass_kg=1.01 * ball.mass_kg), draws=200)
    weighed = bl.analyze_times(TIMES_S, ball=ball.name, mass_kg=1.01 * ball.mass_kg, draws=200)
    assert heavier.drops[0].posterior == weighed.drops[0].posterior


def test_results_cannot_be_changed(times: bl.Recording) -> None:
    with pytest.raises(dataclasses.FrozenInstanceError):
        times.drops[0].restitution.value = 1.0  # type: ignore[misc]
    times.impacts["time_s"][0] = 1.0
    assert times.impacts["time_s"][0] == 0.0


def test_a_detector_of_another_version_is_refused(sound: bl.Sound) -> None:
    make, (_, *state) = bl.Detector(sound.sample_rate_hz).__reduce__()
    with pytest.raises(bl.InputError, match="same version"):
        make("0.0.0", *state)
