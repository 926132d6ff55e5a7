# SPDX-License-Identifier: Apache-2.0
"""Description of a kind of element: one constant in the module of the kind, read by the rest of the package.

Solvers, scenes and power flows use these traits instead of names of kinds. Traits are read while a system is
compiled or prepared, never in the time-step loop.
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
    "RIM",
    "SIGNAL",
    "SINGLE",
    "TOGETHER",
    "TORQUE",
    "WEIGHT",
    "WITH_MODES",
    "WITH_RIM",
    "WITH_STATE",
    "Kind",
    "Power",
]

Rows: TypeAlias = tuple[tuple[str, str, str], ...]
"""Name, unit and long name of observations; ``{}`` in a name is replaced by the name of the element."""

# --- channels: when the entry point of a kind runs
FRAME, COORDINATE, CONSTRAINT, MOTION = "frame", "coordinate", "constraint", "motion"
FRICTION = "friction"
"""Channel of frame kinds that need all other wrenches and multipliers."""

# --- roles: search keys of solvers; kinds of one role share the names of the record fields that are read
MESH = "mesh"
"""Gear meshes: the fields of `elements/mesh/bevel/record.py` that solvers read."""
DRIVE = "drive"
"""Prescribed motion of the coordinate q_i of body i."""
TORQUE, FORCE = "torque", "force"
"""Loads of magnitude `value` on body i, with reaction on body j."""
CLUTCH = "clutch"
"""Dry friction with sticking: `ratio`, and the state k of bristle models."""
SIGNAL = "signal"
"""Signals in the order of their evaluation (`elements/signals/record.py`)."""
RAYLEIGH = "rayleigh"
"""Damping matrix D of all coordinates."""
RATIO = "ratio"
"""Linear relation between speeds: factors `c_i`, `c_j`, `c_k`."""
JOINT = "joint"
"""Load-dependent joint friction: `mu`."""
CLOSURE = "closure"
"""Loop-closing rows, whose multipliers are joint reactions."""

# --- scopes: on what the records of a kind act
BETWEEN, SINGLE, EVERYWHERE = "between", "single", "everywhere"

# --- spins: effect on rotations about the body axes
FREE, TOGETHER, GEARED, HOLDS = "free", "together", "geared", "holds"

# --- resists: rotations that the element resists
NOTHING, RELATIVE, ACROSS, OWN, WEIGHT = "nothing", "relative", "across", "own", "weight"

WITH_STATE = (("i", "j"), ("i", "k"), ("j", "k"))
"""Pairs of kinds whose state is the spin rate of a hidden body k."""
MODAL = ("i", "j", "k", "l", "m", *(f"m{n}" for n in range(5, 11)))
"""Fields of a floating frame and of the hidden bodies of its modal coordinates, three each."""
WITH_MODES = tuple((a, b) for n, a in enumerate(MODAL) for b in MODAL[n + 1 :])
"""Pairs of kinds that couple a floating frame and all hidden bodies of its modal coordinates."""
RIM = ("i", "j", *(f"h{n}" for n in range(1, 11)))
"""Fields of two bodies, and of the hidden bodies of the modal coordinates of the second one."""
WITH_RIM = tuple((a, b) for n, a in enumerate(RIM) for b in RIM[n + 1 :])
"""Pairs of kinds that couple all of them."""


@dataclass(frozen=True)
class Power:
    """How the records of a kind appear in a power flow.

    Parameters
    ----------
    torque
        Channel of the torque on body i about its axis, ``{}`` for the name of the element; "" if the mean
        power of the kind is zero or is evaluated by its role.
    loss
        Name of the power loss between input and output.
    source
        Word for an element that supplies power from outside, such as "load"; "" for one that transmits it
        from body i to body j.
    total
        Channel of the whole power of a source on one body, in place of `torque`.
    body
        Field of this body.
    where
        Whether a record transmits power; default: all do.
    unknown
        Whether a record of a source exchanges power that no channel contains; default: none does.
    energy
        Energy that a record stores at a torque on body i [J], for kinds whose state is this torque.
    """

    torque: str = ""
    loss: str = "damping"
    source: str = ""
    total: str = ""
    body: str = "i"
    where: Callable[[np.void], bool] | None = None
    unknown: Callable[[np.void], bool] | None = None
    energy: Callable[[np.void, Any], Any] | None = None


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
        and pair blocks; set by the layout), its last is out, the index of its first observation. More
        reserved names: row and ev (first row and first event), pool (address of a float array), law (address
        of a user law).
    entry
        Kernel with the signature ``int64 entry(int64 ctl, int64 records, int64 n)``.
    outputs
        Observations per record, or a function of the record that returns them.
    pairs
        Pairs of record fields of interacting bodies.
    paired
        Fields of bodies that all interact; their blocks are in the field `pairs` of the record.
    modal
        Fields of the hidden bodies of the modal coordinates of an elastic body.
    rows, row_unit
        Number of constraint rows per record, and a function of the record for the unit of their residual.
    events, bends
        Event functions per record, and a function of the record for those at whose zeros the force has a jump
        or a kink (default: all).
    exact
        Entry points called only for exact tangents, by the record field of their address.
    some
        Entry points called only by records with a nonzero field: by the record field of their address, with
        the name of the other field.
    body_fixed
        Whether it reads the body-fixed frames S, which rotate with the spin.
    role
        Search key of solvers, such as MESH; most kinds have none.
    scope
        BETWEEN: couples its bodies. SINGLE: acts on body i alone. EVERYWHERE: acts on all coordinates.
    massless
        Whether its forces are independent of accelerations.
    spins
        FREE: all bodies rotate freely about their axes. TOGETHER: both bodies rotate together. GEARED: they
        rotate in a ratio. HOLDS: all other cases. A word, or a function of the record.
    resists
        Rotations that it resists. RELATIVE: of one end relative to the other (default of HOLDS). ACROSS: the
        same, except about the axis of body i. OWN: of body i about its axis. WEIGHT: of all bodies whose
        centre of mass is off the axis. NOTHING (default of all others). A word, or a function of the record.
    lets_turn
        Function of the record: ends that rotate freely about their axis although other rotations are
        resisted.
    close
        Function that removes the clearance of records, in place, so that their stiffness shows all directions
        that they can resist. None: the kind has no clearance.
    linear
        Whether its linearisation is constant in time, so that `reduce` may condense it: true or false, or a
        function of the record and of whether one of its bodies spins.
    large
        Whether its kernel is valid for large motions, so that it is retained if both its bodies are.
    fine
        Whether it introduces modes far above the excitation frequencies.
    excites
        Whether its forces vary without a motion of the modes, so that time steps resolve the modes it
        excites.
    sections
        Sections of the model file whose components become records, with the name of the schematic that
        represents them in a scene (`report.scene.connections.SCHEMATICS`); "" if there is none.
    label
        Word before the name of an element; a word, or a function of the record.
    title, plural
        Name of the kind in words, if different from `name`, and its plural.
    main
        Whether stiffness tables list it first, even with zero stiffness.
    names_modes
        Whether a mode may be named after it.
    arrow
        How its force ``bearing_force[NAME.fx]`` … is drawn: "bearing" in the axes B at zi, "ring" in those of
        the second ring without its spin, "" not drawn. A word, or a function of the record.
    power
        How it appears in a power flow; None: power is not evaluated.
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
    close: Callable[[Any], None] | None = None
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
        """Name of the module of its entry point."""
        return str(self.entry.__module__)

    @property
    def ends(self) -> tuple[str, ...]:
        """Record fields of all its bodies."""
        return tuple(dict.fromkeys(end for pair in self.pairs for end in pair))

    def outputs_of(self, record: np.void) -> Rows:
        """Observations of one record."""
        return self.outputs(record) if callable(self.outputs) else self.outputs

    def bends_of(self, record: np.void) -> tuple[str, ...]:
        """Event functions of one record at whose zeros the force has a jump or a kink."""
        return self.bends(record) if self.bends is not None else tuple(event[0] for event in self.events)

    def spins_of(self, record: np.void) -> str:
        """Effect of one record on rotations about the body axes."""
        return self.spins(record) if callable(self.spins) else self.spins

    def resists_of(self, record: np.void) -> str:
        """Rotations that one record resists."""
        if self.resists is None:
            return RELATIVE if self.spins_of(record) == HOLDS else NOTHING
        return self.resists(record) if callable(self.resists) else self.resists

    def is_linear(self, record: np.void, spinning: bool) -> bool:
        """Whether the linearisation of one record is constant in time."""
        return self.linear(record, spinning) if callable(self.linear) else self.linear

    def label_of(self, record: np.void) -> str:
        """Label of one record."""
        found = self.label(record) if callable(self.label) else self.label
        return found or self.words

    def arrow_of(self, record: np.void) -> str:
        """How the force of one record is drawn."""
        return self.arrow(record) if callable(self.arrow) else self.arrow

    @property
    def words(self) -> str:
        """Name of the kind in words."""
        return self.title or self.name.replace("_", " ")
