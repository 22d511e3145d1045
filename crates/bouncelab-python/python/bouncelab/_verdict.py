"""Whether a ball or a floor obeys a rule."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from os import PathLike, fspath
from typing import TYPE_CHECKING, Literal, Unpack

from bouncelab import _core
from bouncelab._analyze import analyzed
from bouncelab._data import JSON, Diagnostic, Estimate, read
from bouncelab._errors import InputError
from bouncelab._recording import Recording
from bouncelab._report import Reported
from bouncelab._paths import is_url, listed, matched
from bouncelab._settings import Options, analyzer, number, text

if TYPE_CHECKING:
    from bouncelab._analyze import Given


Outcome = Literal["conforms", "conforms-as-far-as-shown", "does-not-conform", "cannot-decide"]


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule of a sport.

    Attributes
    ----------
    name : str
        As in ``rule=`` of :func:`verdict`.
    title : str
        For people.
    source : str
        The rule book, its edition and place.

    Examples
    --------
    >>> import bouncelab as bl
    >>> [rule.title for rule in bl.rules() if rule.name == "ittf-ball"]
    ['Table-tennis ball, 40 mm']
    """

    name: str
    title: str
    source: str


@dataclass(frozen=True)
class Verdict(Reported):
    """Whether drops obey a rule, and how certainly.

    It comes from :func:`bouncelab.verdict`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> sound = bl.synthesize(height_m=0.305, restitution=0.6, bounces=8, seed=1)
    >>> found = bl.verdict([sound.samples], "ittf-ball", sample_rate_hz=sound.sample_rate_hz, draws=500)
    >>> found.outcome
    'does-not-conform'
    >>> found.rebound_m.value < 0.24
    True
    """

    @property
    def outcome(self) -> Outcome:
        """The verdict."""
        outcome: Outcome = self._field("outcome")  # type: ignore[assignment]
        return outcome

    @property
    def probability_within(self) -> float | None:
        """Probability that everything is within the limits; ``None`` if nothing can be said."""
        return read(float | None, self._field("probability_within"))  # type: ignore[arg-type]

    @property
    def rebound_m(self) -> Estimate | None:
        """The mean rebound by the procedure of the rule, in m, at the point at which it measures."""
        found = self._field("rebound_m")
        return None if found is None else read(Estimate, found)

    @property
    def model(self) -> Estimate | None:
        """What the model answers in place of the procedure: a height in m, or a share of the reference."""
        found = self._field("model")
        return None if found is None else read(Estimate, found)

    @property
    def share_of_reference(self) -> Estimate | None:
        """The rebound as a share of that on the reference, for a rule that compares."""
        found = self._field("share_of_reference")
        return None if found is None else read(Estimate, found)

    @property
    def reasons(self) -> tuple[Diagnostic, ...]:
        """Reasons why no decision is possible."""
        return self._diagnostics("reasons")

    @property
    def remarks(self) -> tuple[Diagnostic, ...]:
        """Further remarks."""
        return self._diagnostics("remarks")

    def _field(self, name: str) -> JSON:
        return self.to_dict()[name]

    def _diagnostics(self, name: str) -> tuple[Diagnostic, ...]:
        known = self._field(name)
        assert isinstance(known, list)
        return tuple(read(Diagnostic, each) for each in known)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Verdict) and self._documents == other._documents

    def __repr__(self) -> str:
        return f"<bouncelab.Verdict: {self.outcome}>"

    def _repr_html_(self) -> str:
        """Return the figure, which states the verdict, for notebooks."""
        return self.figure().svg()


def rules() -> tuple[Rule, ...]:
    """Return the rules that are built in.

    Returns
    -------
    tuple of Rule

    Examples
    --------
    >>> import bouncelab as bl
    >>> "ittf-ball" in [rule.name for rule in bl.rules()]
    True
    """
    return tuple(Rule(*rule) for rule in _core.rules_built_in())


def verdict(
    places: Given | Iterable[Given],
    rule: str,
    *,
    reference: Given | Iterable[Given] = (),
    sample_rate_hz: float | None = None,
    risk: float | None = 0.05,
    kept: Iterable[str] = (),
    rule_files: str | PathLike[str] | Iterable[str | PathLike[str]] = (),
    **options: Unpack[Options],
) -> Verdict:
    """Judge drops by the rule of a sport.

    Parameters
    ----------
    places : a recording, or an iterable of recordings
        Recordings as of :func:`analyze`, each of one place on the surface, with one drop or several; a pattern such as
        ``"court/*.wav"`` is every file that matches it.
    rule : str
        One of :func:`rules`, or of ``rule_files``.
    reference : a recording, or an iterable of recordings
        Recordings of the same ball on the reference surface, for a rule that compares.
    sample_rate_hz : float, optional
        Samples a second, where recordings are arrays.
    risk : float or None
        Greatest probability of a wrong decision (JCGM 106), above 0, at most 0.5; ``None`` takes whatever is
        more probable.
    kept : iterable of str
        Parts of the procedure that were kept and that nothing else shows: ``surface``, ``reference``,
        ``conditioning``.
    rule_files : iterable of paths
        Rules of your own, as TOML.
    **options
        As of :func:`analyze`; ball and height are those of the rule unless you state others.

    Returns
    -------
    Verdict

    Raises
    ------
    InputError
        If an argument makes no sense, a recording holds no drop, or one is given twice.
    RecordingError, OutOfRangeError, UnknownNameError, PhysicsError
        As of :func:`analyze`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> sounds = [bl.synthesize(height_m=0.305, restitution=0.93, bounces=15, seed=seed) for seed in (1, 2, 3)]
    >>> drops = [sound.samples for sound in sounds]
    >>> found = bl.verdict(drops, "ittf-ball", sample_rate_hz=44_100, draws=500)
    >>> found.outcome
    'conforms-as-far-as-shown'
    """
    judge = _core.Judge(text("rule", rule), listed("rule_files", rule_files))
    options.setdefault("height_m", None)
    is_its_ball = options.get("ball") is None and options.get("mass_kg") is None
    if is_its_ball:
        if judge.ball() is None:
            raise InputError(f"the rule {rule} names no ball that is known; give ball=, or mass_kg= and diameter_m=")
        options["ball"] = judge.ball()
    completed = judge.complete(analyzer(**options), is_its_ball)

    def surface(sources: object) -> list[_core.Recording]:
        numbered = enumerate(_several(sources), 1)
        return [analyzed(completed, it, sample_rate_hz, _name(it, place), None) for place, it in numbered]

    here, there = surface(places), surface(reference)
    if there and not judge.needs_reference():
        raise InputError(f"the rule {rule} compares with no other surface; leave out reference=")
    _check([Recording(each) for each in (*here, *there)])
    accepted = None if risk is None else number("risk", risk)
    judged = judge.judge(completed, here, there, accepted, [text("kept", part) for part in kept])
    languages = _core.languages()
    return Verdict(
        {language: judged.document(language) for language in languages},
        {language: {"limits": judged.figure("limits", language)} for language in languages},
        {language: judged.page(language) for language in languages},
    )


def _several(sources: object) -> Iterable[object]:
    """Return recordings one by one; a path, a file or an array is a single one."""
    if isinstance(sources, str | PathLike):
        path = fspath(sources)
        return [path] if isinstance(path, bytes) or is_url(path) else matched(path)
    is_single = isinstance(sources, bytes | bytearray | memoryview) or hasattr(sources, "__array__") or hasattr(sources, "read")
    if is_single or not isinstance(sources, Iterable):
        return [sources]
    return sources


def _name(source: object, place: int) -> str | None:
    return None if isinstance(source, str | PathLike) or hasattr(source, "read") else f"place {place}"


def _check(recordings: list[Recording]) -> None:
    """Refuse recordings without a drop, and a drop that is given twice."""
    if not recordings:
        raise InputError("there is no recording to judge; give at least one")
    seen: dict[bytes, str] = {}
    for recording in recordings:
        if recording.no_drop is not None:
            raise InputError(f"{recording.name}: {recording.no_drop.message()}")
        impacts = recording.impacts["time_s"].tobytes()
        if impacts in seen:
            first = seen[impacts]
            raise InputError(f"{first} and {recording.name} are the same recording; every drop counts once")
        seen[impacts] = recording.name
