"""A driver for the tests: `job.py REQUEST`, with the kernel of the tests in place of the kernel."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING

import faults

from bouncelab import batch

if TYPE_CHECKING:
    from pyspark.sql import SparkSession


#: A server of Spark Connect on this machine, which the driver starts.
CONNECT = "connect"


def main() -> None:
    request = json.loads(sys.argv[1])
    if request.pop("faulty", True):
        batch.kernel = faults.faulty  # type: ignore[assignment]
    engine, url = request.pop("engine"), request.pop("url")
    if engine == "Spark":
        from bouncelab import spark

        print(spark.analyze(spark_session(url), **request))
    else:
        import ray as engine_of_ray

        from bouncelab import ray

        engine_of_ray.init(address=url, log_to_driver=False)
        ray.analyze(request.pop("source"), **request)


def spark_session(url: str) -> SparkSession:
    from pyspark.sql import SparkSession

    settings = {
        "spark.driver.host": "127.0.0.1",
        "spark.executor.memory": "600m",
        "spark.sql.shuffle.partitions": "4",
        "spark.ui.enabled": "false",
        "spark.ui.showConsoleProgress": "false",
    }
    if url == CONNECT:
        return SparkSession.builder.remote("local[2,4]").getOrCreate()
    return SparkSession.builder.master(url).config(map=settings).getOrCreate()


if __name__ == "__main__":
    main()
