# SPDX-License-Identifier: Apache-2.0
"""The list of element kinds: where each lives, in which channel it works, which bodies it joins.

A kind is imported only when a model uses it. Other packages add kinds by an entry point in the group
``pitchpoint.kinds`` that names a `Kind`, or by calling `register`. A kind's module has

* ``RECORD``, an aligned dtype of int64, float64 and nested arrays, whose first fields are i, j, ii, ij, ji,
jj
  (bodies, pair blocks; filled by the layout) and whose last is out, the index of its first observation;
* ``entry``, the kernel with the uniform signature ``int64 entry(int64 ctl, int64 records, int64 n)``;
* ``OUTPUTS``, tuple of (name, unit, long name) per record; ``{}`` in the name stands for the element's name;
* optionally ``SPINS``: "free" if it keeps no body from turning about its axis, "together" if both its bodies
  turn together; otherwise it counts as holding them (see `solvers.trains`),
* optionally ``BODY_FIXED = True``, if it reads the frames S of its bodies,
* optionally ``bends(record)``, names of the event functions at whose zeros forces jump or bend; without it
  all count (see `solvers.event_watch`),
* optionally ``EXACT``, entries that only exact tangents call, by the record field of their address,
* optionally ``SOME``, entries that only records with some field other than 0 call: by the record field of
  their address, with the name of the other field, and
* optionally ``EVENTS`` (the same for event functions, first index in the field event), ``ROWS`` (constraint
rows
  per record, first index in the field row) and ``pool`` among the fields (address of a float array).
"""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from types import ModuleType

from pitchpoint.core.errors import CompileError

FRAME, COORDINATE, CONSTRAINT, MOTION = "frame", "coordinate", "constraint", "motion"
FRICTION = "friction"
"""Channel of frame kinds that need all other wrenches and multipliers."""


@dataclass(frozen=True)
class Kind:
    """One row of the registry.

    Parameters
    ----------
    name
        Unique name; kinds run in alphabetical order, so sums are reproducible.
    module
        Dotted name of the module with RECORD and entry.
    channel
        "frame", "coordinate", "constraint", "motion" or "friction".
    pairs
        Pairs of record fields that hold interacting bodies.
    """

    name: str
    module: str
    channel: str
    pairs: tuple[tuple[str, str], ...] = (("i", "j"),)

    def load(self) -> ModuleType:
        """Import the module of the kind."""
        return importlib.import_module(self.module)


_HERE = "pitchpoint.elements."
WITH_STATE = (("i", "j"), ("i", "k"), ("j", "k"))
"""Pairs of kinds whose state is the spin rate of a hidden body k."""
MODAL = ("i", "j", "k", "l", "m", *(f"m{n}" for n in range(5, 11)))
"""Fields of a floating frame, and of the bodies that carry its modal coordinates, three each."""
WITH_MODES = tuple((a, b) for n, a in enumerate(MODAL) for b in MODAL[n + 1 :])
"""Pairs of kinds that join a floating frame and all bodies that carry its modal coordinates."""
_KINDS: dict[str, Kind] = {
    k.name: k
    for k in (
        Kind("ball_on_surface", _HERE + "ball_on_surface", CONSTRAINT),
        Kind("beam", _HERE + "beam", FRAME),
        Kind("bearing", _HERE + "bearing", FRAME),
        Kind("bevel_mesh", _HERE + "bevel_mesh", FRAME),
        Kind("bushing", _HERE + "bushing", FRAME),
        Kind("clearance_bearing", _HERE + "clearance_bearing", FRAME),
        Kind("closure", _HERE + "closure", CONSTRAINT),
        Kind("coupling", _HERE + "coupling", FRAME),
        Kind("curve_curve", _HERE + "curve_curve", FRAME),
        Kind("curve_on_curve", _HERE + "curve_on_curve", CONSTRAINT),
        Kind("damping", _HERE + "damping", COORDINATE),
        Kind("drive", _HERE + "drive", CONSTRAINT),
        Kind("flexible_body", _HERE + "flexible_body", FRAME, WITH_MODES),
        Kind("force", _HERE + "force", FRAME),
        Kind("friction_clutch", _HERE + "friction_clutch", FRAME, WITH_STATE),
        Kind("gear_mesh", _HERE + "gear_mesh", FRAME),
        Kind("gravity", _HERE + "gravity", FRAME),
        Kind("guide", _HERE + "guide", MOTION),
        Kind("joint_friction", _HERE + "joint_friction", FRICTION),
        Kind("linear_hold", _HERE + "linear_hold", COORDINATE),
        Kind("linear_modes", _HERE + "linear_modes", COORDINATE),
        Kind("linear_part", _HERE + "linear_part", COORDINATE),
        Kind("loose_bearing", _HERE + "loose_bearing", FRAME),
        Kind("maxwell", _HERE + "maxwell", FRAME, WITH_STATE),
        Kind("point_curve", _HERE + "point_curve", FRAME),
        Kind("point_on_curve", _HERE + "point_on_curve", CONSTRAINT),
        Kind("point_surface", _HERE + "point_surface", FRAME),
        Kind("ratio", _HERE + "ratio", CONSTRAINT, (("i", "j"), ("i", "k"))),
        Kind("rolling_bearing", _HERE + "rolling_bearing", FRAME),
        Kind("shaft_beam", _HERE + "shaft_beam", FRAME),
        Kind("signal", _HERE + "signal_flow", FRAME),
        Kind("signal_of_loads", _HERE + "signal_flow", FRICTION),
        Kind("spring_damper", _HERE + "spring_damper", FRAME),
        Kind("surface_surface", _HERE + "surface_surface", FRAME),
        Kind("torque", _HERE + "torque", FRAME),
        Kind("torsion_maxwell", _HERE + "torsion_maxwell", FRAME, WITH_STATE),
    )
}
MASSLESS = frozenset(
    {
        *(
            "bearing",
            "bevel_mesh",
            "bushing",
            "clearance_bearing",
            "coupling",
            "damping",
            "force",
            "gear_mesh",
        ),
        *("gravity", "rolling_bearing", "spring_damper", "torque"),
        *("closure", "drive", "ratio"),
    }
)
"""Kinds that are known to have no inertia of their own, so that no acceleration means anything to them; every
other kind may have some."""


def register(kind: Kind) -> None:
    """Add a kind at run time; an existing name is refused."""
    if kind.name in _KINDS and _KINDS[kind.name] != kind:
        raise CompileError(f"the kind {kind.name!r} is registered already ({_KINDS[kind.name].module})")
    if kind.channel not in (FRAME, COORDINATE, CONSTRAINT, MOTION, FRICTION):
        raise CompileError(f"the kind {kind.name!r} names no known channel: {kind.channel!r}")
    _KINDS[kind.name] = kind


def find(name: str) -> Kind:
    """Look a kind up; entry points of other packages are searched only when the name is not known yet."""
    if name not in _KINDS:
        from importlib.metadata import entry_points

        for point in entry_points(group="pitchpoint.kinds"):
            found = point.load()
            if isinstance(found, Kind) and found.name == name:
                register(found)
    if name not in _KINDS:
        raise CompileError(f"no element kind is called {name!r}; known: {', '.join(sorted(_KINDS))}")
    return _KINDS[name]


def names() -> tuple[str, ...]:
    """Names of all kinds known so far, sorted."""
    return tuple(sorted(_KINDS))
