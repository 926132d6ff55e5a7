# SPDX-License-Identifier: Apache-2.0
"""Slider-crank with an elastic rod: deflection at the centre of the rod, compared with beam theory.

Usage: ``python flexible.py`` prints a table, ``python flexible.py bend.html`` draws the curves,
``python flexible.py rod.npz`` writes the matrices of the rod for `elastic.yaml`.
"""

from __future__ import annotations

import math
import sys

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.closure_rows import cut_joint
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.craig_bampton import craig_bampton
from pitchpoint.multibody.joints import FLOATING, PRISMATIC, SPHERICAL
from pitchpoint.multibody.structure import Structure, beam_line
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.rules.elastic_body import elastic_parts
from pitchpoint.system.system import System, assemble

CRANK, LENGTH = 0.1, 0.3  # [m]
THICK, WIDE = 8e-3, 20e-3  # of the rod, in the plane and across it [m]
E, G, DENSITY = 2.1e11, 8.1e10, 7850.0
PIECES = 8
SPEED = 1000.0 * math.pi / 30.0
PISTON = 0.5  # [kg]

ALONG = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Axes of the rod in the world: its first axis along y, its second along z, itself along x."""


def bar() -> Structure:
    """Matrices of the rod, along the third axis of its own."""
    piece = Beam(section=rectangle(THICK, WIDE), length=LENGTH / PIECES, E=E, G=G, rho=DENSITY)
    return beam_line([piece] * PIECES)


def machine() -> tuple[System, dict[str, int]]:
    """Crank, piston and elastic rod, all in line along x, and the numbers of the nodes of the rod.

    The crank is so heavy that it keeps its speed. The rod carries itself: its frame floats, and its ends are
    held by a pin on the crank and a ball in the piston.
    """
    structure = bar()
    modes = craig_bampton(structure, [0, PIECES], 6)
    crank = Body(motion=TORSION, polar_inertia=1e4, name="crank")
    piston = Body(
        motion=PRISMATIC,
        position=(CRANK + LENGTH, 0, 0),
        axes=ALONG,
        mass=PISTON,
        inertia=1e-4 * np.eye(3),
        name="piston",
    )
    frame = Body(motion=FLOATING, position=(CRANK, 0, 0), inertia=np.zeros((3, 3)), name="rod")
    rod = elastic_parts(
        "rod",
        structure,
        modes,
        {"big": 0, "middle": PIECES // 2, "small": PIECES},
        first=3,
        frame=frame,
        pose=((CRANK, 0, 0), ALONG),
    )
    bodies = [crank, piston, *rod.bodies]
    nodes = dict(rod.nodes)
    big, _ = cut_joint(TORSION, bodies, nodes["big"], 1, np.array([CRANK, 0, 0]), np.eye(3))
    small, _ = cut_joint(SPHERICAL, bodies, nodes["small"], 2, np.array([CRANK + LENGTH, 0, 0]), np.eye(3))
    system = assemble(
        bodies,
        {"flexible_body": rod.flexible, "guide": rod.guides},
        {"closure": np.concatenate([big, small])},
    )
    return system, nodes


def bend(turns: float = 2.0, step: float = 2e-5, every: int = 5) -> tuple[NDArray[np.float64], ...]:
    """Integrate from the stretched position.

    Returns
    -------
    t, angle, deflection, travel
        Time [s], angle of the crank [rad], bend of the middle of the rod and way of the piston [m].
    """
    system, nodes = machine()
    state = system.initial_state()
    layout = system.layout
    rates = {"crank.spin": SPEED, "rod.y": SPEED * CRANK, "rod.spin": -SPEED * CRANK / LENGTH}
    for name, rate in rates.items():
        state.v[layout.coordinate(name)] = rate
    run = start(system, state, step)
    rows = []
    for _ in range(round(turns * 2.0 * math.pi / SPEED / step / every)):
        run.advance(every)
        now = run.state()
        evaluate.residual(system, now)
        place = {name: system.workspace.fr[k]["r"].copy() for name, k in nodes.items()}
        chord = place["small"] - place["big"]
        across = np.array([-chord[1], chord[0], 0.0]) / np.linalg.norm(chord)
        rows.append((now.t, now.q[0], across @ (place["middle"] - place["big"]), now.q[1]))
    t, angle, deflection, travel = np.array(rows).T
    return t, np.unwrap(angle), deflection, travel


def theory(t: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Deflection of the middle by beam theory, from the motion of the stiff mechanism.

    Returns
    -------
    slow, vibrating
        Of a rod without vibration, 5 rho A L^4/(768 E I) (a_1 + a_2), and with its modes 1, 3 and 5 [m].
    """
    from scipy.integrate import solve_ivp

    area, second = THICK * WIDE, WIDE * THICK**3 / 12.0
    radius = math.sqrt(second / area)

    def ends(time: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Accelerations of both ends across the rod."""
        theta = SPEED * time
        phi = np.arcsin(CRANK / LENGTH * np.sin(theta))  # the rod is inclined by -phi
        phi1 = CRANK / LENGTH * np.cos(theta) * SPEED / np.cos(phi)
        phi2 = (-CRANK / LENGTH * np.sin(theta) * SPEED**2 + phi1**2 * np.sin(phi)) / np.cos(phi)
        ax, ay = -CRANK * SPEED**2 * np.cos(theta), -CRANK * SPEED**2 * np.sin(theta)
        at_big = ax * np.sin(phi) + ay * np.cos(phi)
        return at_big, at_big - LENGTH * phi2

    first, last = ends(t)
    slow = -5.0 * DENSITY * area * LENGTH**4 / (768.0 * E * second) * (first + last)
    whole = np.zeros_like(t)
    for n in (1, 3, 5):
        natural = (n * math.pi / LENGTH) ** 2 * math.sqrt(E * second / (DENSITY * area))
        # Timoshenko: rotary inertia and shear
        natural *= 1.0 - 0.5 * (n * math.pi * radius / LENGTH) ** 2 * (1.0 + 1.2 * E / G)

        def rates(time, y, n=n, natural=natural):
            one, two = ends(time)
            return [y[1], -(natural**2) * y[0] - 2.0 / (n * math.pi) * (one + two)]

        span, longest = (0.0, t[-1]), 0.5 / natural
        found = solve_ivp(rates, span, [0.0, 0.0], t_eval=t, rtol=1e-8, atol=1e-13, max_step=longest)
        whole += math.sin(0.5 * n * math.pi) * found.y[0]
    return slow, whole


def main() -> None:
    """Print or write the curves."""
    if len(sys.argv) > 1 and sys.argv[1].endswith(".npz"):
        rod = bar()
        np.savez_compressed(sys.argv[1], K=rod.K.toarray(), M=rod.M.toarray(), places=rod.places)
        return
    t, angle, deflection, _ = bend()
    slow, whole = theory(t)
    if len(sys.argv) > 1:
        from pitchpoint.viz.quantities import Channel
        from pitchpoint.viz.signals_plot import plot_signals

        curves = {"elastic rod": deflection, "beam theory": whole, "without vibration": slow}
        channels = [Channel(name, values, "m", "bend of the rod") for name, values in curves.items()]
        rows = [list(range(len(channels)))]
        plot_signals(t, channels, rows=rows, title="middle of the rod").write_html(sys.argv[1])
    print("crank [deg]   bend   beam theory   without vibration [mm]")
    for k in range(0, len(t), len(t) // 24):
        bends = 1e3 * np.array([deflection[k], whole[k], slow[k]])
        print(f"{math.degrees(angle[k]):11.1f} {bends[0]:6.3f} {bends[1]:13.3f} {bends[2]:13.3f}")


if __name__ == "__main__":
    main()
