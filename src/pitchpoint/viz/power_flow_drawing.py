# SPDX-License-Identifier: Apache-2.0
"""Drawing of a power flow: rotating blocks, bands of a width proportional to the power, losses as drops."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from html import escape

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.label_placement import LETTER, LINE, Label, Rectangle, placed
from pitchpoint.viz.power_flow import OUTSIDE, PowerFlow, PowerLink
from pitchpoint.viz.power_flow_return import lanes, reach, return_band
from pitchpoint.viz.quantities import Scale, amount, scale
from pitchpoint.viz.svg import document, text

WIDTH_BLOCK, BETWEEN, BEND = 122.0, 94.0, 60.0
"""Width of a block, least distance of blocks of two columns, and length of a bend next to a name, also the
distance of sources and sinks [pixels]."""
SLICES = 12
"""Rectangles along a band that names avoid."""
WIDEST, THINNEST = 54.0, 1.5
"""Width of the band of the largest power, and minimum width of a band [pixels]."""
GAP, HEAD, MIN_WIDTH = 72.0, 44.0, 46.0
"""Distance between blocks of a column, space above them, and height of a block [pixels]."""
LETTERS, ROW = 12, 16.0
"""Letters of a name that fit into a block, and distance of its lines [pixels]."""
SIDE = 10.0
"""Margin of the drawing [pixels]."""
NEGLIGIBLE = 1e-3
"""Share of the largest power below which a band is not drawn."""
ROUND_OFF = 1e-6
"""Share of the largest power below which a power counts as zero."""


@dataclass
class _Box:
    """Box of a block, or of a source or sink in the surroundings."""

    column: int
    height: float
    words: tuple[str, ...]
    outside: bool = False
    y: float = 0.0
    used: list[float] = field(default_factory=lambda: [0.0, 0.0])

    def port(self, side: int, width: float) -> float:
        """Middle of the next band at the left (0) or right (1) side."""
        at = self.y + self.used[side] + 0.5 * width
        self.used[side] += width
        return at


_Joined = tuple[PowerLink, _Box, _Box, float]
"""Link, the boxes at its ends, and the width of its band [pixels]."""


def power_flow_svg(flow: PowerFlow) -> str:
    """HTML drawing of the flow from left to right; bands back to an earlier block run below all blocks."""
    flow = _drawn(flow)
    links = flow.links
    most = max((link.given for link in links), default=0.0)
    if not links:
        return ""
    unit = scale("W", [most])
    columns = _columns(len(flow.blocks), links)
    boxes = [
        _Box(column, MIN_WIDTH + _more(block.name), (block.name, amount(block.speed, "rad/s")))
        for column, block in zip(columns, flow.blocks, strict=True)
    ]
    ends: list[_Joined] = []
    for link in links:
        width = max(THINNEST, WIDEST * link.given / most)
        words = (link.name, unit.text(link.given))
        start = boxes[link.start] if link.start != OUTSIDE else None
        end = boxes[link.end] if link.end != OUTSIDE else None
        if start is None and end is not None:
            start = _Box(end.column - 1, 34.0 + _more(link.name), words, outside=True)
            boxes.append(start)
        elif end is None and start is not None:
            end = _Box(start.column + 1, 34.0 + _more(link.name), words, outside=True)
            boxes.append(end)
        if start is not None and end is not None:
            ends.append((link, start, end, width))
    for box in boxes:
        widest = max(_load(box, ends, side) for side in (0, 1))
        box.height = max(box.height, widest + (0.0 if box.outside else 8.0))
    height = _stack(boxes, ends)
    for box in boxes:
        box.used = [0.5 * (box.height - _load(box, ends, side)) for side in (0, 1)]
    # bands back to earlier blocks are the last at their blocks, those between near blocks in the upper lanes
    forth = sorted((e for e in ends if not _returns(e)), key=lambda e: (e[1].y, e[2].y))
    back = sorted((e for e in ends if _returns(e)), key=lambda e: e[1].column - e[2].column)
    own_lanes = lanes(max(box.y + box.height for box in boxes), [e[3] for e in back])
    bands = [_band(one, ends, unit) for one in forth]
    bands += [_band(one, ends, unit, lane) for one, lane in zip(back, own_lanes, strict=True)]
    columns_at = _places(boxes, bands)
    x = {id(box): columns_at[box.column] for box in boxes}
    far = max(x.values()) + WIDTH_BLOCK
    parts: list[str] = []
    labels: list[Label] = []
    lines: list[Rectangle] = []
    for band in bands:
        drawn, names, slices = band.drawn(x[id(band.start)] + WIDTH_BLOCK, x[id(band.end)])
        parts.append(drawn)
        labels += names
        lines += slices
    blocks = [(x[id(b)], b.y, x[id(b)] + WIDTH_BLOCK, b.y + b.height) for b in boxes]
    labels = placed(labels, blocks, lines)
    # no band of another link covers a name
    parts += [*(label.svg() for label in labels), *(_block(box, x[id(box)]) for box in boxes)]
    title = f"power flow, input {unit.text(flow.put_in)}"
    above = max(0.0, SIDE - min((label.box[1] for label in labels), default=SIDE))
    drawn_at = [*lines, *(label.box for label in labels)]
    height = max([height, *(box[3] + SIDE for box in drawn_at)]) + above
    left = max([0.0, *(-box[0] for box in drawn_at)])
    right = max([0.0, *(box[2] - far for box in drawn_at)])
    width = far + SIDE + left + right
    drawn = f'<g transform="translate({left:.1f} {above:.1f})">{"".join(parts)}</g>'
    drawing = document(width, height, [f"<style>{STYLE}</style>", drawn], title)
    size = f"min-width:{0.75 * width:.0f}px;max-width:{width:.0f}px"
    return f'<div class="scroll"><div style="{size}">{drawing}</div></div>'


def undrawn(flow: PowerFlow) -> list[str]:
    """Names of the links that are too small for a band, without those that are zero up to round-off."""
    most = max((link.given for link in flow.links), default=0.0)
    return [
        link.name
        for link in flow.links
        if link.given <= NEGLIGIBLE * most and max(link.given, link.taken) > ROUND_OFF * most
    ]


def _drawn(flow: PowerFlow) -> PowerFlow:
    """Flow without negligible links, and without blocks that only these touch."""
    most = max((link.given for link in flow.links), default=0.0)
    links = [link for link in flow.links if link.given > NEGLIGIBLE * most]
    touched = {block for link in links for block in (link.start, link.end)}
    kept = [k for k in range(len(flow.blocks)) if k in touched]
    number = {k: new for new, k in enumerate(kept)} | {OUTSIDE: OUTSIDE}
    return replace(
        flow,
        blocks=[flow.blocks[k] for k in kept],
        links=[replace(link, start=number[link.start], end=number[link.end]) for link in links],
    )


STYLE = (
    ".pp-band{fill-opacity:.55;stroke:none}.pp-arrow{fill:var(--pp-ink)}.pp-block{fill:var(--pp-gear);stroke:var(--pp-edge);stroke-width:1.1}"
    f".pp-drop{{stroke:{theme.RED};stroke-linecap:butt}}.pp-name{{font-weight:600;fill:var(--pp-ink)}}"
)
COLOURS = {"mesh": theme.BLUE, "drive": theme.GREEN, "load": theme.GREEN, "carrier": theme.PURPLE}


def _returns(joined: _Joined) -> bool:
    """Whether a band runs back to an earlier block, or to one in the same column."""
    return joined[2].column <= joined[1].column


def _columns(count: int, links: Sequence[PowerLink]) -> list[int]:
    """Column of every block: to the right of all blocks that feed it, apart from bands that close a loop."""
    after: dict[int, list[int]] = {k: [] for k in range(count)}
    fed = {link.end for link in links if link.start != OUTSIDE}
    driven = {link.end for link in links if link.start == OUTSIDE}
    for link in links:
        if OUTSIDE not in (link.start, link.end):
            after[link.start].append(link.end)
    columns, seen = [0] * count, set[int]()

    def open_loops(k: int, path: tuple[int, ...]) -> None:
        """Drop the links from a block, and from those that it feeds, back to a block on the way to it."""
        seen.add(k)
        after[k] = [other for other in after[k] if other not in path]
        for other in after[k]:
            if other not in seen:
                open_loops(other, (*path, other))

    def push(k: int) -> None:
        """Move all blocks fed by a block to its right, recursively."""
        for other in after[k]:
            if columns[other] <= columns[k]:
                columns[other] = columns[k] + 1
                push(other)

    order = sorted(range(count), key=lambda k: (k in fed, k not in driven))
    for k in order:
        if k not in seen:
            open_loops(k, (k,))
    for k in order:
        push(k)
    return columns


def _stack(boxes: Sequence[_Box], ends: Sequence[_Joined]) -> float:
    """Stack the boxes of each column, close to the boxes that feed them; return the required height."""
    columns = sorted({box.column for box in boxes})
    for sweep in range(3):
        for column in columns if sweep % 2 == 0 else reversed(columns):
            own = [box for box in boxes if box.column == column]
            near = {id(box): _near(box, ends) for box in own}
            own.sort(key=lambda box: near[id(box)])
            total = sum(box.height + GAP for box in own) - GAP
            y = float(np.mean([near[id(box)] for box in own])) - 0.5 * total if sweep else -0.5 * total
            for box in own:
                box.y = y
                y += box.height + GAP
    low = min(box.y for box in boxes)
    for box in boxes:
        box.y += HEAD - low
    return max(box.y + box.height for box in boxes) + 34.0


def _load(box: _Box, ends: Sequence[_Joined], side: int) -> float:
    """Total width of the bands at the left (0) or right (1) side of a box."""
    return sum(e[3] for e in ends if e[2 - side] is box)


def _near(box: _Box, ends: Sequence[_Joined]) -> float:
    """Mean height of the boxes linked to a box."""
    joined = [e[1] for e in ends if e[2] is box] + [e[2] for e in ends if e[1] is box]
    return float(np.mean([other.y + 0.5 * other.height for other in joined])) if joined else 0.0


@dataclass(frozen=True)
class _Band:
    """Band between two boxes: its ends [pixels], and where its name is: start, end, middle or nowhere.

    `lane`: height of the lane of a band back to an earlier block [pixels].
    """

    link: PowerLink
    start: _Box
    end: _Box
    width: float
    y: tuple[float, float]
    named: str
    unit: Scale
    lane: float | None = None

    @property
    def lines(self) -> list[tuple[str, str]]:
        """Name, power and loss, each with its style."""
        lost = _loss(self.link) if self.link.lost > ROUND_OFF * self.link.given else ""
        # the blocks show the planets on each carrier
        name = "" if self.link.kind == "carrier" else self.link.name
        words = (name, "pp-halo"), (self.unit.text(self.link.given), "pp-small"), (lost, "pp-small")
        return [line for line in words if line[0]]

    @property
    def needs(self) -> float:
        """Distance of the columns at its name that leaves room for it [pixels]."""
        if self.lane is not None:
            return max(BETWEEN, reach(self.width) + BEND)
        if self.named in ("", "middle"):
            return BETWEEN if self.named else BEND
        return max(BETWEEN, max(LETTER[style] * len(words) for words, style in self.lines) + BEND)

    def drawn(self, a: float, b: float) -> tuple[str, list[Label], list[Rectangle]]:
        """Band from `a` to `b` [pixels] with the drop of its loss, its names, and rectangles along it."""
        (ya, yb), h = self.y, 0.5 * self.width
        colour = COLOURS.get(self.link.kind, theme.TEAL)
        if self.lane is not None:
            path, arrow, slices = return_band((a, ya), (b, yb), self.lane, self.width)
            drop, labels = _named(self.link, self.unit, 0.5 * (a + b), self.lane, self.width)
            shapes = f'<path class="pp-band" fill="{colour}" d="{path}"/><path class="pp-arrow" d="{arrow}"/>'
            return f"{shapes}{drop}", labels, slices
        # a band runs straight along its name and bends at its other end, away from the other names
        next_to = self.end.column == self.start.column + 1
        left = b - BEND if self.named == "start" and next_to else a
        right = a + BEND if self.named == "end" and next_to else b
        there = back = 0.5 * (left + right)
        path = (
            f"M{a:.1f} {ya - h:.1f}H{left:.1f}"
            f"C{there:.1f} {ya - h:.1f} {back:.1f} {yb - h:.1f} {right:.1f} {yb - h:.1f}H{b:.1f}"
            f"V{yb + h:.1f}H{right:.1f}"
            f"C{back:.1f} {yb + h:.1f} {there:.1f} {ya + h:.1f} {left:.1f} {ya + h:.1f}H{a:.1f}Z"
        )
        t = np.linspace(0.0, 1.0, SLICES + 1)
        bend = 3.0 * t * (1.0 - t) ** 2, 3.0 * t**2 * (1.0 - t)
        across = left * (1.0 - t) ** 3 + there * bend[0] + back * bend[1] + right * t**3
        down = ya + (yb - ya) * (bend[1] + t**3)
        corners = [(a, ya), *zip(across.tolist(), down.tolist(), strict=True), (b, yb)]
        slices = [
            (min(p[0], q[0]), min(p[1], q[1]) - h, max(p[0], q[0]), max(p[1], q[1]) + h)
            for p, q in zip(corners, corners[1:], strict=False)
        ]
        drop, labels = "", list[Label]()
        if self.named == "middle":
            drop, labels = _named(self.link, self.unit, 0.5 * (a + b), ya, self.width)
        elif self.named == "start":
            labels = [_beside(self.lines, (a + 6.0, ya, "start"), yb, h)]
        elif self.named == "end":
            labels = [_beside(self.lines, (b - 6.0, yb, "end"), ya, h)]
        return f'<path class="pp-band" fill="{colour}" d="{path}"/>{drop}', labels, slices


def _band(joined: _Joined, ends: Sequence[_Joined], unit: Scale, lane: float | None = None) -> _Band:
    """Band at the next places of both boxes; named at the end where it is the larger part of all bands."""
    link, start, end, width = joined
    y = start.port(1, width), end.port(0, width)
    parts = [width / _load(box, ends, side) for box, side in ((start, 1), (end, 0))]
    alone = min(parts) > 1.0 - 1e-9
    if start.outside or end.outside:
        named = ""
    elif lane is not None or alone and abs(y[1] - y[0]) <= 0.5 * width:
        named = "middle"
    else:
        named = "start" if parts[0] > parts[1] else "end"
    return _Band(link, start, end, width, y, named, unit, lane)


def _places(boxes: Sequence[_Box], bands: Sequence[_Band]) -> dict[int, float]:
    """Left edges of the columns [pixels], with room for the names between them."""
    columns = range(min(box.column for box in boxes), max(box.column for box in boxes) + 1)
    gaps = dict.fromkeys(columns, BEND)
    for band in bands:
        at_end, at_start = band.end.column - 1, band.start.column
        beside = (
            {at_end, at_start} if band.lane is not None else {at_end if band.named == "end" else at_start}
        )
        gaps |= {k: max(gaps.get(k, BEND), band.needs) for k in beside}
    found, at = {}, SIDE
    for column in columns:
        found[column] = at
        at += WIDTH_BLOCK + gaps[column]
    return found


def _named(link: PowerLink, unit: Scale, x: float, y: float, width: float) -> tuple[str, list[Label]]:
    """Drop for the loss of a straight band; name and power above the band, the loss below it."""
    words = ((link.name, "pp-halo"), (unit.text(link.given), "pp-small"))
    labels = [Label(x, y - 0.5 * width - 10.0 - LINE, "middle", words)]
    if not link.lost > ROUND_OFF * link.given:
        return "", labels
    below, drop = y + 0.5 * width, min(max(THINNEST, width * link.lost / link.given), 40.0)
    line = (
        f'<line class="pp-drop" stroke-width="{drop:.1f}" '
        f'x1="{x:.1f}" x2="{x:.1f}" y1="{below:.1f}" y2="{below + 12.0:.1f}"/>'
    )
    return line, [*labels, Label(x, below + 26.0, "middle", ((_loss(link), "pp-small"),))]


def _beside(
    lines: Sequence[tuple[str, str]], place: tuple[float, float, str], other_y: float, half: float
) -> Label:
    """Lines of text at the end of a curved band, on the side away from its other end."""
    x, y, anchor = place
    top = y + half + 15.0 if other_y < y else y - half - 6.0 - LINE * (len(lines) - 1)
    return Label(x, top, anchor, tuple(lines))


def _more(name: str) -> float:
    """Height of a second line of a name [pixels]."""
    return ROW * (len(name_lines(name)) - 1)


def _loss(link: PowerLink) -> str:
    """Loss in words, with the sign of the table."""
    return f"{amount(link.lost, 'W')} lost"


def _block(box: _Box, x: float) -> str:
    """Block with its name and speed, or text of a source or sink."""
    shape = ""
    if not box.outside:
        shape = (
            f'<rect class="pp-block" rx="5" x="{x:.1f}" y="{box.y:.1f}" '
            f'width="{WIDTH_BLOCK:.0f}" height="{box.height:.1f}"/>'
        )
    name = name_lines(box.words[0])
    full = f"<title>{escape(box.words[0])}</title>" if "".join(name) != box.words[0] else ""
    styles = [(words, "pp-name") for words in name] + [(box.words[1], "pp-small")]
    first = box.y + 0.5 * box.height - 0.5 * ROW * len(styles) + 12.0
    lines = (
        text(x + 0.5 * WIDTH_BLOCK, first + ROW * k, words, style) for k, (words, style) in enumerate(styles)
    )
    return f"<g>{full}{shape}{''.join(lines)}</g>"


def name_lines(name: str) -> list[str]:
    """Name in one line, or in two if it is wider than a block; what is still too long is cut.

    Examples
    --------
    >>> name_lines("output"), name_lines("high_speed_shaft"), name_lines("wheel_gap_015")
    (['output'], ['high_speed_', 'shaft'], ['wheel_gap_', '015'])
    """
    if len(name) <= LETTERS:
        return [name]
    ends = [k for k, letter in enumerate(name, start=1) if letter in " _-." and k <= LETTERS]
    at = max(ends, default=LETTERS)
    rest = name[at:]
    return [name[:at], rest if len(rest) <= LETTERS else f"{rest[: LETTERS - 1]}…"]
