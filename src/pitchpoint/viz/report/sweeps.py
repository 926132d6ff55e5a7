# SPDX-License-Identifier: Apache-2.0
"""Section of a report with speed sweeps: response, jumps, and contact of all meshes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.mesh_sweep import MeshSweep, mesh_sweeps, points_of_mesh, swept_meshes
from pitchpoint.viz.quantities import amount, channel_scale, number, scale
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.sweep_meshes import closing_words, contact_sentences, jump_words, mesh_rows, percent
from pitchpoint.viz.sweep_plot import plot_contact_shares, plot_meshes, plot_sweep
from pitchpoint.viz.tables import plain_table


def sweep_section(sweeps: Mapping[str, Mapping[str, Any]]) -> Section:
    """Section with speed sweeps, jumps and contact loss."""
    section = Section("sweep", "Speed sweep")
    for name, sweep in sweeps.items():
        points, jumps = sweep.get("points", ()), sweep.get("jumps", ())
        if not points:
            continue
        section.add_name(name, sweeps)
        found = mesh_sweeps(points)
        several = len(swept_meshes(points)) > 1
        swept = points_of_mesh(points, swept_meshes(points)[0])
        names = dict.fromkeys(("mesh", "swept"), swept_meshes(points)[0] if several else "")
        section.add(_mesh_table(found) if several else "")
        for quantity, statistic in (("deflection", "rms"), ("mesh_force", "magnitude")):
            if quantity == "mesh_force" and several:
                section.add_figure(*plot_meshes(points, quantity), name=quantity)
            elif any(p.get(quantity) for p in swept):
                caption = _jump_sentence(jumps, names["mesh"]) if quantity == "deflection" else ""
                drawn = plot_sweep(swept, jumps, quantity=quantity, statistic=statistic, **names)
                section.add_figure(drawn, caption, name=quantity)
        words = " ".join(contact_sentences(found))
        section.add(f"<p>{escape(words)}</p>" if words else "")
        if any(one.apart for one in found):
            caption = "Time without contact as a share of the evaluated time."
            drawn, more = (
                plot_meshes(points, "contact_shares") if several else (plot_contact_shares(swept), "")
            )
            section.add_figure(drawn, f"{caption} {more}".rstrip(), name="contact_shares")
        if any(one.closing > 0.0 for one in found):
            section.add_figure(*plot_meshes(points, "closing_speed_max"), name="closing_speed_max")
    return section


def _mesh_table(found: Sequence[MeshSweep]) -> str:
    """Table of the greatest values of every mesh."""
    impacts = any(one.closing > 0.0 for one in found)

    def at(value: str, frequency: float) -> str:
        """Value with its mesh frequency."""
        return f"{value} at {amount(frequency, 'Hz')}" if math.isfinite(frequency) else value

    def cells(one: MeshSweep) -> list[str]:
        """Cells of one mesh in one direction."""
        deflection = channel_scale("deflection", "m", np.array([one.rms])).text(one.rms)
        return [
            one.direction,
            at(deflection, one.rms_at),
            at(amount(one.force, "N"), one.force_at),
            at(percent(one.loss), one.loss_at),
            *([closing_words(one.closing)] if impacts else []),
            jump_words([one]),
        ]

    rows, note = mesh_rows(found, cells)
    body = [
        f'<tr><th scope="row">{escape(mesh)}</th>{"".join(f"<td>{escape(cell)}</td>" for cell in own)}</tr>'
        for mesh, *own in rows
    ]
    head = ["mesh", "direction", "maximum rms of deflection", "maximum mesh force", "maximum contact loss"]
    head += [*["maximum closing speed"] * impacts, "jumps at"]
    return plain_table(head, body, numbers=False) + (f"<p>{escape(note)}</p>" if note else "")


def _jump_sentence(jumps: Sequence[Mapping[str, Any]], mesh: str = "") -> str:
    """Sentence on the jumps, of one of several meshes with its name."""
    if not jumps:
        return f"No jump found in {f'the deflection of {mesh}' if mesh else 'this sweep'}."
    pitch = scale("Hz", [float(j["mesh_frequency"]) for j in jumps])
    places = ", ".join(
        f"{j['direction']} at {number(float(j['mesh_frequency']) * pitch.factor)}" for j in jumps
    )
    return f"Jumps{f' of {mesh}' if mesh else ''}: {places} {pitch.unit} mesh frequency."
