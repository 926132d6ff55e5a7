# SPDX-License-Identifier: Apache-2.0
"""Models of many bodies: work that grows with their number, not with its square, and limits that are said."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError, ModelError
from pitchpoint.io.container import Header
from pitchpoint.io.container import ResultError as TooMany
from pitchpoint.io.writing import MAX_CHANNELS, Channel, ResultWriter
from pitchpoint.model.checks.mobility import alone, tree_of, yielding
from pitchpoint.model.parts import Parts
from pitchpoint.model.remarks.collect import warn_of_remarks
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import free_spins
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.null_space import null_space
from pitchpoint.system.compile import compile_model
from pitchpoint.system.layout import products
from tests.support.mechanism_files import model_of, random_chain

HEAVY = {"mass": 1.0, "inertia_tensor": [0.01, 0.02, 0.03, 0.0, 0.0, 0.0]}


def free_bodies(n):
    """Bodies on bushings, each for itself."""
    stiffness = {"radial": 1e5, "axial": 1e5, "tilt": 1e3, "torsion": 1e3}
    return {
        "bodies": {f"b{k}": HEAVY | {"motion": "free", "position": [0.2 * k, 0.0, 0.0]} for k in range(n)},
        "bushings": {f"s{k}": {"ends": [f"b{k}", "ground"], "stiffness": stiffness} for k in range(n)},
        "scenarios": {"run": {"duration": 0.1}},
    }


def joined_bodies(n, backwards=False):
    """A chain of bodies from ground, joints in its order or against it."""
    bodies = {f"b{k}": HEAVY | {"markers": {"end": {"position": [0.1, 0.0, 0.0]}}} for k in range(n)}
    bodies["b0"] = bodies["b0"] | {"position": [0.0, 0.0, 0.0]}
    ends = [("ground" if k == 0 else f"b{k - 1}.end", f"b{k}") for k in range(n)]
    joints = {f"j{k}": {"type": "revolute", "bodies": list(pair)} for k, pair in enumerate(ends)}
    return {"bodies": bodies, "joints": dict(reversed(joints.items())) if backwards else joints}


def gear_chain(n):
    """Gears in mesh one after another."""
    wheel = {
        "number_of_teeth": 20,
        "normal_module": 0.003,
        "face_width": 0.02,
        "profile_shift_coefficient": 0.0,
    }
    law = {"law": "fourier", "mean": 3e8}
    return {
        "gears": {f"g{k}": wheel for k in range(n)},
        "bodies": {f"w{k}": {"gears": [f"g{k}"], "motion": "torsion"} for k in range(n)},
        "meshes": {f"m{k}": {"gears": [f"g{k}", f"g{k + 1}"], "stiffness": law} for k in range(n - 1)},
        "scenarios": {"run": {"speed": {f"w{k}": 100.0 * (-1.0) ** k for k in range(n)}, "duration": 0.1}},
    }


def loaded_pairs(n):
    """Pairs of gears that have nothing to do with each other, all loaded."""
    train = gear_chain(2 * n)
    for k in range(1, n):
        del train["meshes"][f"m{2 * k - 1}"]
    train["bodies"] = {
        name: body | ({"position": [0.0, 0.2 * k, 0.0]} if k % 2 == 0 else {})
        for k, (name, body) in enumerate(train["bodies"].items())
    }
    loads = {f"i{k}": {"body": f"w{2 * k}", "torque": 10.0} for k in range(n)}
    loads |= {f"o{k}": {"body": f"w{2 * k + 1}", "torque": "balance"} for k in range(n)}
    return train | {"loads": loads, "scenarios": {}}


def shafts(n):
    """Elastic shafts on two bearings each, which all turn."""
    section = [{"length": 0.2, "diameter": 0.04}]
    seats = {"a": ([0.0, 0.0, 0.01], {"radial": 2e8, "axial": 1e8}), "b": ([0.0, 0.0, 0.19], {"radial": 2e8})}
    return {
        "shafts": {f"s{k}": {"sections": section, "position": [0.1 * k, 0.0, 0.0]} for k in range(n)},
        "bearings": {
            f"{side}{k}": {"body": f"s{k}", "position": at, "stiffness": stiffness}
            for k in range(n)
            for side, (at, stiffness) in seats.items()
        },
        "scenarios": {"run": {"speed": {f"s{k}": 100.0 for k in range(n)}, "duration": 0.1}},
    }


def calls(work):
    """How many functions of Python a piece of work calls; generators count whenever they go on."""
    count = 0

    def note(frame, event, argument):
        """Count a call."""
        nonlocal count
        count += event == "call"

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(before)
    return count


@pytest.mark.parametrize("make", [free_bodies, joined_bodies, gear_chain, shafts], ids=lambda f: f.__name__)
@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
def test_reading_and_checking_take_as_many_calls_as_there_are_bodies(make):
    """Twice the bodies, twice the calls: a look-up that goes through all of them would make it four times."""

    def read(n):
        """Read, settle, check and remark upon a model."""
        warn_of_remarks(model_of(make(n)))

    read(3)  # what is made once
    few, more, many = (calls(lambda n=n: read(n)) for n in (12, 24, 48))
    assert many - more < 2.2 * (more - few)


def test_a_chain_hangs_the_same_in_whichever_order_its_joints_stand():
    """Also one that is deeper than functions may call themselves."""
    n = 1100
    one, two = (model_of(joined_bodies(n, backwards)) for backwards in (False, True))
    assert list(one.mechanism.seats) == list(two.mechanism.seats) == [f"b{k}" for k in range(n)]
    for k in (1, 700, n - 1):
        assert one.mechanism.seats[f"b{k}"].parent == two.mechanism.seats[f"b{k}"].parent == f"b{k - 1}"
        assert one.bodies[f"b{k}"].origin == pytest.approx((0.1 * k, 0.0, 0.0))
        assert two.bodies[f"b{k}"].origin == pytest.approx((0.1 * k, 0.0, 0.0))
    assert one.mechanism.carried_by("b1097") == ["b1098", "b1099"] and not one.mechanism.carried_by("b1099")


def mass_matrix(links):
    """Sum over all bodies of mass and inertia times the motions by every two coordinates on the way there."""
    width = sum(len(link.own) for link in links)
    first = np.cumsum([0, *(len(link.own) for link in links)])
    M, motion = np.zeros((width, width)), []
    for k, link in enumerate(links):
        way = {} if link.parent < 0 else dict(motion[link.parent])
        way |= {first[k] + i: column for i, column in enumerate(link.own)}
        motion.append(way)
        v = {c: shift + np.cross(turn, link.center - at) for c, (shift, turn, at) in way.items()}
        for c in way:
            for d in way:
                M[c, d] += link.mass * (v[c] @ v[d]) + way[c][1] @ link.about @ way[d][1]
    return M


def links_of_model(model):
    """Bodies and joints of a model as the check of its inertia sees them."""
    parts = Parts.of({name: getattr(model, name) for name in ("bodies", "joints", "gears")})
    parts.mechanism = model.mechanism
    return tree_of(parts)


@pytest.mark.parametrize("seed", range(4))
def test_inertia_of_single_coordinates_is_the_diagonal_of_the_mass_matrix(seed):
    rng = np.random.default_rng(seed)
    types = rng.choice(["revolute", "prismatic", "cylindrical", "screw", "spherical", "universal"], 7)
    parents = [0, *(int(rng.integers(0, k + 1)) for k in range(1, 7))]
    links = links_of_model(model_of(random_chain(rng, types, parents)))
    M = mass_matrix(links)
    assert [value for _, value in alone(links)] == pytest.approx(M.diagonal().tolist(), rel=1e-12)
    assert not yielding(links) and np.linalg.eigvalsh(M)[0] > 0.0


def test_a_motion_without_inertia_is_a_vector_that_the_mass_matrix_takes_to_zero():
    """A body without mass between two hinges on one axis; what hangs on the second one stays where it is."""
    model = model_of(joined_bodies(4))
    links = links_of_model(model)
    axis = links[2].own[0]
    links[1].mass, links[1].own = 0.0, [axis]
    links[1].felt[:] = links[1].locked[:] = 0.0
    links[1].about = np.zeros((3, 3))
    found = dict(yielding(links))
    M = mass_matrix(links)
    x = np.array([found.get(name, 0.0) for link in links for name in link.names])
    assert np.abs(x).max() > 0.1 and x[3] == pytest.approx(0.0, abs=1e-12 * np.abs(x).max())
    assert x[1] == pytest.approx(-x[2]) and x[0] == 0.0
    assert np.abs(M @ x).max() < 1e-14 * np.abs(x).max()


def test_a_long_chain_has_inertia_however_badly_its_mass_matrix_is_conditioned():
    """Its least eigenvalue falls with the fourth power of the length; nothing is wrong with it, though.

    A body without inertia in its middle is still found.
    """
    n = 300
    assert len(model_of(joined_bodies(n)).bodies) == n
    data = joined_bodies(n)
    data["bodies"]["b150"] = {"markers": {"end": {"position": [0.0, 0.0, 0.0]}}}
    with pytest.raises(ModelError, match=r"has no inertia in a combined motion of j150\.spin and j151\.spin"):
        model_of(data)


@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
def test_products_of_joints_are_counted_before_the_matrix_is_laid_out():
    system = compile_model(model_of(joined_bodies(9)))
    assert (
        products(system.program["body"], set())
        == system.program["proj"].size
        == sum(k * k for k in range(10))
    )
    meshed = compile_model(model_of(gear_chain(4)))
    pairs = {(k, k + 1) for k in range(1, 4)}
    assert products(meshed.program["body"], pairs) == meshed.program["proj"].size == 4 + 2 * 3


@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
def test_a_chain_of_too_many_joints_is_refused_with_the_number_and_the_remedy():
    with pytest.raises(
        CompileError,
        match=r"b399: is at the end of a chain of 400 joints.* 2\.1e\+07 .*limit 1\.2e\+07\); .*bushings",
    ):
        compile_model(model_of(joined_bodies(400)))


def test_a_run_of_too_many_channels_is_refused_before_its_file_is_made(tmp_path):
    target = tmp_path / "run.h5"
    channels = [Channel(f"speed[b{k}]", "rad/s") for k in range(MAX_CHANNELS + 1)]
    with pytest.raises(
        TooMany,
        match=r"run\.h5: the run has 6001 channels, .*limit 6000\); choose which to store: channels: ",
    ):
        ResultWriter(target, Header("time"), channels)
    assert not target.exists()


def test_trains_of_many_gears_have_one_free_rotation_and_bodies_on_bushings_none():
    assert len(free_spins(compile_model(model_of(gear_chain(4))))) == 1
    assert free_spins(compile_model(model_of(free_bodies(5)))) == ()


def test_free_rotations_of_a_train_of_20_000_gears():
    """Gear k turns against gear k + 1 by the teeth z; ends of the basis differ by the whole ratio."""
    z = [20 + k % 7 for k in range(20_000)]
    found = null_space([{k: float(z[k]), k + 1: float(z[k + 1])} for k in range(len(z) - 1)], range(len(z)))
    assert len(found.groups) == 1
    basis = found.groups[0][1]
    assert basis.shape == (20_000, 1)
    assert basis[-1, 0] / basis[0, 0] == pytest.approx(-z[0] / z[-1], rel=1e-9)


def test_independent_trains_go_through_their_mesh_cycles_together(monkeypatch):
    """As many equilibria for six pairs as for two: the time for n pairs does not grow with n squared."""
    from pitchpoint.solvers import cycle_means

    calls = []

    def count(*given, **options):
        """Find the equilibrium and count it."""
        calls.append(1)
        return find_equilibrium(*given, **options)

    monkeypatch.setattr(cycle_means, "find_equilibrium", count)
    found, counts = [], []
    for n in (2, 6):
        calls.clear()
        found.append(find_modes(compile_model(model_of(loaded_pairs(n)))).frequency[-1])
        counts.append(len(calls))
    assert counts[0] == counts[1] > 0
    assert found[0] == pytest.approx(found[1], rel=1e-9)


def test_matrices_of_gigabytes_are_refused_with_their_size(monkeypatch):
    monkeypatch.setattr("pitchpoint.solvers.linear_system.MAX_COORDINATES", 11)
    with pytest.raises(CompileError, match=r"has 12 coordinates, .* 1\.2e-06 GB \(limit 11 coordin"):
        find_modes(compile_model(model_of(free_bodies(2))))
