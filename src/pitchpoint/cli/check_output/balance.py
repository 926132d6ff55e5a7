# SPDX-License-Identifier: Apache-2.0
"""Loads with `torque: balance` in `pitchpoint check`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import show, show_notes, shown
from pitchpoint.core.words import listed

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def solved(model: Model, *, quiet: bool = False) -> dict[str, dict[str, Any]]:
    """Balancing torques of all scenarios, with a progress display; refused if there are none."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import refuse_without_effect
    from pitchpoint.report.balance import balanced_loads, balancing_torques

    if not balanced_loads(model):
        refuse_without_effect("without a load with torque: balance", {"--balance": True})
    with ProgressDisplay("balance", "scenarios", quiet=quiet) as progress:
        found = balancing_torques(model, progress)
    if not found:
        refuse_without_effect("without a time or quasi-static scenario", {"--balance": True})
    return found


def show_balance(balance: dict[str, Any]) -> None:
    """Print what is balanced, and the torques of the scenarios that were solved."""
    if "scenarios" not in balance:
        verb = "balance" if len(balance["loads"]) > 1 else "balances"
        show(
            f"torque: balance: {listed(balance['loads'])} {verb} {balance['balance']}; values with --balance"
        )
    for name, found in balance.get("scenarios", {}).items():
        show(f"torque: balance in {name}: {_words(found)}")
        show_notes(found.get("notes", ()))


def _words(found: dict[str, Any]) -> str:
    """Balancing torques of a scenario, and what they balance."""
    if "failure" in found:
        return f"not found; {found['failure']}"
    torques = ", ".join(f"{name} {shown(value, 'torque', 5)}" for name, value in found["torques"].items())
    return f"{torques}; {found['balance']}"
