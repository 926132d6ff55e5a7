# SPDX-License-Identifier: Apache-2.0
"""Impacts and contact shares of the meshes, counted at every step of a time loop.

A contact that lasts a few steps only would be missed at the sample rate of the output, so the counters are
updated with the running statistics. A state applies from half-way to the preceding step to half-way to the
next one, as in `analysis.statistics.contact_statistics`; `analysis.rattle` has the definitions.

Loads of a mesh: along the base tangent, with the mesh force F and the mass m = J/r_b^2 of each gear, the
loads on the gears are P_1 = F + m_1 a_1 and P_2 = F + m_2 a_2, with the accelerations a = r_b alpha. With its
flanks held together the mesh would transmit F_c = (m_2 P_1 + m_1 P_2)/(m_1 + m_2) = F + m u'', with the
reduced mass m and the deflection u. Impacts of this mesh cancel in F_c.
"""

from __future__ import annotations

import math
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
        *((name, "f8") for name in ("r_b1", "r_b2", "mass_1", "mass_2", "mass")),  # [m], [kg]; inf if driven
        *((name, "f8") for name in ("forward_1", "reverse_1", "forward_2", "reverse_2")),  # of P_1, P_2
        *((name, "f8") for name in ("forward", "reverse", "force_most", "energy", "turned")),
        *((name, "i8") for name in ("flank", "changes")),
    ],
    align=True,
)

#: Numbers of `read_counts`.
CONTACT_NUMBERS = (
    *("front_impacts", "back_impacts", "impact_rate", "contact_frequency"),
    *("closing_speed_mean", "closing_speed_rms", "closing_speed_max", "impulse_mean", "impulse_max"),
    *("front_contact_share", "back_contact_share", "both_flanks_share", "contact_loss_share"),
    *("longest_loss", "shortest_contact", "resolution", "rattle_index"),
    *("load_reversal", "peak_force_ratio", "flank_changes_per_revolution", "impact_energy_per_revolution"),
)
STEADY = 0.05
"""Largest share of the opposite direction in a load that counts as a drag torque."""
FEWEST_TURNS = 0.5
"""Revolutions of gear 1 below which there are no numbers per revolution: it rocks."""


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
        _set_masses(row, system, record, driven)
    return counts


def _set_masses(row: np.void, system: System, record: np.void, driven: set[int]) -> None:
    """Set the masses of both gears on the base tangent, infinite for gears that no force accelerates."""
    inverse = 0.0
    for end, gear in (("i", 1), ("j", 2)):
        body = system.program["body"][int(record[end])]
        radius, polar = float(record[f"r_b{gear}"]), float(body["i_p"])
        free = body["joint"] != 0 and int(record[end]) not in driven and row[f"speed_{gear}_at"] >= 0
        row[f"r_b{gear}"] = radius
        row[f"mass_{gear}"] = polar / radius**2 if free and polar > 0.0 else np.inf
        inverse += 1.0 / float(row[f"mass_{gear}"])
    row["mass"] = 1.0 / inverse if inverse > 0.0 else 0.0


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
        c["turned"] += 0.5 * h * (c["speed_1"] + speed_1)
        _add_loads(c, 0.5 * h * (c["mesh_force"] + force), speed_1 - c["speed_1"], speed_2 - c["speed_2"])
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
    if state == 1 or state == -1:
        c["changes"] += 1 if state * c["flank"] == -1 else 0
        c["flank"] = state
    c["force_most"] = max(c["force_most"], abs(force))
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
def _add_loads(c, impulse, change_1, change_2):
    """Add the impulses of the loads over one step, from that of the mesh force and the changes of speed."""
    a_1 = c["r_b1"] * change_1
    a_2 = c["r_b2"] * change_2
    of_mesh = impulse + c["mass"] * (a_1 + a_2)
    c["forward"] += max(of_mesh, 0.0)
    c["reverse"] -= min(of_mesh, 0.0)
    if c["mass_1"] < math.inf:
        on_1 = impulse + c["mass_1"] * a_1
        c["forward_1"] += max(on_1, 0.0)
        c["reverse_1"] -= min(on_1, 0.0)
    if c["mass_2"] < math.inf:
        on_2 = impulse + c["mass_2"] * a_2
        c["forward_2"] += max(on_2, 0.0)
        c["reverse_2"] -= min(on_2, 0.0)


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
    c["energy"] += 0.5 * c["mass"] * (closing * c["normal"]) ** 2


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
    """Numbers of `analysis.rattle.Rattle` and of the loads by mesh; NaN without steps."""
    found: dict[str, dict[str, Any]] = {}
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
            **_of_loads(system, record, c, total),
        }
    return found


def _of_loads(system: System, record: np.void, c: np.void, total: float) -> dict[str, float]:
    """Numbers that require the inertia of the gears; NaN for gears on a carrier.

    Its line of centres rotates, so that the speeds of the gears are not those relative to it.
    """
    for end in "ij":
        row = against_the_base(system, record, end)
        if len(row) > 1 or not row.keys() <= turning(system, int(record[end])).keys():
            return dict.fromkeys(CONTACT_NUMBERS[-5:], float("nan"))
    either = float(c["forward"] + c["reverse"])
    turns = abs(float(c["turned"])) / (2.0 * math.pi)
    turns = turns if turns >= FEWEST_TURNS else float("nan")
    free = c["mass"] > 0.0 and either > 0.0
    return {
        "rattle_index": _index(c, float(c["momentum"]) / total),
        "load_reversal": _reversal(c["forward"], c["reverse"]) if free else float("nan"),
        "peak_force_ratio": float(c["force_most"]) * total / either if free else float("nan"),
        "flank_changes_per_revolution": int(c["changes"]) / turns,
        "impact_energy_per_revolution": float(c["energy"]) / turns,
    }


def _reversal(forward: float, reverse: float) -> float:
    """Impulse of a load in its rarer direction over that in the other one, 0 to 1."""
    larger = max(forward, reverse)
    return float(min(forward, reverse) / larger) if larger > 0.0 else 0.0


def _index(c: np.void, force: float) -> float:
    """Rattle index, see `analysis.rattle.rattle_index`.

    NaN without a mean force [N], without a gear that is free to rotate, and if the load on the idle gear
    changes its direction: it is not a drag torque.
    """
    mass, idle, other = min((float(c["mass_1"]), 1, 2), (float(c["mass_2"]), 2, 1))
    forward, reverse = (float(c[f"{way}_{idle}"]) for way in ("forward", "reverse"))
    if not np.isfinite(mass) or not abs(force) > 0.0 or _reversal(forward, reverse) > STEADY:
        return float("nan")
    r_b = float(c[f"r_b{other}"])
    return max(0.0, *(-mass * r_b * float(c[f"{end}_{other}"]) / force for end in ("least", "most")))


def _frequency(c: np.void) -> float:
    """Frequency with which contact of one flank begins, of that with more contacts [Hz]; 0 below two."""
    flank = "back" if c["backs"] > c["fronts"] else "front"
    count = int(c[f"{flank}s"])
    return (count - 1) / float(c[f"{flank}_last"] - c[f"{flank}_first"]) if count > 1 else 0.0


def _ratio(total: float, count: int) -> float:
    """Mean over a count; 0 without any."""
    return float(total) / count if count else 0.0
