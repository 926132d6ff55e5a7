# SPDX-License-Identifier: Apache-2.0
"""Sections of a report with tables: modes, signals, parameters."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from pitchpoint.viz.mode_plot import plot_modes
from pitchpoint.viz.quantities import damping_words, number, printed
from pitchpoint.viz.report.page import Section, keep_height
from pitchpoint.viz.tables import plain_table

MAX_ROWS = 100
MAX_MODES = 20


def mode_section(modes: Mapping[str, Any]) -> Section:
    """Section with natural frequencies and damping about loaded states, by the names of their scenarios."""
    section = Section("modes", "Modes")
    shown = {name: own for name, own in modes.items() if len(own.names)}
    for name, own in shown.items():
        section.add_name(name, shown)
        _add_modes(section, own)
    return section


def _add_modes(section: Section, modes: Any) -> None:
    """Add the modes about one loaded state."""
    body = []
    rows = zip(modes.names, modes.frequency, modes.damping_ratio, strict=True)
    for k, (name, frequency, ratio) in enumerate(rows, start=1):
        known = math.isfinite(ratio) and frequency > 0.0
        damping = damping_words(ratio) if known else "–"
        if known and abs(ratio) == 1.0:
            damping = "overdamped" if ratio > 0.0 else "unstable"
        body.append(
            f'<tr><th scope="row">{k}</th><td>{escape(name)}</td>'
            f'<td class="num">{number(frequency)} Hz</td><td class="num">{damping}</td></tr>'
        )
    section.add(f"<p>{escape(_conditions(modes))}</p>")
    section.add(plain_table(("mode", "name", "natural frequency at rest", "damping ratio"), body[:MAX_MODES]))
    if len(modes.components):
        drawn = plot_modes(modes.names, modes.frequency, modes.components, modes.strain_share)
        keep_height(drawn)
        section.add_figure(
            drawn,
            "Strain energy of the lowest modes by component, in percent. A stiffness moves the modes in "
            "which its component has much strain energy.",
            name="modes",
        )
    total = max(modes.total, len(body))
    if total > MAX_MODES:
        section.add(f"<p>The lowest {MAX_MODES} of {total} modes; use pitchpoint modes for all.</p>")


def _conditions(modes: Any) -> str:
    """Scenario and prescribed motions of modes, in words."""
    of = f" of scenario {modes.scenarios[0]}" if modes.scenarios else ""
    of += f" at {modes.at}," if modes.at else ""
    words = f"Linearised about the loaded state{of} with mean mesh stiffness"
    if modes.held:
        words += f"; prescribed motion: {', '.join(modes.held)}"
    elif modes.scenarios:
        words += "; no prescribed motion"
    words += f"; engaged: {', '.join(modes.engaged)}" if modes.engaged else ""
    words += "."
    if len(modes.scenarios) > 1:
        words += f" Scenarios with the same prescribed motions: {', '.join(modes.scenarios[1:])}."
    if modes.others:
        or_clutches = " or engaged clutches" if modes.engaged else ""
        plural = "s" if len(modes.others) > 1 else ""
        words += (
            f" The prescribed motions{or_clutches} of scenario{plural} {', '.join(modes.others)} differ, and "
            f"so do the modes: for a report of these, give {'their results' if plural else 'its result'}."
        )
    return words


def signal_section(lines: Sequence[Sequence[str]]) -> Section:
    """Section with sensors, blocks, controllers and actuators."""
    section = Section("signals", "Signals and control")
    if lines:
        rows = [f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in line)}</tr>" for line in lines]
        head = ("signal", "type", "inputs", "used by")
        section.add(plain_table(head, rows[:MAX_ROWS], numbers=False))
    return section


def parameter_section(lines: Sequence[Sequence[str]]) -> Section:
    """Section with the parameters of the model; without formulas and descriptions, only their values."""
    section = Section("parameters", "Parameters")
    table = [(name, *map(printed, (written, value)), words) for name, written, value, words in lines]
    head = ("parameter", "as written", "value", "description")
    plain = all(written == value for _, written, value, _ in table)
    kept = [k for k in range(4) if not (k == 1 and plain) and any(line[k] for line in table)]
    rows = [f"<tr>{''.join(f'<td>{escape(line[k])}</td>' for k in kept)}</tr>" for line in table]
    section.add(plain_table([head[k] for k in kept], rows, numbers=False) if rows else "")
    return section
