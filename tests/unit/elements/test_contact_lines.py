# SPDX-License-Identifier: Apache-2.0
"""Contact lines asked for by pictures carry what the mesh element itself reports of its pairs."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.kernel import invoke
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh import contact_lines
from pitchpoint.elements.mesh.bevel import contact_lines as bevel_contact_lines
from pitchpoint.elements.mesh.contact_lines import LINES
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.meshes import is_bevel, mesh_record
from tests.support.bevel_files import bevel_file

PAIR = """\
gears:
  a: {{number_of_teeth: 23, normal_module: 3 mm, helix_angle: {beta}, hand: left, face_width: 30 mm, profile_shift_coefficient: 0{a}}}
  b: {{number_of_teeth: {z}, {kind}normal_module: 3 mm, helix_angle: {beta}, hand: {hand}, face_width: 28 mm, profile_shift_coefficient: 0}}
bodies:
  first: {{gears: [a], motion: free}}
  second: {{gears: [b], motion: free}}
meshes:
  m: {{gears: [a, b], stiffness: {{{law}}}, backlash: {{base_tangent: 0.05 mm}}, misalignment: {{in_plane: 0.1 mrad}}}}
bearings:
  s1: {{body: first, stiffness: {{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad, torsion: 1e5}}}}
  s2: {{body: second, stiffness: {{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad, torsion: 1e5}}}}
"""  # noqa: E501

MACHINES = {
    "helical": {},
    "spur": {"beta": "0 deg"},
    "internal": {"z": 61, "kind": "type: internal, tip_diameter: 185 mm, ", "hand": "left", "beta": "15 deg"},
    "relief": {"a": ", modifications: {both: {tip_relief: {amount: 20 um, length: 1.5 mm}}}"},
    "broken": {"a": ", faults: {one: {type: broken_tooth, tooth: 1, width: 9 mm}}"},
    "hertz": {"law": "law: hertz"},
}
BEVELS = {
    "straight bevel": {},
    "spiral bevel": {"spiral": 30.0},
    "broken bevel": {"spiral": 30.0, "fault": "faults: {one: {type: broken_tooth, tooth: 1, width: 9 mm}}, "},
}


def bevel_machine(spiral: float = 0.0, fault: str = ""):
    text = bevel_file(
        spiral=spiral,
        bodies="motion: free",
        mesh="stiffness: {law: din3990, stiffness_ratio: 0.8, low_load: true}, backlash: {normal: 0.05 mm}",
        rest=PAIR[PAIR.index("bearings:") :].format(),
    )
    return compile_model(loads_model(text.replace("opens: +z", f"{fault}opens: +z", 1)))


def machine(name: str):
    if name in BEVELS:
        return bevel_machine(**BEVELS[name])
    values = {"beta": "15 deg", "z": 41, "kind": "", "hand": "right", "a": "", "law": "law: din3990"}
    return compile_model(loads_model(PAIR.format(**{**values, **MACHINES[name]})))


def asked(system, flank: int, stations: int) -> tuple[np.ndarray, np.ndarray, float]:
    """Forces, loads and phase of one flank where the system stands."""
    record = mesh_record(system, 0)
    answer = bevel_contact_lines.answer if is_bevel(record) else contact_lines.answer
    question = np.zeros(1, LINES)
    forces, loads = np.full(record["n_pair"], np.nan), np.full((record["n_pair"], stations), np.nan)
    question["record"], question["flank"] = record["here"], flank
    question["deflection"], question["stations"] = record["now"]["u"] - record["now"]["e_t"], stations
    question["forces"], question["loads"] = forces.ctypes.data, loads.ctypes.data
    assert invoke(answer, system.workspace.at, question.ctypes.data, 1) == OK
    return forces, loads, float(question[0]["pairs"] + question[0]["psi"])


def turned(system, angle: float, push: float):
    """Both gears turned by the ratio of their teeth, gear 1 by a push [m] more; bodies displaced a little."""
    record = mesh_record(system, 0)
    state = system.initial_state()
    names = system.layout.coordinates
    state.q[names.index("first.spin")] += angle + push / record["r_b1"]
    state.q[names.index("second.spin")] -= angle * record["z1"] / record["z2"]
    state.q[names.index("second.x")] += 3e-6
    state.q[names.index("second.alpha")] += 2e-5
    return state


@pytest.mark.nojit
@pytest.mark.parametrize("name", [*MACHINES, *BEVELS])
@pytest.mark.parametrize("push", [45e-6, -45e-6])
def test_forces_are_those_that_the_element_observes(name, push):
    system = machine(name)
    pairs = [k for k, c in enumerate(system.layout.channels) if c.name.startswith("pair_force")]
    for angle in np.linspace(0.0, 0.6, 7):
        row = evaluate.observe(system, turned(system, angle, push))
        found = sum(asked(system, flank, 3)[0] for flank in (1, -1))
        assert np.abs(row[pairs]).max() > 100.0
        assert np.abs(found - row[pairs]).max() < 1e-9 * np.abs(row[pairs]).max()


def test_loads_are_the_density_of_the_forces():
    """The middle rule over 4000 places of a spur pair: its load changes with the tilt alone."""
    system = machine("spur")
    evaluate.observe(system, turned(system, 0.1, 45e-6))
    forces, loads, _ = asked(system, 1, 4001)
    record = mesh_record(system, 0)
    width = record["now"]["z_hi"] - record["now"]["z_lo"]
    middles = 0.5 * (loads[:, 1:] + loads[:, :-1]).mean(axis=1) * width
    assert forces.max() > 100.0
    assert middles == pytest.approx(forces, abs=1e-6 * forces.max())


@pytest.mark.parametrize("name", BEVELS)
def test_loads_of_bevels_are_the_density_of_the_forces(name):
    """Even places of ln R, dR = R d(ln R); the load jumps at the end of the relief and at that of a tooth."""
    system = machine(name)
    evaluate.observe(system, turned(system, 0.1, 45e-6))
    forces, loads, phase = asked(system, 1, 4001)
    record = mesh_record(system, 0)
    ends = [np.log1p(record[end] / record["R_m"]) for end in ("z_lo", "z_hi")]
    slope = record["R_m"] * record["tan_b"] / record["p_bt"]
    compared = 0
    for number in range(int(phase) - 3, int(phase) + 3):
        low, high = ends
        if slope != 0.0:
            path = sorted((p - phase + number) / slope for p in (0.0, record["now"]["eps"]))
            low, high = max(low, path[0]), min(high, path[1])
        slot = number % record["n_pair"]
        if high > low and forces[slot] != 0.0:
            R = record["R_m"] * np.exp(np.linspace(low, high, loads.shape[1]))
            whole = np.trapezoid(loads[slot] * R, dx=(high - low) / (len(R) - 1))
            assert whole == pytest.approx(forces[slot], abs=2e-3 * forces.max())
            compared += 1
    assert compared >= 1


@pytest.mark.parametrize("name", ["helical", "spiral bevel"])
def test_nothing_is_carried_across_a_gap_and_phases_go_on(name):
    """A tooth further the phase is one more; with the gears in the middle of the backlash neither flank
    carries."""
    system = machine(name)
    phases = []
    for angle in (0.0, 2.0 * np.pi / mesh_record(system, 0)["z1"]):
        evaluate.observe(system, turned(system, angle, 0.0))
        for flank in (1, -1):
            forces, loads, phase = asked(system, flank, 5)
            assert not np.any(forces) and not np.any(loads)
            phases.append(phase)
    assert phases[2] - phases[0] == pytest.approx(1.0, abs=1e-9)
    assert phases[3] - phases[1] == pytest.approx(-1.0, abs=1e-9)
