# SPDX-License-Identifier: Apache-2.0
"""Work-precision curves of the page on solvers: all integrators on Andrews' squeezing mechanism.

Usage: ``python docs/make_work_precision.py docs/images/work_precision.svg``. Runs `compare-solvers`
on `examples/squeezing-mechanism/model.yaml` three times and takes the least processor time of every setting.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from pathlib import Path

from make_picture import line, words

from pitchpoint import compile_model, load_model
from pitchpoint.solvers.compare import Attempt, compare_solvers
from pitchpoint.viz.theme import FONT, LIGHT, SERIES

MODEL = Path(__file__).parents[1] / "examples" / "squeezing-mechanism" / "model.yaml"
WIDTH, HEIGHT = 960, 560
PLOT = (84.0, 44.0, 610.0, 440.0)  # left, top, width, height of the diagram [px]
REPEATS = 3
DASHES = {"": "", "I3": "", "SI2": "7 4", "SI1": "2 4"}

Curves = dict[tuple[str, str], list[tuple[float, float]]]


def curves() -> Curves:
    """Processor time [s] and error of every setting that finished, by method and form."""
    model = load_model(MODEL)
    found: dict[tuple[str, str, float], Attempt] = {}
    for _ in range(REPEATS):
        for a in compare_solvers(compile_model(model, "squeeze"), model.scenarios["squeeze"]).attempts:
            key = (a.method, a.form, a.value)
            if math.isfinite(a.error) and (key not in found or a.cpu_s < found[key].cpu_s):
                found[key] = a
    lines: Curves = {}
    for (method, form, _), a in found.items():
        lines.setdefault((method, form), []).append((a.cpu_s, a.error))
    return lines


def dot(x: float, y: float, form: str, colour: str) -> str:
    """Mark of one run: round for I3 and methods without forms, square for SI2, triangle for SI1."""
    if form == "SI2":
        return f'<rect x="{x - 3.5:.1f}" y="{y - 3.5:.1f}" width="7" height="7" fill="{colour}"/>'
    if form == "SI1":
        foot = f"M{x - 4.5:.1f} {y + 4.0:.1f}L{x + 4.5:.1f} {y + 4.0:.1f}"
        return f'<path d="{foot}L{x:.1f} {y - 4.5:.1f}Z" fill="{colour}"/>'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}"/>'


def diagram(lines: Curves) -> list[str]:
    """Axes, one line per method and form, and the list of them."""
    left, top, width, height = PLOT
    times = [t for points in lines.values() for t, _ in points]
    errors = [e for points in lines.values() for _, e in points]
    x_low, x_high = math.log10(min(times)) - 0.05, math.log10(max(times)) + 0.05
    y_low, y_high = math.floor(math.log10(min(errors))), math.ceil(math.log10(max(errors)))

    def pixels(point: Sequence[float]) -> tuple[float, float]:
        t, e = (math.log10(v) for v in point)
        return left + width * (t - x_low) / (x_high - x_low), top + height * (y_high - e) / (y_high - y_low)

    parts = []
    for decade in range(y_low, y_high + 1):
        _, y = pixels((1.0, 10.0**decade))
        parts.append(line([(left, y), (left + width, y)], LIGHT["grid"], 1.0))
        parts.append(words(left - 10, y + 5, f"1e{decade:+03d}", "end", LIGHT["soft"]))
    for exponent in range(math.floor(x_low), math.ceil(x_high) + 1):
        for factor in (1, 2, 5):
            t = factor * 10.0**exponent
            if x_low <= math.log10(t) <= x_high:
                x, _ = pixels((t, 1.0))
                parts.append(line([(x, top), (x, top + height)], LIGHT["grid"], 1.0))
                parts.append(words(x, top + height + 22, f"{t * 1e3:g}", "middle", LIGHT["soft"]))
    methods = dict.fromkeys(method for method, _ in lines)
    colours = dict(zip(methods, (*SERIES, LIGHT["ink"]), strict=True))
    for k, ((method, form), points) in enumerate(lines.items()):
        colour, places = colours[method], [pixels(p) for p in points]
        dash = f'stroke-dasharray="{DASHES[form]}"' if DASHES[form] else ""
        parts.append(line(places, colour, 1.8, dash))
        parts += [dot(x, y, form, colour) for x, y in places]
        x, y = left + width + 28.0, top + 14.0 + 24.0 * k
        parts.append(line([(x, y), (x + 34, y)], colour, 1.8, dash))
        parts.append(dot(x + 17, y, form, colour))
        parts.append(words(x + 44, y + 5, f"{method} {form}".strip(), "start"))
    parts.append(words(left, top - 18, "error of the worst result, share of its alternating part", "start"))
    parts.append(words(left + 0.5 * width, top + height + 50, "processor time [ms]"))
    return parts


def main(target: Path) -> None:
    """Run the comparison and write the picture."""
    lines = curves()
    title = "Accuracy over processor time of all integrators on Andrews' squeezing mechanism"
    size = f'width="{WIDTH}" height="{HEIGHT}"'
    font = FONT.replace("'", "")
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {WIDTH} {HEIGHT}" '
        f'font-family="{font}" font-size="14" role="img"><title>{title}</title>'
        f'<rect {size} fill="#fff"/>{"".join(diagram(lines))}</svg>\n',
        encoding="utf-8",
    )
    print(f"{target} written; {len(lines)} methods and forms")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/images/work_precision.svg"))
