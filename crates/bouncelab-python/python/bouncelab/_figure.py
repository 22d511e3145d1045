"""Figures: drawn as SVG, as PNG, by Matplotlib, or as data."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypeVar

from bouncelab import _core
from bouncelab._data import JSON
from bouncelab._errors import InputError
from bouncelab._settings import text
from bouncelab._table import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

T = TypeVar("T")


class Charted(Protocol):
    """What has figures."""

    def _chart(self, name: str, language: str) -> _core.Chart: ...

    def _inputs(self) -> list[str]: ...


@dataclass(frozen=True)
class Figure:
    """A figure, which a notebook displays.

    Attributes
    ----------
    name : str
        Its name, as in ``figure(name)`` of its owner.
    language : str
        The language of its words.

    Examples
    --------
    >>> import bouncelab as bl
    >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=None).drops[0]
    >>> figure = drop.figure("flight-times")
    >>> figure.svg()[:4]
    '<svg'
    >>> figure.data["y"].shape
    (17,)
    """

    _owner: Charted
    name: str
    language: str = "en"

    @cached_property
    def _drawn(self) -> _core.Chart:
        return self._owner._chart(self.name, self.language)

    @property
    def title(self) -> str:
        """The title."""
        return str(self.to_dict()["title"])

    @property
    def caption(self) -> str:
        """One sentence that explains the figure."""
        return str(self.to_dict()["caption"])

    def svg(self) -> str:
        """Return the figure as SVG.

        Returns
        -------
        str
        """
        return self._drawn.svg()

    def png(self, width_px: int = 1600) -> bytes:
        """Return the figure as PNG.

        Parameters
        ----------
        width_px : int
            Width in pixels.

        Returns
        -------
        bytes

        Raises
        ------
        OutputError
            If it would be too large.
        """
        return self._drawn.png(width_px)

    def pdf(self) -> bytes:
        """Return the figure as a PDF of one page, for papers and slides.

        Returns
        -------
        bytes
        """
        return self._drawn.pdf()

    def save(self, path: str | PathLike[str], width_px: int = 1600, *, force: bool = False) -> Path:
        """Save the figure as SVG, PNG or PDF, by the ending of the name.

        Another figure of bouncelab is replaced, a file of others only with ``force``, the recording itself never.

        Parameters
        ----------
        path : str or path-like
            A name that ends in ``.svg``, ``.png`` or ``.pdf``.
        width_px : int
            Width of a PNG in pixels.
        force : bool
            Whether it may replace a file that bouncelab did not write.

        Returns
        -------
        pathlib.Path
            The file.

        Raises
        ------
        InputError
            If the name ends in none of them.
        OutputError
            If the file cannot be written or may not be replaced.
        """
        file = Path(fspath(path))
        forms = {"svg": lambda: self.svg().encode(), "png": lambda: self.png(width_px), "pdf": self.pdf}
        form = file.suffix.lower().removeprefix(".")
        drawn = forms.get(form)
        if drawn is None:
            raise InputError(f"{file}: a figure is saved as .svg, .png or .pdf; end the name in one of them")
        _core.write_file(fspath(file), form, drawn(), self._owner._inputs(), bool(force))
        return file

    @property
    def data(self) -> Table:
        """Its data, one row for each point, bar and line, for other plotting libraries."""
        return Table(self._drawn.table())

    def to_dict(self) -> dict[str, JSON]:
        """Return the chart as data.

        Returns
        -------
        dict
            Panels with axes and layers.
        """
        chart: dict[str, JSON] = json.loads(self._drawn.json())
        return chart

    def to_matplotlib(self, ax: Axes | None = None, panel: int = 0) -> Axes:
        """Draw a panel with Matplotlib, for those who style it themselves.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; a new figure if left out.
        panel : int
            Which panel, from 0.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        InputError
            If there is no such panel.

        Examples
        --------
        >>> import bouncelab as bl
        >>> import matplotlib
        >>> matplotlib.use("agg")
        >>> drop = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], draws=None).drops[0]
        >>> drop.figure("flight-times").to_matplotlib().get_xlabel()
        'number of the flight'
        """
        from bouncelab import _matplotlib

        panels = self.to_dict()["panels"]
        assert isinstance(panels, list)
        if not 0 <= panel < len(panels):
            raise InputError(f"there is no panel {panel}: the figure has {len(panels)}, the first being 0")
        return _matplotlib.draw(panels[panel], ax)

    def __reduce__(self) -> tuple[type[Figure], tuple[Charted, str, str]]:
        return (Figure, (self._owner, self.name, self.language))

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<bouncelab.Figure {self.name!r}>"


def figure(owner: Charted, name: str, language: str) -> Figure:
    """Return a figure; an unknown name or language is refused at once."""
    drawn = owner._chart(text("name", name), text("language", language))
    made = Figure(owner, name, language)
    made.__dict__["_drawn"] = drawn
    return made


def in_language(by_language: dict[str, T], language: str) -> T:
    """Return what there is in a language."""
    if language not in by_language:
        _core.require_known("language", text("language", language), list(by_language))
    return by_language[language]


def named(charts: dict[str, _core.Chart], name: str) -> _core.Chart:
    """Return the chart of a name."""
    if name not in charts:
        _core.require_known("figure", name, list(charts))
    return charts[name]
