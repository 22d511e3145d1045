"""The exceptions of bouncelab."""

from __future__ import annotations

import json


class BouncelabError(Exception):
    """Base class of every exception that bouncelab raises.

    Parameters
    ----------
    message : str
        The problem and a remedy, in English.
    diagnostic : str, optional
        The same as data, as JSON; empty where there is none.

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
        ...     print(error.message("de")[:18])
        Breite in Grad: 91
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
    """An argument is of the wrong type or shape."""


class OutOfRangeError(BouncelabError, ValueError):
    """A number lies outside the values for which the calculation makes sense."""


class UnknownNameError(BouncelabError, ValueError):
    """A name (a ball, a drag law, a figure, a language, a rule) is not known; the message has the nearest."""


class PhysicsError(BouncelabError, ValueError):
    """The physics refuses: a ball that floats, a drag law beyond its range, too few flights."""


class InferenceError(BouncelabError):
    """Nothing can be inferred from these impacts; the message gives the reason."""


class RecordingError(BouncelabError):
    """A recording, or a list of times, cannot be read."""


class RecordingNotFoundError(RecordingError, FileNotFoundError):
    """There is no such file."""


class SessionError(BouncelabError):
    """A session cannot be read, or its notes contradict each other."""


class OutputError(BouncelabError):
    """A figure or a report cannot be drawn or saved."""
