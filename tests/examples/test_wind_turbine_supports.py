# SPDX-License-Identifier: Apache-2.0
"""Foundation on springs and an elastic machine frame, as on the page docs/howto/wind_turbine.md."""

from __future__ import annotations

import io
import re
from pathlib import Path

import numpy as np
import pytest
from ruamel.yaml import YAML

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.structure import beam_line
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "wind-turbine"
PAGE = (FOLDER.parents[1] / "docs" / "howto" / "wind_turbine.md").read_text(encoding="utf-8")
SOIL, FRAME = (
    YAML(typ="safe").load(block)
    for block in re.findall(r"^```yaml\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE)
    if "soil:" in block or "frame:" in block
)
LENGTH = float(np.hypot(5.0, 2.4))
SMALL = (1e4, 0.0, 0.0)
SECTION, E = tube(1.6, 1.4), 2.1e11


def turbine(folder, *parts, p=None):
    """The example with parts of the page, coarse blades; without wind and weight for a force p on the hub."""
    data, drive = (
        YAML(typ="safe").load((FOLDER / name).read_text(encoding="utf-8"))
        for name in ("model.yaml", "two_mass.yaml")
    )
    assert data.pop("include") == ["two_mass.yaml"]
    for part in (drive, *parts):
        for section, entries in part.items():
            for name, values in entries.items():
                known = data.setdefault(section, {})
                known[name] = {**known.get(name, {}), **values} if isinstance(values, dict) else values
    for name in ("blade_1", "blade_2", "blade_3"):
        data["beams"][name]["pieces"] = 4
    for entry in data["beams"].values():
        entry["properties"]["elastodyn"] = str(FOLDER / entry["properties"]["elastodyn"])
    data["wind_rotors"]["rotor"]["aerodyn"] = str(FOLDER / data["wind_rotors"]["rotor"]["aerodyn"])
    data["scenarios"]["production"].update(duration="0.5 s", settle_time="0 s")
    if p is not None:
        del data["wind_rotors"], data["gravity"]
        data["loads"] = {"push": {"body": "hub", "force": list(p)}}
        data["scenarios"] = {"parked": data["scenarios"]["parked"]}
    text = io.StringIO()
    YAML(typ="safe").dump(data, text)
    return compile_model(
        loads_model(text.getvalue(), file=str(folder / "model.yaml")), "production" if p is None else "parked"
    )


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """With the matrices of the frame: a tube from the yaw bearing to the main bearing, six elements."""
    place = tmp_path_factory.mktemp("turbine")
    line = beam_line([Beam(section=SECTION, length=LENGTH / 6, E=E, G=8e10, rho=7850.0)] * 6)
    np.savez(place / "frame.npz", K=line.K.toarray(), M=line.M.toarray(), places=line.places)
    return place


def places(system, *bodies):
    """Places and axes of bodies at rest under the weight."""
    begin = prepare_start(system, system.scenario)
    evaluate.residual(begin.system, begin.state)
    frames = begin.system.workspace.fr
    at = [begin.system.layout.bodies.index(name) for name in bodies]
    return [(frames["r"][i].copy(), frames["S"][i].copy()) for i in at]


def test_foundation(folder):
    """Under 100 kN more at the hub the base moves by F/k and tilts by F z/k_tilt, as the tower is statically
    determinate; the soil makes the first modes slower, and a stiff soil is the clamped tower."""
    two, one = (places(turbine(folder, SOIL, p=(n * 1e5, 0.0, 0.0)), "foundation")[0] for n in (2, 1))
    moved, tilt = two[0] - one[0], (two[1] @ one[1].T)[0, 2]
    stiffness = SOIL["bushings"]["soil"]["stiffness"]
    value = {name: float(str(text).split()[0]) for name, text in stiffness.items()}
    assert moved[0] == pytest.approx(1e5 / value["radial"], rel=1e-6)
    assert tilt == pytest.approx(1e5 * 90.0 / value["tilt"], rel=1e-3)  # the hub rises
    soft, clamped = (
        find_modes(turbine(folder, *part, p=SMALL), "parked", count=3).frequency for part in ([SOIL], [])
    )
    stiff = {"bushings": {"soil": {"stiffness": {n: v * 1e4 for n, v in value.items()}}}}
    hard = find_modes(turbine(folder, SOIL, stiff, p=SMALL), "parked", count=3).frequency
    assert (soft[:2] < 0.97 * clamped[:2]).all()
    np.testing.assert_allclose(hard, clamped, rtol=1e-4)


def test_machine_frame(folder):
    """The hub sinks relative to the nacelle by F L^3/(3 E I) + F L/(k G A) across and F L/(E A) along the
    frame; the turbine runs with it."""
    relative = []
    for force in (-2e5, -1e5):
        (x, R), (hub, _) = places(turbine(folder, FRAME, p=(0.0, 0.0, force)), "nacelle", "hub")
        relative.append(R.T @ (hub - x))
    along = np.array([-5.0, 0.0, 2.4]) / LENGTH
    across = np.array([2.4, 0.0, 5.0]) / LENGTH
    moved = relative[0] - relative[1]
    force = np.array([0.0, 0.0, -1e5])
    bend = LENGTH**3 / (3.0 * E * SECTION.I_1)
    shear = LENGTH / (SECTION.kappa_1 * 8e10 * SECTION.A)
    assert moved @ across == pytest.approx((bend + shear) * force @ across, rel=0.01)
    assert moved @ along == pytest.approx(force @ along * LENGTH / (E * SECTION.A), rel=0.05)


def test_the_turbine_runs_on_both(folder):
    """Half a second of production from the operating point: the speed holds, the base carries all weight."""
    system, memory = turbine(folder, SOIL, FRAME), Memory()
    done = run_time(system, sink=memory)
    assert done.status == 1, done.sentence
    rows = np.concatenate(memory.rows)
    value = lambda name: rows[:, system.layout.channel(name)]  # noqa: E731
    assert np.ptp(value("speed[hub]")) < 0.01 * value("speed[hub]").mean()
    assert value("rotor_thrust[rotor]").mean() == pytest.approx(370e3, rel=0.02)
    frame = 7850.0 * SECTION.A * LENGTH
    mass = 1900e3 + 347460.0 + 240e3 + frame + 56780.0 + 3 * 17609.0
    thrust = value("rotor_thrust[rotor]") * np.sin(np.radians(5.0))
    assert value("bushing_force[soil.fz]").mean() == pytest.approx(
        -(9.80665 * mass + thrust.mean()), rel=1e-3
    )
