# SPDX-License-Identifier: Apache-2.0
"""Lubricant of a model in contact analyses and oil films, without options."""

from __future__ import annotations

import json
import math

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.contact.lubricant import dynamic_viscosity, pressure_viscosity, squeeze_rate
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.unit.cli.test_contact import MODEL

OIL = """\
lubricant: {viscosity_at_40_degree_celsius: 220 mm^2/s, viscosity_at_100_degree_celsius: 19 mm^2/s,
            density_at_15_degree_celsius: 890 kg/m^3, temperature: 60 degC}
load_cases:
  rated: {speed: {a: 1500 rpm}, temperature: 80 degC}
"""
AT_38 = dynamic_viscosity(311.15, 220e-6, 19e-6, 890.0)
ALPHA = pressure_viscosity(353.15, AT_38)
RATED = ["--speed", "1500 rpm", "--viscosity", "30.0930484 mPa s", "--pressure-viscosity", f"{ALPHA} 1/Pa"]


def numbers(file, options, capsys):
    assert run_command(["contact", file, "-t", "302 N m", "--positions", "8", "--json", *options]) == 0
    return json.loads(capsys.readouterr().out)


def test_film_thickness_follows_from_the_lubricant_of_the_load_case(tmp_path, capsys):
    """The same numbers as with the viscosity 30.09 mPa s at 80 °C as an option; none without speed."""
    with_oil, without = tmp_path / "oil.yaml", tmp_path / "plain.yaml"
    with_oil.write_text(MODEL + OIL, encoding="utf-8")
    without.write_text(MODEL, encoding="utf-8")
    own = numbers(str(with_oil), ["--load-case", "rated", "--friction", "0.05"], capsys)
    given = numbers(str(without), [*RATED, "--friction", "0.05"], capsys)
    assert own["options"]["viscosity"] == pytest.approx(0.0300930484, rel=1e-8)
    assert own["options"]["speed"] == pytest.approx(1500.0 * math.pi / 30.0)
    film = own["numbers"]["min_film_thickness"]
    assert film == pytest.approx(given["numbers"]["min_film_thickness"], rel=1e-5)
    assert own["numbers"]["max_flash_temperature"] == pytest.approx(given["numbers"]["max_flash_temperature"])
    assert "min_film_thickness" not in numbers(str(with_oil), [], capsys)["numbers"]
    hot = numbers(str(with_oil), ["--speed", "1500 rpm"], capsys)
    assert hot["numbers"]["min_film_thickness"][0] > film[0]  # 60 °C


def test_all_load_cases_in_turn(tmp_path, capsys):
    """Each has the numbers of its own `--load-case`, and a file of its own."""
    file, target = tmp_path / "oil.yaml", tmp_path / "contact.h5"
    hot = "  hot: {speed: {a: 1500 rpm}, temperature: 100 degC}\n"
    file.write_text(MODEL + OIL + hot, encoding="utf-8")
    found = numbers(str(file), ["--load-cases", "-o", str(target)], capsys)["load_cases"]
    assert list(found) == ["rated", "hot"]
    for name, case in found.items():
        alone = numbers(str(file), ["--load-case", name], capsys)
        assert case["numbers"] == alone["numbers"]
        assert (tmp_path / f"contact-{name}.h5").exists()
    assert found["hot"]["numbers"]["min_film_thickness"] < found["rated"]["numbers"]["min_film_thickness"]
    (tmp_path / "plain.yaml").write_text(MODEL, encoding="utf-8")
    assert run_command(["contact", str(tmp_path / "plain.yaml"), "--load-cases"]) == 2


def test_the_damping_of_an_oil_film_follows_from_the_lubricant(tmp_path):
    """3 √2 π η L (R/h)^1.5 at the pitch point, by load case; a given rate is kept."""
    text = MODEL.replace("planes: 7}", "planes: 7, oil: {thickness: 5 um}}")
    with pytest.raises(
        ModelError, match=r"stage.contact.oil.rate .* is missing, and the model has no lubricant"
    ):
        loads_model(text)
    model = loads_model(text + OIL).replace("load_case", "rated")
    pair = model.pairs["stage"]
    one, two = (0.5 * d * math.sin(pair.alpha_wt) for d in (pair.d_w1, pair.d_w2))
    rate = squeeze_rate(0.0300930484, one * two / (one + two), 5e-6, 0.014 / 7)
    assert model.meshes["stage"].contact.oil.rate == pytest.approx(rate, rel=1e-6)
    cold = model.replace("load_case", None)
    assert cold.meshes["stage"].contact.oil.rate > 2.0 * rate
    assert "oil: {thickness: 5 um}" in model.to_yaml()
    assert model.replace("meshes.stage.contact.oil.rate", 50.0).meshes["stage"].contact.oil.rate == 50.0
