"""``python -m bouncelab``: the program."""

import sys

from bouncelab._program import run

if __name__ == "__main__":
    sys.exit(run())
