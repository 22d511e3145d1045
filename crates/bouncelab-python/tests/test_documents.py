"""The examples of the documents run."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

ROOT = Path(os.environ.get("BOUNCELAB_ROOT", "."))
DOCUMENTS = ["README.md", "docs/python.md", "crates/bouncelab-python/README.md"]


@pytest.mark.skipif("BOUNCELAB_ROOT" not in os.environ, reason="the documents are part of the repository")
@pytest.mark.parametrize("document", DOCUMENTS)
def test_the_examples_run(document: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for package in ("pandas", "pyarrow"):
        pytest.importorskip(package)
    monkeypatch.chdir(tmp_path)
    examples = re.findall(r"```python\n(.*?)```", (ROOT / document).read_text(encoding="utf-8"), re.DOTALL)
    assert examples
    for example in examples:
        exec(compile(example, document, "exec"), {})
