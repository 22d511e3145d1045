"""The program that comes with the wheel."""

from __future__ import annotations

import os
import sys
import sysconfig
from pathlib import Path


def find() -> Path:
    """Return the program ``bouncelab`` of this installation.

    Raises
    ------
    FileNotFoundError
        If the wheel was built without the program.
    """
    name = "bouncelab" + (sysconfig.get_config_var("EXE") or "")
    schemes = (sysconfig.get_default_scheme(), sysconfig.get_preferred_scheme("user"))
    folders = [Path(sysconfig.get_path("scripts", scheme)) for scheme in schemes]
    # Where `pip install --target` and `uvx` put it.
    package = Path(__file__).resolve().parent
    folders += [package.parent / "bin", *(parent / "bin" for parent in package.parents[2:5])]
    for folder in folders:
        if (folder / name).is_file():
            return folder / name
    raise FileNotFoundError(
        "this installation has no program; install a wheel that has it, or `cargo install bouncelab-cli`"
    )


def run() -> int:
    """Run the program with the arguments of this process; return its exit status."""
    command = [str(find()), *sys.argv[1:]]
    if sys.platform != "win32":
        os.execv(command[0], command)
    import subprocess

    return subprocess.run(command, check=False).returncode
