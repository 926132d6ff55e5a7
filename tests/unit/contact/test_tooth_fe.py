# SPDX-License-Identifier: Apache-2.0
"""Compliance of whole gears by finite elements: limits, symmetries, convergence, planes, storage."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from pitchpoint.contact.tooth_fe import store
from pitchpoint.contact.tooth_fe.fillet_stress import principal_stress, stress_by_planes
from pitchpoint.contact.tooth_fe.flank_fields import flank_fields
from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.contact.tooth_fe.solve import tooth_fe
from pitchpoint.contact.tooth_fe.tooth_model import Resolution, ToothModel
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.materials import material
from pitchpoint.geometry.tooth_form import tooth_form
from pitchpoint.geometry.tooth_outline import ToothOutline
from pitchpoint.system.rules import flexible_teeth
from tests.support.plane_teeth import PlaneTooth, approach, clamped_radius

SMALL = Resolution(heights=4, widths=6, fillet_points=5, density=Density(body=(0.0, 1.0), across=(0.0, 1.0)))
MIDDLE = np.array([1.0, 0.0, -0.5, 0.0])
"""Legendre polynomials at the middle of the height."""


def solved(gear, resolution=SMALL, **body):
    body = body or {"bore_diameter": 2.0 * clamped_radius(gear)}
    return tooth_fe(ToothModel(gear=gear, resolution=resolution, **body))


@pytest.fixture(scope="module")
def spur():
    return solved(CylindricalGear(z=17, m_n=1e-3, b=8e-3))


@pytest.fixture(scope="module")
def helical():
    return solved(CylindricalGear(z=17, m_n=1e-3, b=8e-3, beta=0.35), bore_diameter=10e-3)


def square(part):
    size = part.shape[0] * part.shape[1]
    return part.reshape(size, size)


@pytest.mark.parametrize("name", ["spur", "helical"])
def test_compliance_is_symmetric_and_positive(name, request):
    found = request.getfixturevalue(name)
    same = square(found.same)
    assert np.abs(same - same.T).max() <= 1e-12 * np.abs(same).max()
    assert np.linalg.eigvalsh(same)[0] > -1e-12 * np.abs(same).max()


def test_helix_angle_zero_is_the_limit(spur):
    """The helical path with its one set of values, with a helix of 0.6 µm over the width."""
    nearly = solved(CylindricalGear(z=17, m_n=1e-3, b=8e-3, beta=1e-4))
    for name in ("same", "next", "far"):
        a, b = getattr(spur, name), getattr(nearly, name)
        assert np.abs(a - b).max() < 1e-3 * np.abs(spur.same).max()
    assert np.abs(spur.stress - nearly.stress).max() < 2e-3 * np.abs(spur.stress).max()
    assert nearly.contact == pytest.approx(spur.contact, rel=1e-5)


def test_other_hand_is_the_mirror_image(helical):
    other = solved(CylindricalGear(z=17, m_n=1e-3, b=8e-3, beta=-0.35), bore_diameter=10e-3)
    signs = (-1.0) ** np.arange(6)
    for name in ("same", "next", "far"):
        mirrored = getattr(other, name) * signs[:, None, None] * signs
        assert mirrored == pytest.approx(getattr(helical, name), rel=1e-8, abs=1e-8 * helical.same.max())
    stress = other.stress * signs[:, None, None, None] * signs
    stress[:, 2] *= -1.0  # shear
    assert stress == pytest.approx(helical.stress, rel=1e-6, abs=1e-7 * np.abs(helical.stress).max())


def test_compliance_per_width_does_not_depend_on_the_module(spur):
    large = solved(CylindricalGear(z=17, m_n=4e-3, b=32e-3))
    assert large.same == pytest.approx(spur.same, rel=1e-8, abs=1e-10 * spur.same.max())
    assert large.roll == pytest.approx(4.0 * spur.roll)
    assert large.stress * 4.0 == pytest.approx(spur.stress, rel=1e-6, abs=1e-8 * np.abs(spur.stress).max())


def test_middle_of_a_wide_tooth_is_in_plane_strain():
    gear = CylindricalGear(z=17, m_n=1e-3, b=24e-3)
    wide = solved(gear, replace(SMALL, widths=12))
    fields = flank_fields(wide, 15)
    middle = fields.own[7].sum(axis=0) / 15.0 + fields.windup * np.outer([1, 0, 0, 0], [1, 0, 0, 0])
    tooth = PlaneTooth(gear, SMALL.density)
    rho = 0.5 * sum(tooth.contour.roll)
    plane = float(tooth.without_indentation([rho])[0])
    assert gear.b * float(MIDDLE @ middle @ MIDDLE) == pytest.approx(plane, rel=0.01)


@pytest.mark.study
@pytest.mark.parametrize("beta", [0.0, 0.35])
def test_results_converge(beta):
    """The default resolution against a finer one, relative to the compliance with local indentation: 1.5 %.

    The largest part is the representation of the height by six polynomials near tip and root.
    """
    gear = CylindricalGear(z=25, m_n=1e-3, b=4e-3, beta=beta)
    usual = solved(gear, Resolution())
    layers = {"across": (0.0, 0.5, 0.8, 1.0), "body": (0.0, 0.2, 0.5, 1.0)}
    fine = Density(order=5, flank=(0.0, 0.35, 0.7, 1.0), fillet=2, **layers)
    finer = solved(gear, Resolution(heights=8, widths=9, density=fine))
    a, b = flank_fields(usual, 5), flank_fields(finer, 5)
    t = np.linspace(-0.9, 0.9, 7)
    for i in range(5):
        first, second = (
            np.einsum("km,jmn,kn->k", P, fields.own[i], P) + fields.windup * 5.0
            for fields in (a, b)
            for P in [np.polynomial.legendre.legvander(t, fields.own.shape[2] - 1)]
        )
        total = second + 5.0 * approach(0.8e-3, 50e-6) / gear.b
        assert first / total == pytest.approx(second / total, abs=0.015)
    peak = np.abs(finer.stress[:, 0, 0, 1, 0, 0]).max()
    assert np.abs(usual.stress[:, 0, 0, 1, 0, 0]).max() == pytest.approx(peak, rel=0.01)


def test_uniform_forces_do_not_depend_on_the_number_of_planes(helical):
    few, many = flank_fields(helical, 3), flank_fields(helical, 12)
    assert few.own.shape == (3, 3, 4, 4)
    for name in ("own", "beside"):
        a, b = (getattr(f, name).mean(axis=(0, 1)) for f in (few, many))
        assert a == pytest.approx(b, rel=1e-9, abs=1e-9 * np.abs(b).max())
    assert few.windup == many.windup
    part = flank_fields(helical, 4, span=(-4e-3, 0.0))
    assert part.own == pytest.approx(flank_fields(helical, 8).own[:4, :4], rel=1e-9)


WEBS = {
    "disc": {"bore_diameter": 12e-3},
    "web": {"bore_diameter": 12e-3, "rim_thickness": 2.5e-3, "web_thickness": 2e-3},
    "thin": {"bore_diameter": 12e-3, "rim_thickness": 1.5e-3, "web_thickness": 1e-3},
}


@pytest.mark.parametrize("beta", [0.0, 0.35])
@pytest.mark.parametrize(("body", "heights"), [("disc", 4), ("web", 3), ("thin", 4)])
def test_any_number_of_teeth_is_positive_semidefinite(body, heights, beta):
    gear = CylindricalGear(z=40, m_n=1e-3, b=10e-3, beta=beta)
    found = solved(gear, **WEBS[body])
    fields = flank_fields(found, 7, heights=heights)
    rng = np.random.default_rng(1)
    for teeth in (1, 2, 5):
        rho = fields.roll[0] + (fields.roll[1] - fields.roll[0]) * rng.uniform(0.0, 1.0, (teeth, 7))
        C = fields.matrix(rho, teeth)
        assert np.abs(C - C.T).max() <= 1e-12 * np.abs(C).max()
        assert np.linalg.eigvalsh(C)[0] > -1e-9 * np.abs(C).max()
    assert (fields.provenance["coupling_ratio"] > 0.5) == (body != "disc")
    assert fields.windup > 0.0


@pytest.mark.parametrize("z", [17, -60])
def test_four_polynomials_suffice(z):
    """Fitted to the compliance at equal heights, relative to the compliance with local approach: 1.2 %."""
    gear = CylindricalGear(z=z, m_n=1e-3) if z > 0 else CylindricalGear.internal(z=-z, m_n=1e-3)
    found = solved(gear, replace(SMALL, heights=8, widths=3))
    t = np.linspace(-1.0, 1.0, 21)
    few, all_ = (
        np.einsum("km,mn,kn->k", P, fields.own[0, 0], P)
        for fields in (flank_fields(found, 1, heights=4), flank_fields(found, 1))
        for P in [np.polynomial.legendre.legvander(t, fields.order - 1)]
    )
    total = all_ + approach(0.8e-3, 50e-6) / gear.b
    assert np.abs(few / total - all_ / total).max() < 0.012
    assert np.sqrt(np.mean((few / total - all_ / total) ** 2)) < 0.005


def test_windup_and_neighbours_add_up():
    """Uniform forces on the same and the next tooth, against the displacements of the finite elements."""
    gear = CylindricalGear(z=40, m_n=1e-3, b=10e-3)
    found = solved(gear, bore_diameter=12e-3)
    fields = flank_fields(found, 5)
    same = gear.b * (fields.own.mean(axis=(0, 1))[0, 0] + fields.windup) - found.contact[0] ** 2
    assert same == pytest.approx(found.same[0, 0, 0, 0], rel=1e-6)
    beside = gear.b * (fields.beside.mean(axis=(0, 1))[0, 0] + fields.windup)
    assert beside == pytest.approx(found.next[0, 0, 0, 0], rel=1e-6)
    assert gear.b * fields.windup == pytest.approx(found.far[0, 0, 0, 0], rel=1e-9)
    # the farther, the less, and a large part of the displacement is common to all
    assert (
        0.2 < found.far[0, 0, 0, 0] / found.same[0, 0, 0, 0] < found.next[0, 0, 0, 0] / found.same[0, 0, 0, 0]
    )


def test_a_web_as_wide_as_the_rim_is_a_disc():
    gear = CylindricalGear(z=40, m_n=1e-3, b=10e-3)
    disc = solved(gear, bore_diameter=20e-3)
    web = solved(gear, bore_diameter=20e-3, rim_thickness=3e-3, web_thickness=9.999e-3)
    assert web.same == pytest.approx(disc.same, rel=0.01, abs=2e-4 * disc.same.max())


@pytest.mark.parametrize("z", [10, 120, -40, -120])
def test_many_sizes_of_gears(z):
    """The tooth is softest at its tip, and its tension side has the largest stress near the 30° tangent."""
    gear = CylindricalGear(z=z, m_n=1e-3, b=5e-3, x=0.2 if z > 0 else 0.0)
    body = {} if z < 0 else {"bore_diameter": 1.4 * tooth_form(gear).r_f}
    found = tooth_fe(ToothModel(gear=gear, resolution=SMALL, **body))
    t = np.array([-0.9, 0.0, 0.9])
    P = np.polynomial.legendre.legvander(t, 3)
    diagonal = np.einsum("km,mn,kn->k", P, found.same[:, 0, :, 0], P)
    assert (np.diff(diagonal) > 0.0).all()
    stress = np.einsum("fm,km->fk", found.stress[:, 0, 0, 1, :, 0], P)
    assert (stress[1:-1] > 0.0).all()
    assert math.radians(15.0) < found.tangents[int(np.argmax(stress[:, 2]))] < math.radians(70.0)


def test_stress_by_planes(spur):
    """A uniform force gives the uniform stress in the middle, and nearly plane strain."""
    force = 1000.0
    at = np.array([-2e-3, 0.0, 2e-3])
    by_planes = stress_by_planes(spur, 8, at)
    assert by_planes.shape == (5, 3, 3, 3, 8, 4)
    stress = np.einsum("fckjm,m->fck", by_planes[:, :, :, 1], MIDDLE) * force / 8.0
    assert stress[:, :, 0] == pytest.approx(stress[:, :, 2] * np.array([1.0, 1.0, -1.0]), rel=1e-6, abs=1.0)
    assert stress[:, 2, 1] == pytest.approx(0.0, abs=1e-6 * np.abs(stress).max())
    ratio = stress[:, 1, 1] / stress[:, 0, 1]
    assert (ratio > 0.25).all() and (ratio < 0.36).all()
    assert principal_stress(stress.swapaxes(0, 1))[:, 1] == pytest.approx(stress[:, 0, 1], rel=1e-6)


def test_storage(spur, tmp_path, monkeypatch):
    monkeypatch.setattr(store, "user_cache", lambda: tmp_path)
    calls = []
    monkeypatch.setattr(store.solve, "tooth_fe", lambda model: calls.append(model) or spur)
    gear = CylindricalGear(z=17, m_n=1e-3, b=8e-3)
    model = ToothModel(gear=gear, bore_diameter=2.0 * clamped_radius(gear), resolution=SMALL)
    store.stored_tooth_fe(model)
    found = store.stored_tooth_fe(model)
    assert calls == [model]
    for name, value in spur.to_arrays().items():
        assert (found.to_arrays()[name] == value).all()
    assert found.provenance == spur.provenance
    # a damaged file is replaced, another input has another file
    store.file_of(model).write_bytes(b"PK broken")
    store.stored_tooth_fe(model)
    store.stored_tooth_fe(model)
    assert len(calls) == 2
    # changed bytes: the method of compression and the flags in the directory of the archive
    good = store.file_of(model).read_bytes()
    start = good.index(b"PK\x01\x02")
    for at, byte in ((10, 8), (10, 12), (10, 14), (10, 99), (8, 1), (8, 32)):
        store.file_of(model).write_bytes(good[: start + at] + bytes([byte]) + good[start + at + 1 :])
        assert (store.stored_tooth_fe(model).same == spur.same).all()
    others = [
        replace(model, E=2e11),
        replace(model, gear=gear.replace(x=0.1)),
        replace(model, bore_diameter=9e-3),
    ]
    assert len({store.file_of(m) for m in [model, *others]}) == 4
    # a folder that cannot be created
    (tmp_path / "file").touch()
    monkeypatch.setattr(store, "user_cache", lambda: tmp_path / "file")
    assert store.stored_tooth_fe(model) is spur


def test_a_given_outline_has_the_stored_elements_of_the_generated_tooth(monkeypatch):
    """Finite elements use the generated tooth: no other file, no other calculation."""
    monkeypatch.setattr(flexible_teeth, "stored_tooth_fe", store.file_of)
    gear = CylindricalGear(z=17, m_n=1e-3, b=8e-3)
    given = gear.replace(outline=ToothOutline(((7e-3, -1e-3), (9e-3, 0.0), (7e-3, 1e-3))))
    settings = {"material_data": material("steel"), "bore_diameter": 0.0}
    settings |= {"rim_thickness": None, "web_thickness": None}
    files = {
        flexible_teeth.finite_elements_of(SimpleNamespace(geometry=geometry, **settings))
        for geometry in (gear, given)
    }
    assert len(files) == 1
