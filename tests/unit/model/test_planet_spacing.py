# SPDX-License-Identifier: Apache-2.0
"""Angles at which planets fit, against a search over all orientations of their teeth."""

from __future__ import annotations

import itertools
import math
from fractions import Fraction

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.planet_spacing import spacing_teeth
from pitchpoint.report.planets import stages_of_model
from tests.support.planet_gearboxes import stepped


def fits(place, meshes):
    """Whether planets fit at a place (turns), tried with every tooth.

    The first mesh of each rotating part with a central gear or a known part fixes it up to one of its teeth.
    """
    parts = list(dict.fromkeys(part for teeth, _ in meshes for part in teeth))

    def rest(known, left):
        if not left:
            return True
        for mesh in left:
            teeth, central = mesh
            unknown = [part for part in teeth if part not in known]
            others = [m for m in left if m is not mesh]
            value = sum(z * known[part] for part, z in teeth.items() if part in known) - central * place
            if not unknown:
                return value.denominator == 1 and rest(known, others)
            if len(unknown) == 1:
                z = teeth[unknown[0]]
                turns = (Fraction(n - value) / z for n in range(z))
                return any(rest({**known, unknown[0]: x}, others) for x in turns)
        raise AssertionError(parts)

    return rest({}, list(meshes))


CASES = {
    "single": [({"p": 7}, 6), ({"p": 7}, -20)],
    "stepped": [({"p": 9}, 5), ({"p": 6}, -20)],
    "Wolfrom": [({"p": 8}, 4), ({"p": 8}, -20), ({"p": 6}, -18)],
    "series": [({"i": 5}, 6), ({"i": 5, "o": 7}, 0), ({"o": 7}, -27)],
    "Ravigneaux": [({"i": 5}, 6), ({"i": 5, "o": 7}, 0), ({"o": 7}, -21), ({"o": 7}, 9)],
    "fitted step": [({"p": 9}, 5), ({"s": 6}, -20)],
}


@pytest.mark.parametrize("name", CASES)
def test_places_on_a_turn(name):
    """Any fraction of a turn with a denominator up to 60 fits if and only if it is a multiple of 1/M."""
    meshes = CASES[name]
    count = spacing_teeth(meshes)
    tried = {Fraction(n, d) for d in range(1, 61) for n in range(d)}
    tried |= {Fraction(1, count)} if count else set()
    for place in tried:
        assert fits(place, meshes) == (count == 0 or (place * count).denominator == 1), place


def test_known_conditions():
    """z_s + z_r; z_r - z_s of planets in series; (z_s z_2 + z_r z_1)/gcd(z_1, z_2) of stepped planets."""
    for z_s, z_1, z_2, z_r in itertools.product((20, 21), (14, 15), (12, 18), (60, 63)):
        assert spacing_teeth([({"p": z_1}, z_s), ({"p": z_1}, -z_r)]) == z_s + z_r
        series = [({"p": z_1}, z_s), ({"p": z_1, "q": z_2}, 0), ({"q": z_2}, -z_r)]
        assert spacing_teeth(series) == z_r - z_s
        common = next(n for n in range(z_2, 0, -1) if z_1 % n == 0 and z_2 % n == 0)
        stepped_planets = [({"p": z_1}, z_s), ({"p": z_2}, -z_r)]
        assert spacing_teeth(stepped_planets) == (z_s * z_2 + z_r * z_1) // common


def refused(text):
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    return [str(each) for each in caught.value.problems]


def test_stepped_planets_that_cannot_be_assembled():
    """21 18 + 78 39 = 3420 over the common divisor 3: 1140 places."""
    problem = refused(stepped(7))[0]
    assert "planetary_stages.planet.planets" in problem
    assert "cannot be assembled at equal angles: 1140/7 = 162.857 is not a whole number" in problem
    assert "whole multiples of 360 deg/1140 between the planets" in problem
    assert "give angles: [0 deg, 51.4736842 deg," in problem
    assert "or 6 planets, or fitted: true at a step" in problem


def orientations(text):
    """Orientation of the step of every planet [deg]."""
    rows = stages_of_model(loads_model(text))["planet"]["planets"].values()
    return [math.degrees(row["orientations"]["small"]) for row in rows]


def test_equal_planets_have_one_orientation():
    """As assembled, or as given; other teeth of 39 and 18 have other angles by multiples of 360/234 deg."""
    assert orientations(stepped()) == pytest.approx([0.0] * 3, abs=1e-6)
    assert orientations(stepped(step_more="orientation: 0.4 deg")) == pytest.approx([0.4] * 3, abs=1e-5)
    turned = stepped(step_more=f"orientation: {0.4 + 5 * 360 / 234!r} deg")
    assert orientations(turned) == pytest.approx([0.4] * 3, abs=1e-5)


def test_the_orientation_moves_the_phase_of_the_step():
    """Between the meshes of the first planet: by 18 teeth times the angle."""
    travels = []
    for angle in (0.0, 7.0):
        model = loads_model(stepped(step_more=f"orientation: {angle!r} deg"))
        found = model.phasing
        assert max(map(abs, found.offset.values())) < 1e-12
        travels.append(
            [found.travel[n] / model.pairs[n].p_et for n in ("sun-planet_1", "planet_1-small-output_ring")]
        )
    change = [b - a for a, b in zip(*travels, strict=True)]
    assert change[0] == pytest.approx(0.0, abs=1e-12)
    assert math.remainder(change[1] - 18 * 7.0 / 360.0, 1.0) == pytest.approx(0.0, abs=1e-9)


def test_fitted_steps_fit_at_any_angle():
    """The teeth of a step are turned on its planet by as much as the ring misses, modulo both pitches."""
    text = stepped(step_more="fitted: true").replace("planets: 3", "angles: [0 deg, 101 deg, 220 deg]")
    model = loads_model(text)
    assert max(map(abs, model.phasing.offset.values())) < 1e-12
    turned = orientations(text)
    for psi, own in zip((0.0, 101.0, 220.0), turned, strict=True):
        # the planet turns by z_s psi/39 for the sun, the step by -z_r psi/18 for the ring
        wanted = turned[0] - 78 * psi / 18 - 21 * psi / 39
        assert math.remainder(own - wanted, 360 / 234) == pytest.approx(0.0, abs=1e-5)
    problem = refused(text.replace("fitted: true", "fitted: false"))[0]
    assert "cannot be assembled: a planet is 0.1053 deg off" in problem
