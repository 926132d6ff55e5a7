# SPDX-License-Identifier: Apache-2.0
"""SVG drawing of a gearbox in section: hatched gears and rings, shafts, bearings, centre lines and
distances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz import svg, theme
from pitchpoint.viz.label_placement import LETTER, LINE
from pitchpoint.viz.labels import spread
from pitchpoint.viz.quantities import printed
from pitchpoint.viz.section_content import Piece, Section, SectionAxis, SectionLink
from pitchpoint.viz.section_labels import AXIS_END, axis_lines, reach, section_labels

Array = NDArray[np.float64]

FIELD, TALLEST, PER_AXIS = 620.0, 900.0, (240.0, 170.0)
"""Largest width and height of the machine; height without axes, and with each of them [pixels]."""
FLAT, LONG = 1.6, 1.5
"""Ratio of width and height from which a machine is wider than the field, and how much at most."""
NARROW, NAMES = 360.0, 110.0
"""Width of a machine up to which there is more room for names at its right, and most of it [pixels]."""
BOLD = 1.06
"""Width of the names of axes relative to the mean width of letters."""
MARGIN = 34.0
"""Space around the machine [pixels]."""
COLUMN, STEP = 34.0, 17.0
"""Distance of dimension lines, and of lines of axis labels [pixels]."""
ORDER = (
    *(
        "seat",
        "pedestal",
        "held",
        "pin",
        "plate",
        "spindle",
        "drum",
        "shaft",
        "mass",
        "flange",
        "gear",
        "teeth",
    ),
    *("lining", "ground", "inner", "outer", "linear", "element", "pitch"),
)
"""Kinds of parts from the back to the front."""
WHOLE = ("shaft", "spindle", "mass", "flange", "pin")
"""Kinds of parts without a bore that are not cut along their axis: drawn whole."""
STYLE = (
    "<style>"
    ".pp-shaft{fill:var(--pp-paper);stroke:var(--pp-edge);stroke-width:1.3}"
    ".pp-spindle{fill:var(--pp-paper);stroke:var(--pp-soft);stroke-width:1;stroke-dasharray:6 3}"
    ".pp-drum{fill:var(--pp-soft);fill-opacity:.3;stroke:var(--pp-soft);stroke-width:.8}"
    ".pp-lining{fill:var(--pp-ink);stroke:none}"
    ".pp-cut{fill:var(--pp-gear);stroke:var(--pp-edge);stroke-width:1.3;stroke-linejoin:round}"
    ".pp-hatched{stroke:none}"
    ".pp-hatch{stroke:var(--pp-edge);stroke-width:.7}"
    ".pp-teeth{fill:var(--pp-mate);fill-opacity:.75;stroke:var(--pp-edge);stroke-width:1.1}"
    ".pp-ring{fill:var(--pp-paper);stroke:var(--pp-edge);stroke-width:1}"
    ".pp-element{fill:var(--pp-mate);stroke:var(--pp-edge);stroke-width:1}"
    f".pp-house{{fill:{theme.OCHRE};fill-opacity:.2;stroke:{theme.OCHRE};stroke-width:1}}"
    f".pp-ground{{fill:var(--pp-paper);stroke:{theme.OCHRE};stroke-width:1}}"
    f".pp-pitchline{{stroke:{theme.RED};stroke-width:1;stroke-dasharray:9 3 2 3;fill:none}}"
    ".pp-axis{stroke:var(--pp-soft);stroke-width:1;stroke-dasharray:14 3 3 3;fill:none}"
    ".pp-dim{stroke:var(--pp-soft);stroke-width:.9;fill:var(--pp-soft)}"
    f".pp-apart{{stroke:{theme.RED};stroke-width:1.4;stroke-dasharray:2 4;fill:none}}"
    ".pp-name{fill:var(--pp-ink);stroke:var(--pp-paper);stroke-width:3.5;paint-order:stroke;font-size:13px;"
    "font-weight:600}"
    ".pp-sub{fill:var(--pp-soft);stroke:var(--pp-paper);stroke-width:3;paint-order:stroke;font-size:11.5px}"
    ".pp-solid{fill:var(--pp-gear);fill-opacity:.6;stroke:var(--pp-edge);stroke-width:1.1}"
    "</style>"
)
HATCHES = {
    "gear": ("h1", 45, 7.0),
    "inner": ("h2", 45, 3.5),
    "outer": ("h3", -45, 3.5),
    "seat": ("h4", -45, 6.0),
    "pedestal": ("h4", -45, 6.0),
    "held": ("h4", -45, 6.0),
    "ground": ("h4", -45, 6.0),
    "plate": ("h5", -45, 7.0),
}
"""Hatched kinds: name, direction [deg] and distance [pixels] of the lines."""
CSS = {
    **dict.fromkeys(("gear", "plate"), "pp-cut"),
    **dict.fromkeys(("inner", "outer", "linear"), "pp-ring"),
    "shaft": "pp-shaft",
    "spindle": "pp-spindle",
    "drum": "pp-drum",
    "lining": "pp-lining",
    "pin": "pp-shaft",
    "teeth": "pp-teeth",
    "element": "pp-element",
    "seat": "pp-house",
    "pedestal": "pp-house",
    "held": "pp-house",
    "ground": "pp-ground",
    "mass": "pp-solid",
    "flange": "pp-solid",
}


@dataclass(frozen=True)
class _View:
    """Transformation from the drawing plane [m] to pixels."""

    low: Array
    high: Array
    scale: float
    left: float
    top: float

    def __call__(self, points: Array) -> Array:
        p = np.asarray(points, dtype=np.float64)
        x = self.left + (p[..., 0] - self.low[0]) * self.scale
        y = self.top + (self.high[1] - p[..., 1]) * self.scale
        return np.stack([x, y], axis=-1)


def section_parts(section: Section) -> tuple[float, float, list[str]]:
    """Width, height and SVG elements of a section.

    Parameters
    ----------
    section
        Its contents.
    """
    corners = np.concatenate(
        [
            *(axis.at(p.line, s) for axis in section.axes for p in axis.pieces for s in (1.0, -1.0)),
            *section.walls,
        ]
    )
    low, high = corners.min(axis=0), corners.max(axis=0)
    wide, tall = np.maximum(high - low, 1e-6)
    tallest = min(TALLEST, PER_AXIS[0] + PER_AXIS[1] * len(section.axes))
    field = FIELD * min(max(wide / (FLAT * tall), 1.0), LONG)
    scale = min(field / wide, tallest / tall)
    level = [axis for axis in section.axes if abs(float(axis.way[1])) < 1e-9]
    names = [axis_lines(axis) for axis in level]
    column = BOLD * max([0.0, *(len(words) * LETTER[css] for lines in names for words, css in lines)])
    head = 30.0
    view = _View(low, high, scale, column + 2.0 * AXIS_END + 12.0, head + MARGIN)
    width = view.left + wide * scale + MARGIN
    height = view.top + tall * scale + MARGIN
    title = f"{printed(section.title) if section.title else 'Gearbox'}: section"
    head_line = svg.text(10.0, 22.0, title, "pp-head", "start")
    parts = [STYLE, _patterns()]
    parts += [
        svg.polygon(view(wall), "pp-house")
        + svg.polygon(view(wall), "pp-hatched").replace('class="pp-hatched"', _fill("h4"))
        for wall in section.walls
    ]
    for kind in ORDER:
        parts += [
            _piece(view, axis, piece) for axis in section.axes for piece in axis.pieces if piece.kind == kind
        ]
    parts += [_centre_line(view, axis, width) for axis in section.axes]
    parts += [_apart(view, link) for link in section.apart]
    parts += _axis_names(view, level, names, height)
    more = min(max(0.5 * (NARROW - wide * scale), 0.0), NAMES)
    right = view.left + wide * scale + AXIS_END + more
    labels, leaders = section_labels(view, section, (view.left - AXIS_END, head, right))
    edge = max((label.box[2] for label in labels), default=0.0) + 6.0 + MARGIN - AXIS_END
    lowest = max([height - MARGIN, *(label.box[3] for label in labels)])
    dims, width, lowest = _dimensions(view, section.distances, max(width, edge) - MARGIN + AXIS_END, lowest)
    parts += dims
    parts += [*leaders, *(label.svg() for label in labels)]
    highest = min([head, *(label.box[1] for label in labels)])
    for k, words in enumerate(section.notes):
        parts.append(svg.text(10.0, lowest + 26.0 + LINE * k, words, "pp-small", "start"))
    total = lowest + 20.0 + LINE * len(section.notes) + 8.0
    right = max([width, *(label.box[2] + 8.0 for label in labels)])
    note_width = max([0.0, *(len(words) * LETTER["pp-small"] + 20.0 for words in section.notes)])
    body = "".join(parts)
    if highest < head:
        body = f'<g transform="translate(0 {head - highest:.1f})">{body}</g>'
        total += head - highest
    note_width = max(note_width, 8.0 * len(title) + 20.0)
    return max(right, note_width), total, [head_line, body]


def _fill(name: str) -> str:
    return f'class="pp-hatched" fill="url(#pp-{name})"'


def _patterns() -> str:
    """Hatchings."""
    found = "".join(
        f'<pattern id="pp-{name}" width="{step}" height="{step}" patternUnits="userSpaceOnUse" '
        f'patternTransform="rotate({turn})">'
        f'<line class="pp-hatch" x1="0" y1="0" x2="0" y2="{step}"/></pattern>'
        for name, turn, step in {each[0]: each for each in HATCHES.values()}.values()
    )
    return f"<defs>{found}</defs>"


def _piece(view: _View, axis: SectionAxis, piece: Piece) -> str:
    """One part in both halves."""
    if piece.kind == "pitch":
        return "".join(svg.polyline(view(axis.at(piece.line, s)), "pp-pitchline") for s in (1.0, -1.0))
    css = CSS[piece.kind]
    if piece.kind in WHOLE and float(piece.line[:, 1].min()) <= 0.0:
        (z0, _), (z1, r) = piece.line.min(axis=0), piece.line.max(axis=0)
        return svg.polygon(view(axis.at(np.array([(z0, -r), (z1, -r), (z1, r), (z0, r)]))), css)
    found = []
    for sign, there in zip((1.0, -1.0), piece.sides, strict=True):
        if not there:
            continue
        points = view(axis.at(piece.line, sign))
        found.append(svg.polygon(points, css))
        hatch = HATCHES.get("gear" if piece.kind == "shaft" else piece.kind)
        if hatch:
            found.append(svg.polygon(points, "pp-hatched").replace('class="pp-hatched"', _fill(hatch[0])))
        if piece.kind == "linear":  # simplified representation: free-standing upright cross
            middle, half = points.mean(axis=0), 0.22 * float(np.ptp(points, axis=0).min())
            for way in (np.array([half, 0.0]), np.array([0.0, half])):
                found.append(svg.line(middle - way, middle + way, "pp-frame"))
    return "".join(found)


def _centre_line(view: _View, axis: SectionAxis, width: float) -> str:
    """Centre line over the whole axis, to both edges for a horizontal one."""
    low, high = reach(axis)
    ends = view(axis.at(np.array([(low, 0.0), (high, 0.0)])))
    along = (ends[1] - ends[0]) / max(float(np.hypot(*(ends[1] - ends[0]))), 1e-9)
    return svg.line(ends[0] - AXIS_END * along, ends[1] + AXIS_END * along, "pp-axis")


def _apart(view: _View, link: SectionLink) -> str:
    """Mesh of gears that are apart in the drawing."""
    start, end = view(link.start), view(link.end)
    return (
        svg.line(start, end, "pp-apart") + svg.circle(start, 3.0, "pp-dot") + svg.circle(end, 3.0, "pp-dot")
    )


# --- dimensions and names -----------------------------------------------------------------------------------
def _dimensions(
    view: _View, links: Sequence[SectionLink], right: float, below: float
) -> tuple[list[str], float, float]:
    """Dimension lines at the right and below, and the right and lower edge with them."""
    parts: list[str] = []
    edges = [right, below]
    for across in (1, 0):  # vertical distances at the right, horizontal ones below
        own = [k for k in links if int(np.argmax(np.abs(view(k.end) - view(k.start)))) == across]
        spans = [(sorted(float(view(p)[across]) for p in (k.start, k.end)), k.words) for k in own]
        columns: list[list[tuple[float, float]]] = []
        first = edges[1 - across]
        for (low, high), words in sorted(spans, key=lambda each: each[0][1] - each[0][0]):
            long = max(high - low, len(words) * LETTER["pp-small"] + 8.0)
            middle = 0.5 * (low + high)
            taken = (middle - 0.5 * long, middle + 0.5 * long)
            column = next(
                (k for k, found in enumerate(columns) if all(taken[1] < a or taken[0] > b for a, b in found)),
                len(columns),
            )
            if column == len(columns):
                columns.append([])
            columns[column].append(taken)
            parts += _dimension(first, first + COLUMN * (column + 0.5), (low, high), words, across == 1)
        edges[1 - across] += COLUMN * len(columns) + 12.0 if columns or across else 0.0
    return parts, edges[0], edges[1]


def _dimension(start: float, level: float, ends: tuple[float, float], words: str, upright: bool) -> list[str]:
    """One dimension line from a level at which its auxiliary lines start."""

    def at(along: float, across: float) -> Array:
        """Point along and across the dimension."""
        return np.array([across, along] if upright else [along, across])

    middle = 0.5 * (ends[0] + ends[1])
    x, y = at(middle, level - 4.0)
    turned = " rotate(-90)" if upright else ""
    return [
        *(svg.line(at(end, start - AXIS_END), at(end, level + 5.0), "pp-thin") for end in ends),
        svg.line(at(ends[0], level), at(ends[1], level), "pp-dim"),
        *(_arrow(at(end, level), way, upright) for end, way in zip(ends, (1.0, -1.0), strict=True)),
        f'<text class="pp-small" text-anchor="middle" transform="translate({x:.1f} {y:.1f}){turned}">'
        f"{words}</text>",
    ]


def _arrow(tip: Array, way: float, upright: bool) -> str:
    """Head of a dimension line."""
    corners = np.array([(0.0, 0.0), (2.6, way * 8.0), (-2.6, way * 8.0)])
    return svg.polygon(tip + (corners if upright else corners[:, ::-1]), "pp-dim")


def _axis_names(
    view: _View, axes: Sequence[SectionAxis], names: Sequence[list[tuple[str, str]]], height: float
) -> list[str]:
    """Names at the left ends of horizontal axes."""
    named = [(axis, lines) for axis, lines in zip(axes, names, strict=True) if lines]
    tops = [float(view(axis.origin)[1]) for axis, _ in named]
    lengths = [STEP * len(lines) + 6.0 for _, lines in named]
    middles = spread(tops, lengths, 30.0, height)
    parts = []
    x = view.left - AXIS_END - 8.0
    for (axis, lines), middle, top in zip(named, middles, tops, strict=True):
        start = middle - 0.5 * STEP * (len(lines) - 1) + 5.0
        parts += [svg.text(x, start + STEP * k, words, css, "end") for k, (words, css) in enumerate(lines)]
        begin = float(view(axis.at(np.array([(reach(axis)[0], 0.0)])))[0, 0]) - AXIS_END
        if abs(middle - top) > 3.0 or begin > x + 14.0:
            parts.append(
                svg.polyline(np.array([(x + 3.0, middle), (x + 8.0, top), (begin, top)]), "pp-leader")
            )
    return parts
