# SPDX-License-Identifier: Apache-2.0
"""The turning NREL 5 MW turbine in the wind, in multi-blade coordinates, against linearisations of OpenFAST.

Source: OpenFAST 2.5.0, data/linearization_outputs/ws03.0.{1,13,34}.lin of OpenFAST/openfast_toolbox (Apache
2.0): state matrices of 30 states at three azimuths, 3 m/s, 0.7301 rad/s, generator and pitch locked, yaw
free. The numbers are the eigenvalues of the mean of these matrices in multi-blade coordinates (Coleman and
Feingold 1958), which the first azimuth alone has to 2e-3. The matrices as they are have edgewise modes at
1.084 and 1.110 Hz instead of 0.965 and 1.216 Hz.

Tolerances. Frequencies: 17 elements and assumed modes deviate by 1.6 and 3.4 % in opposite directions, see
test_wind_turbine_matrix.py; the tower fore-aft by 3.4 %. Damping: in OpenFAST the structural damping is that
of modes, here of the material with the same value at the first modes. The damping of the air is that of a
slow wake: with `inflow: steady`, where the wake follows at once, the flapwise modes have 0.35 instead of
0.39.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.multiblade import find_multiblade_modes
from pitchpoint.system.compile import compile_model
from tests.support.rotors import FOLDER

OPENFAST = {
    "tower side to side": (0.3140, 0.0044, "", 0.015, 0.0005),
    "tower fore-aft": (0.3314, 0.0603, "collective", 0.04, 0.005),
    "drive train": (0.6263, 0.0248, "collective", 0.02, 0.001),
    "flap backward": (0.6880, 0.4143, "backward", 0.02, 0.03),
    "flap collective": (0.7063, 0.4053, "collective", 0.02, 0.03),
    "edge backward": (0.9650, 0.0340, "backward", 0.015, 0.006),
    "flap forward": (1.0225, 0.2033, "forward", 0.02, 0.02),
    "edge forward": (1.2163, 0.0167, "forward", 0.015, 0.006),
}
"""Absolute value of the eigenvalue [Hz], damping ratio, whirl; tolerance of the frequency (relative) and of
the damping ratio (absolute)."""


def test_the_whirl_of_openfast():
    changes = {
        **{f"beams.blade_{k}.pieces": 10 for k in (1, 2, 3)},
        **{f"beams.blade_{k}.internal_damping": 2.28e-3 for k in (1, 2, 3)},  # 0.477 % at 0.667 Hz
        **{f"actuators.servo_torque_{k}": None for k in (1, 2, 3)},
        "beams.tower.internal_damping": 3.5e-3,
        "wind_rotors.rotor.inflow": "dynamic",
        "winds.steady.speed": 3.0,
        "winds.steady.exponent": 0.0,
        "bushings.yaw_drive": None,
        "bodies.generator.inertia": 1.0,
        "actuators.generator_torque": None,
        "scenarios.parked.drive": {
            "generator": {"speed": 0.7301},
            **{f"root_{k}": {"speed": 0.0} for k in (1, 2, 3)},
        },
    }
    system = compile_model(load_model(FOLDER.parent / "model.yaml").replace_all(changes), "parked")
    blades = ["blade_1", "blade_2", "blade_3"]
    found = find_multiblade_modes(system, "parked", hub="hub", blades=blades, azimuths=3)
    sizes = np.abs(found.eigenvalue) / (2.0 * np.pi)
    order = np.argsort(sizes)
    for at, (name, (frequency, ratio, whirl, close, damped)) in zip(order, OPENFAST.items(), strict=False):
        assert sizes[at] == pytest.approx(frequency, rel=close), name
        assert found.damping_ratio[at] == pytest.approx(ratio, abs=damped), name
        if whirl:
            assert ("collective", "forward", "backward")[int(np.argmax(found.blades[at]))] == whirl, name
