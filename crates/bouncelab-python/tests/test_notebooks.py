"""The notebooks run from top to bottom, in Jupyter and, converted, in marimo."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
@pytest.mark.filterwarnings("ignore")
def test_a_notebook_runs(notebook: Path) -> None:
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    read = nbformat.read(notebook, 4)
    nbclient.NotebookClient(read, timeout=300, kernel_name="python3").execute()
    shown = [output for cell in read.cells for output in cell.get("outputs", [])]
    figures = [output for output in shown if {"image/png", "image/svg+xml"} & output.get("data", {}).keys()]
    assert len(figures) >= 3


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_in_marimo(notebook: Path, tmp_path: Path) -> None:
    """It refuses a name that is defined in two cells."""
    pytest.importorskip("marimo")
    app = tmp_path / "notebook.py"
    for command in (["-m", "marimo", "convert", notebook, "-o", app], [app]):
        subprocess.run([sys.executable, *command], cwd=tmp_path, check=True, capture_output=True)


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_is_kept_without_outputs(notebook: Path) -> None:
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    assert [cell["outputs"] for cell in cells if cell.get("outputs")] == []
