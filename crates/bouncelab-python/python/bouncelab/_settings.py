"""What a person states of ball, air and drop, checked before it goes to the science."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from numbers import Integral
from typing import SupportsFloat, TypeAlias, TypedDict, Unpack, get_type_hints

from bouncelab import _core
from bouncelab._errors import InputError


@dataclass(frozen=True, slots=True)
class Ball:
    """A ball.

    Attributes
    ----------
    name : str
        As in ``ball=`` of :func:`bouncelab.analyze`.
    label : str
        For people.
    mass_kg, diameter_m : float
        Mass in kg and diameter in m.
    contact_time_s : float
        How long it typically touches the surface, in s.
    source : str
        Where mass and diameter come from.

    Examples
    --------
    >>> import bouncelab as bl
    >>> ball = bl.presets()[0]
    >>> ball.name, ball.mass_kg, ball.diameter_m
    ('table-tennis-40', 0.0027, 0.04)
    """

    name: str
    label: str
    mass_kg: float
    diameter_m: float
    contact_time_s: float
    source: str


@dataclass(frozen=True, slots=True)
class Air:
    """Air.

    Attributes
    ----------
    density_kg_m3 : float
        Density in kg/m³; 0 is vacuum.
    viscosity_pa_s : float
        Dynamic viscosity in Pa s.

    Examples
    --------
    >>> import bouncelab as bl
    >>> on_mars = bl.Air(density_kg_m3=0.02, viscosity_pa_s=1.3e-5)
    >>> bl.terminal_speed_m_s(air=on_mars, gravity_m_s2=3.71) > bl.terminal_speed_m_s()
    True
    """

    density_kg_m3: float
    viscosity_pa_s: float


#: A drag law: as text, or the drag coefficient at Reynolds numbers.
Drag: TypeAlias = str | Mapping[float, float] | Iterable[tuple[float, float]] | Callable[[float], float]


#: What is known of the restitution over the impact speed: as text; mean and standard deviation at speeds; or functions of the
#: speed, of the mean and of the standard deviation, or of the mean and a list of those with standard normal factors.
Prior: TypeAlias = (
    str
    | Mapping[float, tuple[float, float]]
    | tuple[Callable[[float], float], Callable[[float], float] | Sequence[Callable[[float], float]]]
)


class BallOptions(TypedDict, total=False):
    """What is given of the ball."""

    ball: str | Ball | None
    mass_kg: float | None
    diameter_m: float | None
    contact_time_s: float | None


class AirOptions(TypedDict, total=False):
    """What is given of the air, and its forces on the ball."""

    air: Air | None
    drag: Drag | None
    temperature_k: float | None
    pressure_pa: float | None
    relative_humidity: float | None
    density_kg_m3: float | None
    viscosity_pa_s: float | None
    buoyancy: bool | None
    added_mass: bool | None


class GravityOptions(TypedDict, total=False):
    """What is given of gravity."""

    gravity_m_s2: float | None
    latitude_deg: float | None
    altitude_m: float | None


class DropOptions(TypedDict, total=False):
    """What is given of the drop."""

    height_m: float | None
    height_sd_m: float | None
    release_s: float | None
    release_sd_s: float | None
    first_detected: bool | None


class DetectionOptions(TypedDict, total=False):
    """Where in a recording to look for impacts."""

    channel: int | None
    band_hz: tuple[float, float] | None
    rate_hz: int | None


class EditOptions(TypedDict, total=False):
    """Candidates accepted, and impacts excluded and included by hand."""

    accept: Iterable[int] | None
    exclude_s: Iterable[float] | None
    include_s: Iterable[float] | None


class AnalysisOptions(TypedDict, total=False):
    """What to compute besides the inference."""

    flights: tuple[int, int] | None
    compare_balls: bool | None


class PriorOptions(TypedDict, total=False):
    """What is known before the data."""

    restitution_laws: Iterable[str] | None
    restitution_prior: Prior | None
    infer: Iterable[str] | None
    known: Mapping[str, float] | None


class InferenceOptions(PriorOptions, total=False):
    """The inference."""

    at_speed_m_s: float | None
    reach: Iterable[tuple[int, float]] | None
    draws: int | None
    seed: int | None


class PhysicsOptions(BallOptions, AirOptions, GravityOptions, total=False):
    """What is given of ball, air and gravity: keyword arguments, which :func:`bouncelab.analyze` describes.

    Examples
    --------
    >>> import bouncelab as bl
    >>> given: bl.PhysicsOptions = {"ball": "tennis", "temperature_k": 288.15}
    >>> len(bl.simulate(bounces=3, **given).bounces)
    3
    """


class SimulationOptions(PhysicsOptions, PriorOptions, total=False):
    """What is given of ball, air and gravity, and what is known for draws of the prior.

    Examples
    --------
    >>> import bouncelab as bl
    >>> given: bl.SimulationOptions = {"ball": "tennis", "known": {"drag": 0.02}}
    >>> len(bl.simulate(bounces=3, restitution="prior", **given).bounces)
    3
    """


class Options(
    PhysicsOptions, DropOptions, DetectionOptions, EditOptions, AnalysisOptions, InferenceOptions, total=False
):
    """What is given and asked: keyword arguments, which :func:`bouncelab.analyze` describes.

    Examples
    --------
    >>> import bouncelab as bl
    >>> options: bl.Options = {"ball": "tennis", "draws": None}
    >>> bl.analyze_times([0.0, 0.5, 0.9], **options).settings.ball.diameter_m
    0.066
    """


#: The options with their types, by their group in the settings of the science. Names and groups are those of
#: `Settings` in Rust, which a test compares, but for `ball` (`kind`), `air` (an object) and `draws=None` (`enabled`).
GROUPS: dict[str, dict[str, object]] = {
    "ball": get_type_hints(BallOptions),
    "air": get_type_hints(AirOptions),
    "gravity": get_type_hints(GravityOptions),
    "drop": get_type_hints(DropOptions),
    "detection": get_type_hints(DetectionOptions),
    "edits": get_type_hints(EditOptions),
    "analysis": get_type_hints(AnalysisOptions),
    "inference": get_type_hints(InferenceOptions),
}

#: The options of single recordings, which those of many do not have.
OF_ONE_RECORDING = (*GROUPS["detection"], *GROUPS["edits"])


def refuse_options_of_one_recording(options: Iterable[str]) -> None:
    """Refuse options of single recordings where there are many."""
    if not set(OF_ONE_RECORDING).isdisjoint(options):
        *others, last = OF_ONE_RECORDING
        raise InputError(f"{', '.join(others)} and {last} are of single recordings; use analyze")


def analyzer(**options: Unpack[Options]) -> _core.Analyzer:
    """Resolve the options."""
    return _core.Analyzer(settings_of(options))


def settings_of(options: Options) -> str:
    """Check the options, and return them as the settings of the science, in JSON."""
    types = {name: kind for group in GROUPS.values() for name, kind in group.items()}
    unknown = options.keys() - types.keys()
    if unknown:
        raise InputError(f"there is no option {min(unknown)!r}; known: {', '.join(types)}")
    given = {name: value for name, value in options.items() if value is not None}
    if "ball" not in given and len({"mass_kg", "diameter_m"} & given.keys()) == 1:
        raise InputError("mass_kg and diameter_m describe a ball together; give both, or the kind of the ball by ball=")
    ball, air = _of_ball(given), _of_air(given)
    plain = {name: _plain(name, types[name], value) for name, value in given.items()}
    settings = {
        group: {name: plain[name] for name in names if name in plain} for group, names in GROUPS.items()
    }
    settings["ball"] = ball | settings["ball"]
    settings["air"] |= air
    settings["inference"]["enabled"] = options.get("draws", 0) is not None
    return json.dumps(settings)


def _of_ball(given: dict[str, object]) -> dict[str, object]:
    """Take the ball out of the options, as settings."""
    ball = given.pop("ball", None)
    if ball is None:
        return {}
    if not isinstance(ball, Ball):
        return {"kind": text("ball", ball)}
    quantities = ("mass_kg", "diameter_m", "contact_time_s")
    given_of_it: dict[str, object] = {name: getattr(ball, name) for name in quantities}
    preset = next((Ball(*fields) for fields in _core.balls() if fields[0] == ball.name), None)
    if preset is None:
        return given_of_it
    # Only what differs from the preset was measured; the rest is as uncertain as the preset says.
    measured = {name: value for name, value in given_of_it.items() if value != getattr(preset, name)}
    return {"kind": ball.name, **measured}


def _of_air(given: dict[str, object]) -> dict[str, object]:
    """Take the air out of the options, as settings."""
    air = given.pop("air", None)
    if air is None:
        return {}
    if not isinstance(air, Air):
        raise InputError(f"air must be made by bouncelab.air(...), not of {_kind(air)}")
    return {"density_kg_m3": air.density_kg_m3, "viscosity_pa_s": air.viscosity_pa_s}


def _plain(name: str, kind: object, value: object) -> object:
    """Return an option as plain data, by its type."""
    if name == "band_hz":
        numbers = [number(name, each) for each in _listed(name, value)]
        if not (len(numbers) == 2 and numbers[0] < numbers[1]):
            raise InputError("band_hz must be two frequencies in Hz, the lower first, as in (400, 6000)")
        return numbers
    if name == "flights":
        ends = [count(name, each) for each in _listed(name, value)]
        if not (len(ends) == 2 and 1 <= ends[0] <= ends[1]):
            raise InputError("flights must be the first and the last, counted from 1, as in (1, 10)")
        return ends
    if name == "reach":
        return [_target(each) for each in _listed(name, value)]
    if name == "drag":
        return drag_law(value)
    if name == "restitution_prior":
        return restitution_prior(value)
    if name == "known":
        if not isinstance(value, Mapping):
            raise InputError(f"known must be a mapping, not {_kind(value)}")
        return {text("known", key): number(name, share) for key, share in value.items()}
    return _READERS[kind](name, value)


#: Reynolds numbers at which a function of them is sampled, 48 for each decade: from a bubble's to a golf ball's.
REYNOLDS = tuple(10.0 ** (place / 48.0) for place in range(48, 6 * 48 + 1))


def drag_law(value: object) -> str:
    """Return a drag law as text: a mapping, pairs and a function of the Reynolds number are tables of the drag coefficient."""
    if isinstance(value, str):
        return value
    if callable(value):
        points = [(reynolds, number("drag", value(reynolds))) for reynolds in REYNOLDS]
    else:
        listed = value.items() if isinstance(value, Mapping) else _listed("drag", value)
        pairs = [_listed("drag", pair) for pair in listed]
        if any(len(pair) != 2 for pair in pairs):
            raise InputError("drag must be pairs of a Reynolds number and a drag coefficient, as in [(1e4, 0.64), (1e5, 0.58)]")
        points = sorted((number("drag", reynolds), number("drag", coefficient)) for reynolds, coefficient in pairs)
    return "table:" + ",".join(f"{reynolds!r}={coefficient!r}" for reynolds, coefficient in points)


#: Impact speeds in m/s at which a function of them is sampled, 16 for a factor of two: from impacts that are hardly heard to the
#: fastest serve.
SPEEDS_M_S = tuple(2.0 ** (place / 16.0) for place in range(-5 * 16, 6 * 16 + 1))


def restitution_prior(value: object) -> str:
    """Return what is known of the restitution as text: mappings and functions of the impact speed are tables."""
    name = "restitution_prior"
    if isinstance(value, str):
        return value
    kind = "normal"
    if isinstance(value, Mapping):
        points = [(number(name, speed), _listed(name, pair)) for speed, pair in value.items()]
    else:
        listed = _listed(name, value)
        of_speed = [listed[0], *(listed[1:] if callable(listed[-1]) else _listed(name, listed[-1]))] if listed else []
        if len(listed) != 2 or not all(map(callable, of_speed)):
            raise InputError(f"{name} must be a mapping, or a function of the mean and one or a list of deviations")
        kind = "normal" if callable(listed[1]) else "functions"
        points = [(speed, [function(speed) for function in of_speed]) for speed in SPEEDS_M_S]  # type: ignore[operator]
    if any(len(numbers) < 2 for _, numbers in points):
        raise InputError(f"{name} must have a mean and a standard deviation at each speed, as in {{1.0: (0.9, 0.02)}}")
    texts = (f"{speed!r}=" + ":".join(repr(number(name, each)) for each in numbers) for speed, numbers in sorted(points))
    return f"{kind}:" + ",".join(texts)


def _target(value: object) -> dict[str, float]:
    pair = _listed("reach", value)
    if len(pair) != 2:
        raise InputError("reach must be pairs of a bounce and an apex in m, as in [(2, 0.28)]")
    return {"bounce": count("reach", pair[0]), "apex_m": number("reach", pair[1])}


def number(name: str, value: object) -> float:
    """Return a finite number, of Python or NumPy."""
    if isinstance(value, bool) or not isinstance(value, SupportsFloat):
        raise InputError(f"{name} must be a number, not {_kind(value)}")
    try:
        plain = float(value)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{name} must be one number, not {_kind(value)}") from None
    if plain - plain != 0.0:
        raise InputError(f"{name} is {plain}; it must be finite")
    return plain


def count(name: str, value: object) -> int:
    """Return a whole number from 0, of Python or NumPy."""
    if isinstance(value, bool) or not isinstance(value, Integral) or not 0 <= int(value) < 2**63:
        raise InputError(f"{name} must be a whole number, not negative; it is {value!r:.50}")
    return int(value)


def flag(name: str, value: object) -> bool:
    """Return a truth value."""
    if not isinstance(value, bool):
        raise InputError(f"{name} must be True or False, not {_kind(value)}")
    return value


def text(name: str, value: object) -> str:
    """Return a text."""
    if not isinstance(value, str):
        raise InputError(f"{name} must be a text, not {_kind(value)}")
    return value


def texts(name: str, value: object) -> list[str]:
    """Return texts; a single one is a list of one."""
    return [text(name, each) for each in _listed(name, [value] if isinstance(value, str) else value)]


def _listed(name: str, value: object) -> list[object]:
    if isinstance(value, str | bytes | Mapping) or not isinstance(value, Iterable):
        raise InputError(f"{name} must be a list, not {_kind(value)}")
    return list(value)


def _kind(value: object) -> str:
    return type(value).__name__


#: How an option of a type is read.
_READERS: dict[object, Callable[[str, object], object]] = {
    str | None: text,
    bool | None: flag,
    int | None: count,
    float | None: number,
    Iterable[str] | None: lambda name, value: [text(name, each) for each in _listed(name, value)],
    Iterable[int] | None: lambda name, value: [count(name, each) for each in _listed(name, value)],
    Iterable[float] | None: lambda name, value: [number(name, each) for each in _listed(name, value)],
}
