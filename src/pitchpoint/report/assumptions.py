# SPDX-License-Identifier: Apache-2.0
"""Assumptions of a report: keys that the model file omits, by component."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.report.defaults import defaults

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


QUIET = (
    *("type", "name", "planet_name", "channels", "along", "reaction", "drawing_resolution", "sample_rate"),
    *("tip_chamfer", "tip_rounding", "tip_alteration", "bore_diameter", "initial_angle", "shape"),
    *("profile_crowning", "lead_crowning", "profile_slope", "helix_slope", "periods", "position", "axis"),
)
"""Keys without influence on the results at their default, or of features that are then absent."""


def assumptions_of(model: Model) -> list[tuple[str, list[tuple[str, str]]]]:
    """Components in words, each with keys and the values in effect; without the keys in `QUIET`.

    Returns
    -------
    list
        Such as ("bearings rotor_2, drive_2", [("stiffness.axial", "0 N/m")]); keys and values as in
        `defaults`.
    """
    found: dict[str, list[tuple[str, str]]] = {}
    for path, value in defaults(model):
        if path.rpartition(".")[2].rpartition(" ")[2] in QUIET:
            continue
        group, _, rest = path.partition(".")
        names, _, key = rest.partition(".")
        group = group.replace("_", " ")
        if not key:
            part, key = group, names
        else:
            part = f"all {group}" if names == "*" else f"{group} {names.replace(',', ', ')}"
        found.setdefault(part, []).append((key, value))
    return list(found.items())
