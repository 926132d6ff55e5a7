# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint mesh -o map.html`: variation of the mesh stiffness over both contact ratios as a page."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from pitchpoint.contact.overlap_map import BestOverlap
    from pitchpoint.model.model import Model

MOST_OVERLAP = 2.5
"""Largest overlap ratio of the search for the best one."""
POINTS = 121
"""Number of contact ratios in each direction of the map."""
Given = tuple[float | None, float | None, float | None, float | None]
"""Contact ratios, stiffness ratio and tip-relief factor of the command line."""


def write_map(target: Path, model: Model | None, given: Given) -> dict[str, BestOverlap]:
    """Write the map of the meshes of a model or of given contact ratios.

    Returns
    -------
    dict
        Best overlap ratio of every marked mesh.
    """
    import numpy as np

    from pitchpoint.contact.overlap_map import best_overlap, overlap_map
    from pitchpoint.report.figure_picture import check_picture, write_picture
    from pitchpoint.viz.overlap_plot import plot_overlap_map

    check_picture(target, [model.file] if model is not None and model.file else [])
    marks, (S_R, T_R) = _marks(model, given)
    across = max(2.5, *(math.ceil(10.0 * a) / 10.0 for a, _ in marks.values()))
    up = max(3.0, *(math.ceil(10.0 * b) / 10.0 for _, b in marks.values()))
    found = overlap_map(np.linspace(1.0, across, POINTS), np.linspace(0.0, up, POINTS), S_R, T_R)
    write_picture(target, plot_overlap_map(found, marks))
    return {name: best_overlap(a, MOST_OVERLAP, S_R, T_R) for name, (a, _) in marks.items()}


def _marks(model: Model | None, given: Given) -> tuple[dict[str, tuple[float, float]], tuple[float, float]]:
    """Contact ratios by mesh, and the common stiffness ratio and tip-relief factor."""
    from pitchpoint.contact.stiffness.description import PairShape
    from pitchpoint.system.rules.stiffness import describe_stiffness

    if model is None:
        a, b, S_R, T_R = given
        return {"mesh": (a or 1.0, b or 0.0)}, (0.8 if S_R is None else S_R, T_R or 0.0)
    marks, laws = {}, set()
    for name, pair in model.pairs.items():
        if model.meshes[name].contact is not None:
            continue
        law = describe_stiffness(model, name)
        if isinstance(law, PairShape) and law.table is None and law.power == 1.0:
            marks[name] = pair.eps_alpha, pair.eps_beta
            laws.add((law.S_R, law.T_R))
    if len(laws) != 1:
        found = "no mesh has" if not laws else "the meshes have different"
        raise click.BadParameter(
            f"{found} parabolic stiffness; give --eps-alpha, --stiffness-ratio and --tip-relief-factor "
            "instead of the file",
            param_hint="--output",
        )
    return marks, laws.pop()
