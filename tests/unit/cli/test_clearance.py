# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint clearance`: numbers against closed forms, limits, neighbours, picture, refusals."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import TORSION, json_of, written

M = 2e-3
TEETH = "normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0"
DISTANCE = 0.042


def planets(count: int, z: int = 18) -> str:
    """Planets around a sun of 24 teeth, in no mesh with each other."""
    bodies, gears, meshes = [], [], []
    for k in range(count):
        angle = 2.0 * math.pi * k / count
        x, y = DISTANCE * math.cos(angle), DISTANCE * math.sin(angle)
        gears.append(f"  p{k}: {{number_of_teeth: {z}, {TEETH}}}")
        bodies.append(f"  b{k}: {{gears: [p{k}], position: [{x!r}, {y!r}, 0]}}")
        meshes.append(f"  m{k}: {{gears: [sun, p{k}], center_distance: 42 mm}}")
    head = f"gears:\n  sun: {{number_of_teeth: 24, {TEETH}}}\n"
    body = "bodies:\n  s: {gears: [sun], position: [0, 0, 0]}\n"
    return head + "\n".join(gears) + f"\n{body}" + "\n".join(bodies) + "\nmeshes:\n" + "\n".join(meshes)


def test_numbers_of_a_stage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The backlash of the file thins the teeth; c = 0.25 m_n for the standard rack, limit 0.1 m_n."""
    found = json_of(["clearance", written(tmp_path, TORSION)], capsys)
    gears = json_of(["gears", written(tmp_path, TORSION)], capsys)
    stage, mesh = found["meshes"]["stage"], gears["meshes"]["stage"]
    rows = stage["clearances"]
    assert stage["gears"] == ["g1", "g2"]
    m_n = gears["gears"]["g1"]["m_n"]
    for kind in ("front_flanks", "back_flanks"):
        assert rows[kind]["distance"] == pytest.approx(0.5 * mesh["j_bt"], abs=1e-6 * m_n)
        assert rows[kind]["normal"] == pytest.approx(0.5 * mesh["j_bn"], abs=1e-6 * m_n)
    for kind, key in (("tip_1_root_2", "c_1"), ("tip_2_root_1", "c_2")):
        assert rows[kind]["distance"] == pytest.approx(mesh[key], rel=1e-9)
        assert rows[kind]["limit"] == pytest.approx(0.1 * m_n)
    assert rows["face"]["distance"] == pytest.approx(mesh["b_w"])
    assert found["fine"] and all(row["fine"] for row in rows.values())
    # the places are as far apart as it is said
    for row in rows.values():
        if "places" in row:
            assert math.dist(*row["places"]) == pytest.approx(abs(row["distance"]), abs=1e-9 * m_n)


@pytest.mark.parametrize("count, z", [(5, 18), (6, 18), (7, 18)])
def test_planets_beside_each_other(
    count: int, z: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """2 a sin(pi/N) - d_a between neighbours; 7 planets of 18 teeth overlap."""
    found = json_of(["clearance", written(tmp_path, planets(count, z))], capsys)
    room = 2.0 * DISTANCE * math.sin(math.pi / count) - M * (z + 2)
    near = found["neighbours"][:count]
    assert [row["distance"] for row in near] == pytest.approx([room] * count, abs=1e-12)
    assert {row["fine"] for row in near} == {room >= 0.0} == {found["fine"]}
    assert all(row["between"].startswith("tip of p") for row in near)


def test_a_shaft_beside_a_gear(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The second section of the shaft lies beside the gear, 60 mm from its axis: 60 - 26 - 30 mm."""
    text = f"""
gears: {{a: {{number_of_teeth: 24, {TEETH}}}}}
bodies: {{one: {{gears: {{a: 70 mm}}, position: [0, 0, 0]}}}}
shafts:
  other:
    position: [60 mm, 0, 0]
    sections: [{{length: 40 mm, diameter: 90 mm}}, {{length: 90 mm, diameter: 60 mm}}]
"""
    found = json_of(["clearance", written(tmp_path, text)], capsys)
    (row,) = found["neighbours"]
    assert row["between"] == "tip of a to shaft other"
    assert row["distance"] == pytest.approx(4e-3, abs=1e-12)


def test_gears_beside_each_other_in_height_do_not_count(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = planets(7).replace("gears: [p0]", "gears: {p0: 19 mm}").replace("[p1], pos", "{p1: -19 mm}, pos")
    found = json_of(["clearance", written(tmp_path, text)], capsys)
    pairs = {frozenset(re.findall(r"p\d", row["between"])) for row in found["neighbours"]}
    assert {frozenset({"p0", "p6"}), frozenset({"p1", "p2"})} < pairs
    assert frozenset({"p0", "p1"}) not in pairs
    # what overlaps the sun by a millimetre carries there alone
    face = found["meshes"]["m0"]["clearances"]["face"]
    assert face["distance"] == pytest.approx(1e-3) and not face["fine"]


def test_table_and_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model, picture = written(tmp_path, planets(7)), tmp_path / "room.svg"
    assert run_command(["clearance", model, "--mesh", "m1", "-o", str(picture)]) == 0
    said = capsys.readouterr().out
    assert "tip of sun to root of p1" in said and "0.5 mm" in said and "do not mesh" not in said
    root = ET.fromstring(picture.read_text(encoding="utf-8"))
    words = ["".join(e.itertext()) for e in root.iter("{http://www.w3.org/2000/svg}text")]
    assert "m1: sun / p1" in words and "3  tip of sun to root of p1" in words
    assert any(w.startswith("0.5 mm, limit 0.2 mm: OK") for w in words)
    # written again, since it is ours; all meshes, and the neighbours in words
    assert run_command(["clearance", model, "-o", str(picture)]) == 0
    said = capsys.readouterr().out
    assert "overlap" in said and "7 distances below their limits, of which 7 overlap" in said


def test_what_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = written(tmp_path, planets(3))
    for arguments, words in (
        (["--mesh", "m9"], "no mesh 'm9'; there are m0, m1, m2"),
        (["-o", str(tmp_path / "room.png")], "does not end in .svg"),
    ):
        assert run_command(["clearance", model, *arguments]) == 2
        assert words in capsys.readouterr().err
    mine = tmp_path / "mine.svg"
    mine.write_text("<svg/>", encoding="utf-8")
    assert run_command(["clearance", model, "-o", str(mine)]) == 2
    assert mine.read_text(encoding="utf-8") == "<svg/>"


def test_a_tooth_from_a_file_leaves_the_same_room(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Points that `gears --export` writes of a thinner tooth, read back by a nominal gear, lose nothing."""
    text = f"""
gears:
  a: {{number_of_teeth: 24, {TEETH}, drawing_resolution: 200, THIN}}
  b: {{number_of_teeth: 41, {TEETH}}}
meshes: {{m: {{gears: [a, b], center_distance: 65 mm}}}}
"""
    thin = written(tmp_path, text.replace("THIN", "tooth_thickness_allowance: -80 um"), "thin.yaml")
    assert run_command(["gears", thin, "--gear", "a", "--export", str(tmp_path / "a.csv")]) == 0
    capsys.readouterr()
    real = written(tmp_path, text.replace("THIN", "tooth_profile: {tooth: a.csv}"), "real.yaml")
    rows = [json_of(["clearance", file], capsys)["meshes"]["m"]["clearances"] for file in (thin, real)]
    expected = 0.5 * 80e-6 * math.cos(math.radians(20.0))
    for kind, one in rows[0].items():
        # where the fillet begins is told by the form circle of the nominal gear, which lies elsewhere
        if kind != "tip_2_fillet_1":
            assert rows[1][kind]["distance"] == pytest.approx(one["distance"], abs=1e-4 * M), kind
    assert rows[1]["front_flanks"]["distance"] == pytest.approx(expected, abs=1e-4 * M)
    picture = tmp_path / "real.svg"
    assert run_command(["gears", real, "--gear", "a", "--preview", str(picture)]) == 0
    assert picture.stat().st_size > 10_000


MICRO = f"""
gears:
  a: {{number_of_teeth: 30, {TEETH}, tooth_thickness_allowance: -40 um}}
  b: {{number_of_teeth: 30, {TEETH}}}
meshes: {{m: {{gears: [a, b], center_distance: 60 mm}}}}
"""


def test_flanks_with_modifications_and_misalignment(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Excess material at the tip and a tilt: j_bt/2 less 5 µm and less cos(alpha) f b/2."""
    plain = json_of(["clearance", written(tmp_path, MICRO)], capsys)["meshes"]["m"]["clearances"]
    changed = MICRO.replace(
        "allowance: -40 um", "allowance: -40 um, modifications: {left: {profile_slope: 10 um}}"
    )
    changed = changed.replace("60 mm}", "60 mm, misalignment: {out_of_plane: 0.3 mrad}}")
    found = json_of(["clearance", written(tmp_path, changed)], capsys)["meshes"]["m"]
    rows, lean = found["clearances"], math.cos(math.radians(20.0)) * 0.3e-3 * 10e-3
    half = plain["front_flanks"]["distance"]
    assert rows["front_flanks"]["distance"] == pytest.approx(half - 5e-6 - lean, abs=1e-8)
    assert rows["back_flanks"]["distance"] == pytest.approx(half - lean, abs=1e-8)
    assert rows["tip_1_root_2"] == plain["tip_1_root_2"]
    assert found["notes"] == []
    ends = rows["front_flanks"]["places"]
    assert math.dist(*ends) == pytest.approx(rows["front_flanks"]["distance"], abs=1e-9)


def test_flanks_with_too_much_material_overlap(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    changed = MICRO.replace("allowance: -40 um", "allowance: -40 um, deviations: {runout: {amount: 90 um}}")
    found = json_of(["clearance", written(tmp_path, changed)], capsys)
    row = found["meshes"]["m"]["clearances"]["front_flanks"]
    assert row["distance"] == pytest.approx(18.79e-6 - 45e-6, abs=0.3e-6)
    assert not row["fine"] and not found["fine"]


def test_interference_with_a_fillet_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = MICRO.replace("a: {number_of_teeth: 30", "a: {number_of_teeth: 15").replace("60 mm}", "45 mm}")
    (note,) = json_of(["clearance", written(tmp_path, text)], capsys)["meshes"]["m"]["notes"]
    assert note == (
        "interference of the tip of b with the fillet of a: contact would lie below the root form circle of a"
    )
