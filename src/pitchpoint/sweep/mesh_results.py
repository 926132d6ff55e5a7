# SPDX-License-Identifier: Apache-2.0
"""Results of every mesh at one point of a speed sweep."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.io.sweep_store import CONTACTS, QUANTITIES
from pitchpoint.solvers.contact_counts import read_counts
from pitchpoint.solvers.sampling import Accumulators, Statistics
from pitchpoint.system.system import System


def results_by_mesh(
    system: System, swept: str, channels: Mapping[str, Any], found: Statistics, sums: Accumulators
) -> dict[str, dict[str, Any]]:
    """Statistics of `QUANTITIES` and contact numbers of `CONTACTS` by mesh, the swept mesh first.

    Parameters
    ----------
    system, swept
        System and name of the swept mesh.
    channels
        Statistics of all channels by name.
    found, sums
        Statistics of the point, and the counters from which they were read.
    """
    counted = read_counts(system, sums.counts)
    results = {}
    for mesh in (swept, *(name for name in counted if name != swept)):
        state = system.layout.channel(f"contact_state[{mesh}]")
        # simultaneous contact of both flanks (state 2) counts as neither contact loss nor back contact
        results[mesh] = {
            **{quantity: channels[f"{quantity}[{mesh}]"] for quantity, _, _ in QUANTITIES},
            **{name: counted[mesh][name] for name, _, _ in CONTACTS},
            "contact_loss_share": float(found.share_zero[state]),
            "back_contact_share": float(found.share_negative[state]),
        }
    return results
