# SPDX-License-Identifier: Apache-2.0
"""Levels of contact of one mesh: the element against the contact analysis, fits, cost and error."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.potential_range import TableSize
from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.law_fit import fit_analytic_law
from pitchpoint.solvers.contact_analysis.levels import ROWS, compare_levels
from pitchpoint.solvers.contact_analysis.mesh_path import MeshPath
from tests.support.contact_files import fzg, helical

K = 2.338e8
PHASE = np.linspace(0.0, 0.98, 15)


@pytest.mark.parametrize("level", ["rigid", "flexible"])
@pytest.mark.parametrize("pair", [fzg, helical])
@pytest.mark.parametrize("flank", [1, -1])
def test_the_element_has_the_forces_of_the_contact_analysis(tmp_path, pair, level, flank):
    """Same phase, same approach, same tilt of the housing: forces of the element and of the static states."""
    model = pair(tmp_path).replace("meshes.stage.misalignment", {"in_plane": 2e-4, "out_of_plane": -4e-4})
    if level == "flexible":
        model = model.replace("meshes.stage.contact", {"level": "flexible", "planes": 5})
    # the flanks differ by relief, and by the offset of helical gears
    side = {"tip_relief": {"amount": 8e-6, "length": 2e-3}}
    model = model.replace("gears.g1.modifications", {"right": side}).replace("bodies.a.gears", {"g1": "1 mm"})
    path, flanks = MeshPath(model, "stage", flank), FlankStates(model, "stage", flank)
    states = flanks.states(PHASE)
    states["x_0"] = 2e-5
    flanks.solve(states)
    force, stiffness = path.forces(PHASE, 2e-5)
    assert force == pytest.approx(states["force"], rel=1e-8)
    assert stiffness == pytest.approx(states["stiffness"], rel=1e-7)


def test_approaches_carry_the_force(tmp_path):
    model = fzg(tmp_path)
    path = MeshPath(model, "stage")
    x = path.approaches(PHASE, 5000.0, 1e-5)
    assert path.forces(PHASE, x)[0] == pytest.approx(np.full(PHASE.size, 5000.0), rel=1e-9)


@pytest.mark.parametrize("pair", [fzg, helical])
def test_rigid_contact_is_a_law_with_a_constant_stiffness(tmp_path, pair):
    """Rigid contact of stiffness k has S_R = 1 and c' = k cos² β_b/b.

    Tip edges carry a share that vanishes with the torque: 1e-3 N m deflects by 1e-10 m, over which a tip edge
    is in contact 1e-4 base pitches beyond A and E.
    """
    model = pair(tmp_path, k=K)
    fit = fit_analytic_law(model, torque=1e-3)
    pair_ = model.pairs["stage"]
    assert fit.S_R == pytest.approx(1.0, abs=1e-9)
    assert fit.T_R == 0.0
    assert fit.pair_error < 1e-9
    assert fit.c_prime == pytest.approx(K * math.cos(pair_.gear1.beta_b) ** 2 / pair_.b_w, rel=2e-3)
    assert fit.rigid_stiffness == pytest.approx(K, rel=1e-9)
    assert fit.rigid_error[1] < 1e-9


@pytest.mark.parametrize("stiffness", [(14e9, 0.8), (9e9, 0.35)])
def test_a_parabola_is_found_exactly(tmp_path, stiffness, monkeypatch):
    """Node forces of a law with S_R and T_R give its coefficients back."""
    from pitchpoint.solvers.contact_analysis import law_fit

    c_prime, S_R = stiffness
    real = law_fit._loaded_nodes

    def of_law(flanks, force):
        """Nodes on the path with the forces of the law."""
        nodes, eps = real(flanks, force)
        inside = np.isfinite(nodes.place) & (nodes.place >= 0.0) & (nodes.place <= eps)
        p, x = nodes.place[inside], nodes.x[inside]
        load = c_prime * nodes.plane * x * law_fit._along(p, eps, S_R, 0.25)
        # the mesh force of a phase is the sum of its nodes
        scale = force / np.bincount(nodes.phase[inside], load, law_fit.POSITIONS)[nodes.phase[inside]]
        return law_fit._Nodes(nodes.phase[inside], p, x * scale, load * scale, nodes.plane), eps

    monkeypatch.setattr(law_fit, "_loaded_nodes", of_law)
    fit = fit_analytic_law(fzg(tmp_path, k=K), torque=302.0)
    assert (fit.S_R, fit.T_R) == pytest.approx((S_R, 0.25), abs=1e-9)
    assert fit.c_prime == pytest.approx(c_prime, rel=1e-9)
    assert fit.pair_error < 1e-9
    assert fit.mesh_error[1] < 1e-9


@pytest.mark.study
def test_levels_of_the_back_flanks(tmp_path):
    """Mirrored teeth: the back flanks with a relief have the numbers of front flanks with the same relief."""
    found = {}
    for flank, side in ((1, "left"), (-1, "right")):
        relief = {side: {"tip_relief": {"amount": 30e-6, "length": 2e-3}}}
        model = fzg(tmp_path, k=K, planes=3).replace("gears.g1.modifications", relief)
        model = model.replace("meshes.stage.contact", {"level": "flexible", "planes": 2})
        size = TableSize(phase=8, approach=6, misalignment=3)
        found[flank] = compare_levels(
            model, torque=302.0, positions=8, size=size, flank=flank, misalignment=1e-4
        )
        assert found[flank].misalignment == pytest.approx(1e-4, rel=1e-12)
    front, back = found[1], found[-1]
    assert (front.fit.flank, back.fit.flank) == (1, -1)
    for level in ROWS:
        for name in ("te_mean", "te_pp", "stiffness", "force_rms", "force_max"):
            one, two = (getattr(levels.numbers[level], name) for levels in (front, back))
            assert two == pytest.approx(one, rel=1e-6, abs=1e-12), (level, name)
    assert back.fit.c_prime == pytest.approx(front.fit.c_prime, rel=1e-6)


def test_levels_against_flexible_contact(tmp_path):
    """FZG gears type C at 302 N m. The bounds follow from the physics of each level.

    A small table is within 2 % of the force at any state, its mean TE within 1e-3. A constant stiffness and
    the parabola have neither the coupling of the pairs nor contact of tip edges: 10 % rms; both have the mean
    TE and stiffness within 10 %, because they are fitted to the mesh force.
    """
    model = fzg(tmp_path).replace("meshes.stage.contact", {"level": "flexible", "planes": 5})
    found = compare_levels(model, torque=302.0, positions=32, size=TableSize(phase=32, approach=12))
    assert tuple(found.numbers) == ROWS
    exact = found.numbers["flexible"]
    assert (exact.force_rms, exact.force_max) == (0.0, 0.0)
    table = found.numbers["precomputed"]
    assert table.te_mean == pytest.approx(exact.te_mean, rel=1e-3)
    assert table.te_pp == pytest.approx(exact.te_pp, rel=2e-2)
    assert table.force_max < 0.02
    for level in ("rigid", "law"):
        one = found.numbers[level]
        assert one.te_mean == pytest.approx(exact.te_mean, rel=0.1)
        assert one.stiffness == pytest.approx(exact.stiffness, rel=0.1)
        assert 0.0 < one.force_rms < 0.15
    assert found.table == "computed"
    assert all(one.evaluation_s > 0.0 and one.setup_s > 0.0 for one in found.numbers.values())


def test_what_is_refused(tmp_path):
    model = fzg(tmp_path)
    with pytest.raises(SolverError, match="torque 0"):
        fit_analytic_law(model, torque=0.0)
    with pytest.raises(SolverError, match="torque nan"):
        compare_levels(model, torque=math.nan)
    law = model.replace("meshes.stage.contact", None)
    with pytest.raises(SolverError, match="rigid or flexible contact"):
        fit_analytic_law(law, torque=100.0)
