# SPDX-License-Identifier: Apache-2.0
"""Teeth read from files: the exported gear comes back, and an exported relief acts like the relief as a key.

The files are the exports of this package. A relief is cut into them along the normals of the exact flank,
found by differences of the profile, and not by the formula of the reader. Tolerances: a point of a file has
nine decimals of a millimetre; between the points the reader is linear, which leaves at most a quarter of the
distance of the points times the change of slope at the start of a relief, 0.04 um here; the law is of first
order in the deviation d, so d^2 over the length of the relief is left, 0.015 um.
"""

from __future__ import annotations

import csv
import io
import math
import re

import numpy as np
import pytest

from pitchpoint.geometry.modifications import deviation, flank_range
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.geometry.tooth_form import gear_outline, tooth_form
from pitchpoint.io.gear_export import drawing_dxf, drawing_svg, points_csv
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.system.compile import compile_model

KINDS = {
    "spur": (24, False, 0.0),
    "helical": (24, False, 20.0),
    "ring": (60, True, 0.0),
    "helical ring": (60, True, 15.0),
}
NUMBER = r"-?\d+\.\d{6,9}"
EVERY_KIND = pytest.mark.parametrize("kind", list(KINDS))


def machine(folder, kind, one="", two="", torque=300.0):
    """Pair on spinning bodies, loaded on the front flanks, in a file beside the profiles."""
    z2, internal, beta = KINDS[kind]
    turn = f", helix_angle: {beta} deg, hand: " if beta else ""
    hands = ("left", "left" if internal else "right") if beta else ("", "")
    gear = "number_of_teeth: {}, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0.1{}{}{}"
    first = gear.format(21, turn, hands[0], one)
    second = gear.format(z2, turn, hands[1], two) + (", type: internal" if internal else "")
    distance = 1.5 / math.cos(math.radians(beta)) * ((z2 - 21) if internal else (21 + z2))
    distance += -0.9 if internal else 0.9
    file = folder / "model.yaml"
    file.write_text(
        f"gears:\n  g1: {{{first}}}\n  g2: {{{second}}}\n"
        "bodies:\n  driver: {gears: [g1]}\n  driven: {gears: [g2]}\n"
        f"meshes:\n  stage: {{gears: [g1, g2], center_distance: {distance!r} mm, stiffness: {{law: din3990, "
        "single_stiffness: 14 N/(mm um), stiffness_ratio: 1, tip_relief_factor: 0}}\n"
        "loads:\n  input: {body: driver, torque: balance}\n"
        f"  brake: {{body: driven, torque: {-torque if internal else torque} N m}}\n"
    )
    return load_model(file)


def errors(model):
    """Unloaded and loaded transmission error over a mesh cycle."""
    data = solve_quasistatic(compile_model(model), "stage", 60, 1)
    return [data[f"{kind}transmission_error[stage]"].values for kind in ("unloaded_", "")]


def real_flank(gear, cut):
    """Radius and half angle of a left flank with modifications cut in along its normals, overlong."""
    form = tooth_form(gear)
    first, last = sorted(flank_range(gear))
    length = np.linspace(max(first - 1e-4, 2e-7), last + 1e-4, 40001)

    def flank(length):
        r = np.hypot(form.r_b, length)
        return r * np.exp(1j * form.involute_half_angle(r))

    tangent = flank(length + 1e-7) - flank(length - 1e-7)
    normal = 1j * tangent / np.abs(tangent)
    normal *= np.sign((normal * (1j * flank(length)).conj()).real)
    # normal to the flank in space; in the transverse section the same cut is longer
    point = flank(length) - normal * deviation(cut.of_geometry(), gear, length) / math.cos(gear.beta_b)
    return np.abs(point), np.angle(point)


def cut_into(gear, rows, sides):
    """Exported points, those of the involute turned to where the real flank has their radius, one tooth."""
    real = {side: real_flank(gear, cut) for side, cut in sides.items()}
    low, high = sorted((0.5 * abs(gear.d_Ff), 0.5 * abs(gear.d_Fa)))
    out = []
    for row in rows:
        point = complex(float(row["x [mm]"]), float(row["y [mm]"])) * 1e-3
        if row["tooth"] != "3":
            continue
        point *= np.exp(-2j * math.pi * 3 / abs(gear.z))
        side = 1.0 if point.imag > 0.0 else -1.0
        r, half = real["left" if side > 0.0 else "right"]
        if low - 1e-11 <= abs(point) <= high + 1e-11 and row["region"] != "tip":
            point = abs(point) * np.exp(1j * side * np.interp(abs(point), r, half))
        end = np.interp(0.5 * abs(gear.d_a), r, half)
        if row["region"] == "tip" and abs(np.angle(point)) > end - 1e-9:
            continue
        out.append((point * np.exp(2j * math.pi * 3 / abs(gear.z)) * 1e3, row))
    return out


def written(folder, name, points):
    lines = [f"{p.real:.9f},{p.imag:.9f},{row['tooth']},{row['region']}" for p, row in points]
    (folder / name).write_text("\n".join(["x [mm],y [mm],tooth,region", *lines]) + "\n")


def exported(gear, n_flank):
    return list(csv.DictReader(io.StringIO(points_csv(gear, n_flank))))


@EVERY_KIND
def test_an_exported_gear_comes_back(kind, tmp_path):
    plain = machine(tmp_path, kind)
    keys = []
    for name in ("g1", "g2"):
        gear = plain.gears[name]
        (tmp_path / f"{name}.csv").write_text(points_csv(gear.geometry, 20))
        keys.append(f", tooth_profile: {{tooth: {name}.csv}}")
    model = machine(tmp_path, kind, *keys)
    for name in ("g1", "g2"):
        one, two = plain.gears[name].geometry, model.gears[name].geometry
        # nine decimals of a millimetre, once more turned to the other teeth
        assert gear_outline(two, 20) == pytest.approx(gear_outline(one, 20), abs=2e-12)
        for draw in (drawing_svg, drawing_dxf, points_csv):
            found, expected = draw(two, 20), draw(one, 20)
            assert len(re.findall(NUMBER, found)) == len(re.findall(NUMBER, expected))
        assert len(gear_solid(two, 20)) == len(gear_solid(one, 20))
        # the chords between 20 points of a flank
        masses = [m.body_inertia({"g1": "driver", "g2": "driven"}[name]) for m in (plain, model)]
        assert masses[1].mass == pytest.approx(masses[0].mass, rel=4e-4)
        assert masses[1].polar == pytest.approx(masses[0].polar, rel=6e-4)
        roll = np.linspace(*flank_range(one), 50)
        for flank in ("left", "right"):
            assert np.abs(two.outline.gap(two, flank, roll)).max() < 1e-12
    # the same flanks, but by slices instead of the exact integral, as with any modification
    zero = ", modifications: {both: {lead_crowning: 0 um}}"
    for found, expected in zip(errors(model), errors(machine(tmp_path, kind, zero, zero)), strict=True):
        assert found == pytest.approx(expected, abs=2e-12)


@pytest.mark.each_value
@EVERY_KIND
@pytest.mark.parametrize("which", [1, 2])
def test_an_exported_relief_acts_like_the_relief(kind, which, tmp_path):
    """Other reliefs on the left than on the right; the mesh must find the right one."""
    both = (
        ", modifications: {left: {profile_slope: -4 um, tip_relief: {amount: 10 um, length: 7 mm}}, "
        "right: {profile_slope: 5 um, tip_relief: {amount: 8 um, length: 6 mm}}}"
    )
    keys = [both if k == which else "" for k in (1, 2)]
    wanted = machine(tmp_path, kind, *keys)
    gear = wanted.gears[f"g{which}"]
    sides = {side: gear.modifications.side(side) for side in ("left", "right")}
    written(tmp_path, "real.csv", cut_into(gear.geometry, exported(gear.geometry, 400), sides))
    given = machine(tmp_path, kind, *(k and ", tooth_profile: {tooth: real.csv, number: 3}" for k in keys))
    roll = np.linspace(*flank_range(gear.geometry), 129)
    for flank, cut in sides.items():
        expected = deviation(cut.of_geometry(), gear.geometry, roll) / math.cos(gear.geometry.beta_b)
        outline = given.gears[f"g{which}"].geometry.outline
        assert outline.gap(gear.geometry, flank, roll) == pytest.approx(expected, abs=0.06e-6)
    plain = errors(machine(tmp_path, kind))
    assert np.abs(errors(wanted)[1] - plain[1]).max() > 1e-6
    for found, expected in zip(errors(given), errors(wanted), strict=True):
        assert found == pytest.approx(expected, abs=0.06e-6)
