"""Results as plain, immutable data. The names are those of the schema ``bouncelab.analysis/2``."""

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


@dataclass(frozen=True, slots=True)
class Estimate:
    """A number found from data, with its uncertainty.

    Parameters
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
    """

    value: float
    sd: float = math.inf
    interval68: tuple[float, float] = (-math.inf, math.inf)
    interval95: tuple[float, float] = (-math.inf, math.inf)

    def __float__(self) -> float:
        return self.value


@dataclass(frozen=True, slots=True)
class Measured:
    """A value that was known before, with its standard uncertainty."""

    value: float
    sd: float


@dataclass(frozen=True)
class Diagnostic:
    """A remark on a result.

    Parameters
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
        """Return the sentence in a language, one of :func:`bouncelab.languages`."""
        from bouncelab import _core

        return _core.message(json.dumps(dataclasses.asdict(self)), language)

    def __str__(self) -> str:
        return self.message()


@dataclass(frozen=True, slots=True)
class Source:
    """Where impact times come from: ``kind`` is ``"sound"`` or ``"times"``, of which nothing else is known."""

    kind: str
    format: str | None = None
    sample_rate_hz: int | None = None
    channels: int | None = None
    channel: int | None = None
    duration_s: float | None = None
    onsets: int | None = None


@dataclass(frozen=True, slots=True)
class StrongestBand:
    """The band in which the impacts stand out most, in Hz and dB."""

    low_hz: float
    high_hz: float
    above_background_db: float


@dataclass(frozen=True)
class Settings:
    """What was known or assumed of ball, air and gravity, in SI."""

    ball_mass_kg: float
    ball_diameter_m: float
    contact_time_s: float
    air_density_kg_m3: float
    air_viscosity_pa_s: float
    drag: str
    buoyancy: bool
    added_mass: bool
    gravity_m_s2: float
    assumptions: tuple[Diagnostic, ...]


@dataclass(frozen=True, slots=True)
class LogLinearFit:
    """The straight line through log10 of the flight times (Nagurka 2003, Eqs. 4 to 8), as without drag."""

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
    """The restitution of one impact, corrected for drag; ``flight_time_ratio`` is that without air."""

    number: int
    impact_speed_m_s: float
    restitution: Estimate
    flight_time_ratio: float


@dataclass(frozen=True, slots=True)
class PerImpact:
    """The restitution of single impacts, corrected for drag; ``restitution`` is the median over them."""

    restitution: Estimate | None
    slowest_m_s: float | None
    fastest_m_s: float | None
    impacts: tuple[ImpactRestitution, ...]


@dataclass(frozen=True, slots=True)
class ImpactPosterior:
    """An impact, and the flight after it, as the inference has them."""

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
    """A restitution law with a drag law, and how probable they are."""

    restitution_law: str
    drag_law: str
    probability: float
    log_evidence: float
    restitution: Estimate | None
    drop_height_m: Estimate | None


@dataclass(frozen=True, slots=True)
class Share:
    """The standard uncertainty that one source alone would leave, and its share of the variance."""

    source: str
    sd: float
    share: float


@dataclass(frozen=True, slots=True)
class Budget:
    """Where the uncertainty of restitution and drop height comes from."""

    restitution: tuple[Share, ...]
    drop_height_m: tuple[Share, ...]


@dataclass(frozen=True, slots=True)
class Prediction:
    """The drop height from which a bounce reaches an apex."""

    bounce: int
    apex_m: float
    drop_height_m: Estimate | None


@dataclass(frozen=True, slots=True)
class PriorContraction:
    """Width of an unknown after the data relative to before: 1 means that the data contain no information on it."""

    unknown: str
    remaining: float


@dataclass(frozen=True, slots=True)
class Correlations:
    """Correlations between the answers, a row of ``matrix`` for each of ``quantities``."""

    quantities: tuple[str, ...]
    matrix: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class Sampling:
    """How the sampling went; ``pareto_shape`` is good below 0.7."""

    effective_draws: float
    pareto_shape: float
    converged: bool


@dataclass(frozen=True, slots=True)
class BandPoint:
    """The restitution law at one impact speed."""

    speed_m_s: float
    restitution: Estimate


@dataclass(frozen=True)
class Posterior:
    """The posterior of one drop, over all priors and models.

    The attributes are described in ``docs/json.md`` of the project, under ``drops[].posterior``. What is
    not defined, such as drag in vacuum, is ``None``.

    Examples
    --------
    >>> import bouncelab as bl
    >>> times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984]
    >>> posterior = bl.analyze_times(times_s, draws=500).drops[0].posterior
    >>> 0.9 < posterior.restitution.value < 1.0
    True
    >>> posterior.sampling.converged
    True
    """

    at_speed_m_s: float
    restitution: Estimate
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
    made: T = _read(kind, value)
    return made


def _read(kind: object, value: typing.Any) -> typing.Any:
    if kind is float and value is None:
        return math.inf
    if isinstance(kind, types.UnionType):
        return None if value is None else _read(typing.get_args(kind)[0], value)
    if typing.get_origin(kind) is tuple:
        inner = typing.get_args(kind)[0]
        if kind == tuple[float, float] and value is None:
            return (-math.inf, math.inf)
        return tuple(_read(inner, each) for each in value)
    if isinstance(kind, type) and dataclasses.is_dataclass(kind):
        fields = _fields(kind)
        return kind(**{name: _read(of, value[name]) for name, of in fields.items() if name in value})
    return value


@functools.cache
def _fields(kind: type) -> dict[str, object]:
    hints = typing.get_type_hints(kind)
    return {field.name: hints[field.name] for field in dataclasses.fields(kind)}
