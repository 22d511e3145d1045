"""The commands and examples of docs/cluster.md, with the places of a small cluster in place of those that they name."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import ray as engine_of_ray
from clusters import Ray, Spark, cluster
from job import spark_session
from laboratory import names

DOCUMENT = Path(__file__).parents[3] / "docs" / "cluster.md"


def blocks(language: str, word: str, places: dict[str, str]) -> Iterator[str]:
    """The blocks of a language that have a word in them, in order."""
    for block in re.findall(rf"```{language}\n(.*?)```", DOCUMENT.read_text(encoding="utf-8"), re.DOTALL):
        if word in block:
            for name, place in places.items():
                block = block.replace(name, place)
            yield block


def shell(command: str, environment: dict[str, str]) -> str:
    """Run a command with the programs of this environment."""
    path = os.pathsep.join([str(Path(sys.executable).parent), environment["PATH"]])
    done = subprocess.run(
        ["bash", "-c", command], env=environment | {"PATH": path}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr[-4000:]
    return done.stdout


def places(few: Path, folder: Path) -> dict[str, str]:
    here = {name: f"{folder}{name}" for name in ("/frame", "/results", "/manifest", "/tables")}
    # As the names of the files are.
    here |= {"{ball_number}_{surface}_{height}_{}": "{surface}_{height}_{}"}
    return {"/recordings": str(few), **here}


def test_spark(few: Path, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    with cluster(Spark, tmp_path_factory.mktemp("spark")) as spark, pytest.MonkeyPatch.context() as patch:
        job, example = tmp_path / "job", tmp_path / "example"
        small = {"spark://HOST:7077": spark.url, "cores 4": "cores 1", "memory 2g": "memory 600m"}
        small |= {"driver-memory 4g": "driver-memory 1g", "Overhead=2g": "Overhead=300m"}
        [command] = blocks("sh", "spark-submit", places(few, job) | small)
        assert "300 recordings analysed" in shell(command, spark.environment)
        assert len(names(job / "results.parquet")) == 300

        [command] = blocks("sh", "bouncelab session --from", places(few, job) | {"session.html": f"{job}/session.html"})
        shell(command.replace("session --from", f"session --output {job}/session --from"), spark.environment)
        assert (job / "session.html").is_file()

        for name, value in spark.environment.items():
            patch.setenv(name, value)
        session = spark_session(spark.url)
        found: dict[str, object] = {}
        for word in ("SparkSession", "spark.analyze"):
            [code] = blocks("python", word, places(few, example))
            exec(compile(code, str(DOCUMENT), "exec"), found)
        assert len(found["study"]["study"]["groups"]) == 3  # type: ignore[index]
        session.stop()


def test_ray_and_what_comes_then(few: Path, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    with cluster(Ray, tmp_path_factory.mktemp("r")) as ray:
        here = places(few, tmp_path) | {'"auto"': f'"{ray.url}"'}
        for word in ("ray.init", "batch.explode"):
            [code] = blocks("python", word, here)
            exec(compile(f"from bouncelab import batch\n{code}", str(DOCUMENT), "exec"), {})
        engine_of_ray.shutdown()
    assert len(names(tmp_path / "results.parquet")) == 300
    assert (tmp_path / "tables" / "impacts.parquet").is_file()
