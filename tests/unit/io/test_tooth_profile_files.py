# SPDX-License-Identifier: Apache-2.0
"""Files with the points of a tooth: what is read, how it is written back, and what is refused where."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.geometry import CylindricalGear
from pitchpoint.geometry.modifications import flank_range
from pitchpoint.geometry.tooth_form import tooth_form, tooth_profile
from pitchpoint.io.gear_export import points_csv
from pitchpoint.io.yaml_model import dump_model, load_model, loads_model
from pitchpoint.model.components.tooth_profile import Points, ToothProfile
from tests.support.model_files import gear

REAL = CylindricalGear(z=30, m_n=3e-3, b=20e-3)
ROLL = np.linspace(*flank_range(REAL), 40)
HEAD = "x [mm],y [mm]"


def tooth_lines(other: CylindricalGear = REAL, unit: float = 1e3) -> list[str]:
    """Points of one tooth of 20 points a flank as lines of a file."""
    return [f"{unit * x:.12g},{unit * y:.12g}" for x, y in tooth_profile(other, 20).points]


def model_file(folder: Path, lines: list[str], keys: str = "tooth: real.csv") -> Path:
    (folder / "real.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    file = folder / "model.yaml"
    file.write_text("gears:\n" + gear("a", more=f"tooth_profile: {{{keys}}}"), encoding="utf-8")
    return file


def off(file: Path, flank: str = "left") -> float:
    """Largest distance of a flank from the nominal involute."""
    found = load_model(file).gears["a"].geometry
    assert found.outline is not None
    return float(np.abs(found.outline.gap(found, flank, ROLL)).max())


def flank_lines(turn: float, side: float, below: bool = False) -> list[str]:
    """Involute of the left (side 1) or right (-1) flank, turned into the tooth; with the fillet below it."""
    r, half, n = tooth_form(REAL).flank(60)
    n = 0 if below else n
    points = 1e3 * r[n:] * np.exp(1j * side * (half[n:] - turn))
    return [HEAD, *(f"{p.real:.9f},{p.imag:.9f}" for p in points)]


def test_units_separators_comments_and_order_do_not_matter(tmp_path: Path) -> None:
    mm, metres = tooth_lines(), tooth_lines(unit=1.0)
    plain = [HEAD, *mm]
    variants = [
        plain,
        [HEAD, *mm[::-1]],
        ["# measured on Monday", "", "\tX [m] ; y [m]", *(m.replace(",", " ; ") for m in metres)],
        ["y [mm],no,x [mm]", *(f"{p.split(',')[1]},7,{p.split(',')[0]}" for p in mm)],
        [HEAD, *mm, ",".join(closing(mm[0]))],
    ]
    for lines in variants:
        assert off(model_file(tmp_path, lines)) < 1e-11
        assert off(tmp_path / "model.yaml", "right") < 1e-11


def closing(line: str) -> list[str]:
    x, y = (float(v) for v in line.split(","))
    turned = complex(x, y) * np.exp(2j * math.pi / 30)
    return [f"{turned.real:.12g}", f"{turned.imag:.12g}"]


def test_any_tooth_of_an_export_and_any_direction(tmp_path: Path) -> None:
    lines = points_csv(REAL, 20).splitlines()
    assert off(model_file(tmp_path, lines)) < 1e-11
    assert off(model_file(tmp_path, lines, "tooth: real.csv, number: 17")) < 1e-11
    up = [HEAD, *(",".join((f"{-float(y)}", x)) for x, y in (p.split(",") for p in tooth_lines()))]
    assert off(model_file(tmp_path, up, "tooth: real.csv, angle: 90 deg")) < 1e-11


@pytest.mark.parametrize(
    ("keys", "sides", "expected"),
    [
        ("both: real.csv", (1.0,), (1.0, 1.0)),
        ("both: real.csv", (-1.0,), (1.0, 1.0)),
        ("left: real.csv", (1.0,), (1.0, 0.0)),
        ("right: real.csv", (-1.0,), (0.0, 1.0)),
        ("left: real.csv, right: other.csv", (1.0, -1.0), (1.0, 2.0)),
    ],
)
def test_single_flanks(
    keys: str, sides: tuple[float, ...], expected: tuple[float, float], tmp_path: Path
) -> None:
    """Flanks turned by 0.1 mrad, 0.2 mrad in the second file: the gap is r_b times the turn."""
    (tmp_path / "other.csv").write_text("\n".join(flank_lines(2e-4, sides[-1])))
    found = load_model(model_file(tmp_path, flank_lines(1e-4, sides[0]), keys)).gears["a"].geometry
    assert found.outline is not None
    for flank, turn in zip(("left", "right"), expected, strict=True):
        gap = found.outline.gap(found, flank, ROLL)
        assert gap == pytest.approx(np.full(40, 1e-4 * turn * found.r_b), abs=1e-11)
    thinner = tooth_form(REAL).z * 1e-4 * sum(expected) * (0.5 * REAL.d) * 2.25 * REAL.m_n
    area = found.outline.section(30)[0]
    from pitchpoint.geometry.mass_properties import section_integrals

    assert section_integrals(tooth_form(REAL))[0] - area == pytest.approx(thinner, rel=0.1)


def test_round_trip_holds_the_points(tmp_path: Path) -> None:
    model = load_model(model_file(tmp_path, points_csv(REAL, 10).splitlines(), "tooth: real.csv, number: 4"))
    again = loads_model(dump_model(model))
    assert again == model
    assert pickle.loads(pickle.dumps(model)) == model
    assert again.gears["a"].geometry == model.gears["a"].geometry


def changed(line: int, text: str) -> list[str]:
    """A good file with one line (from 1) replaced."""
    lines = [HEAD, *tooth_lines()]
    lines[line - 1] = text
    return lines


def swapped(first: int, second: int) -> list[str]:
    """A good file with two lines (from 1) exchanged."""
    lines = [HEAD, *tooth_lines()]
    lines[first - 1], lines[second - 1] = lines[second - 1], lines[first - 1]
    return lines


GOOD = [HEAD, *tooth_lines()]
WHEEL = points_csv(REAL, 20).splitlines()
TOOTH = (len(WHEEL) - 1) // 30


def back(lines: list[str], line: int, count: int = 8) -> list[str]:
    """Lines of a file that run back by a number of points after a line (from 1), then go on."""
    return [*lines[:line], *lines[line - 1 - count : line - 1][::-1], *lines[line:]]


def early(lines: list[str], line: int, count: int) -> list[str]:
    """Lines of a file with one line (from 1) put some places earlier."""
    at = line - 1
    return [*lines[: at - count], lines[at], *lines[at - count : at], *lines[at + 1 :]]


# (lines of the file, keys, words that the sentence must hold)
BAD: dict[str, tuple[list[str], str, list[str]]] = {
    "no heading": (tooth_lines(), "tooth: real.csv", ["has no header line", "line 1", "x [mm],y [mm]"]),
    "heading without units": (["x,y", *tooth_lines()], "tooth: real.csv", ["has no header line"]),
    "unit of angle": (
        ["x [deg],y [mm]", *tooth_lines()],
        "tooth: real.csv",
        ["'deg'", "not a unit of length"],
    ),
    "two columns x": (["x [mm],x [mm]", *tooth_lines()], "tooth: real.csv", ["two columns x"]),
    "NaN": (changed(9, "nan,1"), "tooth: real.csv", ["line 9", "'nan,1'", "finite numbers"]),
    "words": (changed(9, "12 mm,1"), "tooth: real.csv", ["line 9", "'12 mm,1'"]),
    "missing value": (changed(9, "12"), "tooth: real.csv", ["line 9", "is not a point"]),
    "empty": ([], "tooth: real.csv", ["has no header line"]),
    "heading only": ([HEAD], "tooth: real.csv", ["0 points are too few", "10 to 2000"]),
    "few points": (GOOD[:8], "tooth: real.csv", ["7 points are too few", "10 to 2000"]),
    "half a tooth": (GOOD[:24], "tooth: real.csv", ["same side of the x axis", "line 2"]),
    "not closed": (GOOD[:-12], "tooth: real.csv", ["not closed", "line 40", "0.6 mm", "0.2 m_n"]),
    "wrong unit": (
        ["x [m],y [m]", *tooth_lines()],
        "tooth: real.csv",
        ["96000 mm", "tip diameter of another gear", "96 mm and 1.2 mm next to it", "check the unit"],
    ),
    "another number of teeth": (
        [HEAD, *tooth_lines(CylindricalGear(z=31, m_n=3e-3))],
        "tooth: real.csv",
        ["tip diameter of another gear", "99 mm"],
    ),
    "another profile shift": (
        [
            HEAD,
            *tooth_lines(CylindricalGear(z=30, m_n=3e-3, x=0.8, tip_diameter=96e-3, root_diameter=82.5e-3)),
        ],
        "tooth: real.csv",
        ["off the nominal involute", "0.6 mm, 0.2 m_n", "line "],
    ),
    "points out of order": (
        swapped(14, 17),
        "tooth: real.csv",
        ["reverses", "line 15", " mm is", "limit > 0 mm"],
    ),
    "back along fillet and root": (
        back(GOOD, 48),
        "tooth: real.csv",
        ["180 deg turn", "runs back", "line 49)", "limit 150 deg", "in order"],
    ),
    "root point in the fillet": (
        early(GOOD, 50, 2),
        "tooth: real.csv",
        ["deg turn", "runs back", "limit 150 deg"],
    ),
    "back along the root below a flank": (
        back(flank_lines(0.0, 1.0, below=True), 14),
        "left: real.csv",
        ["180 deg turn", "line 15)", "limit 150 deg"],
    ),
    "back along another tooth": (
        back(WHEEL, 5 * TOOTH + 20),
        "tooth: real.csv",
        ["180 deg turn", "in tooth 5", f"line {5 * TOOTH + 21})", "limit 150 deg"],
    ),
    "point of another tooth too early": (
        early(WHEEL, 6 * TOOTH + 27, 60),
        "tooth: real.csv",
        ["crosses itself after this point in tooth 6", "line "],
    ),
    "two points of the root exchanged": (swapped(3, 6), "tooth: real.csv", ["runs back", "line 4)"]),
    "wrong flank": (flank_lines(0.0, -1.0), "left: real.csv", ["other side of the tooth", "y > 0"]),
    "short flank": (
        flank_lines(0.0, 1.0)[:30],
        "left: real.csv",
        ["ends before the tip form diameter 96 mm", "% of the roll", "limit 10 %"],
    ),
    "nothing": (GOOD, "", ["gives no points"]),
    "too much": (GOOD, "tooth: real.csv, both: real.csv", ["gives tooth and both together"]),
    "absent tooth": (
        points_csv(REAL, 10).splitlines(),
        "tooth: real.csv, number: 30",
        ["tooth 30", "limit 0 to 29"],
    ),
    "absent file": (GOOD, "tooth: none.csv", ["there is no file 'none.csv'"]),
}


@pytest.mark.parametrize("name", list(BAD))
def test_bad_files_are_refused_with_the_place(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines, keys, words = BAD[name]
    file = model_file(tmp_path, lines, keys)
    with pytest.raises(ModelError) as caught:
        load_model(file)
    (problem,) = caught.value.problems
    assert problem.where.startswith("gears.a.tooth_profile")
    assert problem.line == 2
    assert problem.remedy
    for word in words:
        assert word in str(problem)
    assert run_command(["check", str(file)]) == 2
    assert "Traceback" not in capsys.readouterr().err


def test_every_bad_line_is_named_up_to_five(tmp_path: Path) -> None:
    lines = [HEAD, *tooth_lines()]
    for n in range(3, 12):
        lines[n - 1] = "inf,0"
    with pytest.raises(ModelError) as caught:
        load_model(model_file(tmp_path, lines))
    texts = [str(p) for p in caught.value.problems]
    assert len(texts) == 6
    assert "line 7)" in texts[4]
    assert "4 more such lines" in texts[5]


def test_mass_of_the_bore_is_that_of_the_real_root(tmp_path: Path) -> None:
    """A bore beyond the root circle of the file is refused although the nominal root would stand it."""
    deep = CylindricalGear(z=30, m_n=3e-3, b=20e-3, root_diameter=80.5e-3)
    file = model_file(tmp_path, [HEAD, *tooth_lines(deep)])
    body = "bodies:\n  shaft: {gears: [a], motion: torsion}\n"
    text = file.read_text().replace("face_width", "bore_diameter: 81 mm, face_width") + body
    file.write_text(text)
    with pytest.raises(
        ModelError, match=r"81 mm does not fit the gear \(limit 0 to the root diameter 80\.5 mm"
    ):
        load_model(file)


def test_profiles_made_in_python_pass_the_same_checks(tmp_path: Path) -> None:
    model = load_model(model_file(tmp_path, [HEAD, *tooth_lines()]))
    xy = tuple((float(x), float(y)) for x, y in tooth_profile(REAL, 20).points)
    again = model.replace("gears.a.tooth_profile", ToothProfile(tooth=Points(xy)))
    assert again.gears["a"].geometry.outline is not None
    same = model.replace("gears.a.tooth_profile", {"tooth": [list(p) for p in xy]})
    assert same == again
    plain = model.replace("gears.a.tooth_profile", None)
    assert plain.gears["a"].geometry.outline is None
    turned = model.replace("gears.a.tooth_profile.angle", 2e-4)
    found = turned.gears["a"].geometry
    assert found.outline is not None
    assert found.outline.gap(found, "left", ROLL) == pytest.approx(np.full(40, 2e-4 * found.r_b), abs=1e-11)
    # a list of points is read as in a file
    assert model.replace("gears.a.tooth_profile", ToothProfile(tooth=xy)) == again  # type: ignore[arg-type]
    for wrong, words in (
        (ToothProfile(tooth=Points(((math.nan, 1.0), *xy))), r"tooth_profile\.tooth"),
        (ToothProfile(tooth=Points(xy[:20])), r"tooth_profile\.tooth"),
        (ToothProfile(tooth=xy[:20]), r"tooth_profile\.tooth"),  # type: ignore[arg-type]
    ):
        with pytest.raises(ModelError, match=words):
            model.replace("gears.a.tooth_profile", wrong)
