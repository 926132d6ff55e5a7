# SPDX-License-Identifier: Apache-2.0
"""Additional masses on shafts: rigid bodies on rigid couplings."""

from __future__ import annotations

from pitchpoint.io.rexs.conversion.bearings import LINEAR_DAMPING, RIGID, RIGID_TILT, stiffness_entry
from pitchpoint.io.rexs.conversion.shafts import axes_of
from pitchpoint.io.rexs.conversion.state import Conversion, Seat, q, vector
from pitchpoint.io.rexs.document import RexsComponent

STIFFNESS = {"radial": RIGID, "axial": RIGID, "tilt": RIGID_TILT, "torsion": RIGID_TILT}


def convert_mass(conversion: Conversion, mass: RexsComponent) -> None:
    """Add a mass with moments of inertia to its shaft; without them it is listed as ignored."""
    shaft = conversion.owner(mass, "shaft")
    seat = None if shaft is None else conversion.seats.get(shaft.id)
    if seat is None:
        conversion.ignored(mass, "all", "it is on no shaft of the model")
        return
    name = conversion.name(mass)
    path = f"bodies.{name}"
    kilograms = conversion.number(mass, "mass_of_component", f"{path}.mass")
    polar = conversion.number(mass, "moment_of_inertia_u_axis", f"{path}.inertia")
    across = [
        conversion.number(mass, f"moment_of_inertia_{a}_axis", f"{path}.transverse_inertia") for a in "vw"
    ]
    given = [value for value in across if value is not None and value > 0.0]
    if polar and polar > 0.0 and _of_rigid_body(conversion, mass, seat, (kilograms or 0.0, polar, given)):
        return
    if not kilograms or not polar or min(kilograms, polar) <= 0.0 or not given:
        conversion.ignored(mass, "all", "mass and moments of inertia about u, v and w are required")
        return
    if max(given) > min(given) or len(given) < 2:
        text = "mean about v and w" if len(given) == 2 else "the same about v and w"
        target = f"{path}.transverse_inertia"
        conversion.changed(mass, "moment_of_inertia_v_axis", text, target, "bodies are round")
    u = conversion.number(mass, "u_coordinate_on_shaft")
    if u is None:
        u = 0.0
        conversion.default(mass, "u_coordinate_on_shaft", "0 mm", f"couplings.{name}.position")
    values = {
        "motion": "free",
        "position": vector(seat.point(u)),
        **axes_of(seat.frame),
        "mass": q(kilograms, "mass"),
        "inertia": q(polar, "inertia"),
        "transverse_inertia": q(sum(given) / len(given), "inertia"),
    }
    conversion.put("bodies", mass, values, name)
    entry = {
        "bodies": [seat.body, name],
        "position": [0, 0, q(seat.place(u), "length")],
        "stiffness": stiffness_entry(STIFFNESS),
        "damping": {"ratio": LINEAR_DAMPING},
    }
    conversion.data.setdefault("couplings", {})[name] = entry
    conversion.default(mass, "stiffness", "rigid", f"couplings.{name}.stiffness", "fixed to its shaft")


def _of_rigid_body(
    conversion: Conversion, mass: RexsComponent, seat: Seat, values: tuple[float, float, list[float]]
) -> bool:
    """Give mass and moments of inertia to a shaft without sections and gears, which is a rigid body.

    Parameters
    ----------
    conversion, mass, seat
        The conversion, the additional mass, and the seat of its shaft.
    values
        Mass [kg], polar moment of inertia and those about v and w, if they are given [kg m^2].

    Returns
    -------
    bool
        False if the shaft is elastic, has gears or is fixed: then the mass is a body of its own.
    """
    body = conversion.data.get("bodies", {}).get(seat.body)
    if body is None or "gears" in body or "mass" in body or body["motion"] != "free":
        return False
    kilograms, polar, across = values
    path = f"bodies.{seat.body}"
    body["inertia"] = q(polar, "inertia")
    if not kilograms or not across:
        body["motion"] = "planar" if kilograms else "torsion"
        missing = "moments of inertia about v and w" if kilograms else "mass"
        conversion.default(mass, missing, body["motion"], f"{path}.motion", f"no {missing}")
    if kilograms:
        body["mass"] = q(kilograms, "mass")
    if kilograms and across:
        z = seat.place(conversion.number(mass, "u_coordinate_on_shaft") or 0.0)
        central = sum(across) / len(across)
        body["transverse_inertia"] = q(central + kilograms * z * z, "inertia")
        body["center_of_mass"] = q(z, "length")
    conversion.done.add(mass.id)
    return True
