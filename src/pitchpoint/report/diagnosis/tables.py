# SPDX-License-Identifier: Apache-2.0
"""Tables of the diagnosis page."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape

from pitchpoint.analysis.bearing_tests import alike
from pitchpoint.analysis.findings import Evidence
from pitchpoint.analysis.indicators import signal_indicators
from pitchpoint.report.diagnosis.study import Study
from pitchpoint.report.diagnosis.tooth_places import GAUSSIAN, INDICATORS, GearTurn, crest
from pitchpoint.report.diagnosis.words import NEVER, cells_of_test, unit_of
from pitchpoint.viz.quantities import number, scale
from pitchpoint.viz.tables import plain_table

HARMONICS = 5


def rows_html(rows: Iterable[Sequence[str]], words: int, texts: Sequence[int] = ()) -> list[str]:
    """HTML rows of a table: `words` columns of text, then numbers; a leading `**` gives bold type.

    `texts` are further columns of text.
    """
    made = []
    for row in rows:
        cells = []
        for k, text in enumerate(row):
            plain = escape(text.removeprefix("**"))
            shown = f"<b>{plain}</b>" if text.startswith("**") else plain
            cells.append(f"<td>{shown}</td>" if k < words or k in texts else f'<td class="num">{shown}</td>')
        made.append(f"<tr>{''.join(cells)}</tr>")
    return made


def origin_table(study: Study) -> str:
    """Table of quantity, value, origin."""
    return plain_table(("quantity", "value", "source"), rows_html(study.origin, 3), numbers=False)


def shaft_table(study: Study) -> str:
    """Table of shafts with gears, if any, ratio, speed and turns in the record."""
    hertz, turns = study.over.frequency, study.diagnosis.turns
    rows = []
    for shaft in study.parts.shafts:
        gears = ", ".join(f"{gear} ({z})" for gear, (_, z) in study.parts.gears_of(shaft.name).items())
        order = float(shaft.order)
        rows.append(
            (
                shaft.name,
                *([gears or "–"] if study.parts.meshes else []),
                str(shaft.order) if shaft.order.denominator < 1000 else number(order, 7),
                *_rates(order, hertz, study.over.speeds),
                number(turns[shaft.name], 4) if shaft.name in turns else "–",
            )
        )
    words = ("shaft", "gears (teeth)") if study.parts.meshes else ("shaft",)
    return plain_table((*words, "ratio", "[Hz]", "[rpm]", "turns in the record"), rows_html(rows, len(words)))


def mesh_table(study: Study) -> str:
    """Table of meshes with frequency and the harmonics above half the sample rate."""
    first = next(iter(study.diagnosis.meshes.values()), ())
    rows = []
    for mesh, line in zip(study.parts.meshes, first, strict=True):
        seen = any(lines[first.index(line)].seen for lines in study.diagnosis.meshes.values())
        rows.append(
            (
                mesh.name,
                f"{mesh.gears[0]} and {mesh.gears[1]}",
                f"{mesh.teeth[0]}/{mesh.teeth[1]}",
                number(line.order, 6),
                _rates(line.order, study.over.frequency, study.over.speeds)[0],
                "yes" if seen else "no",
                ", ".join(str(k) for k in line.lost) or "none",
            )
        )
    head = (
        "mesh",
        "gears",
        "teeth",
        "order",
        "[Hz]",
        "visible",
        f"harmonics not covered (of {HARMONICS})",
    )
    return plain_table(head, rows_html(rows, 2)) if rows else ""


def bearing_table(study: Study) -> str:
    """Table of bearings with the frequencies of their parts."""
    rows = [
        (bearing.name, part, number(order, 5), _rates(order, study.over.frequency, study.over.speeds)[0])
        for bearing in alike(study.parts.bearings)
        for part, order in bearing.orders.items()
    ]
    return plain_table(("bearing", "part", "order", "[Hz]"), rows_html(rows, 2)) if rows else ""


def test_table(study: Study) -> str:
    """Table of all tests by channel."""
    where = "at [Hz]" if math.isfinite(study.over.frequency) else "at order"
    head = ("shaft or bearing", "test", where, "value", "limit", "by noise", "result")
    body = []
    for channel in study.over.signals:
        if len(study.over.signals) > 1:
            body.append(f'<tr><td colspan="{len(head)}"><b>{escape(channel)}</b></td></tr>')
        mine = [e for e in study.diagnosis.evidence if e.channel == channel]
        body += rows_html((_test_row(e, study) for e in mine), 2, texts=(6,))
    return plain_table(head, body, texts=(6,))


def _test_row(e: Evidence, study: Study) -> tuple[str, ...]:
    """Table cells of one test."""
    hertz = study.over.frequency
    whose, test, value, limit, chance, result = cells_of_test(e, study.diagnosis)
    where = _rates(e.order, hertz)[0] if math.isfinite(hertz) else number(e.order, 5)
    return whose, test, where, value, limit, chance, f"**{result}" if result == "found" else result


def limit_table(study: Study, channel: str) -> str:
    """Table of the values of one channel and the limits above which a fault is reported."""
    unit = study.units.get(channel, "")
    rms = signal_indicators(study.over.signals[channel]).rms
    rows = []
    for e in study.diagnosis.evidence:
        if e.channel != channel:
            continue
        now, needed = _amplitudes(e, rms, unit)
        whose = f"{e.shaft} of {e.gear}" if e.kind == "bearing" else e.shaft
        rows.append(
            (
                whose,
                _fault(e),
                f"{number(round(e.value, 1), 4)} {unit_of(e.kind)}" if e.value > NEVER else "–",
                f"{number(round(e.threshold, 1), 4)} {unit_of(e.kind)}",
                now,
                needed,
            )
        )
    head = ("part", "detected as", "value", "limit", "strongest line", "line at the limit")
    return plain_table(head, rows_html(rows, 2))


def indicator_tables(turns: Sequence[GearTurn], unit: str) -> str:
    """Table of indicators of mean turns; in brackets the value exceeded by 1 % of noise of equal spectrum."""
    if not turns:
        return ""
    best = scale(unit, [float(row.turn.average.std()) for row in turns])
    levels, shapes = [], []
    for row in turns:
        gear = f"{' or '.join(row.gears)} ({row.teeth})"
        cells = {name: _against(*row.turn.indicators[name]) for name in INDICATORS}
        levels.append(
            (
                gear,
                row.shaft,
                str(row.turn.averages),
                number(float(row.turn.average.std()) * best.factor, 3),
                number(float(row.turn.residual.std()) * best.factor, 3),
                number(crest(row.turn), 3),
                f"{number(100.0 * row.turn.energy.share, 2)} ({number(100.0 / row.teeth, 2)})",
            )
        )
        fm0 = number(row.fm0, 3) if math.isfinite(row.fm0) else "–"
        shapes.append((gear, row.shaft, fm0, *cells.values()))
    gaussian = [number(GAUSSIAN[name], 3) for name in INDICATORS]
    shapes.append(("Gaussian noise", "", "", *gaussian))
    head = ("gear (teeth)", "shaft")
    rms = (best.title("rms"), best.title("rms of residual"))
    return plain_table(
        (*head, "turns", *rms, "crest", "tooth energy [%]"), rows_html(levels, 2)
    ) + plain_table((*head, "FM0", *INDICATORS.values()), rows_html(shapes, 2))


def _against(value: float, limit: float, part: float) -> str:
    """Indicator with its limit in brackets, bold if exceeded."""
    return f"{'**' if part < 0.01 else ''}{number(value, 3)} ({number(limit, 3)})"


def _amplitudes(e: Evidence, rms: float, unit: str) -> tuple[str, str]:
    """Amplitudes of the strongest line and of a line at the limit; dashes if there is no line."""
    if e.kind not in ("low order", "sidebands") or e.value < NEVER or e.amplitude <= 0.0:
        return "–", "–"
    needed = max(e.amplitude * 10.0 ** ((e.threshold - e.value) / 20.0), 0.01 * rms)
    best = scale(unit, [needed])
    return tuple(best.text(a, 3) for a in (e.amplitude, needed))  # type: ignore[return-value]


def _fault(e: Evidence) -> str:
    """Kind of damage that a test detects."""
    if e.kind == "bearing":
        return "bearing impacts in the envelope"
    if e.kind == "sidebands":
        return f"modulation of the mesh of {e.gear} over a turn"
    if e.kind == "period":
        return f"one event per turn, in the wavelet level of {e.gear}"
    return {"comb": "one impact per turn: all orders", "low order": "unbalance, misalignment"}[e.kind]


def _rates(order: float, hertz: float, speeds: tuple[float, float] | None = None) -> tuple[str, str]:
    """Hz and rpm of an order, with a varying speed their ranges; dashes if these are unknown."""
    if speeds is not None:
        low, high = (tuple(number(k * order * speed, 4) for k in (1.0, 60.0)) for speed in speeds)
        return f"{low[0]} to {high[0]}", f"{low[1]} to {high[1]}"
    if not math.isfinite(hertz):
        return "–", "–"
    return number(order * hertz, 5), number(60.0 * order * hertz, 5)
