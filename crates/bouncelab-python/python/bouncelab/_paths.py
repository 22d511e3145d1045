"""Paths that people give: of files and folders, patterns, URLs, and lists of them."""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager
from os import PathLike, fspath
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from bouncelab._errors import BouncelabError, InputError, RecordingError, RecordingNotFoundError, imported
from bouncelab._settings import text


def is_url(path: str) -> bool:
    """Return whether a path is one of a store, as ``s3://bucket/drop.wav``; a letter before a colon is a drive."""
    return re.match(r"[A-Za-z][A-Za-z0-9+.-]+://", path) is not None


def matched(path: str) -> list[str]:
    """Return the files that a pattern matches, in order of their names; any other path as it is."""
    if os.path.exists(path) or not glob.has_magic(path):
        return [path]
    return sorted(glob.glob(path, recursive=True))


def listed(name: str, given: object) -> list[str]:
    """Return a path, or several, as texts."""
    if isinstance(given, str | PathLike):
        given = [given]
    if not isinstance(given, Iterable) or isinstance(given, bytes):
        raise InputError(f"{name} must be a path or a list of paths, not {type(given).__name__}")
    return [text(name, fspath(path) if isinstance(path, PathLike) else path) for path in given]


def local(name: str, given: object, stack: ExitStack) -> list[str]:
    """Return paths of this machine: those that patterns match, and what is at URLs, in a folder until the stack ends."""
    found: list[str] = []
    for path in listed(name, given):
        if is_url(path):
            files, place = _of_url(path)
            folder = stack.enter_context(TemporaryDirectory())
            copied = Path(folder, place.rstrip("/").rpartition("/")[2])
            with _told(path):
                files.get(place, str(copied), recursive=files.isdir(place))
            found.append(str(copied))
        else:
            found += matched(path)
    return found


def fetched(url: str) -> bytes:
    """Return the content of the file at a URL."""
    files, place = _of_url(url)
    with _told(url):
        read: bytes = files.cat_file(place)
    return read


def files_at(url: str) -> dict[str, str]:
    """Return the files in a folder at a URL: their own URLs by their names relative to it."""
    files, place = _of_url(url)
    with _told(url):
        start = len(place.rstrip("/")) + 1
        return {path[start:]: files.unstrip_protocol(path) for path in files.find(place)}


def _of_url(url: str) -> tuple[Any, str]:
    """Return the file system of fsspec for a URL, and the path there."""
    with _told(url):
        files, place = imported("fsspec", "fsspec").core.url_to_fs(url)
        return files, place


@contextmanager
def _told(url: str) -> Iterator[None]:
    """Make an exception of the package of what a store raises."""
    try:
        yield
    except BouncelabError:
        raise
    except FileNotFoundError as reason:
        raise RecordingNotFoundError(f"{url}: there is no such file") from reason
    except Exception as reason:
        # Each kind of store has exceptions of its own.
        raise RecordingError(f"{url}: {reason}") from reason
