# SPDX-License-Identifier: Apache-2.0
"""Observations and event functions of a mesh, cylindrical or bevel, from the sums of its flanks.

A normal force F along the base tangent has the torque -r_b F on both gears. The lever of friction is not
constant: friction acts along the tooth profile, its lever is the distance of the contact from the tangent
point of the line of action on each base circle, and it reverses at the pitch point. It is reported as two
torques about the axes of the gears.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.line_of_action import flank_phase
from pitchpoint.elements.mesh.record import EVENTS, OUTPUTS
from pitchpoint.elements.mesh.sums import FRICTION_ROWS
from pitchpoint.multibody.channels import F8, bounded

#: Observations of every mesh, first in its row.
OBSERVED = np.dtype([(name, "f8") for name, _, _ in OUTPUTS])
EVENT_ROW = np.dtype([(name, "f8") for name, _ in EVENTS])
FLANK_EVENTS = np.dtype([(name, "f8") for name in ("pair_entry", "pair_exit", "sliding_reversal")])
"""Event functions of one flank; those of the front flanks come first."""
_NAMES = [name for name, _ in EVENTS]
_FRONT = 8 * _NAMES.index("pair_entry")
_BACK = 8 * _NAMES.index("back_pair_entry")

_MIN_DISTANCE = 1e-15
"""Minimum magnitude [m] of a contact event function, so that its sign is defined."""
_AWAY = 10.0
"""Offset of the event functions of the flank farther from contact: suppresses their sign changes."""


@kernel
def observed(b):
    """Observations of every mesh, as a record."""
    return view(b["request"]["out"], 1, OBSERVED)[0]


@kernel
def clear(b, n_out):
    """Set all observations of a mesh to zero; `n_out` of its kind precede those of its pairs."""
    n = n_out + b["n_pair"] + 2 * b["rubs"]
    out = view(b["request"]["out"], n, F8)
    for k in range(n):
        out[k] = 0.0


@kernel
def add_flank(b, flank, force, parts, fed):
    """Add the sums of one flank to the observations; pair forces are written separately.

    `force`: along the base tangent [N]; `parts`: its circumferential, radial and axial component on gear 2
    [N]; `fed`: parametric power in addition to that of the nodes [W].
    """
    out = observed(b)
    sums = b["sums"]
    if sums["pushed"] > 0.0:
        out["contact_state"] = 2.0 if out["contact_state"] == 1.0 else float(flank)
    out["mesh_force"] += flank * force
    out["mesh_stiffness"] += sums["stiffness"]
    out["normal_force"] += sums["pushed"] * b["contact"]["normal"]
    out["circumferential_force"] += parts[0]
    out["radial_force"] += parts[1]
    out["axial_force"] += parts[2]
    out["friction_power"] += sums["friction_power"]
    out["damping_power"] += sums["damping_power"]
    out["parametric_power"] += sums["parametric_power"] + fed
    out["elastic_energy"] += sums["energy"]


@kernel
def write_mesh(b, e_rate, psi, damper, rate):
    """Write the observations that do not depend on the flank; add damper force and power."""
    now = b["now"]
    out = observed(b)
    x = now["u"] - now["e_t"]
    out["transmission_error"] = now["u"]
    out["deflection"] = x
    out["mesh_force"] += damper
    out["mesh_phase"] = psi
    out["damping_power"] += damper * rate
    out["parametric_power"] -= damper * e_rate
    out["backlash"] = now["gap"]
    out["penetration"] = (abs(x) - 0.5 * now["gap"]) / b["contact"]["normal"]


@kernel
def add_pair_force(b, n_out, slot, force):
    """Add the force of a tooth pair, front flank positive [N]."""
    view(b["request"]["out"] + 8 * n_out, b["n_pair"], F8)[slot] += force


@kernel
def add_friction_torques(b, n_out, f, g):
    """Add the friction torques (last rows of the basis) if the mesh observes them."""
    if b["rubs"] == 0 or b["contact"]["mu"] == 0.0:
        return
    out = view(b["request"]["out"] + 8 * (n_out + b["n_pair"]), 2, F8)
    rows = b["lever"].size
    for p in range(rows - FRICTION_ROWS, rows):
        s = b["sums"]["force"][p]
        for k in range(3):
            out[0] += s * b["basis_i"][p, 3 + k] * f["R"][k, 2]
            out[1] += s * b["basis_j"][p, 3 + k] * g["R"][k, 2]


@kernel
def contact_event(distance, force):
    """Contact event function from a distance [m]: positive if the flank has a force, else negative."""
    return max(distance, _MIN_DISTANCE) if force > 0.0 else min(distance, -_MIN_DISTANCE)


@kernel
def _nearest_pitch(psi):
    """Distance from the nearest whole base pitch, in [-1/2, 1/2]."""
    return psi - math.floor(psi + 0.5)


@kernel
def write_events(b, x, front, back, leaves):
    """Write the event functions at the deflection x [m]; see `mesh.record`. `front`, `back`: contact events.

    `leaves`: path position at which a pair leaves contact [base pitches].
    """
    now = b["now"]
    where = b["request"]["ev"]
    ev = view(where, 1, EVENT_ROW)[0]
    ev["front_gap"] = front
    ev["back_gap"] = back
    ev["turning_reversal"] = bounded(now["travel_rate"])
    for flank in (1, -1):
        of_flank = view(where + (_FRONT if flank > 0 else _BACK), 1, FLANK_EVENTS)[0]
        away = _AWAY if flank * x < 0.0 else 0.0
        psi = flank_phase(b, flank)
        of_flank["pair_entry"] = away + _nearest_pitch(psi)
        of_flank["pair_exit"] = away + _nearest_pitch(psi - leaves)
        of_flank["sliding_reversal"] = away + _nearest_pitch(psi + now["xi_A"] / b["p_bt"])
