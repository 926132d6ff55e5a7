# SPDX-License-Identifier: Apache-2.0
"""Impacts and contact shares of the meshes, counted at every step of a time loop.

A contact that lasts a few steps only would be missed at the sample rate of the output, so the counters are
updated with the running statistics. A state applies from half-way to the preceding step to half-way to the
next one, as in `analysis.statistics.contact_statistics`; `analysis.rattle` has the definitions.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.kind import DRIVE
from pitchpoint.solvers.step_choice import mesh_mode
from pitchpoint.solvers.torque_paths import against_the_base, turning
from pitchpoint.system.meshes import mesh_names, mesh_records

if TYPE_CHECKING:
    from pitchpoint.system.system import System

#: Counters of one mesh: places of its channels, the step before, sums.
COUNTS = np.dtype(
    [
        *((name, "i8") for name in ("state_at", "deflection_at", "force_at", "speed_1_at", "speed_2_at")),
        *((name, "i8") for name in ("begun", "state", "hit", "front_impacts", "back_impacts", "impulses")),
        *((name, "f8") for name in ("normal", "t", "deflection", "mesh_force", "speed_1", "speed_2")),
        *((name, "f8") for name in ("total", "front", "back", "both", "loss", "lost_at", "longest_loss")),
        *((name, "i8") for name in ("fronts", "backs")),
        *((name, "f8") for name in ("front_first", "front_last", "back_first", "back_last")),
        ("momentum", "f8"),
        *((name, "f8") for name in ("closing", "closing_squares", "closing_most")),
        *((name, "f8") for name in ("impulse", "impulse_sum", "impulse_most", "touched_at")),
        ("period", "f8"),  # natural period of the flanks in contact: impulses of longer contacts do not count
        *((name, "f8") for name in ("shortest_contact", "resolution")),
        *((name, "f8") for name in ("least_1", "most_1", "least_2", "most_2")),
    ],
    align=True,
)

#: Numbers of `read_counts`.
CONTACT_NUMBERS = (
    *("front_impacts", "back_impacts", "impact_rate", "contact_frequency"),
    *("closing_speed_mean", "closing_speed_rms", "closing_speed_max", "impulse_mean", "impulse_max"),
    *("front_contact_share", "back_contact_share", "both_flanks_share", "contact_loss_share"),
    *("longest_loss", "shortest_contact", "resolution", "rattle_index"),
)


def new_counts(system: System) -> NDArray[np.void]:
    """Counters of all meshes of a system at zero, shape (number of meshes,)."""
    names = mesh_names(system)
    driven = {int(record["i"]) for record in system.rows(DRIVE)}
    counts = np.zeros(len(names), COUNTS)
    known = {c.name: k for k, c in enumerate(system.layout.channels)}
    for row, name, record in zip(counts, names, mesh_records(system), strict=True):
        row["state_at"] = known[f"contact_state[{name}]"]
        row["deflection_at"], row["force_at"] = known[f"deflection[{name}]"], known[f"mesh_force[{name}]"]
        for gear, end in ((1, "i"), (2, "j")):
            body = system.layout.bodies[int(record[end])]
            row[f"speed_{gear}_at"] = known.get(f"speed[{body}]", -1)
        row["normal"] = record["contact"]["normal"]
        row["shortest_contact"] = np.inf
        frequency = mesh_mode(record, system, driven)
        row["period"] = 1.0 / frequency if frequency > 0.0 else np.inf
    return counts


@kernel
def count_contacts(t, row, counts):
    """Add one step of all meshes, from the channel values at t."""
    for m in range(counts.shape[0]):
        _count(t, row, counts[m])


@kernel
def _count(t, row, c):
    """Add one step of one mesh."""
    state = int(row[c["state_at"]])
    x = row[c["deflection_at"]]
    force = row[c["force_at"]]
    speed_1 = row[c["speed_1_at"]] if c["speed_1_at"] >= 0 else 0.0
    speed_2 = row[c["speed_2_at"]] if c["speed_2_at"] >= 0 else 0.0
    if c["begun"] != 0:
        h = t - c["t"]
        middle = c["t"] + 0.5 * h
        c["total"] += h
        c["resolution"] = max(c["resolution"], h)
        _add_share(c, c["state"], 0.5 * h)
        _add_share(c, state, 0.5 * h)
        _add_accelerations(c, (speed_1 - c["speed_1"]) / h, (speed_2 - c["speed_2"]) / h)
        c["momentum"] += 0.5 * h * (c["mesh_force"] + force)
        if c["hit"] != 0:
            c["impulse"] += 0.5 * h * abs(c["mesh_force"])
        if c["hit"] != 0 and (state == 0 or state * c["state"] == -1):
            _end_contact(c, middle)
        _begin_cycle(c, state, middle)
        if state == 0 and c["state"] != 0:
            c["lost_at"] = middle
        if c["state"] == 0 or state == 0:
            c["longest_loss"] = max(c["longest_loss"], (t if state == 0 else middle) - c["lost_at"])
        if state != 0 and c["state"] == 0:
            _begin_contact(c, state, abs(x - c["deflection"]) / (h * c["normal"]), middle)
        if c["hit"] != 0:
            c["impulse"] += 0.5 * h * abs(force)
    else:
        c["begun"] = 1
        c["lost_at"] = t
    c["t"] = t
    c["state"] = state
    c["deflection"] = x
    c["mesh_force"] = force
    c["speed_1"] = speed_1
    c["speed_2"] = speed_2


@kernel
def _add_share(c, state, h):
    """Add a duration [s] to the time of a contact state."""
    if state == 1:
        c["front"] += h
    elif state == -1:
        c["back"] += h
    elif state == 2:
        c["both"] += h
    else:
        c["loss"] += h


@kernel
def _add_accelerations(c, first, second):
    """Update the extremes of the angular accelerations [rad/s^2]."""
    c["least_1"] = min(c["least_1"], first)
    c["most_1"] = max(c["most_1"], first)
    c["least_2"] = min(c["least_2"], second)
    c["most_2"] = max(c["most_2"], second)


@kernel
def _begin_cycle(c, state, t):
    """Count the contacts of either flank that begin, after a separation or from the other flank."""
    before = c["state"]
    if (state == 1 or state == 2) and before != 1 and before != 2:
        c["front_first"] = t if c["fronts"] == 0 else c["front_first"]
        c["front_last"] = t
        c["fronts"] += 1
    if (state == -1 or state == 2) and before != -1 and before != 2:
        c["back_first"] = t if c["backs"] == 0 else c["back_first"]
        c["back_last"] = t
        c["backs"] += 1


@kernel
def _begin_contact(c, state, closing, t):
    """Count an impact with its closing speed [m/s]."""
    if state == -1:
        c["back_impacts"] += 1
    else:
        c["front_impacts"] += 1
    c["hit"] = 1
    c["impulse"] = 0.0
    c["touched_at"] = t
    c["closing"] += closing
    c["closing_squares"] += closing * closing
    c["closing_most"] = max(c["closing_most"], closing)


@kernel
def _end_contact(c, t):
    """Add a contact that began with an impact; its impulse, if the flanks rebounded at once."""
    c["hit"] = 0
    lasted = t - c["touched_at"]
    c["shortest_contact"] = min(c["shortest_contact"], lasted)
    if lasted <= c["period"]:
        c["impulses"] += 1
        c["impulse_sum"] += c["impulse"]
        c["impulse_most"] = max(c["impulse_most"], c["impulse"])


def read_counts(system: System, counts: NDArray[np.void]) -> dict[str, dict[str, Any]]:
    """Numbers of `analysis.rattle.Rattle` by mesh; NaN without steps."""
    found: dict[str, dict[str, Any]] = {}
    driven = {int(record["i"]) for record in system.rows(DRIVE)}
    for name, record, c in zip(mesh_names(system), mesh_records(system), counts, strict=True):
        total = float(c["total"])
        if not total > 0.0:
            found[name] = dict.fromkeys(CONTACT_NUMBERS, float("nan"))
            continue
        impacts = int(c["front_impacts"] + c["back_impacts"])
        found[name] = {
            "front_impacts": int(c["front_impacts"]),
            "back_impacts": int(c["back_impacts"]),
            "impact_rate": impacts / total,
            "contact_frequency": _frequency(c),
            "closing_speed_mean": _ratio(c["closing"], impacts),
            "closing_speed_rms": float(np.sqrt(_ratio(c["closing_squares"], impacts))),
            "closing_speed_max": float(c["closing_most"]),
            "impulse_mean": _ratio(c["impulse_sum"], int(c["impulses"])),
            "impulse_max": float(c["impulse_most"]),
            "front_contact_share": float(c["front"] + c["both"]) / total,
            "back_contact_share": float(c["back"] + c["both"]) / total,
            "both_flanks_share": float(c["both"]) / total,
            "contact_loss_share": float(c["loss"]) / total,
            "longest_loss": float(c["longest_loss"]),
            "shortest_contact": float(c["shortest_contact"]) if np.isfinite(c["shortest_contact"]) else 0.0,
            "resolution": float(c["resolution"]),
            "rattle_index": _index(system, record, c, float(c["momentum"]) / total, driven),
        }
    return found


def _index(system: System, record: np.void, c: np.void, force: float, driven: set[int]) -> float:
    """Rattle index, see `analysis.rattle.rattle_index`.

    NaN without a mean force [N], without a gear that is free to rotate, and for gears on a carrier.
    """
    for end in "ij":
        row = against_the_base(system, record, end)
        if len(row) > 1 or not row.keys() <= turning(system, int(record[end])).keys():
            return float("nan")  # the line of centres turns, also where one of the gears is fixed
    sides = []
    bodies = system.program["body"]
    for end, radius, gear in (("i", "r_b1", 1), ("j", "r_b2", 2)):
        body, r_b = int(record[end]), float(record[radius])
        free = bodies[body]["joint"] != 0 and body not in driven and c[f"speed_{gear}_at"] >= 0
        polar = float(bodies[body]["i_p"])
        sides.append((polar / r_b**2 if free and polar > 0.0 else np.inf, r_b, gear))
    (mass, r_b, _), (_, other_r_b, other) = sorted(sides)
    if not np.isfinite(mass) or not abs(force) > 0.0:
        return float("nan")
    needed = [-mass * other_r_b * float(c[f"{end}_{other}"]) / force for end in ("least", "most")]
    return max(0.0, *needed)


def _frequency(c: np.void) -> float:
    """Frequency with which contact of one flank begins, of that with more contacts [Hz]; 0 below two."""
    flank = "back" if c["backs"] > c["fronts"] else "front"
    count = int(c[f"{flank}s"])
    return (count - 1) / float(c[f"{flank}_last"] - c[f"{flank}_first"]) if count > 1 else 0.0


def _ratio(total: float, count: int) -> float:
    """Mean over a count; 0 without any."""
    return float(total) / count if count else 0.0
