# SPDX-License-Identifier: Apache-2.0
"""Mass, centre of mass and inertia of bodies: what each given key changes, and what it leaves as it is."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.modal import solve_modal
from pitchpoint.system.compile import compile_model

TEXT = """
gears:
  g: {{number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{of_gear}}}
  h: {{number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies: {{A: {{motion: {motion}, gears: {gears}{more}}}}}
bearings:
  one: {{body: A, position: [0, 0, 50 mm], stiffness: {{radial: 1e8, axial: 1e8, tilt: 1e3, torsion: 1}}}}
  two: {{body: A, position: [0, 0, -50 mm], stiffness: {{radial: 1e8}}}}
"""


def model_of(more: str = "", gears: str = "{g: 70 mm}", motion: str = "free", of_gear: str = ""):
    return loads_model(TEXT.format(more=more, gears=gears, motion=motion, of_gear=of_gear))


def inertia_of(*args: str, **kw: str):
    return model_of(*args, **kw).body_inertia("A")


def frequencies(model) -> np.ndarray:
    return solve_modal(compile_model(model))["undamped_frequency"].values


OWN = inertia_of()


@pytest.mark.parametrize(
    "more",
    [
        f", mass: {OWN.mass}",
        f", inertia: {OWN.polar}",
        f", transverse_inertia: {OWN.transverse}",
        f", center_of_mass: {OWN.center}",
        f", mass: {OWN.mass}, inertia: {OWN.polar}, transverse_inertia: {OWN.transverse}",
        f", mass: {OWN.mass}, transverse_inertia: {OWN.transverse}, center_of_mass: {OWN.center}",
    ],
)
def test_a_key_with_the_value_it_has_anyway_changes_nothing(more: str) -> None:
    found = inertia_of(more)
    for name in ("mass", "polar", "central", "transverse", "center"):
        assert getattr(found, name) == pytest.approx(getattr(OWN, name), rel=1e-12), name
    np.testing.assert_allclose(frequencies(model_of(more)), frequencies(model_of()), rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize(
    ("more", "mass", "center", "about_origin"),
    [
        # a heavier body keeps its centre and its inertia about it: Steiner's part grows with the mass
        (", mass: 4", 4.0, 0.07, OWN.central + 4.0 * 0.07**2),
        (", inertia: 0.5", OWN.mass, 0.07, OWN.transverse),
        (", transverse_inertia: 0.02", OWN.mass, 0.07, 0.02),
        # the gear lies 50 mm beside the given centre, which lies 20 mm from the origin
        (", center_of_mass: 20 mm", OWN.mass, 0.02, OWN.central + OWN.mass * (0.05**2 + 0.02**2)),
        (", mass: 4, center_of_mass: 20 mm", 4.0, 0.02, OWN.central + OWN.mass * 0.05**2 + 4.0 * 0.02**2),
        # the sum about the origin, with the centre there
        (", center_of_mass: 0", OWN.mass, 0.0, OWN.transverse),
        (", mass: 4, transverse_inertia: 0.03, center_of_mass: -10 mm", 4.0, -0.01, 0.03),
    ],
)
def test_each_key_alone_and_together_by_parallel_axes(more, mass, center, about_origin) -> None:
    found = inertia_of(more)
    assert found.mass == pytest.approx(mass, rel=1e-12)
    assert found.center == pytest.approx(center, rel=1e-12, abs=1e-15)
    assert found.transverse == pytest.approx(about_origin, rel=1e-12)
    assert found.central == pytest.approx(about_origin - mass * center**2, rel=1e-12)
    assert found.polar == (0.5 if "inertia: 0.5" in more else OWN.polar)


@pytest.mark.parametrize(
    "more", ["", ", mass: 4", ", mass: 4, center_of_mass: 20 mm", ", transverse_inertia: 0.012"]
)
def test_modes_are_those_of_a_rigid_body_about_its_origin(more: str) -> None:
    found = inertia_of(more)
    # y and rx: mass matrix about the origin, two springs at +-50 mm and one against tilt
    M = np.array(
        [[found.mass, found.mass * found.center], [found.mass * found.center, 0.0]], dtype=float
    ) + np.diag([0.0, found.transverse])
    K = np.diag([2e8, 2e8 * 0.05**2 + 1e3])
    values = np.sort(np.linalg.eigvals(np.linalg.solve(M, K)).real)
    want = np.sqrt(values) / (2.0 * math.pi)
    have = frequencies(model_of(more))
    for frequency in want:
        assert np.sum(np.abs(have - frequency) < 1e-6 * frequency) == 2  # both transverse planes


def test_the_centre_of_two_gears_is_weighted_by_their_masses() -> None:
    gears = "{g: 70 mm, h: -30 mm}"
    one, two = inertia_of(gears="{g: 0}"), inertia_of(gears="{h: 0}")
    both = inertia_of(", mass: 9", gears=gears)
    center = (0.07 * one.mass - 0.03 * two.mass) / (one.mass + two.mass)
    assert both.center == pytest.approx(center, rel=1e-12)
    parts = one.mass * (0.07 - center) ** 2 + two.mass * (-0.03 - center) ** 2
    assert both.central == pytest.approx(one.central + two.central + parts, rel=1e-12)


def test_gears_without_mass_leave_the_centre_at_the_origin() -> None:
    assert inertia_of(", mass: 3", of_gear=", mass: 0").center == 0.0


def test_a_file_keeps_the_centre_of_mass() -> None:
    model = model_of(", center_of_mass: 12 mm")
    assert loads_model(dump_model(model)).bodies["A"].center_of_mass == 0.012


@pytest.mark.parametrize(
    ("more", "limit", "remedy"),
    [
        ("", OWN.mass * 0.07**2, "give center_of_mass"),
        (", mass: 4", 4.0 * 0.07**2, "give center_of_mass"),
        (", mass: 4, center_of_mass: 30 mm", 4.0 * 0.03**2, "correct center_of_mass"),
    ],
)
def test_a_transverse_inertia_that_leaves_nothing_about_the_centre_is_refused(more, limit, remedy) -> None:
    with pytest.raises(ModelError) as caught:
        model_of(", transverse_inertia: 0.002" + more)
    (problem,) = caught.value.problems
    assert problem.where == "bodies.A.transverse_inertia"
    assert problem.value == "0.002 kg m^2"
    assert problem.limit == f"> {limit:.6g} kg m^2, mass * center_of_mass^2"
    assert f"add {limit:.6g} kg m^2" in problem.remedy
    assert remedy in problem.remedy
    compile_model(model_of(f", transverse_inertia: {0.002 + limit}" + more))


def test_only_bodies_that_tilt_need_it() -> None:
    for motion in ("torsion", "planar"):
        model_of(", transverse_inertia: 0.002", motion=motion).body_inertia("A")


def test_gears_without_inertia_of_their_own_do_not_make_a_body_that_tilts() -> None:
    with pytest.raises(ModelError, match="of the gears is zero about the centre of mass at 70 mm"):
        model_of(of_gear=", transverse_inertia: 0")


@pytest.mark.parametrize("more", ["inertia: 0.01", "inertia: 0.01, mass: 2, transverse_inertia: 0.05"])
@pytest.mark.parametrize("motion", ["torsion", "free", "fixed"])
def test_what_compile_asks_the_gears_for_is_asked_by_the_check(more: str, motion: str) -> None:
    text = TEXT.format(more=", " + more, gears="{g: 70 mm}", motion=motion, of_gear=", bore_diameter: 150 mm")
    with pytest.raises(ModelError, match=r"gears\.g\.bore_diameter .*does not fit the gear"):
        loads_model(text.split("bearings")[0])
