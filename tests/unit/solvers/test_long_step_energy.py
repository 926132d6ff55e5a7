# SPDX-License-Identifier: Apache-2.0
"""Energy of long steps: amplification matrix of two masses as an independent oracle, and the program.

The oracle repeats the method for a linear chain: fast mass I (gear train), spring k, slow mass M, spring,
second slow mass on a spring to ground; one long step H = 1 of it is a matrix. Its spectral radius shows
whether vibrations gain energy.
"""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.implicit import gear_part
from pitchpoint.solvers.implicit.substeps import LONG_RHO
from pitchpoint.solvers.initial_state.start import prepare_start


def coefficients(rho):
    alpha_m, alpha_f = (2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0)
    gamma = 0.5 - alpha_m + alpha_f
    return 0.25 * (gamma + 0.5) ** 2, gamma, alpha_m, alpha_f


def alpha_step(M, K, force, state, h, rho):
    """One generalised-alpha step of M a + K q = force."""
    q, v, a, al = state
    beta, gamma, alpha_m, alpha_f = coefficients(rho)
    base, share = (alpha_f * a - alpha_m * al) / (1.0 - alpha_m), (1.0 - alpha_f) / (1.0 - alpha_m)
    q = q + h * v + h * h * ((0.5 - beta) * al + beta * base)
    v = v + h * ((1.0 - gamma) * al + gamma * base)
    a = np.linalg.solve(M + h * h * beta * share * K, force - K @ q)
    return q + h * h * beta * share * a, v + h * gamma * share * a, a, base + share * a


def amplification(fast, k, M, K, n=10, rho=LONG_RHO, held=False):
    """Matrix of one long step H = 1; held: without the motion by the difference of forces."""
    ns, h = len(M), 1.0 / n
    beta, _, alpha_m, alpha_f = coefficients(rho)
    factor = beta * (1.0 - alpha_f) / (1.0 - alpha_m)
    W = 0.0 if held else np.linalg.inv(M + 2.0 * factor * K)[0, 0]
    e = np.eye(ns)[:, :1]
    sizes = np.cumsum([0, *[ns] * 5, 1, 1, 1, 1, 1, 1, 1, 1])

    def step(X):
        """Columns of slow q, v, a, al, a before; fast q, v, a, al; force, mean, end force, its slope."""
        q, v, a, al, before, *x, last, mean, end, slope = (
            X[i:j] for i, j in zip(sizes[:-1], sizes[1:], strict=True)
        )
        jerk, z, rate, second, total = a - before, 0.0 * last, 0.0 * last, -W * (last - end), 0.5 * last
        for j in range(1, n + 1):
            t = j * h
            z = z + h * rate + 0.5 * h * h * second
            y = (q + t * v + 0.5 * t * t * a + t**3 / 6.0 * jerk)[:1] + z
            x = alpha_step(np.array([[fast]]), np.array([[k]]), k * y, x, h, 0.8)
            last = k * (y - x[0])
            now = -W * (last - end - slope * t)
            rate, second = rate + 0.5 * h * (second + now), now
            total = total + (last if j < n else 0.5 * last)
        new_mean = total / n
        new_end = new_mean + 0.5 * (new_mean - mean)
        slow = alpha_step(M, K, -e @ new_end, (q, v, a, al), 1.0, rho)
        return np.vstack([*slow, a, *x, last, new_mean, new_end, new_end - end])

    return step(np.eye(sizes[-1]))


def chain(ratio, first, second):
    """Slow masses 1 and `ratio` with the frequencies of their springs."""
    k1, k2 = first**2, second**2 * ratio
    return np.diag([1.0, ratio]), np.array([[k1, -k1], [-k1, k1 + k2]])


def test_no_vibration_with_six_steps_per_period_gains_energy():
    """Undamped random chains, all frequencies up to 1/H, H^2 k/M up to its limit."""
    rng = np.random.default_rng(1)
    most = before = 0.0
    for _ in range(60):
        k = gear_part.SOFT_SPRING * rng.uniform(0.1, 1.0)
        M, K = chain(10.0 ** rng.uniform(-0.5, 1.0), *10.0 ** rng.uniform(-1.5, -0.2, 2))
        fast = k / 10.0 ** (2.0 * rng.uniform(-1.5, 0.0))
        n = int(rng.choice([2, 5, 10]))
        radius = [
            abs(np.linalg.eigvals(amplification(fast, k, M, K, n, *more))).max() for more in ((), (0.8, True))
        ]
        most, before = max(most, radius[0]), max(before, radius[1])
    assert most <= 1.0 + 1e-9
    assert before > 1.0005  # with the numerical damping of short steps and the rest held


MODEL = """
gears:
  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
meshes: {stage: {gears: [a, b], stiffness: {law: constant, value: 3e10 N/m}, damper: {ratio: 0.05}}}
bodies:
  pinion: {gears: [a], inertia: INERTIA kg m^2}
  wheel: {gears: [b], inertia: INERTIA kg m^2}
  hub: {inertia: 1 kg m^2}
  blade: {inertia: 1 kg m^2}
joints:
  hub_bearing: {type: revolute, bodies: [ground, hub], position: [0, 0, 0]}
  pin: {type: revolute, bodies: [hub, blade], position: [0, 0, 0]}
torsion_springs: {root: {bodies: [blade, hub], stiffness: 4e4 N m/rad}}
couplings:
  shaft: {bodies: [wheel, hub], stiffness: {torsion: SHAFT N m/rad}, damping: {torsion: 0 N m s/rad}}
loads:
  push: {body: pinion, torque: 100}
  brake: {body: hub, torque: 100 + 20*step(t - 5e-3)}
scenarios: {run: {speed: {pinion: 100 rpm}, duration: 1 s, step: 0.1 ms, long_step: 1 ms}}
"""


def run(k, fast):
    """Running system with the stiffness H^2 k/M and the natural frequency of the gear train in 1/H."""
    text = MODEL.replace("SHAFT", f"{k * 1e6:.9g}").replace("INERTIA", f"{0.5 * k / fast**2:.9g}")
    system = pp.compile_model(pp.load_model(text=text), "run")
    begun = prepare_start(system, system.scenario)
    return begun.system, gear_part.start(begun.system, begun.state, 1e-4, 10)


@pytest.mark.parametrize(("k", "fast"), [(0.02, 0.5), (0.028, 1.2), (0.02, 2.0)])
def test_the_vibration_of_a_gear_train_decays_as_in_the_oracle(k, fast):
    """Undamped shaft between gear train and hub, 2000 long steps; frequency and decay per step."""
    system, now = run(k, fast)
    rows = now.advance(20000, every=10).rows
    x = rows[20:, 1 + system.layout.channel("coupling_force[shaft.mz]")]
    M, K = chain(1.0, 0.2, 0.0)
    roots = np.linalg.eigvals(amplification(k / fast**2, k, M, K))
    root = min(roots, key=lambda z: abs(np.angle(z) - np.sqrt(fast**2 + k)) - abs(z))
    size = 900
    ends = [
        abs(np.hanning(size) * (p - p.mean()) @ np.exp(-1j * np.angle(root) * np.arange(size)))
        for p in (x[:size], x[-size:])
    ]
    assert np.log(ends[1] / ends[0]) / (len(x) - size) == pytest.approx(np.log(abs(root)), rel=0.02, abs=1e-6)
    assert abs(root) < 1.0


def test_a_long_step_beyond_the_limit_of_stiffness_is_refused():
    with pytest.raises(SolverError, match=r"long_step: 0.001 s is too long for hub.spin.*limit 0.00095 s"):
        run(0.0333, 1.0)
