# SPDX-License-Identifier: Apache-2.0
"""Power flow at constant speed in `pitchpoint check`: shafts, meshes, couplings, rolling bearings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.cli.output import show, show_notes, table
from pitchpoint.core.words import ranges

MAX_FLOWS = 3
"""Largest number of power flows that are printed without `--scenario`."""


def show_power_flows(flows: Mapping[str, Mapping[str, Any]]) -> None:
    """Print the power flow of all scenarios; those with equal tables together.

    Parameters
    ----------
    flows
        Power flows by scenario, see `report.static_power`.
    """
    from pitchpoint.report.power_tables import flow_texts

    found = flow_texts(flows)
    for flow in found[:MAX_FLOWS]:
        place = f" in {ranges(flow.names)}" if any(flow.names) else ""
        if not flow.tables:
            show(f"Power flow{place}: {flow.summary}")
        for k, each in enumerate(flow.tables):
            title = f"Power flow{place}: {flow.summary}" if k == 0 else each.title
            table(title, each.head, each.rows, each.notes)
        show_notes(flow.notes)
    if more := [ranges(flow.names) for flow in found[MAX_FLOWS:]]:
        show(f"power flow in other scenarios, with --scenario: {ranges(more)}")
