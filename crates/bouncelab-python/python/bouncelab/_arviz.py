"""A posterior as the InferenceData of ArviZ."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from bouncelab._errors import imported

if TYPE_CHECKING:
    from arviz import InferenceData

    from bouncelab._recording import Draws

#: The coordinate of each axis.
AXES = {"impact": "impact", "interval": "interval", "speed": "speed_m_s"}


def inference_data(draws: Draws) -> InferenceData:
    """Return all that is known of a posterior."""
    arviz = imported("arviz", "arviz")
    import numpy as np

    drop, recording = draws._drop, draws._drop._recording
    drawn, order, kinds = json.loads(recording._ask("drawn_unknowns", drop._place))
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
    answers = {column.name: draws[column.name][None] for column in draws.columns}
    units |= {column.name: column.unit for column in draws.columns}
    groups = {
        "posterior": of(drawn["posterior"], order) | answers,
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
    document = recording._document
    about = {
        "recording": recording.name,
        "bouncelab": str(document["bouncelab"]),
        "settings": json.dumps(document["settings"]),
        "restitution_speed_m_s": drop.posterior.at_speed_m_s,
        "balls": json.dumps([kind or "stated" for kind in kinds]),
        "effective_draws": drop.posterior.sampling.effective_draws,
        "pareto_shape": drop.posterior.sampling.pareto_shape,
    }
    for name, variables in groups.items():
        group = data[name]
        group.attrs.update(about)
        for variable in variables:
            unit = units[variable] if name != "log_likelihood" else ""
            group[variable].attrs["units"] = unit or "1"
    return data
