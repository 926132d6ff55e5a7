# SPDX-License-Identifier: Apache-2.0
"""The picture on the first page, drawn from a real run: teeth in mesh, and a speed sweep up and down.

Usage: ``python docs/make_picture.py docs/images/overview.svg``. Nothing in it is typed in: the outlines come
from the geometry of `examples/backlash-oscillator/model.yaml`, the curves from its sweep.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint import compile_model, load_model
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.placement import mesh_outlines
from pitchpoint.sweep.speed import run_sweep
from pitchpoint.viz.svg import clip
from pitchpoint.viz.theme import FONT, LIGHT, RED, SWEEP

Array = NDArray[np.float64]

MODEL = Path(__file__).parents[1] / "examples" / "backlash-oscillator" / "model.yaml"
WIDTH, HEIGHT = 960, 400
TEETH = (14.0, 14.0, 372.0, 372.0)  # left, top, width, height of the drawing [px]
PLOT = (460.0, 44.0, 484.0, 302.0)
SCALE = 7.4  # pixels per mm of gear


def line(points: Iterable[Any], colour: str, width: float, extra: str = "") -> str:
    """Open line through points in pixels."""
    path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
    return f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width}" {extra}/>'


def words(
    x: float, y: float, text: str, anchor: str = "middle", colour: str = LIGHT["ink"], more: str = ""
) -> str:
    """One line of text."""
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}" {more}>{escape(text)}</text>'
    )


def teeth(pair: GearPair) -> list[str]:
    """Both gears around the pitch point, front flanks touching, with the path of contact A-E."""
    left, top, width, height = TEETH
    phi1 = 0.3 * 2.0 * math.pi / pair.gear1.z
    phi2 = (0.5 * pair.j_bt - pair.gear1.r_b * phi1) / pair.gear2.r_b
    middle = np.array([left + 0.5 * width, top + 0.5 * height])
    pitch = np.array([0.5 * pair.d_w1, 0.0])

    def pixels(points: Any) -> Array:
        p = (np.asarray(points, dtype=np.float64) - pitch) * 1e3 * SCALE
        return middle + p * np.array([1.0, -1.0])

    low, high = np.array([left, top]), np.array([left + width, top + height])
    parts = []
    for outline, fill in zip(
        mesh_outlines(pair, phi1, 30, phi2=phi2), (LIGHT["gear"], LIGHT["mate"]), strict=True
    ):
        ring = clip(pixels(outline), low, high)
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in ring) + "Z"
        parts.append(f'<path d="{path}" fill="{fill}" stroke="{LIGHT["edge"]}" stroke-width="1.2"/>')
    # front flank: the line of action rises from gear 1 towards gear 2 at alpha_wt from the common tangent
    along = np.array([math.sin(pair.alpha_wt), math.cos(pair.alpha_wt)])
    ends = [pitch + (s - pair.T1C) * along for s in (pair.T1A, pair.T1E)]
    far = [pitch + s * along for s in (-0.021, 0.021)]
    parts.append(line(pixels(far), RED, 1.2, 'stroke-dasharray="5 4"'))
    parts.append(line(pixels(ends), RED, 3.5, 'stroke-linecap="round"'))
    for point, name, side in ((ends[0], "A", 16), (pitch, "C", 16), (ends[1], "E", 16)):
        x, y = pixels(point)
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="#fff" stroke="{RED}" stroke-width="2"/>')
        halo = 'font-weight="600" stroke="#fff" stroke-width="4" paint-order="stroke"'
        parts.append(words(x + side, y + 5.0, name, "middle", LIGHT["ink"], halo))
    frame = (
        f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="none" stroke="{LIGHT["grid"]}"/>'
    )
    return [*parts, frame]


def sweep(found: Any) -> list[str]:
    """The rms of the deflection over the mesh frequency, one line per direction, and the jumps."""
    left, top, width, height = PLOT
    points = [(p["direction"], p["mesh_frequency"] / 1e3, p["deflection"]["rms"] * 1e6) for p in found.points]
    f_low, f_high = min(p[1] for p in points), max(p[1] for p in points)
    y_high = 5.0 * math.ceil(max(p[2] for p in points) / 5.0)

    def pixels(f: float, rms: float) -> tuple[float, float]:
        return left + width * (f - f_low) / (f_high - f_low), top + height * (1.0 - rms / y_high)

    parts = []
    for rms in np.arange(0.0, y_high + 1.0, 5.0):
        x, y = pixels(f_low, float(rms))
        parts.append(line([(x, y), (x + width, y)], LIGHT["grid"], 1.0))
        parts.append(words(x - 8, y + 5, f"{rms:.0f}", "end", LIGHT["soft"]))
    for f in np.arange(math.ceil(2 * f_low) / 2, f_high + 1e-9, 0.5):
        x, y = pixels(float(f), 0.0)
        parts.append(line([(x, y), (x, y + 5)], LIGHT["soft"], 1.0))
        parts.append(words(x, y + 21, f"{f:.1f}", "middle", LIGHT["soft"]))
    for jump in found.jumps:
        colour = SWEEP[jump["direction"]][0]
        x, _ = pixels(jump["mesh_frequency"] / 1e3, 0.0)
        parts.append(line([(x, top), (x, top + height)], colour, 1.0, 'stroke-dasharray="3 4"'))
    for direction, (colour, _) in SWEEP.items():
        curve = [pixels(f, rms) for d, f, rms in points if d == direction]
        parts.append(line(curve, colour, 2.2, 'stroke-linejoin="round"'))
        tip = -3.6 if direction == "up" else 3.6
        for x, y in curve[::3]:
            foot = f"M{x - 3.6:.1f} {y - tip:.1f}L{x + 3.6:.1f} {y - tip:.1f}"
            parts.append(f'<path d="{foot}L{x:.1f} {y + tip:.1f}Z" fill="{colour}"/>')
    x, y = left + width - 8.0, top + 20.0
    parts.append(words(x, y, "▲ speed rising", "end", SWEEP["up"][0]))
    parts.append(words(x, y + 20.0, "▼ speed falling", "end", SWEEP["down"][0]))
    parts.append(words(x, y + 40.0, "dashed: jumps found", "end", LIGHT["soft"]))
    parts.append(words(left, top - 18.0, "rms of the deflection [µm]", "start"))
    parts.append(words(left + 0.5 * width, top + height + 44.0, "mesh frequency [kHz]"))
    return parts


def main(target: Path) -> None:
    """Run the example and write the picture."""
    model = load_model(MODEL)
    found = run_sweep(compile_model(model, "sweep"), model.scenarios["sweep"])
    body = "".join([*teeth(model.pairs["stage"]), *sweep(found)])
    title = "Two gears in mesh, and their vibration while the speed rises and falls"
    target.parent.mkdir(parents=True, exist_ok=True)
    size = f'width="{WIDTH}" height="{HEIGHT}"'
    font = FONT.replace("'", "")
    target.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {WIDTH} {HEIGHT}" '
        f'font-family="{font}" font-size="14" role="img"><title>{title}</title>'
        f'<rect {size} fill="#fff"/>{body}</svg>\n',
        encoding="utf-8",
    )
    jumps = ", ".join(f"{j['direction']} {j['mesh_frequency']:.0f} Hz" for j in found.jumps)
    print(f"{target} written; jumps: {jumps}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/images/overview.svg"))
