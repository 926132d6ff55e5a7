# SPDX-License-Identifier: Apache-2.0
"""Tables of the elastic potential computed from flexible contact, and runs with them."""

import json
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.cli.contact_table import LISTED
from pitchpoint.cli.main import run_command
from pitchpoint.contact.potential_range import TableSize
from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.core.status import OK
from pitchpoint.io.contact_table import read_contact_table, write_contact_table
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.contact_inputs import contact_inputs
from pitchpoint.model.remarks.collect import remarks_of
from pitchpoint.solvers.contact_analysis.precompute import PotentialEvaluator, TableRequest, contact_table
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.time import run_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.contact_table import contact_words, options_of
from tests.support.flank_models import pair_text

SIZE = TableSize(16, 10, 5, 3)
REQUEST = TableRequest(torque=400.0, misalignment=2e-3, centre_distance=5e-5)


@pytest.fixture(scope="module")
def flexible():
    return loads_model(pair_text())


@pytest.fixture(scope="module")
def table_file(flexible, tmp_path_factory):
    tables = {
        name: contact_table(flexible, "stage", REQUEST, flank, size=SIZE)
        for name, flank in (("front", 1), ("back", -1))
    }
    path = tmp_path_factory.mktemp("tables") / "stage.gcp.h5"
    inputs = contact_inputs(flexible, "stage", flexible.meshes["stage"].contact)
    write_contact_table(path, tables, inputs)
    return path


def precomputed(path, **more):
    return loads_model(pair_text(f"{{level: precomputed, file: {path}}}", **more))


def test_values_are_the_derivatives_of_the_potential(flexible):
    """Central differences; the potential is smooth but for contact that begins (none at these approaches)."""
    evaluator = PotentialEvaluator(flexible, "stage", 1)
    rng = np.random.default_rng(0)
    a = abs(evaluator.flanks.distance)
    states = np.column_stack(
        [
            rng.random(12),
            rng.uniform(15e-6, 30e-6, 12),
            rng.uniform(-1e-3, 1e-3, 12),
            a + rng.uniform(-2e-5, 2e-5, 12),
        ]
    )
    values = evaluator(states)
    for k, h in enumerate((1e-6, 1e-10, 1e-8, 1e-9)):
        step = np.zeros(4)
        step[k] = h
        slope = (evaluator(states + step)[:, 0] - evaluator(states - step)[:, 0]) / (2.0 * h)
        assert np.allclose(slope, values[:, 1 + k], rtol=0.0, atol=2e-6 * abs(values[:, 1 + k]).max())


def test_the_roll_agrees_within_the_errors_of_the_table(flexible, table_file):
    """Transmission error against flexible contact: the force error over the mesh stiffness."""
    rolls = [roll_through(compile_model(m), "slow") for m in (flexible, precomputed(table_file))]
    system = compile_model(flexible)
    channel = system.layout.channel("transmission_error[stage]")
    one, two = (roll.rows[:, channel] for roll in rolls)
    force = 300.0 / (0.5 * flexible.gears["pinion"].geometry.d_b)
    assert abs(one - two).max() < 0.02 * force / 5e8  # 2 % of the nominal force, for this coarse table


def test_a_run_outside_the_range_says_so(table_file):
    done = run_time(compile_model(precomputed(table_file, torque="1500 N m"), "run"))
    assert any("left the range of its contact table: approach" in str(n) for n in done.notes)


def test_trial_states_of_the_start_are_not_part_of_the_run(table_file):
    done = run_time(compile_model(precomputed(table_file), "run"))
    assert done.status == OK
    assert not any("contact" in str(n) for n in done.notes)


def test_a_table_of_other_gears_is_refused(table_file):
    with pytest.raises(ModelError, match="face_width is 31 mm, was 30 mm"):
        precomputed(table_file, width="31 mm")


def test_rigid_contact_has_no_table():
    with pytest.raises(SolverError, match="flexible"):
        contact_table(loads_model(pair_text("{level: rigid}")), "stage", REQUEST)


def test_teeth_that_differ_have_no_table():
    text = pair_text().replace("-0.1}", "-0.1, faults: {chip: {type: pitch_error, tooth: 3, amount: 10 um}}}")
    with pytest.raises(SolverError, match="differ from each other"):
        contact_table(loads_model(text), "stage", REQUEST)


def test_an_analysis_describes_the_flexible_contact_of_the_table(flexible, table_file):
    """It is that of flexible contact."""
    one, two = (solve_contact(m, torque=200.0, positions=4) for m in (flexible, precomputed(table_file)))
    assert np.array_equal(one["transmission_error"], two["transmission_error"])
    about = {"level": "flexible", "planes": 5, "body": "ring", "correction": 1.0}
    assert options_of(two).items() >= about.items()
    assert contact_words(options_of(two)) == contact_words(options_of(one))


def test_a_request_that_no_table_can_cover():
    for change in ({"torque": 0.0}, {"misalignment": 0.2}, {"misalignment": float("nan")}):
        with pytest.raises(SolverError, match="is not a load|is out of range"):
            TableRequest(**({"torque": 5.0} | change))


def test_errors_of_a_table_above_their_limits_are_noted(flexible, table_file, monkeypatch, capsys, tmp_path):
    """In the terminal, in JSON, and as a remark on the model; the worse of both flanks and quantities."""
    errors = ({"force": (0.02, 0.1, 0.5)}, {"force": (0.02, 0.1, 0.5), "tilting_moment": (0.2, 0.9, 0.5)})
    listed = dict.fromkeys(LISTED, (0.0, 0.0, 0.5))
    stored = read_contact_table(table_file)
    tables = {
        flank: replace(stored.tables[flank], errors=listed | each)
        for flank, each in zip(("front", "back"), errors, strict=True)
    }
    said = "rms error of the tilting moment on the back flanks is 20 % of F_bt b/2 (limit 5 %); compute"
    monkeypatch.setattr("pitchpoint.cli.contact_table.compute", lambda *_: tables)
    file, target = tmp_path / "m.yaml", tmp_path / "t.gcp.h5"
    file.write_text(pair_text(), encoding="utf-8")
    command = ["contact-table", str(file), "--torque", "400", "-o", str(target)]
    assert run_command(command) == 0
    assert f"note: contact table of stage: {said}" in " ".join(capsys.readouterr().out.split())
    assert run_command([*command, "--json"]) == 0
    assert said in json.loads(capsys.readouterr().out)["notes"][0]
    (remark,) = remarks_of(precomputed(target))
    assert str(remark).startswith("meshes.stage.contact.file (line ")
    assert said in remark
    assert remarks_of(precomputed(table_file)) == ()
