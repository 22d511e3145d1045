"""The notebooks run from top to bottom, in Jupyter; and as marimo wants them, no name is defined twice."""

from __future__ import annotations

import ast
import json
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
def test_no_name_is_defined_in_two_cells(notebook: Path) -> None:
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    defined: list[str] = []
    for cell in cells:
        if cell["cell_type"] == "code":
            assert cell["outputs"] == [], "notebooks are kept without outputs"
            defined += sorted(names("".join(cell["source"])))
    assert len(defined) == len(set(defined)), sorted(defined)


def names(code: str) -> set[str]:
    """Return what a cell defines, but for names that begin with an underscore and those within functions."""
    found: set[str] = set()
    for statement in ast.parse(code).body:
        if isinstance(statement, ast.FunctionDef):
            found.add(statement.name)
            continue
        if isinstance(statement, ast.Import | ast.ImportFrom):
            found |= {(alias.asname or alias.name).split(".")[0] for alias in statement.names}
        nodes = ast.walk(statement)
        found |= {node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    return {name for name in found if not name.startswith("_")}
