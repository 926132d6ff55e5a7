# SPDX-License-Identifier: Apache-2.0
"""Materials of a model by name: used by gears and shafts, replaced, written, refused."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.own_material import OwnMaterial
from pitchpoint.model.model import Model

TEXT = """\
parameters: {E: 200 GPa}
materials:
  case: {youngs_modulus: E, poisson_ratio: 0.3, density: 7800 kg/m^3}
  light: {youngs_modulus: 70 GPa, poisson_ratio: 0.33, density: 2700 kg/m^3}
gears:
  a: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, material: case,
      profile_shift_coefficient: 0}
shafts:
  s: {sections: [{length: 100 mm, diameter: 20 mm}], gears: {a: 50 mm}, material: light}
bearings:
  l: {body: s, stiffness: {radial: 1e8, axial: 1e8, tilt: 1e6}}
"""


def test_names_are_those_of_the_model():
    model = loads_model(TEXT)
    assert model.gears["a"].material_data.youngs_modulus == 200e9
    assert model.shafts["s"].material_data.density == 2700.0
    assert loads_model(model.to_yaml()) == model
    assert "material: case" in model.to_yaml()


def test_a_replaced_property_reaches_every_part():
    model = loads_model(TEXT)
    heavy = model.replace("materials.light.density", 5400)
    assert heavy.shafts["s"].material_data.density == 5400.0
    soft = model.replace("parameters.E", "100 GPa")
    assert soft.gears["a"].material_data.youngs_modulus == 100e9
    both = model.replace("gears.a.material", "light")
    assert both.gears["a"].material_data.density == 2700.0


def test_components_of_python_name_materials_of_their_model():
    gear = Gear(
        number_of_teeth=20,
        normal_module="2 mm",
        face_width="20 mm",
        profile_shift_coefficient=0,
        material="own",
    )
    own = OwnMaterial(youngs_modulus="100 GPa", poisson_ratio=0.3, density=7000.0)
    model = Model(materials={"own": own}, gears={"a": gear}, bodies={"r": {"gears": ["a"]}})
    assert model.gears["a"].material_data.density == 7000.0
    assert model.replace("materials.own.density", 8000.0).gears["a"].material_data.density == 8000.0
    with pytest.raises(ModelError, match=r"gears.a.material: 'own' is neither a material of the model"):
        Model(gears={"a": gear}, bodies={"r": {"gears": ["a"]}})


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "material: light",
            "material: lite",
            "'lite' is neither a material of the model nor of the library; did you",
        ),
        ("  light:", "  steel:", "materials.steel (line 4): is a material of the library"),
        ("70 GPa", "70 GP", "'GP' is not the unit of a stress or modulus"),
        ("0.33", "0.5", "materials.light.poisson_ratio (line 4): 0.5 is out of range"),
        ("density: 2700 kg/m^3", "rho: 2700", "rho (line 4): is an unknown key; did you mean density?"),
    ],
)
def test_wrong_materials_are_refused(old, new, words):
    with pytest.raises(ModelError) as caught:
        loads_model(TEXT.replace(old, new))
    assert words in str(caught.value)


def test_the_user_of_an_unreadable_material_is_not_reported():
    with pytest.raises(ModelError) as caught:
        loads_model(TEXT.replace("70 GPa", "70 GP"))
    assert len(caught.value.problems) == 1
