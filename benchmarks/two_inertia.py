# SPDX-License-Identifier: Apache-2.0
"""Spur pair with backlash and varying stiffness on two inertias: our engine, a bare loop, exudyn and SciPy.

z 20/40, m 4 mm, alpha 20 deg, k = 4e8 (1 + 0.3 cos(z1 theta1)) N/m, damper 1373.85 N s/m also in the gap,
clearance 50 um, 200/400 N m, 4000/2000 rpm, one second from mid-gap.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

from benchmarks.rows import Row, cpu_seconds, in_turn

R_B1, J1, J2 = 0.0375877048, 1e-3, 8e-3
CLEARANCE, K0, DAMPING, T1, T2, Z1 = 50e-6, 4e8, 1373.847596734438, 200.0, 400.0, 20
OMEGA1, T_END, STEP = 4000.0 * math.pi / 30.0, 1.0, 5e-6
ENDS = (0.7, 0.8, 0.9, 1.0)
"""End times [s] at which errors are taken: at a single one a method may be right by luck."""

MODEL = f"""
title: two inertias
gears:
  pinion: {{number_of_teeth: 20, normal_module: 4 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  wheel: {{number_of_teeth: 40, normal_module: 4 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies:
  one: {{gears: [pinion], inertia: {J1}}}
  two: {{gears: [wheel], inertia: {J2}}}
meshes:
  stage:
    gears: [pinion, wheel]
    center_distance: 120 mm
    backlash: {{base_tangent: {CLEARANCE}}}
    stiffness: {{law: fourier, mean: {K0}, cosine: [COSINE], sine: [SINE]}}
    damper: {{value: {DAMPING}}}
loads:
  motor: {{body: one, torque: {T1}}}
  brake: {{body: two, torque: {T2}}}
scenarios:
  second: {{speed: {{one: 4000 rpm}}, duration: 1 s, step: {STEP}, start: assembled}}
"""


def hand_written_loop() -> Any:
    """RK4 on this one problem, compiled, with nothing general in it: what the hardware allows."""
    from numba import njit

    @njit(fastmath=True, error_model="numpy")
    def slope(x1: float, x2: float, v1: float, v2: float) -> tuple[float, float]:
        d = R_B1 * x1 - 2.0 * R_B1 * x2
        w = R_B1 * v1 - 2.0 * R_B1 * v2
        g = d if d > 0.0 else (0.0 if d >= -CLEARANCE else d + CLEARANCE)
        f = K0 * (1.0 + 0.3 * math.cos(Z1 * x1)) * g + DAMPING * w
        return (T1 - R_B1 * f) / J1, (2.0 * R_B1 * f - T2) / J2

    @njit(fastmath=True, error_model="numpy")
    def loop(n: int, h: float) -> tuple[float, float, float]:
        x1, x2, v1, v2 = -CLEARANCE / (2.0 * R_B1), 0.0, OMEGA1, 0.5 * OMEGA1
        low, high = 1e9, -1e9
        for k in range(n):
            a1, a2 = slope(x1, x2, v1, v2)
            p1, p2 = v1 + 0.5 * h * a1, v2 + 0.5 * h * a2
            b1, b2 = slope(x1 + 0.5 * h * v1, x2 + 0.5 * h * v2, p1, p2)
            q1, q2 = v1 + 0.5 * h * b1, v2 + 0.5 * h * b2
            c1, c2 = slope(x1 + 0.5 * h * p1, x2 + 0.5 * h * p2, q1, q2)
            r1, r2 = v1 + h * c1, v2 + h * c2
            d1, d2 = slope(x1 + h * q1, x2 + h * q2, r1, r2)
            x1 += h / 6.0 * (v1 + 2.0 * p1 + 2.0 * q1 + r1)
            x2 += h / 6.0 * (v2 + 2.0 * p2 + 2.0 * q2 + r2)
            v1 += h / 6.0 * (a1 + 2.0 * b1 + 2.0 * c1 + d1)
            v2 += h / 6.0 * (a2 + 2.0 * b2 + 2.0 * c2 + d2)
            d = R_B1 * x1 - 2.0 * R_B1 * x2
            if k >= 0.9 * n:
                low, high = min(low, d), max(high, d)
        return R_B1 * x1 - 2.0 * R_B1 * x2, low, high

    return loop


@cache
def system() -> Any:
    """The model compiled by pitchpoint, its phase counted from theta1 = 0 as in the formula."""
    from pitchpoint.io.yaml_model import loads_model
    from pitchpoint.system import evaluate
    from pitchpoint.system.compile import compile_model

    plain = MODEL.replace("COSINE", "0.3").replace("SINE", "0.0")
    probe = compile_model(loads_model(plain), "second")
    psi = evaluate.observe(probe, _start(probe))[probe.layout.channel("mesh_phase[stage]")]
    # cos(z1 theta1) at psi = psi_0 + z1 theta1 / 2 pi
    cosine, sine = 0.3 * math.cos(2.0 * math.pi * psi), 0.3 * math.sin(2.0 * math.pi * psi)
    text = MODEL.replace("COSINE", repr(cosine)).replace("[SINE]", f"[{sine!r}]")
    return compile_model(loads_model(text), "second")


def _start(compiled: Any) -> Any:
    state = compiled.initial_state()
    state.v[:] = OMEGA1, -0.5 * OMEGA1
    return state


def ours(method: str, h: float, t_end: float = T_END) -> float:
    """Run the engine; mesh penetration at the end [m], 0 at the front flank as in the reference."""
    from pitchpoint.solvers.explicit import runge_kutta
    from pitchpoint.solvers.implicit import generalized_alpha
    from pitchpoint.system import evaluate

    compiled = system()
    state = _start(compiled)
    if method == "adaptive":
        run: Any = runge_kutta.start_adaptive(compiled, state, rtol=h, atol=1e-5 * h, atol_rate=1e-1 * h)
        assert run.advance_to(t_end).status == 1
    else:
        start = generalized_alpha.start if method == "implicit" else runge_kutta.start_classical
        run = start(compiled, state, h)
        assert run.advance(round(t_end / h)).status == 1
    row = evaluate.observe(compiled, run.state())
    return float(row[compiled.layout.channel("deflection[stage]")]) - 0.5 * CLEARANCE


def scipy_run(method: str, rtol: float, t_end: float = T_END) -> float:
    """The same in SciPy, right-hand side in Python."""
    from scipy.integrate import solve_ivp

    def rhs(t: float, y: Any) -> list[float]:
        x1, x2, v1, v2 = y
        d = R_B1 * x1 - 2.0 * R_B1 * x2
        w = R_B1 * v1 - 2.0 * R_B1 * v2
        g = d if d > 0.0 else (0.0 if d >= -CLEARANCE else d + CLEARANCE)
        f = K0 * (1.0 + 0.3 * math.cos(Z1 * x1)) * g + DAMPING * w
        return [v1, v2, (T1 - R_B1 * f) / J1, (2.0 * R_B1 * f - T2) / J2]

    y0 = [-CLEARANCE / (2.0 * R_B1), 0.0, OMEGA1, 0.5 * OMEGA1]
    atol = [1e-6 * rtol, 1e-6 * rtol, 1e-3 * rtol, 1e-3 * rtol]
    # LSODA of SciPy counts its steps; a second of mesh vibration needs many
    found = solve_ivp(rhs, (0.0, t_end), y0, method=method, rtol=rtol, atol=atol)
    x1, x2 = found.y[:2, -1]
    return float(R_B1 * x1 - 2.0 * R_B1 * x2)


def exudyn_run(method: str, n: int) -> None:
    """The same in exudyn: two torsional nodes and a Python user function for the mesh torque."""
    import exudyn as exu
    from exudyn.itemInterface import Mass1D, Node1D, ObjectGenericODE2

    container = exu.SystemContainer()
    mbs = container.AddSystem()
    starts = ((-CLEARANCE / (2.0 * R_B1), OMEGA1, J1), (0.0, 0.5 * OMEGA1, J2))
    nodes = []
    for angle, speed, inertia in starts:
        node = mbs.AddNode(
            Node1D(referenceCoordinates=[0.0], initialCoordinates=[angle], initialVelocities=[speed])
        )
        mbs.AddObject(Mass1D(physicsMass=inertia, nodeNumber=node))
        nodes.append(node)

    def mesh(mbs: Any, t: float, item: int, q: Any, q_t: Any) -> list[float]:
        x1, x2 = q
        v1, v2 = q_t
        d = R_B1 * x1 - 2.0 * R_B1 * x2
        w = R_B1 * v1 - 2.0 * R_B1 * v2
        g = d if d > 0.0 else (0.0 if d >= -CLEARANCE else d + CLEARANCE)
        f = K0 * (1.0 + 0.3 * math.cos(Z1 * x1)) * g + DAMPING * w
        return [T1 - R_B1 * f, 2.0 * R_B1 * f - T2]

    mbs.AddObject(ObjectGenericODE2(nodeNumbers=nodes, forceUserFunction=mesh))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = n
    settings.timeIntegration.endTime = n * STEP
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1e9
    settings.displayComputationTime = False
    settings.timeIntegration.newton.useModifiedNewton = True
    if method == "implicit":
        mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
    else:
        mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)


def rows(bare_rate: list[float]) -> list[Row]:
    """Measure; the steps per second of the bare loop are also appended to `bare_rate` for other tables."""
    loop = hand_written_loop()
    n = round(T_END / STEP)
    loop(10, STEP)
    system()
    for method in ("implicit", "explicit"):
        ours(method, STEP, 0.001)
    ours("adaptive", 1e-7, 0.001)
    taken = in_turn(
        {
            "bare": lambda: loop(n, STEP),
            "implicit": lambda: ours("implicit", STEP),
            "explicit": lambda: ours("explicit", STEP),
        },
        repeats=5,
    )
    bare_rate.append(n / taken["bare"])
    found = [
        Row("two-inertia bare loop", n / taken["bare"], "steps/s", "", "hand-written compiled RK4"),
        Row("two-inertia generalized-alpha", n / taken["implicit"], "steps/s", "", "engine, same step"),
        Row("two-inertia RK4", n / taken["explicit"], "steps/s", "", "engine, same step"),
    ]
    return found + _against_exudyn(n, taken) + _against_scipy(loop)


def _against_exudyn(n: int, taken: dict[str, float]) -> list[Row]:
    try:
        import exudyn
    except ImportError:
        return [Row("exudyn", float("nan"), "", "", "not installed, see the extra `peers`")]
    part = n // 10
    version = f"exudyn {exudyn.__version__}, Python user function, same step"
    rows_ = []
    for method, target in (("implicit", ">= 20"), ("explicit", ">= 5")):
        peer = cpu_seconds(lambda m=method: exudyn_run(m, part), 3) * (n / part)
        label = "generalized-alpha" if method == "implicit" else "RK4"
        rows_.append(
            Row(f"two-inertia {label} against exudyn", peer / taken[method], "times", target, version)
        )
    return rows_


def _against_scipy(loop: Any) -> list[Row]:
    """Time of one second of motion at the same error of the penetration, the largest of several end times.

    Each against its own converged value: the engine counts the phase of the mesh from both gears, the formula
    from the pinion alone, which makes 1e-3 of the penetration.
    """
    steps = 6_400_000
    reference = {end: loop(round(steps * end), T_END / steps)[0] for end in ENDS}
    own = {end: ours("adaptive", 1e-11, end) for end in ENDS}
    found = []
    for peer, rtol, target in (("LSODA", 1e-7, ">= 4"), ("DOP853", 1e-9, ">= 15")):
        error = max(abs(scipy_run(peer, rtol, end) - reference[end]) for end in ENDS)
        seconds = cpu_seconds(lambda p=peer, r=rtol: scipy_run(p, r), 2)
        best = None
        for method, sizes in (
            ("explicit", (4e-5, 2e-5, 1e-5, 5e-6, 2.5e-6, 1.25e-6, 6.25e-7)),
            ("adaptive", tuple(10.0 ** (-k / 2) for k in range(8, 20))),
        ):
            for size in sizes:
                if max(abs(ours(method, size, end) - own[end]) for end in ENDS) <= error:
                    time_ = cpu_seconds(lambda m=method, s=size: ours(m, s), 3)
                    if best is None or time_ < best[0]:
                        best = (time_, method, size)
                    break
        if best is None:
            found.append(Row(f"two-inertia against {peer}", 0.0, "times", target, "accuracy not reached"))
            continue
        text = f"SciPy {peer} rtol {rtol:g}, error {error / 1.5e-5:.1e}; ours {best[1]} {best[2]:.1e}"
        found.append(Row(f"two-inertia against {peer}", seconds / best[0], "times", target, text))
    return found
