"""What comes out."""

from __future__ import annotations

import dataclasses
import json
import math
import subprocess
import warnings
from pathlib import Path

import numpy as np
import pytest
from conftest import PROGRAM, TIMES_S

import bouncelab as bl


def test_a_posterior_has_the_numbers_of_the_document(times: bl.Recording) -> None:
    drop = times.drops[0]
    document = times.to_dict()
    assert document["schema"] == "bouncelab.analysis/3"
    posterior = document["drops"][0]["posterior"]  # type: ignore[index,call-overload]
    assert drop.posterior.restitution.value == posterior["restitution"]["value"]  # type: ignore[index,call-overload]
    assert drop.posterior.restitution.interval68 == tuple(posterior["restitution"]["interval68"])  # type: ignore[index,call-overload]
    assert len(drop.posterior.impacts) == len(TIMES_S)
    assert drop.posterior.models[0].probability >= drop.posterior.models[-1].probability
    assert drop.draws["restitution"].mean() == pytest.approx(drop.restitution.value, abs=3 * drop.restitution.sd)


def test_results_have_the_fields_of_the_document(recording: bl.Recording) -> None:
    listed = bl.analyze_times(TIMES_S, draws=500, compare_balls=True, reach=[(2, 0.2)])
    sources = recording.to_dict()["source"] | listed.to_dict()["source"]  # type: ignore[operator]
    assert set(sources) == {field.name for field in dataclasses.fields(bl.Source)}
    for found in (recording, listed):
        document, drop = found.to_dict(), found.drops[0]
        for name, value in document["source"].items():  # type: ignore[union-attr]
            assert getattr(found.source, name) == value
        for name in ("settings", "strongest_band"):
            assert_same_fields(getattr(found, name), document[name])
        for name in ("log_linear_fit", "per_impact", "posterior", "balls"):
            assert_same_fields(getattr(drop, name), drop.to_dict()[name])


def assert_same_fields(found: object, document: object) -> None:
    """Fail where a class lacks a field of its document, or has one that the document lacks."""
    if isinstance(document, dict):
        assert dataclasses.is_dataclass(found)
        names = {field.name for field in dataclasses.fields(found)}
        # The sentence of a diagnostic is made where it is asked for.
        assert names == set(document) - {"message"}, type(found)
        for name in names - {"arguments"}:
            assert_same_fields(getattr(found, name), document[name])
    elif isinstance(document, list) and isinstance(found, tuple):
        for each, of_it in zip(found, document, strict=True):
            assert_same_fields(each, of_it)


def test_the_document_is_that_of_the_program(sound: bl.Sound, tmp_path: Path) -> None:
    sound.save(tmp_path / "drop.wav")
    command = [*PROGRAM, "analyze", "drop.wav", "--ball", "tennis", "--draws", "500", "--format", "json"]
    shown = subprocess.run(command, cwd=tmp_path, capture_output=True, check=True)
    found = bl.analyze(tmp_path / "drop.wav", ball="tennis", draws=500, name="drop.wav")
    assert without_messages(found.to_dict()) == without_messages(json.loads(shown.stdout))


def without_messages(document: object) -> object:
    """Return a document without its sentences, to which the program adds its own options."""
    if isinstance(document, dict):
        return {name: without_messages(it) for name, it in document.items() if name != "message"}
    return [without_messages(it) for it in document] if isinstance(document, list) else document


def test_what_cannot_be_told_is_said() -> None:
    two = bl.analyze_times([0.0, 0.5], draws=200).drops[0]
    with pytest.raises(bl.PhysicsError, match="at least 3 impacts"):
        _ = two.log_linear_fit
    without = bl.analyze_times(TIMES_S, draws=None).drops[0]
    assert not without.has_posterior
    with pytest.raises(bl.InferenceError, match="inference") as raised:
        _ = without.restitution
    assert raised.value.code == "inference-off"
    assert bl.analyze_times([0.0], draws=None).no_drop is not None


def test_an_estimate_without_bounds_is_infinite() -> None:
    fit = bl.analyze_times([0.0, 0.5, 0.95], draws=None).drops[0].log_linear_fit
    assert math.isinf(fit.restitution.sd) and fit.restitution.interval95 == (-math.inf, math.inf)


def test_diagnostics_have_a_code_and_a_sentence_in_every_language(times: bl.Recording) -> None:
    for known in (*times.settings.assumptions, *times.drops[0].diagnostics):
        assert known.code in bl.diagnostic_codes()
        assert len({known.message(language) for language in bl.languages()}) == len(bl.languages())
        assert str(known) == known.message("en")


def test_every_figure_is_drawn_saved_and_given_as_data(recording: bl.Recording, tmp_path: Path) -> None:
    drop = recording.drops[0]
    figures = [*map(recording.figure, recording.figures), *map(drop.figure, drop.figures)]
    assert {"waveform", "posterior", "restitution"} <= {figure.name for figure in figures}
    for figure in figures:
        assert figure._repr_svg_() == figure.svg()
        assert figure.caption and figure.title
        assert len(figure.data) > 0
        assert figure.save(tmp_path / f"{figure.name}.svg").read_text().startswith("<svg")
    assert drop.figure("height").save(tmp_path / "height.png").read_bytes()[1:4] == b"PNG"
    assert drop.figure("height").save(tmp_path / "height.pdf").read_bytes()[1:4] == b"PDF"
    assert drop.figure("height", "de").title != drop.figure("height").title
    with pytest.raises(bl.UnknownNameError, match="posterior"):
        drop.figure("posteriors")


def test_matplotlib_draws_every_panel_of_every_figure(recording: bl.Recording) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    from matplotlib import pyplot

    drop = recording.drops[0]
    for figure in [*map(recording.figure, recording.figures), *map(drop.figure, drop.figures)]:
        for panel in range(len(figure.to_dict()["panels"])):  # type: ignore[arg-type]
            axes = figure.to_matplotlib(panel=panel)
            assert axes.has_data()
            pyplot.close(axes.figure)


@pytest.mark.filterwarnings("ignore")
def test_arviz_takes_the_draws(times: bl.Recording) -> None:
    pytest.importorskip("arviz")
    drop = times.drops[0]
    posterior = drop.draws.to_arviz().posterior
    assert set(drop.draws) < set(posterior.data_vars)
    assert dict(posterior.sizes) == {
        "chain": 1, "draw": len(drop.draws), "impact": len(TIMES_S), "interval": len(TIMES_S) - 1, "speed_m_s": 5
    }  # fmt: skip
    for name in drop.draws:
        assert (posterior[name].values[0] == drop.draws[name]).all()


@pytest.mark.filterwarnings("ignore")
def test_arviz_has_the_whole_posterior() -> None:
    """Of simulated impacts, whose errors are known: each law is right or wrong by as much as it was made."""
    arviz, numpy = pytest.importorskip("arviz"), pytest.importorskip("numpy")
    import matplotlib

    matplotlib.use("agg")
    made = bl.simulate(restitution="linear:0.95,0.03", bounces=12, ball="table-tennis-40", scatter=0.001, seed=3)
    times_s = made.bounces["time_s"] + numpy.random.default_rng(1).normal(0.0, 2e-5, len(made.bounces))
    found = {}
    for law in ("constant", "smooth"):
        options: bl.Options = {"ball": "table-tennis-40", "height_m": 0.305, "draws": 800, "restitution_laws": [law]}
        drop = bl.analyze_times(times_s, **options).drops[0]
        found[law] = drop.draws.to_arviz()
    data = found["smooth"]
    assert {"posterior", "prior", "log_likelihood", "posterior_predictive", "observed_data", "sample_stats"} <= set(data.groups())
    # The law that was made, at the speeds at which it is stated; and the impacts, one by one.
    curve = data.posterior["restitution_curve"]
    truth = 0.95 - 0.03 * curve["speed_m_s"].values
    assert (abs(curve.mean(("chain", "draw")) - truth) < 4 * curve.std(("chain", "draw"))).all()
    speed = data.posterior["impact_speed_m_s"]
    off = abs(speed.mean(("chain", "draw")).values - made.bounces["impact_speed_m_s"])
    assert (off < 4 * speed.std(("chain", "draw")).values).all()
    # What is replicated scatters about what was observed, by as much as it differs.
    observed, replicated = data.observed_data["interval_s"], data.posterior_predictive["interval_s"]
    ranks = (replicated < observed).mean(("chain", "draw")).values
    assert 0.0 < ranks.min() and ranks.max() < 1.0 and 0.2 < ranks.mean() < 0.8
    # The priors, as they are documented.
    prior = data.prior
    assert float(prior["drop_height_m"].mean()) == pytest.approx(0.305, abs=3e-4)
    assert float(numpy.log(prior["contact_time_s"]).std()) == pytest.approx(0.5, abs=0.1)
    assert float(prior["restitution_curve"].sel(speed_m_s=curve["speed_m_s"][2]).mean()) == pytest.approx(0.5, abs=0.05)
    assert prior["restitution_curve"].std() > 5 * curve.std()
    # ArviZ compares the laws, and draws what is replicated.
    assert arviz.loo(data).elpd_loo > arviz.loo(found["constant"]).elpd_loo
    assert list(arviz.compare(found).index) == ["smooth", "constant"]
    assert arviz.plot_ppc(data, num_pp_samples=20) is not None
    assert data.posterior["impact_speed_m_s"].attrs["units"] == "m/s" and "smooth" not in data.posterior.attrs["balls"]
    assert '"ball"' in data.posterior.attrs["settings"]


def test_the_covariance_of_neighbours_is_that_of_repeated_noise() -> None:
    numpy = pytest.importorskip("numpy")
    sound = bl.synthesize(restitution=0.9, bounces=7, ball="table-tennis-40", seed=2)
    drop = bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-40", draws=None).drops[0]
    numbers, covariance = drop.restitution_covariance
    assert drop.per_impact is not None
    assert numbers == tuple(impact.number for impact in drop.per_impact.impacts)
    sds = numpy.array([impact.restitution.sd for impact in drop.per_impact.impacts])
    assert numpy.sqrt(numpy.diag(covariance)) == pytest.approx(sds)
    assert (covariance == covariance.T).all() and covariance[0, 3] == 0.0 and covariance[0, 1] < 0.0 < covariance[0, 2]
    # The same by noise that is drawn many times.
    noise, times_s = numpy.random.default_rng(1), numpy.asarray(drop.impacts["time_s"])
    sd_s = numpy.asarray(drop.impacts["time_sd_s"])
    rows = []
    for _ in range(1500):
        noisy = bl.analyze_times(times_s + sd_s * noise.standard_normal(len(sd_s)), ball="table-tennis-40", draws=None)
        per_impact = noisy.drops[0].per_impact
        assert per_impact is not None
        rows.append([impact.restitution.value for impact in per_impact.impacts])
    repeated = numpy.cov(numpy.array(rows).T)
    assert abs(repeated - covariance).max() < 0.12 * numpy.diag(covariance).max()


@pytest.mark.filterwarnings("ignore")
def test_the_draws_are_a_chain_of_independent_ones() -> None:
    """Several laws are among them: in the order of the laws they would look like a chain that does not mix."""
    arviz = pytest.importorskip("arviz")
    laws = [law.name for law in bl.restitution_laws()]
    draws = bl.analyze_times(TIMES_S, draws=1000, ball="table-tennis-40", restitution_laws=laws).drops[0].draws
    effective = arviz.summary(draws.to_arviz())["ess_bulk"]
    assert (effective.astype(float) > 0.8 * len(draws)).all()
    assert draws == bl.analyze_times(TIMES_S, draws=1000, ball="table-tennis-40", restitution_laws=laws).drops[0].draws


def test_estimates_and_posteriors_are_shown_in_short(times: bl.Recording) -> None:
    estimate = bl.Estimate(0.93184, 0.00069)
    assert f"{estimate:.3f}" == "0.932 ± 0.001" and str(estimate) == f"{estimate}" == "0.93184 ± 0.00069"
    assert str(bl.Estimate(1234.5, 321.0)) == "1234.5 ± 321" and str(bl.Estimate(0.5)) == "0.5 ± inf"
    drop = times.drops[0]
    for found in (drop.posterior, drop.log_linear_fit, drop.per_impact):
        assert found is not None
        assert len(repr(found)) < 1500
        assert found._repr_html_().startswith("<table>")
    assert str(drop.restitution) in repr(drop.posterior)


def test_what_to_read_with_care_is_a_warning(sound: bl.Sound) -> None:
    clipped = np.clip(30.0 * sound.samples, -1.0, 1.0)
    with pytest.warns(bl.BouncelabWarning, match="clipped") as caught:
        recording = bl.analyze(clipped, sound.sample_rate_hz, draws=None)
    assert any("ball=" in str(it.message) for it in caught)
    assert {it.filename for it in caught} == {__file__}
    assert f"{len(caught)} warnings" in repr(recording)
    assert recording._repr_html_().count("<strong>Warning:</strong>") == len(caught)
    with pytest.warns(bl.BouncelabWarning, match="did not converge"):
        unconverged = bl.analyze_times([0.0, 0.5, 0.9, 0.901, 1.2], draws=200)
    assert "warning" in repr(unconverged.drops[0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-38", draws=500)


def test_reports_and_answers_are_in_the_language_of_the_reader(times: bl.Recording) -> None:
    assert times.report().startswith("<!DOCTYPE html>")
    assert times.report("markdown", "de").startswith("# times")
    assert times.report(details=True) == times.report().replace("<details>", "<details open>")
    with pytest.raises(bl.InputError, match="'html' or 'markdown'"):
        times.report("pdf")  # type: ignore[arg-type]
    with pytest.raises(bl.UnknownNameError):
        times.report(language="xx")
    assert "keeps" in times._repr_html_() and "<p>" in times.drops[0]._repr_html_()


def test_the_air_slows_a_simulated_ball() -> None:
    drop = bl.simulate(height_m=1.0, restitution=0.8, bounces=4, ball="table-tennis-40")
    free = bl.simulate(height_m=1.0, restitution=0.8, bounces=4, drag="none")
    assert (drop.bounces["apex_m"] < free.bounces["apex_m"]).all()
    assert free.bounces["apex_m"] == pytest.approx([0.64, 0.4096, 0.262144, 0.16777216], rel=1e-4)
    kept = drop.initial_energy_j - drop.lost_to_surface_j - drop.lost_to_air_j
    assert 0 < kept < drop.initial_energy_j
    assert drop.height_m([[0.0, 0.1]]).shape == (1, 2)
    assert drop.height_m(0.0) == pytest.approx(1.0)


def test_one_number_and_several_are_taken() -> None:
    assert bl.flights(2.0)["apex_m"] == bl.flights([2.0])["apex_m"]
    assert bl.falls(0.3)["fall_time_s"] == bl.falls(np.array([0.3]))["fall_time_s"]
    for heights_m in ([0.2, 0.4], np.array([0.2, 0.4])):
        runs = bl.simulate(height_m=heights_m, bounces=2)
        assert runs == tuple(bl.simulate(height_m=height_m, bounces=2) for height_m in (0.2, 0.4))


def test_samples_are_an_ordinary_array() -> None:
    samples = bl.synthesize(bounces=3, snr_db=None).samples
    samples *= 0.5
    assert samples.flags.writeable and samples.flags.c_contiguous


def test_forward_functions_take_arrays_of_any_shape() -> None:
    temperatures_k = np.array([[283.15, 293.15], [303.15, 313.15]])
    densities = bl.air_density_kg_m3(temperatures_k, [[90_000.0], [101_325.0]], 0.5)
    assert densities.shape == (2, 2)
    assert densities[1, 1] == bl.air(313.15, 101_325.0, 0.5).density_kg_m3
    assert bl.air_viscosity_pa_s(293.15).shape == ()
    assert float(bl.air_viscosity_pa_s(293.15)) == bl.air(293.15).viscosity_pa_s
    assert bl.gravity_m_s2([0.0, 45.0], 100.0)[1] == bl.gravity_m_s2(45.0, 100.0)
    assert bl.drag_coefficient([[1e3], [1e4]]).shape == (2, 1)
    assert bl.drag_coefficient([]).shape == (0,)


def test_a_flight_is_the_same_by_each_of_its_quantities() -> None:
    known = bl.Options(ball="table-tennis-40", temperature_k=288.15)
    by_speed = bl.flights([0.5, 2.0], **known)
    for name in ("flight_time_s", "apex_m"):
        again = bl.flights(**{name: by_speed[name]}, **known)
        assert again["launch_speed_m_s"] == pytest.approx(by_speed["launch_speed_m_s"])
    assert (by_speed["impact_speed_m_s"] < by_speed["launch_speed_m_s"]).all()
    fall = bl.falls(by_speed["apex_m"], **known)
    assert fall["impact_speed_m_s"] == pytest.approx(by_speed["impact_speed_m_s"])
    assert fall["fall_time_s"] == pytest.approx(by_speed["fall_time_s"])
    fast = bl.falls([1000.0], **known)["impact_speed_m_s"][0]
    assert fast == pytest.approx(bl.terminal_speed_m_s(**known), rel=1e-3)
