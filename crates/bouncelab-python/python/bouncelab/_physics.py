"""Formulas, forwards."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from bouncelab import _core
from bouncelab._settings import Air, Ball, number, text

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, slots=True)
class DragLaw:
    """A drag law, and the Reynolds number up to which its authors vouch for it (infinite if there is none)."""

    name: str
    max_reynolds: float


def presets() -> tuple[Ball, ...]:
    """Return the balls whose mass and size the rules of their sport fix.

    Returns
    -------
    tuple of Ball

    Examples
    --------
    >>> import bouncelab as bl
    >>> [ball.name for ball in bl.presets()][:2]
    ['table-tennis-40', 'table-tennis-38']
    """
    return tuple(Ball(*preset) for preset in _core.balls())


def drag_laws() -> tuple[DragLaw, ...]:
    """Return the drag laws; besides there are ``"none"`` and ``"constant:0.4"``.

    Examples
    --------
    >>> import bouncelab as bl
    >>> "morrison" in [law.name for law in bl.drag_laws()]
    True
    """
    return tuple(DragLaw(*law) for law in _core.drag_laws())


def drag_coefficient(reynolds: ArrayLike, law: str = "clift-grace-weber") -> NDArray[np.float64]:
    """Return the drag coefficient of a smooth sphere.

    Parameters
    ----------
    reynolds : array_like
        Reynolds numbers of the diameter, of any shape.
    law : str
        One of :func:`drag_laws`, ``"none"`` or ``"constant:0.4"``.

    Returns
    -------
    numpy.ndarray
        Of the shape of ``reynolds``.

    Raises
    ------
    UnknownNameError
        If there is no such law.
    PhysicsError, OutOfRangeError
        If a Reynolds number lies outside the law.

    Notes
    -----
    ``clift-grace-weber`` is the standard drag curve of Clift, Grace and Weber, *Bubbles, Drops, and
    Particles* (1978), Table 5.2.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.drag_coefficient([1e3, 1e4]).round(3)
    array([0.471, 0.405])
    """
    import numpy as np

    from bouncelab._analyze import as_numbers

    given = np.asarray(reynolds)
    numbers = as_numbers("reynolds", given.ravel())
    return np.frombuffer(_core.drag_coefficient(numbers, text("law", law))).reshape(given.shape)


def air(temperature_k: float = 293.15, pressure_pa: float = 101_325.0, relative_humidity: float = 0.5) -> Air:
    """Return moist air (CIPM-2007 for the density).

    Parameters
    ----------
    temperature_k : float
        Temperature in K.
    pressure_pa : float
        Pressure in Pa.
    relative_humidity : float
        Relative humidity, 0 to 1.

    Returns
    -------
    Air
        For ``air=`` of :func:`analyze`, which then takes its density as measured.

    Raises
    ------
    OutOfRangeError
        If there is no such air.

    Examples
    --------
    >>> import bouncelab as bl
    >>> round(bl.air(293.15).density_kg_m3, 3)
    1.199
    """
    weather = (
        number("temperature_k", temperature_k),
        number("pressure_pa", pressure_pa),
        number("relative_humidity", relative_humidity),
    )
    return Air(*_core.air(*weather))


def gravity_m_s2(latitude_deg: float, altitude_m: float = 0.0) -> float:
    """Return the acceleration of gravity at a place on the Earth.

    Parameters
    ----------
    latitude_deg : float
        Latitude in degrees, north positive.
    altitude_m : float
        Height above the sea in m.

    Returns
    -------
    float
        Gravity in m/s².

    Raises
    ------
    OutOfRangeError
        If there is no such place.

    Examples
    --------
    >>> import bouncelab as bl
    >>> round(bl.gravity_m_s2(47.5, 500.0), 4)
    9.8069
    """
    return _core.gravity_m_s2(number("latitude_deg", latitude_deg), number("altitude_m", altitude_m))


def languages() -> tuple[str, ...]:
    """Return the languages of sentences and figures.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.languages()
    ('de', 'en')
    """
    return tuple(_core.languages())


def diagnostic_codes() -> tuple[str, ...]:
    """Return the codes that diagnostics and exceptions can have.

    Examples
    --------
    >>> import bouncelab as bl
    >>> "clipped" in bl.diagnostic_codes()
    True
    """
    return tuple(_core.code_names())
