# SPDX-License-Identifier: Apache-2.0
"""Rotors of wind turbines in model files: loads on rigid blades are those of `solve_rotor_performance`."""

from __future__ import annotations

import shutil
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.openfast.aerodyn import read_aerodyn
from pitchpoint.solvers.rotor_performance import along_blade, solve_rotor_performance
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.rotors import AERODYN, FOLDER

SPEED, TURNS = 8.0, 9.156 * np.pi / 30.0
HUB = """\
bodies:
  hub: {inertia: 4.37e7 kg m^2, position: [X m, 0, 90 m], axes: {z: [AXIS], x: [UP]}}
winds:
  steady: {speed: 8 m/s, height: HEIGHT m, profile: power, exponent: SHEAR, direction: DIRECTION deg}
wind_rotors:
  rotor: {hub: hub, aerodyn: onshore/AeroDyn.dat, hub_radius: 1.5 m, precone: CONE deg}
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Files of the turbine, without the flow around the tower."""
    path = tmp_path_factory.mktemp("turbine")
    shutil.copytree(FOLDER, path, dirs_exist_ok=True)
    text = AERODYN.read_text(encoding="utf-8")
    lines = ["0 TwrPotent" if "TwrPotent" in line else line for line in text.splitlines()]
    (path / "onshore" / "AeroDyn.dat").write_text("\n".join(lines), encoding="utf-8")
    return path


def model_of(folder, tilt=0.0, cone=0.0, shear=0.0, yaw=0.0, overhang=5.0, text=HUB):
    """Hub of a rotor 90 m above ground."""
    s, c = float(np.sin(tilt)), float(np.cos(tilt))
    changes = {
        "AXIS": f"{c!r}, 0, {-s!r}",
        "UP": f"{s!r}, 0, {c!r}",
        "X": repr(-overhang * c),
        "HEIGHT": repr(90.0),
        "SHEAR": repr(shear),
        "DIRECTION": repr(float(np.degrees(-yaw))),
        "CONE": repr(float(np.degrees(cone))),
    }
    for word, value in changes.items():
        text = text.replace(word, value)
    file = folder / "model.yaml"
    file.write_text(text, encoding="utf-8")
    return load_model(file)


def observed(system, angle, speed=TURNS):
    state = system.initial_state()
    spin = system.spin("hub")
    state.q[spin], state.v[spin] = angle, speed
    return dict(zip((c.name for c in system.layout.channels), evaluate.observe(system, state), strict=True))


@pytest.mark.parametrize(
    ("cone", "tilt", "shear", "yaw"),
    [(0.0, 0.0, 0.0, 0.0), (0.05, 0.0, 0.0, 0.0), (0.05, 0.1, 0.0, 0.0), (0.05, 0.1, 0.2, 0.3)],
)
def test_rigid_blades_have_the_loads_of_the_steady_rotor(folder, cone, tilt, shear, yaw):
    """Mean over one revolution to 1e-9: the same law. The torque of the solver is that of the forces alone;
    the pitching moment of an inclined blade has a component about the rotor axis. With tilt and yaw the
    sweep of the blade is a difference of azimuth, which the mean over 36 azimuths does not resolve."""
    system = compile_model(model_of(folder, tilt, cone, shear, yaw))
    rows = [observed(system, a) for a in 2.0 * np.pi * np.arange(12) / 36.0]
    given = read_aerodyn(folder / "onshore" / "AeroDyn.dat")
    rotor = Rotor(
        blade=given.blade,
        hub_radius=1.5,
        precone=cone,
        tilt=tilt,
        hub_height=90.0,
    )
    flow = replace(given.flow, sectors=36, shear_exponent=shear, yaw=yaw)
    found = solve_rotor_performance(rotor, SPEED, TURNS, flow=flow)
    moment = 3.0 * along_blade(rotor, found.pitching_moment.values[0] * np.sin(rotor.inclination))
    close = 1e-9 if tilt == shear == yaw == 0.0 else 1e-5
    thrust, torque, power = (
        np.mean([row[f"{word}[rotor]"] for row in rows])
        for word in ("rotor_thrust", "rotor_torque", "aerodynamic_power")
    )
    assert thrust == pytest.approx(float(found.rotor_thrust[0]), rel=close)
    assert torque == pytest.approx(float(found.rotor_torque[0]) - moment, rel=close)
    assert power == pytest.approx(torque * TURNS, rel=1e-9)
    assert rows[0]["hub_wind_speed[rotor]"] == pytest.approx(SPEED * np.cos(tilt) * np.cos(yaw))
