# SPDX-License-Identifier: Apache-2.0
"""Pins of planetary stages on nodes of an elastic carrier: what is refused, and tables and pictures."""

from __future__ import annotations

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.section.axes import drawn_bodies
from pitchpoint.report.static_power import static_power
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.elastic_carriers import files, two_wall_carrier

MORE = "planets: 3\nmotion: planar\nbearing: {stiffness: {radial: 8e8 N/m}}"


def written(folder, *changes, kind="elastic"):
    """File of the set with changed words."""
    text = dict(zip(("rigid", "elastic"), files(folder, two_wall_carrier(), MORE, modes=24), strict=True))[
        kind
    ]
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    file = folder / "model.yaml"
    file.write_text(text, encoding="utf-8")
    return file


WRONG = {
    "none": (
        [("    pins: [p1, p2, p3]\n", "")],
        "is missing: planets act on an elastic carrier at its nodes; carrier has out, in, p1, p2, p3; "
        "name the node of each pin, such as pins: [p1, p2, p3]",
    ),
    "fewer": ([("[p1, p2, p3]", "[p1, p2]")], "2 nodes for 3 planets (limit one for each planet)"),
    "unknown": (
        [("[p1, p2, p3]", "[p1, p2, q3]")],
        "names 'q3', which carrier does not have; carrier has out, in, p1, p2, p3",
    ),
    "twice": ([("[p1, p2, p3]", "[p1, p2, p2]")], "names p2 again: two planets cannot be on one pin"),
    "exchanged": (
        [("[p1, p2, p3]", "[p1, p3, p2]")],
        "155.9 mm is the distance of carrier.p3 from the axis of planet_2 (limit 0.3 mm, a tenth of a "
        "module); name the node of planet_2, or correct its position: [-45, 77.9423, 0] mm in "
        "the axes of carrier",
    ),
    "axial": (
        [("p1: {position: [0.09, 0.0, 0.0]", "p1: {position: [0.09, 0.0, 0.05]")],
        "50 mm is the distance of carrier.p1 from the middle of planet_1 (limit 40 mm, the face width)",
    ),
    "no rotor": ([("rotor: true", "rotor: false")], "does not count revolutions (limit rotor: true)"),
    "no carrier": (
        [("carrier: carrier\n", "carrier: carier\n")],
        "names the body 'carier', which does not exist",
    ),
}


def test_values_are_replaced_in_a_model_of_a_relative_path(tmp_path, monkeypatch):
    """The file of the elastic carrier is in the folder of the model, not in the working folder."""
    (tmp_path / "rig").mkdir()
    written(tmp_path / "rig")
    monkeypatch.chdir(tmp_path)
    model = load_model("rig/model.yaml")
    changed = model.replace("loads.motor.torque", "500 N m").replace("elastic_bodies.carrier.modes", 26)
    assert changed.elastic_bodies["carrier"].file == model.elastic_bodies["carrier"].file
    assert len(find_modes(compile_model(changed)).frequency) > 26


@pytest.mark.parametrize("case", WRONG)
def test_wrong_pins_are_told(tmp_path, case):
    changes, words = WRONG[case]
    with pytest.raises(ModelError) as error:
        load_model(written(tmp_path, *changes))
    told = [str(p) for p in error.value.problems]
    assert len(told) == (2 if case == "exchanged" else 1), told
    assert words in told[0]
    assert error.value.problems[0].line


def test_a_node_that_the_file_does_not_have(tmp_path):
    """Positions agree with the stage, but not with the nodes of the matrices."""
    model = load_model(
        written(
            tmp_path,
            ("p1: {position: [0.09, 0.0, 0.0]", "p1: {position: [0.09, 0.0, 0.01]"),
        )
    )
    with pytest.raises(ModelError, match=r"nodes\.p1 .*: the file has no node at this position"):
        compile_model(model)


def test_elastic_carrier_in_tables_and_pictures(tmp_path, capsys):
    """Section, power flow, modes and the list of parts treat it as they do a rigid one."""
    model = load_model(written(tmp_path, kind="elastic"))
    rigid = load_model(written(tmp_path, kind="rigid"))
    assert set(drawn_bodies(model)) == set(drawn_bodies(rigid)) >= {"carrier", "planet_1"}
    flow = static_power(model, model.scenarios["steady"])["shafts"]
    for name in ("carrier", "out"):
        assert flow[name]["torque"] == pytest.approx(600.0 * 120 / 21, rel=1e-9)
    assert flow["carrier"]["driven_by"] == ["planet_1", "planet_2", "planet_3"]
    assert flow["out"]["driven_by"] == ["carrier"]
    names = find_modes(compile_model(model), None).names
    for kind in ("rotational", "translational"):
        assert any(f"{kind} mode of planetary stage set" in name for name in names), names
    assert any("elastic mode of carrier" in name for name in names)
    assert any(name.startswith("axial mode of carrier") for name in names)
    run_command(["check", str(written(tmp_path))])
    assert "carries planet_2 on carrier.p2" in capsys.readouterr().out


def test_effective_masses_are_those_of_the_machine(tmp_path):
    """With all modes their sums are mass and inertia of what moves, elastic or not."""
    sums = []
    for kind in ("rigid", "elastic"):
        model = load_model(written(tmp_path, kind=kind))
        sums.append(find_modes(compile_model(model), None).effective_mass.sum(axis=0))
    assert sums[1] == pytest.approx(sums[0], rel=1e-6)
