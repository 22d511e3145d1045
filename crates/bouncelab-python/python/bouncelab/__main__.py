"""``bouncelab`` and ``python -m bouncelab``: the program, of the same compiled code as the package."""

import os
import sys

from bouncelab import _core


def main() -> int:
    """Run the program with the arguments of this process; return its exit status."""
    # A session starts this program again, which must find the package where this process found it.
    os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, sys.path))
    return _core.run_program([sys.executable, "-m", "bouncelab"], sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
