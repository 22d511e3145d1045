"""A child process that analyses recordings, so that one that ends it harms no other."""

from __future__ import annotations

import atexit
import os
import pickle
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Protocol, TypeAlias

#: The row of a recording.
Outcome: TypeAlias = "Callable[[Any], bytes]"

#: Memory that a child may take beyond what it has when it begins, in bytes: that of the program.
MEMORY = 1 << 30


class Analyses(Protocol):
    """What analyses one recording; it can be pickled."""

    def row(self, given: Any, /) -> bytes: ...


class Isolated:
    """A child process that analyses one recording after the other; it is replaced when it ends.

    Parameters
    ----------
    analyses : bytes
        What the child does, pickled.
    limit_s : float or None
        Longest time for one recording.
    """

    def __init__(self, analyses: bytes, limit_s: float | None) -> None:
        self._analyses = analyses
        self._limit_s = limit_s
        self._child: subprocess.Popen[bytes] | None = None
        self._is_over = False

    def row(self, given: object) -> bytes | tuple[str, str]:
        """Return the row of a recording, or the kind of its failure and the reason.

        A recording fails if it ends two children: the system may have ended the first for another.
        """
        outcome = self._try(given)
        return self._try(given) if outcome[0] == "process-died" and not self._is_over else outcome

    def _try(self, given: object) -> bytes | tuple[str, str]:
        child = self._running()
        assert child.stdin is not None and child.stdout is not None
        late = threading.Event()

        def end() -> None:
            late.set()
            child.kill()

        timer = threading.Timer(self._limit_s or 0.0, end)
        try:
            if self._limit_s is not None:
                timer.start()
            child.stdin.write(pickle.dumps(given))
            child.stdin.flush()
            outcome: bytes | Exception = pickle.load(child.stdout)
        except (EOFError, OSError, pickle.UnpicklingError):
            if late.is_set():
                reason = ("out-of-time", f"it took longer than {self._limit_s:g} s")
            else:
                reason = ("process-died", f"it ended the process that analysed it, by {_cause(child.wait())}")
            self.close()
            return reason
        finally:
            timer.cancel()
        if late.is_set():
            self.close()
        if isinstance(outcome, Exception):
            raise outcome
        return outcome

    def _running(self) -> subprocess.Popen[bytes]:
        if self._child is None:
            path = os.pathsep.join(filter(None, sys.path))
            command = [sys.executable, "-m", "bouncelab._isolated"]
            self._child = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=os.environ | {"PYTHONPATH": path}
            )
            assert self._child.stdin is not None and self._child.stdout is not None
            self._child.stdin.write(self._analyses)
            self._child.stdin.flush()
            # The time to begin is not that of a recording.
            pickle.load(self._child.stdout)
        return self._child

    def end(self) -> None:
        """End the work of another thread on a recording, and all further work."""
        self._is_over = True
        if self._child is not None:
            self._child.kill()

    def close(self) -> None:
        """End the child."""
        if self._child is not None:
            self._child.kill()
            self._child.communicate()
            self._child = None


#: Children that wait for the next call; to start one takes as long as to analyse several recordings.
_idle: dict[tuple[bytes, float | None], Isolated] = {}


@contextmanager
def child_process(analyses: Analyses, limit_s: float | None) -> Iterator[Isolated]:
    """Give a child that nobody else uses; it is kept for the next call in this process."""
    key = (pickle.dumps(analyses), limit_s)
    child = _idle.pop(key, None) or Isolated(*key)
    try:
        yield child
    except BaseException:
        # It may still owe a reply.
        child.close()
        raise
    _end_idle()
    _idle[key] = child


def _end_idle() -> None:
    while _idle:
        _idle.popitem()[1].close()


atexit.register(_end_idle)
if hasattr(os, "register_at_fork"):
    # They are children of the process that was forked, which goes on to use them.
    os.register_at_fork(after_in_child=_idle.clear)


def _cause(status: int) -> str:
    try:
        return signal.Signals(-status).name if status < 0 else f"exit status {status}"
    except ValueError:
        return f"signal {-status}"


def _limit_memory() -> None:
    """Limit the memory of this process, on Linux; a stricter limit of somebody else stays."""
    if sys.platform != "linux":
        return
    import resource

    with open("/proc/self/status", encoding="ascii") as status:
        taken = next(int(line.split()[1]) << 10 for line in status if line.startswith("VmData:"))
    soft, hard = resource.getrlimit(resource.RLIMIT_DATA)
    if soft == resource.RLIM_INFINITY or soft > taken + MEMORY:
        resource.setrlimit(resource.RLIMIT_DATA, (taken + MEMORY, hard))


def main() -> None:
    """Analyse what comes in, until nothing comes any more."""
    replies = os.fdopen(os.dup(1), "wb")
    # Whatever else is printed must not come between the replies.
    os.dup2(2, 1)
    analyses: Analyses = pickle.load(sys.stdin.buffer)
    _limit_memory()
    outcome: bytes | Exception | None = None
    while True:
        pickle.dump(outcome, replies)
        replies.flush()
        try:
            given = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        try:
            outcome = analyses.row(given)
        except MemoryError:
            os.abort()
        except Exception as fault:
            outcome = fault


if __name__ == "__main__":
    main()
