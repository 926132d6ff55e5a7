# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint wind`: values without unit, out of range and wrong names are refused, one sentence each."""

from __future__ import annotations

import pytest

from pitchpoint.cli.main import run_command

GIVEN = {"--speed": "12 m/s", "--height": "90 m", "--width": "145 m", "--duration": "1 s", "--points": "3"}


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"--speed": "12"}, "--speed: 12 has no unit; write '12 m/s'"),
        ({"--height": "90"}, "--height: 90 has no unit; write '90 m'"),
        ({"--width": "145"}, "--width: 145 has no unit; write '145 m'"),
        ({"--duration": "1"}, "--duration: 1 has no unit; write '1 s'"),
        ({"--speed": "12 kg"}, "--speed: '12 kg': 'kg' is not the unit of a speed"),
        (
            {"--width": "200 m"},
            "--width: 200 m is out of range (limit 0 to 180 m); the grid would reach below",
        ),
        ({"--speed": "900 m/s"}, "--speed: 900 m/s is out of range (limit 0.1 to 150 m/s)"),
        ({"--class": "IVA"}, "--class: 'IVA' is not one of 'IA'"),
        ({"--points": "many"}, "--points: 'many' is not a valid integer range"),
        ({"--sped": "12 m/s"}, "No such option '--sped'"),
    ],
)
def test_wrong_options_are_one_sentence(tmp_path, capsys, changes, words):
    options = [text for pair in {**GIVEN, **changes}.items() for text in pair]
    assert run_command(["wind", str(tmp_path / "wind.bts"), *options]) == 2
    said = capsys.readouterr().err
    assert words in said
    assert len(said.splitlines()) == (2 if "1 problem" in said else 1)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("name", "has"), [("wind.txt", "has the ending .txt"), ("wind", "has no ending")])
def test_the_file_is_one_of_turbsim(tmp_path, capsys, name, has):
    options = [text for pair in GIVEN.items() for text in pair]
    assert run_command(["wind", str(tmp_path / name), *options]) == 2
    said = capsys.readouterr().err
    assert f"{has} (limit .bts); write {tmp_path / 'wind.bts'}" in said
    assert not list(tmp_path.iterdir())


def test_an_empty_name_is_refused(capsys):
    options = [text for pair in GIVEN.items() for text in pair]
    assert run_command(["wind", "", *options]) == 2
    assert "OUTPUT: the name of the file is empty; write out.bts" in capsys.readouterr().err
