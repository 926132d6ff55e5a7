# SPDX-License-Identifier: Apache-2.0
"""Section of a report with contact analyses: results by torque, contact pattern, curves of the mesh cycle."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.flank_contact.active_flank import active_flanks
from pitchpoint.analysis.flank_contact.contact_pattern import (
    ContactPattern,
    contact_pattern,
    load_sharing,
    on_path,
)
from pitchpoint.analysis.flank_contact.load_factors import load_over_width
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.analysis.flank_contact.root_stress import root_stress_of_tooth, root_stress_over_width
from pitchpoint.core.units import format_quantity
from pitchpoint.viz import contact_plots as plots
from pitchpoint.viz.contact_table import (
    FLANKS,
    NEGLIGIBLE,
    columns,
    contact_words,
    flank_cells,
    gear_names,
    meshes_table,
    operation_words,
    options_of,
)
from pitchpoint.viz.mesh_cycle_plot import plot_transmission_error
from pitchpoint.viz.quantities import Array, amount, number
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.root_stress_plots import plot_root_stress, plot_root_stress_over_width
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import xarray as xr

MAX_CURVES = 5
"""Maximum number of torques in a plot with one curve each."""
MAX_COLUMNS = 10
"""Maximum number of columns after the first one of a table that fits on a page."""
DETAILS = ("mean_transmission_error", "mean_secant_stiffness", "mean_mesh_stiffness")
"""Results that a table of several meshes has no room for."""
OIL = (
    ("film_thickness", "thickness of the oil film", "m", -1.0),
    ("flash_temperature", "flash temperature", "K", 1.0),
    ("sliding_speed", "sliding speed", "m/s", 1.0),
)
"""Fields with operating conditions: name, title, unit, and whether maxima (1) or minima (-1) are drawn."""


@dataclass(frozen=True, kw_only=True)
class ContactData:
    """Contact analysis of one mesh.

    Attributes
    ----------
    data
        Dataset of `solve_contact`.
    numbers
        Its main results, of `contact_numbers`.
    note
        Sentence on an incomplete analysis.
    """

    data: xr.Dataset
    numbers: Mapping[str, Array]
    note: str = ""


def contact_result(data: xr.Dataset, note: str = "") -> ContactData:
    """Contact analysis with its main results."""
    return ContactData(data=data, numbers=contact_numbers(data), note=note)


def contact_section(analyses: Mapping[str, ContactData]) -> Section:
    """Section with contact analyses by name."""
    section = Section("contact", "Tooth contact")
    rolled = {name: one for name, one in analyses.items() if _on_shafts(one)}
    section.add(_meshes(rolled) if len(rolled) > 1 else "")
    for name, analysis in analyses.items():
        section.add_name(name, analyses)
        section.add(f"<p>{escape(analysis.note)}</p>" if analysis.note else "")
        if analysis.data.sizes.get("torque", 0):
            _add_analysis(section, analysis.data, analysis.numbers)
    return section


def overview_section(analyses: Mapping[str, ContactData], omitted: Mapping[str, str]) -> Section:
    """Section with a table of the meshes of a machine in equilibrium, and their loads over the face width."""
    section = Section("meshes", "All meshes")
    section.add(_meshes(analyses))
    for mesh, reason in omitted.items():
        section.add(f"<p>{escape(f'Mesh {mesh} is omitted: {reason}.')}</p>")
    figure = plots.plot_relative_loads(
        {
            name: (one.data["plane"].values, load_over_width(one.data)[0], one.data["plane_width"].values)
            for name, one in analyses.items()
        }
    )
    section.add_figure(
        figure,
        "Line load over its mean along the common face width of each mesh, from its end at −z to that at +z; "
        "sum of all tooth pairs, mean over the mesh cycle.",
        name="relative_loads",
    )
    return section


def _on_shafts(analysis: ContactData) -> bool:
    return "misalignment" in analysis.data and analysis.data.sizes.get("torque", 0) > 0


def _meshes(analyses: Mapping[str, ContactData]) -> str:
    """Table with one row per mesh on its shafts; empty without any."""
    head, *rows = meshes_table(
        {
            name: (
                float(one.data["torque"][0]),
                float(one.data["mesh_force"].mean()),
                float(one.data["misalignment"].mean() * one.data["plane_width"].sum()),
                {key: values for key, values in one.numbers.items() if key not in DETAILS},
            )
            for name, one in analyses.items()
        }
    )
    return _split(head, rows) if rows else ""


def _split(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Table, in parts of equal width if it does not fit on a page; each part begins with the first column."""
    parts = max(1, math.ceil((len(head) - 1) / MAX_COLUMNS))
    most = max(1, math.ceil((len(head) - 1) / parts))
    return "".join(
        plain_table(
            (head[0], *head[k : k + most]), [_row(row[0], *row[k : k + most]) for row in rows], words=1
        )
        for k in range(1, len(head), most)
    )


def _row(name: str, *cells: str) -> str:
    """Row of a table of numbers."""
    numbers = "".join(f'<td class="num">{cell.replace("-", "−")}</td>' for cell in cells)
    return f'<tr><th scope="row">{escape(name)}</th>{numbers}</tr>'


def _add_analysis(section: Section, data: xr.Dataset, found: Mapping[str, Array]) -> None:
    torques = np.asarray(data["torque"].values, dtype=np.float64)
    section.add(f"<p>{escape(_about(data))}</p>")
    section.add(_table(torques, found))
    most = int(np.argmax(torques))
    section.add(_flanks(data, most))
    pattern = contact_pattern(data, most)
    at = amount(float(torques[most]), "N m")
    section.add_figure(
        plots.plot_path_pattern(pattern, "line_load"),
        f"Line load of one tooth pair at {at}: normal force per length of the contact line, over the path of "
        "contact with contacts of tip edges before A and beyond E.",
        name="line_load",
    )
    for gear in (1, 2):
        section.add_figure(
            plots.plot_flank_pattern(pattern, "any_pressure", gear),
            f"Contact pattern on the flank of gear {gear} at {at}: maximum Hertzian pressure at each place, "
            "rounded tip edges included.",
            name=f"contact_pattern[gear {gear}]",
        )
    chosen = chosen_torques(torques)
    names = {k: amount(float(torques[k]), "N m") for k in chosen}
    _add_path(section, data, pattern, names, at)
    _add_root_stress(section, data, found, pattern, most)
    _add_cycle(section, data, names, most, at)
    loads = load_over_width(data)
    section.add_figure(
        plots.plot_load_over_width(
            data["plane"].values, {names[k]: loads[k] for k in chosen}, data["plane_width"].values
        ),
        "Line load over the face width, integrated over the profile: sum of all tooth pairs, mean over the "
        f"mesh cycle. Maximum over mean, K_Hβ, at {at}: {number(float(found['face_load_factor'][most]), 4)}.",
        name="load_over_width",
    )
    if torques.size > 2:
        section.add_figure(
            plots.plot_harris_map(
                torques, found["transmission_error_pp"], found["transmission_error_orders"]
            ),
            "Transmission error over torque: peak to peak, and amplitudes of the mesh orders.",
            name="harris_map",
        )


def _add_path(
    section: Section, data: xr.Dataset, pattern: ContactPattern, names: Mapping[int, str], at: str
) -> None:
    """Load share and maximum pressure along the path of contact."""
    shares = {name: load_sharing(data, k) for k, name in names.items()}
    section.add_figure(
        plots.plot_along_path(
            {name: (one.way, one.share) for name, one in shares.items()}, pattern.teeth, "load share", "%"
        ),
        "Load share of one tooth pair from its first to its last contact; A to E for contact at mid-face.",
        name="load_share",
    )
    curves = {}
    for words, name in (("flanks", "pressure"), ("tip edges", "edge_pressure")):
        field = on_path(pattern, name)
        if np.isfinite(field.values).any():
            curves[words] = field.place, _largest(field.values)
    section.add_figure(
        plots.plot_along_path(curves, pattern.teeth, "maximum pressure", "Pa", of_pair=False),
        f"Maximum contact pressure over the face width along the path of contact, at {at}.",
        name="pressure",
    )
    for name, title, unit, sign in OIL:
        if name not in pattern.others:
            continue
        field = on_path(pattern, name)
        curve = {"": (field.place, sign * _largest(sign * field.values))}
        section.add_figure(
            plots.plot_along_path(curve, pattern.teeth, title, unit, of_pair=False),
            f"{title[0].upper()}{title[1:]} along the path of contact at {at}: "
            f"{'maximum' if sign > 0 else 'minimum'} over the face width.",
            name=name,
        )


def _add_root_stress(
    section: Section, data: xr.Dataset, found: Mapping[str, Array], pattern: ContactPattern, most: int
) -> None:
    """Root stress of both gears along the path of contact and over the face width, at one torque."""
    tangent = "30°/60°" if "internal" in str(options_of(data).get("root_stress")) else "30°"
    words_of = {"root_stress": f"{tangent} tangent", "root_stress_fe": "finite elements"}
    methods = {
        words: name
        for name, words in words_of.items()
        if name in data and np.isfinite(data[name].values[most]).any()
    }
    if not methods:
        return
    at = amount(float(data["torque"].values[most]), "N m")
    curves = {words: root_stress_of_tooth(data, most, name) for words, name in methods.items()}
    least = ""
    if "root_stress_fe_min_1" in found:
        ends = [amount(float(found[f"root_stress_fe_min_{k}"][most]), "Pa") for k in (1, 2)]
        least = (
            " By finite elements the stress is that of one point of the fillet, with loads on neighbouring "
            f"teeth; minimum over a turn at the place of the maximum: {ends[0]} (gear 1), {ends[1]} (gear 2)."
        )
    section.add_figure(
        plot_root_stress(curves, pattern.teeth),
        f"Root stress of one tooth of each gear at {at}: maximum over the face width. At the "
        f"{tangent} tangent of the fillet nominal stress with notch factor, ISO 6336-3.{least}",
        name="root_stress",
    )
    if pattern.z.size > 1:
        over = {words: root_stress_over_width(data, name)[most] for words, name in methods.items()}
        section.add_figure(
            plot_root_stress_over_width(pattern.z, over),
            f"Root stress over the face width at {at}: maximum over the mesh cycle.",
            name="root_stress_over_width",
        )


def _add_cycle(section: Section, data: xr.Dataset, names: Mapping[int, str], most: int, at: str) -> None:
    """Transmission error and stiffness over the mesh cycle."""
    phase = np.asarray(data["mesh_phase_position"].values, dtype=np.float64)
    errors = {"without load": data["unloaded_transmission_error"].values[0]}
    errors |= {name: data["transmission_error"].values[k] for k, name in names.items()}
    section.add_figure(
        plot_transmission_error(phase, errors),
        "Transmission error over two mesh cycles: approach of the flanks along the base tangent.",
        name="transmission_error",
    )
    section.add_figure(
        plots.plot_stiffness(
            phase, data["mesh_stiffness"].values[most], data["secant_stiffness"].values[most]
        ),
        f"Stiffness along the base tangent at {at}. Tangent: derivative of the mesh force, for vibration "
        "about the loaded state; secant: mesh force over the approach from first contact.",
        name="stiffness",
    )


def _largest(values: Array) -> Array:
    """Maximum over the planes, shape (n_position,); NaN without any."""
    known = np.where(np.isfinite(values), values, -np.inf).max(axis=1)
    return np.where(np.isfinite(known), known, np.nan)


def chosen_torques(torques: Array) -> list[int]:
    """Indices of the torques with a curve of their own: all, or a selection in ascending order.

    Examples
    --------
    >>> chosen_torques(np.array([3.0, 1.0])), chosen_torques(np.arange(9.0))
    ([1, 0], [0, 2, 4, 6, 8])
    """
    order = np.argsort(torques, kind="stable")
    if order.size <= MAX_CURVES:
        return [int(k) for k in order]
    return [int(order[k]) for k in np.linspace(0, order.size - 1, MAX_CURVES).round().astype(np.int64)]


def _about(data: xr.Dataset) -> str:
    options = options_of(data)
    side = "back flanks" if options.get("flank") == -1 else "front flanks"
    angle = float(data["misalignment"].mean() if "misalignment" in data else options.get("misalignment", 0.0))
    side += ", shafts in equilibrium" if options.get("shafts") else ""
    more = "".join(f", {words}" for words in operation_words(options))
    tilted = (
        f", misalignment {format_quantity(angle, 'angle', 4)}" if abs(angle) > NEGLIGIBLE else ""
    ) + more
    return (
        f"Mesh {options['mesh']}, {side}: {contact_words(options)}; "
        f"{data.sizes['mesh_phase_position']} mesh phases{tilted}."
    )


def _flanks(data: xr.Dataset, torque: int) -> str:
    """Table with the ends of the flanks in contact of both gears at one torque."""
    body = []
    for name, flank in zip(gear_names(options_of(data)), active_flanks(data, torque) or (), strict=False):
        body.append(_row(name, *flank_cells(vars(flank))))
    at = amount(float(data["torque"].values[torque]), "N m")
    table = plain_table(("flank in contact", *FLANKS), body, words=1) if body else ""
    return table and f"<p>Flanks in contact at {at}, over all mesh phases and contact planes:</p>{table}"


def _table(torques: Array, found: Mapping[str, Array]) -> str:
    """Table with one row per torque."""
    chosen = columns(found)
    rows = [
        [amount(float(torque), "N m"), *(c.text(float(found[c.key][k])) for c in chosen)]
        for k, torque in enumerate(torques)
    ]
    return _split(("torque", *(c.heading for c in chosen)), rows)
