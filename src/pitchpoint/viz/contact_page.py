# SPDX-License-Identifier: Apache-2.0
"""HTML page of contact analyses."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.flank_contact.active_flank import active_flanks, contact_path
from pitchpoint.analysis.flank_contact.teeth import mesh_teeth
from pitchpoint.viz.active_flank_drawing import active_flank_svg
from pitchpoint.viz.quantities import amount, number
from pitchpoint.viz.report.contact import contact_result, contact_section, overview_section
from pitchpoint.viz.report.page import Section, page

if TYPE_CHECKING:
    import xarray as xr


def contacts_page(
    analyses: Mapping[str, xr.Dataset],
    note: str = "",
    *,
    gears: Mapping[str, Mapping[str, Any]],
    omitted: Mapping[str, str] | None = None,
) -> str:
    """Page with contact analyses: with several meshes an overview, and then a section for each.

    Parameters
    ----------
    analyses
        Datasets by mesh.
    note
        Sentence on incomplete analyses.
    gears
        `CylindricalGear` of gear 1 and gear 2 by name, by mesh.
    omitted
        Reason by mesh for those without an analysis.
    """
    some = next(iter(analyses.values()))
    facts = (
        ("version", str(some.attrs.get("pitchpoint_version", some.attrs.get("package_version", "")))),
        ("model", str(some.attrs.get("model_hash", ""))[:12]),
        ("mesh", ", ".join(analyses)),
    )
    title = str(some.attrs.get("title") or "Gears")
    found = {mesh: contact_result(data) for mesh, data in analyses.items()}
    sections = []
    if len(found) == 1:
        ((mesh, data),) = analyses.items()
        found[mesh] = contact_result(data, note)
        sections = [contact_section(found), flank_section(data, gears[mesh])]
    else:
        sections.append(overview_section(found, omitted or {}))
        for k, (mesh, one) in enumerate(found.items()):
            section = contact_section({mesh: one})
            section.anchor, section.heading = f"mesh{k + 1}", mesh
            drawings = flank_section(one.data, gears[mesh])
            section.add(f"<h3>{drawings.heading}</h3>" if drawings.parts else "")
            section.parts += drawings.parts
            sections.append(section)
    return page(f"{title}: tooth contact", facts, sections, "pitchpoint contact.", [note] if note else [])


def flank_section(data: xr.Dataset, gears: Mapping[str, Any]) -> Section:
    """Part of the flanks in contact at the highest torque, as drawings of a tooth of each gear."""
    section = Section("flanks", "Flanks in contact")
    torques = np.asarray(data["torque"].values, dtype=np.float64)
    if not torques.size or not gears:
        return section
    most = int(np.argmax(torques))
    found = active_flanks(data, most)
    if found is None:
        return section
    at = amount(float(torques[most]), "N m")
    path = contact_path(data, most)
    assert path is not None
    before, beyond = (number(max(v, 0.0), 3) for v in (-path[0], path[1] - mesh_teeth(data).eps_alpha))
    section.add(
        f"<p>Filled: flank between start and end of contact at {escape(at)}, over all mesh phases and "
        f"contact planes. On the path of contact, pairs touch from {before} base pitches before A to "
        f"{beyond} beyond E, there with a tip edge.</p>"
    )
    for (name, gear), loaded in zip(gears.items(), found, strict=True):
        section.add(f"<figure>{active_flank_svg(gear, loaded, name=name, words=at)}</figure>")
    return section
