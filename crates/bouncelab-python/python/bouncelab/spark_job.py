"""The job for ``spark-submit``; see docs/cluster.md.

``spark-submit --master URL $(python -m bouncelab.spark_job --place) SOURCE OUTPUT --ball tennis``
"""
# pyright: reportMissingImports=false

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any


def main() -> None:
    """Analyse a folder of recordings on the cluster of ``spark-submit``."""
    # The usual formatter would break a long place into two lines, which are two words of a command.
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(
        prog="spark_job.py",
        description=main.__doc__,
        formatter_class=raw,
        # What is not stated is left to bouncelab.spark.analyze.
        argument_default=argparse.SUPPRESS,
    )
    parser.add_argument("--place", action="version", version=str(Path(__file__).resolve()), help="where this is")
    parser.add_argument("source", help="folder of recordings, or a URL that fsspec opens")
    parser.add_argument("output", help="folder for the rows")
    parser.add_argument("--ball", help="as of bouncelab.analyze")
    parser.add_argument("--pattern", help="as of bouncelab session")
    parser.add_argument("--settings", type=Path, help="JSON with more options of bouncelab.batch.kernel")
    parser.add_argument("--notes", help="CSV with a column recording and what was noted")
    parser.add_argument("--files-at-once", type=int, help="as of bouncelab.spark.analyze")
    parser.add_argument("--files-per-task", type=int, help="as of bouncelab.spark.analyze")
    asked = vars(parser.parse_args())
    file, notes = asked.pop("settings", None), asked.pop("notes", None)
    settings: Any = json.loads(file.read_text()) if file else {}
    settings |= {name: asked.pop(name) for name in ("ball", "pattern") if name in asked}

    from pyspark.sql import SparkSession

    from bouncelab.spark import analyze

    spark = SparkSession.builder.appName("bouncelab").getOrCreate()
    asked["notes"] = spark.read.csv(notes, header=True) if notes else None
    print(f"{analyze(spark, settings=settings, **asked)} recordings analysed")


if __name__ == "__main__":
    main()
