# SPDX-License-Identifier: Apache-2.0
"""Every stiffness law with every fault of a gear: it works, or a sentence says why it cannot.

Laws of tooth pairs take all faults, laws of the whole mesh those that displace the gear as one. "Works"
means, on flanks pressed by the same depth over a whole turn: severity 0 is the healthy gear, to the last bit;
little severity changes little, all of it more; flanks never pull; only the teeth that are faulty differ.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.gear_faults import SEAT_FAULTS
from pitchpoint.model.components.stiffness import LAWS, OF_PAIRS
from pitchpoint.model.components.tooth_faults import FAULTS
from tests.support.pressed_pair import turned_forces

LAW_FILE = "from tests.support.pressed_pair import swaying as k\n"
"""The law of the user is one object, however often its file is read: it is compiled once."""
OPTIONS = {
    "din3990": "tip_relief_factor: 0.4",
    "energy": "tip_relief_factor: 0.4",
    "hertz": "force: 2 kN, depth: 10 um, tip_relief_factor: 0.4",
    "pair_table": "single_stiffness: 14 N/(mm um), values: [0.6, 1, 0.9, 0.7]",
    "constant": "value: 4e8 N/m",
    "rectangular": "high: 5e8 N/m, low: 3e8 N/m",
    "fourier": "mean: 4e8 N/m, cosine: [-0.2]",
    "table": "values: [3e8 N/m, 4e8 N/m, 5e8 N/m]",
    "user": "python: '{law}:k'",
}
OWN = {
    "broken_tooth": "tooth: 3, at: end, width: 9 mm",
    "root_crack": "tooth: 3, flank: both, depth: 2 mm",
    "pitting": "tooth: 3, flank: both, pattern: {{number: 9, length: 4 mm, height: 2 mm, depth: 60 um}}",
    "wear": "flank: both, depth: 5 um",
    "pitch_error": "tooth: 3, amount: 4 um",
    "eccentricity": "amount: 4 um, phase: 30 deg",
    "wobble": "amount: 1.5 mrad, phase: 30 deg",
}
GEAR = "normal_module: 3 mm, face_width: 20 mm"
KINDS = {
    "spur": (42, "", "", "", "109.7"),
    "helical": (42, "", ", helix_angle: 15 deg, hand: right", ", helix_angle: 15 deg, hand: left", "113.6"),
    "ring": (75, ", type: internal", "", "", "65.8"),
    "helical ring": (
        75,
        ", type: internal",
        ", helix_angle: 15 deg, hand: right",
        ", helix_angle: 15 deg, hand: right",
        "68.1",
    ),
}
DEPTH = 10e-6
ANGLES = np.linspace(0.0, 2.0 * math.pi, 124, endpoint=False)
"""One turn of the pinion, four places per pitch."""


def text_of(kind, law, fault, severity, folder):
    z2, ring, one, two, a = KINDS[kind]
    own = ""
    if fault:
        own = f", faults: {{f: {{type: {fault}, {OWN[fault].format()}, severity: {severity}}}}}"
    options = OPTIONS[law].format(law=folder / "law.py")
    return (
        "gears:\n"
        f"  g1: {{number_of_teeth: 31, profile_shift_coefficient: 0, {GEAR}{one}{own}}}\n"
        f"  g2: {{number_of_teeth: {z2}, profile_shift_coefficient: 0, {GEAR}{ring}{two}}}\n"
        "bodies: {driver: {gears: [g1]}, driven: {gears: [g2]}}\n"
        "meshes:\n"
        f"  stage: {{gears: [g1, g2], center_distance: {a} mm, stiffness: {{law: {law}, {options}}}}}\n"
    )


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    found = tmp_path_factory.mktemp("law")
    (found / "law.py").write_text(LAW_FILE, encoding="utf-8")
    return found


@lru_cache
def forces(kind, law, fault, severity, folder):
    """Mesh forces over a turn, both gears turned through the ratio and pressed by the depth."""
    model = loads_model(text_of(kind, law, fault, severity, folder), allow_code=True)
    return turned_forces(model, ANGLES, DEPTH)


def test_the_table_names_all_laws_and_all_faults():
    assert set(OPTIONS) == set(LAWS)
    assert set(OWN) == {*FAULTS, *SEAT_FAULTS}


# spur and helical, external and internal gears are all among the quick ones
@pytest.mark.parametrize(
    "kind", [k if k in ("spur", "helical ring") else pytest.param(k, marks=pytest.mark.study) for k in KINDS]
)
@pytest.mark.parametrize("fault", OWN)
@pytest.mark.parametrize("law", LAWS)
def test_every_fault_in_every_law(law, fault, kind, folder):
    if law not in OF_PAIRS and fault in FAULTS:
        with pytest.raises(ModelError) as caught:
            loads_model(text_of(kind, law, fault, 1.0, folder), allow_code=True)
        words = f"has no effect in the mesh stage, whose law {law} describes the whole mesh, not single teeth"
        assert [p.where for p in caught.value.problems] == ["gears.g1.faults.f"]
        assert words in str(caught.value)
        return
    healthy = forces(kind, law, "", 0.0, folder)
    assert healthy.min() > 0.0
    assert np.array_equal(forces(kind, law, fault, 0.0, folder), healthy)
    little, whole = (abs(forces(kind, law, fault, s, folder) - healthy) for s in (0.1, 1.0))
    assert 0.0 < little.sum() < 0.6 * whole.sum()
    assert forces(kind, law, fault, 1.0, folder).min() >= 0.0
    assert whole.max() > 1e-3 * healthy.max()
    if fault not in ("wear", "eccentricity", "wobble"):
        # tooth 3 is in contact over eps_gamma < 2.5 of 31 pitches
        touched = np.count_nonzero(whole > 1e-9 * healthy.max())
        assert 4 <= touched <= 2.5 * 4
