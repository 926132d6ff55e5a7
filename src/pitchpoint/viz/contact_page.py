# SPDX-License-Identifier: Apache-2.0
"""HTML page of one contact analysis."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.viz.contact_table import options_of
from pitchpoint.viz.report.contact import contact_result, contact_section
from pitchpoint.viz.report.page import page

if TYPE_CHECKING:
    import xarray as xr


def contact_page(data: xr.Dataset, note: str = "") -> str:
    """Page with the results and plots of `solve_contact`.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    note
        Sentence on an incomplete analysis.
    """
    mesh = str(options_of(data)["mesh"])
    facts = (
        ("version", str(data.attrs.get("pitchpoint_version", data.attrs.get("package_version", "")))),
        ("model", str(data.attrs.get("model_hash", ""))[:12]),
        ("mesh", mesh),
    )
    title = str(data.attrs.get("title") or "Gears")
    section = contact_section({mesh: contact_result(data, note)})
    return page(f"{title}: tooth contact", facts, [section], "pitchpoint contact.", [note] if note else [])
