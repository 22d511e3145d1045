"""A posterior as the InferenceData of ArviZ."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from bouncelab._errors import imported

if TYPE_CHECKING:
    import numpy as np
    from arviz import InferenceData
    from numpy.typing import NDArray

#: The coordinate of each axis.
AXES = {"impact": "impact", "interval": "interval", "speed": "speed_m_s"}


def inference_data(
    unknowns: str, answers: Mapping[str, tuple[str, NDArray[np.generic]]], about: Mapping[str, object]
) -> InferenceData:
    """Return all that is known of a posterior.

    Parameters
    ----------
    unknowns : str
        What the core says of them.
    answers : mapping
        Unit and draws of each answer.
    about : mapping
        Attributes of every group.
    """
    arviz = imported("arviz", "arviz")
    import numpy as np

    drawn, order, kinds = json.loads(unknowns)
    dims: dict[str, list[str]] = {}
    units: dict[str, str] = {}

    def of(variables: list[dict[str, Any]], order: list[int] | slice) -> dict[str, Any]:
        found = {}
        for variable in variables:
            name, along = variable["name"], variable["along"]
            values = np.array(variable["values"], dtype=np.float64)
            if along is not None:
                coordinate = AXES[along]
                dims[name] = [coordinate]
                values = values.reshape(-1, len(coordinates[coordinate]))
            units[name] = units.get(name) or variable["unit"]
            found[name] = values[order][None]
        return found

    numbers = drawn["impacts"]
    coordinates = {"impact": numbers, "interval": numbers[:-1], "speed_m_s": drawn["speeds_m_s"]}
    units |= {name: unit for name, (unit, _) in answers.items()}
    groups = {
        "posterior": of(drawn["posterior"], order) | {name: values[None] for name, (_, values) in answers.items()},
        "posterior_predictive": of([drawn["replicated"]], order),
        "prior": of(drawn["prior"], slice(None)),
        "log_likelihood": of([drawn["log_likelihood"]], order),
        "sample_stats": {name: values.astype(np.int64) for name, values in of(drawn["sample"], order).items()},
        "observed_data": {"interval_s": np.array(drawn["intervals_s"])},
    }
    # Version 1 takes all groups as one.
    is_new = int(arviz.__version__.split(".")[0]) >= 1
    given: dict[str, Any] = {"coords": coordinates, "dims": dims}
    data: InferenceData = arviz.from_dict(groups, **given) if is_new else arviz.from_dict(**groups, **given)
    balls = json.dumps([kind or "stated" for kind in kinds])
    for name, variables in groups.items():
        group = data[name]
        group.attrs.update(about, balls=balls)
        for variable in variables:
            unit = units[variable] if name != "log_likelihood" else ""
            group[variable].attrs["units"] = unit or "1"
    return data
