# SPDX-License-Identifier: Apache-2.0
"""FC-6: whole contact of a spur pair with rounded tips, against an open gear contact program.

17/43 teeth, m 1 mm, b 10 mm, a 30 mm, tip rounding 0.1 mm, steel, μ 0.06, 20 N m on gear 1: mean number of
loaded pairs 1.8032, mean normal force 2486.0 N, torque on gear 2 50.037 N m, maximum pressure 4782 MPa. It is
at the start of the rounding, where the curvature changes within the contact (`test_curvature_step`); Hertz
gives 2731 MPa on the involutes. Code to code: tolerance 1 %, of pressures 3 %; of the pairs 1.5 %, as their
number follows from the deflection, which depends on the gear body (1.73 to 1.79 for the bodies of this
package). The states here neglect friction: the force is that without it, 0.7 % more.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.lubrication import Operation, with_operation
from pitchpoint.solvers.contact_analysis.solve import solve_contact

GEAR = "normal_module: 1 mm, face_width: 10 mm, profile_shift_coefficient: 0, tip_rounding: 0.1 mm"
MODEL = f"""
gears:
  g1: {{number_of_teeth: 17, {GEAR}}}
  g2: {{number_of_teeth: 43, {GEAR}}}
bodies:
  a: {{gears: [g1], motion: torsion}}
  b: {{gears: [g2], motion: torsion}}
meshes:
  m: {{gears: [g1, g2], center_distance: 30 mm, contact: {{level: flexible, planes: 1}}}}
"""


@pytest.fixture(scope="module")
def numbers():
    link = FlankStates._link

    def rounded(self):
        self.records["rounding"] = 0.1e-3
        link(self)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(FlankStates, "_link", rounded)
        data = solve_contact(loads_model(MODEL), torque=20.0, positions=1000)
    return contact_numbers(with_operation(data, Operation(friction=0.06))), data


def test_pairs_force_and_torque(numbers):
    found, data = numbers
    assert float(found["loaded_pairs"][0]) == pytest.approx(1.8032, rel=0.015)
    assert float(data["mesh_force"].mean()) == pytest.approx(2486.0, rel=0.01)
    torque = 20.0 * 43.0 / 17.0 * (1.0 - float(found["loss_share"][0]))
    assert torque == pytest.approx(50.037, rel=1e-3)


def test_maximum_pressure_at_the_start_of_the_rounding(numbers):
    found, data = numbers
    assert float(found["flank_pressure"][0]) * 1e-6 == pytest.approx(4782.0, rel=0.03)
    # on the rounding the pressure continues from there and is higher, although the load decreases: by 3 % per
    # thousandth of a base pitch
    assert found["edge_pressure"][0] > found["flank_pressure"][0]
    flank, edge = (data[name].values[0, :, :, 0] for name in ("pressure", "edge_pressure"))
    place = data["mesh_phase_position"].values[:, None] + data["tooth_pair"].values
    eps = float(np.ptp(data["mark_roll"].values[0])) / (2.0 * np.pi * float(data["base_radius"][0]) / 17.0)
    for end in (0.0, eps):
        inner = np.abs(place - end) < 0.002
        pressures = np.concatenate([flank[inner & np.isfinite(flank)], edge[inner & np.isfinite(edge)]])
        assert pressures.size > 2
        assert np.ptp(pressures) < 0.08 * pressures.max()
