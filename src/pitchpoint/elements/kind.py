# SPDX-License-Identifier: Apache-2.0
"""What the rest of the package knows about a kind of element: one description, in the module of the kind.

Solvers, scenes and power flows read these traits and name no kind. Traits are read while a system is
compiled or prepared, never in the loop over time steps.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

__all__ = [
    "ACROSS",
    "BETWEEN",
    "CLOSURE",
    "CLUTCH",
    "CONSTRAINT",
    "COORDINATE",
    "DRIVE",
    "EVERYWHERE",
    "FORCE",
    "FRAME",
    "FREE",
    "FRICTION",
    "GEARED",
    "HOLDS",
    "JOINT",
    "MESH",
    "MODAL",
    "MOTION",
    "NOTHING",
    "OWN",
    "RATIO",
    "RAYLEIGH",
    "RELATIVE",
    "SIGNAL",
    "SINGLE",
    "TOGETHER",
    "TORQUE",
    "WEIGHT",
    "WITH_MODES",
    "WITH_STATE",
    "Kind",
    "Power",
]

Rows: TypeAlias = tuple[tuple[str, str, str], ...]
"""Name, unit and long name of observations; ``{}`` in a name is replaced by that of the element."""

# --- channels: when the entry of a kind runs
FRAME, COORDINATE, CONSTRAINT, MOTION = "frame", "coordinate", "constraint", "motion"
FRICTION = "friction"
"""Channel of frame kinds that need all other wrenches and multipliers."""

# --- roles: what solvers search for; kinds of one role share the names of the record fields that are read
MESH = "mesh"
"""Teeth: the fields of `elements/mesh/bevel/record.py` that solvers read."""
DRIVE = "drive"
"""Prescribed motion of the coordinate q_i of body i."""
TORQUE, FORCE = "torque", "force"
"""Loads of the size `value` on body i, with their reaction on body j."""
CLUTCH = "clutch"
"""Dry friction that sticks: `ratio`, and the state k of those with bristles."""
SIGNAL = "signal"
"""Signals in the order of their evaluation (`elements/signals/record.py`)."""
RAYLEIGH = "rayleigh"
"""Damping matrix D of all coordinates."""
RATIO = "ratio"
"""Linear relation between rates: factors `c_i`, `c_j`, `c_k`."""
JOINT = "joint"
"""Friction of joints from the load that they carry: `mu`."""
CLOSURE = "closure"
"""Rows that close loops, whose multipliers are the loads of joints."""

# --- scopes: what the records of a kind act on
BETWEEN, SINGLE, EVERYWHERE = "between", "single", "everywhere"

# --- spins: what an element does to rotations about axes
FREE, TOGETHER, GEARED, HOLDS = "free", "together", "geared", "holds"

# --- resists: which rotations it resists
NOTHING, RELATIVE, ACROSS, OWN, WEIGHT = "nothing", "relative", "across", "own", "weight"

WITH_STATE = (("i", "j"), ("i", "k"), ("j", "k"))
"""Pairs of kinds whose state is the spin rate of a hidden body k."""
MODAL = ("i", "j", "k", "l", "m", *(f"m{n}" for n in range(5, 11)))
"""Fields of a floating frame, and of the bodies that carry its modal coordinates, three each."""
WITH_MODES = tuple((a, b) for n, a in enumerate(MODAL) for b in MODAL[n + 1 :])
"""Pairs of kinds that join a floating frame and all bodies that carry its modal coordinates."""


@dataclass(frozen=True)
class Power:
    """How the records of a kind appear in a power flow.

    Parameters
    ----------
    torque
        Channel of the torque on body i about its axis, ``{}`` for the name of the element; "" if the kind
        neither gives nor takes power on the mean, or is evaluated by its role.
    loss
        Name of the loss that makes up the difference between both sides.
    source
        Word for an element that brings power from outside, such as "load"; "" for one that passes it on
        from body i to body j.
    where
        Whether a record passes power on; all do if omitted.
    """

    torque: str = ""
    loss: str = "damping"
    source: str = ""
    where: Callable[[np.void], bool] | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
class Kind:
    """Description of a kind of element, as the constant ``KIND`` of its module.

    Parameters
    ----------
    name
        Unique name, that of the module; kinds run in alphabetical order, so sums are reproducible.
    channel
        FRAME, COORDINATE, CONSTRAINT, MOTION or FRICTION.
    record
        Aligned dtype of int64, float64 and nested arrays. Its first fields are i, j, ii, ij, ji, jj (bodies
        and pair blocks; filled in by the layout), its last is out, the index of its first observation. Some
        more names have a meaning: row and ev (first row and first event), pool (address of a float array),
        law (address of a user law).
    entry
        Kernel with the signature ``int64 entry(int64 ctl, int64 records, int64 n)``.
    outputs
        Observations per record, or a function that gives those of one record.
    pairs
        Pairs of record fields that hold interacting bodies.
    paired
        Fields of bodies all of which interact; their blocks go to the field `pairs` of the record.
    modal
        Fields of hidden bodies that carry modal coordinates of an elastic body.
    rows, row_unit
        Number of constraint rows per record, and the unit of what they are off by, of one record.
    events, bends
        Event functions per record; of one record those at whose zeros forces jump or bend (all if omitted).
    exact
        Entries that only exact tangents call, by the record field of their address.
    some
        Entries that only records with some field other than 0 call: by the record field of their address,
        with the name of the other field.
    body_fixed
        Whether it reads the frames S of its bodies, which turn with their spin.
    role
        What solvers search for, such as MESH; most kinds have none.
    scope
        BETWEEN: joins its bodies. SINGLE: acts on body i alone. EVERYWHERE: acts on all coordinates.
    massless
        Whether it is known to have no inertia, so that accelerations mean nothing to it.
    spins
        FREE: keeps no body from turning about its axis. TOGETHER: both bodies turn together. GEARED: they
        turn in a ratio. HOLDS: anything else. A word, or a function of the record.
    resists
        Rotations from which it keeps the bodies. RELATIVE: of one end against the other (default of HOLDS).
        ACROSS: the same but about the axis of body i. OWN: of body i about its axis. WEIGHT: of all whose
        centre of mass is off the axis. NOTHING (default of all others). A word, or a function of the
        record.
    lets_turn
        Ends, of one record, that may turn about their axis although it resists other rotations.
    linear
        Whether its linearisation is the same at all times, so that `reduce` may condense it: true or false,
        or a function of the record and of whether one of its bodies has a spin of its own.
    large
        Whether its kernel holds for large motions, so that it stays where both its bodies stay.
    fine
        Whether it brings modes far above what excites them.
    excites
        Whether its forces change by themselves, so that time steps follow the modes that it moves.
    sections
        Sections of the model file whose components become records, with the name of the schematic that
        represents them in a scene (`report.scene.connections.SCHEMATICS`); "" if there is none.
    label
        Word for it next to the name of an element; a word, or a function of the record.
    title, plural
        Its name in words, if that differs from `name`, and a word for several of them.
    main
        Whether lists of stiffness show it first, and with no stiffness too.
    names_modes
        Whether a mode may be named after it.
    arrow
        How its force ``bearing_force[NAME.fx]`` … is drawn: "bearing" in the axes B at zi, "ring" in those of
        the second ring, "" if it is not. A word, or a function of the record.
    power
        How it appears in a power flow; None: it may take or give power that is not followed.
    law_call
        Last call of the user law of a record, so that a failed call can be repeated in Python: a function of
        the record, the frames, the pool of the kind and the time [s] that gives the second argument of the
        law and the position and number of its parameters in the pool. None: the kind has no user laws.
    """

    name: str
    channel: str
    record: np.dtype[Any]
    entry: Any
    outputs: Rows | Callable[[np.void], Rows] = ()
    pairs: tuple[tuple[str, str], ...] = (("i", "j"),)
    paired: tuple[str, ...] = ()
    modal: tuple[str, ...] = ()
    rows: int = 0
    row_unit: Callable[[np.void], str] = field(default=lambda record: "")
    events: tuple[tuple[str, str], ...] = ()
    bends: Callable[[np.void], tuple[str, ...]] | None = None
    exact: Mapping[str, Any] = field(default_factory=dict)
    some: Mapping[str, tuple[Any, str]] = field(default_factory=dict)
    body_fixed: bool = False
    role: str = ""
    scope: str = BETWEEN
    massless: bool = False
    spins: str | Callable[[np.void], str] = HOLDS
    resists: str | Callable[[np.void], str] | None = None
    lets_turn: Callable[[np.void], tuple[str, ...]] = field(default=lambda record: ())
    linear: bool | Callable[[np.void, bool], bool] = False
    large: bool = False
    fine: bool = False
    excites: bool = True
    sections: Mapping[str, str] = field(default_factory=dict)
    label: str | Callable[[np.void], str] = ""
    title: str = ""
    plural: str = ""
    main: bool = False
    names_modes: bool = True
    arrow: str | Callable[[np.void], str] = ""
    power: Power | None = None
    law_call: Callable[[np.void, Any, Any, float], tuple[float, int, int]] | None = None

    @property
    def module(self) -> str:
        """Name of the module that its entry is written in."""
        return str(self.entry.__module__)

    @property
    def ends(self) -> tuple[str, ...]:
        """Record fields of all its bodies."""
        return tuple(dict.fromkeys(end for pair in self.pairs for end in pair))

    def outputs_of(self, record: np.void) -> Rows:
        """Observations of one record."""
        return self.outputs(record) if callable(self.outputs) else self.outputs

    def bends_of(self, record: np.void) -> tuple[str, ...]:
        """Event functions of one record at whose zeros forces jump or bend."""
        return self.bends(record) if self.bends is not None else tuple(event[0] for event in self.events)

    def spins_of(self, record: np.void) -> str:
        """What one record does to rotations about axes."""
        return self.spins(record) if callable(self.spins) else self.spins

    def resists_of(self, record: np.void) -> str:
        """Which rotations one record resists."""
        if self.resists is None:
            return RELATIVE if self.spins_of(record) == HOLDS else NOTHING
        return self.resists(record) if callable(self.resists) else self.resists

    def is_linear(self, record: np.void, spinning: bool) -> bool:
        """Whether the linearisation of one record is the same at all times."""
        return self.linear(record, spinning) if callable(self.linear) else self.linear

    def label_of(self, record: np.void) -> str:
        """Word for one record."""
        found = self.label(record) if callable(self.label) else self.label
        return found or self.words

    def arrow_of(self, record: np.void) -> str:
        """How the force of one record is drawn."""
        return self.arrow(record) if callable(self.arrow) else self.arrow

    @property
    def words(self) -> str:
        """Its name in words."""
        return self.title or self.name.replace("_", " ")
