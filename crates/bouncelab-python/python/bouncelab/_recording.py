"""Results of an analysis."""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterator
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any, Literal, overload

from bouncelab import _core
from bouncelab._arviz import inference_data
from bouncelab._data import (
    BallComparison,
    JSON,
    Diagnostic,
    Estimate,
    LogLinearFit,
    PerImpact,
    Posterior,
    SettingsUsed,
    Source,
    StrongestBand,
    read,
)
from bouncelab._errors import BouncelabError, BouncelabWarning
from bouncelab._figure import Figure, figure
from bouncelab._report import Documented, written
from bouncelab._settings import flag, text
from bouncelab._table import Table

if TYPE_CHECKING:
    import numpy as np
    from arviz import InferenceData
    from numpy.typing import NDArray


class Recording(Documented):
    """The analysis of a recording, or of a list of impact times.

    It comes from :func:`bouncelab.analyze`, :func:`bouncelab.analyze_times` and
    :meth:`bouncelab.Detector.finish`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> recording = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500)
    >>> len(recording.drops), len(recording.impacts), len(recording.flights)
    (1, 6, 5)
    """

    def __init__(self, core: _core.Recording, answers: dict[tuple[object, ...], Any] | None = None) -> None:
        self._core = core
        self._answers = {} if answers is None else answers

    def _ask(self, question: str, *about: object) -> Any:
        """Return what a method of the core gives; a pickle has it too, so that nothing is inferred again."""
        key = (question, *about)
        if key not in self._answers:
            self._answers[key] = getattr(self._core, question)(*about)
        return self._answers[key]

    def _why_no_posterior(self, drop: int) -> tuple[str, str] | None:
        """Return code and reason of a drop that has no posterior."""
        key = ("why", drop)
        if key not in self._answers:
            try:
                self._core.require_posterior(drop)
                self._answers[key] = None
            except BouncelabError as reason:
                self._answers[key] = (reason.code or "", str(reason))
        why: tuple[str, str] | None = self._answers[key]
        return why

    @cached_property
    def _document(self) -> dict[str, JSON]:
        document: dict[str, JSON] = json.loads(self._ask("document", "en"))
        return document

    @property
    def name(self) -> str:
        """The file, or what the recording is called."""
        return str(self._document["recording"])

    @property
    def source(self) -> Source:
        """Where the impact times come from."""
        return read(Source, self._document["source"])

    @property
    def settings(self) -> SettingsUsed:
        """What was known or assumed."""
        return read(SettingsUsed, self._document["settings"])

    @property
    def strongest_band(self) -> StrongestBand | None:
        """The band in which the impacts stand out most; ``None`` without a drop."""
        band = self._document["strongest_band"]
        return None if band is None else read(StrongestBand, band)

    @cached_property
    def drops(self) -> Drops:
        """The drops, in order of time."""
        return Drops(self)

    @cached_property
    def impacts(self) -> Table:
        """The impacts of all drops, one row for each."""
        return Table(self._ask("table", "impacts", None))

    @cached_property
    def flights(self) -> Table:
        """The flights of all drops, one row for each."""
        return Table(self._ask("table", "flights", None))

    @property
    def no_drop(self) -> Diagnostic | None:
        """Why there is no drop; ``None`` if there is one."""
        reason = self._document["no_drop"]
        return None if reason is None else read(Diagnostic, reason)

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Warnings and remarks on the recording as a whole."""
        return _diagnostics(self._document)

    @property
    def figures(self) -> tuple[str, ...]:
        """Names of the figures of the recording as a whole; those of a drop are ``drop.figures``."""
        return tuple(self._core.figure_names())

    def figure(self, name: str, language: str = "en") -> Figure:
        """Return a figure of the recording as a whole.

        Parameters
        ----------
        name : str
            One of :attr:`figures`.
        language : str
            One of :func:`bouncelab.languages`.

        Returns
        -------
        Figure

        Raises
        ------
        UnknownNameError
            If there is no such figure or language.
        """
        return figure(self, name, language)

    def _chart(self, name: str, language: str) -> _core.Chart:
        return self._core.figure(name, language)

    def _inputs(self) -> list[str]:
        return [self.name]

    def report(
        self,
        form: Literal["html", "markdown"] = "html",
        language: str = "en",
        *,
        details: bool = False,
    ) -> str:
        """Return a report to read and keep: one page of HTML, or Markdown without its figures.

        Parameters
        ----------
        form : {"html", "markdown"}
        language : str
            One of :func:`bouncelab.languages`.
        details : bool
            Unfold the details of the HTML (every table and figure, the formulas), so that it prints them too.
            Markdown does not fold them.

        Returns
        -------
        str

        Raises
        ------
        InputError
            If there is no such form.
        UnknownNameError
            If there is no such language.
        """
        return written(self._core.page(text("language", language), flag("details", details)), form)

    def _document_in(self, language: str) -> str:
        return self._core.document(language)

    def __reduce__(self) -> tuple[type[Recording], tuple[_core.Recording, dict[tuple[object, ...], Any]]]:
        for name in ("drops", "impacts", "flights"):
            self._ask("table", name, None)
        self._ask("summary", "en", None)
        for drop in self.drops:
            drop._keep()
        return (Recording, (self._core, self._answers))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Recording) and self._document == other._document

    def __repr__(self) -> str:
        parts = [_counted(len(self.drops), "drop"), *_doubts(self)]
        return f"<bouncelab.Recording {self.name!r}: {', '.join(parts)}>"

    def _repr_html_(self) -> str:
        """Return a short answer as HTML, for notebooks."""
        return _html(self._ask("summary", "en", None), self._warnings())

    def _warnings(self) -> list[str]:
        """Return the first sentence of each kind of doubt."""
        found = [(it.code, it.message()) for it in self.diagnostics if it.severity == "warning"]
        for drop in self.drops:
            found += drop._doubts()
        first = dict(reversed(found))
        for assumed in self.settings.assumptions:
            if assumed.code == "assumed-ball":
                first[assumed.code] = f"nobody stated the ball. {assumed.message()} State it by ball=."
        return list(reversed(first.values()))

    def _warn(self) -> Recording:
        """Say through the module ``warnings`` what to read with care, at the line that called the package."""
        for words in self._warnings():
            warnings.warn(f"{self.name}: {words}", BouncelabWarning, stacklevel=3)
        return self


class Drop:
    """The analysis of one drop.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0]
    >>> drop.restitution == drop.posterior.restitution
    True
    >>> drop.figures[:3]
    ('restitution', 'flight-times', 'height')
    """

    def __init__(self, recording: Recording, place: int) -> None:
        self._recording = recording
        self._place = place

    @property
    def _document(self) -> dict[str, JSON]:
        drops = self._recording._document["drops"]
        assert isinstance(drops, list)
        drop = drops[self._place]
        assert isinstance(drop, dict)
        return drop

    @property
    def probability(self) -> float:
        """Probability that it is a drop; 1 for a list of times."""
        return read(float, self._document["probability"])

    @property
    def impacts(self) -> Table:
        """The impacts, one row for each."""
        return self._table("impacts")

    @property
    def flights(self) -> Table:
        """The flights between successive impacts, one row for each."""
        return self._table("flights")

    def _table(self, name: str) -> Table:
        return Table(self._recording._ask("table", name, self._place))

    @property
    def log_linear_fit(self) -> LogLinearFit:
        """The log-linear fit: the line through the logarithms of the flight times, as if there were no air.

        Raises
        ------
        PhysicsError
            If there are too few flights.
        """
        if self._document["log_linear_fit"] is None:
            self._recording._core.require_fit(self._place)
        return read(LogLinearFit, self._document["log_linear_fit"])

    @property
    def per_impact(self) -> PerImpact | None:
        """The restitution of single impacts, corrected for drag; ``None`` if no flight can be modelled."""
        found = self._document["per_impact"]
        return None if found is None else read(PerImpact, found)

    @property
    def restitution_covariance(self) -> tuple[tuple[int, ...], NDArray[np.float64]]:
        """Numbers of the impacts of :attr:`per_impact`, and the covariance of their restitutions by the errors of the times.

        Impacts whose numbers differ by one or two share times. It is not a number where the error of a time is unknown.

        Raises
        ------
        PhysicsError
            If no flight can be modelled.
        """
        import numpy as np

        numbers, covariance = self._recording._core.restitution_covariance(self._place)
        return tuple(numbers), np.frombuffer(covariance).reshape(len(numbers), len(numbers))

    @cached_property
    def posterior(self) -> Posterior:
        """The posterior of restitution, drop height, drag and the rest.

        Raises
        ------
        InferenceError
            If nothing can be inferred, or ``draws=None`` left the inference out.
        """
        if not self.has_posterior:
            self._recording._core.require_posterior(self._place)
        return read(Posterior, self._document["posterior"])

    @property
    def has_posterior(self) -> bool:
        """Whether there is a posterior."""
        return self._document["posterior"] is not None

    @property
    def balls(self) -> tuple[BallComparison, ...]:
        """What the times indicate of each preset ball, the best first; empty without ``compare_balls=True``."""
        return read(tuple[BallComparison, ...], self._document["balls"])

    @property
    def restitution(self) -> Estimate:
        """Restitution by the inference, at the speed of the first impact detected (``posterior.at_speed_m_s``)."""
        return self.posterior.restitution

    @property
    def drop_height_m(self) -> Estimate:
        """Height of the fall by the inference, in m."""
        return self.posterior.drop_height_m

    @property
    def drag_coefficient(self) -> Estimate | None:
        """Drag coefficient at the fastest impact by the inference; ``None`` in vacuum."""
        return self.posterior.drag_coefficient

    @property
    def draws(self) -> Draws:
        """Draws of the posterior."""
        return Draws(self)

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Warnings and remarks on the drop."""
        return _diagnostics(self._document)

    @property
    def figures(self) -> tuple[str, ...]:
        """Names of its figures."""
        return tuple(self._recording._core.figure_names(self._place))

    def figure(self, name: str, language: str = "en") -> Figure:
        """Return a figure.

        Parameters
        ----------
        name : str
            One of ``figures``.
        language : str
            One of :func:`bouncelab.languages`.

        Returns
        -------
        Figure
            In a notebook it shows itself.

        Raises
        ------
        UnknownNameError
            If there is no such figure or language.
        """
        return figure(self, name, language)

    def _chart(self, name: str, language: str) -> _core.Chart:
        return self._recording._core.figure(name, language, self._place)

    def _inputs(self) -> list[str]:
        return self._recording._inputs()

    def to_dict(self) -> dict[str, JSON]:
        """Return the drop as in the document of the recording.

        Returns
        -------
        dict
            As JSON has it: lists, numbers, texts and ``None``.
        """
        return self._document

    def __reduce__(self) -> tuple[type[Drop], tuple[Recording, int]]:
        return (Drop, (self._recording, self._place))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Drop) and self._document == other._document

    def __repr__(self) -> str:
        answer = self._recording._ask("in_one_line", self._place, "en")
        parts = [_counted(len(self.impacts), "impact"), answer, *_doubts(self)]
        return f"<bouncelab.Drop: {', '.join(filter(None, parts))}>"

    def _repr_html_(self) -> str:
        """Return a short answer as HTML, for notebooks."""
        return _html(self._recording._ask("summary", "en", self._place), self._warnings())

    def _doubts(self) -> list[tuple[str, str]]:
        """Return code and sentence of what to read with care, why there is no posterior among them."""
        found = [(it.code, it.message()) for it in self.diagnostics if it.severity == "warning"]
        why = self._recording._why_no_posterior(self._place)
        return found if why is None or why[0] == "inference-off" else [*found, why]

    def _warnings(self) -> list[str]:
        return [words for _, words in self._doubts()]

    def _keep(self) -> None:
        """Ask what a pickle keeps."""
        ask = self._recording._ask
        for name in ("impacts", "flights"):
            ask("table", name, self._place)
        ask("summary", "en", self._place)
        ask("in_one_line", self._place, "en")
        self._recording._why_no_posterior(self._place)
        if self.has_posterior:
            ask("draws", self._place)


class Drops(Table):
    """The drops of a recording: a sequence of :class:`Drop`, and a table with a row for each.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drops = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops
    >>> bool(drops[0].restitution.value == drops["restitution"][0])
    True
    """

    __slots__ = ("_recording",)

    def __init__(self, recording: Recording) -> None:
        Table.__init__(self, recording._ask("table", "drops", None))
        self._recording = recording

    @overload
    def __getitem__(self, index: int) -> Drop: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Drop, ...]: ...
    @overload
    def __getitem__(self, index: str) -> NDArray[np.generic]: ...
    def __getitem__(self, index: int | slice | str) -> Drop | tuple[Drop, ...] | NDArray[np.generic]:
        """Return a drop by its place, several by a slice, or a column by its name."""
        if isinstance(index, str):
            return Table.__getitem__(self, index)
        places = range(len(self))[index]
        if isinstance(places, int):
            return Drop(self._recording, places)
        return tuple(Drop(self._recording, place) for place in places)

    def __iter__(self) -> Iterator[Drop]:  # type: ignore[override]
        return (Drop(self._recording, place) for place in range(len(self)))

    def __eq__(self, other: object) -> bool:
        # Whatever their recordings are called.
        return isinstance(other, Drops) and list(self) == list(other)

    def __reduce__(self) -> tuple[type[Drops], tuple[Recording]]:  # type: ignore[override]
        return (Drops, (self._recording,))

    def __repr__(self) -> str:
        return f"<bouncelab.Drops: {_counted(len(self), 'drop')}>"


class Draws(Table):
    """Equally likely values of the answers together: NumPy arrays by name, and a table.

    Examples
    --------
    >>> import bouncelab as bl
    >>> draws = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].draws
    >>> draws.keys()
    ('restitution', 'drop_height_m', 'drag_coefficient')
    >>> draws["restitution"].shape == (len(draws),)
    True
    """

    __slots__ = ("_drop",)

    def __init__(self, drop: Drop) -> None:
        Table.__init__(self, drop._recording._ask("draws", drop._place))
        self._drop = drop

    def to_arviz(self) -> InferenceData:
        """Return all that is known of the posterior for ArviZ, which must be installed.

        Returns
        -------
        arviz.InferenceData
            One chain of independent draws. ``posterior`` has every unknown: the answers, as here; the restitution law and its
            slope at five speeds (``restitution_curve``, ``restitution_slope``), which determine the smooth law; the scatter,
            gravity, the contact time, and factors on the drag and on the errors of the times; speed and restitution of each
            impact. ``prior`` has what has a proper prior; the drop height has one only if it was measured.
            ``observed_data`` and ``posterior_predictive`` are the times between impacts, ``log_likelihood`` the logarithm of
            the density of each given those before it. ``sample_stats`` has the ball, the number of impacts missed before
            the first, and whether that is left out as another sound. Attributes state units, settings and version.
        """
        drop, recording = self._drop, self._drop._recording
        document, sampling = recording._document, drop.posterior.sampling
        about: dict[str, object] = {
            "recording": recording.name,
            "bouncelab": str(document["bouncelab"]),
            "settings": json.dumps(document["settings"]),
            "restitution_speed_m_s": drop.posterior.at_speed_m_s,
            "effective_draws": sampling.effective_draws,
            "pareto_shape": sampling.pareto_shape,
        }
        answers = {column.name: (column.unit, self[column.name]) for column in self.columns}
        return inference_data(recording._ask("drawn_unknowns", drop._place), answers, about)

    def __reduce__(self) -> tuple[type[Draws], tuple[Drop]]:  # type: ignore[override]
        return (Draws, (self._drop,))

    def __repr__(self) -> str:
        return f"<bouncelab.Draws: {len(self)} of {', '.join(self)}>"


def _diagnostics(document: dict[str, JSON]) -> tuple[Diagnostic, ...]:
    known = document["diagnostics"]
    assert isinstance(known, list)
    return tuple(read(Diagnostic, each) for each in known)


def _doubts(found: Recording | Drop) -> list[str]:
    count = len(found._warnings())
    return [_counted(count, "warning")] if count else []


def _html(sentences: list[str], doubts: list[str]) -> str:
    """Return sentences, and what to read with care, as paragraphs."""
    words = [escape(sentence) for sentence in sentences]
    words += [f"<strong>Warning:</strong> {escape(doubt)}" for doubt in doubts]
    return "".join(f"<p>{each}</p>" for each in words)


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
