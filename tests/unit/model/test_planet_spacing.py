# SPDX-License-Identifier: Apache-2.0
"""Angles at which planets fit, against a search over all orientations of their teeth."""

from __future__ import annotations

import itertools
from fractions import Fraction

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.planet_spacing import spacing_teeth
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
