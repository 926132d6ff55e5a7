# SPDX-License-Identifier: Apache-2.0
"""General sections of a report: summary, scene, provenance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.statistics import contact_statistics
from pitchpoint.viz.power_flow import PowerFlow
from pitchpoint.viz.quantities import Channel, amount, channels
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.run_record import owner, settled_part
from pitchpoint.viz.scene.page import scene_fragment
from pitchpoint.viz.tables import plain_table

HEIGHT = "clamp(430px, 78vh, 760px)"
"""Height of the scene, with space for scrolling on small screens."""


def summary_section(counts: Sequence[tuple[str, str]], results: Any) -> Section:
    """Section with the contents of the model, and one line per result."""
    section = Section("summary", "Summary")
    section.add(facts_list(counts))
    states = {source.name: "finished" if source.finished else source.sentence for source in results.sources}
    rows = [_run_row(name, run, states.get(name, ""), results.powers) for name, run in results.runs.items()]
    if rows:
        head = ("time response", "status", "input power", "maximum mesh force", "transmission error, p–p")
        section.add(plain_table((*head, "maximum contact loss"), rows))
    others = [source for source in results.sources if source.name not in results.runs]
    items = "".join(
        f"<li>{escape(source.kind[:1].upper() + source.kind[1:])} <b>{escape(source.name)}</b>: "
        f"{escape(states[source.name])}</li>"
        for source in others
    )
    section.add(f'<ul class="notes">{items}</ul>' if items else "")
    return section


def facts_list(rows: Sequence[tuple[str, str]]) -> str:
    """Definition list in columns."""
    items = "".join(f"<div><dt>{escape(key)}</dt><dd>{escape(text)}</dd></div>" for key, text in rows)
    return f'<dl class="known">{items}</dl>' if items else ""


def _run_row(name: str, run: Any, state: str, powers: Mapping[str, PowerFlow | str]) -> str:
    """Table row of one time response."""
    time, found = channels(run.data)
    window = settled_part(time, run.settle_time) if time.size else np.zeros(0, dtype=bool)
    flow = powers.get(name)
    cells = [
        escape(state),
        amount(flow.put_in, "W") if isinstance(flow, PowerFlow) and flow.put_in else "–",
        _largest(found, "mesh_force", window, lambda low, high: max(abs(low), abs(high))),
        _largest(found, "transmission_error", window, lambda low, high: high - low),
        _contact(found, time, window),
    ]
    words = "".join(f"<td{' class=num' if k else ''}>{cell}</td>" for k, cell in enumerate(cells))
    return f'<tr><th scope="row">{escape(name)}</th>{words}</tr>'


def _largest(found: Mapping[str, Channel], quantity: str, window: np.ndarray, size: Any) -> str:
    """Largest value of a quantity over all meshes, with the name of the mesh."""
    sizes = {}
    for channel in found.values():
        if channel.quantity != quantity or not np.all(np.isfinite(channel.values)) or not window.any():
            continue
        low, high = float(channel.values[window].min()), float(channel.values[window].max())
        known = channel.statistics or {"min": low, "max": high}
        sizes[owner(channel)] = size(min(low, known["min"]), max(high, known["max"]))
    if not sizes:
        return "–"
    name = max(sizes, key=lambda key: sizes[key])
    return amount(sizes[name], next(c.unit for c in found.values() if c.quantity == quantity)) + (
        f", {escape(name)}" if len(sizes) > 1 else ""
    )


def _contact(found: Mapping[str, Channel], time: np.ndarray, window: np.ndarray) -> str:
    """Largest share of time without contact over all meshes."""
    states = {owner(c): c.values[window] for c in found.values() if c.quantity == "contact_state"}
    if not states or window.sum() < 2:
        return "–"
    shares = {name: contact_statistics(time[window], state).loss_share for name, state in states.items()}
    name = max(shares, key=lambda key: shares[key])
    text = f"{100.0 * shares[name]:.3g} %"
    return text + (f", {escape(name)}" if len(shares) > 1 and shares[name] else "")


def scene_section(data: Any) -> Section:
    """Section with the scene, or a sentence if there is none."""
    section = Section("scene", "Scene")
    if data.scene is None:
        section.add(f"<p>{escape(data.words)}</p>" if data.words else "")
        return section
    section.add('<p class="screen"><a class="skip" href="#after-scene">Skip the scene</a></p>')
    section.add(f'<div class="scene">{scene_fragment(data.scene, height=HEIGHT)}</div>')
    section.add('<img id="pp-still" alt="The scene at the selected time" hidden>')
    section.add(f'<p id="after-scene" tabindex="-1">{escape(data.words)}</p>')
    return section


def provenance_section(sources: Sequence[Any]) -> Section:
    """Section with file, fingerprint, solver, options and status of each result."""
    section = Section("provenance", "Provenance")
    for source in sources:
        rows = [
            f'<tr><th scope="row">{escape(key)}</th><td>{escape(text)}</td></tr>' for key, text in source.rows
        ]
        if rows:
            section.add(f"<h3>{escape(source.name)}</h3>")
            section.add(
                f'<div class="scroll"><table class="plain"><tbody>{"".join(rows)}</tbody></table></div>'
            )
    return section
