# SPDX-License-Identifier: Apache-2.0
"""Fast contact analyses of designs: equal to analyses of the models with these modifications."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.elements.mesh.surface.nodes import ON_PATH
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.relief.analyses import Analyses, Conditions
from pitchpoint.solvers.contact_analysis.relief.curves import BEHIND, Curves, kinks
from pitchpoint.solvers.contact_analysis.relief.variables import Flanks, with_values
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.relief_models import TIP, pair, torque

FLEXIBLE = "level: flexible, planes: 5"
RIGID = "level: rigid, stiffness: 3e8 N/m, exponent: 1.3, planes: 5"
START = "both: {tip_relief: {amount: 8 um, length: 2.5 mm}, lead_crowning: 3 um}"
NEW = {
    TIP.format("pinion", "amount"): 14e-6,
    TIP.format("pinion", "length"): 3.4e-3,
    "gears.wheel.modifications.both.lead_crowning": 5e-6,
    "gears.wheel.modifications.both.tip_relief.amount": 2e-6,
    "gears.pinion.modifications.both.helix_slope": -4e-6,
}
FORCES = (800.0, 2500.0)
CASES = [(0.0, False, 1), (15.0, False, -1), (12.0, True, 1)]


def analysed(model, conditions, values=None, **more):
    """Curves of a model with values by path changed without compiling it again."""
    values = values or {}
    flanks = Flanks(model, "stage", conditions.flank, list(values))
    analyses = Analyses(model, "stage", conditions, flanks.rows(flanks.start), 100e-6, **more)
    return analyses.curves(flanks.rows(np.array(list(values.values()))))


@pytest.mark.parametrize("contact", [FLEXIBLE, RIGID], ids=["flexible", "rigid"])
@pytest.mark.parametrize(("beta", "internal", "flank"), CASES)
def test_a_design_is_the_model_with_its_modifications(contact, beta, internal, flank):
    """Approach, pressure and tip edges of compiled states, to their error of 1e-11 of the force."""
    model = pair(START, START, contact=contact, beta=beta, internal=internal)
    loads = tuple(torque(model, force) for force in FORCES)
    conditions = Conditions(loads, 8, (0.0, 2e-4), flank)
    found = analysed(model, conditions, NEW)
    changed = FlankStates(with_values(model, NEW), "stage", flank)
    for m, kappa in enumerate(conditions.misalignments):
        for t, force in enumerate(FORCES):
            states = changed.states(conditions.phases[:8])
            states["kappa"], states["by_force"], states["force"] = kappa, 1, force
            nodes = changed.solve(states, keep_nodes=True)
            assert found.approach[m, t] == pytest.approx(states["x_0"], rel=1e-9)
            held = np.arange(nodes.shape[1]) < states["n_nodes"][:, None]
            edges = np.where(held & (nodes["place"] != ON_PATH), nodes["force"], 0.0).sum(axis=1)
            assert found.edge[m, t] == pytest.approx(edges / force, abs=1e-8)


CURVED = "both: {profile_crowning: 15 um, lead_crowning: 3 um}"


@pytest.mark.parametrize("contact", [FLEXIBLE, RIGID], ids=["flexible", "rigid"])
@pytest.mark.parametrize(("beta", "internal", "flank"), CASES)
@pytest.mark.parametrize("modified", [START, CURVED], ids=["linear", "crowned"])
def test_pressure_is_that_of_the_contact_analysis(contact, beta, internal, flank, modified):
    """Both without misalignment; the positions of the analysis are half a step before. Crowning adds 4 % to
    the curvature in the middle of the flank, and more near the root."""
    model = pair(modified, modified, contact=contact, beta=beta, internal=internal)
    loads = tuple(torque(model, force) for force in FORCES)
    found = analysed(model, Conditions(loads, 32, flank=flank))
    fine = solve_contact(model, "stage", torque=loads, positions=64, flank=flank)
    pressure = fine["pressure"].max(("tooth_pair", "plane")).values[:, 1::2]
    assert found.pressure[0] == pytest.approx(pressure, rel=1e-8)


@pytest.mark.nojit
def test_a_helix_slope_balances_a_misalignment():
    """kappa b of helix slope on one gear: the same as aligned flanks, shifted by half of it."""
    model = pair(START, START, contact=FLEXIBLE)
    (load,) = (torque(model, 2000.0),)
    kappa = 4e-4
    aligned = analysed(model, Conditions((load,), 8))
    path = "gears.pinion.modifications.both.helix_slope"
    balanced = analysed(model, Conditions((load,), 8, (kappa,)), {path: kappa * 20e-3})
    assert balanced.approach == pytest.approx(aligned.approach, abs=1e-12)


def test_independent_of_threads_and_order():
    model = pair(START, START, contact=FLEXIBLE)
    loads = tuple(torque(model, force) for force in FORCES)
    flanks = Flanks(model, "stage", 1, list(NEW))
    designs = [flanks.rows(np.array(list(NEW.values())) * share) for share in (0.2, 1.0, 0.6, 0.9, 0.2)]
    found = []
    for jobs, order in ((1, 1), (3, 1), (2, -1)):
        analyses = Analyses(model, "stage", Conditions(loads, 8), designs[0], 200e-6, jobs)
        with analyses.pool() as pool:
            found.append([c.points for c in analyses.curves_of(designs[::order], pool)][::order])
    for other in found[1:]:
        for one, two in zip(found[0], other, strict=True):
            assert np.array_equal(one, two, equal_nan=True)
    assert np.array_equal(found[0][0], found[0][4], equal_nan=True)


def test_kinks_of_a_piecewise_linear_curve_are_exact():
    """Roof with its ridge at any place: peak to peak 1 from eight positions that miss it."""
    for ridge in (0.31, 0.5, 0.62):
        place = (np.arange(8) + 0.5) / 8

        def roof(x, ridge=ridge):
            x = x % 1.0
            return np.where(x < ridge, x / ridge, (1.0 - x) / (1.0 - ridge))

        values = np.concatenate([roof(place), roof(place + BEHIND / 8)])[None, None]
        found = Curves.of(values, values, values)
        assert found.peak_to_peak == pytest.approx(np.ones((1, 1)), abs=1e-12)
        assert np.ptp(found.approach) < 0.95


def test_smooth_curves_hardly_change():
    """A cosine over 32 positions: at most c h^2/4 more, with c half of its second derivative."""
    phase = 2.0 * np.pi * np.arange(32) / 32
    values, slopes = np.cos(phase + 0.03), -np.sin(phase + 0.03) * 2.0 * np.pi / 32
    peak = np.nanmax(kinks(values, slopes))
    assert 1.0 < peak < 1.0 + 0.25 * 0.5 * (2.0 * np.pi / 32) ** 2


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ("gears.other.modifications.both.lead_crowning", "is not a modification of a gear of mesh stage"),
        ("gears.wheel.face_width", "is not a modification of a gear of mesh stage"),
        ("gears.pinion.modifications.left.lead_crowning", "has no effect on the loaded flank"),
        ("gears.pinion.modifications.both.tip_relief.shape", "is not a length"),
    ],
)
def test_paths_that_are_refused(path, words):
    with pytest.raises(ModelError, match=words):
        Flanks(pair(START), "stage", 1, [path])


def test_values_stay_within_what_a_flank_can_have():
    """Negative relief is none; a relief is not longer than the flank."""
    model = pair(START)
    paths = [TIP.format("pinion", "amount"), TIP.format("pinion", "length")]
    flanks = Flanks(model, "stage", 1, paths)
    none = flanks.rows(np.array([-1e-6, 2e-3]))
    assert np.array_equal(none, flanks.rows(np.array([0.0, 2e-3])))
    assert np.array_equal(
        flanks.rows(np.array([1e-6, 1.0])), flanks.rows(np.array([1e-6, flanks.limits[1, 1]]))
    )


def test_missing_modifications_are_created_together():
    model = with_values(
        pair(),
        {
            TIP.format("pinion", "amount"): "12 um",
            TIP.format("pinion", "length"): 2e-3,
            "gears.pinion.modifications.both.lead_crowning": 4e-6,
            "gears.wheel.modifications.left.profile_slope": "1 um",
        },
    )
    both = model.gears["pinion"].modifications.both
    assert (both.tip_relief.amount, both.tip_relief.length) == (12e-6, 2e-3)
    assert both.lead_crowning == 4e-6
    assert model.gears["wheel"].modifications.left.profile_slope == 1e-6
    with pytest.raises(ModelError, match="tip_reliev"):
        with_values(pair(), {"gears.pinion.modifications.both.tip_reliev.amount": 1e-6})


def test_a_stiffness_law_is_refused():
    model = pair(START).replace("meshes.stage.contact", None)
    with pytest.raises(SolverError, match="no contact of tooth surfaces"):
        analysed(model, Conditions((100.0,), 8))
