"""What the tests of clusters share."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from laboratory import PATTERN, RECORDINGS, SETTINGS, record


@pytest.fixture(scope="session")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return record(tmp_path_factory.mktemp("recordings"), RECORDINGS)


@pytest.fixture(scope="session")
def few(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three hundred recordings, for what is done often."""
    return record(tmp_path_factory.mktemp("few"), 300)


@pytest.fixture(scope="session")
def session(recordings: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The tables of `bouncelab session`."""
    folder = tmp_path_factory.mktemp("session")
    command = [sys.executable, "-m", "bouncelab", "session", recordings, "--output", folder, "--pattern", PATTERN]
    command += ["--ball", SETTINGS["ball"], "--draws", str(SETTINGS["draws"]), "--tables", "parquet"]
    subprocess.run(command, check=True, capture_output=True)
    return folder
