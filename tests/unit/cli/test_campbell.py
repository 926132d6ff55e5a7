# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint campbell`: tables, files and pictures of the geared rotor, refused options."""

from __future__ import annotations

import csv
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result
from pitchpoint.io.target import OutputError, check_target
from pitchpoint.report.figure_picture import check_picture, marked_png
from pitchpoint.report.write import write_report
from tests.support.browser import needs_browser
from tests.support.cli_files import json_of

MODEL = Path(__file__).parents[3] / "examples" / "geared-rotor" / "model.yaml"
RANGE = ["--body", "rotor", "--speeds", "300..7200rpm", "--points", "13", "--frequency", "0..250Hz"]
RPM = math.pi / 30.0


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Result file of the command."""
    target = tmp_path_factory.mktemp("campbell") / "rotor.h5"
    arguments = [*RANGE, "-s", "fast", "-o", str(target), "--plot", str(target.with_suffix(".html"))]
    assert (
        run_command(["campbell", str(MODEL), *arguments, "--table", str(target.with_suffix(".csv")), "-q"])
        == 0
    )
    return target


def test_critical_speeds_of_the_example(capsys: pytest.CaptureFixture[str]) -> None:
    """The rotor speed crosses the whirl modes at 4717 and 5854 rpm; 5854 rpm is 30 % above 4500 rpm."""
    rows = json_of(["campbell", str(MODEL), "-s", "fast", *RANGE, "--orders", "1x,mesh"], capsys)
    assert rows["body"] == "rotor"
    assert [row["name"] for row in rows["modes"]][1:] == [
        "1st bending of rotor (backward)",
        "1st bending of rotor (forward)",
        "torsion of rotor against drive",
    ]
    by_mode = {(c["mode"], c["order"]): c for c in rows["critical_speeds"]}
    forward = by_mode["1st bending of rotor (forward)", "1× rotor"]
    assert forward["speed"] / RPM == pytest.approx(5854.0, abs=1.0)
    assert forward["separation"] == pytest.approx(forward["speed"] / RPM / 4500.0 - 1.0, rel=1e-6)
    assert (forward["source"], forward["whirl"]) == ("unbalance", "forward")
    torsion = by_mode["torsion of rotor against drive", "mesh stage"]
    assert torsion["speed"] / RPM == pytest.approx(513.7, abs=1.0)
    assert torsion["source"] == "transmission error"


def test_files_hold_the_same(found: Path) -> None:
    with open_result(found) as data:
        assert data.attrs["kind"] == "campbell"
        assert data["frequency"].dims == ("speed", "mode")
        speeds = data["crossing_speed"].values
        assert data["strain_share"].sum("component").values[:, 1:] == pytest.approx(1.0)
    lines = found.with_suffix(".csv").read_text(encoding="utf-8").splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    assert [float(row["speed [rad/s]"]) for row in rows] == pytest.approx(speeds, rel=1e-8)
    assert "1st bending of rotor (forward)" in found.with_suffix(".html").read_text(encoding="utf-8")


def test_a_report_shows_a_given_diagram(found: Path, tmp_path: Path) -> None:
    page = write_report(MODEL, tmp_path / "page.html", str(found)).read_text(encoding="utf-8")
    assert "Critical speeds are ranked by" in page
    assert "torsion of rotor against drive" in page


def test_people_get_tables(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["campbell", str(MODEL), "-s", "fast", *RANGE, "--modes", "torsion"]) == 0
    out = capsys.readouterr().out
    assert "critical speeds" in out
    assert "ranked by the response of the machine at resonance" in out
    assert "torsion of rotor against drive" in out
    assert "1st bending" not in out


def test_machines_without_modes_have_a_table_without_rows(capsys: pytest.CaptureFixture[str]) -> None:
    crank = MODEL.parents[1] / "flexible-slider-crank" / "rigid.yaml"
    assert run_command(["campbell", str(crank), "-s", "driven", "--points", "2"]) == 0
    assert "critical speeds: none" in " ".join(capsys.readouterr().out.split())


def test_operating_speeds_are_in_the_diagram(capsys: pytest.CaptureFixture[str]) -> None:
    """The scenario stops at 4500 rpm: the critical speed at 5854 rpm is inside the operating range given."""
    given = ["-s", "fast", "--body", "rotor", "--operating", "5000..6500rpm", "--points", "13"]
    rows = json_of(["campbell", str(MODEL), *given, "--orders", "1x"], capsys)
    assert rows["speeds"][1] == pytest.approx(1.2 * 6500.0 * RPM)
    forward = next(c for c in rows["critical_speeds"] if c["order"] == "1× rotor" and c["whirl"] == "forward")
    assert forward["speed"] / RPM == pytest.approx(5854.0, abs=1.0)
    assert forward["separation"] == 0.0
    assert rows["notes"] == [] or "outside" not in " ".join(rows["notes"])
    apart = json_of(["campbell", str(MODEL), *given, "--speeds", "0..900rpm", "--orders", "1x"], capsys)
    assert "operating speeds 5000–6500 rpm are outside the computed speeds 0–900 rpm" in apart["notes"][-1]


@pytest.mark.parametrize(
    ("more", "word"),
    [
        (["--orders", "3q"], "3q"),
        (["--orders", "1x,0.5x"], "'0.5x' is not an order"),
        (["--speeds", "9..3 rpm"], "LOW..HIGH"),
        (["--speeds", "3000rpm"], "LOW..HIGH"),
        (["--operating", "0rpm"], "above 0"),
        (["--body", "nobody"], "nobody"),
        (["--modes", "banana"], "banana"),
        (["--plot", "plot.bmp"], ".svg"),
    ],
)
def test_what_is_refused(more: list[str], word: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["campbell", str(MODEL), *more]) == 2
    told = capsys.readouterr()
    assert word in told.err + told.out


@needs_browser
def test_pictures(tmp_path: Path) -> None:
    """In a process of its own: Playwright runs once per process."""
    subprocess.run([sys.executable, "-c", PICTURE, str(tmp_path)], check=True, timeout=120)
    for kind in ("svg", "png"):
        target = check_target(check_picture(tmp_path / f"plot.{kind}"), kind)  # its own file may be replaced
        head = target.read_bytes()[:4]
        assert head == (b"<svg" if kind == "svg" else b"\x89PNG")
        target.write_bytes(head + bytes(2000))
        with pytest.raises(OutputError):
            check_target(target, kind)


PICTURE = """
import sys
from pathlib import Path
from pitchpoint.report.figure_picture import write_picture
from pitchpoint.viz import theme
figure = theme.figure("x", "y")
figure.add_scatter(x=[0, 1], y=[0, 1])
for kind in ("svg", "png"):
    write_picture(Path(sys.argv[1]) / f"plot.{kind}", figure)
"""


def test_a_marked_png_is_a_png() -> None:
    made = marked_png(b"\x89PNG\r\n\x1a\n" + bytes(25) + b"rest")
    assert made[33:].startswith(np.uint32(19).byteswap().tobytes() + b"tEXtSoftware\x00pitchpoint")
    assert made.endswith(b"rest")
