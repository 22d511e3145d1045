"""The likelihood of impact times, for models of a researcher's own."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, Unpack

from bouncelab import _core
from bouncelab._analyze import as_numbers
from bouncelab._errors import InputError
from bouncelab._recording import Recording
from bouncelab._settings import Air, Drag, PhysicsOptions, analyzer
from bouncelab._table import Table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Floats: TypeAlias = NDArray[np.float64]
    #: The restitution of each impact but the last, or a law of the impact speed in m/s.
    Restitution: TypeAlias = ArrayLike | Callable[[Floats], Floats]

#: Number of nodes in the logarithms of speed and of drag; a test holds the times against those of simulations.
NODES = (129, 9)

#: Factors on the drag coefficient that the flights cover.
DRAG_SCALES = (0.4, 2.5)


class Gradient(NamedTuple):
    """Derivatives of a logarithm of the likelihood; the axes before the last are those of the parameters.

    Attributes
    ----------
    restitution : numpy.ndarray of float64
        By the restitution of each impact but the last.
    height_m : numpy.ndarray of float64
        By the drop height, 1/m.
    drag_scale : numpy.ndarray of float64
        By the factor on the drag coefficient.
    contact_time_s : numpy.ndarray of float64
        By the contact time, 1/s.

    Examples
    --------
    >>> import bouncelab as bl
    >>> likelihood = bl.LogLikelihood([0.0, 0.4605, 0.8877, 1.2854], 1e-4, ball="table-tennis-40")
    >>> likelihood.with_gradient([0.93, 0.93, 0.93], 0.305)[1].restitution.shape
    (3,)
    """

    restitution: Floats
    height_m: Floats
    drag_scale: Floats
    contact_time_s: Floats


class LogLikelihood:
    """Logarithm of the likelihood of the impact times of a drop, vectorised over parameters.

    The ball falls from a height, each impact keeps a share of its speed, and each flight is that of the ball in air; the
    measured times have independent normal errors, and nothing is known of the time of the first impact. What restitution is
    (a law, its scatter, a prior) is left to the model that a sampler such as emcee, PyMC or NumPyro samples.

    Parameters
    ----------
    times_s : array_like of float, shape (impacts,)
        Times of successive impacts in s, in order, none of them missed.
    sigma_s : float or array_like of float, shape (impacts,)
        Their standard errors in s.
    **settings
        Ball, air, drag and gravity, as of :func:`analyze`.

    Raises
    ------
    InputError, OutOfRangeError, UnknownNameError, PhysicsError
        If an argument makes no sense.

    Notes
    -----
    With residuals r and weights w = 1/σ², and the time of the first impact integrated over a flat density of 1/s,
    ln L = -½ Σ w (r - r̄)² - ½ Σ ln 2πσ² + ½ ln(2π/Σw). Flights and falls are interpolated between those of
    :func:`flights` and :func:`falls`; buoyancy and added mass of the air are contained
    exactly, as the mass and the gravity of a ball without them. The drag scale may be 0.4 to 2.5.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.simulate(height_m=0.305, restitution=0.93, bounces=8, ball="table-tennis-40")
    >>> likelihood = bl.LogLikelihood(drop.bounces["time_s"], 1e-4, ball="table-tennis-40")
    >>> true, false = likelihood([[0.93] * 7, [0.92] * 7], 0.305)
    >>> bool(true > false)
    True
    >>> law = likelihood(lambda v_m_s: 0.95 - 0.01 * v_m_s, [0.30, 0.31])
    >>> law.shape
    (2,)
    """

    def __init__(self, times_s: ArrayLike, sigma_s: ArrayLike, **settings: Unpack[PhysicsOptions]) -> None:
        import numpy as np

        times = as_numbers("times_s", times_s)
        sigmas = as_numbers("sigma_s", sigma_s, single=True)
        if len(times) < 2 or any(later <= earlier for earlier, later in zip(times, times[1:], strict=False)):
            raise InputError("times_s must be at least two times that increase")
        if len(sigmas) not in (1, len(times)) or min(sigmas) <= 0.0:
            raise InputError("sigma_s must be one standard error above 0, or one for each time")
        self._times_s = np.array(times)
        self._sigma_s = np.broadcast_to(np.array(sigmas), self._times_s.shape)
        used = _Used.of(settings)
        self.contact_time_s: float = used.contact_time_s
        longest_s = float(np.diff(self._times_s).max())
        fastest = 0.5 * used.gravity_m_s2 * longest_s
        # From rest to what the first fall may have been.
        slowest = 0.2 * used.gravity_m_s2 * float(np.diff(self._times_s).min())
        speeds = (slowest, 3.0 * fastest)
        heights_m = (0.5 * slowest**2 / used.gravity_m_s2, 0.5 * speeds[1] ** 2 / used.gravity_m_s2)
        self._flight = _Surface(speeds, used.flights)
        self._fall = _Surface(heights_m, used.falls)

    def __call__(
        self,
        restitution: Restitution,
        height_m: ArrayLike,
        drag_scale: ArrayLike = 1.0,
        contact_time_s: ArrayLike | None = None,
    ) -> Floats:
        """Return the logarithm of the likelihood.

        Parameters
        ----------
        restitution : array_like of float, shape (..., impacts - 1), or callable
            The restitution of each impact but the last, or a function that returns the restitutions at impact speeds in m/s,
            an array of the shape of the other parameters.
        height_m : array_like of float, shape (...)
            Drop heights in m.
        drag_scale : array_like of float, shape (...)
            Factors on the drag coefficient.
        contact_time_s : array_like of float, shape (...), optional
            Contact times in s; that of the ball if left out.

        Returns
        -------
        numpy.ndarray of float64
            Of the shape to which the parameters broadcast; minus infinity where no ball moves like that.
        """
        return self._chain(restitution, height_m, drag_scale, contact_time_s, derivatives=False).value

    def with_gradient(
        self,
        restitution: ArrayLike,
        height_m: ArrayLike,
        drag_scale: ArrayLike = 1.0,
        contact_time_s: ArrayLike | None = None,
    ) -> tuple[Floats, Gradient]:
        """Return the logarithm of the likelihood and its derivatives by the parameters.

        Parameters
        ----------
        restitution : array_like of float, shape (..., impacts - 1)
            The restitution of each impact but the last.
        height_m, drag_scale, contact_time_s : array_like of float, shape (...)
            As of a call.

        Returns
        -------
        tuple of numpy.ndarray of float64 and Gradient
            Not a number where the likelihood is zero.
        """
        import numpy as np

        if callable(restitution):
            raise InputError("a gradient takes the restitution of each impact; apply the chain rule to that of a law")
        found = self._chain(restitution, height_m, drag_scale, contact_time_s, derivatives=True)
        # Backwards: `later` is the derivative by the times of all impacts after a flight, and `speed` by the logarithm of the
        # speed at its end; each surface has its value and the derivatives by the logarithms of its argument and of drag.
        zero = np.zeros(found.value.shape)
        later, speed, log_drag, contact, restitutions = zero, zero, zero, zero, []
        for place in reversed(range(len(found.kept))):
            (time, time_by_launch, time_by_drag), (_, end_by_launch, end_by_drag) = found.flights[place]
            later = later + found.pull[..., place + 1]
            contact = contact + later
            log_drag = log_drag + later * time * time_by_drag + speed * end_by_drag
            # The launch speed is the restitution times the impact speed, so its logarithm is a sum.
            speed = later * time * time_by_launch + speed * end_by_launch
            restitutions.append(speed / found.kept[place])
        _, fall_by_height, fall_by_drag = found.fall
        height = speed * fall_by_height / found.height_m
        log_drag = log_drag + speed * fall_by_drag
        return found.value, Gradient(np.stack(restitutions[::-1], axis=-1), height, log_drag / found.drag_scale, contact)

    def _chain(
        self,
        restitution: Restitution,
        height_m: ArrayLike,
        drag_scale: ArrayLike,
        contact_time_s: ArrayLike | None,
        *,
        derivatives: bool,
    ) -> _Chain:
        """Let the ball bounce, with all parameters at once."""
        import numpy as np

        given = [np.asarray(it, dtype=np.float64) for it in (height_m, drag_scale)]
        given.append(np.asarray(self.contact_time_s if contact_time_s is None else contact_time_s, dtype=np.float64))
        law = restitution if callable(restitution) else None
        each = None if law is not None else np.asarray(restitution, dtype=np.float64)
        flights = len(self._times_s) - 1
        if each is not None:
            if each.ndim == 0 or each.shape[-1] != flights:
                raise InputError(f"there are {flights} restitutions, one for each impact but the last, not {each.shape}")
            given.append(each[..., 0])
        try:
            height, scale, contact, *_ = np.broadcast_arrays(*given)
        except ValueError:
            raise InputError("the shapes of the parameters do not broadcast; make them equal") from None
        with np.errstate(all="ignore"):
            drag = np.log(scale)
            fall, flight = self._fall.at(drag), self._flight.at(drag)
            [first] = fall(np.log(height), derivatives)
            log_speed, time = first[0], np.zeros(height.shape)
            times, kept, passed = [time], [], []
            for place in range(flights):
                keeps = law(np.exp(log_speed)) if law is not None else each[..., place]  # type: ignore[index]
                found = flight(log_speed + np.log(keeps), derivatives)
                duration = np.exp(found[0][0])
                time = time + duration + contact
                times.append(time)
                kept.append(keeps)
                passed.append(((duration, *found[0][1:]), found[1]))
                log_speed = found[1][0]
            weights = 1.0 / self._sigma_s**2
            residuals = self._times_s - np.stack(np.broadcast_arrays(*times), axis=-1)
            mean = (residuals * weights).sum(axis=-1, keepdims=True) / weights.sum()
            pull = weights * (residuals - mean)
            constant = 0.5 * np.log(2.0 * np.pi / weights.sum()) - 0.5 * np.log(2.0 * np.pi * self._sigma_s**2).sum()
            value = constant - 0.5 * (pull * (residuals - mean)).sum(axis=-1)
            value = np.where(np.isnan(value), -np.inf, value)
        return _Chain(value, pull, tuple(kept), tuple(passed), first, height, scale)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LogLikelihood) and self._plain() == other._plain()

    def _plain(self) -> tuple[bytes, ...]:
        return tuple(it.tobytes() for it in (self._times_s, self._sigma_s, self._flight._table, self._fall._table))

    def __repr__(self) -> str:
        return f"<bouncelab.LogLikelihood of {len(self._times_s)} impacts>"


class _Chain(NamedTuple):
    """A likelihood, and what its derivatives take."""

    value: Floats
    #: Derivative by the predicted time of each impact.
    pull: Floats
    kept: tuple[Floats, ...]
    #: Duration, and logarithm of the impact speed, of each flight.
    flights: tuple[tuple[tuple[Floats, ...], tuple[Floats, ...]], ...]
    fall: tuple[Floats, ...]
    height_m: Floats
    drag_scale: Floats


class _Used(NamedTuple):
    """A ball without buoyancy and added mass that flies as a ball with them does.

    With the mass m_a of the displaced air, (m + m_a/2) dv/dt = (m - m_a) g - drag: its mass is m + m_a/2, and its gravity
    (m - m_a) g/(m + m_a/2). A drag that is larger by a factor is that of a ball lighter by this factor.
    """

    mass_kg: float
    diameter_m: float
    gravity_m_s2: float
    contact_time_s: float
    air: Air
    drag: Drag | None

    @classmethod
    def of(cls, settings: PhysicsOptions) -> _Used:
        if settings.get("ball") is None and settings.get("mass_kg") is None:
            raise InputError("a likelihood takes a ball; give ball=, or mass_kg= and diameter_m=")
        used = Recording(analyzer(**settings).times([0.0, 1.0], "times")).settings
        displaced_kg = used.air.density_kg_m3 * math.pi / 6.0 * used.ball.diameter_m**3
        moving_kg = used.ball.mass_kg + 0.5 * displaced_kg * used.air.added_mass
        carried_kg = used.ball.mass_kg - displaced_kg * used.air.buoyancy
        gravity_m_s2 = used.gravity.gravity_m_s2 * carried_kg / moving_kg
        air = Air(used.air.density_kg_m3, used.air.viscosity_pa_s)
        return cls(moving_kg, used.ball.diameter_m, gravity_m_s2, used.ball.contact_time_s, air, settings.get("drag"))

    def _analyzer(self, drag_scale: float) -> _core.Analyzer:
        return analyzer(
            mass_kg=self.mass_kg / drag_scale,
            diameter_m=self.diameter_m,
            gravity_m_s2=self.gravity_m_s2,
            air=self.air,
            drag=self.drag,
            buoyancy=False,
            added_mass=False,
            draws=None,
        )

    def flights(self, launch_speeds_m_s: Floats, drag_scale: float) -> list[Floats]:
        """Return logarithms of flight times and impact speeds."""
        import numpy as np

        found = Table(_core.flights(self._analyzer(drag_scale), "launch_speed_m_s", launch_speeds_m_s.tolist()))
        return [np.log(np.asarray(found[name], dtype=np.float64)) for name in ("flight_time_s", "impact_speed_m_s")]

    def falls(self, heights_m: Floats, drag_scale: float) -> list[Floats]:
        """Return logarithms of impact speeds."""
        import numpy as np

        found = Table(_core.falls(self._analyzer(drag_scale), heights_m.tolist()))
        return [np.log(np.asarray(found["impact_speed_m_s"], dtype=np.float64))]


class _Surface:
    """Quantities by the logarithms of an argument and of the factor on drag.

    Cubic between equidistant nodes of the argument, for drag curves have kinks, and Chebyshev polynomials of the drag.
    """

    def __init__(self, ends: tuple[float, float], quantities: Callable[[Floats, float], list[Floats]]) -> None:
        import numpy as np
        from numpy.polynomial import chebyshev

        self._drags = np.log(DRAG_SCALES)
        arguments = np.linspace(math.log(ends[0]), math.log(ends[1]), NODES[0])
        self._first, self._step = float(arguments[0]), float(arguments[1] - arguments[0])
        drags = chebyshev.chebpts1(NODES[1])
        scales = np.exp(0.5 * (self._drags.sum() + drags * np.ptp(self._drags)))
        values = np.array([quantities(np.exp(arguments), scale) for scale in scales.tolist()])
        solved = np.linalg.solve(chebyshev.chebvander(drags, NODES[1] - 1), values.reshape(NODES[1], -1))
        # Axes: argument, coefficient of the drag, quantity.
        self._table = np.moveaxis(solved.reshape(values.shape), 2, 0)

    def at(self, log_drag: Floats) -> Callable[[Floats, bool], list[tuple[Floats, ...]]]:
        """Return what gives each quantity, perhaps with its derivatives by the logarithms of its argument and of drag."""
        import numpy as np
        from numpy.polynomial import chebyshev

        drag = (2.0 * log_drag - self._drags.sum()) / np.ptp(self._drags)
        powers = chebyshev.chebvander(drag, NODES[1] - 1).reshape(*drag.shape, NODES[1])
        powers[np.abs(drag) > 1.0] = np.nan
        # Axes: draw, node, quantity.
        along = [np.tensordot(powers.reshape(-1, NODES[1]), self._table, axes=(1, 1))]
        rows = np.arange(along[0].shape[0])

        def quantities(log_argument: Floats, derivatives: bool) -> list[tuple[Floats, ...]]:
            place = (np.broadcast_to(log_argument, drag.shape).ravel() - self._first) / self._step
            known = np.where((place >= 0.0) & (place <= NODES[0] - 1.0), place, np.nan)
            first = np.nan_to_num(np.clip(np.floor(known) - 1.0, 0.0, NODES[0] - 4.0)).astype(np.intp)
            a = known - first
            b, c, d = a - 1.0, a - 2.0, a - 3.0

            def between(weights: list[Floats], values: Floats) -> Floats:
                near = [weight[:, None] * values[rows, first + node] for node, weight in enumerate(weights)]
                found: Floats = sum(near[1:], near[0]).T.reshape(-1, *drag.shape)
                return found

            # Lagrange polynomials of the nodes 0, 1, 2, 3, and their derivatives.
            weights = [-b * c * d / 6.0, a * c * d / 2.0, -a * b * d / 2.0, a * b * c / 6.0]
            wanted = [between(weights, along[0])]
            if derivatives:
                if len(along) == 1:
                    derived = chebyshev.chebder(np.eye(NODES[1])) * (2.0 / np.ptp(self._drags))
                    slopes = (powers[..., :-1] @ derived).reshape(-1, NODES[1])
                    along.append(np.tensordot(slopes, self._table, axes=(1, 1)))
                rates = [-(b * c + b * d + c * d) / 6.0, (a * c + a * d + c * d) / 2.0]
                rates += [-(a * b + a * d + b * d) / 2.0, (a * b + a * c + b * c) / 6.0]
                wanted += [between(rates, along[0]) / self._step, between(weights, along[1])]
            return list(zip(*wanted, strict=True))

        return quantities
