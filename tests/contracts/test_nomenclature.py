# SPDX-License-Identifier: Apache-2.0
"""Every quantity that users meet has a row in the table of names, and every row is sound."""

from __future__ import annotations

import dataclasses
from functools import cached_property

import numpy as np
import pytest

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.nomenclature import attributes, label, lookup, markdown_table, table, unit
from pitchpoint.core.units import DIMENSIONS, in_unit, parse_quantity
from pitchpoint.elements.registry import find, names
from pitchpoint.geometry import BasicRack, BevelGear, BevelPair, CylindricalGear, GearPair

CHANNELS = """
transmission_error[m] deflection[m] mesh_force[m] mesh_stiffness[m] mesh_phase[m] contact_state[m]
circumferential_force[m] radial_force[m] axial_force[m] normal_force[m] pair_force[m.1]
friction_power[m] damping_power[m] parametric_power[m] angle[b] speed[b] displacement[b.x]
displacement[b.ry] bearing_force[n.fx] bearing_force[n.mz] coupling_force[n.fx] coupling_force[n.mz]
torque[l] contact_loss_share
back_contact_share mesh_frequency
""".split()
JSON_NAMES = """
z m_n m_t alpha_n alpha_t beta beta_b x d d_b d_a d_f d_Ff s_n p_t p_et mass a_d a_w alpha_wt x_sum
x_sum_given d_w1 d_w2 d_Nf1 d_Nf2 g_alpha eps_alpha eps_beta eps_gamma c_prime c_gamma_alpha C_R C_B
j_bt j_wt j_bn
""".split()


def public_quantities(cls):
    """Fields and read-only properties of a class."""
    names = {f.name for f in dataclasses.fields(cls)}
    for base in cls.__mro__:
        names |= {n for n, v in vars(base).items() if isinstance(v, property | cached_property)}
    return sorted(n for n in names if not n.startswith("_"))


@pytest.mark.parametrize(
    "cls", [BasicRack, BevelGear, BevelPair, CylindricalGear, GearPair], ids=lambda c: c.__name__
)
def test_every_property_of_the_geometry_has_a_row(cls):
    missing = [n for n in public_quantities(cls) if n not in table()]
    assert not missing, f"add these to core/nomenclature.csv: {missing}"


def test_every_channel_and_every_number_of_the_command_line_has_a_row():
    assert not [name for name in CHANNELS + JSON_NAMES if not lookup(name).meaning]
    assert not [n for n in CHANNELS + JSON_NAMES if not attributes(n)["units"] == unit(n) != ""]


def test_outputs_of_all_element_kinds_have_rows_with_their_unit():
    for name in names():
        module = find(name).load()
        outputs = [*getattr(module, "OUTPUTS", ())]
        if hasattr(module, "outputs"):
            outputs += module.outputs(np.ones(1, module.RECORD)[0])
        for output, si, _ in outputs:
            channel = output.format("name")
            assert unit(channel) == si, channel


def is_sound(row):
    """Whether a row has a meaning, the unit of its dimension, a display unit that works and a clean label."""
    if not row.dimension:
        return bool(row.meaning) and row.unit == row.display == ""
    shown = row.display and row.display != "1"
    there_and_back = (
        in_unit(parse_quantity(f"3 {row.display}", row.dimension), row.dimension, row.display)
        if shown
        else 3.0
    )
    si = DIMENSIONS[row.dimension].si or "1"
    clean = label(row.identifier).strip() == label(row.identifier)
    return bool(row.meaning) and row.unit == si and there_and_back > 2.999 and clean


def test_rows_are_sound():
    assert len(table()) > 100
    assert not [row.identifier for row in table().values() if not is_sound(row)]


def test_table_for_the_documentation():
    text = markdown_table()
    assert text.count("\n") == len(table()) + 2
    assert "| `eps_alpha` | ε_α | radial_contact_ratio | 1 |" in text


def test_unknown_names_are_refused():
    with pytest.raises(PitchpointError, match="no row for 'flux'"):
        label("flux[stage]".removesuffix("[stage]"))
