# SPDX-License-Identifier: Apache-2.0
"""Remarks on given keys that have no effect because of other keys.

A remark is exact: without the key no result changes, or the remark names the remaining effect. Data that the
motion of a part does not need, such as the mass of a body that only spins, are not reported: they are used
with another motion.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.words import listed
from pitchpoint.model.checks.forces import TURNING
from pitchpoint.model.checks.references import ends_of
from pitchpoint.model.components.flank_contact import FlexibleContact, PrecomputedContact, RigidContact
from pitchpoint.model.components.joint import FUNCTIONS
from pitchpoint.model.components.law import Constant
from pitchpoint.model.components.stiffness import OF_PAIRS, Din3990, Energy, Hertz
from pitchpoint.model.frames import ALONG, body_frame
from pitchpoint.model.keys import defaults_of
from pitchpoint.model.mechanism import coordinate
from pitchpoint.model.remarks.flank_contact import contact_keys
from pitchpoint.model.remarks.supports import idle_springs, idle_supports
from pitchpoint.model.scenario import ERROR_METHODS, EXPLICIT_METHODS, STIFF_METHODS
from pitchpoint.model.signals import signals_without_effect

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.mesh import ContactDamping, Mesh
    from pitchpoint.model.components.stiffness import StiffnessLaw
    from pitchpoint.model.model import Model

#: Inertias required by each motion, by their keys in the body and in the gear.
POLAR, MASS = ("inertia", "polar_inertia"), ("mass", "mass")
TRANSVERSE = ("transverse_inertia", "transverse_inertia")
NEEDS: dict[str, tuple[tuple[str, str], ...]] = {
    "fixed": (),
    "torsion": (POLAR,),
    "planar": (POLAR, MASS),
    "free": (POLAR, MASS, TRANSVERSE),
    "joint": (POLAR, MASS, TRANSVERSE),
}

#: Keys of a scenario that only a time response reads.
TIME_KEYS = (
    "sample_rate",
    "settle_time",
    "statistics",
    "step",
    "method",
    "form",
    "order",
    "tolerance",
    "events",
    "channels",
)


def keys_without_effect(model: Model) -> tuple[Message, ...]:
    """A remark for every key without effect."""
    return (
        *_frictions(model),
        *_width_integrals(model),
        *contact_keys(model),
        *_laws(model),
        *_blanks(model),
        *_inertias(model),
        *_joints(model),
        *idle_springs(model),
        *idle_supports(model),
        *_loads(model),
        *_scenarios(model),
        *_driven_starts(model),
        *signals_without_effect(model),
    )


def _only_spins(model: Model, mesh: Mesh) -> bool:
    """Whether the bodies of both gears spin only or are fixed; False for gears without a body."""
    bodies = [model.body_of(g) for g in mesh.gears]
    return None not in bodies and {model.bodies[str(b)].moves for b in bodies} <= {"torsion", "fixed"}


def _frictions(model: Model) -> Iterator[Message]:
    """Friction without effect: zero coefficients, and laws without sliding at the pitch point."""
    for name, mesh in model.every_mesh.items():
        if mesh.friction is None:
            continue
        at = f"{model.section_of(name)}.{name}"
        if mesh.friction.mu == 0.0 and mesh.friction.static:
            yield remark(f"{at}.friction.static", "has no effect with mu: 0, which disables all friction")
        if mesh.friction.mu > 0.0 and not mesh.law.of_pairs:
            yield remark(
                f"{at}.friction",
                f"the law {mesh.law.law} acts at the pitch point, where "
                "rolling teeth do not slide, so friction acts only on vibration and lateral motion",
                f"{listed(OF_PAIRS)} follow the contact along its path",
            )


def _width_integrals(model: Model) -> Iterator[Message]:
    """Slices that are not used, and slices of a law that is uniform over the face width."""
    for name, mesh in model.meshes.items():
        if mesh.contact is not None:
            continue  # contact planes
        law = mesh.law.law
        follows = mesh.law.of_pairs and any(model.gears[g].is_modified for g in mesh.gears)
        if mesh.width == "exact" and mesh.slices != defaults_of(type(mesh))["slices"] and not follows:
            yield remark(
                f"meshes.{name}.slices", "has no effect with width: exact", "write width: slices to use it"
            )
        elif mesh.width == "slices" and law not in OF_PAIRS and _only_spins(model, mesh):
            yield remark(
                f"meshes.{name}.width",
                f"has no effect as slices: the law {law} is uniform over the face width, "
                "and the bodies only spin",
            )


def _restitution(damping: ContactDamping, where: str) -> Iterator[Message]:
    """Keys of damping that have no effect with a restitution, and keys that require one."""
    usual = defaults_of(type(damping))
    if damping.restitution is None:
        if damping.speed != usual["speed"]:
            yield remark(f"{where}.speed", "has no effect without restitution")
        return
    for key in ("s_0", "law"):
        if getattr(damping, key) != usual[key]:
            yield remark(
                f"{where}.{key}", "has no effect with restitution, which damps in proportion to the force"
            )


def _laws(model: Model) -> Iterator[Message]:
    """Keys of stiffness, contact damping and tip circles that are overridden by others."""
    for name, mesh in model.every_mesh.items():
        law, damping, at = mesh.law, mesh.damping, f"{model.section_of(name)}.{name}"
        if isinstance(law, Din3990) and law.single_stiffness is not None and law.virtual_teeth != "iso":
            yield remark(
                f"meshes.{name}.stiffness.virtual_teeth",
                "has no effect on the stiffness: single_stiffness replaces the formula",
            )
        if isinstance(law, Hertz) and law.force is not None and law.diameter != "reference":
            yield remark(
                f"meshes.{name}.stiffness.diameter",
                "has no effect together with force and depth, which give K",
            )
        if damping is not None and damping.s_0 == 0.0 and damping.law != "linear":
            yield remark(f"{at}.damping.law", "has no effect with s_0: 0, where the damping acts immediately")
        if damping is not None:
            yield from _restitution(damping, f"{at}.damping")
    for name, gear in model.gears.items():
        if gear.tip_diameter is not None and gear.tip_alteration != 0.0:
            yield remark(
                f"gears.{name}.tip_alteration",
                "has no effect together with tip_diameter, which takes precedence",
            )


def _blanks(model: Model) -> Iterator[Message]:
    """Rim and web that affect neither the inertia nor the blank factor of DIN 3990 / ISO 6336."""
    for name, gear in model.gears.items():
        keys = [k for k in ("rim_thickness", "web_thickness") if getattr(gear, k) is not None]
        laws = {n: m.law for n, m in model.meshes.items() if name in m.gears}
        if not keys or not laws or model.body_of(name) is None:
            continue
        where = f"gears.{name}.{' and '.join(keys)}"
        weighs = _blank_weighs(model, name)
        energy = [n for n, law in laws.items() if isinstance(law, Energy)]
        if keys == ["rim_thickness"] and gear.type == "external":
            yield remark(
                where, "has no effect without web_thickness: a web of the face width makes a solid gear"
            )
        elif any(map(_elastic_blank, laws.values())) or _bends(gear):
            continue
        elif energy:
            yield remark(
                where,
                f"has no effect on the stiffness of {listed(energy)}: the law energy does not include "
                f"them{', only the inertia does' if weighs else ''}",
                "the law din3990 has a blank factor for them",
            )
        elif not weighs and not (gear.web_thickness is not None and any(map(_by_formula, laws.values()))):
            yield remark(
                where,
                f"has no effect on stiffness and motion: the stiffness of {listed(laws)} does not "
                "follow them, and the inertia is given",
            )


def _by_formula(law: StiffnessLaw) -> bool:
    """Whether a law computes the single tooth stiffness by the standard, including the blank factor."""
    if isinstance(law, RigidContact):
        return law.stiffness is None
    return isinstance(law, Din3990) and law.single_stiffness is None


def _elastic_blank(law: StiffnessLaw) -> bool:
    """Whether the blank is a part of the compliance of flexible teeth."""
    if isinstance(law, FlexibleContact):
        return law.body != "rigid" or law.teeth == "finite_elements"
    return isinstance(law, PrecomputedContact)


def _bends(gear: Gear) -> bool:
    """Whether the rim thickness determines the modes of a flexible rim."""
    return gear.flexible_rim is not None and gear.bore_diameter == 0.0


def _blank_weighs(model: Model, gear: str) -> bool:
    """Whether rim or web of a gear affect an inertia that is required by the motion of its body."""
    name = str(model.body_of(gear))
    body, part = model.bodies[name], model.gears[gear]
    # the inertia of a ring gear follows from the outside diameter, if given
    if part.type == "internal" and (part.rim_thickness is None or part.bore_diameter > 0.0):
        return False
    needed = NEEDS[body.moves]
    if part.solid is not None or body.solid is not None:
        return False
    if any(getattr(body, own) is None and getattr(part, of_gear) is None for own, of_gear in needed):
        return True
    # centre of mass of several gears, and the inertia of each about it
    return body.moves == "free" and len(body.gears) > 1 and part.mass is None


def _inertias(model: Model) -> Iterator[Message]:
    """Inertias of gears on bodies with given inertia."""
    for name, body in model.bodies.items():
        for gear in body.gears:
            for own, of_gear in (POLAR, TRANSVERSE):
                if getattr(body, own) is not None and getattr(model.gears[gear], of_gear) is not None:
                    yield remark(
                        f"gears.{gear}.{of_gear}",
                        f"has no effect on the motion together with bodies.{name}.{own}, "
                        "which applies to the whole body",
                    )


def _joints(model: Model) -> Iterator[Message]:
    """Keys of joints that do not apply to their type, joints without constraints, unused markers."""
    for name, joint in model.joints.items():
        if joint.lead is not None and joint.type != "screw":
            yield remark(
                f"joints.{name}.lead", f"has no effect with type: {joint.type}; only a screw has a lead"
            )
        for key in ("motion", "coordinates") if joint.type not in FUNCTIONS else ():
            if getattr(joint, key):
                yield remark(f"joints.{name}.{key}", f"has no effect with type: {joint.type}")
        if name in model.mechanism.cut and joint.type in ("free", "shaft"):
            yield remark(f"joints.{name}", "has no effect: it closes a loop and constrains nothing")
    given = [places for _, _, _, places in ends_of(model)]
    named = {e for places in given for e in ((places,) if isinstance(places, str) else places)}
    named |= {f"{load.body}.{load.marker}" for load in model.loads.values()}
    named |= {e for group in TURNING for part in getattr(model, group).values() for e in part.bodies}
    for body, part in model.bodies.items():
        for marker in part.markers if part.elastic is None else ():  # nodes also affect the modes
            if f"{body}.{marker}" not in named:
                group = "shafts" if part.shaft is not None else "bodies"
                yield remark(
                    f"{group}.{body}.markers.{marker}", f"has no effect: {body}.{marker} is not used"
                )


def _loads(model: Model) -> Iterator[Message]:
    """Positions of torques, and forces and moments in directions without motion."""
    for name, load in model.loads.items():
        if load.body not in model.bodies:
            continue  # a station of a beam moves in all directions
        motion = model.bodies[load.body].moves
        yield from _tilting(model, name)
        if load.force is None:
            idle = load.position if load.body not in model.shafts else load.position[:2]
            if any(v != 0.0 for v in idle):
                yield remark(
                    f"loads.{name}.position",
                    "has no effect on a torque or moment; it is the point of action of a force",
                )
            continue
        axis = abs(body_frame(model, load.body)[1][:, 2])
        k = int(axis.argmax())
        along = load.force[k]
        if (
            load.marker is None
            and motion in ("torsion", "planar")
            and axis[k] > ALONG  # a force is checked only if the axis is an axis of the world
            and not (isinstance(along, Constant) and along.value == 0.0)
        ):
            yield remark(
                f"loads.{name}.force",
                f"its component {'xyz'[k]} has no effect: {load.body} has motion: "
                f"{motion} and neither moves along its axis nor tilts",
            )


def _tilting(model: Model, name: str) -> Iterator[Message]:
    """Components of a moment across the axis of a body that does not tilt."""
    load = model.loads[name]
    motion = model.bodies[load.body].moves
    if motion not in ("torsion", "planar") or load.along == "marker":
        return
    axis = abs(body_frame(model, load.body)[1][:, 2])
    for k, part in enumerate(load.moment or ()):
        if axis[k] < 1.0 - ALONG and not (isinstance(part, Constant) and part.value == 0.0):
            yield remark(
                f"loads.{name}.moment",
                f"its component {'xyz'[k]} has no effect: {load.body} has motion: {motion} and does not tilt",
            )


def _scenarios(model: Model) -> Iterator[Message]:
    """Keys of a time response in sweeps and quasi-static rolls, and keys that the chosen method ignores."""
    for name, scenario in model.scenarios.items():
        kind = scenario.kind
        if model.line(("load_case",)) and scenario.load_case not in (None, model.load_case):
            yield remark(
                f"scenarios.{name}.load_case",
                f"has no effect: {model.load_case}, load_case of the file, applies to all scenarios",
                "remove load_case of the file",
            )
        keys = [k for k in TIME_KEYS if getattr(scenario, k) != defaults_of(type(scenario))[k]]
        if kind == "sweep" and scenario.speed:
            keys.append("speed")
        if kind != "time" and keys:
            yield remark(
                f"scenarios.{name}",
                f"{listed(keys)} {'have' if keys[1:] else 'has'} no effect with {kind}",
                "the sign of sweep.speed gives the direction of rotation" if "speed" in keys else None,
            )
            continue
        if "tolerance" in keys and scenario.method not in ERROR_METHODS:
            yield remark(
                f"scenarios.{name}.tolerance",
                f"has no effect with method: {scenario.method}, which uses constant steps",
                "give step, or write method: runge_kutta",
            )
        if "form" in keys and scenario.method in EXPLICIT_METHODS:
            yield remark(
                f"scenarios.{name}.form",
                f"has no effect with method: {scenario.method}, which enforces constraints on accelerations",
            )
        if "order" in keys and scenario.method not in STIFF_METHODS:
            yield remark(
                f"scenarios.{name}.order",
                f"has no effect with method: {scenario.method}",
                f"methods with selectable order are {listed(STIFF_METHODS)}",
            )


def _driven_starts(model: Model) -> Iterator[Message]:
    """Initial values and rates of joint coordinates that a scenario drives."""
    for name, scenario in model.scenarios.items():
        for word, drive in scenario.drive.items():
            found = coordinate(model.mechanism, model, word)
            if isinstance(found, str):
                continue
            seat = model.mechanism.seats[found[0]]
            own = seat.coordinates[found[1]]
            for key in ("start", "speed") if seat.joint is not None else ():
                idle = key == "speed" or drive.value is not None  # a speed continues from the start
                if idle and own in getattr(model.joints[str(seat.joint)], key):
                    yield remark(
                        f"joints.{seat.joint}.{key}",
                        f"{own} has no effect in {name}, where the drive of {word} determines it",
                    )
