# SPDX-License-Identifier: Apache-2.0
"""Table of the load sharing of planets."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

from pitchpoint.viz.quantities import number, scale
from pitchpoint.viz.tables import plain_table


def planet_table(stages: Mapping[str, Mapping[str, Any]]) -> str:
    """HTML tables of mean mesh force and share of every planet, with K_γ in words; without load a sentence.

    Parameters
    ----------
    stages
        By stage: `planets`, `meshes`, `mean_force` [N], `share` [-] and `load_sharing_factor` [-], None
        without load (`system.planet_loads.loads_in`).
    """
    found = []
    for name, stage in stages.items():
        factor = stage["load_sharing_factor"]
        if factor is None:
            found.append(f"<p>{escape(name)}: no load on the planets, no mesh load factor K<sub>γ</sub>.</p>")
            continue
        force = scale("N", stage["mean_force"])
        head = ["planet", "mesh", f"mean mesh force [{force.unit}]", "share [%]"]
        rows = zip(stage["planets"], stage["meshes"], stage["mean_force"], stage["share"], strict=True)
        body = [
            f'<tr><th scope="row">{escape(planet)}</th><td>{escape(mesh)}</td>'
            f"<td class=num>{number(load * force.factor, 4)}</td><td class=num>{100.0 * share:.2f}</td></tr>"
            for planet, mesh, load, share in rows
        ]
        words = f"{escape(name)}: mesh load factor K<sub>γ</sub> = {factor:.4f}, from mean mesh forces."
        found.append(f"{plain_table(head, body)}<p>{words}</p>")
    return "".join(found)
