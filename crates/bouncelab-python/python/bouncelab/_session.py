"""Analysis of many recordings."""

from __future__ import annotations

import csv
import json
import os
import pickle
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, closing, contextmanager
from dataclasses import dataclass
from functools import cached_property
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias, Unpack

from bouncelab import _core
from bouncelab._analyze import Bars
from bouncelab._data import JSON
from bouncelab._errors import InputError
from bouncelab._isolated import Isolated
from bouncelab._report import Reported
from bouncelab._paths import local
from bouncelab._settings import (
    Options,
    count,
    flag,
    number,
    refuse_options_of_one_recording,
    settings_of,
    text,
    texts,
)
from bouncelab._table import Table

if TYPE_CHECKING:
    from bouncelab._analyze import Progress

#: Longest time for one recording, in seconds: that of the program.
LONGEST_S = 600.0

#: What was noted: a CSV file, notes by recording, or rows with a column ``recording``.
Notes: TypeAlias = "str | PathLike[str] | Mapping[str, Mapping[str, object]] | Iterable[Mapping[str, object]]"


@dataclass(frozen=True)
class Study(Reported):
    """Statistics of the drops of many recordings.

    It comes from :func:`bouncelab.session`.

    Attributes
    ----------
    drops, impacts : Table
        One row for each drop, and for each impact, with what was noted of its recording: the tables that the
        program ``bouncelab session`` writes.

    Examples
    --------
    >>> import bouncelab as bl
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     bl.synthesize(bounces=12, seed=1).save(f"{folder}/wood.wav")
    ...     study = bl.session(folder, ball="table-tennis-40", draws=None)
    >>> len(study.drops), study.no_study is None
    (1, False)
    """

    drops: Table
    impacts: Table

    @property
    def groups(self) -> list[JSON]:
        """The groups: levels, restitution, curve, scatter; empty if the drops are not compared."""
        study = self.to_dict()["study"]
        groups = study["groups"] if isinstance(study, dict) else []
        assert isinstance(groups, list)
        return groups

    @property
    def no_study(self) -> str | None:
        """Why the drops are not compared; ``None`` if they are."""
        reason = self.to_dict()["no_study"]
        return None if reason is None else str(reason)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Study)
            and self._documents == other._documents
            and self.drops == other.drops
            and self.impacts == other.impacts
        )

    def __repr__(self) -> str:
        return f"<bouncelab.Study: {len(self.drops)} drops in {len(self.groups)} groups>"

    def _repr_html_(self) -> str:
        """Return the groups as a figure, or else the drops as a table, for notebooks."""
        return self.figure("groups").svg() if "groups" in self.figures else self.drops._repr_html_()


def session(
    files: str | PathLike[str] | Iterable[str | PathLike[str]],
    notes: Notes | None = None,
    *,
    pattern: str | None = None,
    by: str | Iterable[str] | None = None,
    compare_at_m_s: float | None = None,
    wanted: float | None = None,
    exclude: str | Iterable[str] = (),
    allow_missing: bool = False,
    allow_implausible: bool = False,
    output: str | PathLike[str] | None = None,
    jobs: int | None = None,
    progress: Progress | None = None,
    **options: Unpack[Options],
) -> Study:
    """Analyse many recordings, and compare their drops.

    Parameters
    ----------
    files : path or iterable of paths
        Recordings, folders of recordings, or a ``session.toml``; patterns such as ``"class/*.wav"``; URLs that fsspec
        opens, which are copied to this machine until the session ends.
    notes : path, mapping or iterable of mappings, optional
        What was noted of each: a CSV file with a column ``recording``; notes by recording,
        ``{"1.wav": {"surface": "steel", "height": "30 cm"}}``; or rows, such as
        ``frame.to_dict("records")`` of pandas. Quantities are texts with their unit.
    pattern : str, optional
        What the names of the files say, as in ``"{ball}_{surface}_{height}_{}"``.
    by : str or iterable of str, optional
        What makes groups, nothing for a single one; ball, surface and what else was noted if left out.
    compare_at_m_s : float, optional
        Impact speed at which groups are compared; a round one that they have in common if left out.
    wanted : float, optional
        Half width of the 95 % interval that the restitution should have.
    exclude : str or iterable of str
        Recordings, or ``"recording#2"`` for a second drop, to leave out of the comparison.
    allow_missing, allow_implausible : bool
        Whether recordings may lack what others have; whether to believe what looks like a mistake of units.
    output : path, optional
        Folder in which to keep the results of single recordings, so that a session that was ended goes on
        where it was.
    jobs : int, optional
        Child processes, which end before this returns; as many as there are processors if left out. A recording
        that ends two of them, or takes longer than ten minutes, is said to fail, and the others go on.
    progress : optional
        As of :func:`analyze`.
    **options
        What holds for all recordings, as of :func:`analyze`; what was noted of one goes before.

    Returns
    -------
    Study

    Raises
    ------
    SessionError
        If there is no recording, a note makes no sense, or notes contradict each other.
    InputError, OutOfRangeError, UnknownNameError, PhysicsError
        If an argument makes no sense.

    Examples
    --------
    >>> import bouncelab as bl
    >>> import tempfile, pathlib
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     for number, restitution in enumerate([0.85, 0.86, 0.90, 0.91]):
    ...         sound = bl.synthesize(restitution=restitution, bounces=12, seed=number)
    ...         sound.save(pathlib.Path(folder) / f"{'wood' if number < 2 else 'steel'}_{number}.wav")
    ...     study = bl.session(folder, pattern="{surface}_{}", ball="table-tennis-40", draws=200)
    >>> study
    <bouncelab.Study: 4 drops in 2 groups>
    """
    refuse_options_of_one_recording(options)
    settings = settings_of(options)
    report = None if progress is None else Bars(progress)
    with ExitStack() as folders:
        csv_of_notes = folders.enter_context(_csv(notes))
        request = {
            "inputs": local("files", files, folders),
            "pattern": None if pattern is None else text("pattern", pattern),
            "notes": csv_of_notes,
            "output": None if output is None else text("output", fspath(output)),
            "by": None if by is None else texts("by", by),
            "compare_at_m_s": None if compare_at_m_s is None else number("compare_at_m_s", compare_at_m_s),
            "wanted": None if wanted is None else number("wanted", wanted),
            "exclude": texts("exclude", exclude),
            "allow_missing": flag("allow_missing", allow_missing),
            "allow_implausible": flag("allow_implausible", allow_implausible),
        }
        work = _Work(settings, json.dumps(request))
        several = os.cpu_count() or 1 if jobs is None else count("jobs", jobs)
        try:
            with ExitStack() as ends:
                analyses = pickle.dumps(work)
                alike = (Isolated(analyses, LONGEST_S) for _ in range(max(several, 1)))
                children = [ends.enter_context(closing(child)) for child in alike]
                analysed = _core.Session(work.settings, work.request, report, children)
        finally:
            if report is not None:
                report.close()
    drops, impacts = analysed.tables()
    reported = {language: analysed.reported(language) for language in _core.languages()}
    return Study(
        {language: document for language, (document, _, _) in reported.items()},
        {language: dict(charts) for language, (_, charts, _) in reported.items()},
        {language: page for language, (_, _, page) in reported.items()},
        Table(drops),
        Table(impacts),
    )


@dataclass
class _Work:
    """What a child process does: it finds the recordings, and analyses those that it is asked for."""

    settings: str
    request: str

    @cached_property
    def _known(self) -> _core.SessionWork:
        return _core.SessionWork(self.settings, self.request)

    def row(self, given: tuple[str, str]) -> bytes:
        return self._known.record(*given)


@contextmanager
def _csv(notes: Notes | None) -> Iterator[str | None]:
    """Give notes as the path of a CSV file."""
    if notes is None or isinstance(notes, str | PathLike):
        yield None if notes is None else text("notes", fspath(notes))
        return
    if isinstance(notes, Mapping):
        rows = [{"recording": name, **_row(of_it)} for name, of_it in notes.items()]
    elif isinstance(notes, Iterable):
        rows = [_row(row) for row in notes]
    else:
        raise InputError(f"notes must be a path, a mapping or rows, not {type(notes).__name__}")
    if not all("recording" in row for row in rows):
        raise InputError("each row of notes must have a field recording, the name of its recording")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "notes.csv"
        with path.open("w", newline="", encoding="utf-8") as file:
            fields = list(dict.fromkeys(field for row in rows for field in row))
            writer = csv.DictWriter(file, fields)
            writer.writeheader()
            writer.writerows(rows)
        yield str(path)


def _row(row: object) -> dict[str, object]:
    if not isinstance(row, Mapping):
        raise InputError(f"the notes of a recording must be a mapping, not {type(row).__name__}")
    return dict(row)
