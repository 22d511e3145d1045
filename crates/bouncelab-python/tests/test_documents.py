"""The examples of the documents run."""

from __future__ import annotations

import importlib.metadata
import itertools
import os
import re
from pathlib import Path

import pytest

import bouncelab as bl

ROOT = Path(os.environ.get("BOUNCELAB_ROOT", "."))
DOCUMENTS = ["docs/python.md", "crates/bouncelab-python/README.md"]


pytestmark = pytest.mark.skipif("BOUNCELAB_ROOT" not in os.environ, reason="the documents are part of the repository")


def run_examples(document: str) -> None:
    examples = re.findall(r"```python\n(.*?)```", (ROOT / document).read_text(encoding="utf-8"), re.DOTALL)
    assert examples
    for example in examples:
        exec(compile(example, document, "exec"), {})


@pytest.mark.parametrize("document", DOCUMENTS)
def test_the_examples_run(document: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for package in ("pandas", "pyarrow"):
        pytest.importorskip(package)
    monkeypatch.chdir(tmp_path)
    run_examples(document)


def test_the_queries_of_a_session_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for package in ("duckdb", "pandas", "statsmodels"):
        pytest.importorskip(package)
    parquet = pytest.importorskip("pyarrow.parquet")
    metadata = itertools.product(("tennis", "golf"), ("wood", "stone"), ("ann", "bob"), range(2))
    for seed, (ball, surface, operator, number) in enumerate(metadata):
        sound = bl.synthesize(ball=ball, restitution=0.8 - 0.05 * (surface == "wood"), bounces=8, seed=seed)
        sound.save(tmp_path / f"{ball}_{surface}_{operator}_{number}.wav")
    study = bl.session(tmp_path, pattern="{ball}_{surface}_{operator}_{}", draws=200)
    (tmp_path / "bouncelab-session").mkdir()
    parquet.write_table(study.drops.to_arrow(), tmp_path / "bouncelab-session" / "drops.parquet")
    monkeypatch.chdir(tmp_path)
    run_examples("docs/session.md")


def test_the_reference_has_every_public_name() -> None:
    pdoc = pytest.importorskip("pdoc")
    pdoc.render.configure(docformat="numpy")
    for module in (bl, bl.batch):
        page = pdoc.render.html_module(pdoc.doc.Module(module), {module.__name__: pdoc.doc.Module(module)})
        lacks = [name for name in module.__all__ if not name.startswith("__") and f'id="{name}"' not in page]
        assert not lacks


def test_the_package_has_the_licences_of_all_that_it_contains() -> None:
    files = importlib.metadata.files("bouncelab") or []
    texts = {path.name: path.read_text(encoding="utf-8") for path in files if path.name.startswith("LICENSE")}
    assert texts.keys() == {"LICENSE-MIT", "LICENSE-APACHE", "LICENSE-THIRD-PARTY.txt"}
    assert "\nsymphonia " in texts["LICENSE-THIRD-PARTY.txt"]
    assert "Mozilla Public License" in texts["LICENSE-THIRD-PARTY.txt"]


def test_the_recipe_of_conda_makes_a_package_for_every_system() -> None:
    rattler = pytest.importorskip("rattler_build")
    recipe = rattler.Stage0Recipe.from_file(str(ROOT / "conda" / "recipe.yaml"))
    variants = rattler.VariantConfig.from_yaml("c_compiler: [gcc]\nrust_compiler: [rust]\nc_stdlib: [sysroot]\n")
    for system in ("linux-64", "linux-aarch64", "osx-arm64", "win-64"):
        platform = rattler.PlatformConfig(target_platform=system)
        [made] = recipe.render(variants, rattler.RenderConfig(platform))
        assert (str(made.recipe.package.name), str(made.recipe.package.version)) == ("bouncelab", bl.__version__)
