# SPDX-License-Identifier: Apache-2.0
"""Shafts of sections: stations where things sit, mass and stiffness of the whole, frequencies of the
continuum."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.model.components.shaft import Shaft, ShaftSection
from pitchpoint.system import evaluate
from pitchpoint.system.rules.shaft import Rider, shaft_parts
from pitchpoint.system.system import assemble
from tests.support.engine import frequencies

STEPPED = Shaft(
    sections=(
        ShaftSection(length=0.2, diameter=0.05),
        ShaftSection(length=0.1, diameter=0.08),
        ShaftSection(length=0.3, diameter=0.05, bore=0.02),
    )
)


def test_stations_stand_where_things_sit():
    riders = {
        "gear": Rider(place=0.25, mass=3.0, polar=0.02, central=0.012, center=0.01),
        "front": Rider(place=0.02),
        "seal": Rider(place=0.2 + 1e-8),  # at the step
        "motor": Rider(place=0.25, mass=1.0, polar=0.01, central=0.006, center=-0.03),
    }
    parts = shaft_parts("input", STEPPED, riders, first=4, origin=(1.0, 2.0, 3.0), angle=0.5)
    for name, rider in riders.items():
        assert parts.places[parts.stations[name] - 4] == pytest.approx(rider.place, abs=1e-6)
    assert parts.stations["gear"] == parts.stations["motor"]
    assert np.min(np.diff(parts.places)) > 1e-3
    for step in (0.0, 0.2, 0.3, 0.6):
        assert np.abs(parts.places - step).min() < 1e-6
    pieces = np.diff(parts.places)
    assert np.all(pieces <= 0.16 + 1e-12)
    assert np.all(pieces[parts.places[1:] <= 0.2 + 1e-6] <= 0.1 + 1e-6)
    assert parts.beams["i"].tolist() == list(range(4, 4 + pieces.size))
    hub = parts.bodies[parts.stations["gear"] - 4]
    assert hub.mass == pytest.approx(4.0)
    assert hub.center == pytest.approx((3.0 * 0.01 - 0.03) / 4.0, abs=1e-9)
    about = 0.012 + 3.0 * 0.01**2 + 0.006 + 0.03**2  # about the place
    assert hub.transverse_inertia + hub.mass * hub.center**2 == pytest.approx(about, rel=1e-6)
    np.testing.assert_allclose(parts.bodies[0].position, [1.0, 2.0, 3.0])
    assert parts.names[0] == "input.1"
    assert [b.name for b in parts.bodies[:2]] == ["input", "input.2"]


def test_mass_and_stiffness_are_those_of_the_sections():
    parts = shaft_parts("s", STEPPED, {}, first=1)
    steel = STEPPED.material_data
    areas = [math.pi / 4 * (0.05**2), math.pi / 4 * 0.08**2, math.pi / 4 * (0.05**2 - 0.02**2)]
    volume = sum(a * h for a, h in zip(areas, (0.2, 0.1, 0.3), strict=True))
    assert parts.beams["mass"].sum() == pytest.approx(volume * steel.density, rel=1e-12)
    polar = [math.pi / 32 * (d**4 - b**4) for d, b in ((0.05, 0.0), (0.08, 0.0), (0.05, 0.02))]
    soft = sum(h / (steel.shear_modulus * p) for p, h in zip(polar, (0.2, 0.1, 0.3), strict=True))
    assert np.sum(1.0 / parts.beams["k_t"]) == pytest.approx(soft, rel=1e-12)


def test_free_shaft_swings_like_the_continuum():
    """Torsion and stretching of a uniform shaft, free at both ends: n c / 2 L."""
    shaft = Shaft(sections=(ShaftSection(length=1.0, diameter=0.05),), largest_piece=0.05)
    parts = shaft_parts("s", shaft, {"disc": Rider(place=0.31)}, first=1)
    system = assemble(parts.bodies, {"shaft_beam": parts.beams}, names={"shaft_beam": parts.names})
    M, _, K = evaluate.linearize(system, system.initial_state())
    found = frequencies(M, K)
    steel = shaft.material_data
    torsion = math.sqrt(steel.shear_modulus / steel.density) / 2.0
    # 21 pieces: pi^2/24 n^2 too high
    assert np.abs(found / torsion - 1.0).min() < 1.2e-3
    assert np.sum(found < 1.0) == 6


def test_a_rider_off_the_shaft_is_named():
    with pytest.raises(CompileError, match=r"shaft input: is 0.6 m long; not on it: gear at 0.7 m"):
        shaft_parts("input", STEPPED, {"gear": Rider(place=0.7)}, first=1)
