"""What a person states of ball, air and drop, checked before it goes to the science."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from numbers import Integral
from typing import SupportsFloat, TypedDict, Unpack

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


class PhysicsSettings(TypedDict, total=False):
    """What is known of ball, air and gravity: keyword arguments, which :func:`bouncelab.analyze` describes.

    Examples
    --------
    >>> import bouncelab as bl
    >>> known: bl.PhysicsSettings = {"ball": "tennis", "temperature_k": 288.15}
    >>> len(bl.simulate(bounces=3, **known).bounces)
    3
    """

    ball: str | Ball | None
    mass_kg: float | None
    diameter_m: float | None
    contact_time_s: float | None
    air: Air | None
    temperature_k: float | None
    pressure_pa: float | None
    relative_humidity: float | None
    drag: str | None
    buoyancy: bool | None
    added_mass: bool | None
    gravity_m_s2: float | None
    latitude_deg: float | None
    altitude_m: float | None


class Options(PhysicsSettings, total=False):
    """What is known and asked: keyword arguments, which :func:`bouncelab.analyze` describes.

    Examples
    --------
    >>> import bouncelab as bl
    >>> options: bl.Options = {"ball": "tennis", "draws": None}
    >>> bl.analyze_times([0.0, 0.5, 0.9], **options).settings.ball_diameter_m
    0.066
    """

    height_m: float | None
    height_sd_m: float | None
    release_s: float | None
    release_sd_s: float | None
    first_detected: bool | None
    restitution_laws: Iterable[str] | None
    infer: Iterable[str] | None
    flights: tuple[int, int] | None
    at_speed_m_s: float | None
    reach: Iterable[tuple[int, float]] | None
    draws: int | None
    seed: int
    channel: int | None
    band_hz: tuple[float, float] | None
    exclude_s: Iterable[float]
    include_s: Iterable[float]


def analyzer(**options: Unpack[Options]) -> _core.Analyzer:
    """Resolve the options."""
    settings, question = split(options)
    return _core.Analyzer(json.dumps(settings), json.dumps(question))


def split(options: Options) -> tuple[dict[str, object], dict[str, object]]:
    """Check the options, and divide them into settings and what else is asked."""
    known = PhysicsSettings.__annotations__ | Options.__annotations__
    unknown = options.keys() - known.keys()
    if unknown:
        raise InputError(f"there is no option {min(unknown)!r}; known: {', '.join(known)}")
    given = {name: value for name, value in options.items() if value is not None}
    question: dict[str, object] = {"inference": options.get("draws", 0) is not None}
    settings = _of_ball_and_air(given)
    for name, value in given.items():
        into = question if name in ("channel", "band_hz", "exclude_s", "include_s") else settings
        into[name] = _plain(name, value)
    return settings, question


def _of_ball_and_air(given: dict[str, object]) -> dict[str, object]:
    """Take ball and air out of the options, as settings."""
    settings: dict[str, object] = {}
    ball, air = given.pop("ball", None), given.pop("air", None)
    if isinstance(ball, Ball):
        known = any(ball.name == preset[0] for preset in _core.balls())
        settings["ball"] = ball.name if known else None
        settings |= {"mass_kg": ball.mass_kg, "diameter_m": ball.diameter_m} if not known else {}
        given.setdefault("contact_time_s", ball.contact_time_s)
    elif ball is not None:
        settings["ball"] = text("ball", ball)
    if isinstance(air, Air):
        settings["air_density_kg_m3"] = air.density_kg_m3
        settings["air_viscosity_pa_s"] = air.viscosity_pa_s
    elif air is not None:
        raise InputError(f"air must be made by bouncelab.air(...), not of {_kind(air)}")
    return settings


_TEXTS = ("drag",)
_LISTS_OF_TEXTS = ("restitution_laws", "infer")
_LISTS_OF_NUMBERS = ("exclude_s", "include_s", "band_hz")
_FLAGS = ("buoyancy", "added_mass", "first_detected")
_COUNTS = ("draws", "seed", "channel")


def _plain(name: str, value: object) -> object:
    """Return an option as plain data."""
    if name in _TEXTS:
        return text(name, value)
    if name in _FLAGS:
        return flag(name, value)
    if name in _COUNTS:
        return count(name, value)
    if name in _LISTS_OF_TEXTS:
        return [text(name, each) for each in _listed(name, value)]
    if name in _LISTS_OF_NUMBERS:
        numbers = [number(name, each) for each in _listed(name, value)]
        if name == "band_hz" and not (len(numbers) == 2 and numbers[0] < numbers[1]):
            raise InputError("band_hz must be two frequencies in Hz, the lower first, as in (400, 6000)")
        return numbers
    if name == "flights":
        ends = [count(name, each) for each in _listed(name, value)]
        if not (len(ends) == 2 and 1 <= ends[0] <= ends[1]):
            raise InputError("flights must be the first and the last, counted from 1, as in (1, 10)")
        return ends
    if name == "reach":
        return [_target(each) for each in _listed(name, value)]
    return number(name, value)


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


def _listed(name: str, value: object) -> list[object]:
    if isinstance(value, str | bytes | Mapping) or not isinstance(value, Iterable):
        raise InputError(f"{name} must be a list, not {_kind(value)}")
    return list(value)


def _kind(value: object) -> str:
    return type(value).__name__
