# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint frequencies` on trains of stages, planet sets with other members held, and rolling bearings."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint.analysis.bearing_frequencies import bearing_frequencies
from pitchpoint.analysis.fault_frequencies import train_frequencies
from pitchpoint.analysis.planet_frequencies import planetary_frequencies
from pitchpoint.cli.main import run_command
from tests.support.cli_files import ISO_EX1, json_of, written
from tests.support.planet_gearboxes import ravigneaux
from tests.support.planet_stages import stage_file

RPM = math.pi / 30.0

STAGES = ((11, 81, 12, 16, 580), (12, 68, 16, 12, 665), (11, 36, 30, 12, 750))
"""Teeth, normal module [mm], helix angle [deg] and centre distance [mm] of the mining shovel."""


def _stage(k: int, pinion: int, wheel: int, module: int, beta: int) -> str:
    """Gears of one stage; the shift of the wheel follows from the centre distance."""
    both = f"normal_module: {module} mm, helix_angle: {beta} deg, face_width: 200 mm"
    return (
        f"  Z{2 * k + 1}: {{number_of_teeth: {pinion}, {both}, hand: left, profile_shift_coefficient: 0.4}}\n"
        f"  Z{2 * k + 2}: {{number_of_teeth: {wheel}, {both}, hand: right}}"
    )


SHOVEL = "\n".join(
    [
        "title: travel drive",
        "gears:",
        *(_stage(k, *stage[:4]) for k, stage in enumerate(STAGES)),
        "bodies:",
        "  motor: {gears: [Z1]}",
        "  second: {gears: [Z2, Z3]}",
        "  third: {gears: [Z4, Z5]}",
        "  output: {gears: [Z6]}",
        "meshes:",
        *(
            f"  stage_{k + 1}: {{gears: [Z{2 * k + 1}, Z{2 * k + 2}], center_distance: {stage[4]} mm}}"
            for k, stage in enumerate(STAGES)
        ),
        "scenarios:",
        "  rated: {speed: {motor: 740 rpm}, duration: 1 s}",
    ]
)


def grc(held: str = "ring", driven: str = "carrier: 22.09 rpm", more: str = "") -> str:
    """Planet set 21/39/99 of three planets with one member held; planets are on roller bearings."""
    gear = "normal_module: 10 mm, face_width: 100 mm, profile_shift_coefficient: 0"
    angles = [2.0 * math.pi * k / 3 for k in range(3)]
    places = [f"[{300 * math.cos(a)!r} mm, {300 * math.sin(a)!r} mm, 0]" for a in angles]
    motion = {name: "motion: fixed, " if name == held else "" for name in ("sun", "ring")}
    motion["carrier"] = f"motion: {'fixed' if held == 'carrier' else 'torsion'}, "
    lines = [
        f"gears:\n  sun: {{number_of_teeth: 21, {gear}}}",
        f"  ring: {{number_of_teeth: 99, type: internal, {gear}}}",
        *(f"  p{k}: {{number_of_teeth: 39, {gear}}}" for k in range(3)),
        "bodies:",
        f"  sun: {{gears: [sun], {motion['sun']}position: [0, 0, 0]}}",
        f"  ring: {{gears: [ring], {motion['ring']}position: [0, 0, 0]}}",
        f"  carrier: {{inertia: 100 kg m^2, mass: 500 kg, {motion['carrier']}position: [0, 0, 0], "
        "markers: {seat: {position: [300 mm, 0, 0]}}}",
        *(f"  b{k}: {{gears: [p{k}], position: {place}}}" for k, place in enumerate(places)),
        "joints:",
        *(f"  pin{k}: {{type: revolute, bodies: [carrier, b{k}]}}" for k in range(3)),
        "meshes:",
        *(f"  s{k}: {{gears: [sun, p{k}]}}\n  r{k}: {{gears: [p{k}, ring]}}" for k in range(3)),
        more,
        f"scenarios:\n  run: {{speed: {{{driven}}}, duration: 1 s}}",
    ]
    return "\n".join(lines)


def test_three_stages_of_the_shovel(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["frequencies", written(tmp_path, SHOVEL)], capsys)
    expected = train_frequencies([(11, 81), (12, 68), (11, 36)], 740 * RPM)
    assert [row["frequency"] for row in found["meshes"].values()] == pytest.approx(expected.mesh, rel=1e-12)
    assert [row["speed"] for row in found["shafts"].values()] == pytest.approx(expected.speed, rel=1e-12)
    assert found["gears"]["Z5"]["tooth_meets_all"] == pytest.approx(0.295570, abs=5e-7)
    assert found["scenario"] == "rated"
    assert found["planet_sets"] == found["rolling_bearings"] == {}


def test_a_speed_takes_the_place_of_a_scenario(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, SHOVEL)
    rated = json_of(["frequencies", file], capsys)
    found = json_of(
        ["frequencies", file, "--speed", f"output={740 * 11 * 12 * 11 / (81 * 68 * 36)!r} rpm"], capsys
    )
    assert found["scenario"] is None
    for name, row in found["meshes"].items():
        assert row["frequency"] == pytest.approx(rated["meshes"][name]["frequency"], rel=1e-12)


@pytest.mark.parametrize(
    ("speeds", "still"),
    [
        (("sun=300 rpm", "carrier=300 rpm"), "meshes"),  # the set turns as one body
        (("ring=100 rpm", "carrier=0 rpm"), "planet_sets"),
    ],
)
def test_what_stands_still_has_no_frequency(
    speeds: tuple[str, str], still: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Differences of speeds that cancel are zero, not their rounding such as 3.4e-14 Hz."""
    given = [word for speed in speeds for word in ("--speed", speed)]
    found = json_of(["frequencies", written(tmp_path, grc("")), *given], capsys)
    assert {row["frequency"] for row in found[still].values()} == {0.0}
    assert any(row["frequency"] > 1.0 for row in found["shafts"].values())


@pytest.mark.parametrize(
    ("held", "driven"),
    [
        ("ring", "carrier: 22.09 rpm"),
        ("sun", "ring: 50 rpm"),
        ("carrier", "sun: -80 rpm"),
        ("", "sun: 100 rpm, ring: 7 rpm"),
    ],
)
def test_planet_sets_with_each_member_held(
    held: str, driven: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = json_of(["frequencies", written(tmp_path, grc(held, driven))], capsys)
    given = {m: float(v.split()[0]) * RPM for m, v in (p.split(": ") for p in driven.split(", "))}
    speeds = given | ({held: 0.0} if held else {})
    expected = planetary_frequencies(
        z_sun=21, z_planet=39, z_ring=99, planets=3, **{f"speed_{m}": w for m, w in speeds.items()}
    )
    assert {round(row["frequency"], 9) for row in found["meshes"].values()} == {round(expected.mesh, 9)}
    gears = found["gears"]
    assert gears["sun"]["tooth_meets_all"] == pytest.approx(expected.sun_fault, rel=1e-9)
    assert gears["ring"]["tooth_meets_all"] == pytest.approx(expected.ring_fault, rel=1e-9)
    assert gears["p1"]["tooth_meets"] == pytest.approx(
        dict.fromkeys(("s1", "r1"), expected.planet_fault), rel=1e-9
    )
    assert gears["p1"]["tooth_meets_all"] == pytest.approx(expected.planet_fault_both, rel=1e-9)
    assert found["shafts"]["b0"]["speed"] == pytest.approx(
        expected.speed_planet + expected.speed_carrier, rel=1e-9
    )
    if held == "carrier":  # a star of gears: nothing goes round
        assert found["planet_sets"] == {}
        return
    carrier = found["planet_sets"]["carrier"]
    assert carrier["planet_pass"] == pytest.approx(expected.planet_pass, rel=1e-9, abs=1e-12)
    for gear in ("sun", "ring"):
        assert list(carrier["central"][gear]["phases"].values()) == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)
        assert carrier["central"][gear]["excites"] == ["rotational"] * 3


def test_planets_on_a_fixed_carrier_are_a_set(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """No planet passes, but the phases of the meshes are those of a rotating carrier: z k/N of the sun.

    51/17/85 teeth and four planets: 51 k/4 mesh cycles.
    """
    text = stage_file("planets: 4", mesh="backlash: {normal: 80 um}").replace(", tip_diameter: 292.5 mm", "")
    for old, new in ((39, 17), (21, 51), (99, 85)):
        text = text.replace(f"number_of_teeth: {old},", f"number_of_teeth: {new},")
    text = text.replace("motion: fixed", "motion: torsion, inertia: 1 kg m^2", 1)
    text = text.replace("inertia: 0.1 kg m^2, mass: 10 kg", "motion: fixed")
    text = text.replace("body: carrier", "body: ring")
    found = json_of(["frequencies", written(tmp_path, text), "-s", "steady"], capsys)
    carrier = found["planet_sets"]["carrier"]
    assert carrier["planets"] == [f"planet_{k}" for k in (1, 2, 3, 4)]
    assert carrier["planet_pass"] == carrier["frequency"] == 0.0
    phases = carrier["central"]["sun"]["phases"].values()
    assert [phase % 1.0 for phase in phases] == pytest.approx([0.0, 0.75, 0.5, 0.25], abs=1e-8)
    assert carrier["central"]["sun"]["excites"] == ["translational", "planet", "translational"]


def test_bearings_of_a_shaft_and_of_a_planet(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The load of a planet bearing stands still against the carrier: so do its frequencies count."""
    size = (
        "elements: 17, element_diameter: 20 mm, pitch_diameter: 120 mm, contact_angle: 10 deg, stiffness: 1e9"
    )
    bearings = (
        f"rolling_bearings:\n  main: {{ends: [carrier, ground], {size}}}\n"
        f"  pin: {{ends: [carrier.seat, b0], {size}}}\n  turned: {{ends: [b0, carrier.seat], {size}}}"
    )
    text = grc(more=bearings)
    found = json_of(["frequencies", written(tmp_path, text)], capsys)
    geometry = {
        "elements": 17,
        "element_diameter": 0.02,
        "pitch_diameter": 0.12,
        "contact_angle": math.radians(10.0),
    }
    w_c = 22.09 * RPM
    w_p = w_c * 99 / 39  # against the carrier, with the ring held
    for name, inner, outer in (("main", w_c, 0.0), ("pin", 0.0, -w_p), ("turned", -w_p, 0.0)):
        row = found["rolling_bearings"][name]
        expected = vars(bearing_frequencies(**geometry, speed_inner=inner, speed_outer=outer))
        for key, value in expected.items():
            assert abs(row[key]) == pytest.approx(abs(value), rel=1e-9), (name, key)


def test_drives_count_at_the_end_of_a_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for drive in (
        "speed: {table: [[0 s, 0 rpm], [0.5 s, 740 rpm]]}",
        "speed: 740 rpm * t / (1 s)",
        'angle: "0.5 * 740 rpm * t^2 / (1 s)"',
        "speed: 740 rpm",
    ):
        text = SHOVEL.replace("speed: {motor: 740 rpm}", f"drive: {{motor: {{{drive}}}}}")
        found = json_of(["frequencies", written(tmp_path, text)], capsys)
        assert found["meshes"]["stage_1"]["frequency"] == pytest.approx(135.0 + 2.0 / 3.0, rel=1e-8), drive
        assert len(found["remarks"]) == (drive != "speed: 740 rpm")


def test_drives_need_not_fit_the_teeth(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Both ends driven, a tenth of a per cent apart: the first counts, as at the start of a run."""
    drives = f"drive: {{motor: {{speed: 740 rpm}}, output: {{speed: {740 / 136.56 * 1.001!r} rpm}}}}"
    text = SHOVEL.replace("speed: {motor: 740 rpm}", drives)
    found = json_of(["frequencies", written(tmp_path, text)], capsys)
    assert found["meshes"]["stage_3"]["frequency"] == pytest.approx(3.251271, abs=5e-7)


def test_people_get_tables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bearing = (
        "{ends: [sun, ground], elements: 8, element_diameter: 10 mm, pitch_diameter: 50 mm, stiffness: 1e9}"
    )
    file = written(tmp_path, grc(more=f"rolling_bearings:\n  front: {bearing}"))
    assert run_command(["frequencies", file]) == 0
    out = capsys.readouterr().out
    for words in ("shafts", "Meshes", "Contacts of one tooth", "Planet sets", "Rolling bearings", "BPFO"):
        assert words in out
    assert "36.4485 Hz" in out  # 99 * 22.09/60
    assert "at rest" in out


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--speed", "motor"], "not BODY=QUANTITY"),
        (["--speed", "motor=3 kg"], "motor:"),
        (["--speed", "moter=3 rpm"], "did you mean motor?"),
        (["--speed", "motor=3 rpm", "--speed", "output=3 rpm"], "does not fit the ratio"),
        (["--speed", "motor=0 rpm"], "nothing rotates"),
        (["--speed", "motor=3 rpm", "-s", "rated"], "replaces a scenario"),
        (["-s", "ratd"], "did you mean rated?"),
    ],
)
def test_what_cannot_be_is_said(
    options: list[str], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_command(["frequencies", written(tmp_path, SHOVEL), *options]) == 2
    captured = capsys.readouterr()
    assert words in captured.err
    assert captured.out == ""


def test_files_without_speeds_say_what_to_give(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = SHOVEL[: SHOVEL.index("scenarios")]
    assert run_command(["frequencies", written(tmp_path, text)]) == 2
    assert "or give --speed BODY=QUANTITY" in capsys.readouterr().err
    assert run_command(["frequencies", written(tmp_path, ISO_EX1)]) == 2
    assert "the file has no bodies" in capsys.readouterr().err


def test_speeds_that_do_not_follow_have_a_remark(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A Ravigneaux set requires two speeds, or a speed and a held member."""
    hold = "scenarios:\n  run: {hold: [carrier], speed: {small_sun: 1000 rpm}, duration: 1 ms}\n"
    file = written(tmp_path, ravigneaux(scenarios=hold))
    (remark,) = json_of(["frequencies", file, "--speed", "small_sun=1000rpm"], capsys)["remarks"]
    assert remark.startswith(
        "the speeds of large_sun, ring and carrier do not follow from those of small_sun"
    )
    for known in (["--speed", "small_sun=1000rpm", "--speed", "ring=0rpm"], ["-s", "run"]):
        assert json_of(["frequencies", file, *known], capsys)["remarks"] == []
    given = ["--speed", "carrier=60rpm", "--speed", "ring=0rpm"]
    sets = json_of(["frequencies", file, *given], capsys)["planet_sets"]
    assert {name: row["planet_pass"] for name, row in sets.items()} == pytest.approx(
        {"carrier, short": 3.0, "carrier, long": 3.0}
    )
