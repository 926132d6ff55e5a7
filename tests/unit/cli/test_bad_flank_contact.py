# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces: what is refused, what is remarked, what is noted, and the exit codes."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.contact.potential_build import NominalValues, build_potential_table
from pitchpoint.contact.potential_range import TableSize
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import NOT_FINITE
from pitchpoint.io.contact_table import write_contact_table
from pitchpoint.io.gear_export import export_gear
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.contact_inputs import contact_inputs
from pitchpoint.model.remarks.keys_without_effect import keys_without_effect
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.precompute import (
    PotentialEvaluator,
    TableRequest,
    quantities,
    table_span,
)
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.cli_files import json_of, written

TEXT = """
gears:
  g1: {{number_of_teeth: {z1}, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{one}}}
  g2: {{number_of_teeth: {z2}, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{two}}}
bodies:
  a: {{gears: [g1], motion: torsion}}
  b: {{gears: [g2], motion: torsion}}
meshes:
  stage: {{gears: [g1, g2], contact: {{level: {contact}}}{mesh}}}
"""
PARTS = {"z1": "25", "z2": "31", "one": "", "two": "", "contact": "flexible", "mesh": ""}


def text_of(**parts: str) -> str:
    return TEXT.format(**(PARTS | parts))


REFUSED = {
    "stiffness": (
        {"mesh": ", stiffness: {law: constant, value: 3e8 N/m}"},
        "meshes.stage.stiffness (line 9): law: constant cannot be combined with contact",
        "remove stiffness or contact",
    ),
    "sainsot": (
        {"contact": "flexible, body: sainsot", "z1": "17"},
        "contact.body (line 9): 0.1772 is the half tooth angle at the root circle [rad] of gear g1",
        "(limit 0.01 to 0.12); use body: weber_banaschek, half_plane or ring",
    ),
    "sainsot of a ring": (
        {"contact": "flexible, body: sainsot", "z1": "60", "z2": "110", "two": ", type: internal"},
        "meshes.stage.contact.body (line 9): sainsot does not apply to internal gears",
        "use body: ring or weber_banaschek",
    ),
    "clamp": (
        {"contact": "flexible, clamp: 5 deg"},
        "meshes.stage.contact.clamp (line 9): 5 deg is not the inclination of a tangent of the fillet",
        "set clamp within the limits",
    ),
    "bore": (
        {"one": ", bore_diameter: 72 mm", "contact": "flexible"},
        "gears.g1.bore_diameter",
        "",
    ),
    "planes": (
        {"contact": "flexible, planes: 102"},
        "102 is out of range (limit >= 1 and",
        "write 101",
    ),
    "exponent": ({"contact": "rigid, exponent: 0.5"}, "0.5 is out of range (limit >= 1 and", "write 1"),
    "level": ({"contact": "soft"}, "allowed are rigid, flexible, precomputed", ""),
    "nan": ({"contact": "flexible, correction: .nan"}, "nan is not a finite number", ""),
    "no file": ({"contact": "precomputed, file: none.gcp.h5"}, "names a file that does not exist", ""),
    "no table": ({"contact": "precomputed, file: m.yaml"}, "is not a contact table, or is damaged", ""),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refused_with_code_2(case: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    parts, place, remedy = REFUSED[case]
    file = written(tmp_path, text_of(**parts), "m.yaml")
    assert run_command(["check", file]) == 2
    said = capsys.readouterr().err
    assert place in said
    assert remedy in said


@pytest.mark.parametrize(
    ("parts", "key"),
    [
        ({"mesh": ", width: slices"}, "meshes.stage.width"),
        ({"mesh": ", slices: 5"}, "meshes.stage.slices"),
        ({"contact": "flexible, teeth: finite_elements, clamp: 20 deg"}, "meshes.stage.contact.clamp"),
        ({"contact": "flexible, teeth: finite_elements, body: rigid"}, "meshes.stage.contact.body"),
        ({"contact": "flexible, teeth: finite_elements, coupling: none"}, "meshes.stage.contact.coupling"),
        ({"contact": "rigid, depth: 20 um"}, "meshes.stage.contact.depth"),
    ],
)
def test_keys_without_effect(parts: dict[str, str], key: str) -> None:
    found = [
        message for message in keys_without_effect(loads_model(text_of(**parts))) if message.where == key
    ]
    assert len(found) == 1
    assert "has no effect" in found[0]


@pytest.mark.parametrize("contact", ["flexible", "rigid", "rigid, exponent: 1.5, depth: 20 um"])
def test_blanks_of_flexible_teeth_have_an_effect(contact: str) -> None:
    """Also of a contact without stiffness, whose c' has the blank factor."""
    one = ", rim_thickness: 4 mm, web_thickness: 5 mm, polar_inertia: 1e-3 kg m^2"
    assert keys_without_effect(loads_model(text_of(contact=contact, one=one))) == ()


def test_stiffness_of_a_contact_leaves_the_blank_without_effect() -> None:
    one = ", rim_thickness: 4 mm, web_thickness: 5 mm, polar_inertia: 1e-3 kg m^2"
    found = keys_without_effect(loads_model(text_of(contact="rigid, stiffness: 3e8 N/m", one=one)))
    assert [message.where for message in found] == ["gears.g1.rim_thickness and web_thickness"]


def test_interference_is_noted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The ring touches the pinion inside its base circle."""
    file = written(tmp_path, text_of(z1="17", z2="43", two=", type: internal"), "m.yaml")
    found = json_of(["contact", file, "-t", "60 N m", "--positions", "8"], capsys)
    assert len(found["notes"]) == 1
    assert found["notes"][0].startswith("mesh stage: interference, g1 touches inside its base circle")


def test_contact_beyond_the_range_of_tip_edges_is_noted() -> None:
    data = solve_contact(loads_model(text_of()), torque=1e5, positions=16)
    assert "only contacts within 0.5 are calculated" in data.attrs["notes"]
    assert solve_contact(loads_model(text_of()), torque=100.0, positions=4).attrs["notes"] == ""


@pytest.mark.parametrize("fault", ["exchanged", "repeated"])
def test_profile_files_that_turn_back(fault: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Two points exchanged, or a piece run back and forth so that the profile touches itself: one problem."""
    form = loads_model(text_of()).gears["g1"].geometry
    export_gear(form, tmp_path / "all.csv", "csv", n_flank=20)
    head, *lines = (tmp_path / "all.csv").read_text(encoding="utf-8").splitlines()
    rows = [line for line in lines if line.split(",")[2] == "0"]
    a = 3 + next(k for k, row in enumerate(rows) if row.endswith("involute"))
    b = a + 5
    if fault == "exchanged":
        rows[a], rows[b] = rows[b], rows[a]
    else:
        rows = rows[:b] + rows[a:b][::-1] + rows[a:]
    (tmp_path / "tooth.csv").write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    file = written(tmp_path, text_of(one=", tooth_profile: {tooth: tooth.csv}"))
    assert run_command(["contact", file, "-t", "100"]) == 2
    text = capsys.readouterr().err
    assert "1 problem" in text
    assert "gears.g1.tooth_profile.tooth (line 3): -" in text
    assert "the flank reverses towards the root" in text
    assert "limit > 0 mm from root to tip" in text
    assert "file 'tooth.csv', line" in text


@pytest.mark.parametrize("level", ["rigid", "flexible"])
def test_gaps_without_a_number_are_a_status_with_the_state(
    level: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = FlankStates.states

    def lost(self: FlankStates, phase: object) -> np.ndarray:
        found = plain(self, phase)
        found["distance"][2] = np.nan
        return found

    monkeypatch.setattr(FlankStates, "states", lost)
    with pytest.raises(
        SolverError, match=r"mesh stage: no contact state at 10 N m, mesh phase 0.5"
    ) as caught:
        solve_contact(loads_model(text_of(contact=level)), torque=10.0, positions=4)
    assert caught.value.status != 0
    assert caught.value.partial is not None


RELIEF = "gears.g1.modifications.both.lead_crowning=0:10um"


@pytest.mark.parametrize(
    ("contacts", "command", "words"),
    [
        (("stiffness: {law: din3990}",) * 2, ["contact-table"], "no mesh has a contact of level flexible"),
        (("contact: {level: rigid}",) * 2, ["contact-table", "-m", "m1"], "m1 has a contact of level rigid"),
        (("contact: {level: rigid}",) * 2, ["relief", "--vary", RELIEF], "select a mesh; there are m0, m1"),
        (("stiffness: {law: din3990}",) * 2, ["relief", "--vary", RELIEF],
         "no mesh has a contact of level flexible or rigid"),
    ],
)  # fmt: skip
def test_levels_that_a_command_does_not_have(
    contacts: tuple[str, str],
    command: list[str],
    words: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Input is wrong, code 2; no computation has begun."""
    file, (name, *options) = tmp_path / "two.yaml", command
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    gears = "".join(f"  g{k}: {{number_of_teeth: {20 + k}, {gear}}}\n" for k in range(4))
    meshes = "".join(f"  m{k}: {{gears: [g{2 * k}, g{2 * k + 1}], {c}}}\n" for k, c in enumerate(contacts))
    file.write_text(f"gears:\n{gears}meshes:\n{meshes}", encoding="utf-8")
    assert run_command([name, str(file), "--torque", "100 N m", "-q", *options]) == 2
    assert words in capsys.readouterr().err


def test_tables_of_other_gears(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A small table is accepted for its gears, refused for others and when its bytes change."""
    model = loads_model(text_of())
    tables = {}
    for name, flank in (("front", 1), ("back", -1)):
        source = PotentialEvaluator(model, "stage", flank)
        span = table_span(source, TableRequest(torque=50.0))
        nominal = NominalValues(source.flanks.force_of(50.0), source.pitch, 0.02)
        tables[name] = build_potential_table(
            source.copy, span, nominal, TableSize(4, 4), quantities(source.pairs), checks=1
        )
    options = model.meshes["stage"].contact
    path = write_contact_table(tmp_path / "t.gcp.h5", tables, contact_inputs(model, "stage", options))
    contact = "precomputed, file: t.gcp.h5"
    file = written(tmp_path, text_of(contact=contact), "m.yaml")
    assert load_model(file).meshes["stage"].contact.tables is not None
    assert run_command(["check", file]) == 0
    other = written(tmp_path, text_of(contact=contact, z1="26"), "other.yaml")
    capsys.readouterr()
    assert run_command(["check", other]) == 2
    said = capsys.readouterr().err
    assert "was computed from other inputs" in said
    assert "compute the table again" in said
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(bytes(data))
    assert run_command(["check", file]) == 2
    assert "damaged" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["contact-table", "contact-levels", "relief"])
def test_torques_that_fold_the_teeth(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Before, the table had an error of 2e5 % of its nominal force, without a word."""
    file = written(tmp_path, text_of(), "m.yaml")
    more = ["--vary", "gears.g1.modifications.both.profile_crowning=0:9um"] if command == "relief" else []
    assert run_command([command, file, "--torque", "1e7 N m", "-q", *more]) == 2
    assert "deflects the flanks of stage by" in capsys.readouterr().err
    assert [p.name for p in tmp_path.iterdir()] == ["m.yaml"]


def test_failed_states_end_with_code_3(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = FlankStates.solve

    def failing(self: FlankStates, states: np.ndarray, keep_nodes: bool = False) -> object:
        found = plain(self, states, keep_nodes)
        states["status"][-1] = NOT_FINITE
        return found

    monkeypatch.setattr(FlankStates, "solve", failing)
    file = written(tmp_path, text_of(contact="rigid"), "m.yaml")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert run_command(["contact", file, "-t", "10 N m", "--positions", "4"]) == 3
    assert "mesh phase 0.7500" in capsys.readouterr().err
