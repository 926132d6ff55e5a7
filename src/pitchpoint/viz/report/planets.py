# SPDX-License-Identifier: Apache-2.0
"""Table of the load sharing of planets."""

from __future__ import annotations

import math
from collections.abc import Mapping
from html import escape
from typing import Any

from pitchpoint.core.words import ranges
from pitchpoint.viz.quantities import amount, number, scale
from pitchpoint.viz.tables import plain_table

EQUAL = 1.00005
"""Mesh load factor up to which the planets carry equal loads."""


def planet_table(stages: Mapping[str, Mapping[str, Any]]) -> str:
    """HTML tables of mean mesh force and share of every planet, with K_γ in words; without load a sentence.

    Parameters
    ----------
    stages
        By stage: `planets`, `meshes`, `mean_force` [N], `share` [-], `load_sharing_factor` [-], None
        without load, and `positions` (`system.planet_loads.as_data`).
    """
    found = []
    for name, stage in stages.items():
        factor = stage["load_sharing_factor"]
        if factor is None:
            found.append(f"<p>{escape(name)}: no load on the planets, no mesh load factor K<sub>γ</sub>.</p>")
            continue
        positions = stage.get("positions")
        largest = factor if positions is None else max(factor, positions["load_sharing_factor"])
        if largest < EQUAL:
            words = ranges(stage["meshes"])
            load = amount(max(map(abs, stage["mean_force"])), "N", 4)
            found.append(
                f"<p>{escape(name)}: mesh load factor K<sub>γ</sub> = {factor:.4f}; equal mean forces in "
                f"{escape(words)}, {load}.</p>"
            )
            continue
        force = scale("N", stage["mean_force"])
        head = ["planet", "mesh", f"mean mesh force [{force.unit}]", "share [%]"]
        pairs: list[tuple[float, ...]] = [()] * len(stage["planets"])
        if positions is not None:
            head += ["smallest share [%]", "largest share [%]"]
            pairs = list(zip(positions["least_share"], positions["largest_share"], strict=True))
        means = zip(stage["planets"], stage["meshes"], stage["mean_force"], stage["share"], strict=True)
        rows = zip(means, pairs, strict=True)
        body = [
            f'<tr><th scope="row">{escape(planet)}</th><td>{escape(mesh)}</td>'
            f"<td class=num>{number(load * force.factor, 4)}</td>"
            + "".join(f"<td class=num>{100.0 * part:.2f}</td>" for part in (share, *extremes))
            + "</tr>"
            for (planet, mesh, load, share), extremes in rows
        ]
        words = f"{escape(name)}: mesh load factor K<sub>γ</sub> = {factor:.4f}, from mean mesh forces."
        if positions is not None:
            words += (
                f" Largest at a carrier position {positions['load_sharing_factor']:.4f}, "
                f"at a carrier angle of {math.degrees(positions['carrier_angle']):.0f} deg; shares over 1/12 "
                f"turn each, in {positions['turns']:.3g} turns of the carrier."
            )
        found.append(f"{plain_table(head, body)}<p>{words}</p>")
    return "".join(found)
