"""Results as plain, immutable data. The names are those of the schema ``bouncelab.analysis/3``."""

from __future__ import annotations

import dataclasses
import functools
import json
import math
import types
import typing
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeAlias, TypeVar

JSON: TypeAlias = "dict[str, JSON] | list[JSON] | str | float | int | bool | None"

T = TypeVar("T")


class Shown:
    """A result of many fields, each of which a person sees in one line."""

    __slots__ = ()

    def _lines(self) -> list[tuple[str, str]]:
        assert dataclasses.is_dataclass(self)
        values = ((field.name, getattr(self, field.name)) for field in dataclasses.fields(self))
        return [(name, _in_a_line(value)) for name, value in values]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value}' for name, value in self._lines())})"

    def _repr_html_(self) -> str:
        """Return a table of the fields as HTML, for notebooks."""
        from html import escape

        rows = (f"<tr><th>{escape(name)}</th><td>{escape(value)}</td></tr>" for name, value in self._lines())
        return f"<table>{''.join(rows)}</table>"


def _in_a_line(value: object) -> str:
    """Return a value for a person: an estimate with its uncertainty, and of a list its length."""
    match value:
        case Estimate():
            return str(value)
        case Measured():
            return f"{value.value:.6g} ± {value.sd:.6g}"
        case float():
            return f"{value:.6g}"
        case tuple() if value:
            return f"<{len(value)} of {type(value[0]).__name__}>"
        case _:
            return f"<{type(value).__name__}>" if dataclasses.is_dataclass(value) else repr(value)



@dataclass(frozen=True, slots=True)
class Estimate:
    """A number found from data, with its uncertainty.

    Attributes
    ----------
    value : float
        The median of the posterior, or the best value.
    sd : float
        Standard uncertainty; infinite where the data leave nothing to judge it by.
    interval68, interval95 : tuple of float
        Lower and upper end of the interval that holds the value with that probability.

    Examples
    --------
    >>> import bouncelab as bl
    >>> fit = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045]).drops[0].log_linear_fit
    >>> print(f"{fit.restitution.value:.3f} ± {fit.restitution.sd:.3f}")
    0.932 ± 0.001
    >>> float(fit.restitution) == fit.restitution.value
    True
    >>> f"{fit.restitution:.3f}", str(fit.restitution)
    ('0.932 ± 0.001', '0.93221 ± 0.00097')
    """

    value: float
    sd: float = math.inf
    interval68: tuple[float, float] = (-math.inf, math.inf)
    interval95: tuple[float, float] = (-math.inf, math.inf)

    def __float__(self) -> float:
        return self.value

    def __format__(self, spec: str) -> str:
        """Return value and standard uncertainty, both by a format of numbers."""
        return f"{self.value:{spec}} ± {self.sd:{spec}}" if spec else str(self)

    def __str__(self) -> str:
        """Return value and standard uncertainty, of which two digits count."""
        if not (0.0 < self.sd < math.inf):
            return f"{self.value:.6g} ± {self.sd:g}"
        places = 1 - math.floor(math.log10(self.sd))
        return f"{self:.{places}f}" if places >= 0 else f"{self:.6g}"


@dataclass(frozen=True, slots=True)
class Measured:
    """A value that was known before, with its standard uncertainty.

    Attributes
    ----------
    value : float
        The value.
    sd : float
        Standard uncertainty, in the unit of the value.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> posterior.drag_coefficient_prior.sd > 0
    True
    """

    value: float
    sd: float


@dataclass(frozen=True)
class Diagnostic:
    """A remark on a result.

    Attributes
    ----------
    code : str
        Stable name, one of :func:`bouncelab.diagnostic_codes`.
    severity : str
        ``"info"``, ``"warning"`` or ``"error"``.
    arguments : mapping
        The values that belong to it, by name, in SI.

    Examples
    --------
    >>> import bouncelab as bl
    >>> reason = bl.analyze_times([0.0], draws=None).no_drop
    >>> reason.code
    'too-few-times'
    >>> reason.message("de") != reason.message("en")
    True
    """

    code: str
    severity: str
    arguments: Mapping[str, float | str | list[float]]

    def message(self, language: str = "en") -> str:
        """Return the sentence in a language.

        Parameters
        ----------
        language : str
            One of :func:`bouncelab.languages`.

        Returns
        -------
        str

        Raises
        ------
        UnknownNameError
            If there is no such language.
        """
        from bouncelab import _core

        return _core.message(json.dumps(dataclasses.asdict(self)), language)

    def __str__(self) -> str:
        return self.message()


@dataclass(frozen=True, slots=True)
class Source:
    """Where impact times come from.

    Attributes
    ----------
    kind : str
        ``"sound"`` or ``"times"``, a list of times. What is of the other kind is ``None``.
    format : str or None
        Format of the file, for people.
    sample_rate_hz : int or None
        Samples a second.
    channels : int or None
        How many channels there are.
    channel : int or None
        The channel that was used, the first being 1.
    duration_s : float or None
        Length in s.
    onsets : int or None
        How many sounds stand out of the background.
    program : str or None
        The program that exported the list, and its kind of export, if they are known.
    by_threshold : bool or None
        Whether each time is that at which the sound exceeded a threshold.
    of_intervals : bool or None
        Whether the times are sums of listed intervals.
    notes : mapping or None
        What the file states of the measurement, by field.

    Examples
    --------
    >>> import bouncelab as bl
    >>> sound = bl.synthesize(bounces=8, seed=1)
    >>> bl.analyze(sound.samples, sound.sample_rate_hz, draws=None).source.channels
    1
    >>> bl.analyze(b"interval (s)\\n0.5\\n0.4\\n0.3", name="list.csv", draws=None).source.of_intervals
    True
    """

    kind: str
    format: str | None = None
    sample_rate_hz: int | None = None
    channels: int | None = None
    channel: int | None = None
    duration_s: float | None = None
    onsets: int | None = None
    program: str | None = None
    by_threshold: bool | None = None
    of_intervals: bool | None = None
    notes: Mapping[str, str] | None = None


@dataclass(frozen=True, slots=True)
class StrongestBand:
    """The band of frequencies in which the impacts stand out most.

    Attributes
    ----------
    low_hz, high_hz : float
        Its ends in Hz.
    above_background_db : float
        By how much they stand out, in dB.

    Examples
    --------
    >>> import bouncelab as bl
    >>> sound = bl.synthesize(bounces=8, seed=1)
    >>> band = bl.analyze(sound.samples, sound.sample_rate_hz, draws=None).strongest_band
    >>> band.low_hz < band.high_hz
    True
    """

    low_hz: float
    high_hz: float
    above_background_db: float


@dataclass(frozen=True, slots=True)
class BallUsed:
    """The ball, as used.

    Attributes
    ----------
    mass_kg, diameter_m : float
        Mass in kg and diameter in m.
    contact_time_s : float
        How long the ball touches the surface, in s.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.analyze_times([0.0, 0.5, 0.9], draws=None, ball="tennis").settings.ball.mass_kg
    0.0577
    """

    mass_kg: float
    diameter_m: float
    contact_time_s: float


@dataclass(frozen=True, slots=True)
class AirUsed:
    """The air and its forces on the ball, as used.

    Attributes
    ----------
    density_kg_m3, viscosity_pa_s : float
        Density in kg/m³ and dynamic viscosity in Pa s.
    drag : str
        The drag law.
    buoyancy, added_mass : bool
        Whether these forces count.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.analyze_times([0.0, 0.5, 0.9], draws=None, drag="constant:0.45").settings.air.drag
    'constant:0.45'
    """

    density_kg_m3: float
    viscosity_pa_s: float
    drag: str
    buoyancy: bool
    added_mass: bool


@dataclass(frozen=True, slots=True)
class GravityUsed:
    """Gravity, as used.

    Attributes
    ----------
    gravity_m_s2 : float
        Gravity in m/s².

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.analyze_times([0.0, 0.5, 0.9], draws=None, gravity_m_s2=9.81).settings.gravity.gravity_m_s2
    9.81
    """

    gravity_m_s2: float


@dataclass(frozen=True)
class SettingsUsed:
    """What was known or assumed of ball, air and gravity, in the groups of the settings.

    Attributes
    ----------
    ball : BallUsed
        The ball.
    air : AirUsed
        The air and its forces.
    gravity : GravityUsed
        Gravity.
    assumptions : tuple of Diagnostic
        What was assumed for want of an option.

    Examples
    --------
    >>> import bouncelab as bl
    >>> settings = bl.analyze_times([0.0, 0.5, 0.9], draws=None, ball="tennis").settings
    >>> settings.ball.mass_kg
    0.0577
    """

    ball: BallUsed
    air: AirUsed
    gravity: GravityUsed
    assumptions: tuple[Diagnostic, ...]


@dataclass(frozen=True, slots=True)
class BallComparison:
    """The results of a drop for a preset ball.

    Attributes
    ----------
    ball : str
        The name of the preset.
    log_bayes_factor : float
        Natural logarithm of the evidence of this ball over that of the ball that was stated or assumed.
    restitution, drop_height_m : Estimate
        The results, if it was this ball; the height in m.

    Examples
    --------
    >>> import bouncelab as bl
    >>> times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045]
    >>> balls = bl.analyze_times(times_s, draws=100, compare_balls=True).drops[0].balls
    >>> len(balls) == len(bl.presets())
    True
    """

    ball: str
    log_bayes_factor: float
    restitution: Estimate
    drop_height_m: Estimate


@dataclass(frozen=True, slots=True, repr=False)
class LogLinearFit(Shown):
    """The log-linear fit: the line through log10 of the flight times, as without drag (Nagurka 2003, Eqs. 4 to 8).

    Attributes
    ----------
    flights : int
        How many flights it goes through.
    slope, intercept : Estimate
        Of log10 of the flight time in s against the number of the flight.
    r_squared : float or None
        Coefficient of determination; ``None`` for two flights.
    restitution : Estimate
        Coefficient of restitution.
    drop_height_m : Estimate
        Height of the fall before the first impact, in m.
    energy_kept : Estimate
        Share of the energy that each impact leaves.
    total_time_s, total_path_m : Estimate or None
        From the release to rest, in s and m; ``None`` if the ball would not rest.
    residuals : tuple of float
        What the line leaves of each log10, in the order of the flights.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0]
    >>> fit = drop.log_linear_fit
    >>> fit.flights, round(fit.restitution.value, 3)
    (5, 0.932)
    """

    flights: int
    slope: Estimate
    intercept: Estimate
    r_squared: float | None
    restitution: Estimate
    drop_height_m: Estimate
    energy_kept: Estimate
    total_time_s: Estimate | None
    total_path_m: Estimate | None
    residuals: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class ImpactRestitution:
    """The restitution of one impact, corrected for drag.

    Attributes
    ----------
    number : int
        Number of the impact, the first being 1.
    impact_speed_m_s : float
        Speed before it, in m/s.
    restitution : Estimate
        Speed after it over speed before it.
    flight_time_ratio : float
        The flight after it over that before it: the restitution if there were no air.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0]
    >>> first = drop.per_impact.impacts[0]
    >>> first.restitution.value > first.flight_time_ratio
    True
    """

    number: int
    impact_speed_m_s: float
    restitution: Estimate
    flight_time_ratio: float


@dataclass(frozen=True, slots=True, repr=False)
class PerImpact(Shown):
    """The restitution of single impacts, corrected for drag.

    Attributes
    ----------
    restitution : Estimate or None
        The median over them.
    slowest_m_s, fastest_m_s : float or None
        Least and greatest impact speed, in m/s.
    impacts : tuple of ImpactRestitution
        The impacts.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0]
    >>> len(drop.per_impact.impacts)
    4
    """

    restitution: Estimate | None
    slowest_m_s: float | None
    fastest_m_s: float | None
    impacts: tuple[ImpactRestitution, ...]


@dataclass(frozen=True, slots=True)
class ImpactPosterior:
    """An impact, and the flight after it, as the inference has them.

    Attributes
    ----------
    number : int
        Number of the impact, the first being 1.
    impact_speed_m_s : Estimate
        Speed before it, in m/s.
    restitution : Estimate or None
        Speed after it over speed before it; ``None`` for the last.
    apex_m : Estimate or None
        Apex of the flight after it, in m.
    lost_to_surface_j, lost_to_air_j : Estimate or None
        Energy that the impact and the flight after it took, in J.
    standardised_residual : float or None
        What the model leaves of its time, in standard deviations.
    weight : float
        From 1 down to 0 for an outlier.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> [impact.number for impact in posterior.impacts]
    [1, 2, 3, 4, 5, 6]
    """

    number: int
    impact_speed_m_s: Estimate
    restitution: Estimate | None
    apex_m: Estimate | None
    lost_to_surface_j: Estimate | None
    lost_to_air_j: Estimate | None
    standardised_residual: float | None
    weight: float


@dataclass(frozen=True, slots=True)
class Model:
    """A restitution law with a kind of ball, and how probable they are.

    Attributes
    ----------
    restitution_law : str
        Name of the law.
    ball : str or None
        Kind of the ball; ``None`` if the ball was stated.
    probability : float
        Posterior probability of the two together.
    log_odds : float
        Natural logarithm of its probability over that of the most probable.
    restitution, drop_height_m : Estimate or None
        What they alone would give; the height in m. ``None`` if their probability is negligible.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> round(sum(model.probability for model in posterior.models), 6)
    1.0
    """

    restitution_law: str
    ball: str | None
    probability: float
    log_odds: float
    restitution: Estimate | None
    drop_height_m: Estimate | None


@dataclass(frozen=True, slots=True)
class Share:
    """The part of an uncertainty that comes from one source.

    Attributes
    ----------
    source : str
        Where it comes from.
    sd : float
        Standard uncertainty that this source alone would leave, in the unit of the quantity.
    share : float
        Its share of the variance.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> share = posterior.budget.drop_height_m[0]
    >>> share.sd >= 0.0
    True
    """

    source: str
    sd: float
    share: float


@dataclass(frozen=True, slots=True)
class Budget:
    """Where the uncertainty of restitution and drop height comes from.

    Attributes
    ----------
    restitution, drop_height_m : tuple of Share
        The sources of each.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> len(posterior.budget.restitution) > 1
    True
    """

    restitution: tuple[Share, ...]
    drop_height_m: tuple[Share, ...]


@dataclass(frozen=True, slots=True)
class Prediction:
    """The drop height from which a bounce reaches an apex.

    Attributes
    ----------
    bounce : int
        Number of the bounce, the first being 1.
    apex_m : float
        The apex in m.
    drop_height_m : Estimate or None
        The height in m; ``None`` if no height reaches it.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500, reach=[(2, 0.2)]).drops[0]
    >>> 0.2 < drop.posterior.predictions[0].drop_height_m.value < 0.4
    True
    """

    bounce: int
    apex_m: float
    drop_height_m: Estimate | None


@dataclass(frozen=True, slots=True)
class PriorContraction:
    """How much the data tell of an unknown.

    Attributes
    ----------
    unknown : str
        Its name.
    remaining : float
        Its width after the data relative to before: 1 means that they contain no information on it.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> min(it.remaining for it in posterior.prior_contraction) < 0.5
    True
    """

    unknown: str
    remaining: float


@dataclass(frozen=True, slots=True)
class Correlations:
    """Correlations between the answers.

    Attributes
    ----------
    quantities : tuple of str
        Their names.
    matrix : tuple of tuple of float
        A row and a column for each.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> round(posterior.correlations.matrix[0][0], 6)
    1.0
    """

    quantities: tuple[str, ...]
    matrix: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class Sampling:
    """How the sampling went (Vehtari et al. 2024, Pareto smoothed importance sampling).

    Attributes
    ----------
    effective_draws : float
        How many independent draws the weighted ones are worth.
    pareto_shape : float
        Shape of the tail of the weights: below 0.7, above which there is no posterior.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> posterior.sampling.pareto_shape < 0.7
    True
    """

    effective_draws: float
    pareto_shape: float


@dataclass(frozen=True, slots=True)
class BandPoint:
    """The restitution law at one impact speed.

    Attributes
    ----------
    speed_m_s : float
        Impact speed in m/s.
    restitution : Estimate
        The restitution there.

    Examples
    --------
    >>> import bouncelab as bl
    >>> posterior = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=500).drops[0].posterior
    >>> [point.speed_m_s for point in posterior.band] == sorted(point.speed_m_s for point in posterior.band)
    True
    """

    speed_m_s: float
    restitution: Estimate


@dataclass(frozen=True, repr=False)
class Posterior(Shown):
    """The posterior of one drop, over all priors and models.

    What is not defined, such as drag in vacuum, is ``None``. ``docs/json.md`` of the project says more, under
    ``drops[].posterior``.

    Attributes
    ----------
    at_speed_m_s : float
        Impact speed in m/s at which ``restitution`` is stated: that of the first impact detected, unless asked otherwise.
    restitution : Estimate
        Coefficient of restitution there.
    first_speed_m_s : float
        Speed of the first impact detected, in m/s.
    energy_kept : Estimate
        Share of its kinetic energy that the ball kept there.
    round_speed_m_s : float or None
        Of 1, 2, 5, 10, ... m/s, that between the slowest and the fastest impact which is nearest to 1 m/s.
    round_speed_restitution : Estimate or None
        Coefficient of restitution there.
    restitution_slope : Estimate
        Its change with the natural logarithm of the impact speed, there.
    drop_height_m : Estimate
        Height of the fall before the first impact detected, in m.
    drag_coefficient : Estimate or None
        Drag coefficient at ``drag_reynolds``.
    drag_reynolds : float or None
        Reynolds number of the fastest impact.
    drag_coefficient_prior : Measured or None
        What was known of the drag coefficient before the data.
    terminal_speed_m_s : Estimate or None
        Terminal speed in m/s.
    gravity_m_s2 : Estimate
        Gravity in m/s².
    restitution_scatter : Estimate
        Standard deviation of the restitution from impact to impact.
    timing_s : Estimate
        Standard deviation of the impact times, in s.
    contact_time_s : Estimate
        Contact time in s.
    total_time_s, total_path_m : Estimate or None
        Time in s and path in m from the release to rest.
    missed_first_impacts : tuple of float or None
        Probabilities that 0, 1, 2, ... impacts went undetected before the first.
    first_is_other_sound : float
        Probability that the first impact detected is another sound, or of an earlier drop.
    predictions : tuple of Prediction
        Answers to ``reach=``.
    impacts : tuple of ImpactPosterior
        The impacts.
    models : tuple of Model
        The laws that were compared, the most probable first.
    prior_contraction : tuple of PriorContraction
        What the data tell of each unknown.
    correlations : Correlations
        Correlations between the answers.
    budget : Budget
        Where the uncertainty comes from.
    sampling : Sampling
        How the sampling went.
    priors : tuple of Diagnostic
        What was known before the data.
    band : tuple of BandPoint
        Restitution against impact speed.

    Examples
    --------
    >>> import bouncelab as bl
    >>> times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984]
    >>> posterior = bl.analyze_times(times_s, draws=500).drops[0].posterior
    >>> 0.9 < posterior.restitution.value < 1.0
    True
    >>> posterior.energy_kept.value < posterior.restitution.value
    True
    """

    at_speed_m_s: float
    restitution: Estimate
    first_speed_m_s: float
    energy_kept: Estimate
    round_speed_m_s: float | None
    round_speed_restitution: Estimate | None
    restitution_slope: Estimate
    drop_height_m: Estimate
    drag_coefficient: Estimate | None
    drag_reynolds: float | None
    drag_coefficient_prior: Measured | None
    terminal_speed_m_s: Estimate | None
    gravity_m_s2: Estimate
    restitution_scatter: Estimate
    timing_s: Estimate
    contact_time_s: Estimate
    total_time_s: Estimate | None
    total_path_m: Estimate | None
    missed_first_impacts: tuple[float, ...] | None
    first_is_other_sound: float
    predictions: tuple[Prediction, ...]
    impacts: tuple[ImpactPosterior, ...]
    models: tuple[Model, ...]
    prior_contraction: tuple[PriorContraction, ...]
    correlations: Correlations
    budget: Budget
    sampling: Sampling
    priors: tuple[Diagnostic, ...]
    band: tuple[BandPoint, ...]


def read(kind: type[T], value: JSON) -> T:
    """Make a result of plain data; what it does not know is left out."""
    return typing.cast("T", _read(kind, value))


def _read(kind: object, value: JSON) -> object:
    if kind is float and value is None:
        return math.inf
    if isinstance(kind, types.UnionType):
        return None if value is None else _read(typing.get_args(kind)[0], value)
    if kind == tuple[float, float] and value is None:
        return (-math.inf, math.inf)
    if isinstance(value, list) and typing.get_origin(kind) is tuple:
        inner = typing.get_args(kind)[0]
        return tuple(_read(inner, each) for each in value)
    if isinstance(value, dict) and isinstance(kind, type) and dataclasses.is_dataclass(kind):
        fields = _fields(kind)
        return kind(**{name: _read(of, value[name]) for name, of in fields.items() if name in value})
    return value


@functools.cache
def _fields(kind: type) -> dict[str, object]:
    hints = typing.get_type_hints(kind)
    return {field.name: hints[field.name] for field in dataclasses.fields(kind)}
