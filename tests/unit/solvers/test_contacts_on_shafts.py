# SPDX-License-Identifier: Apache-2.0
"""Contact analyses of all meshes of a machine in equilibrium."""

import numpy as np
import pytest

from pitchpoint.analysis.flank_contact.load_factors import load_over_width
from pitchpoint.core.errors import SolverError, split_notes
from pitchpoint.core.status import DIVERGED
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.on_shafts import solve_contacts_on_shafts
from pitchpoint.solvers.contact_analysis.torque_balance import torque_of_train
from tests.support.contact_trains import double_helical, planets, two_stages
from tests.support.planet_stages import stage_file

N = 8


@pytest.fixture(scope="module")
def gearbox():
    model = loads_model(two_stages())
    return model, solve_contacts_on_shafts(model, positions=N)


def test_every_mesh_is_that_of_its_own_analysis(gearbox):
    """The same system, roll and kernels: the same bits."""
    model, found = gearbox
    assert list(found.meshes) == ["fast", "slow"]
    for name, data in found.meshes.items():
        alone = solve_contacts_on_shafts(model, [name], positions=N).meshes[name]
        for key, values in alone.variables.items():
            assert np.array_equal(values, data[key], equal_nan=values.dtype.kind == "f"), key


def test_torques_balance_on_every_shaft(gearbox):
    """Input 250 N m; on the middle shaft the torques of both meshes are opposite. Axes are tilted by 1e-3
    at most, and the means are over 8 positions each, of variations of 1 %: 2e-3."""
    _, found = gearbox
    fast, slow = (float(found.meshes[name].torque[0]) for name in ("fast", "slow"))
    assert fast == pytest.approx(250.0, rel=2e-3)
    assert slow == pytest.approx(fast * 71.0 / 23.0, rel=2e-3)
    assert [found.meshes[name].attrs["force_of_roll"] < 1e-9 for name in found.meshes] == [True, True]


def test_positions_are_not_those_of_a_slow_roll_in_the_scenario(gearbox):
    """The scenario rolls 3 points over two periods."""
    model, found = gearbox
    rolled = solve_contacts_on_shafts(model, ["slow"], scenario="slow_roll", positions=N)
    assert np.array_equal(rolled.meshes["slow"].mesh_force, found.meshes["slow"].mesh_force)


def test_symmetric_arrangement():
    """Both halves of a double helical pair carry the same load, mirrored about the plane of symmetry."""
    found = solve_contacts_on_shafts(loads_model(double_helical()), positions=N)
    loads = [load_over_width(found.meshes[name])[0] for name in ("m0", "m1")]
    assert np.ptp(loads[0]) > 0.02 * loads[0].mean()  # tilted by the bending of the shafts
    # the pinion is held by 1e3 N/m along its axis, 1e-6 of the meshes
    assert loads[0] == pytest.approx(loads[1][::-1], rel=1e-5)
    total = sum(float(data.torque[0]) for data in found.meshes.values())
    assert total == pytest.approx(500.0, rel=2e-3)


def test_load_sharing_of_planets():
    """Planets without errors share the torque equally. A pin error of 10 and 20 µm along the circle of the
    pins takes load from its planet in proportion, as long as all carry load; the two others take half of it
    each. Stiffness varies with the load by a few per cent."""
    shares = []
    for pin in (0.0, 10e-6, 20e-6):
        found = solve_contacts_on_shafts(loads_model(planets(pin)), positions=N)
        torques = np.array([float(found.meshes[f"s{k}"].torque[0]) for k in range(3)])
        ring = np.array([float(found.meshes[f"r{k}"].torque[0]) for k in range(3)])
        assert ring * 21.0 / 39.0 == pytest.approx(torques, rel=2e-3)
        shares.append(torques / torques.sum() - 1.0 / 3.0)
    assert shares[0] == pytest.approx(0.0, abs=1e-6)
    lost = [share[0] for share in shares]
    assert -0.1 > lost[2] > -1.0 / 3.0
    assert lost[2] / lost[1] == pytest.approx(2.0, rel=0.05)
    for share in shares[1:]:
        assert share[1:] == pytest.approx(-0.5 * share[0], rel=0.02)


def test_a_planet_without_load_is_omitted_for_its_pin_error():
    """A pin that is 0.1 mm ahead; loads on both sides of its meshes would not change it."""
    contact = "contact: {level: rigid, stiffness: 3e8 N/m, planes: 1}, backlash: {normal: 0.4 mm}"
    text = stage_file("planets: 3\npin_errors: {planet_1: {tangential: 100 um}}", mesh=contact)
    found = solve_contacts_on_shafts(loads_model(text), positions=4)
    assert "sun-planet_2" in found.meshes
    assert found.omitted.keys() == {"sun-planet_1", "planet_1-ring"}
    assert all("errors of the pins exceed" in reason for reason in found.omitted.values())


def test_a_failure_keeps_the_other_meshes(gearbox, monkeypatch):
    solve = FlankStates.solve

    def failing(self, states, keep_nodes=False):
        nodes = solve(self, states, keep_nodes)
        if self.mesh == "fast":
            states["status"][3] = DIVERGED
        return nodes

    monkeypatch.setattr(FlankStates, "solve", failing)
    with pytest.raises(SolverError, match=r"^mesh fast: the Newton iteration diverged$") as caught:
        solve_contacts_on_shafts(gearbox[0], positions=4)
    assert caught.value.status == DIVERGED
    assert list(caught.value.partial.meshes) == ["slow"]
    assert list(caught.value.partial.failed) == ["fast"]


def test_what_is_omitted():
    """Meshes with a stiffness law and meshes without load; given by name they are errors."""
    model = loads_model(two_stages("stiffness: {law: din3990}"))
    found = solve_contacts_on_shafts(model, positions=4)
    assert list(found.meshes) == ["slow"]
    assert found.omitted == {"fast": "it has a stiffness law; give the mesh `contact: {level: flexible}`"}
    with pytest.raises(SolverError, match="mesh fast: it has a stiffness law"):
        solve_contacts_on_shafts(model, ["fast"])
    with pytest.raises(SolverError, match=r"no mesh 'slo'; did you mean slow\?"):
        solve_contacts_on_shafts(model, ["slo"])
    idle = two_stages().replace(
        "output, torque: balance, position: [0, 0, 200 mm]", "middle, torque: balance"
    )
    found = solve_contacts_on_shafts(
        loads_model(idle.replace("gears: [z3, z4]", "gears: [z3, z4], backlash: {normal: 0.2 mm}")),
        positions=4,
    )
    assert list(found.meshes) == ["fast"]
    assert "carries no load" in found.omitted["slow"]
    # without backlash its teeth wedge, as the load bends the shaft towards the wheel
    found = solve_contacts_on_shafts(loads_model(idle), ["slow"], positions=4)
    wedged = split_notes(found.meshes["slow"].attrs["notes"])[0]
    assert wedged.startswith("mesh slow: front and back flanks touch at 4 of 4 positions, so that ")
    assert wedged.endswith(": give the mesh backlash")


def test_rounding_is_no_load():
    """Without torques the flanks keep forces of some 1e-8 N, which would have a pressure and K_Hβ."""
    model = loads_model(two_stages().replace("torque: 250 N m", "torque: 0 N m"))
    with pytest.raises(SolverError, match="meshes fast and slow: they carry no load") as caught:
        solve_contacts_on_shafts(model, positions=4)
    assert not caught.value.partial.meshes


def test_what_has_no_equilibrium_names_the_mesh_and_a_coordinate():
    """Where an iteration that diverges has its largest rest depends on the rounding of the processor."""
    model = loads_model(two_stages().replace("torque: 250 N m", "torque: 1e8 N m"))
    where = r"are unbalanced on (input|middle|output)\.\d\.(x|y|z|alpha|beta|spin) \(line \d+\)"
    with pytest.raises(SolverError, match=rf"^mesh fast: no equilibrium found after \d+ steps: .* {where}"):
        solve_contacts_on_shafts(model, ["fast"], positions=4)


def test_torque_from_the_train():
    """T_1 z_2 = T_2 z_1 through both stages; planets share by their deflections."""
    model = loads_model(two_stages())
    assert torque_of_train(model, "fast") == pytest.approx(250.0, rel=1e-12)
    assert torque_of_train(model, "slow") == pytest.approx(-250.0 * 71.0 / 23.0, rel=1e-12)
    with pytest.raises(SolverError, match="its share of the load depends on deflections"):
        torque_of_train(loads_model(planets()), "s0")
    with pytest.raises(SolverError, match="the torques of the loads do not balance"):
        torque_of_train(model.replace("loads.brake.torque", -1000.0), "slow")
    with pytest.raises(SolverError, match="the torque of the load motor is not constant"):
        torque_of_train(model.replace("loads.motor.torque", "10*t"), "slow")
