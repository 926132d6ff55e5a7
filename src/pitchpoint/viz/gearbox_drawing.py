# SPDX-License-Identifier: Apache-2.0
"""Drawing of a gearbox: its section and its transverse view next to each other."""

from __future__ import annotations

from pitchpoint.viz import svg
from pitchpoint.viz.quantities import printed
from pitchpoint.viz.section_content import Section
from pitchpoint.viz.section_drawing import section_parts
from pitchpoint.viz.transverse_drawing import Transverse, transverse_parts

WIDEST = 1500.0
"""Width up to which both views are next to each other [pixels]."""

BELOW = 0.8
"""Width of the transverse view below the section, relative to that of the section."""


def gearbox_svg(section: Section, transverse: Transverse | None = None) -> str:
    """SVG drawing of a gearbox.

    Parameters
    ----------
    section
        The section.
    transverse
        The transverse view; None for a drawing without it.
    """
    width, height, parts = section_parts(section)
    drawn = [f'<svg x="0" y="0" width="{width:.0f}" height="{height:.0f}">{"".join(parts)}</svg>']
    if transverse is not None and len(transverse.wheels) > 1:
        wide, tall, more = transverse_parts(transverse)
        x, y = (width, 0.0)
        if width + wide > WIDEST:
            wide, tall, more = transverse_parts(transverse, BELOW * width)
            x, y = 0.0, height
        drawn.append(
            f'<svg x="{x:.0f}" y="{y:.0f}" width="{wide:.0f}" height="{tall:.0f}">{"".join(more)}</svg>'
        )
        width, height = max(width, x + wide), max(height, y + tall)
    return svg.document(width, height, drawn, f"section of {printed(section.title) or 'the gearbox'}")
