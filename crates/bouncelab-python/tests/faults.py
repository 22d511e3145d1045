"""A kernel to test with: some recordings do what no real one was ever seen to do."""

from __future__ import annotations

import os
import time

from bouncelab import batch
from bouncelab.batch import kernel as sound


class Faulty(batch.Kernel):
    """The kernel, but recordings end their process, or never end, if their names say so.

    It notes each recording that it analyses in the file that ``BOUNCELAB_WORK`` names.
    """

    def row(self, given: batch.Given) -> bytes:
        if work := os.environ.get("BOUNCELAB_WORK"):
            line = os.open(work, os.O_WRONLY | os.O_APPEND | os.O_CREAT)
            os.write(line, f"{given.name}\n".encode())
            os.close(line)
        if "abort" in given.name:
            os.abort()
        while "endless" in given.name:
            time.sleep(1)
        return super().row(given)


def faulty(settings: batch.Settings | None = None, *, root: str = "", isolated: bool = False) -> Faulty:
    """Return it, as :func:`bouncelab.batch.kernel` does."""
    return Faulty(*sound(settings, root=root, isolated=isolated).__reduce__()[1])


class Process:
    """Says which process analyses a recording."""

    def row(self, given: object, /) -> bytes:
        return str(os.getpid()).encode()
