"""The exceptions of bouncelab."""

from __future__ import annotations

import importlib
import json
from typing import Any


class BouncelabError(Exception):
    """Base class of every exception that bouncelab raises.

    Parameters
    ----------
    message : str
        The problem and a remedy, in English.
    diagnostic : str, optional
        The same as data, as JSON; empty if the error has no data.

    Attributes
    ----------
    code : str or None
        Stable name of the problem, such as ``"out-of-range"``; ``None`` where the science was not asked.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.drag_coefficient(1e4, law="morison")
    ... except bl.BouncelabError as error:
    ...     print(error.code)
    unknown-name
    """

    def __init__(self, message: str, diagnostic: str = "") -> None:
        super().__init__(message, diagnostic)
        self._message = message
        self._diagnostic = diagnostic

    @property
    def code(self) -> str | None:
        """Stable name of the problem."""
        if not self._diagnostic:
            return None
        code: str = json.loads(self._diagnostic)["code"]
        return code

    def message(self, language: str = "en") -> str:
        """Return the sentence in a language.

        Parameters
        ----------
        language : str
            One of :func:`bouncelab.languages`. What the science did not refuse is said in English.

        Returns
        -------
        str

        Raises
        ------
        UnknownNameError
            If there is no such language.

        Examples
        --------
        >>> import bouncelab as bl
        >>> try:
        ...     bl.gravity_m_s2(latitude_deg=91.0)
        ... except bl.OutOfRangeError as error:
        ...     print(error.message("de").split(":")[0])
        Geografische Breite
        """
        if not self._diagnostic:
            return self._message
        from bouncelab import _core

        return _core.message(self._diagnostic, language)

    def __str__(self) -> str:
        return self._message

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.args == getattr(other, "args", None)

    def __hash__(self) -> int:
        return hash((type(self), self.args))


class InputError(BouncelabError, ValueError):
    """An argument is of the wrong type or shape.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.analyze_times([1.0, 0.5])
    ... except bl.InputError as error:
    ...     print(error)
    times_s must increase: sort them, and leave out doubles
    """


class OutOfRangeError(BouncelabError, ValueError):
    """A number lies outside the values for which the calculation makes sense.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.air(temperature_k=20.0)
    ... except bl.OutOfRangeError as error:
    ...     print(error.code)
    out-of-range
    """


class UnknownNameError(BouncelabError, ValueError):
    """A name (a ball, a drag law, a figure, a language, a rule) is not known; the message has the nearest.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.simulate(ball="tenniss")
    ... except bl.UnknownNameError as error:
    ...     print("tennis" in str(error))
    True
    """


class PhysicsError(BouncelabError, ValueError):
    """The physics refuses: a ball that floats, a drag law beyond its range, too few flights.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.analyze_times([0.0, 0.5], draws=None).drops[0].log_linear_fit
    ... except bl.PhysicsError as error:
    ...     print("at least 3 impacts" in str(error))
    True
    """


class InferenceError(BouncelabError):
    """Nothing can be inferred from these impacts; the message gives the reason.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.analyze_times([0.0, 0.5, 0.9], draws=None).drops[0].posterior
    ... except bl.InferenceError as error:
    ...     print(error.code)
    inference-off
    """


class RecordingError(BouncelabError):
    """A recording, or a list of times, cannot be read.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.analyze(b"no sound")
    ... except bl.RecordingError:
    ...     print("not a recording")
    not a recording
    """


class RecordingNotFoundError(RecordingError, FileNotFoundError):
    """There is no such file.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.analyze("nowhere.wav")
    ... except FileNotFoundError as error:
    ...     print(isinstance(error, bl.RecordingNotFoundError))
    True
    """


class SessionError(BouncelabError):
    """A session cannot be read, or its notes contradict each other.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     bl.session([])
    ... except bl.SessionError:
    ...     print("no recordings")
    no recordings
    """


class OutputError(BouncelabError):
    """A figure or a report cannot be drawn or saved.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> figure = bl.simulate(bounces=3).figure("height")
    >>> try:
    ...     figure.save("no/such/folder/height.svg")
    ... except bl.OutputError:
    ...     print("not saved")
    not saved
    """


class MissingPackageError(BouncelabError, ImportError):
    """A package that bouncelab uses here is not installed; the message has the command that installs it.

    Parameters and attributes are those of :class:`BouncelabError`.

    Examples
    --------
    >>> import bouncelab as bl
    >>> try:
    ...     table = bl.analyze_times([0.0, 0.5, 0.9], draws=None).impacts.to_polars()
    ... except bl.MissingPackageError as error:
    ...     print(error)
    """


class BouncelabWarning(UserWarning):
    """A result to be read with care: clipped samples, an assumed ball, an inference that did not converge.

    It goes through the module ``warnings``, once for each kind of doubt in a recording, and says the same as the
    diagnostics of the result.

    Examples
    --------
    >>> import bouncelab as bl
    >>> import warnings
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     warnings.simplefilter("always")
    ...     drop = bl.analyze_times([0.0, 0.5, 0.9], draws=None)
    >>> caught[0].category.__name__
    'BouncelabWarning'
    """


def imported(package: str, extra: str) -> Any:
    """Return a package that an extra installs."""
    try:
        return importlib.import_module(package)
    except ModuleNotFoundError as missing:
        if missing.name is None or missing.name.split(".")[0] != package.split(".")[0]:
            raise
        raise MissingPackageError(f"this takes {package}: pip install 'bouncelab[{extra}]'") from None
