"""A driver for the tests: `job.py REQUEST`, with the kernel of the tests in place of the kernel."""

from __future__ import annotations

import json
import sys

import faults
from bouncelab import batch


def main() -> None:
    request = json.loads(sys.argv[1])
    if request.pop("faulty", True):
        batch.kernel = faults.faulty  # type: ignore[assignment]
    engine, url = request.pop("engine"), request.pop("url")
    print(spark(url, **request) if engine == "Spark" else ray(url, **request))


def spark(url: str, memory: str = "600m", **request: object) -> int:
    from pyspark.sql import SparkSession

    from bouncelab.spark import analyze

    session = SparkSession.builder.master(url).config("spark.executor.memory", memory)
    session = session.config("spark.ui.enabled", False).config("spark.driver.host", "127.0.0.1")
    return analyze(session.getOrCreate(), **request)  # type: ignore[arg-type]


def ray(url: str, source: str, **request: object) -> None:
    import ray

    from bouncelab.ray import analyze

    ray.init(address=url, log_to_driver=False)
    analyze(source, **request)  # type: ignore[arg-type]


if __name__ == "__main__":
    main()
