"""Charts drawn with Matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from bouncelab import _core
from bouncelab._errors import imported

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Dashes and markers of charts, as Matplotlib calls them.
DASHES = {"solid": "-", "dashed": "--", "dotted": ":", "long": (0, (8, 4))}
MARKERS = {"dot": "o", "ring": "o", "triangle": "v", "open-triangle": "v", "speck": "."}


def draw(panel: Any, given: Axes | None) -> Axes:
    """Draw a panel of a chart."""
    ax: Axes = imported("matplotlib.pyplot", "matplotlib").subplots()[1] if given is None else given
    for axis, label, scale, limits in (
        (panel["x"], ax.set_xlabel, ax.set_xscale, ax.set_xlim),
        (panel["y"], ax.set_ylabel, ax.set_yscale, ax.set_ylim),
    ):
        label(f"{axis['quantity']} ({axis['unit']})" if axis["unit"] else axis["quantity"])
        scale("log" if axis["scale"]["kind"] == "log" else "linear")
        limits(axis["scale"]["low"], axis["scale"]["high"])
    if names := panel["y"]["names"]:
        # The first stands on top, in rows of the height 1.
        ax.set_yticks([len(names) - 0.5 - place for place in range(len(names))], names)
    ax.set_title(panel["title"])
    named = False
    for layer in panel["layers"]:
        _layer(ax, layer)
        named |= bool(layer["name"])
    if named:
        ax.legend()
    return ax


def _layer(ax: Axes, layer: Any) -> None:
    colour = _core.colour(layer["meaning"])
    look = {"color": colour, "alpha": layer["strength"], "label": layer["name"] or "_"}
    match layer["kind"]:
        case "line":
            ax.plot(*_columns(layer["points"], 2), ls=DASHES[layer["dashes"]], lw=layer["width"], **look)
        case "points":
            x, y = _columns(layer["points"], 2)
            errors = [error or 0.0 for error in layer["errors"]] or None
            fill = "none" if layer["marker"] in ("ring", "open-triangle") else colour
            ax.errorbar(x, y, yerr=errors, fmt=MARKERS[layer["marker"]], markerfacecolor=fill, **look)
        case "band":
            x, low, high = _columns(layer["points"], 3)
            ax.fill_between(x, low, high, lw=0, **look)
        case "boxes":
            left, right, bottom, top = _columns(layer["boxes"], 4)
            width = [b - a for a, b in zip(left, right, strict=True)]
            height = [b - a for a, b in zip(bottom, top, strict=True)]
            ax.bar(left, height, width, bottom, align="edge", **look)
        case "rule":
            across = ax.axvline if layer["upright"] else ax.axhline
            across(layer["at"], ls=DASHES[layer["dashes"]], lw=layer["width"], **look)
        case "labels":
            for (x, y), words in zip(layer["points"], layer["texts"], strict=True):
                ax.annotate(words, (x, y), color=colour)
        case "marks":
            ends = ax.get_xaxis_transform()
            ax.plot(layer["positions"], [1.0] * len(layer["positions"]), "v", transform=ends, **look)


def _columns(rows: Any, count: int) -> list[list[float]]:
    """Return the columns of rows of numbers, NaN where a number is missing."""
    import math

    known = [[math.nan if value is None else value for value in row] for row in rows]
    return [[row[place] for row in known] for place in range(count)]
