"""Formulas, forwards."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Unpack, overload

from bouncelab import _core
from bouncelab._analyze import as_numbers
from bouncelab._errors import InputError
from bouncelab._settings import Air, Ball, Drag, PhysicsOptions, analyzer, drag_law, number
from bouncelab._table import Table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, slots=True)
class RestitutionLaw:
    """A restitution law.

    Attributes
    ----------
    name : str
        As in ``restitution_laws=`` of :func:`analyze`.
    example : str
        A law of this kind, as in ``restitution=`` of :func:`simulate`.
    meaning : str
        Its restitution at the impact speed v in m/s.

    Examples
    --------
    >>> import bouncelab as bl
    >>> {law.example: law.meaning for law in bl.restitution_laws()}["linear:0.96,0.01"]
    '0.96 - 0.01 v'
    """

    name: str
    example: str
    meaning: str


def presets() -> tuple[Ball, ...]:
    """Return the balls that can be stated by name: those whose mass and size rules fix, and usual solid ones.

    Returns
    -------
    tuple of Ball
        Each with the source of its numbers.

    Examples
    --------
    >>> import bouncelab as bl
    >>> [ball.name for ball in bl.presets()][:2]
    ['table-tennis-40', 'table-tennis-38']
    """
    return tuple(Ball(*preset) for preset in _core.balls())


def drag_laws() -> tuple[str, ...]:
    """Return how each drag law is written, with an example of its numbers.

    Returns
    -------
    tuple of str
        As for ``drag=`` of :func:`analyze`. The first is the usual one; points of a table are Reynolds number and
        drag coefficient.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.drag_laws()
    ('standard', 'none', 'constant:0.4', 'table:10000=0.64,100000=0.58')
    """
    return tuple(_core.drag_laws())


def restitution_laws() -> tuple[RestitutionLaw, ...]:
    """Return the restitution laws that drops can be simulated with and that the inference can compare.

    Returns
    -------
    tuple of RestitutionLaw
        Each with an example.

    Examples
    --------
    >>> import bouncelab as bl
    >>> example = bl.restitution_laws()[0].example
    >>> float(bl.simulate(restitution=example, bounces=3).bounces["restitution"][0])
    0.9
    """
    return tuple(RestitutionLaw(*law) for law in _core.restitution_laws())


def drag_coefficient(reynolds: ArrayLike, law: Drag = "standard") -> NDArray[np.float64]:
    """Return the drag coefficient of a law.

    Parameters
    ----------
    reynolds : array_like of float
        Reynolds numbers of the diameter, of any shape.
    law : str, mapping, list of pairs, array or function
        As ``drag=`` of :func:`analyze`.

    Returns
    -------
    numpy.ndarray of float64
        Of the shape of ``reynolds``.

    Raises
    ------
    UnknownNameError
        If there is no such law.
    PhysicsError, OutOfRangeError
        If a Reynolds number is negative or beyond the last point of a table.

    Notes
    -----
    ``standard`` is the drag curve of a smooth sphere of Clift, Grace and Weber, *Bubbles, Drops, and
    Particles* (1978), Table 5.2. Between two points of a table the coefficient is a power of the Reynolds number.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.drag_coefficient([1e3, 1e4]).round(3)
    array([0.471, 0.405])
    """
    [numbers], shape = _broadcast(reynolds=reynolds)
    return _shaped(_core.drag_coefficient(numbers, drag_law(law)), shape)


def air(temperature_k: float = 293.15, pressure_pa: float = 101_325.0, relative_humidity: float = 0.5) -> Air:
    """Return moist air.

    Parameters
    ----------
    temperature_k : float
        Temperature in K, 250 to 330.
    pressure_pa : float
        Pressure in Pa, 30,000 to 120,000.
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

    See Also
    --------
    air_density_kg_m3, air_viscosity_pa_s : The same for arrays.

    Notes
    -----
    The density is that of CIPM-2007 (Picard, Davis, Gläser and Fujii 2008, Metrologia 45, 149), the viscosity
    that of Sutherland's formula for dry air.

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
    density, viscosity = _core.air([weather])
    return Air(float(_shaped(density, ())), float(_shaped(viscosity, ())))


def air_density_kg_m3(
    temperature_k: ArrayLike = 293.15, pressure_pa: ArrayLike = 101_325.0, relative_humidity: ArrayLike = 0.5
) -> NDArray[np.float64]:
    """Return the density of moist air.

    Parameters
    ----------
    temperature_k : array_like of float
        Temperatures in K, 250 to 330.
    pressure_pa : array_like of float
        Pressures in Pa, 30,000 to 120,000.
    relative_humidity : array_like of float
        Relative humidities, 0 to 1.

    Returns
    -------
    numpy.ndarray of float64
        Densities in kg/m³, of the shape to which the arguments broadcast.

    Raises
    ------
    InputError
        If the shapes do not broadcast.
    OutOfRangeError
        If there is no such air.

    Notes
    -----
    CIPM-2007: Picard, Davis, Gläser and Fujii 2008, Metrologia 45, 149.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.air_density_kg_m3([283.15, 293.15, 303.15]).round(3)
    array([1.244, 1.199, 1.156])
    """
    return _moist(temperature_k, pressure_pa, relative_humidity)[0]


def air_viscosity_pa_s(temperature_k: ArrayLike = 293.15) -> NDArray[np.float64]:
    """Return the dynamic viscosity of air.

    Parameters
    ----------
    temperature_k : array_like of float
        Temperatures in K, 250 to 330, of any shape.

    Returns
    -------
    numpy.ndarray of float64
        Viscosities in Pa s, of the shape of ``temperature_k``.

    Raises
    ------
    OutOfRangeError
        If there is no such air.

    Notes
    -----
    Sutherland's formula for dry air; humidity and pressure change it by less than 1 %.

    Examples
    --------
    >>> import bouncelab as bl
    >>> (bl.air_viscosity_pa_s([273.15, 293.15]) * 1e6).round(1)
    array([17.2, 18.1])
    """
    return _moist(temperature_k, 101_325.0, 0.0)[1]


@overload
def gravity_m_s2(latitude_deg: float, altitude_m: float = 0.0) -> float: ...
@overload
def gravity_m_s2(latitude_deg: ArrayLike, altitude_m: ArrayLike = 0.0) -> float | NDArray[np.float64]: ...
def gravity_m_s2(latitude_deg: ArrayLike, altitude_m: ArrayLike = 0.0) -> float | NDArray[np.float64]:
    """Return the acceleration of gravity at a place on the Earth.

    Parameters
    ----------
    latitude_deg : float or array_like of float
        Latitude in degrees, north positive.
    altitude_m : float or array_like of float
        Height above the sea in m, -1000 to 10,000.

    Returns
    -------
    float or numpy.ndarray of float64
        Gravity in m/s²: an array of the shape to which arrays broadcast.

    Raises
    ------
    InputError
        If the shapes do not broadcast.
    OutOfRangeError
        If there is no such place.

    Notes
    -----
    Normal gravity of the WGS 84 ellipsoid, less the free-air gradient.

    Examples
    --------
    >>> import bouncelab as bl
    >>> round(bl.gravity_m_s2(47.5, 500.0), 4)
    9.8069
    >>> bl.gravity_m_s2([0.0, 45.0, 90.0]).round(4)
    array([9.7803, 9.8062, 9.8322])
    """
    (latitudes, altitudes), shape = _broadcast(latitude_deg=latitude_deg, altitude_m=altitude_m)
    found = _shaped(_core.gravity_m_s2(list(zip(latitudes, altitudes, strict=True))), shape)
    return found if shape else float(found)


def flights(
    launch_speed_m_s: ArrayLike | None = None,
    *,
    flight_time_s: ArrayLike | None = None,
    apex_m: ArrayLike | None = None,
    **settings: Unpack[PhysicsOptions],
) -> Table:
    """Return flights of a ball from one impact to the next, by one quantity of each.

    Parameters
    ----------
    launch_speed_m_s : float or array_like of float, shape (flights,)
        Speeds after the impact that starts the flight, in m/s.
    flight_time_s : float or array_like of float, shape (flights,)
        In place of these, times between the impacts, in s.
    apex_m : float or array_like of float, shape (flights,)
        In place of these, greatest heights, in m.
    **settings
        Ball, air, drag and gravity, as of :func:`analyze`.

    Returns
    -------
    Table
        A row for each: ``launch_speed_m_s``, ``impact_speed_m_s``, ``apex_m``, ``rise_time_s``, ``fall_time_s``
        and ``flight_time_s``.

    Raises
    ------
    InputError
        If not exactly one quantity is given, or it is no list of numbers.
    OutOfRangeError, UnknownNameError, PhysicsError
        If there is no such flight, ball or drag law.

    Notes
    -----
    Nagurka 2003, Eqs. 11 to 17, where the drag coefficient is constant; else quadrature to 1e-11.

    Examples
    --------
    >>> import bouncelab as bl
    >>> with_air = bl.flights(flight_time_s=[0.2, 0.4], ball="table-tennis-40")
    >>> with_air["apex_m"].round(4)
    array([0.0479, 0.1918])
    >>> bl.flights([1.0, 2.0], drag="none", gravity_m_s2=9.81)["apex_m"].round(4)
    array([0.051 , 0.2039])
    """
    stated = {"launch_speed_m_s": launch_speed_m_s, "flight_time_s": flight_time_s, "apex_m": apex_m}
    given = {name: values for name, values in stated.items() if values is not None}
    if len(given) != 1:
        raise InputError(f"give one of {', '.join(stated)}; it determines the others")
    [(name, values)] = given.items()
    return Table(_core.flights(analyzer(**settings), name, as_numbers(name, values, single=True)))


def falls(height_m: ArrayLike, **settings: Unpack[PhysicsOptions]) -> Table:
    """Return falls of a ball from rest to the surface.

    Parameters
    ----------
    height_m : float or array_like of float, shape (falls,)
        Heights of the lowest point of the ball above the surface, in m.
    **settings
        Ball, air, drag and gravity, as of :func:`analyze`.

    Returns
    -------
    Table
        A row for each: ``height_m``, ``fall_time_s`` and ``impact_speed_m_s``.

    Raises
    ------
    InputError
        If the heights are no list of numbers.
    OutOfRangeError, UnknownNameError, PhysicsError
        If there is no such fall, ball or drag law.

    Notes
    -----
    As of :func:`flights`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.falls([0.1, 0.305], drag="none", gravity_m_s2=9.81)["impact_speed_m_s"].round(3)
    array([1.401, 2.446])
    """
    return Table(_core.falls(analyzer(**settings), as_numbers("height_m", height_m, single=True)))


def terminal_speed_m_s(**settings: Unpack[PhysicsOptions]) -> float:
    """Return the speed at which the drag carries the weight.

    Parameters
    ----------
    **settings
        Ball, air, drag and gravity, as of :func:`analyze`.

    Returns
    -------
    float
        Terminal speed in m/s; infinite without drag, and where a drag table ends below it.

    Raises
    ------
    InputError, OutOfRangeError, UnknownNameError, PhysicsError
        If there is no such ball, air or drag law.

    Examples
    --------
    >>> import bouncelab as bl
    >>> round(bl.terminal_speed_m_s(ball="table-tennis-40"), 1)
    8.8
    >>> bl.terminal_speed_m_s(drag="none")
    inf
    """
    speed = _core.terminal_speed_m_s(analyzer(**settings))
    return float("inf") if speed is None else speed


def languages() -> tuple[str, ...]:
    """Return the languages of sentences and figures.

    Returns
    -------
    tuple of str
        As in ``language=`` of figures, reports, documents and messages.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.languages()
    ('de', 'en', 'es', 'fr')
    """
    return tuple(_core.languages())


def diagnostic_codes() -> tuple[str, ...]:
    """Return the codes that diagnostics and exceptions can have.

    Returns
    -------
    tuple of str
        Stable names; ``docs/diagnostics.md`` of the project explains them.

    Examples
    --------
    >>> import bouncelab as bl
    >>> "clipped" in bl.diagnostic_codes()
    True
    """
    return tuple(_core.code_names())


def _moist(*conditions: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return density and viscosity of air of temperatures, pressures and humidities."""
    names = ("temperature_k", "pressure_pa", "relative_humidity")
    (temperatures, pressures, humidities), shape = _broadcast(**dict(zip(names, conditions, strict=True)))
    density, viscosity = _core.air(list(zip(temperatures, pressures, humidities, strict=True)))
    return _shaped(density, shape), _shaped(viscosity, shape)


def _broadcast(**given: ArrayLike) -> tuple[list[list[float]], tuple[int, ...]]:
    """Return arrays as lists of equal length, and their common shape."""
    import numpy as np

    numbers = {name: as_numbers(name, values, flat=True) for name, values in given.items()}
    try:
        together = np.broadcast_arrays(
            *(np.reshape(numbers[name], np.shape(values)) for name, values in given.items())
        )
    except ValueError:
        raise InputError(f"the shapes of {' and '.join(given)} do not broadcast; make them equal") from None
    return [array.ravel().tolist() for array in together], together[0].shape


def _shaped(numbers: bytes, shape: tuple[int, ...]) -> NDArray[np.float64]:
    import numpy as np

    return np.frombuffer(numbers).reshape(shape)
