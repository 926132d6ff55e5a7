# SPDX-License-Identifier: Apache-2.0
"""Address tables of element kinds: entry, records and number of records. Rebuilt in each process."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import address, law_address, prepare
from pitchpoint.elements import kind as traits
from pitchpoint.elements import registry
from pitchpoint.elements.signals.record import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    CHANNEL,
    FORCE,
    HELD,
    LINK,
    RATE,
    STATE,
    STRUT,
    TORQUE,
)
from pitchpoint.multibody.bodies import FREE, GENERAL
from pitchpoint.system import linear, residual, tree
from pitchpoint.system.requests import handle_request
from pitchpoint.system.residual import COLUMNS, EARLY, OBSERVER_CHANNEL

if TYPE_CHECKING:
    from pitchpoint.system.workspace import Workspace

ACTING = (STATE, HELD, TORQUE, STRUT, FORCE, RATE, LINK)
"""Operations of signals that act on the machine, or are written and read between steps."""
NO_MATTER = 1e30
"""Relative error tolerance of coordinates on which nothing depends."""
_CHANNEL = {
    traits.FRAME: 0,
    traits.FRICTION: 0,
    traits.COORDINATE: 1,
    traits.CONSTRAINT: 2,
    traits.MOTION: 3,
}
_TABLE = {traits.CONSTRAINT: "cons", traits.MOTION: "guiding", traits.FRICTION: "frictions"}


TABLES = ("forces", "cons", "guiding", "frictions")
"""Address tables in the order of their row numbers in messages."""


def link(
    records: Mapping[str, NDArray[np.void]],
    pools: Mapping[str, NDArray[np.float64]],
    laws: Mapping[str, Sequence[Any]],
) -> dict[str, NDArray[np.int64]]:
    """Create the address tables with rows (entry, records, count, channel, early).

    Kinds are in alphabetical order, so that sums are reproducible. Also writes the addresses of pools and
    user laws to the records.
    """
    tables: dict[str, list[tuple[int, ...]]] = {name: [] for name in TABLES}
    for name in sorted(records):
        bank = records[name]
        kind = registry.find(name)
        if name in pools and "pool" in (bank.dtype.names or ()):
            bank["pool"] = pools[name].ctypes.data
        if "closures" in (bank.dtype.names or ()):
            for closures in registry.of_role(records, traits.CLOSURE):
                bank["closures"] = records[closures].ctypes.data
        for k, law in enumerate(laws.get(name, ())):
            if law is not None:
                bank[k]["law"] = law_address(law)
        for field, (kernel, reason) in kind.some.items():
            if np.any(bank[reason]):
                bank[field] = address(kernel)
        channel = OBSERVER_CHANNEL if only_observes(name, bank) else _CHANNEL[kind.channel]
        early = int(kind.channel == traits.FRAME and kind.massless)
        row = (address(kind.entry), bank.ctypes.data, bank.size, channel, early)
        tables[_TABLE.get(kind.channel, "forces")].append(row)
    return {name: np.array(rows, np.int64).reshape(-1, COLUMNS) for name, rows in tables.items()}


#: Core kernels that every driver calls, by their fields of MACH.
_PARTS = {"residual": residual.entry, "factor_entry": linear.factor_entry, "solve_entry": linear.solve_entry}


def prepare_kernels(kinds: Iterable[str], trees: bool = False) -> None:
    """Compile kernels that are not in the cache: the core here, element kinds in a second process.

    Meshes are first: they are the largest kinds, and the records of a model need them first. `trees` adds
    the core kernels of bodies in trees.
    """
    found = [registry.find(name) for name in kinds]
    theirs = [kind.entry for kind in sorted(found, key=lambda kind: (kind.role != traits.MESH, kind.name))]
    prepare([*_PARTS.values(), handle_request], [*theirs, tree.entry] if trees else theirs)


def link_exact(records: Mapping[str, NDArray[np.void]]) -> None:
    """Compile the kernels of exact tangents and write their addresses to the records."""
    for name, bank in records.items():
        for field, kernel in registry.find(name).exact.items():
            bank[field] = address(kernel)


def link_parts(body: NDArray[np.void]) -> dict[str, int]:
    """Addresses of the core kernels that these bodies require."""
    parts = dict(_PARTS)
    if np.any(body["joint"] == GENERAL) or np.any(body["fixed_axes"]):
        parts["tree"] = tree.entry
    if np.any(body["chart"] >= 0):
        parts["tumble"] = tree.tumble_entry
    return {name: address(kernel) for name, kernel in parts.items()}


def signal_banks(records: Mapping[str, NDArray[np.void]]) -> list[NDArray[np.void]]:
    """Banks of signal records, one at most."""
    return [records[name] for name in registry.of_role(records, traits.SIGNAL)]


def only_observes(name: str, bank: NDArray[np.void]) -> bool:
    """Whether the records of a kind are signals used for output only."""
    return registry.find(name).role == traits.SIGNAL and not acts(bank)


def acts(signals: NDArray[np.void]) -> bool:
    """Whether signals act on the machine, or are written and read between steps."""
    return bool(np.any(np.isin(signals["op"], ACTING)))


def fit_signals(workspace: Workspace, records: Mapping[str, NDArray[np.void]]) -> None:
    """Set the fields of a new workspace that depend on friction, signals and element states."""
    mach = workspace.mach[0]
    body = workspace.program["body"]
    mach["settles"] = np.any(workspace.tables["frictions"][:, residual.CHANNEL] != OBSERVER_CHANNEL)
    mach["constant_mass"] = np.all(body["joint"] < FREE) and not mach["settles"]
    workspace.arrays["relative"][body["spin"][body["state"] == 1]] = NO_MATTER
    for bank in signal_banks(records):
        if not acts(bank):
            continue
        if np.any(bank["op"] == CHANNEL):  # signals read channels of other elements at every evaluation
            mach["watch"] = workspace.arrays["heard"].ctypes.data
            mach["shares"] = 0  # these signals need all observations in one pass
        if np.any(np.isin(bank["op"], (ACCELERATION, ANGULAR_ACCELERATION))):
            mach["constant_mass"] = 0  # feedback of accelerations changes the mass matrix


@contextmanager
def heard(
    workspace: Workspace, records: Mapping[str, NDArray[np.void]], channels: NDArray[np.int64] | None
) -> Iterator[None]:
    """Context: kinds observed before the accelerations are evaluated only for these channels; None: all."""
    early = workspace.tables["forces"][:, EARLY]
    kept = early.copy()
    if channels is not None and len(channels):
        banks = [bank for bank in records.values() if "out" in (bank.dtype.names or ())]
        firsts = np.array([bank["out"][0] for bank in banks])  # channels are ordered by kind
        for e in np.flatnonzero(early == 1):
            first = records[kind_of_row(records, int(e))]["out"][0]
            end = min(firsts[firsts > first], default=workspace.ctl[0]["no"])
            early[e] = 1 if np.any((channels >= first) & (channels < end)) else 2
    try:
        yield
    finally:
        early[:] = kept


def kind_of_row(records: Mapping[str, NDArray[np.void]], row: int) -> str:
    """Name of the kind of a row, counted through the `TABLES`; "?" if out of range."""
    ordered = sorted(records, key=lambda n: (TABLES.index(_TABLE.get(registry.find(n).channel, "forces")), n))
    return ordered[row] if 0 <= row < len(ordered) else "?"
