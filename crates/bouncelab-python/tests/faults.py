"""A kernel to test with: some recordings do what no real one was ever seen to do."""

from __future__ import annotations

import os
import time
from typing import Any

import pytest

from bouncelab import _session, batch
from bouncelab._isolated import MEMORY
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
        fail(given.name)
        return super().row(given)


class FaultyWork(_session._Work):
    """The same for the recordings of a session."""

    def row(self, given: tuple[str, str]) -> bytes:
        fail(given[0])
        return super().row(given)


def fail(name: str) -> None:
    """End the process, or never return, if the name of a recording says so."""
    if "abort" in name:
        os.abort()
    while "endless" in name:
        time.sleep(1)


def faulty(settings: batch.KernelOptions | None = None, *, root: str = "", isolated: bool = False) -> Faulty:
    """Return it, as :func:`bouncelab.batch.kernel` does."""
    return Faulty(*sound(settings, root=root, isolated=isolated).__reduce__()[1])


class Greedy:
    """Takes more memory than a child may have."""

    def row(self, given: object, /) -> bytes:
        return bytes(2 * MEMORY)[:1]


class Process:
    """Says which process analyses a recording."""

    def row(self, given: object, /) -> bytes:
        return str(os.getpid()).encode()


def same_groups(found: dict[str, Any], expected: dict[str, Any]) -> None:
    """Compare the groups of two documents: sums that are added up in another order differ in their last digits."""
    assert [group["levels"] for group in found["study"]["groups"]] == [
        group["levels"] for group in expected["study"]["groups"]
    ]
    for one, other in zip(found["study"]["groups"], expected["study"]["groups"], strict=True):
        for number in ("value", "sd"):
            assert one["restitution"][number] == pytest.approx(other["restitution"][number], rel=1e-6)
        assert one["between_drops"]["value"] == pytest.approx(other["between_drops"]["value"], rel=1e-6)
