# SPDX-License-Identifier: Apache-2.0
"""Geometry of a mesh for the dataset of its contact analysis: evaluation needs no model."""

from __future__ import annotations

from typing import Any

import numpy as np

from pitchpoint.model.components.flank_contact import PrecomputedContact, default_clamp
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.system.rules.flexible_teeth import flexible_options

MARKS = ("A", "B", "C", "D", "E")
"""Points of the path of contact: start, start of single contact, pitch point, end of single contact, end."""


def mesh_geometry(flanks: FlankStates) -> tuple[dict[str, Any], dict[str, Any]]:
    """Variables and coordinates of the mesh geometry, as for `xarray.Dataset`.

    Parameters
    ----------
    flanks
        The mesh; a state has been solved, so that its record contains the common face width.

    Notes
    -----
    All lengths are positive, but lengths of roll inside a base circle are negative. B and D are one base
    pitch from E and A; they change their order if the transverse contact ratio is above 2.
    """
    pair, record = flanks.model.pairs[flanks.mesh], flanks.record
    gears = [flanks.model.gears[name] for name in flanks.model.meshes[flanks.mesh].gears]
    path = np.array([pair.T1A, pair.T1B, pair.T1C, pair.T1D, pair.T1E])
    signs = [[gear.geometry.sign] for gear in gears]
    planes = int(record["slices"])
    width = float(record["now"]["z_hi"] - record["now"]["z_lo"]) / planes
    lead = flanks.flank * float(record["tan_b"]) / float(record["p_bt"])
    by_gear: dict[str, tuple[list[float], str, str]] = {
        "number_of_teeth": ([abs(g.geometry.z) for g in gears], "1", "number of teeth"),
        "base_radius": ([abs(g.geometry.r_b) for g in gears], "m", "base radius"),
        "base_helix_angle": ([abs(g.geometry.beta_b) for g in gears], "rad", "base helix angle"),
        "youngs_modulus": ([g.material_data.youngs_modulus for g in gears], "Pa", "Young's modulus"),
        "poisson_ratio": ([g.material_data.poisson_ratio for g in gears], "1", "Poisson's ratio"),
    }
    variables: dict[str, Any] = {
        name: (("gear",), values, {"units": unit, "long_name": text})
        for name, (values, unit, text) in by_gear.items()
    }
    variables["mark_roll"] = (
        ("gear", "mark"),
        np.array([path, pair.T1T2 - path]) * signs,
        {"units": "m", "long_name": "length of roll at the points of the path of contact"},
    )
    variables["plane_width"] = (
        ("plane",),
        np.full(planes, width),
        {"units": "m", "long_name": "width of a contact plane"},
    )
    variables["plane_advance"] = (
        ("plane",),
        lead * flanks.widths + 0.0,
        {"units": "1", "long_name": "base pitches by which contact is ahead of the middle of the face"},
    )
    coordinates = {
        "gear": (("gear",), [1, 2], {"units": "1", "long_name": "gear of the mesh"}),
        "mark": (("mark",), list(MARKS), {"units": "1", "long_name": "point of the path of contact"}),
    }
    return variables, coordinates


def contact_options(flanks: FlankStates) -> dict[str, str | int | float]:
    """Level of the contact and its options, by their keys in the model file; defaults that depend on others
    as texts. Of a pre-computed contact those of the flexible one of its table, which is the one analysed.
    """
    from pitchpoint.model.keys import keys_of

    contact = flanks.model.meshes[flanks.mesh].contact
    assert contact is not None
    if isinstance(contact, PrecomputedContact):
        contact = flexible_options(contact)
    found: dict[str, str | int | float] = {"level": contact.level}
    for name, key in keys_of(type(contact)).items():
        value = getattr(contact, name)
        if value is None and key.kind == "quantity":
            value = default_clamp(flanks.distance < 0.0) if name == "clamp" else key.display
        if isinstance(value, str | int | float) and value != "":
            found[name] = value
    return found
