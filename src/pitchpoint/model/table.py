# SPDX-License-Identifier: Apache-2.0
"""A model as plain HTML tables, for notebooks."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING

from pitchpoint.core.units import format_quantity
from pitchpoint.model.sections import groups_of
from pitchpoint.model.stand_ins import own_parts

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


SYMBOLS = {
    "m_n": "m<sub>n</sub>",
    "beta": "β",
    "m_mn": "m<sub>mn</sub>",
    "delta": "δ",
    "beta_m": "β<sub>m</sub>",
    "x_hm": "x<sub>hm</sub>",
    "R_m": "R<sub>m</sub>",
    "eps_alpha": "ε<sub>α</sub>",
    "eps_beta": "ε<sub>β</sub>",
    "backlash j_bt": "backlash j<sub>bt</sub>",
}
"""Symbols as printed."""


def table(head: Iterable[str], rows: Iterable[Iterable[object]]) -> str:
    """HTML table of escaped cells; symbols of the head have their subscripts."""
    top = "".join(f"<th>{SYMBOLS.get(h, escape(h))}</th>" for h in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(c))}</td>" for c in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


PLURALS = {"bodies": "body", "elastic_bodies": "elastic body", "meshes": "mesh", "bevel_meshes": "bevel mesh"}
PLURALS["clutches"] = "clutch"
"""Words for one component of a section, if not that of the section without s."""


def summary(model: Model) -> str:
    """Title, number of components of each section and names of the scenarios, as one line."""
    counts = []
    for section in groups_of(model):
        count = len(own_parts(getattr(model, section)))
        words = section.replace("_", " ")
        one = PLURALS.get(section, words.removesuffix("s"))
        if count and section != "scenarios":
            counts.append(f"{count} {one if count == 1 else words}")
    title = f" {model.title!r}" if model.title else ""
    names = list(model.scenarios)
    more = [f"scenario{'s' if len(names) > 1 else ''} {', '.join(names)}"] if names else []
    return f"Model{title}: {'; '.join([', '.join(counts) or 'empty', *more])}"


def model_table(model: Model) -> str:
    """Title and tables of gears, meshes and bodies."""
    out = [f"<p><b>{escape(model.title or 'Model')}</b></p>"]
    if model.gears:
        out.append(
            table(
                ("gear", "type", "z", "m_n", "beta", "x", "b"),
                (
                    (
                        name,
                        gear.type,
                        gear.number_of_teeth,
                        format_quantity(gear.normal_module, "length"),
                        f"{format_quantity(gear.helix_angle, 'angle')} {gear.hand or ''}".rstrip(),
                        f"{gear.x:.4f}",
                        format_quantity(gear.face_width, "length"),
                    )
                    for name, gear in model.gears.items()
                ),
            )
        )
    if model.bevel_gears:
        out.append(
            table(
                ("bevel gear", "z", "m_mn", "delta", "beta_m", "x_hm", "b"),
                (
                    (
                        name,
                        gear.number_of_teeth,
                        format_quantity(gear.geometry.m_mn, "length"),
                        format_quantity(gear.delta, "angle", 7),
                        f"{format_quantity(gear.spiral_angle, 'angle')} {gear.hand or ''}".rstrip(),
                        f"{gear.profile_shift_coefficient:.4f}",
                        format_quantity(gear.face_width, "length"),
                    )
                    for name, gear in model.bevel_gears.items()
                ),
            )
        )
    if model.meshes:
        out.append(
            table(
                ("mesh", "gears", "centre distance", "eps_alpha", "eps_beta", "backlash j_bt", "stiffness"),
                (
                    (
                        name,
                        " - ".join(mesh.gears),
                        format_quantity(abs(model.pairs[name].a_w), "length", 7),
                        f"{model.pairs[name].eps_alpha:.4f}",
                        f"{model.pairs[name].eps_beta:.4f}",
                        format_quantity(model.backlash(name), "length"),
                        mesh.law.law,
                    )
                    for name, mesh in model.meshes.items()
                ),
            )
        )
    if model.bevel_meshes:
        out.append(
            table(
                (
                    "bevel mesh",
                    "gears",
                    "shaft angle",
                    "R_m",
                    "eps_alpha",
                    "eps_beta",
                    "backlash",
                    "stiffness",
                ),
                (
                    (
                        name,
                        " - ".join(mesh.gears),
                        format_quantity(model.bevel_pairs[name].Sigma, "angle", 7),
                        format_quantity(model.bevel_pairs[name].R_m, "length", 7),
                        f"{model.bevel_pairs[name].eps_alpha:.4f}",
                        f"{model.bevel_pairs[name].eps_beta:.4f}",
                        format_quantity(model.backlash(name), "length"),
                        mesh.law.law,
                    )
                    for name, mesh in model.bevel_meshes.items()
                ),
            )
        )
    if model.bodies:
        out.append(
            table(
                ("body", "gears", "motion"),
                (
                    (name, ", ".join((*body.gears, *body.bevel_gears)), body.moves)
                    for name, body in model.bodies.items()
                ),
            )
        )
    return "".join(out)
