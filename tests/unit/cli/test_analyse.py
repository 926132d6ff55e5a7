# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint analyse` on measured files and on results: tables, JSON, CSV, HTML, and sentences."""

from __future__ import annotations

import json

import numpy as np
import pytest

from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.tools import TOOLS
from pitchpoint.cli.analyse import value_of
from pitchpoint.cli.main import run_command
from tests.support import measured_files as files
from tests.support.cli_files import TORSION, json_of, written


@pytest.fixture
def rig(tmp_path):
    path = tmp_path / "rig.csv"
    path.write_text(files.csv_text(), encoding="utf-8")
    return str(path)


def refusal(arguments, capsys):
    assert run_command(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and "Traceback" not in captured.err
    return captured.err


def test_tools_are_listed_in_the_help_and_without_a_file(capsys):
    assert run_command(["analyse", "--help"]) == 0
    shown = capsys.readouterr().out
    assert all(f"  {name} " in shown for name in TOOLS)
    assert run_command(["analyse"]) == 0
    listed = capsys.readouterr().out
    assert all(name in listed for name in TOOLS) and "highest_order, revolutions" in listed
    assert set(json_of(["analyse"], capsys)) == set(TOOLS)


def test_channels_of_a_file_are_listed(rig, capsys):
    assert run_command(["analyse", rig]) == 0
    shown = capsys.readouterr().out
    assert "CSV, 64 samples at 1000 Hz" in shown and "rad/s" in shown
    found = json_of(["analyse", rig], capsys)
    assert found["channels"]["force"]["mean"] == pytest.approx(5000.0) and found["samples"] == 64


def test_spectrum_of_a_measured_file(rig, capsys):
    assert run_command(["analyse", rig, "amplitude_spectrum", "-c", "force"]) == 0
    shown = capsys.readouterr().out
    assert "amplitude_spectrum of force" in shown and "125 Hz" in shown and "2000 N" in shown
    found = json_of(
        ["analyse", rig, "amplitude_spectrum", "-c", "force", "-O", "window_name=flattop"], capsys
    )
    expected = amplitude_spectrum(1000.0 * files.FORCE, 1000.0, window_name="flattop")
    np.testing.assert_allclose(
        found["variables"]["amplitude"]["values"], expected.amplitude, rtol=1e-9, atol=1e-9
    )
    assert (
        found["variables"]["frequency"]["unit"] == "Hz" and found["options"] == '{"window_name": "flattop"}'
    )


def test_lost_harmonics_of_a_mesh_are_named(rig, capsys):
    arguments = ["analyse", rig, "amplitude_spectrum", "-c", "force", "--mesh-frequency"]
    found = json_of([*arguments, "0.2 kHz"], capsys)
    assert "lost are harmonic 3 of the mesh frequency (200 Hz); sample with 1536 Hz" in found["notes"][-1]
    assert json_of([*arguments, "100"], capsys)["notes"] == []
    assert "expected a frequency" in refusal([*arguments, "5 m"], capsys)


@pytest.mark.parametrize("tool", ["amplitude_spectrum", "power_spectral_density", "time_frequency_map"])
def test_tables_and_pages_are_written(rig, tmp_path, tool, capsys):
    table, html = tmp_path / "out.csv", tmp_path / "out.html"
    arguments = ["analyse", rig, tool, "-c", "force", "--csv", str(table), "--html", str(html)]
    for _ in range(2):  # the second time it replaces its own files
        assert run_command(arguments) == 0
    lines = table.read_text(encoding="utf-8").splitlines()
    assert lines[0] == "# pitchpoint analysis" and f"# tool: {tool}" in lines
    assert any(line.startswith("# sha256: ") for line in lines)
    head = next(line for line in lines if not line.startswith("#"))
    assert "frequency [Hz]" in head
    values = np.array([line.split(",") for line in lines[lines.index(head) + 1 :]], dtype=float)
    assert values.shape[1] == len(head.split(",")) and np.all(np.isfinite(values))
    page = html.read_text(encoding="utf-8")
    assert "rig.csv" in page and page.count('<div class="plot"') == 2
    table.write_text("my own numbers", encoding="utf-8")
    capsys.readouterr()
    assert "exists and is not a table of an analysis" in refusal(arguments, capsys)


def test_orders_of_a_simulated_run(tmp_path, capsys):
    result = tmp_path / "run.h5"
    model = written(tmp_path, TORSION)
    assert run_command(["run", model, "-s", "steady", "-o", str(result), "-q"]) == 0
    capsys.readouterr()
    arguments = ["analyse", str(result), "tracked_spectrum", "-c", "mesh_force[stage]", "--angle"]
    html = tmp_path / "a.html"
    found = json_of([*arguments, "angle[driver]", "-O", "highest_order=120", "--html", str(html)], capsys)
    amplitude, order = (np.array(found["variables"][n]["values"]) for n in ("amplitude", "order"))
    top = 2 + int(np.argmax(amplitude[2:]))
    assert order[top] % 50.0 == 0.0  # 50 teeth, whole revolutions: a harmonic of the mesh falls on a line
    assert found["model_hash"] and found["variables"]["amplitude"]["unit"] == "N"
    assert "order" in html.read_text(encoding="utf-8")
    assert run_command([*arguments, "angle[driver]", "-O", "highest_order=120"]) == 0
    assert "peak 1" in capsys.readouterr().out


def test_orders_by_a_tacho(tmp_path, capsys):
    time = np.arange(20_000) / 5000.0
    turned = 2 * np.pi * (10.0 * time + 2.0 * time**2)
    pulses = 5.0 * (np.mod(turned, 2 * np.pi) < 0.5)
    path = tmp_path / "run.csv"
    table = np.column_stack((pulses, 3.0 * np.cos(21 * turned)))
    np.savetxt(path, table, delimiter=";", header="tacho [V];acc [m/s^2]", comments="", fmt="%.6f")
    arguments = ["analyse", str(path), "tracked_spectrum", "-c", "acc", "--sample-rate", "5 kHz"]
    arguments += ["-O", "highest_order=30"]
    found = json_of([*arguments, "--tacho", "tacho", "--pulses-per-revolution", "1"], capsys)
    amplitude, order = (np.array(found["variables"][n]["values"]) for n in ("amplitude", "order"))
    # edges fall between samples: at 26 turns/s one sample is 0.033 rad, a ninth of a period of order 21
    assert order[2 + np.argmax(amplitude[2:])] == 21.0 and amplitude.max() == pytest.approx(3.0, rel=0.05)
    assert found["angle"] == "angle[tacho]"
    assert "and vice versa" in refusal([*arguments, "--tacho", "tacho"], capsys)
    both = ["--tacho", "tacho", "--pulses-per-revolution", "1", "--angle", "acc"]
    assert "both define the shaft" in refusal([*arguments, *both], capsys)
    assert "angle: is not named" in refusal(arguments, capsys)
    assert "did you mean tacho?" in refusal(
        [*arguments, "--tacho", "tach", "--pulses-per-revolution", "1"], capsys
    )


def test_several_channels_in_one_go(tmp_path, capsys):
    path = tmp_path / "a.wav"
    files.write_wav(path)
    arguments = ["analyse", str(path), "amplitude_spectrum", "-c", "channel 1", "-c", "channel 2"]
    out = tmp_path / "a.csv"
    found = json_of([*arguments, "--csv", str(out), "--html", str(tmp_path / "a.html")], capsys)
    assert found["variables"]["amplitude"]["dims"] == ["channel", "frequency"]
    assert "channel,frequency [Hz],amplitude [1]" in out.read_text(encoding="utf-8")
    assert run_command(arguments) == 0
    assert "amplitude_spectrum of channel 2" in capsys.readouterr().out


def test_units_and_sample_rate_from_the_command_line(tmp_path, capsys):
    path = tmp_path / "a.csv"
    path.write_text("a,b\n" + "".join(f"{k % 7},{k}\n" for k in range(40)), encoding="utf-8")
    arguments = ["analyse", str(path), "signal_statistics", "-c", "a"]
    assert "(limit one of them); give --sample-rate" in refusal(arguments, capsys)
    found = json_of([*arguments, "--sample-rate", "2 kHz", "--unit", "a=10 mm/s"], capsys)
    assert found["variables"]["max"] == {"dims": [], "unit": "m/s", "values": pytest.approx(0.06)}


@pytest.mark.parametrize(
    "more, sentence",
    [
        (["amplitude_spektrum", "-c", "force"], "did you mean amplitude_spectrum"),
        (["amplitude_spectrum"], "choose of force, speed"),
        (["amplitude_spectrum", "-c", "forze"], "did you mean force?"),
        (["amplitude_spectrum", "-c", "force", "-O", "window"], "'window' is not NAME=VALUE"),
        (["amplitude_spectrum", "-c", "force", "-O", "windo_name=hann"], "did you mean window_name?"),
        (["amplitude_spectrum", "-c", "force", "--unit", "x=N"], "'x' is not a channel of the file"),
        (
            ["power_spectral_density", "-c", "force", "-O", "segment=1e9"],
            "segment: 1000000000 samples (limit 4 to 64)",
        ),
        (["order_map", "-c", "force", "-O", "highest_order=4"], "angle: is not named"),
        (
            ["amplitude_spectrum", "-c", "force", "--sample-rate", "900"],
            "contradicts the file (limit 1000 Hz)",
        ),
    ],
)
def test_wrong_commands_get_a_sentence(rig, more, sentence, capsys):
    assert sentence in refusal(["analyse", rig, *more], capsys)


def test_a_damaged_file_ends_in_a_sentence(tmp_path, capsys):
    path = tmp_path / "a.wav"
    files.write_wav(path)
    path.write_bytes(path.read_bytes()[:100])
    assert "the file promises more" in refusal(["analyse", str(path), "amplitude_spectrum"], capsys)


def test_an_input_is_never_replaced(rig, capsys):
    arguments = ["analyse", rig, "signal_statistics", "-c", "force", "--csv", rig]
    assert "is read by the same command" in refusal(arguments, capsys)


def test_values_of_options():
    assert value_of("2.5 kHz") == 2500.0 and value_of("x3") == "x3" and value_of("5 bananas") == "5 bananas"
    assert json.dumps(value_of("1e3")) == "1000.0"
