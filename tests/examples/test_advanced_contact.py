# SPDX-License-Identifier: Apache-2.0
"""The example `advanced-contact`: one gear pair with rigid, flexible and pre-computed contact.

Oracles: the brake torque over the base radius bounds the mean mesh force, friction with 0.06 being at most a
few per cent; flexible contact for the table; `contact-levels` for the rigid stiffness.
"""

from __future__ import annotations

import pytest

from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis.law_fit import fit_analytic_law
from pitchpoint.solvers.contact_analysis.on_shafts import solve_contacts_on_shafts
from pitchpoint.solvers.time import run_time
from pitchpoint.system.compile import compile_model
from tests.support.advanced_contact import EXAMPLE, folder_with_table

NUMBERS = {
    "rigid": (18.6e-6, 3.72e-6, 5922.0),
    "flexible": (17.8e-6, 2.03e-6, 5920.0),
    "precomputed": (17.9e-6, 2.04e-6, 5915.0),
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return folder_with_table(tmp_path_factory.mktemp("advanced"))


@pytest.fixture(scope="module")
def channels(folder):
    return {
        name: run_time(compile_model(load_model(folder / f"{name}.yaml"), "steady")).channels
        for name in NUMBERS
    }


@pytest.mark.parametrize("name", NUMBERS)
def test_numbers_of_the_page(channels, name):
    error, force = (channels[name][f"{what}[stage]"] for what in ("transmission_error", "mesh_force"))
    mean, rms, load = NUMBERS[name]
    assert error["mean"] == pytest.approx(mean, abs=0.051e-6)
    assert error["rms"] == pytest.approx(rms, abs=0.0051e-6)
    assert force["mean"] == pytest.approx(load, abs=1.0)


@pytest.mark.parametrize("name", NUMBERS)
def test_mean_mesh_force_is_the_brake_torque_over_the_base_radius(channels, name):
    """Friction changes it by less than its coefficient times tan α_wt = 0.38."""
    model = load_model(EXAMPLE / "flexible.yaml")
    nominal = 300.0 / model.pairs["stage"].gear2.r_b
    assert channels[name]["mesh_force[stage]"]["mean"] == pytest.approx(nominal, rel=0.06 * 0.38)


def test_table_against_flexible_contact(channels):
    mean = {name: channels[name]["transmission_error[stage]"]["mean"] for name in NUMBERS}
    assert mean["precomputed"] == pytest.approx(mean["flexible"], rel=5e-3)


def test_the_rigid_stiffness_is_that_of_the_fit():
    model = load_model(EXAMPLE / "flexible.yaml")
    fit = fit_analytic_law(model, torque=200.0)
    rigid = load_model(EXAMPLE / "rigid.yaml").meshes["stage"].contact
    assert rigid.stiffness == pytest.approx(fit.rigid_stiffness, rel=2e-3)


def test_contact_on_shafts_by_the_table(folder):
    """The roll has the forces of the table, the contact is that of flexible teeth at its approaches."""
    flexible, table = (
        solve_contacts_on_shafts(load_model(folder / f"{name}.yaml"), scenario="steady", positions=16).meshes[
            "stage"
        ]
        for name in ("flexible", "precomputed")
    )
    assert float(table["torque"][0]) == pytest.approx(float(flexible["torque"][0]), rel=1e-4)
    assert flexible.attrs["force_of_roll"] < 1e-12
    assert 0.0 < table.attrs["force_of_roll"] < 5e-3
    assert "touch at" not in table.attrs["notes"]
    for name in ("flank_pressure", "face_load_factor", "root_stress_1"):
        found, exact = (contact_numbers(data)[name][0] for data in (table, flexible))
        assert found == pytest.approx(exact, rel=2e-3)
