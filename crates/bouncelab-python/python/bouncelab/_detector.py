"""Detection in live sound."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Unpack

from bouncelab import _core
from bouncelab._analyze import as_rate, as_samples
from bouncelab._errors import InputError
from bouncelab._recording import Drop, Recording
from bouncelab._settings import Options, analyzer, count, text

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Detector:
    """Detects drops in blocks of samples from any recorder, and returns each drop once it is complete.

    The result does not depend on the size of the blocks. A detector can be copied and pickled at any time, and
    goes on where it was; the version of the package must be the same.

    Parameters
    ----------
    sample_rate_hz : float
        Samples a second.
    channels : int
        How many channels each block has.
    name : str
        What the recording is called.
    **options
        As of :func:`analyze`.

    Raises
    ------
    InputError, OutOfRangeError, UnknownNameError, PhysicsError
        If an argument makes no sense.

    Examples
    --------
    >>> import bouncelab as bl
    >>> import numpy as np
    >>> sound = bl.synthesize(height_m=0.305, restitution=0.9, seed=1, tail_s=6.0)
    >>> detector = bl.Detector(sound.sample_rate_hz, ball="table-tennis-40", draws=None)
    >>> for block in np.array_split(sound.samples, 50):
    ...     for drop in detector.push(block):
    ...         print(round(drop.per_impact.restitution.value, 2))
    0.9
    >>> len(detector.finish().drops)
    1
    """

    def __init__(
        self, sample_rate_hz: float, channels: int = 1, *, name: str = "live", **options: Unpack[Options]
    ) -> None:
        rate, number = as_rate(sample_rate_hz), count("channels", channels)
        if number == 0:
            raise InputError("a detector takes at least one channel")
        self._core = _core.Detector(analyzer(**options), rate, number, text("name", name))

    def push(self, samples: NDArray[np.generic]) -> Iterator[Drop]:
        """Process the next samples, and return the drops completed since.

        Parameters
        ----------
        samples : numpy.ndarray, shape (frames,) or (frames, channels)
            As of :func:`analyze`.

        Returns
        -------
        iterator of Drop
            Usually empty. The samples are processed at once, whether or not it is iterated.

        Raises
        ------
        InputError
            If the samples do not have the channels of the detector.
        """
        over = self._core.push(as_samples(samples))
        return iter([drop for recording in over for drop in Recording(recording).drops])

    @property
    def duration_s(self) -> float:
        """Length of the samples so far, in s."""
        return self._core.duration_s()

    def so_far(self) -> Recording:
        """Return the analysis of the samples so far.

        Returns
        -------
        Recording
            As if the recording ended here.
        """
        return Recording(self._core.so_far())

    def finish(self) -> Recording:
        """Return the analysis of all samples.

        Returns
        -------
        Recording
            What :func:`analyze` returns for all of them together.
        """
        return self.so_far()

    def __reduce__(self) -> tuple[Callable[..., Detector], tuple[str, _core.Analyzer, str, int, bytes]]:
        return (restored, (_core.__version__, *self._core.state()))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Detector) and self._plain() == other._plain()

    def _plain(self) -> tuple[object, ...]:
        analyzer, *rest = self._core.state()
        return (analyzer.__getnewargs__(), *rest)

    def __repr__(self) -> str:
        return f"<bouncelab.Detector: {self.duration_s:.3f} s>"


def restored(version: str, analyzer: _core.Analyzer, name: str, channels: int, state: bytes) -> Detector:
    """Return a detector from its pickle."""
    if version != _core.__version__:
        own = _core.__version__
        raise InputError(f"this detector is of bouncelab {version}, not {own}; use the same version for both")
    detector = Detector.__new__(Detector)
    detector._core = _core.Detector.restore(analyzer, name, channels, state)
    return detector
