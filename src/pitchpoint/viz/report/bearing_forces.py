# SPDX-License-Identifier: Apache-2.0
"""Table of bearing forces: radial force with its direction, axial force, moment."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape

import numpy as np

from pitchpoint.analysis.statistics import signal_statistics
from pitchpoint.viz.quantities import Array, Channel, amount, number, scale
from pitchpoint.viz.tables import plain_table

QUANTITY = "bearing_force"
ROTATES = 0.1
"""Largest ratio of the mean vector to the mean radial force at which no direction is given."""

NOTHING = 1e-8
"""Forces and moments [N, N m] relative to the largest radial force [N] that count as round-off."""


@dataclass(frozen=True)
class BearingForce:
    """Force of one bearing on its shaft or inner ring over the window of the statistics [N, N m, rad].

    `mean`, `rms` (alternating part) and `maximum` are those of the radial force; `direction` is that of its
    mean vector, from the x axis of the bearing towards y, nan if the force rotates. Axial values are the
    signed mean and the largest absolute value; `moment` is the largest tilting moment.
    """

    mean: float
    rms: float
    maximum: float
    direction: float
    axial_mean: float
    axial_maximum: float
    moment: float


def with_resultants(found: Mapping[str, Channel]) -> dict[str, Channel]:
    """Channels with the radial and axial force of every bearing; results of older versions lack them.

    Examples
    --------
    >>> parts = {f"bearing_force[a.{c}]": Channel(f"bearing_force[a.{c}]", np.array([v]), "N")
    ...          for c, v in (("fx", 3.0), ("fy", 4.0), ("fz", 1.0))}
    >>> with_resultants(parts)["bearing_force[a.radial]"].values.tolist()
    [5.0]
    """
    whole = dict(found)
    for name in bearing_names(found):
        x, y, z = (found.get(f"{QUANTITY}[{name}.{c}]") for c in ("fx", "fy", "fz"))
        radial, axial = (f"{QUANTITY}[{name}.{word}]" for word in ("radial", "axial"))
        if radial not in whole and x is not None and y is not None:
            whole[radial] = Channel(radial, np.hypot(x.values, y.values), "N")
        if axial not in whole and z is not None:
            whole[axial] = Channel(axial, z.values, "N", statistics=z.statistics)
    return whole


def bearing_names(found: Mapping[str, Channel]) -> list[str]:
    """Bearings with forces, in the order of the channels."""
    own = [name for name in found if name.startswith(f"{QUANTITY}[")]
    return list(dict.fromkeys(name.partition("[")[2].rstrip("]").rpartition(".")[0] for name in own))


def bearing_forces(time: Array, found: Mapping[str, Channel], window: np.ndarray) -> dict[str, BearingForce]:
    """Forces of all bearings with a force other than zero.

    Parameters
    ----------
    time
        Times of the record [s], shape (n,).
    found
        Channels by name; see `with_resultants`.
    window
        Samples of the statistics, shape (n,), bool.
    """
    rows = {}
    for name in bearing_names(found):
        part = {c: found.get(f"{QUANTITY}[{name}.{c}]") for c in ("fx", "fy", "mx", "my", "radial", "axial")}
        radial, axial = part["radial"], part["axial"]
        if radial is None or not np.all(np.isfinite(radial.values)):
            continue
        across = _statistics(time, radial, window)
        along = _statistics(time, axial, window)
        moments = [c.values[window] for c in (part["mx"], part["my"]) if c is not None]
        row = BearingForce(
            mean=across["mean"],
            rms=across["rms"],
            maximum=across["max"],
            direction=_direction(part["fx"], part["fy"], window, across["mean"]),
            axial_mean=along["mean"],
            axial_maximum=max(abs(along["min"]), abs(along["max"])),
            moment=float(np.hypot(*moments).max()) if len(moments) == 2 else 0.0,
        )
        if row.maximum > 0.0 or row.axial_maximum > 0.0:
            rows[name] = row
    return rows


def bearing_table(rows: Mapping[str, BearingForce]) -> str:
    """HTML table of bearing forces, and the most loaded bearing in words; empty without bearings."""
    if not rows:
        return ""
    force = scale("N", [max(row.maximum, row.axial_maximum) for row in rows.values()])
    moment = scale("N m", [row.moment for row in rows.values()])
    size = max(row.maximum for row in rows.values())
    with_axial = any(row.axial_maximum > NOTHING * size for row in rows.values())
    with_moment = any(row.moment > NOTHING * size for row in rows.values())
    head = ["bearing", f"radial [{force.unit}], mean", "rms (alternating)", "maximum", "direction [°]"]
    head += [f"axial [{force.unit}], mean", "axial, maximum"] if with_axial else []
    head += [f"tilting moment [{moment.unit}], maximum"] if with_moment else []
    most = max(rows, key=lambda name: rows[name].maximum)
    body = []
    for name, row in rows.items():
        angle = np.degrees(row.direction)
        cells = [number(v * force.factor, 4) for v in (row.mean, row.rms, row.maximum)]
        cells.append("rotates" if np.isnan(angle) else number(float(round(angle)), 4))
        if with_axial:
            free = row.axial_maximum <= NOTHING * size
            cells += [
                "–" if free else number(v * force.factor, 4) for v in (row.axial_mean, row.axial_maximum)
            ]
        if with_moment:
            cells.append(number(row.moment * moment.factor, 4) if row.moment > NOTHING * size else "–")
        label = f"<b>{escape(name)}</b>" if name == most else escape(name)
        body.append(
            f'<tr><th scope="row">{label}</th>{"".join(f"<td class=num>{c}</td>" for c in cells)}</tr>'
        )
    words = f"Largest radial force: {amount(rows[most].maximum, 'N')}, {most}. " if len(rows) > 1 else ""
    words += (
        "Forces on the shaft; direction of the mean radial force in the plane normal to the shaft, "
        "from the x axis of the bearing towards its y axis."
    )
    return f"{plain_table(head, body, words=1)}<p>{escape(words)}</p>"


def _statistics(time: Array, channel: Channel | None, window: np.ndarray) -> Mapping[str, float]:
    """Statistics over all steps of the window if the run stored them, else over its samples."""
    if channel is None:
        return dict.fromkeys(("mean", "rms", "min", "max"), 0.0)
    known = channel.statistics or vars(signal_statistics(channel.values[window], time[window]))
    noise = 1e-10 * max(abs(known["min"]), abs(known["max"]))
    return {**known, "rms": known["rms"] if known["rms"] > noise else 0.0}


def _direction(x: Channel | None, y: Channel | None, window: np.ndarray, mean: float) -> float:
    """Direction of the mean vector [rad]; nan if the force rotates."""
    if x is None or y is None:
        return float("nan")
    along_x, along_y = (
        c.statistics["mean"] if c.statistics is not None else float(c.values[window].mean()) for c in (x, y)
    )
    return (
        float(np.arctan2(along_y, along_x)) if np.hypot(along_x, along_y) > ROTATES * mean else float("nan")
    )
