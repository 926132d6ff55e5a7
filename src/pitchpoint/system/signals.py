# SPDX-License-Identifier: Apache-2.0
"""Systems with signals and sampled controllers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError, Message, ModelError
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import SIGNAL
from pitchpoint.elements.signals import record as sr
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.system.controller import SampledController
from pitchpoint.system.requests import RESIDUAL, send_request
from pitchpoint.system.residual import RECORDS
from pitchpoint.system.system import System, assemble

OBSERVED = "use the name of a result channel"


def assemble_controlled(
    net: SignalNet,
    banks: Mapping[str, NDArray[np.void]],
    constraints: Mapping[str, NDArray[np.void]] | None = None,
    *,
    controllers: Sequence[SampledController] = (),
    names: Mapping[str, Sequence[str]] | None = None,
    pools: Mapping[str, NDArray[np.float64]] | None = None,
    laws: Mapping[str, Sequence[Any]] | None = None,
    **more: Any,
) -> System:
    """Assemble a system with signals; other arguments as in `system.assemble`.

    Parameters
    ----------
    net
        Bodies and signals.
    controllers
        Sampled controllers; their outputs are signals created by `SignalNet.held`.

    Raises
    ------
    CompileError
        If signals form an algebraic loop, or a name does not exist.
    ModelError
        If a sensor refers to a channel that does not exist.
    """
    if not net.nodes:
        return assemble(net.bodies, banks, constraints, names=names, pools=pools, laws=laws, **more)
    records, labels, pool, functions = net.records()
    kind = net.kind
    system = assemble(
        [*net.bodies, *net.states],
        {**banks, kind: records},
        constraints,
        names={**(names or {}), kind: labels},
        pools={**(pools or {}), kind: pool},
        laws={**(laws or {}), kind: functions},
        **more,
    )
    for name, channel in net.listened.items():
        known = [c.name for c in system.layout.channels]
        if channel not in known:
            remedy = f"{did_you_mean(channel, known)}{OBSERVED}"
            raise ModelError(
                [Message(f"sensors.{name}.channel", f"nothing observes {channel!r}", remedy=remedy)]
            )
        system.records[kind]["channel"][labels.index(name)] = known.index(channel)
    _check(net, controllers)
    return replace(system, controllers=tuple(controllers))


def _check(net: SignalNet, controllers: Sequence[SampledController]) -> None:
    """Check that controllers read existing signals and write held signals, each written only once."""
    taken: set[str] = set()
    for controller in controllers:
        for name in controller.inputs:
            if name not in net.nodes:
                raise CompileError(f"controller {controller.name!r}: no signal is called {name!r}")
        for name in controller.outputs:
            if name not in net.nodes or net.nodes[name].op != sr.HELD:
                raise CompileError(f"controller {controller.name!r}: {name!r} is not a held signal")
            if name in taken:
                raise CompileError(f"controller {controller.name!r}: {name!r} has two controllers")
            taken.add(name)


def kind_of_signals(system: System) -> str:
    """Kind of the signals of a system, "" if it has none."""
    return next(iter(system.kinds(SIGNAL)), "")


def values(system: System, names: Sequence[str]) -> NDArray[np.float64]:
    """Values of signals at the last evaluation of the system, shape (n,)."""
    kind = kind_of_signals(system)
    labels = list(system.names[kind])
    slots = [int(system.records[kind]["slot"][labels.index(name)]) for name in names]
    found: NDArray[np.float64] = system.pools[kind][slots].copy()
    return found


@contextmanager
def only_signals(system: System, signals: bool = True) -> Iterator[bool]:
    """Context: evaluations contain no elements but signals and actuators, or without `signals` none at all.

    Its value is whether the signals are independent of other elements.
    """
    w = system.workspace
    kept: dict[str, int] = {}
    mach = w.mach[0]
    bank = system.records[kind_of_signals(system)].ctypes.data if signals else 0
    mine = {name: w.tables[name][w.tables[name][:, RECORDS] == bank] for name in ("forces", "frictions")}
    for name, rows in mine.items():
        kept |= {key: int(mach[key]) for key in (name, f"n{name}")}
        mach[name], mach[f"n{name}"] = rows.ctypes.data, len(rows)
    try:
        yield bool(mach["watch"] == 0 and len(mine["forces"]))
    finally:
        for key, value in kept.items():
            mach[key] = value


def evaluate_signals(system: System, t: float) -> int:
    """Evaluate all signals at the state in the workspace; returns the status.

    The residual R in the workspace then contains the forces that signals change, besides others. Elements
    that signals neither read nor change are omitted, unless signals read loads or results of elements.
    """
    with only_signals(system) as alone:
        if alone and send_request(system.workspace, RESIDUAL, t) == OK:
            return OK
    return send_request(system.workspace, RESIDUAL, t)  # also names the element that has failed


def hold(system: System, name: str, value: float) -> None:
    """Set the value of a held signal."""
    kind = kind_of_signals(system)
    record = system.records[kind][list(system.names[kind]).index(name)]
    system.pools[kind][int(record["start"])] = value


def reset(system: System) -> None:
    """Reset all held signals to their start values."""
    kind = kind_of_signals(system)
    for record in system.records[kind]:
        if record["op"] == sr.HELD:
            system.pools[kind][int(record["start"])] = record["value"]
