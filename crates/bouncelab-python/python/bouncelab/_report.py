"""Results with a document, figures and a report in every language."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Literal

from bouncelab import _core
from bouncelab._data import JSON
from bouncelab._errors import InputError
from bouncelab._figure import Figure, figure, in_language, named


def written(page: _core.Page, form: object) -> str:
    """Return a report in one of its forms."""
    if form == "html":
        return page.html()
    if form == "markdown":
        return page.markdown()
    raise InputError(f"a report is 'html' or 'markdown', not {form!r}")


class Documented:
    """A result with a document in every language."""

    def _document_in(self, language: str) -> str:
        raise NotImplementedError

    def to_dict(self, language: str = "en") -> dict[str, JSON]:
        """Return the document, whose schema it names: what ``--format json`` of the program prints.

        Parameters
        ----------
        language : str
            Language of its sentences, one of :func:`bouncelab.languages`.

        Returns
        -------
        dict
            As JSON has it: lists, numbers, texts and ``None``.

        Raises
        ------
        UnknownNameError
            If there is no such language.
        """
        document: dict[str, JSON] = json.loads(self._document_in(language))
        return document


@dataclass(frozen=True)
class Reported(Documented):
    """A result of many drops, as it was when it was made."""

    _documents: dict[str, str]
    _charts: dict[str, dict[str, _core.Chart]]
    _pages: dict[str, _core.Page]

    @property
    def figures(self) -> tuple[str, ...]:
        """Names of its figures."""
        return tuple(self._charts["en"])

    def figure(self, name: str | None = None, language: str = "en") -> Figure:
        """Return a figure.

        Parameters
        ----------
        name : str, optional
            One of ``figures``; the first if left out.
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
        return figure(self, next(iter(self.figures), "") if name is None else name, language)

    def _chart(self, name: str, language: str) -> _core.Chart:
        return named(in_language(self._charts, language), name)

    def _inputs(self) -> list[str]:
        return []

    def report(self, form: Literal["html", "markdown"] = "html", language: str = "en") -> str:
        """Return a report to read and keep: one page of HTML, or Markdown without its figures.

        Parameters
        ----------
        form : {"html", "markdown"}
        language : str
            One of :func:`bouncelab.languages`.

        Returns
        -------
        str

        Raises
        ------
        InputError
            If there is no such form.
        UnknownNameError
            If there is no such language.
        """
        return written(in_language(self._pages, language), form)

    def _document_in(self, language: str) -> str:
        return in_language(self._documents, language)
