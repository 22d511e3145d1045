"""From ball, air and surface to a drop and its sound."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from os import PathLike, fspath
from typing import TYPE_CHECKING, Unpack, overload

from bouncelab import _core
from bouncelab._analyze import as_numbers
from bouncelab._data import JSON
from bouncelab._errors import InputError
from bouncelab._figure import Figure, figure
from bouncelab._report import Documented
from bouncelab._settings import SimulationOptions, analyzer, count, number, text
from bouncelab._table import Table

if TYPE_CHECKING:
    from collections.abc import Sequence

    from typing import TypeAlias

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    #: A law of the impact speed, a constant, or the restitution of each impact.
    Law: TypeAlias = float | str | Sequence[float] | NDArray[np.floating]


class Simulation(Documented):
    """A simulated drop.

    It comes from :func:`bouncelab.simulate`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.simulate(height_m=0.305, restitution=0.9, bounces=5)
    >>> drop.bounces["apex_m"].round(3)
    array([0.233, 0.181, 0.141, 0.111, 0.088])
    >>> drop.figures
    ('height', 'flight-times')
    """

    def __init__(self, core: _core.Simulation) -> None:
        self._core = core

    @cached_property
    def _run(self) -> dict[str, JSON]:
        run: dict[str, JSON] = json.loads(self._core.document("en"))["simulations"][0]
        return run

    def _number(self, name: str) -> float:
        value = self._run[name]
        assert isinstance(value, int | float)
        return float(value)

    @cached_property
    def bounces(self) -> Table:
        """The bounces, one row for each: the impact and the flight after it."""
        return Table(self._core.bounces())

    @property
    def terminal_speed_m_s(self) -> float | None:
        """Terminal speed in m/s; ``None`` without drag."""
        return None if self._run["terminal_speed_m_s"] is None else self._number("terminal_speed_m_s")

    @property
    def contact_time_s(self) -> float:
        """How long each impact takes, in s: as stated, or usual for the ball."""
        settings = json.loads(self._core.document("en"))["settings"]
        return float(settings["ball"]["contact_time_s"])

    @property
    def total_time_s(self) -> float:
        """Time from the release to the end, in s."""
        return self._number("total_time_s")

    @property
    def total_path_m(self) -> float:
        """Length of the path from the release to the end, in m."""
        return self._number("total_path_m")

    @property
    def initial_energy_j(self) -> float:
        """Energy at the release, in J."""
        return self._number("initial_energy_j")

    @property
    def lost_to_surface_j(self) -> float:
        """Energy that all impacts took, in J."""
        return self._number("lost_to_surface_j")

    @property
    def lost_to_air_j(self) -> float:
        """Energy that the air took, in J."""
        return self._number("lost_to_air_j")

    def height_m(self, times_s: ArrayLike) -> NDArray[np.float64]:
        """Return the height of the lowest point of the ball.

        Parameters
        ----------
        times_s : array_like
            Times after the release in s, of any shape.

        Returns
        -------
        numpy.ndarray
            Heights in m, of the shape of ``times_s``.
        """
        import numpy as np

        heights = self._core.height_m(as_numbers("times_s", times_s, flat=True))
        return np.frombuffer(heights).reshape(np.shape(times_s))

    @property
    def figures(self) -> tuple[str, ...]:
        """Names of its figures."""
        return ("height", "flight-times")

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
        return self._core.figure(name, language)

    def _inputs(self) -> list[str]:
        return []

    def _document_in(self, language: str) -> str:
        return self._core.document(language)

    def __reduce__(self) -> tuple[type[Simulation], tuple[_core.Simulation]]:
        return (Simulation, (self._core,))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Simulation) and self.to_dict() == other.to_dict()

    def __repr__(self) -> str:
        return f"<bouncelab.Simulation: {len(self.bounces)} bounces in {self.total_time_s:.3f} s>"


@dataclass(frozen=True, eq=False)
class Sound:
    """A synthesised recording, and the truth about it.

    Attributes
    ----------
    samples : numpy.ndarray of float32, shape (frames,)
        The samples, 1 being full scale.
    sample_rate_hz : int
        Samples a second.
    impacts : Table
        The true impacts: time, speed, level above the noise, and whether each was left out.
    simulation : Simulation
        The drop.

    Examples
    --------
    >>> import bouncelab as bl
    >>> sound = bl.synthesize(height_m=0.2, restitution=0.8, bounces=6, seed=3)
    >>> sound.samples.dtype, sound.sample_rate_hz, len(sound.impacts)
    (dtype('float32'), 44100, 7)
    """

    samples: NDArray[np.float32]
    sample_rate_hz: int
    impacts: Table
    simulation: Simulation

    def save(self, path: str | PathLike[str], *, force: bool = False) -> None:
        """Save it as WAV, 16 bits a sample.

        Parameters
        ----------
        path : str or path-like
            Where to; a name that ends in ``.wav``.
        force : bool
            Whether it may replace another file of this name. One with the same content is left as it is.

        Raises
        ------
        InputError
            If the name ends in something else.
        OutputError
            If the file cannot be written, or is there already.
        """
        file = text("path", fspath(path))
        if not file.lower().endswith((".wav", ".wave")):
            raise InputError(f"{file}: a sound is saved as WAV; end the name in .wav")
        _core.write_wav(file, self.samples[:, None], self.sample_rate_hz, bool(force))

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Sound)
            and self.sample_rate_hz == other.sample_rate_hz
            and self.impacts == other.impacts
            and self.simulation == other.simulation
            and self.samples.tobytes() == other.samples.tobytes()
        )

    def __repr__(self) -> str:
        seconds = len(self.samples) / self.sample_rate_hz
        return f"<bouncelab.Sound: {seconds:.3f} s with {len(self.impacts)} impacts>"


@overload
def simulate(
    *,
    height_m: float = 0.305,
    launch_speed_m_s: float | None = None,
    restitution: Law = 0.935,
    scatter: float = 0.0,
    seed: int = 1,
    until_m: float | None = None,
    bounces: int | None = None,
    **settings: Unpack[SimulationOptions],
) -> Simulation: ...
@overload
def simulate(
    *,
    height_m: Sequence[float] | NDArray[np.floating],
    launch_speed_m_s: float | None = None,
    restitution: Law = 0.935,
    scatter: float = 0.0,
    seed: int = 1,
    until_m: float | None = None,
    bounces: int | None = None,
    **settings: Unpack[SimulationOptions],
) -> tuple[Simulation, ...]: ...
def simulate(
    *,
    height_m: float | Sequence[float] | NDArray[np.floating] = 0.305,
    launch_speed_m_s: float | None = None,
    restitution: Law = 0.935,
    scatter: float = 0.0,
    seed: int = 1,
    until_m: float | None = None,
    bounces: int | None = None,
    **settings: Unpack[SimulationOptions],
) -> Simulation | tuple[Simulation, ...]:
    """Simulate a drop, or one from each of several heights.

    Parameters
    ----------
    height_m : float, or list or array of float
        Height of the release, surface to lowest point of the ball, in m.
    launch_speed_m_s : float, optional
        Start upwards from the surface instead, at this speed in m/s.
    restitution : float or str, or list or array of float
        Coefficient of restitution, 0 to 1, or a law of the impact speed, such as ``"linear:0.95,0.01"``;
        :func:`restitution_laws` has an example of each. A list has the restitution of each impact, and the drop ends with it.
        ``"prior"`` draws all that is unknown before the data: the law over speeds from a quarter of that of the first
        impact, scatter, ball, air, drag, gravity and contact time, as ``restitution_laws``, ``restitution_prior`` and ``known``
        of :func:`analyze` have them.
    scatter : float
        Standard deviation of the logarithm of the restitution from impact to impact, normal; a draw of the prior has its own.
    seed : int
        Seed of the scatter, and of a draw of the prior.
    until_m : float, optional
        Stop when the ball rises no higher; 1 mm, unless ``bounces`` is given.
    bounces : int, optional
        Stop after this number of bounces.
    **settings
        Ball, air, drag and gravity, and what is known of them, as of :func:`analyze`.

    Returns
    -------
    Simulation or tuple of Simulation
        One for each of several heights.

    Raises
    ------
    InputError, OutOfRangeError, UnknownNameError, PhysicsError
        If an argument makes no sense.

    Notes
    -----
    Quadratic drag with a coefficient that follows the Reynolds number, buoyancy and added mass; the
    formulas are in the documentation of the crate ``bouncelab``, module ``flight``. Each impact takes the contact time of
    the ball, :attr:`Simulation.contact_time_s`, during which it rests on the surface: the bounces begin later by the sum.

    Examples
    --------
    >>> import bouncelab as bl
    >>> with_air, without = bl.simulate(bounces=3), bl.simulate(bounces=3, drag="none")
    >>> with_air.total_time_s < without.total_time_s
    True
    """
    heights_m = as_numbers("height_m", height_m, single=True)
    law, most = _law(restitution), None if bounces is None else count("bounces", bounces)
    if isinstance(law, list):
        most = min(len(law) if most is None else most, len(law))
    request = {
        "launch_speed_m_s": _optional("launch_speed_m_s", launch_speed_m_s),
        "restitution": law,
        "scatter": _spread(scatter),
        "seed": count("seed", seed),
        "until_m": _optional("until_m", until_m),
        "bounces": most,
    }
    resolved = analyzer(**settings)
    runs = [_core.Simulation(resolved, json.dumps(request | {"height_m": height})) for height in heights_m]
    return tuple(map(Simulation, runs)) if hasattr(height_m, "__len__") else Simulation(runs[0])


def synthesize(
    *,
    sample_rate_hz: int = 44_100,
    seed: int = 1,
    voice: str = "table-tennis",
    snr_db: float | None = 40.0,
    noise: str = "pink",
    hum_hz: float | None = None,
    reverb_s: float | None = None,
    clicks_per_s: float | None = None,
    lost: float | None = None,
    clip_at: float | None = None,
    lead_in_s: float = 0.5,
    tail_s: float = 0.5,
    height_m: float = 0.305,
    launch_speed_m_s: float | None = None,
    restitution: Law = 0.935,
    scatter: float = 0.0,
    until_m: float | None = None,
    bounces: int | None = None,
    **settings: Unpack[SimulationOptions],
) -> Sound:
    """Synthesise the sound of a drop, whose truth is known.

    Parameters
    ----------
    sample_rate_hz : int
        Samples a second.
    seed : int
        Seed of everything random: the same seed gives the same samples.
    voice : str
        What an impact sounds like: table-tennis, steel-ball, basketball or tennis.
    snr_db : float or None
        How far the first impact stands above the noise, in dB; ``None`` is no noise.
    noise : str
        ``"pink"`` or ``"white"``.
    hum_hz, reverb_s, clicks_per_s, lost, clip_at : float, optional
        Mains hum of a frequency; reverberation time; clicks that are no impact, in clicks per second; share of
        the impacts that is left out; level at which the sound is cut off.
    lead_in_s, tail_s : float
        Time before the release, and after the last impact.
    height_m, launch_speed_m_s : float
        As of :func:`simulate`.
    restitution : float or str, or list or array of float
        As of :func:`simulate`.
    scatter : float
        As of :func:`simulate`; the seed is the same.
    until_m : float, optional
        As of :func:`simulate`.
    bounces : int, optional
        As of :func:`simulate`.
    **settings
        Ball, air, drag and gravity, as of :func:`analyze`.

    Returns
    -------
    Sound

    Raises
    ------
    InputError, OutOfRangeError, UnknownNameError, PhysicsError
        If an argument makes no sense.

    Examples
    --------
    >>> import bouncelab as bl
    >>> quiet = bl.synthesize(snr_db=None, bounces=3)
    >>> float(abs(quiet.samples[:1000]).max())
    0.0
    """
    simulation = simulate(
        height_m=height_m,
        launch_speed_m_s=launch_speed_m_s,
        restitution=restitution,
        scatter=scatter,
        seed=seed,
        until_m=until_m,
        bounces=bounces,
        **settings,
    )
    scene = {
        "sample_rate_hz": count("sample_rate_hz", sample_rate_hz),
        "seed": count("seed", seed),
        "voice": text("voice", voice),
        "snr_db": _optional("snr_db", snr_db),
        "noise": text("noise", noise),
        "hum_hz": _optional("hum_hz", hum_hz),
        "reverb_s": _optional("reverb_s", reverb_s),
        "clicks_per_s": _optional("clicks_per_s", clicks_per_s),
        "lost": _optional("lost", lost),
        "clip_at": _optional("clip_at", clip_at),
        "lead_in_s": number("lead_in_s", lead_in_s),
        "tail_s": number("tail_s", tail_s),
    }
    import numpy as np

    samples, impacts = simulation._core.sound(json.dumps(scene))
    return Sound(np.frombuffer(samples, dtype=np.float32), int(sample_rate_hz), Table(impacts), simulation)


def _law(restitution: object) -> str | list[float] | None:
    """Return a restitution as the text of a law, as that of each impact, or as ``None`` for a draw of the prior."""
    if isinstance(restitution, str):
        return None if restitution == "prior" else restitution
    if not hasattr(restitution, "__len__"):
        return repr(number("restitution", restitution))
    each = as_numbers("restitution", restitution)
    if not each or not all(0.0 < kept <= 1.0 for kept in each):
        raise InputError("the restitutions of impacts must be above 0 and not above 1, and at least one")
    return each


def _spread(scatter: object) -> float:
    spread = number("scatter", scatter)
    if spread < 0.0:
        raise InputError(f"scatter is {spread:g}; it must not be below 0")
    return spread


def _optional(name: str, value: object) -> float | None:
    return None if value is None else number(name, value)
