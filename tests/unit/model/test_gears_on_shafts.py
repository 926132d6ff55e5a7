# SPDX-License-Identifier: Apache-2.0
"""Mass of shafts with gears: every material once, in one body and in stations and beams alike."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.inertia import gear_inertia
from pitchpoint.model.remarks.bores import gears_thinner_than_their_shafts
from pitchpoint.system.rules.shaft import shaft_of
from tests.support.cli_files import json_of, written

FILE = """
gears:
  a: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0, BORE}
  b: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm,
    profile_shift_coefficient: 0}
bevel_gears:
  c: {number_of_teeth: 20, mate_teeth: 40, outer_transverse_module: 3 mm, face_width: 20 mm, opens: OPENS}
shafts:
  s:
    sections: [SECTIONS]
    gears: {GEARS}
    bevel_gears: {BEVEL}
    position: [0, 0, 0]
    PIECES
"""
RHO = 7830.0


def model_of(
    sections: str, gears: str = "", bevel: str = "", pieces: str = "", bore: str = "", opens: str = "+z"
):
    """A shaft with gears."""
    new = {"SECTIONS": sections, "GEARS": gears, "BEVEL": bevel, "PIECES": pieces, "OPENS": f'"{opens}"'}
    text = FILE.replace(", BORE", f", {bore}" if bore else "")
    for key, value in new.items():
        text = text.replace(key, value)
    return loads_model(text)


def tube(d: float, bore: float, low: float, high: float) -> np.ndarray:
    """Mass, its moments of first and second order along z, and polar inertia of a hollow cylinder."""
    line = RHO * math.pi / 4.0 * (d**2 - bore**2)
    powers = [line * (high**k - low**k) / k for k in (1, 2, 3)]
    return np.array([*powers, powers[0] * (d**2 + bore**2) / 8.0])


def totals(mass: float, polar: float, central: float, center: float) -> np.ndarray:
    """The same integrals from mass, inertias and centre."""
    return np.array([mass, mass * center, central - 0.5 * polar + mass * center**2, polar])


def alone(model, gear: str, place: float) -> np.ndarray:
    """The same of a full gear on a shaft."""
    mass, polar, transverse = gear_inertia(model.gears[gear])
    return totals(mass, polar, transverse, place)


def of_body(model) -> np.ndarray:
    found = model.body_inertia("s")
    return totals(found.mass, found.polar, found.central, found.center)


def of_stations(model) -> np.ndarray:
    """The same of stations and beams."""
    parts = shaft_of(model, "s", 1)
    total = np.zeros(4)
    for body, place in zip(parts.bodies, parts.places, strict=True):
        total += totals(body.mass, body.polar_inertia, body.transverse_inertia, place + body.center)
    for low, high in zip(parts.places[:-1], parts.places[1:], strict=True):
        end = 0.0
        for section in model.shafts["s"].sections:
            if end <= 0.5 * (low + high) <= end + section.length:
                total += tube(section.diameter, section.bore, low, high)
            end += section.length
    return total


CASES = {
    "through": ("{length: 200 mm, diameter: 50 mm}", "a: 60 mm", [(0.05, 0.045, 0.075)]),
    "hollow": ("{length: 200 mm, diameter: 50 mm, bore: 30 mm}", "a: 60 mm", [(0.05, 0.045, 0.075)]),
    "two": (
        "{length: 200 mm, diameter: 50 mm}",
        "a: 60 mm, b: 150 mm",
        [(0.05, 0.045, 0.075), (0.05, 0.14, 0.16)],
    ),
    "stepped": (
        "{length: 55 mm, diameter: 40 mm}, {length: 145 mm, diameter: 60 mm}",
        "a: 60 mm",
        [(0.04, 0.045, 0.055), (0.06, 0.055, 0.075)],
    ),
    "beyond the end": ("{length: 200 mm, diameter: 50 mm}", "a: 195 mm", [(0.05, 0.18, 0.2)]),
    "ring": ("{length: 200 mm, diameter: 50 mm}", "ring: 100 mm", []),
}
PLACES = {"a": {"stepped": 0.06, "beyond the end": 0.195}, "b": {}, "ring": {}}
DEFAULT = {"a": 0.06, "b": 0.15, "ring": 0.1}


@pytest.mark.parametrize("pieces", ["", "largest_piece: 7 mm"])
@pytest.mark.parametrize("case", CASES)
def test_material_counts_once(case: str, pieces: str) -> None:
    sections, gears, inside = CASES[case]
    model = model_of(sections, gears, pieces=pieces)
    wanted, end = np.zeros(4), 0.0
    for section in model.shafts["s"].sections:
        wanted += tube(section.diameter, section.bore, end, end + section.length)
        end += section.length
    for gear in model.bodies["s"].gears:
        wanted += alone(model, gear, PLACES[gear].get(case, DEFAULT[gear]))
    for d, low, high in inside:
        wanted -= tube(d, 0.0, low, high)
    np.testing.assert_allclose(of_body(model), wanted, rtol=1e-12)
    np.testing.assert_allclose(of_stations(model), wanted, rtol=1e-7)  # bare stations have 1e-9 of the mass


@pytest.mark.parametrize("opens", ["+z", "-z"])
def test_bevel_gears_of_either_direction(opens: str) -> None:
    """From 35.3 to 64.7 mm before or behind its apex, all on the shaft of 20 mm."""
    apex = "20 mm" if opens == "+z" else "120 mm"
    solid, bored = (
        model_of("{length: 200 mm, diameter: 20 mm}", bevel=f"c: {apex}", opens=opens).replace(
            "bevel_gears.c.bore_diameter", bore
        )
        for bore in (0.0, 0.02)
    )
    np.testing.assert_allclose(of_body(solid), of_body(bored), rtol=1e-11)
    np.testing.assert_allclose(of_stations(solid), of_body(bored), rtol=1e-7)
    blank = solid.bevel_gears["c"].blank
    way = 1.0 if opens == "+z" else -1.0
    step = 1e3 * (float(apex.split()[0]) * 1e-3 + way * 0.5 * (blank.toe[1] + blank.back[1]))
    thin = model_of(
        f"{{length: {step} mm, diameter: 20 mm}}, {{length: {200 - step} mm, diameter: 10 mm}}",
        bevel=f"c: {apex}",
        opens=opens,
    )
    more = tube(0.02, 0.01, step * 1e-3, 0.2)  # less shaft, but more gear
    low, high = sorted(float(apex.split()[0]) * 1e-3 + way * z for z in (blank.toe[1], blank.back[1]))
    less = tube(0.02, 0.01, step * 1e-3, high)
    assert low < step * 1e-3 < high
    np.testing.assert_allclose(of_body(thin), of_body(solid) - more + less, rtol=1e-11)


def test_given_masses_stay() -> None:
    model = model_of("{length: 200 mm, diameter: 50 mm}", "a: 60 mm", bore="mass: 2 kg")
    shaft = RHO * math.pi / 4.0 * 0.05**2 * 0.2
    assert model.body_inertia("s").mass == pytest.approx(shaft + 2.0, rel=1e-12)
    whole = "mass: 2 kg, polar_inertia: 0.01 kg m^2, transverse_inertia: 0.006 kg m^2"
    model = model_of("{length: 200 mm, diameter: 50 mm}", "a: 60 mm", bore=whole)
    np.testing.assert_allclose(
        of_body(model), tube(0.05, 0.0, 0.0, 0.2) + totals(2.0, 0.01, 0.006, 0.06), rtol=1e-12
    )


def test_a_bore_smaller_than_the_shaft_is_told() -> None:
    shaft = "{length: 55 mm, diameter: 40 mm}, {length: 145 mm, diameter: 60 mm}"
    for bore, told in (("60 mm", False), ("59.9 mm", False), ("50 mm", True), ("0", False)):
        model = model_of(shaft, "a: 60 mm", bore=f"bore_diameter: {bore}")
        assert bool(gears_thinner_than_their_shafts(model)) == told, bore
    model = model_of(shaft, "a: 60 mm", bore="bore_diameter: 50 mm")
    assert "gears.a.bore_diameter (line 3): 50 mm is less than the 60 mm of the shaft s there" in str(
        gears_thinner_than_their_shafts(model)[0]
    )
    gap = tube(0.05, 0.04, 0.045, 0.055)  # on the thin section
    np.testing.assert_allclose(of_body(model), of_body(model_of(shaft, "a: 60 mm")) - gap, rtol=1e-12)
    bevel = model_of("{length: 200 mm, diameter: 20 mm}", bevel="c: 20 mm")
    assert gears_thinner_than_their_shafts(bevel.replace("bevel_gears.c.bore_diameter", 0.01))


def test_check_says_what_gears_add(tmp_path, capsys) -> None:
    text = FILE.replace(", BORE", "").replace("OPENS", '"+z"').replace("    PIECES\n", "")
    text = text.replace("SECTIONS", "{length: 200 mm, diameter: 50 mm}").replace("GEARS", "a: 60 mm")
    file = written(tmp_path, text.replace("BEVEL", "c: 20 mm"))
    found = json_of(["check", file], capsys)
    parts = found["shaft_masses"]["s"]
    assert list(parts) == ["sections", "a", "c"]
    assert sum(part["mass"] for part in parts.values()) == pytest.approx(
        found["bodies"]["s"]["mass"], rel=1e-12
    )
    assert parts["a"]["alone"] - parts["a"]["mass"] == pytest.approx(RHO * math.pi / 4.0 * 0.05**2 * 0.03)
    assert run_command(["check", file]) == 0
    assert "Masses on shafts" in capsys.readouterr().out
    table = {entry["name"]: entry["sources"] for entry in json_of(["mass", file], capsys)["masses"]}
    assert table["a"]["effective"]["mass"] == table["a"]["outside shaft"]["mass"] == parts["a"]["mass"]
    assert table["c"]["effective"]["mass"] == parts["c"]["mass"] < table["c"]["geometry"]["mass"]
    assert table["b"]["effective"] == table["b"]["geometry"]
