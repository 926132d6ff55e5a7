# SPDX-License-Identifier: Apache-2.0
"""Checks of sensors, blocks, controllers and actuators: names, loops, numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.formula.dimension import readable
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.checks.discon import check_discon
from pitchpoint.model.checks.fmus import check_fmu
from pitchpoint.model.components import block as bl
from pitchpoint.model.components.controller import DisconController, FmuController, SampledPid
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.signal_units import contradictory
from pitchpoint.model.signals import SECTIONS, TIME, at_once, made, read

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts


def check_signals(parts: Parts, report: Reader) -> None:
    """Check all properties of signals that do not depend on the mechanism."""
    if not any(parts.known(section) for section in SECTIONS):
        return
    names = _names(parts, report)
    for name, block in parts.blocks.items():
        _block(("blocks", name), block, report)
    for name, part in parts.controllers.items():
        _controller(("controllers", name), part, report)
    if names:
        _units(parts, report)
    if names and not any((section,) in report.tainted for section in SECTIONS):
        _loops(parts, report)


# --- names --------------------------------------------------------------------------------------------------
def _names(parts: Parts, report: Reader) -> bool:
    """Check that every signal is defined once and every reference exists; True if all could be resolved."""
    seen: dict[str, Place] = {}
    for name, at in made(parts):
        if name == TIME:
            report.problem(at, "is the name of the time in formulas", remedy="rename the signal")
        elif name in seen:
            _taken(name, at, seen[name], report)
        elif at[0] != "controllers" or report.good_name(name, at[:2]):
            seen[name] = at
    for name in parts.actuators:
        if name in seen:
            _taken(name, ("actuators", name), seen[name], report)
    whole = all(set(getattr(parts, s)) == parts.known(s) for s in SECTIONS)
    unread = {n for s in ("sensors", "blocks") for n in parts.known(s)} - set(seen)
    found = True
    for name, at in read(parts):
        if (
            name in seen
            or name in unread
            or (not whole and parts.known("controllers") - set(parts.controllers))
        ):
            continue
        found = False
        if name in parts.actuators:
            remedy = f"name the signal that it follows, {parts.actuators[name].signal}"
            report.problem(at, f"names {name}, which is an actuator", remedy=remedy)
            continue
        have = f"there are {', '.join(seen)}" if seen else "there are none: add sensors or blocks"
        report.problem(
            at,
            f"names the signal {name[:40]!r}, which does not exist",
            remedy=did_you_mean(name, seen) + have,
        )
    return found and whole


def _taken(name: str, at: Place, first: Place, report: Reader) -> None:
    who = ".".join(str(step) for step in first[:2])
    remedy = "give each signal and each actuator a unique name"
    report.problem(at, f"has a name that is already used: {who} defines signal[{name}]", remedy=remedy)


def _units(parts: Parts, report: Reader) -> None:
    """Report values whose unit contradicts that of their signal."""
    for bare, unit in contradictory(parts, report.bare):
        value = f"{bare.value:.6g} {readable(bare.unit)}"
        report.problem(bare.place, "is the value of a signal in another unit", value=value, limit=unit)


def _loops(parts: Parts, report: Reader) -> None:
    """Report algebraic loops with the names of their signals."""
    follows = at_once(parts)
    done: set[str] = set()
    for first in follows:
        trail: list[str] = []
        stack: list[tuple[str, int]] = [(first, 0)]
        while stack:
            name, k = stack.pop()
            del trail[len(stack) :]
            if name in done and k == 0:
                continue
            trail.append(name)
            if k == len(follows[name]):
                done.add(name)
                continue
            stack.append((name, k + 1))
            wanted = follows[name][k]
            if wanted in trail:
                _loop(parts, trail[trail.index(wanted) :], report)
                done.update(trail)
                break
            if wanted not in done:
                stack.append((wanted, 0))


def _loop(parts: Parts, loop: list[str], report: Reader) -> None:
    k = next(k for k, name in enumerate(loop) if name in parts.blocks or name in parts.actuators)
    first = loop[k]
    report.problem(
        ("blocks" if first in parts.blocks else "actuators", first),
        f"is part of an algebraic loop: {' <- '.join([*loop[k:], *loop[:k], first])}",
        remedy="add a block with a state, such as a filter",
    )


# --- blocks and controllers ---------------------------------------------------------------------------------
def _block(at: Place, block: bl.Block, report: Reader) -> None:
    """Check dependent keys of a block."""
    if isinstance(block, bl.Limits | bl.Pid):
        _limits(at, block.limits, report)
    if isinstance(block, bl.FormulaBlock):
        _formula(at, block, report)
    elif isinstance(block, bl.RateLimit):
        if not block.rate > 0.0:
            value, remedy = f"{block.rate:.6g}", "give the largest rate, without sign"
            report.problem(
                (*at, "rate"), "is not positive", value=value, limit="> 0, in SI units", remedy=remedy
            )
    elif isinstance(block, bl.DryFriction):
        if not block.wind_up > 0.0:
            report.problem((*at, "wind_up"), "is not positive", value=f"{block.wind_up:.6g}", limit="> 0")
    elif isinstance(block, bl.TransferFunction):
        _transfer_function(at, block, report)
    elif isinstance(block, bl.Pid):
        _pid(at, block, report)


def _limits(at: Place, limits: tuple[float, float] | None, report: Reader) -> None:
    if limits is not None and not limits[0] < limits[1]:
        report.problem(
            (*at, "limits"),
            "are not increasing",
            value=f"{limits[0]:.6g} to {limits[1]:.6g}",
            remedy="write [minimum, maximum]",
        )


def _formula(at: Place, block: bl.FormulaBlock, report: Reader) -> None:
    from pitchpoint.core.formula.formula import Formula, FormulaError

    for i, name in enumerate(block.inputs):
        try:
            Formula.parse(name, (name,))
        except FormulaError:
            report.problem(
                (*at, "inputs", i),
                f"{name[:40]!r} is not a name that a formula can use",
                remedy="name the signal with letters, digits and '_', and not as a function",
            )
            return
    try:
        formula = Formula.parse(block.formula, block.inputs)
    except FormulaError as error:
        remedy = error.remedy or f"a formula may use {', '.join(block.inputs)}, pi, numbers and functions"
        report.problem((*at, "formula"), f"cannot be read as a formula: {error}", remedy=remedy)
        return
    for i, name in enumerate(block.inputs):
        if not formula.uses(name):
            report.problem((*at, "inputs", i), f"{name}, is not in the formula", remedy="use or remove it")


def _transfer_function(at: Place, block: bl.TransferFunction, report: Reader) -> None:
    if block.denominator[0] == 0.0:
        report.problem((*at, "denominator", 0), "is zero", remedy="remove leading zeros")
    elif len(block.numerator) > len(block.denominator):
        report.problem(
            (*at, "numerator"),
            "is of higher order than the denominator: the transfer function is improper",
            value=f"order {len(block.numerator) - 1}",
            limit=f"<= {len(block.denominator) - 1}",
            remedy="add a pole to the denominator",
        )


def _pid(at: Place, block: bl.Pid, report: Reader) -> None:
    if block.derivative != 0.0 and block.filter_time == 0.0:
        report.problem(
            (*at, "filter_time"),
            "is missing: required for the derivative part",
            remedy="add for example filter_time: 1 ms",
        )
    follows = block.limits is not None and block.integral != 0.0 and block.tracking_time is None
    if follows and not block.proportional / block.integral > 0.0:
        report.problem(
            (*at, "tracking_time"),
            "does not follow from these gains: proportional over integral is not positive",
            remedy="add for example tracking_time: 100 ms",
        )


def _controller(at: Place, part: Any, report: Reader) -> None:
    if isinstance(part, DisconController):
        check_discon(at, part, report)
        return
    if isinstance(part, SampledPid):
        _limits(at, part.limits, report)
        return
    if isinstance(part, FmuController):
        check_fmu(at, part, report)
    if part.start and len(part.start) != len(part.outputs):
        report.problem(
            (*at, "start"),
            f"has {len(part.start)} numbers for {len(part.outputs)} outputs",
            remedy="give one for each, or remove it",
        )
