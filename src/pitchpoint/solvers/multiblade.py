# SPDX-License-Identifier: Apache-2.0
"""Modes of a turning rotor with blades in multi-blade coordinates.

The mass, damping and stiffness of a bladed rotor on a flexible support change with its azimuth psi. With
coordinates of the whole rotor instead of those of each blade (Coleman and Feingold 1958),

    q_k = a_0 + sum_n (a_n cos n psi_k + b_n sin n psi_k) + (-1)^k d    (d for an even number of blades),

q = T(psi) z, the matrices are constant if all blades are equal and the air and the support are those of an
isotropic rotor: M T'' z + ... gives

    M_z = T^T M T,   D_z = T^T (D T + 2 M T'),   K_z = T^T (K T + D T' + M T''),   T' = Omega dT/dpsi.

Weight, tilt and wind shear make them periodic; the mean over some azimuths neglects their harmonics, as is
usual (Bir 2008, Hansen 2003). The coordinates of a blade are compared with those of the first one by the
motions of its bodies in axes that are turned with the blade.

References
----------
.. [1] R. P. Coleman, A. M. Feingold: Theory of self-excited mechanical oscillations of helicopter rotors with
   hinged blades, NACA Report 1351, 1958.
.. [2] G. Bir: Multi-blade coordinate transformation and its application to wind turbine analysis,
   NREL/CP-500-42553, 2008.
"""

from __future__ import annotations

import math
import time as clock
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.kind import SIGNAL
from pitchpoint.elements.registry import find
from pitchpoint.solvers.body_shapes import body_motions
from pitchpoint.solvers.eigen import ratio_of
from pitchpoint.solvers.linear_system import Linearised, linearise
from pitchpoint.solvers.modal import FREQUENCY, RATIO
from pitchpoint.system import evaluate
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.scenario import Scenario

Array = NDArray[np.float64]

LEAST, LOWEST = 3, 0.03
"""Least number of blades; least imaginary part over the absolute value of eigenvalues that oscillate."""
ALIKE = 1e-3
"""Largest difference of motions, masses and angles of the blades, relative to the largest."""


@dataclass(frozen=True)
class MultibladeModes:
    """Modes of a turning rotor with its support, in axes that do not turn, by frequency.

    Parameters
    ----------
    eigenvalue
        Eigenvalues [1/s], shape (n,), those with Im > 0.
    frequency, damping_ratio
        Im/2 pi [Hz] and -Re/|eigenvalue|, shape (n,).
    blades
        Amplitudes of the blades, collective, in forward and in backward whirl, shape (n, 3), relative to the
        largest multi-blade coordinate of the mode.
    speed
        Speed of the rotor [rad/s].
    """

    eigenvalue: NDArray[np.complex128]
    frequency: Array
    damping_ratio: Array
    blades: Array
    speed: float


@dataclass(frozen=True)
class _Rotor:
    """Body of the hub; bodies, coordinates and states of each blade, azimuths relative to the first [rad]."""

    hub: int
    bodies: list[list[int]]
    coordinates: list[list[int]]
    states: list[list[int]]
    angles: Array

    @property
    def columns(self) -> list[list[int]]:
        """Coordinates of each blade, states last."""
        return [one + two for one, two in zip(self.coordinates, self.states, strict=True)]


def find_multiblade_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    hub: str,
    blades: Sequence[str],
    azimuths: int = 6,
) -> MultibladeModes:
    """Modes of a turning rotor with three or more equal blades, with its support.

    Parameters
    ----------
    system
        The compiled model, a tree of bodies.
    scenario
        Gives the speed of the hub; default: the one the system was compiled with.
    hub
        Body that carries the blades and turns about its z axis.
    blades
        Bodies or beams of the blades, in the order of their azimuths.
    azimuths
        Number of positions within the angle between two blades whose mean is used.

    Returns
    -------
    MultibladeModes

    Raises
    ------
    CompileError
        If there are fewer than three blades, they differ, or the model has closed loops.
    """
    import scipy.linalg

    first = linearise(system, scenario)
    rotor = _rotor_of(first, hub, blades)
    alike = _alike(first, rotor)
    spin = first.system.spin(hub)
    speed = float(first.state.v[spin])
    kept = _kept(first)
    total = np.zeros((3, len(kept), len(kept)))
    linear = first
    for step in range(azimuths):
        if step:
            start = first.state.copy()
            start.q[spin] += step * math.tau / (azimuths * len(blades))
            linear = linearise(system, scenario, start=start)
        total += _transformed(linear, rotor, alike, speed)[:, kept[:, None], kept] / azimuths
    n, (M, D, K) = len(kept), total
    pencil = np.block([[np.zeros((n, n)), np.eye(n)], [-K, -D]])
    values, vectors = scipy.linalg.eig(pencil, scipy.linalg.block_diag(np.eye(n), M))
    chosen = np.flatnonzero(np.isfinite(values) & (values.imag > LOWEST * np.abs(values)))
    chosen = chosen[np.argsort(values[chosen].imag)]
    shapes = np.zeros((len(chosen), first.system.sizes["nd"]), dtype=np.complex128)
    shapes[:, kept] = vectors[:n, chosen].T
    size = np.zeros(first.system.sizes["nd"])
    size[kept] = np.sqrt(np.abs(np.diag(M)))
    return MultibladeModes(
        eigenvalue=values[chosen],
        frequency=values[chosen].imag / math.tau,
        damping_ratio=ratio_of(values[chosen]),
        blades=_whirl(shapes * size, rotor, speed),
        speed=speed,
    )


def _rotor_of(linear: Linearised, hub: str, blades: Sequence[str]) -> _Rotor:
    """Bodies and coordinates of the blades, and their azimuths, as drawn."""
    system = linear.system
    names, table = list(system.layout.bodies), system.program["body"]
    beams = system.model.beams if system.model is not None else {}
    if unknown := [name for name in (hub, *blades) if name not in names and name not in beams]:
        raise CompileError(
            f"{', '.join(unknown)}: no body or beam has this name; name hub and blades of the model"
        )
    if len(blades) < LEAST:
        raise CompileError(
            f"blades: {len(blades)} blades (limit {LEAST}); matrices of rotors with fewer remain periodic"
        )
    center = names.index(hub)
    branches = [_branch(system, center, _first_body(names, beams, name), name) for name in blades]
    coordinates = [
        [int(table[b]["dof"]) + c for b in branch for c in range(table[b]["n"])] for branch in branches
    ]
    states = [_states_of(system, branch) for branch in branches]
    numbers = {(len(own), len(more)) for own, more in zip(coordinates, states, strict=True)}
    if len(numbers) > 1 or len({body for branch in branches for body in branch}) < sum(map(len, branches)):
        raise CompileError(
            "blades: are not equal branches of the hub; give blades of the same bodies and beams"
        )
    evaluate.residual(system, system.initial_state())
    frames = system.workspace.fr
    places = frames["r"] + np.einsum("bij,bj->bi", frames["S"], table["com"])
    arms = np.array([places[branch].mean(axis=0) for branch in branches]) - frames["r"][center]
    x, y = (arms @ frames["R"][center][:, :2]).T
    angles = np.arctan2(y, x)
    return _Rotor(center, branches, coordinates, states, angles - angles[0])


def _states_of(system: System, branch: list[int]) -> list[int]:
    """Coordinates whose rates are states of elements on a blade, such as those of the air, not of control."""
    table, found = system.program["body"], []
    for name, bank in system.records.items():
        kind = find(name)
        fields = dict.fromkeys(field for pair in kind.pairs if kind.role != SIGNAL for field in pair)
        for record in bank:
            ends = [int(record[field]) for field in fields]
            if not set(ends).isdisjoint(branch):
                found += [int(table[b]["spin"]) for b in ends if table[b]["state"]]
    return list(dict.fromkeys(found))


def _first_body(names: list[str], beams: Mapping[str, Any], name: str) -> int:
    """Body of a blade, the one at the first end of a beam."""
    return names.index(beams[name].ends[0].partition(".")[0] if name in beams else name)


def _branch(system: System, center: int, at: int, name: str) -> list[int]:
    """All bodies of the branch of the hub that carries a body."""
    table = system.program["body"]
    while at and table[at]["parent"] != center:
        at = int(table[at]["parent"])
    if not at:
        raise CompileError(
            f"{name}: is not carried by {system.layout.bodies[center]}; name a blade of this hub"
        )
    branch = [at]
    for k in range(at + 1, len(table)):
        if table[k]["parent"] in branch and not table[k]["state"]:
            branch.append(k)
    return branch


def _kept(linear: Linearised) -> NDArray[np.int64]:
    """Coordinates that are free."""
    basis = linear.basis if isinstance(linear.basis, np.ndarray) else linear.basis.toarray()
    rows, columns = np.nonzero(basis)
    if len(rows) != basis.shape[1] or not np.allclose(basis[rows, columns], 1.0):
        raise CompileError(
            "the model has closed loops or ratios, whose coordinates cannot be combined over the blades; "
            "give a model that is a tree of bodies"
        )
    return rows[np.argsort(rows)]


def _change(one: Array, other: Array) -> float:
    """Largest difference over the largest value."""
    return float(np.abs(one - other).max() / np.abs(other).max())


def _alike(linear: Linearised, rotor: _Rotor) -> list[Array]:
    """Coordinates of every blade for unit coordinates of the first blade, with the same motions, as drawn."""
    from scipy.linalg import block_diag

    system, drawn = linear.system, linear.system.initial_state()
    evaluate.residual(system, drawn)
    axis = system.workspace.fr["R"][rotor.hub][:, 2].copy()
    own = []
    for branch, at, angle in zip(rotor.bodies, rotor.coordinates, rotor.angles, strict=True):
        unit = np.zeros((len(at), system.sizes["nd"]))
        unit[np.arange(len(at)), at] = 1.0
        moved = body_motions(system, drawn, unit)[:, branch]
        back = rotation(axis, -angle)
        turned = np.concatenate([moved[..., :3] @ back.T, moved[..., 3:] @ back.T], axis=-1)
        own.append(turned.reshape(len(at), -1).T)
    found = [np.linalg.lstsq(X, own[0], rcond=None)[0] for X in own]
    M = evaluate.matrix(system, drawn, 1.0, 0.0, 0.0)
    masses = [Q.T @ M[np.ix_(at, at)] @ Q for Q, at in zip(found, rotor.coordinates, strict=True)]
    steps = np.diff(np.sort(np.mod(rotor.angles + ALIKE, math.tau)))
    for what, worst in (
        ("motions", max(_change(X @ Q, own[0]) for X, Q in zip(own, found, strict=True))),
        ("masses", max(_change(mass, masses[0]) for mass in masses)),
        ("angles between them", float(np.abs(steps * len(own) / math.tau - 1.0).max())),
    ):
        if worst > ALIKE:
            raise CompileError(
                f"blades: their {what} differ by {100.0 * worst:.2g} % (limit {100.0 * ALIKE:g} %); "
                "give equal blades with equal angles between them"
            )
    return [block_diag(Q, np.eye(len(own))) for Q, own in zip(found, rotor.states, strict=True)]


def _transformed(linear: Linearised, rotor: _Rotor, alike: list[Array], speed: float) -> Array:
    """M, D and K, shape (3, nd, nd), with multi-blade coordinates in the places of those of the blades."""
    nd = linear.system.sizes["nd"]
    T = np.zeros((3, nd, nd))
    T[0] = np.eye(nd)
    columns = rotor.columns
    blades = np.concatenate(columns)
    T[0][blades, blades] = 0.0
    psi = rotor.angles + float(linear.state.q[linear.system.spin(linear.system.layout.bodies[rotor.hub])])
    for k, Q in enumerate(alike):
        for n, values in enumerate(harmonics(psi[k], k, len(psi))):
            for order in range(3):
                rows = np.ix_([order], columns[k], columns[n])
                T[rows] += speed**order * values[order] * Q
    M, D, K = linear.at_rest.M.copy(), linear.D.copy(), linear.K.copy()
    own = list(linear.states)  # the rates of these coordinates are the unknowns: one derivative less
    M[:, own], D[:, own], K[:, own] = 0.0, linear.at_rest.M[:, own], linear.D[:, own]
    return np.array(
        [
            T[0].T @ M @ T[0],
            T[0].T @ (D @ T[0] + 2.0 * M @ T[1]),
            T[0].T @ (K @ T[0] + D @ T[1] + M @ T[2]),
        ]
    )


def harmonics(psi: float, k: int, count: int) -> list[tuple[float, float, float]]:
    """Share of each multi-blade coordinate in blade k at an azimuth, and its two derivatives by azimuth.

    The order is a_0, a_1, b_1, a_2, ..., with d last for an even number of blades.

    Examples
    --------
    >>> [round(value, 3) for value, _, _ in harmonics(0.5, 1, 4)]
    [1.0, 0.878, 0.479, -1.0]
    """
    out = [(1.0, 0.0, 0.0)]
    for n in range(1, (count - 1) // 2 + 1):
        c, s = math.cos(n * psi), math.sin(n * psi)
        out += [(c, -n * s, -n * n * c), (s, n * c, -n * n * s)]
    if count % 2 == 0:
        out.append(((-1.0) ** k, 0.0, 0.0))
    return out


def rotation(axis: Array, angle: float) -> Array:
    """Rotation matrix about a unit vector, shape (3, 3)."""
    S = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    return np.asarray(np.eye(3) + math.sin(angle) * S + (1.0 - math.cos(angle)) * S @ S)


def _whirl(shapes: NDArray[np.complex128], rotor: _Rotor, speed: float) -> Array:
    """Amplitudes of the blades, collective, forward and backward, over the largest one, shape (n, 3)."""
    collective, c, s, *others = (shapes[:, own] for own in rotor.coordinates)
    turn = 1j if speed >= 0.0 else -1j
    parts = (collective, 0.5 * (c + turn * s), 0.5 * (c - turn * s), *others)
    sizes = np.array([np.linalg.norm(part, axis=1) for part in parts]).T
    return np.asarray(sizes[:, :3] / np.maximum(sizes.max(axis=1, keepdims=True), 1e-300))


def solve_multiblade_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    hub: str,
    blades: Sequence[str],
    azimuths: int = 6,
) -> xr.Dataset:
    """Modes of a turning rotor in multi-blade coordinates; arguments and errors of `find_multiblade_modes`.

    Returns
    -------
    xarray.Dataset
        Over `mode`, by frequency: frequency [Hz], the damped natural frequency in axes that do not turn,
        damping_ratio, eigenvalue_real and eigenvalue_imag [1/s]; collective, forward and backward, the
        amplitudes of the blades relative to the largest multi-blade coordinate.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = clock.perf_counter()
    found = find_multiblade_modes(system, scenario, hub=hub, blades=blades, azimuths=azimuths)
    columns = {
        "frequency": (found.frequency, *FREQUENCY),
        "damping_ratio": (found.damping_ratio, *RATIO),
        "eigenvalue_real": (found.eigenvalue.real, "1/s", "real part of the eigenvalue"),
        "eigenvalue_imag": (found.eigenvalue.imag, "1/s", "imaginary part of the eigenvalue"),
        "collective": (found.blades[:, 0], "1", "amplitude of all blades together"),
        "forward": (found.blades[:, 1], "1", "amplitude of the blades in forward whirl"),
        "backward": (found.blades[:, 2], "1", "amplitude of the blades in backward whirl"),
    }
    options: dict[str, Any] = {"hub": hub, "blades": list(blades), "azimuths": azimuths, "speed": found.speed}
    return xr.Dataset(
        {
            name: (("mode",), values, {"units": unit, "long_name": text})
            for name, (values, unit, text) in columns.items()
        },
        coords={"mode": np.arange(1, len(found.frequency) + 1)},
        attrs=attributes(system, "multiblade", wall_s=clock.perf_counter() - began, **options),
    )
