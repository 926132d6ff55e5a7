# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint analyse` with wavelets and periods: FD-WAVELET on a file, and sentences for wrong input."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of

RATE, SAMPLES = 430.4, 6456
TIME = np.arange(SAMPLES) / RATE
TONES = {"fault": 0.29557, "slow": 3.251271, "middle": 20.098765, "fast": 135.666667}
SHARES = {
    "fault": {"a5": 99.7},
    "slow": {"a5": 99.5},
    "middle": {"d4": 88.4, "d3": 10.9},
    "fast": {"d1": 90.0, "d2": 9.9},
}
"""Percent of the energy of a cosine, from the case."""


def table(path: Path, columns: dict[str, np.ndarray]) -> str:
    """CSV file with a time axis."""
    head = ",".join(["time [s]", *(f"{name} [N]" for name in columns)])
    rows = np.column_stack((TIME[: len(next(iter(columns.values())))], *columns.values()))
    np.savetxt(path, rows, delimiter=",", header=head, comments="", fmt="%.9g")
    return str(path)


@pytest.fixture(scope="module")
def rig(tmp_path_factory: pytest.TempPathFactory) -> str:
    tones = {name: np.cos(2 * np.pi * f * TIME) for name, f in TONES.items()}
    return table(tmp_path_factory.mktemp("rig") / "shovel.csv", tones)


def refusal(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    assert run_command(["analyse", *arguments]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and "Traceback" not in captured.err
    return " ".join(captured.err.split())


def test_lengths_and_bands_of_five_levels(
    rig: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "levels.csv"
    arguments = ["analyse", rig, "wavelet_levels", "-c", "middle", "-O", "wavelet=db5", "-O", "levels=5"]
    found = json_of([*arguments, "--csv", str(out)], capsys)["variables"]
    assert found["level"]["values"] == ["a5", "d5", "d4", "d3", "d2", "d1"]
    assert found["coefficients"]["values"] == [210, 210, 411, 814, 1620, 3232]
    edges = [0.0, 6.725, 13.45, 26.9, 53.8, 107.6, 215.2]
    assert found["band"]["unit"] == "Hz"
    # nine digits in the file
    np.testing.assert_allclose(found["band"]["values"], np.column_stack((edges[:-1], edges[1:])), rtol=1e-7)
    parts = np.array(found["signals"]["values"])
    assert parts.shape == (6, SAMPLES) and found["signals"]["unit"] == "N"
    np.testing.assert_allclose(parts.sum(axis=0), np.cos(2 * np.pi * TONES["middle"] * TIME), atol=1e-8)
    # the table holds the parts of the signal, one row for each level and time
    lines = [line for line in out.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    assert lines[0].startswith("level,time [s],signals [N]") and len(lines) == 1 + 6 * SAMPLES
    assert run_command(arguments) == 0
    shown = capsys.readouterr().out
    assert "13.45 to 26.9 Hz, 411 coefficients" in shown and "107.6 to 215.2 Hz, 3232 coefficients" in shown


@pytest.mark.parametrize("tone", sorted(TONES))
def test_shares_of_the_tones(rig: str, tone: str, capsys: pytest.CaptureFixture[str]) -> None:
    """The shares of the case are those with periodic ends, to its one decimal."""
    assert run_command(["analyse", rig, "wavelet_levels", "-c", tone, "-O", "extension=periodization"]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines() if " % " in line]
    shown = {row[0]: float(row[1]) for row in rows}
    assert len(shown) == 6
    for level, share in SHARES[tone].items():
        assert shown[level] == pytest.approx(share, abs=0.051)


@pytest.mark.parametrize(
    "more, sentence",
    [
        (["wavelet_levels", "-O", "wavelet=bd5"], "wavelet: 'bd5' is unknown; did you mean db5?"),
        (["wavelet_levels", "-O", "wavelet=DB5"], "wavelet: 'DB5' is unknown; did you mean db5?"),
        (["wavelet_packets", "-O", "wavelet=coiff3"], "wavelet: 'coiff3' is unknown; did you mean coif3?"),
        (["wavelet_levels", "-O", "wavelet=5"], "option wavelet is 5 (limit a text)"),
        (["wavelet_levels", "-O", "levels=12"], "levels: 12 (limit 1 to 9 for 6456 samples and db5)"),
        (["wavelet_packets", "-O", "levels=0"], "levels: 0 (limit 1 to 9 for 6456 samples and db5)"),
        (["wavelet_levels", "-O", "levels=2.5"], "option levels is 2.5 (limit a whole number)"),
        (["wavelet_levels", "-O", "extension=symetric"], "did you mean symmetric?"),
        (["scalogram", "-O", "wavelet=cmor"], "lacks its numbers; write such as 'cmor1.5-1.0'"),
        (["scalogram", "-O", "wavelet=mexx"], "wavelet: 'mexx' is unknown; did you mean mexh?"),
        (
            ["scalogram", "-O", "frequencies=10,300"],
            "frequencies: 300 Hz (limit 0.0666667 to below 215.2 Hz)",
        ),
        (["find_period", "-O", "shortest=1"], "needs the option longest"),
        (["find_period", "-O", "shortest=1", "-O", "longest=9"], "limits 0 to 7.5 s"),
        (["wavelet_level"], "did you mean wavelet_levels"),
    ],
)
def test_wrong_input_gets_a_sentence(
    rig: str, more: list[str], sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert sentence in refusal([rig, *more, "-c", "slow"], capsys)


def test_short_records_and_missing_samples(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    short = table(tmp_path / "short.csv", {"force": np.arange(17.0)})
    shown = refusal([short, "wavelet_levels"], capsys)
    assert "has 17 samples (limit 18 for one level of db5); use a longer record" in shown
    assert run_command(["analyse", short, "wavelet_levels", "-O", "wavelet=haar", "-O", "levels=4"]) == 0
    capsys.readouterr()
    broken = np.cos(TIME)
    broken[100] = np.nan
    shown = refusal([table(tmp_path / "nan.csv", {"force": broken}), "wavelet_levels"], capsys)
    assert "force" in shown and "nan" in shown.lower()


def test_a_period_is_found_or_not(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A dip once in 3.3833 s beside a mesh, and the mesh alone; the step is 2.3 ms."""
    noise = 300.0 * np.random.default_rng(5).standard_normal(SAMPLES)
    mesh = 500.0 * np.sin(2 * np.pi * TONES["slow"] * TIME) + noise
    dip = -2500.0 * (np.mod(TIME, 3.3833) < 0.1)
    rig = table(tmp_path / "rig.csv", {"bad": mesh + dip, "good": mesh})
    search = ["-O", "shortest=1", "-O", "longest=6", "-O", "known=3.251271"]
    html = tmp_path / "a.html"
    found = json_of(["analyse", rig, "find_period", "-c", "bad", *search, "--html", str(html)], capsys)
    values = {name: v["values"] for name, v in found["variables"].items()}
    assert values["found"] is True and values["turns"] == 4
    assert values["period"] == pytest.approx(3.3833, abs=2.3e-3)
    assert "approximate score" in html.read_text(encoding="utf-8")
    assert run_command(["analyse", rig, "find_period", "-c", "good", *search]) == 0
    assert "nothing found" in capsys.readouterr().out
    assert run_command(["analyse", rig, "period_evidence", "-c", "bad", "-O", "periods=3.3833,12"]) == 0
    shown = capsys.readouterr().out
    assert "4 turns, 20 lines" in shown and "not known" in shown


def test_tones_are_told_with_their_frequencies(rig: str, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["analyse", rig, "tones", "-c", "middle", "-O", "expected=20,22", "-O", "reach=1"]
    assert run_command(arguments) == 0
    first, second = (line for line in capsys.readouterr().out.splitlines() if "near" in line)
    assert "near 20 Hz" in first and "20.0988 Hz" in first and "1 N" in first
    # 2 Hz beside the tone the spectrum of a sine only falls
    assert "near 22 Hz" in second and second.rstrip().endswith("no peak")


def test_noise_is_written_as_a_record(rig: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = str(tmp_path / "noisy.csv")
    arguments = ["white_noise", "-c", "middle", "-O", "signal_to_noise=0", "-O", "seed=1"]
    assert run_command(["analyse", rig, *arguments, "--csv", out]) == 0
    capsys.readouterr()
    found = json_of(["analyse", out, "signal_statistics", "-c", "values"], capsys)
    # half the power is signal, half noise; 6456 samples scatter by 1 %
    assert found["variables"]["rms"]["values"] == pytest.approx(1.0, rel=0.03)
    assert found["variables"]["rms"]["unit"] == "N"


@pytest.mark.study
def test_maps_are_thinned_as_json_and_whole_in_a_file(
    rig: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """6456 samples by some fifty frequencies: 300 000 values, 6 MB as text."""
    whole = tmp_path / "map.csv"
    command = ["analyse", rig, "scalogram", "-c", "middle"]
    found = json_of([*command, "--csv", str(whole)], capsys)
    times = found["variables"]["time"]["values"]
    amplitude = np.array(found["variables"]["amplitude"]["values"])
    assert amplitude.shape == (len(found["variables"]["frequency"]["values"]), len(times))
    assert 30_000 < amplitude.size <= 110_000
    (note,) = [n for n in found["notes"] if "values of time" in n]
    step = int(note.split("every ")[1].split("th")[0])
    np.testing.assert_allclose(times, TIME[::step], rtol=0, atol=1e-6)
    rows = sum(1 for line in whole.read_text(encoding="utf-8").splitlines() if line[:1] != "#") - 1
    assert rows == amplitude.shape[0] * SAMPLES


def test_a_period_that_cannot_be_judged_is_told_in_words(
    rig: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_command(["analyse", rig, "period_evidence", "-c", "slow", "-O", "periods=15,1"]) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "nan" not in told
    assert "probability in noise of 15 s not known 1 turn, 0 lines: too few for a test" in told
    # lines beside no sideband: a table of numbers, with none of round-off
    assert run_command(
        ["analyse", rig, "sideband_table", "-c", "fast", "-O", "mesh=135.6667", "-O", "spacing=20",
         "-O", "harmonics=1"]
    ) == 0  # fmt: skip
    told = " ".join(capsys.readouterr().out.split())
    assert "maximum asymmetry not known" in told
