# SPDX-License-Identifier: Apache-2.0
"""Energy of undamped vibration through several mesh cycles: the conservative levels keep it.

Two bodies that spin under constant torques; the energy is kinetic and elastic energy less the work of the
torques. Limit: 1e-4 of the mean elastic energy per mesh cycle.
"""

import numpy as np
import pytest

from pitchpoint.contact.potential_build import NominalValues, build_potential_table
from pitchpoint.contact.potential_range import TableSize
from pitchpoint.io.contact_table import write_contact_table
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.contact_inputs import contact_inputs
from pitchpoint.solvers.contact_analysis.precompute import (
    PotentialEvaluator,
    TableRequest,
    quantities,
    table_span,
)
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

TORQUE, CYCLES, SPEED = 100.0, 4, 40.0
TEXT = """
gears:
  g1: {{number_of_teeth: 25, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{left}}}
  g2: {{number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{right}}}
bodies:
  a: {{gears: [g1], motion: torsion, inertia: 2e-3 kg m^2}}
  b: {{gears: [g2], motion: torsion, inertia: 4.5e-2 kg m^2}}
meshes:
  stage: {{gears: [g1, g2], backlash: {{normal: 0.05 mm}}, contact: {{level: {contact}, planes: 5}}}}
loads:
  drive: {{body: a, torque: 100 N m}}
  brake: {{body: b, torque: 240 N m}}
"""
TABULATED = "precomputed, file: t.gcp.h5"
HELICAL = {"left": ", helix_angle: 15 deg, hand: left", "right": ", helix_angle: 15 deg, hand: right"}


def model_of(folder, contact, helical):
    helix = HELICAL if helical else {"left": "", "right": ""}
    text = TEXT.format(contact=contact, **helix)
    path = folder / "m.yaml"
    path.write_text(text.replace("gcp.h5, planes: 5", "gcp.h5"), encoding="utf-8")
    return load_model(path)


def write_table(folder, helical):
    """Coarse table of both flanks: its forces are those of its own potential."""
    model, tables = model_of(folder, "flexible", helical), {}
    for name, flank in (("front", 1), ("back", -1)):
        source = PotentialEvaluator(model, "stage", flank)
        span = table_span(source, TableRequest(torque=4.0 * TORQUE))
        nominal = NominalValues(source.flanks.force_of(TORQUE), source.pitch, 0.02)
        tables[name] = build_potential_table(
            source.copy, span, nominal, TableSize(32, 10), quantities(source.pairs), checks=1
        )
    inputs = contact_inputs(model, "stage", model.meshes["stage"].contact)
    write_contact_table(folder / "t.gcp.h5", tables, inputs)


@pytest.mark.each_value
@pytest.mark.parametrize("helical", [False, True], ids=["spur", "helical"])
@pytest.mark.parametrize(
    "contact", ["rigid", "flexible", TABULATED], ids=["rigid", "flexible", "precomputed"]
)
def test_energy_is_kept(tmp_path, contact, helical):
    if contact == TABULATED:
        write_table(tmp_path, helical)
    system = compile_model(model_of(tmp_path, contact, helical))
    state = system.initial_state()
    names = list(system.layout.coordinates)
    a, b = names.index("a.spin"), names.index("b.spin")
    elastic = system.layout.channel("elastic_energy[stage]")
    deflection = system.layout.channel("deflection[stage]")
    r_b = float(system.records["gear_mesh"][0]["r_b1"])
    # pressed to about the mean deflection of the torque, turning without slip
    state.q[a] += (25e-6 + 8e-6 - evaluate.observe(system, state)[deflection]) / r_b
    state.v[a], state.v[b] = SPEED, -SPEED * 25 / 60
    start = state.q.copy()

    def energy(now):
        M = evaluate.matrix(system, now, 1.0, 0.0, 0.0)
        stored = evaluate.observe(system, now)[elastic]
        work = TORQUE * (now.q[a] - start[a]) + 240.0 * (now.q[b] - start[b])
        return 0.5 * now.v @ M @ now.v + stored - work, stored

    first, _ = energy(state)
    run = runge_kutta.start_adaptive(system, state, rtol=1e-9, atol=1e-14, atol_rate=1e-10)
    end = CYCLES * 2.0 * np.pi / 25 / SPEED
    found = []
    for t in np.linspace(0.0, end, 60)[1:]:
        assert run.advance_to(t).status == 1
        found.append(energy(run.state()))
    total, stored = np.transpose(found)
    assert stored.mean() > 1e-3
    assert abs(total - first).max() < 1e-4 * stored.mean() * CYCLES
