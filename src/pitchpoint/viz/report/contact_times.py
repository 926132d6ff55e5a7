# SPDX-License-Identifier: Apache-2.0
"""Table of contact times of the flanks: flank in work, contact loss, back contact, impacts."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

import numpy as np

from pitchpoint.analysis.statistics import ContactStatistics, contact_statistics
from pitchpoint.viz.quantities import Array, Channel, amount, number
from pitchpoint.viz.tables import plain_table

HEAD = (
    *("flank in work", "contact loss", "back contact"),
    *("impacts", "largest impact", "closing speed", "impulse", "energy", "rattle index", "reversal"),
)
"""Columns of the table after the mesh."""
ALWAYS = 3
"""Number of columns that are always listed."""
NOTHING = ("–", "0")
"""Cells without a result."""
NO_RATTLE = 0.05
"""Rattle index that is not listed: flanks separate above 1."""


def contact_table(
    time: Array, states: Mapping[str, Array], found: Mapping[str, Channel], settled: np.ndarray
) -> str:
    """HTML table of flank in work, contact loss, back contact and impacts per mesh; empty without meshes.

    Parameters
    ----------
    time
        Times of the window of the statistics [s], shape (n,).
    states
        Contact states in the window by mesh.
    found
        Channels by name.
    settled
        Samples of the window in the record, bool.
    """
    rows: dict[str, tuple[str, ...]] = {}
    for mesh, state in states.items():
        force = found.get(f"mesh_force[{mesh}]")
        c = contact_statistics(time, state, None if force is None else force.values[settled])
        peaks = [i.peak for i in c.impacts if i.peak is not None]
        counted = found[f"contact_state[{mesh}]"].contact
        if counted is not None:  # at all steps, not at the stored samples
            cells: tuple[str, ...] = _counted_cells(counted, amount(max(peaks), "N") if peaks else "–")
        else:
            cells = _sampled_cells(c, peaks)
        rows[mesh] = (working_flank(state), *cells)
    # impacts are listed only if there are any
    kept = [k for k in range(len(HEAD)) if k < ALWAYS or any(row[k] not in NOTHING for row in rows.values())]
    body = [
        f'<tr><th scope="row">{escape(mesh)}</th><td>{row[0]}</td>'
        + "".join(f'<td class="num">{row[k]}</td>' for k in kept[1:])
        + "</tr>"
        for mesh, row in rows.items()
    ]
    words = "" if len(kept) > ALWAYS else "<p>No mesh loses contact.</p>"
    if HEAD.index("energy") in kept:
        words = (
            "<p>Energy: of the impacts, per revolution of gear 1. Reversal: load of the back flank over that "
            "of the front flank with the flanks held together, the smaller over the larger one.</p>"
        )
    return plain_table(("mesh", *(HEAD[k] for k in kept)), body) + words if body else ""


def _counted_cells(counted: Mapping[str, float], largest: str) -> tuple[str, ...]:
    """Cells of a mesh from the numbers of all steps, and its largest force after an impact."""
    impacts = int(counted["front_impacts"] + counted["back_impacts"])
    index, reversal = counted["rattle_index"], counted["load_reversal"]
    energy = counted["impact_energy_per_revolution"]
    return (
        f"{100.0 * counted['contact_loss_share']:.3g} %",
        f"{100.0 * counted['back_contact_share']:.3g} %",
        str(impacts),
        largest,
        f"{1e3 * counted['closing_speed_max']:.4g} mm/s" if impacts else "–",
        f"{counted['impulse_max']:.4g} N s" if counted["impulse_max"] > 0.0 else "–",
        f"{1e3 * energy:.3g} mJ" if energy > 0.0 else "–",
        number(index, 3) if np.isfinite(index) and index > NO_RATTLE else "–",
        number(reversal, 3) if impacts and np.isfinite(reversal) else "–",
    )


def _sampled_cells(c: ContactStatistics, peaks: list[float]) -> tuple[str, ...]:
    """Cells of a mesh from the stored samples."""
    return (
        f"{100.0 * c.loss_share:.3g} %",
        f"{100.0 * c.back_contact_share:.3g} %",
        str(len(c.impacts)),
        amount(max(peaks), "N") if peaks else "–",
        *("–" for _ in range(len(HEAD) - 5)),
    )


def working_flank(state: Array) -> str:
    """Flank in work over a record of contact states, in words.

    Examples
    --------
    >>> [working_flank(np.array(s)) for s in ([1, 1], [-1, -1, 0], [1, -1, 0], [0, 0], [2, 2])]
    ['front', 'works on back flank', 'both, alternating', 'no contact', 'both at once']
    """
    codes = np.rint(state)
    front, back, both = (bool(np.any(codes == k)) for k in (1, -1, 2))
    if front and back:
        share = float(np.mean(codes == -1)) / float(np.mean(np.abs(codes) == 1))
        return "works on back flank" if share > 0.9 else "front" if share < 0.1 else "both, alternating"
    if front or back:
        return "works on back flank" if back else "front"
    return "both at once" if both else "no contact"
