# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose -o PAGE`: the answer, what it rests on, and pictures, from all kinds of records."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of, written
from tests.support.measured_sets import motor_records
from tests.support.rig_records import BROKEN_PAIR, rig_file

TRAIN = ["--train", "32/95", "--speed", "10Hz"]


def page_of(arguments: list[str], folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[str, str]:
    """Page and printed text of the command."""
    target = folder / "page.html"
    assert run_command(["diagnose", *arguments, "-o", str(target)]) == 0, capsys.readouterr().err
    return html.unescape(target.read_text(encoding="utf-8")), capsys.readouterr().out


def figures(page: str) -> list[dict]:
    """Every figure of a page."""
    return [
        json.loads(text)
        for text in re.findall(r'<script type="application/json">(.*?)</script>', page, re.DOTALL)
    ]


def captions(page: str) -> str:
    return " ".join(re.findall(r"<figcaption>(.*?)</figcaption>", page))


def test_the_page_of_a_measured_file_names_gear_tooth_and_chance(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The knock is in the middle of 0.2 turns, 6.4 pitches of 32: a window of one tooth about it is told."""
    page, printed = page_of([rig_file(tmp_path), *TRAIN], tmp_path, capsys)
    assert "A local fault on gear Z1 (shaft 1, 9.9999 Hz)" in page
    assert "by noise alone: less than 0.001 %, over all 7 tests" in page
    tooth = re.search(
        r"the tooth of 32 that meshes ([\d.]+) pitches \(\d+°\) after the start of the record", page
    )
    assert tooth and abs(float(tooth[1]) - 6.4) < 0.5
    assert tooth[0] in printed and "FM4" in printed and "M6A" in printed
    for words in (
        "train of gears 32/95",
        "--speed 10Hz ±2 %, refined by the mesh lines",
        "5000 Hz",
        "10000 samples",
    ):
        assert words in page
    assert "Mean of 19 turns of shaft 1, over the teeth of Z1" in captions(page)
    assert "nothing found" not in page and "Detection limits" not in page


def test_figures_have_axes_with_units_and_marked_lines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bearing = ["--bearing", "left:9,7.94mm,39.04mm,0deg@1"]  # 9/2 (1 - 7.94/39.04) 10 Hz = 35.85 Hz
    page, _ = page_of([rig_file(tmp_path), *TRAIN, *bearing], tmp_path, capsys)
    drawn = figures(page)
    titles = [(f["layout"]["xaxis"]["title"]["text"], f["layout"]["yaxis"]["title"]["text"]) for f in drawn]
    spectrum = ("frequency [Hz]", "amplitude [m/s²]")
    assert titles[0] == spectrum and titles[-1] == ("frequency [Hz]", "squared envelope [(m/s²)²]")
    assert ("tooth pitches from the start of the record", "[m/s²]") in titles
    names = [trace["name"] for trace in drawn[0]["data"]]
    assert names == ["spectrum", "mesh 1, 320 Hz"]
    shown = {trace["hovertemplate"].partition("<extra>")[2]: trace for trace in drawn[-1]["data"][1:]}
    assert shown["left, outer ring, 35.85 Hz</extra>"]["marker"]["symbol"] == "circle-open"
    assert [trace["name"] for trace in shown.values() if trace.get("showlegend")] == ["left"]
    sidebands = next(
        f for f in drawn if any("+1" == note["text"] for note in f["layout"].get("annotations", ()))
    )
    assert {note["text"] for note in sidebands["layout"]["annotations"]} >= {"−2", "−1", "+1", "+2"}
    turn = drawn[titles.index(("tooth pitches from the start of the record", "[m/s²]"))]
    assert [shape["yref"] for shape in turn["layout"]["shapes"]] == ["y domain", "y2 domain"]
    assert all(shape["x0"] < 6.4 < shape["x1"] for shape in turn["layout"]["shapes"])


def bearing_file(folder: Path) -> list[str]:
    """Impacts of an outer ring, 3.05 per revolution at 25 Hz with random slip, in noise of their rms."""
    rate, rng = 12_000.0, np.random.default_rng(1)
    x = 0.4 * rng.standard_normal(60_000)
    for when in rate * np.cumsum(rng.normal(1 / 76.25, 1e-4, 380)):
        x[int(when) : int(when) + 100] += 4 * np.exp(-np.arange(100) / 20) * np.sin(1.5 * np.arange(100))
    savemat(folder / "fan.mat", {"acc": x, "fs": rate})
    machine = ["--speed", "25Hz±0.1%", "--bearing", "bearing A:BPFO=3.05,BPFI=4.95,BSF=1.99,FTF=0.382"]
    return [str(folder / "fan.mat"), *machine]


def motor_file(_: Path) -> list[str]:
    """Inner ring with 0.014 in at 2 hp, in the sensor of the other end, found by median whitening."""
    files = [one.file for one in motor_records() if one.file.name == "IR014_2.mat"]
    if not files:
        pytest.skip("the measured records are not beside the project")
    bearing = ["--bearing", "DE:6205-2RS JEM"]
    return [str(files[0]), "--sample-rate", "12kHz", "-c", "X171_FE_time", *bearing]


@pytest.mark.parametrize(
    ("arguments", "named", "detector", "limit"),
    [
        (bearing_file, "outer ring of bearing A", "cepstral whitening", 15.0),
        (motor_file, "inner ring of bearing DE", "spectral coherence", 27.0),
    ],
)
def test_the_envelope_is_that_of_the_detector_of_the_verdict(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: Callable[[Path], list[str]],
    named: str,
    detector: str,
    limit: float,
) -> None:
    """The numbered lines of the part named are above the limit of the detector, as in table and sentence."""
    page, printed = page_of(arguments(tmp_path), tmp_path, capsys)
    assert f"a local fault on the {named}, seen in" in printed
    assert f"by {detector}" in printed.splitlines()[0]
    row = next(line for line in printed.splitlines() if line.rstrip().endswith("found"))
    assert f"ring, by {detector}" in row and f"{limit:.1f} dB" in row
    assert f"by {detector}, level above the running median" in captions(page)
    (figure,) = [f for f in figures(page) if "median [dB]" in f["layout"]["yaxis"]["title"]["text"]]
    assert [note["text"] for note in figure["layout"]["annotations"]] == [f"limit {limit:g} dB"]
    (part,) = [trace for trace in figure["data"] if trace.get("text")]
    assert part["text"] == ["1", "2", "3"]
    first, second, third = part["x"]
    assert second == pytest.approx(2 * first) and third == pytest.approx(3 * first)
    # one of the lines may be 4 dB lower
    assert sorted(part["y"])[1] >= limit and min(part["y"]) >= limit - 4.0


def test_a_healthy_record_has_the_same_pictures_and_says_what_would_be_found(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page, printed = page_of([rig_file(tmp_path, 0.0), *TRAIN], tmp_path, capsys)
    assert "Nothing found: none of 7 tests exceeds its limit" in page and "nothing found" in printed
    assert "does not prove that the machine is healthy" in page
    assert "Detection limits" in page and "line at the limit" in page
    assert "FM4" not in printed
    assert "Not tested:" in page and "no test of the lowest orders of shaft 2" in page
    words = captions(page)
    assert "Spectrum of acc" in words and "Mean of" in words and "shaded" not in words


def test_the_page_needs_no_network(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page, _ = page_of([rig_file(tmp_path), *TRAIN], tmp_path, capsys)
    assert "Content-Security-Policy\" content=\"default-src 'none'" in page
    assert not re.search(r"<(script|link|img|iframe)[^>]+(src|href)=", page)
    assert page.count("* plotly.js (") == 1, "the script of the plots stands in the page once"


@pytest.mark.parametrize(("severity", "found"), [("1", True), ("0", False)])
def test_the_page_of_a_result(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], severity: str, found: bool
) -> None:
    model = written(tmp_path, BROKEN_PAIR.replace("severity: 1", f"severity: {severity}"))
    result = str(tmp_path / "run.h5")
    assert run_command(["run", model, "-o", result, "-q"]) == 0
    capsys.readouterr()
    page, printed = page_of([result], tmp_path, capsys)
    assert ("A local fault on gear pinion" in page) == found
    assert ("Nothing found" in page) != found
    assert "model stored in the file" in page and "less the first 0.2 s (settle_time" in page
    assert "white noise 20 dB below the signal was added" in page and "angle channel angle[shaft]" in page
    if found:
        # the pinion turns counter-clockwise and its mate lies on the x axis, as tooth 0 at angle zero does:
        # tooth 12 of 21 comes there after 9 pitches, and touches for less than one before and after it
        words = r"the tooth of 21 that meshes ([\d.]+) pitches \(\d+°\) after the zero of angle\[shaft\]"
        tooth = re.search(words, page)
        assert tooth and abs(float(tooth[1]) - 9.0) < 1.0
        assert "FM4" in printed


def test_json_tells_the_mean_turn_of_a_local_fault(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = json_of(["diagnose", rig_file(tmp_path), *TRAIN, "-o", str(tmp_path / "page.html")], capsys)
    (finding,) = found["findings"]
    (turn,) = finding["mean_turn"]
    assert turn["teeth"] == 32 and abs(turn["tooth"] - 6.4) < 0.5 and turn["averages"] in (19, 20)
    assert turn["tooth"] == pytest.approx(turn["angle"] / (2 * np.pi) * 32)
    fm4 = turn["indicators"]["fm4"]
    assert fm4["value"] > fm4["limit_1_percent"] > fm4["gaussian"] == 3.0
    assert turn["tooth_energy"]["share"] > 5 * turn["tooth_energy"]["evenly_spread"]
    assert (tmp_path / "page.html").exists()


def test_a_tooth_counts_from_the_first_pulse_of_a_tacho(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """One pulse in a turn, 0.1 turns after the start: the knock at 0.2 turns is 3.2 pitches after it."""
    time = np.arange(10_000) / 5000.0
    turned = 10.0 * time
    knock = np.exp(-((((turned + 0.3) % 1 - 0.5) / 0.01) ** 2)) * np.cos(2 * np.pi * 140 * turned)
    noise = 0.4 * np.random.default_rng(3).standard_normal(time.size)
    x = np.cos(2 * np.pi * 32 * turned) + noise + 2.0 * knock
    pulses = 5.0 * (np.mod(turned - 0.1, 1.0) < 0.2)
    file = tmp_path / "tacho.csv"
    head = "time [s],acc [m/s^2],pulses"
    np.savetxt(file, np.c_[time, x, pulses], delimiter=",", header=head, comments="", fmt="%.7g")
    options = ["--train", "32/95", "--tacho", "pulses", "--pulses", "1"]
    page, _ = page_of([str(file), *options], tmp_path, capsys)
    tooth = re.search(
        r"the tooth of 32 that meshes ([\d.]+) pitches \(\d+°\) after the first pulse of pulses", page
    )
    assert tooth and abs(float(tooth[1]) - 3.2) < 0.5
    assert "tacho pulses, 1 pulses per turn" in page


@pytest.mark.parametrize(
    ("target", "words"),
    [
        ("page.pdf", "is not an HTML page"),
        ("page", "is not an HTML page"),
        ("rig.csv/page.html", "cannot be written"),
        ("notes.html", "exists and is not an HTML page of pitchpoint"),
    ],
)
def test_a_page_that_cannot_be_written_is_refused_before_the_work(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    target: str,
    words: str,
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise AssertionError("read before the output was looked at")

    file = rig_file(tmp_path)
    (tmp_path / "notes.html").write_text("my notes")
    monkeypatch.setattr("pitchpoint.report.diagnosis.record.read_record", fail)
    assert run_command(["diagnose", file, *TRAIN, "-o", str(tmp_path / target)]) == 2
    captured = capsys.readouterr()
    assert words in captured.err and captured.out == ""
    assert (tmp_path / "notes.html").read_text() == "my notes"
