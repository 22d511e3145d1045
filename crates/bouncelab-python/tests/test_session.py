"""Many recordings, and verdicts."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sysconfig
from pathlib import Path

import pytest

import bouncelab as bl
from bouncelab import _session
from conftest import PROGRAM
from faults import FaultyWork

PATTERN = "{surface}_{height}_{}"


@pytest.fixture(scope="module")
def laboratory(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("laboratory")
    for number in range(24):
        surface, restitution = [("wood", 0.85), ("steel", 0.90), ("glass", 0.92)][number % 3]
        sound = bl.synthesize(
            height_m=0.2 + 0.01 * (number % 10),
            restitution=restitution + 0.001 * (number % 7),
            bounces=10,
            seed=number,
            sample_rate_hz=22_050,
        )
        sound.save(folder / f"{surface}_{20 + number % 10}cm_{number}.wav")
    (folder / "wood_20cm_silent.wav").write_bytes((folder / f"wood_20cm_0.wav").read_bytes()[:44])
    return folder


@pytest.fixture(scope="module")
def study(laboratory: Path) -> bl.Study:
    return bl.session(laboratory, pattern=PATTERN, ball="table-tennis-40", draws=100, jobs=2)


def test_the_tables_are_those_of_the_program(laboratory: Path, study: bl.Study, tmp_path: Path) -> None:
    assert_equal_tables(laboratory, PATTERN, study, tmp_path)


@pytest.mark.skipif("BOUNCELAB_LABORATORY" not in os.environ, reason="it is for recordings of the laboratory")
def test_the_tables_of_the_laboratory_are_those_of_the_program(tmp_path: Path) -> None:
    """Of the folder that `cargo xtask laboratory FOLDER 240` makes."""
    folder, pattern = Path(os.environ["BOUNCELAB_LABORATORY"]), "{ball}_" + PATTERN
    study = bl.session(folder, pattern=pattern, ball="table-tennis-40", draws=100)
    assert_equal_tables(folder, pattern, study, tmp_path)


def assert_equal_tables(folder: Path, pattern: str, study: bl.Study, tmp_path: Path) -> None:
    """Compare all cells of the tables of Python and of the program."""
    pyarrow_parquet = pytest.importorskip("pyarrow.parquet")
    command = [*PROGRAM, "session", folder, "--output", tmp_path, "--pattern", pattern]
    command += ["--ball", "table-tennis-40", "--draws", "100", "--tables", "parquet"]
    subprocess.run(command, check=True, capture_output=True)
    cells = 0
    for name in ("drops", "impacts"):
        expected = pyarrow_parquet.read_table(tmp_path / f"{name}.parquet").to_pydict()
        found = getattr(study, name).to_dict()
        assert list(found) == list(expected)
        differ = [column for column in expected if found[column] != expected[column]]
        assert differ == []
        cells += sum(len(column) for column in expected.values())
    print(f"{len(list(folder.iterdir()))} recordings, {cells} cells, 0 differ")


def test_a_study_compares_the_groups(study: bl.Study) -> None:
    assert study.no_study is None
    means = {group["levels"]["surface"]: group["restitution"]["value"] for group in study.groups}  # type: ignore[index,call-overload]
    assert means["wood"] < means["steel"] < means["glass"]
    assert study.figures == ("groups", "intervals", "run")
    assert study._repr_html_() == study.figure("groups").svg()
    assert study._repr_html_().startswith("<svg")
    assert study.to_dict("de")["schema"] == "bouncelab.session/3"
    with pytest.raises(bl.UnknownNameError, match="groups"):
        study.figure("group")
    with pytest.raises(bl.UnknownNameError):
        study.to_dict("xx")


def test_a_study_and_a_verdict_have_reports(study: bl.Study) -> None:
    drop = bl.synthesize(height_m=0.305, restitution=0.93, bounces=15, seed=1)
    judged = bl.verdict([drop.samples], "ittf-ball", sample_rate_hz=drop.sample_rate_hz, draws=100)
    for reported, english, german in [(study, "Groups", "Gruppen"), (judged, "The rule", "Die Regel")]:
        page, seite = reported.report(), reported.report("markdown", "de")
        assert page.startswith("<!DOCTYPE html>") and page.count("<svg") == len(reported.figures)
        assert f">{english}</h2>" in page and f"## {german}" in seite
        again = pickle.loads(pickle.dumps(reported))
        assert again.report() == page and again.report("markdown", "de") == seite


def test_notes_come_as_rows_and_mappings(laboratory: Path) -> None:
    files = sorted(laboratory.glob("*_2?cm_?.wav"))[:4]
    notes = {str(file): {"surface": file.name.split("_")[0], "operator": "Ada, B."} for file in files}
    rows = [{"recording": name, **noted} for name, noted in notes.items()]
    by_file = bl.session(files, notes, ball="table-tennis-40", draws=None)
    assert by_file.drops.to_dict()["operator"] == ["Ada, B."] * 4
    assert bl.session(files, rows, ball="table-tennis-40", draws=None) == by_file
    assert by_file.no_study is not None
    assert by_file._repr_html_().startswith("<table>")


def test_kept_results_are_taken_up(laboratory: Path, tmp_path: Path) -> None:
    files = sorted(laboratory.glob("wood_2?cm_?.wav"))[:2]
    known = dict(ball="table-tennis-40", draws=100, output=tmp_path)
    first = bl.session(files, **known)  # type: ignore[arg-type]
    assert bl.session(files, **known) == first  # type: ignore[arg-type]
    assert any(tmp_path.iterdir())


def test_a_recording_that_ends_its_process_fails_alone(
    laboratory: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = ("a.wav", "abort.wav", "endless.wav", "z.wav")
    for name, recording in zip(names, sorted(laboratory.glob("*.wav")), strict=False):
        (tmp_path / name).write_bytes(recording.read_bytes())
    monkeypatch.setattr(_session, "_Work", FaultyWork)
    monkeypatch.setattr(_session, "LONGEST_S", 5.0)
    study = bl.session(tmp_path, ball="table-tennis-40", draws=None, jobs=2)
    assert study.drops.to_dict()["recording"] == ["a.wav", "z.wav"]
    said = str(study.to_dict())
    assert "SIGABRT" in said and "longer than 5 s" in said


@pytest.mark.parametrize(
    "wrong",
    [
        lambda folder: bl.session([]),
        lambda folder: bl.session(3),
        lambda folder: bl.session(b"x"),
        lambda folder: bl.session(folder / "nowhere"),
        lambda folder: bl.session(folder, pattern="{"),
        lambda folder: bl.session(folder, [{"surface": "wood"}]),
        lambda folder: bl.session(folder, [3]),
        lambda folder: bl.session(folder, notes=3),
        lambda folder: bl.session(folder, ball="table-tennis-40", draws=None, by=["colour"]),
        lambda folder: bl.session(folder, ball="table-tennis-40", draws=None, exclude=["nothing.wav"]),
        lambda folder: bl.session(folder, channel=1),
        lambda folder: bl.session(folder, jobs=-1),
        lambda folder: bl.session(folder, height_m="high"),
        lambda folder: bl.verdict([], "ittf-ball"),
        lambda folder: bl.verdict([folder], "ittf-bal"),
        lambda folder: bl.verdict([folder / "nowhere.wav"], "ittf-ball"),
        lambda folder: bl.verdict([folder / "wood_20cm_silent.wav"], "ittf-ball"),
        lambda folder: bl.verdict([folder / "wood_20cm_0.wav"] * 2, "ittf-ball", draws=100),
        lambda folder: bl.verdict([folder / "wood_20cm_0.wav"], "ittf-ball", kept=["weather"]),
        lambda folder: bl.verdict([folder / "wood_20cm_0.wav"], "ittf-ball", draws=100, risk=2.0),
        lambda folder: bl.verdict([], "ittf-ball", rule_files=["nowhere.toml"]),
    ],
)
def test_only_exceptions_of_the_package_come_out(wrong, laboratory: Path) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(bl.BouncelabError) as raised:
        wrong(laboratory)
    assert len(str(raised.value)) > 15


def test_a_verdict_says_how_certain_it_is() -> None:
    sounds = [bl.synthesize(height_m=0.305, restitution=0.93, bounces=12, seed=seed) for seed in range(3)]
    lively = bl.verdict([sound.samples for sound in sounds], "ittf-ball", sample_rate_hz=44_100, draws=200)
    assert lively.rebound_m is not None and lively.probability_within is not None
    assert 0.24 < lively.rebound_m.value < 0.27
    assert lively.outcome != "conforms"  # nothing shows the surface
    dull = bl.synthesize(height_m=0.305, restitution=0.6, bounces=8).samples
    assert bl.verdict([dull], "ittf-ball", sample_rate_hz=44_100, draws=200).outcome == "does-not-conform"
    assert lively._repr_html_().startswith("<svg")
    again = pickle.loads(pickle.dumps(lively))
    assert again == lively and again.figure().svg() == lively.figure().svg()


def test_a_study_is_pickled_whole(study: bl.Study) -> None:
    again = pickle.loads(pickle.dumps(study))
    assert again == study
    assert again.figure("groups", "de").svg() == study.figure("groups", "de").svg()


def test_the_program_comes_along() -> None:
    installed = Path(sysconfig.get_path("scripts")) / "bouncelab"
    for command in (PROGRAM, [installed]):
        shown = subprocess.run([*command, "--version"], capture_output=True, text=True, check=True)
        assert shown.stdout.strip() == f"bouncelab {bl.__version__}"


def test_the_program_has_its_exit_status_and_takes_over_interruptions(tmp_path: Path) -> None:
    assert subprocess.run([*PROGRAM, "analyze", "missing.wav"], capture_output=True, check=False).returncode == 1
    assert subprocess.run([*PROGRAM, "analyse"], capture_output=True, check=False).returncode == 2
    # Ten minutes in real time, which the program ends with a summary at the first Ctrl-C; Python would end with a traceback.
    bl.synthesize(bounces=5, tail_s=600.0, sample_rate_hz=8000).save(tmp_path / "drop.wav")
    command = [*PROGRAM, "listen", "--from", tmp_path / "drop.wav"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as listening:
        assert listening.stdout is not None and "drop 1" in listening.stdout.readline()
        listening.send_signal(signal.SIGINT)
        _, messages = listening.communicate()
    assert listening.returncode == 0 and "Traceback" not in messages
