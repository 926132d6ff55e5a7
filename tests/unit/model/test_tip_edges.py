# SPDX-License-Identifier: Apache-2.0
"""Keys `tip_chamfer` and `tip_rounding`: reading, writing, messages, numbers, records and drawings."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.schema import json_schema
from pitchpoint.report.numbers import gear_numbers
from pitchpoint.system.compile import compile_model
from tests.support.cli_files import written
from tests.support.machines import pair

TEXT = pair("{law: din3990}")
CHAMFERED = TEXT.replace("face_width:", "tip_chamfer: 0.2 mm, face_width:", 1)
ROUNDED = TEXT.replace("face_width:", "tip_rounding: 0.2 mm, face_width:", 1)


def first(model):
    name = next(iter(model.gears))
    return name, model.gears[name]


@pytest.mark.parametrize("text", [CHAMFERED, ROUNDED])
def test_keys_are_read_written_and_replaced(text):
    model = loads_model(text)
    name, gear = first(model)
    key = "tip_chamfer" if text is CHAMFERED else "tip_rounding"
    assert getattr(gear, key) == getattr(gear.geometry, key) == pytest.approx(0.2e-3)
    assert gear.geometry.d_Fa < gear.geometry.d_a
    assert loads_model(dump_model(model)) == model
    assert f"{key}: 0.2 mm" in dump_model(model)
    half = model.replace(f"gears.{name}.{key}", 0.1e-3)
    assert first(half)[1].geometry.d_Fa > gear.geometry.d_Fa
    none = model.replace(f"gears.{name}.{key}", None)
    assert none == loads_model(TEXT)
    zero = model.replace(f"gears.{name}.{key}", 0.0)
    assert first(zero)[1].geometry.d_Fa == first(none)[1].geometry.d_Fa


def test_keys_are_in_the_schema():
    keys = json_schema()["$defs"]["Gear"]["properties"]
    assert {"tip_chamfer", "tip_rounding"} <= set(keys)
    assert keys["tip_chamfer"]["unit"] == "m"


def test_models_with_sharp_edges_are_written_as_before():
    assert "tip_" not in dump_model(loads_model(TEXT))


@pytest.mark.parametrize(
    ("given", "where", "words"),
    [
        ("tip_chamfer: 3 mm", "tip_chamfer", "is larger than the tip"),
        ("tip_rounding: 3 mm", "tip_rounding", "is larger than the tip"),
        ("tip_rounding: 0.1 mm, tip_chamfer: 0.1 mm", "tip_rounding", "cannot be combined with tip_chamfer"),
        ("tip_chamfer: -0.1 mm", "tip_chamfer", "out of range"),
        ("tip_rounding: .nan", "tip_rounding", ""),
        ("tip_chamfer: 0.1", "tip_chamfer", "is larger than the tip"),
    ],
)
def test_wrong_edges_are_told_with_their_lines(given, where, words):
    with pytest.raises(ModelError) as caught:
        loads_model(TEXT.replace("face_width:", f"{given}, face_width:", 1))
    problem = caught.value.problems[0]
    assert problem.where.endswith(where)
    assert words in str(problem)
    assert problem.line == next(
        k for k, line in enumerate(TEXT.splitlines(), start=1) if "face_width:" in line
    )


def test_largest_edge_of_the_message_is_accepted():
    with pytest.raises(ModelError) as caught:
        loads_model(TEXT.replace("face_width:", "tip_chamfer: 3 mm, face_width:", 1))
    (problem,) = caught.value.problems
    most = problem.limit.split(" mm")[0]
    assert problem.remedy == "reduce it"
    loads_model(TEXT.replace("face_width:", f"tip_chamfer: {float(most) - 1e-4} mm, face_width:", 1))


@pytest.mark.parametrize("text", [CHAMFERED, ROUNDED])
def test_mesh_element_has_the_path_up_to_the_tip_form_circles(text):
    model = loads_model(text)
    (mesh,) = model.pairs
    pair = model.pairs[mesh]
    row, plain = (compile_model(m).records["gear_mesh"][0] for m in (model, loads_model(TEXT)))
    assert row["rho_a1"] == pytest.approx(pair.T1E, rel=1e-14)
    assert row["rho_a2"] == plain["rho_a2"]
    assert row["now"]["eps"] == pytest.approx(pair.eps_alpha, rel=1e-12)
    assert row["now"]["eps"] < plain["now"]["eps"]
    for name in row.dtype.names:
        if name in ("r_b1", "r_b2", "p_bt", "u0", "xi_0", "xi_b", "tan_b"):
            assert row[name] == plain[name]


def test_numbers_and_tables(tmp_path, capsys):
    from pitchpoint.cli.main import run_command

    model = loads_model(CHAMFERED)
    name, gear = first(model)
    numbers = gear_numbers(model, name)
    assert numbers["tip_chamfer"] == 0.2e-3 and numbers["tip_rounding"] is None
    assert numbers["d_Fa"] == pytest.approx(gear.geometry.d_a - 0.4e-3)
    assert run_command(["gears", written(tmp_path, CHAMFERED)]) == 0
    shown = capsys.readouterr().out
    assert "radial height of the tip chamfer" in shown and "tip rounding" not in shown
    assert run_command(["gears", written(tmp_path, TEXT)]) == 0
    assert "tip chamfer" not in capsys.readouterr().out


def test_drawing_names_the_tip_form_circle():
    from pitchpoint.viz.tooth_drawing import tooth_svg

    for text in (CHAMFERED, ROUNDED, TEXT):
        drawing = tooth_svg(first(loads_model(text))[1].geometry, name="a")
        assert ("tip form d_Fa" in drawing) == (text is not TEXT)
