# SPDX-License-Identifier: Apache-2.0
"""The same system with something switched off: friction of flanks and joints, loads."""

from __future__ import annotations

from pitchpoint.elements.kind import FORCE, JOINT, MESH, TORQUE
from pitchpoint.elements.signal import set_constant
from pitchpoint.system.system import System


def without_friction(system: System, joints: bool = False) -> System:
    """The same system with frictionless flanks, and frictionless joints if wanted.

    Sliding friction follows the normal force but acts across it: in a stiffness matrix it would feed energy
    into modes that real sliding does not.
    """
    rough = [k for k in system.kinds(MESH) if system.records[k]["contact"]["mu"].any()]
    smooth = {kind: system.records[kind].copy() for kind in rough}
    for records in smooth.values():
        records["contact"]["mu"] = 0.0
    for kind in system.kinds(JOINT) if joints else ():
        smooth[kind] = system.records[kind].copy()
        smooth[kind]["mu"] = 0.0
    return system.with_params(smooth) if smooth else system


def without_loads(system: System) -> System:
    """The same system with its torques and forces at zero."""
    loads = {kind: system.records[kind].copy() for role in (TORQUE, FORCE) for kind in system.kinds(role)}
    for records in loads.values():
        for record in records:
            set_constant(record, 0.0)
    return system.with_params(loads)
