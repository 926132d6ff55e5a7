# SPDX-License-Identifier: Apache-2.0
"""Contact analysis of a mesh in equilibrium with its machine."""

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.on_shafts import solve_contacts_on_shafts
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.flank_models import pair_text


@pytest.mark.parametrize("level", ["rigid", "flexible"])
@pytest.mark.parametrize("torque", ["300 N m", "-300 N m"])
def test_forces_are_those_of_the_roll(level, torque):
    """The same kernels at the same positions: equal but for rounding."""
    model = loads_model(pair_text(f"{{level: {level}, planes: 5}}", torque=torque))
    found = solve_contacts_on_shafts(model, positions=8).meshes["stage"]
    assert found.attrs["force_of_roll"] < 1e-9
    force = found.plane_force[0].sum(["tooth_pair", "plane"])
    assert np.allclose(force, found.mesh_force[0], rtol=1e-12)
    assert float(abs(found.misalignment).max()) > 1e-6


def test_stiff_bearings_give_the_result_on_fixed_axes():
    """Bearings 1e4 times stiffer have no effect. The positions of both analyses are at other phases: means
    over 48 of them differ by less than one part in 48 of the variation over the phase (5 %)."""
    text = pair_text().replace("3e8 N/m", "3e12 N/m").replace("5e8 N/m", "5e12 N/m")
    text = text.replace("1e8 N/m", "1e12 N/m").replace("1e6 N m/rad", "1e10 N m/rad")
    model = loads_model(text)
    on_shafts = solve_contacts_on_shafts(model, positions=48).meshes["stage"]
    fixed = solve_contact(model, torque=float(on_shafts.torque[0]), positions=48)
    loads = [d.line_load[0].sum("tooth_pair").mean("mesh_phase_position") for d in (on_shafts, fixed)]
    assert np.allclose(loads[0], loads[1], rtol=1e-3)
    assert float(abs(on_shafts.misalignment).max()) < 1e-8


def test_a_mesh_without_load_is_refused():
    model = loads_model(pair_text(torque="0 N m"))
    with pytest.raises(SolverError, match="no load"):
        solve_contacts_on_shafts(model, positions=4)
