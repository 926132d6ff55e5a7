# SPDX-License-Identifier: Apache-2.0
"""A blade of finite elements on a hub that turns: what the spin adds to its stiffness, from its file."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.io import mmwrite
from scipy.sparse import csc_array

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.multibody.beam_section import Beam, Section
from pitchpoint.multibody.structure import beam_line
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.beam_modes import axial_stiffening

PIECES, STEP = 16, 2e-3
BLADE = """\
gravity: [0, 0, -0.01]
bodies:
  hub: {mass: 1 kg, inertia: 1 kg m^2, transverse_inertia: 1 kg m^2}
elastic_bodies:
  blade:
    file: blade.npz
    nodes: {root: {}, tip: {position: [1, 0, 0]}}
    rotor: true
    modes: 12
    static_shapes: true
joints:
  axle: {type: revolute, bodies: [ground, hub], position: [0, 0, 0]}
  clamp: {type: fixed, bodies: [hub, blade.root]}
scenarios:
  turn: {drive: {hub: {speed: SPEED rad/s}}, start: assembled, duration: 8 s, step: 2 ms, settle_time: 0 s}
"""
THREE = (
    "stiffness_file: k.mtx\n    mass_file: m.mtx\n    place_file: places.txt\n    spin_stiffness_file: s.mtx"
)


def write_blade(folder, stiffened=True):
    """Uniform thin blade of length 1 along x that turns about z, with E I = rho A = 1."""
    thin = Section(A=1e-2, I_1=1e-8, I_2=1e-8, J=2e-8, kappa_1=0.0, kappa_2=0.0)
    beams = [Beam(section=thin, length=1.0 / PIECES, E=1e8, G=4e13, rho=1e2)] * PIECES
    line = beam_line(beams)
    P = np.roll(np.eye(3), 1, axis=0)  # z, x, y of the line are x, y, z of the blade
    T = np.kron(np.eye(2 * (PIECES + 1)), P)
    data = {"K": T @ line.K.toarray() @ T.T, "M": T @ line.M.toarray() @ T.T}
    if stiffened:
        data["K_spin"] = T @ axial_stiffening(beams, line)[4] @ T.T  # that of a spin about y of the line
    places = line.places @ P.T
    np.savez(folder / "blade.npz", places=places, **data)
    for name, key in (("k", "K"), ("m", "M"), ("s", "K_spin")):
        if key in data:
            mmwrite(folder / f"{name}.mtx", csc_array(data[key]), symmetry="symmetric")
    (folder / "places.txt").write_text("\n".join(" ".join(map(repr, p)) for p in places.tolist()))


def blade_with(folder, text):
    file = folder / "blade.yaml"
    file.write_text(text, encoding="utf-8")
    return load_model(file)


def flapping(model):
    """Lowest two angular frequencies of the tip out of the plane, released from rest in a small weight.

    From 6 s of motion by the eigenvalues of its shift matrix of rank 8.
    """
    begin = prepare_start(compile_model(model, "turn"), model.scenarios["turn"])
    run = generalized_alpha.start(begin.system, begin.state, STEP)
    tip = begin.system.layout.bodies.index("blade.tip")
    z = []
    for _ in range(1500):
        run.advance(2)
        evaluate.residual(begin.system, run.state())
        z.append(begin.system.workspace.fr[tip]["r"][2])
    rows = np.lib.stride_tricks.sliding_window_view(np.array(z), 500)
    V = np.linalg.svd(rows, full_matrices=False)[2][:8]
    shift = np.linalg.eigvals(V[:, 1:] @ np.linalg.pinv(V[:, :-1]))
    rates = np.sort(np.abs(np.log(shift.astype(complex)).imag) / (2 * STEP))
    return rates[rates > 0.5][[0, 2]]  # in pairs


@pytest.mark.parametrize(
    ("speed", "first", "second"),
    [(0, 3.5160, 22.0345), pytest.param(2, 4.1373, 22.6149, marks=pytest.mark.study), (6, 7.3604, 26.8091)],
)
def test_a_blade_stiffens_as_it_turns(tmp_path, speed, first, second):
    """Wright, Smith, Thresher, Wang, J. Appl. Mech. 49 (1982) 197-202, Table 1, hub radius 0; to 1e-3.

    Twelve modes and elements with a constant tension make the error. Nodes must not move by products of the
    turns of modes: the tension of 18 N at the root would make a stiffness of them.
    """
    write_blade(tmp_path)
    found = flapping(blade_with(tmp_path, BLADE.replace("SPEED", str(speed))))
    assert found[0] == pytest.approx(first, rel=1e-3)
    assert found[1] == pytest.approx(second, rel=1e-3)


def test_matrix_market_has_the_same_and_without_it_the_blade_is_softer(tmp_path):
    write_blade(tmp_path)
    text = BLADE.replace("SPEED", "6")
    wanted = compile_model(blade_with(tmp_path, text)).records["flexible_body"]["geo"]
    found = compile_model(blade_with(tmp_path, text.replace("file: blade.npz", THREE)))
    # the lowest modes come in pairs of one frequency, whose axes are free: eigenvalues are compared
    one, two = (np.linalg.eigvalsh(x[0, 5]) for x in (found.records["flexible_body"]["geo"], wanted))
    np.testing.assert_allclose(one, two, rtol=1e-6, atol=1e-9 * np.abs(two).max())
    write_blade(tmp_path, stiffened=False)
    model = blade_with(tmp_path, text)
    assert not compile_model(model).records["flexible_body"]["geo"].any()
    assert flapping(model)[0] < 6.8


def test_a_wrong_stiffness_by_spin_is_told(tmp_path):
    write_blade(tmp_path)
    text = BLADE.replace("SPEED", "6")
    with np.load(tmp_path / "blade.npz") as arrays:
        data = dict(arrays)
    np.savez(tmp_path / "blade.npz", **{**data, "K_spin": np.eye(5)})
    with pytest.raises(ModelError, match="K has 102 displacements, K_spin has 5"):
        compile_model(blade_with(tmp_path, text))
    with pytest.raises(ModelError, match=r"spin_stiffness_file \(line 10\): cannot be combined with"):
        blade_with(tmp_path, text.replace("modes: 12", "modes: 12\n    spin_stiffness_file: s.mtx"))
