# SPDX-License-Identifier: Apache-2.0
"""Assumptions of a report: keys that the model file omits, by component."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.report.defaults import defaults

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def assumptions_of(model: Model) -> list[tuple[str, list[tuple[str, str]]]]:
    """Components in words, each with keys and the values in effect.

    Returns
    -------
    list
        Such as ("bearings rotor_2, drive_2", [("stiffness.axial", "0 N/m")]); keys and values as in
        `defaults`.
    """
    found: dict[str, list[tuple[str, str]]] = {}
    for path, value in defaults(model):
        group, _, rest = path.partition(".")
        names, _, key = rest.partition(".")
        group = group.replace("_", " ")
        if not key:
            part, key = group, names
        else:
            part = f"all {group}" if names == "*" else f"{group} {names.replace(',', ', ')}"
        found.setdefault(part, []).append((key, value))
    return list(found.items())
