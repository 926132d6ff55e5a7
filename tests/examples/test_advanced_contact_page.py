# SPDX-License-Identifier: Apache-2.0
"""The page `howto/advanced_contact`: its keys exist, its conversions and its comparison are true."""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.flank_contact import LEVELS, OilFilm, StructuralDamping
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.mesh import Friction, Mesh, TransientDamping
from pitchpoint.model.keys import keys_of
from pitchpoint.solvers.contact_analysis.levels import compare_levels
from pitchpoint.solvers.contact_analysis.mesh_path import MeshPath

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "howto" / "advanced_contact.md").read_text("utf-8")
EXAMPLE = ROOT / "examples" / "advanced-contact" / "flexible.yaml"
KEYS = sorted(set(re.findall(r"`((?:bodies|gears|meshes)\.NAME\.[\w.]+)`", PAGE)))
BELOW: dict[str, Any] = {
    "meshes.friction": (Friction,),
    "meshes.transient_damping": (TransientDamping,),
    "meshes.contact": tuple(LEVELS.values()),
    "meshes.contact.oil": (OilFilm,),
    "meshes.contact.structural": (StructuralDamping,),
    "meshes": (Mesh,),
    "gears": (Gear,),
    "bodies": (Body,),
}


@pytest.mark.parametrize("path", KEYS)
def test_keys_of_the_page_exist(path):
    *above, name = path.replace(".NAME", "").split(".")
    kinds = BELOW[".".join(above)]
    assert name == "level" or any(name in keys_of(kind) for kind in kinds)


def test_the_page_has_all_rows():
    assert len(KEYS) >= 25


def test_stiffness_per_plane(tmp_path):
    """k x^e on each of n planes is the force of `stiffness` = n k h^(e-1) at the penetration x."""
    k, n, e, h = 80_000.0, 5, 1.2, 0.01
    stiffness = n * k * h ** (e - 1.0)
    assert f"{round(stiffness):,}".replace(",", " ") in PAGE
    contact = {
        "level": "rigid",
        "stiffness": f"{stiffness!r} N/mm",
        "exponent": e,
        "depth": f"{h} mm",
        "planes": n,
    }
    model = load_model(EXAMPLE).replace_all(
        {
            "meshes.stage.contact": contact,
            "gears.pinion.modifications": None,
            "gears.wheel.modifications": None,
        }
    )
    eps = model.pairs["stage"].eps_alpha
    single = 0.5 * (eps - 1.0 + 1.0)  # middle of the range of single contact
    force = MeshPath(model, "stage").forces(np.array([single]), np.array([20e-6]))[0][0]
    assert force == pytest.approx(n * k * 0.02**e, rel=1e-9)


def test_what_is_refused():
    model = load_model(EXAMPLE)
    with pytest.raises(ModelError, match="inertia: is zero, but the body moves"):
        model.replace_all({"gears.pinion.mass": 0.0, "gears.pinion.polar_inertia": 0.0})
    own = {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3, "density": "7830 kg/m^3"}
    same = model.replace("gears.pinion.material", own)
    assert same.body_inertia("input").mass == pytest.approx(model.body_inertia("input").mass, rel=1e-12)
    tensor = ["1e-3 kg m^2"] * 3 + ["1e-5 kg m^2", "0", "0"]
    found = model.replace_all({"bodies.input.mass": "1 kg", "bodies.input.inertia_tensor": tensor})
    assert found.body_inertia("input").tensor[3] == pytest.approx(1e-5)


def test_profile_file_round_trip(tmp_path):
    """The exported tooth as `tooth_profile` leaves the contact as it was, within its chords of 0.1 µm."""
    from pitchpoint.cli.main import run_command
    from pitchpoint.solvers.contact_analysis.solve import solve_contact

    relief = "modifications: {both: {tip_relief: {amount: 15 um, length: 1.5 mm}}}"
    text = EXAMPLE.read_text("utf-8").replace(relief, "")
    path = tmp_path / "model.yaml"
    path.write_text(text, encoding="utf-8")
    tooth = tmp_path / "tooth.csv"
    assert run_command(["gears", str(path), "--gear", "pinion", "--export", str(tooth)]) == 0
    model = load_model(path)
    read = model.replace("gears.pinion.tooth_profile", {"tooth": str(tooth)})
    te = [solve_contact(m, torque=200.0, positions=16)["transmission_error"].values for m in (model, read)]
    assert te[1] == pytest.approx(te[0], abs=1e-6)
    assert te[1].mean() == pytest.approx(te[0].mean(), abs=0.3e-6)


@pytest.mark.study
def test_comparison_of_the_levels():
    found = compare_levels(load_model(EXAMPLE), torque=200.0).numbers
    rows = dict(re.findall(r"^\| (rigid|flexible|pre-computed|law `din3990`) \| (.* µm) \|$", PAGE, re.M))
    for level, name in zip(("rigid", "flexible", "precomputed", "law"), rows, strict=True):
        numbers = [float(v) for v in re.findall(r"[\d.]+", rows[name])]
        one = dataclasses.astuple(found[level])
        te_mean, te_pp, _, rms, most = one[2:]
        assert numbers[-2:] == pytest.approx([1e6 * te_mean, 1e6 * te_pp], abs=0.0101)
        if level != "flexible":
            assert numbers[:2] == pytest.approx([1e2 * rms, 1e2 * most], abs=0.0501)
