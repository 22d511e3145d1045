"""Analysis of recordings and of impact times."""

from __future__ import annotations

from os import PathLike, fspath
from typing import TYPE_CHECKING, BinaryIO, Protocol, TypeAlias, Unpack, overload

from bouncelab import _core
from bouncelab._errors import InputError
from bouncelab._recording import Recording
from bouncelab._paths import fetched, is_url, matched
from bouncelab._settings import Options, analyzer, count, number, text

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray


class ProgressBar(Protocol):
    """A bar as those of tqdm: it is moved on, and closed.

    Attributes
    ----------
    total : float or None
        How much there is to do; ``None`` if that is not known.

    Examples
    --------
    >>> import bouncelab as bl
    >>> class Bar:
    ...     def __init__(self, *, total, desc, unit):
    ...         self.total = total
    ...     def update(self, n): ...
    ...     def close(self): ...
    >>> bar: bl.ProgressBar = Bar(total=10.0, desc="detecting", unit="s")
    """

    total: float | None

    def update(self, n: float, /) -> object:
        """Move the bar on.

        Parameters
        ----------
        n : float
            By how much.

        Returns
        -------
        object
            Anything.
        """

    def close(self) -> object:
        """End the bar.

        Returns
        -------
        object
            Anything.
        """


class Progress(Protocol):
    """What makes a bar: ``tqdm.tqdm``, ``tqdm.auto.tqdm`` or a function like them.

    Examples
    --------
    >>> import bouncelab as bl
    >>> from tqdm import tqdm
    >>> progress: bl.Progress = tqdm
    >>> sound = bl.synthesize(bounces=8, seed=1)
    >>> len(bl.analyze(sound.samples, sound.sample_rate_hz, draws=None, progress=progress).drops)
    1
    """

    def __call__(self, *, total: float | None, desc: str, unit: str) -> ProgressBar: ...


#: What a recording may be.
Given: TypeAlias = "str | PathLike[str] | bytes | BinaryIO | NDArray[np.generic]"


@overload
def analyze(
    source: Given,
    sample_rate_hz: float | None = None,
    *,
    name: str | None = None,
    progress: Progress | None = None,
    **options: Unpack[Options],
) -> Recording: ...
@overload
def analyze(
    source: list[str] | list[PathLike[str]] | list[bytes] | list[NDArray[np.generic]] | list[Given],
    sample_rate_hz: float | None = None,
    *,
    name: str | None = None,
    progress: Progress | None = None,
    **options: Unpack[Options],
) -> tuple[Recording, ...]: ...
def analyze(
    source: object,
    sample_rate_hz: float | None = None,
    *,
    name: str | None = None,
    progress: Progress | None = None,
    **options: Unpack[Options],
) -> Recording | tuple[Recording, ...]:
    """Find the drops in a recording, and analyse them.

    Parameters
    ----------
    source : path, bytes, binary file or numpy.ndarray, or a list of them
        A recording, such as WAV, MP3 or M4A, or a list of impact times, such as ``.txt`` or ``.csv`` (the page
        Formats of the documents lists all); or samples of shape ``(frames,)`` or ``(frames, channels)``, full
        scale being 1 for floating point and the whole range for integers of up to 32 bits. Contiguous ``float32``
        is read in place. A path may be a URL that fsspec opens, such as ``s3://bucket/drop.wav``, or a pattern such as
        ``"class/*.wav"`` that one file matches.
    sample_rate_hz : float, optional
        Samples a second: for arrays only, and necessary there.
    name : str, optional
        What the recording is called; with bytes, its ending tells lists of times from sound.
    progress : optional
        ``tqdm.tqdm``, or what makes a bar like it.
    **options
        What is known, in SI, and what is asked. All of it may be left out; what is assumed instead is in
        ``recording.settings.assumptions``.

        ball : str or Ball
            One of :func:`presets`, by its name in any case or another usual word, such as ``"ping pong"``; also with
            the diameter in m, as in ``"steel:0.01"``. If left out, and no mass and diameter either, the ball is an
            unknown: the intervals cover every kind that the times allow.
        mass_kg, diameter_m, contact_time_s : float
            As measured, beside ``ball`` or in place of it. Beside it, drag and contact time stay those of the kind, and
            mass and diameter of a solid ball follow from one another. In place of it, the contact time follows from the
            mean density, unless it is given.
        air : Air, or temperature_k, pressure_pa, relative_humidity, or density_kg_m3, viscosity_pa_s : float
            The air; a density of 0 is vacuum.
        drag : str, mapping, list of pairs, array or function
            As :func:`drag_laws` writes them; or the drag coefficient at Reynolds numbers, as in ``{1e4: 0.64, 1e5: 0.58}``;
            or a function of the Reynolds number, which is sampled from 10 to 1e6.
        buoyancy, added_mass : bool
            Whether these forces count; usually they do.
        gravity_m_s2 : float, or latitude_deg, altitude_m : float
            Gravity.
        height_m, height_sd_m : float
            Measured drop height, surface to lowest point of the ball, and its uncertainty (2 mm).
        release_s, release_sd_s : float
            When the ball was released, and the uncertainty (5 ms).
        first_detected : bool
            Whether the first impact detected is the first there was.
        restitution_laws : list of str
            Names of :func:`restitution_laws` to compare; the smooth law alone if left out.
        restitution_prior : mapping, pair of functions or str
            What is known of the restitution over the impact speed, in place of anything from 0 to 1: mean and standard
            deviation at speeds in m/s, as in ``{0.5: (0.93, 0.01), 3.0: (0.86, 0.02)}``; a function of the speed for the mean
            and one for the standard deviation; or one for the mean and a list of functions, each times a standard
            normal of its own. The law is then the smooth one. A study takes each drop without it.
        infer : list of str
            What to leave to the data: gravity, drag, contact-time.
        known : mapping of str to float
            Relative standard uncertainties of inputs: mass, diameter, air-density, gravity, added-mass, drag,
            contact-time, timing. Also scatter, the typical scatter of restitution; scatter-spread, the width of its prior
            over the usual width (0: exact); slow-losses, where 0 lets restitution follow its law until rest.
        flights : tuple of int
            First and last flight of the log-linear fit.
        compare_balls : bool
            Whether to compare what the impact times indicate of each preset ball: ``drop.balls``.
        at_speed_m_s : float
            Impact speed at which to state the restitution.
        reach : list of (bounce, apex_m)
            From which height does a bounce reach an apex?
        draws : int or None
            Draws of the posterior to aim at, 100 to 100,000 (1,000); ``None`` leaves the inference out.
        seed : int
            Seed of the random numbers of the inference (1).
        channel : int
            The only channel to use, the first being 1.
        band_hz : tuple of float
            The only frequencies to use.
        rate_hz : int
            The sample rate of a file that does not state it: samples in text without times.
        accept : list of int
            Numbers of ``candidates`` of the document, the first being 1, to analyse as drops.
        exclude_s, include_s : list of float
            Times of impacts to leave out, and to add.

    Returns
    -------
    Recording or tuple of Recording
        Without a drop, ``drops`` is empty and ``no_drop`` gives the reason. One for each of a list.

    Raises
    ------
    RecordingError
        If the recording cannot be read; :class:`RecordingNotFoundError` if it is not there.
    InputError
        If an argument is of the wrong type or shape.
    OutOfRangeError, UnknownNameError, PhysicsError
        If a setting makes no sense.

    Notes
    -----
    Ctrl-C interrupts it at any time. It releases the GIL, so several threads can analyse in parallel. What to read with
    care is a :class:`BouncelabWarning`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> sound = bl.synthesize(height_m=0.305, restitution=0.95, seed=1)
    >>> recording = bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-38", draws=500)
    >>> abs(recording.drops[0].restitution.value - 0.95) < 0.01
    True
    """
    prepared = analyzer(**options)
    report = None if progress is None else Bars(progress)
    try:
        if isinstance(source, list):
            found = [Recording(analyzed(prepared, each, sample_rate_hz, name, report)) for each in source]
            for recording in found:
                recording._warn()
            return tuple(found)
        return Recording(analyzed(prepared, source, sample_rate_hz, name, report))._warn()
    finally:
        if report is not None:
            report.close()


def analyzed(
    prepared: _core.Analyzer,
    source: object,
    sample_rate_hz: float | None,
    name: str | None,
    report: Bars | None,
) -> _core.Recording:
    """Analyse whatever a recording may be."""
    called = None if name is None else text("name", name)
    if hasattr(source, "__array__") or isinstance(source, memoryview):
        samples = as_samples(source)
        return prepared.samples(samples, as_rate(sample_rate_hz), called or "samples", report)
    if sample_rate_hz is not None:
        raise InputError("sample_rate_hz is for arrays of samples; omit it for a file, which contains it")
    if isinstance(source, str | PathLike):
        path = fspath(source)
        if not isinstance(path, str):
            raise InputError("the path must be a text; decode it with os.fsdecode")
        if is_url(path):
            return prepared.content(fetched(path), called or path, report)
        files = matched(path)
        if len(files) != 1:
            raise InputError(
                f"{path} matches {len(files)} files; bouncelab.session compares them, and analyze(glob.glob({path!r})) "
                "analyses each"
            )
        return prepared.file(files[0], called or files[0], report)
    if isinstance(source, bytes | bytearray):
        return prepared.content(bytes(source), called or "recording", report)
    if callable(read := getattr(source, "read", None)):
        content = read()
        if not isinstance(content, bytes):
            raise InputError('the file gives text; open it with mode "rb"')
        own = getattr(source, "name", None)
        return prepared.content(content, called or (own if isinstance(own, str) else "recording"), report)
    raise InputError(
        f"a recording is a path, bytes, a binary file or a NumPy array, not {type(source).__name__}"
    )


def analyze_times(
    times_s: Sequence[float] | NDArray[np.generic],
    *,
    name: str = "times",
    **options: Unpack[Options],
) -> Recording:
    """Analyse a list of impact times.

    Parameters
    ----------
    times_s : array_like of float, shape (impacts,)
        Impact times in s, in increasing order; they are one drop.
    name : str
        What the list is called.
    **options
        As of :func:`analyze`.

    Returns
    -------
    Recording

    Raises
    ------
    InputError
        If the times are no increasing list of finite numbers.
    OutOfRangeError, UnknownNameError, PhysicsError
        If a setting makes no sense.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=None).drops[0]
    >>> round(drop.log_linear_fit.restitution.value, 3)
    0.932
    """
    times = as_numbers("times_s", times_s)
    if any(later <= earlier for earlier, later in zip(times, times[1:], strict=False)):
        raise InputError("times_s must increase: sort them, and leave out doubles")
    return Recording(analyzer(**options).times(times, text("name", name)))._warn()


def as_samples(source: object) -> NDArray[np.float32]:
    """Return samples as contiguous frames of 32-bit floats, without a copy if they are."""
    import numpy as np

    try:
        array = np.asarray(source)
    except (TypeError, ValueError) as reason:
        raise InputError(f"these are no samples: {reason}") from None
    if array.dtype.kind in "iu":
        # Those that NumPy makes of lists of numbers; taken for their whole range, 16-bit sound would be silence.
        if array.dtype.itemsize > 4:
            raise InputError(
                f"samples of {array.dtype} do not state their full scale; divide by it, as in samples / 32768 for "
                "16-bit sound, or convert them to int16 or int32"
            )
        limits = np.iinfo(array.dtype)
        middle, half = (limits.max + limits.min + 1) // 2, (limits.max - limits.min + 1) / 2
        array = ((array - np.float32(middle)) / np.float32(half)).astype(np.float32, copy=False)
    elif array.dtype.kind != "f":
        raise InputError(f"samples must be numbers, not {array.dtype}")
    if array.ndim == 1:
        array = array[:, None]
    if array.ndim != 2:
        raise InputError(f"samples have the shape (frames,) or (frames, channels), not {array.shape}")
    if array.shape[1] == 0 or array.shape[0] == 0:
        raise InputError("there are no samples")
    if array.shape[1] > array.shape[0] and array.shape[0] > 1:
        raise InputError(f"{array.shape} are more channels than frames; transpose the array (samples.T)")
    with np.errstate(over="ignore"):
        samples = np.ascontiguousarray(array, dtype=np.float32)
    for start in range(0, len(samples), CHECKED_AT_ONCE):
        known = np.isfinite(samples[start : start + CHECKED_AT_ONCE]).all(axis=1)
        if not known.all():
            frame = start + int(known.argmin())
            raise InputError(
                f"the samples of frame {frame} are not finite; cut the sound before it, or fill the gap, for which "
                "include_s and exclude_s correct the impacts"
            )
    return samples


def as_rate(sample_rate_hz: object) -> int:
    """Return a sample rate as a whole number."""
    if sample_rate_hz is None:
        raise InputError("the sample rate of an array is missing; give sample_rate_hz")
    rate = number("sample_rate_hz", sample_rate_hz)
    if rate != round(rate) or not 0 < rate < 2**32:
        raise InputError(f"sample_rate_hz is {rate:g}; it must be a whole number above 0, such as 44100")
    return count("sample_rate_hz", round(rate))


def as_numbers(name: str, values: object, *, flat: bool = False, single: bool = False) -> list[float]:
    """Return a list of finite numbers; flat ones may be of any shape, and a single one may be a number."""
    import numpy as np

    try:
        array = np.asarray(values)
        if array.dtype.kind not in "iuf" and array.size:
            raise InputError(f"{name} must be numbers, not {array.dtype}")
        if flat or (single and array.ndim == 0):
            array = array.ravel()
        if array.ndim != 1:
            raise InputError(f"{name} must be a list of numbers, not of shape {array.shape}")
        numbers: list[float] = array.astype(np.float64).tolist()
    except (TypeError, ValueError) as reason:
        if isinstance(reason, InputError):
            raise
        raise InputError(f"{name} must be a list of numbers: {reason}") from None
    if not np.isfinite(numbers).all():
        raise InputError(f"{name} must be finite; leave out what is not known")
    return numbers


#: Number of frames whose samples are checked at once, so that no large array is made.
CHECKED_AT_ONCE = 1 << 18


class Bars:
    """A bar for each kind of work, moved on as it is done."""

    def __init__(self, make: Progress) -> None:
        if not callable(make):
            raise InputError("progress must make bars, as tqdm.tqdm does")
        self._make = make
        self._bar: ProgressBar | None = None
        self._unit = ""
        self._done = 0.0

    def __call__(self, unit: str, done: float, total: float | None) -> None:
        if unit != self._unit:
            self.close()
            desc = "detecting" if unit == "s" else "inferring"
            self._bar, self._unit, self._done = self._make(total=total, desc=desc, unit=unit), unit, 0.0
        if self._bar is not None:
            self._bar.update(done - self._done)
        self._done = done

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
