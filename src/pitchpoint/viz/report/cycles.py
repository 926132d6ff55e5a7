# SPDX-License-Identifier: Apache-2.0
"""Sections of a report over mesh cycles: mesh cycles of the model, and given slow rolls."""

from __future__ import annotations

import math
from collections.abc import Mapping
from html import escape
from typing import Any

import numpy as np

from pitchpoint.viz.mesh_cycle_plot import (
    ROUND_OFF,
    plot_load_sharing,
    plot_mesh_stiffness,
    plot_transmission_error,
)
from pitchpoint.viz.quantities import amount, channel_scale, number, scale, span
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.report.planets import planet_table
from pitchpoint.viz.same_curves import grouped
from pitchpoint.viz.tables import common_name

MAX_CYCLES = 4
"""Maximum number of stiffness cycles in a plot."""
CONSTANT = 1e-9
"""Relative variation of a constant stiffness."""
SAME = 0.02
"""Difference of two curves over their variation that is within the width of a line."""
ALIKE = 1e-9
"""Relative difference of equal reference stiffnesses."""
ROUND_OFF_WAY = 1e-6
"""Travel before contact at mid-face that counts as round-off [base pitches]: zero for spur gears."""


def mesh_cycle_section(
    cycles: Mapping[str, Any], planets: Mapping[str, Mapping[str, Any]] | None = None
) -> Section:
    """Section with stiffness and transmission error over the mesh cycle, and load sharing of planets."""
    section = Section("cycle", "Mesh cycle")
    if planets:
        section.add(f"<h3>Load sharing of the planets in slow rolls</h3>{planet_table(planets)}")
    for meshes, cycle in grouped(cycles, _same):
        mesh = common_name(meshes)
        section.add_name(mesh, cycles)
        if cycle.stiffness is not None:
            _add_stiffness(section, mesh, cycle)
        if cycle.errors and all(float(np.ptp(e)) <= ROUND_OFF for e in cycle.errors.values()):
            micrometres = channel_scale("transmission_error", "m", np.zeros(1))
            means = ", ".join(
                f"{micrometres.text(float(np.mean(e)))} {name}" for name, e in cycle.errors.items()
            )
            section.add(f"<p>The quasi-static transmission error is constant: {escape(means)}.</p>")
        elif cycle.errors:
            drawn = plot_transmission_error(cycle.error_phase, cycle.errors, cycles=_drawn_cycles(cycle))
            words = f"Quasi-static transmission error along the line of action over {_words(cycle)}."
            section.add_figure(drawn, words, name=f"transmission_error[{mesh}]")
        if np.size(cycle.share):
            words = "Load share of one tooth pair, from its first to its last contact"
            if float(np.min(cycle.share_way)) < -ROUND_OFF_WAY:
                words += "; helical teeth touch at one end of the face before mid-face"
            drawn = plot_load_sharing(cycle.share_way, cycle.share)
            section.add_figure(drawn, f"{words}.", name=f"load_share[{mesh}]")
    return section


def _same(one: Any, other: Any) -> bool:
    """Whether two cycles have the same stiffness, load share and, about their means, errors."""
    if (one.stiffness is None) != (other.stiffness is None) or one.cycles != other.cycles:
        return False
    if one.stiffness is not None and one.stiffness_unit != other.stiffness_unit:
        return False
    if not math.isclose(one.unit_stiffness or 0.0, other.unit_stiffness or 0.0, rel_tol=ALIKE):
        return False
    pairs = [(one.share, other.share), (one.loaded_ratio, other.loaded_ratio)]
    if one.stiffness is not None:
        pairs.append((one.stiffness.stiffness_ratio, other.stiffness.stiffness_ratio))
    if len(one.errors) != len(other.errors):
        return False
    pairs += list(zip(one.errors.values(), other.errors.values(), strict=True))
    return all(_close(np.asarray(a, float), np.asarray(b, float)) for a, b in pairs)


def _close(a: Any, b: Any) -> bool:
    """Whether two curves have the same shape within the width of a line."""
    if a.shape != b.shape or not a.size:
        return bool(a.shape == b.shape)
    width = max(float(np.ptp(a)), float(np.ptp(b)))
    return bool(np.abs((a - a.mean()) - (b - b.mean())).max() <= SAME * width + ROUND_OFF)


def _add_stiffness(section: Section, mesh: str, cycle: Any) -> None:
    s = cycle.stiffness
    if not np.size(cycle.loaded_ratio) and float(s.maximum - s.minimum) <= CONSTANT * abs(float(s.mean)):
        one = cycle.unit_stiffness
        value = "" if one is None else f", {amount(one * float(s.mean), 'N/m')}"
        section.add(f"<p>The mesh stiffness is constant over the mesh cycle{value}.</p>")
        return
    loaded = (cycle.error_phase, cycle.loaded_ratio) if np.size(cycle.loaded_ratio) else None
    count = min(_drawn_cycles(cycle), MAX_CYCLES) if loaded else 2
    unit, one = cycle.stiffness_unit, cycle.unit_stiffness
    mean, low, high = float(s.mean), float(s.minimum), float(s.maximum)
    if one is not None:
        words = f"mean {amount(one * mean, 'N/m')}, from {span(one * low, one * high, 'N/m')}"
        words += f"; {unit} = {amount(one, 'N/m')}" if unit != "mean" else ""
    else:
        words = f"mean {number(mean)}, from {number(low)} to {number(high)}"
        words += f", in units of {'its mean' if unit == 'mean' else unit}"
    caption = f"Mesh stiffness over {_count(count)}: {words}."
    drawn = plot_mesh_stiffness(
        s,
        name=mesh,
        unit="× mean" if unit == "mean" else unit,
        reference=one,
        loaded=loaded,
        cycles=count,
    )
    section.add_figure(drawn, caption, name=f"mesh_stiffness[{mesh}]")


def roll_section(rolls: Mapping[str, Any]) -> Section:
    """Section with transmission errors of slow rolls over all their periods."""
    section = Section("roll", "Slow roll")
    for name, roll in rolls.items():
        section.add(f"<h3>{escape(name)}</h3>")
        section.add(f"<p>{escape(roll.note)}</p>" if roll.note else "")
        section.add(planet_table(roll.planets))
        for meshes, periods, errors in _distinct_rolls(roll.curves):
            mesh = common_name(meshes)
            drawn = plot_transmission_error(
                periods, errors, cycles=1, title=f"periods of {mesh} rolled [base pitches]"
            )
            section.add_figure(
                drawn, _roll_caption(mesh, periods, errors), name=f"transmission_error[{mesh}]"
            )
    return section


def _distinct_rolls(curves: Mapping[str, Any]) -> list[tuple[list[str], Any, Mapping[str, Any]]]:
    """Curves of a roll with the names of all meshes that have the same ones, about their means."""
    found: list[tuple[list[str], Any, Mapping[str, Any]]] = []
    for mesh, (periods, errors) in curves.items():
        if np.size(periods) < 2:
            continue
        for names, other_periods, other in found:
            alike = _close(np.asarray(periods, float), np.asarray(other_periods, float))
            pairs = zip(errors.values(), other.values(), strict=False)
            alike = alike and len(errors) == len(other)
            if alike and all(_close(np.asarray(a, float), np.asarray(b, float)) for a, b in pairs):
                names.append(mesh)
                break
        else:
            found.append(([mesh], periods, errors))
    return found


def _roll_caption(mesh: str, periods: Any, errors: Mapping[str, Any]) -> str:
    spans = {name: float(np.ptp(values)) for name, values in errors.items()}
    spans = {name: span if span > ROUND_OFF else 0.0 for name, span in spans.items()}
    shown = scale("m", [*spans.values(), ROUND_OFF])
    words = ", ".join(f"{shown.text(span)} {name}" for name, span in spans.items())
    words = words.replace(" mesh force", " at a mesh force of")
    count = number(float(np.max(periods)), 4)
    word = "rolled period" if count == "1" else "rolled periods"
    return f"Transmission error of {mesh} over {count} {word}; peak to peak {words}."


def _drawn_cycles(cycle: Any) -> int:
    """Number of drawn repetitions: two for a single cycle that repeats, else one."""
    return 2 if cycle.cycles == cycle.repeats == 1 else int(cycle.cycles)


def _words(cycle: Any) -> str:
    if cycle.cycles == cycle.repeats == 1:
        return _count(2)
    if cycle.cycles == cycle.repeats:
        return f"{_count(cycle.cycles)}, after which it repeats"
    if cycle.repeats > cycle.cycles:
        return f"the first {cycle.cycles} of {cycle.repeats} mesh cycles, after which it repeats"
    return f"{_count(cycle.cycles)}; no repetition within this range"


def _count(cycles: int) -> str:
    few = ("no", "one", "two", "three", "four")
    words = few[cycles] if cycles < len(few) else str(cycles)
    return f"{words} mesh cycle{'' if cycles == 1 else 's'}"
