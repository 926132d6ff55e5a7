# SPDX-License-Identifier: Apache-2.0
"""Energies of whirl modes and ranked critical speeds: closed forms, balances, frequency responses."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.analysis.campbell_ranking import ranked_speeds, select_modes
from pitchpoint.core.errors import SolverError
from pitchpoint.report.campbell import campbell_of
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.critical_speeds import _solve, critical_speeds, separation
from pitchpoint.solvers.eigen import ratio_of
from pitchpoint.solvers.excitation_orders import excitation_orders
from pitchpoint.solvers.linear_system import damped_modes
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.over_speed import at_one_azimuth
from tests.support.machines import compiled, pair

EXAMPLE = Path(__file__).parents[3] / "examples" / "geared-rotor" / "model.yaml"
RPM = math.pi / 30.0
M, I_P, I_T, K, C, K_TILT, C_TILT = 3.0, 0.006, 0.012, 2e6, 60.0, 4e4, 0.5
ROTOR = f"""\
bodies:
  disc: {{motion: free, mass: {M}, inertia: {I_P}, transverse_inertia: {I_T}}}
bearings:
  support: {{body: disc, stiffness: {{radial: {K}, axial: 1e8, tilt: {K_TILT}, torsion: 1}},
            damping: {{radial: {C}, tilt: {C_TILT}}}}}
"""


@pytest.fixture(scope="module")
def rotor():
    """Jeffcott rotor with a tilting disc: translation and tilt are independent."""
    return compiled(ROTOR)[1]


@pytest.fixture(scope="module")
def geared():
    return pp.compile_model(pp.load_model(EXAMPLE), "fast")


def test_critical_speeds_of_a_tilting_disc(rotor):
    """With p = ry - i rx, I = I_t -+ I_p: I_t p'' + (c -+ i I_p W) p' + k p = 0 and p ~ e^((s + i W) t).

    The imaginary part gives s = -c/(I_t + I), the real part W^2 = k/I - c^2/(I_t + I)^2. Translation:
    W^2 = k/m (1 - zeta^2) both ways. The points are 75 rad/s apart: crossings are solved again.
    """
    data = pp.solve_campbell(rotor, np.linspace(0.0, 3000.0, 41), "disc", orders=["1x"])
    found: dict[str, float] = {}
    for c in ranked_speeds(data, least=0.0):
        found[c.mode] = c.speed
        assert c.frequency == pytest.approx(c.speed / (2.0 * math.pi), rel=1e-9)
    for word, inertia in (("forward", I_T - I_P), ("backward", I_T + I_P)):
        critical = math.sqrt(K_TILT / inertia - (C_TILT / (I_T + inertia)) ** 2)
        assert found[f"tilting of disc ({word})"] == pytest.approx(critical, rel=1e-9)
    zeta = C / (2.0 * math.sqrt(K * M))
    critical = math.sqrt(K / M * (1.0 - zeta**2))
    assert [found[name] for name in found if "translation" in name] == pytest.approx([critical] * 2, rel=1e-9)


def test_unbalance_drives_forward_whirl_only(rotor):
    """Circular modes: participation 1 forwards, 0 backwards; amplification 1/(2 zeta) of the translation."""
    data = pp.solve_campbell(rotor, np.linspace(100.0, 3000.0, 30), "disc", orders=["1x"])
    for c in ranked_speeds(data, least=-1.0):
        if "tilting" in c.mode:
            assert c.whirl in c.mode
            assert c.participation == pytest.approx(1.0 if c.whirl == "forward" else 0.0, abs=1e-6)
            assert c.source == ("unbalance" if c.whirl == "forward" else c.source)
    zeta = C / (2.0 * math.sqrt(K * M))
    both = [c for c in ranked_speeds(data, least=-1.0) if "translation" in c.mode]
    assert sum(c.amplification for c in both) == pytest.approx(1.0 / (2.0 * zeta), rel=1e-4)


def test_amplification_is_that_of_the_response_to_unbalance():
    """Overhung disc: response per eccentricity of the mass at the first forward critical speed.

    The amplification is that of the most unfavourable static and dynamic unbalance, an upper bound. That of
    an eccentricity e alone is smaller by the share of the translation in the energy of the forward whirl.
    """
    text = ROTOR.replace("support: {body: disc,", "support: {body: disc, position: [0, 0, -0.05],")
    model, system = compiled(text + "scenarios: {turn: {speed: {disc: 500}, duration: 1 ms}}\n")
    data = pp.solve_campbell(system, np.linspace(50.0, 1500.0, 30), "disc", orders=["1x"])
    first = next(c for c in ranked_speeds(data) if c.whirl == "forward" and c.frequency < 200.0)
    hertz = first.frequency * np.linspace(0.98, 1.02, 321)
    response = pp.solve_frequency_response(
        system, ["unbalance[disc]"], ["disc.ux"], hertz, synchronous="disc"
    )
    peak = M * response.amplitude.values[:, 0, 0].max()  # per kg m on the mass M: e = 1/M
    modes = follow_modes(system, [first.speed], "disc")
    k = modes.names.index(first.mode)
    twist = modes.energies[0].twist[k, 1]
    moved, tilted = M * abs(twist[0]) ** 2, I_T * abs(twist[3]) ** 2
    share = moved / (moved + tilted)
    assert 0.5 < share < 0.999
    assert modes.energies[0].gyroscopic[k] > 1e-3
    # the backward modes and the second forward one add their static response
    assert peak == pytest.approx(share * first.amplification, rel=0.03)
    assert model.bodies


def test_mesh_amplification_is_that_of_the_response_to_transmission_error():
    """Mesh deflection per transmission error at the resonances of a pair on bearings, damped modally.

    Other modes add the sum of their shares over |1 - (f/f_n)^2|, which is below 1 at well separated ones.
    """
    stiffness = "{radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}"
    bearings = "".join(f"  on_{b}: {{body: {b}, stiffness: {stiffness}}}\n" for b in ("driver", "driven"))
    rest = f"bearings:\n{bearings}damping: {{modal: 0.005}}\n"
    system = compiled(pair("{law: constant, value: 3e8 N/m}", beta="17 deg", motion="free", rest=rest))[1]
    data = pp.solve_campbell(system, np.linspace(1.0, 20.0, 5), "driver", orders=["mesh"])
    modes = find_modes(system)
    share = dict(
        zip(modes.names, modes.energies.strain[:, modes.groups.components.index("mesh stage")], strict=True)
    )
    checked = 0
    for k, name in enumerate(modes.names):
        if share[name] > 0.1:
            f = modes.damped_frequency[k]
            response = pp.solve_frequency_response(
                system,
                ["transmission_error[stage]"],
                ["mesh_force[stage]"],
                f * np.linspace(0.995, 1.005, 101),
            )
            peak = response.amplitude.values[:, 0, 0].max() / 3e8
            assert peak == pytest.approx(share[name] / (2.0 * 0.005), abs=1.0)
            checked += 1
    assert checked == 2
    assert data.sizes["mode"] == len(modes.names)


def test_energies_of_whirl_balance(geared):
    """T = V + E with gyroscopic energy E, for damped modes at any speed; shares sum to 1.

    The mesh and the loads make K unsymmetric by 1e-6 of the stiffness.
    """
    data = pp.solve_campbell(geared, np.linspace(0.0, 9000.0, 7) * RPM, "rotor")
    moving = data["frequency"].values > 1.0
    balance = (data["strain_to_kinetic"] + data["gyroscopic_share"]).values[moving]
    assert balance == pytest.approx(np.ones(balance.size), abs=1e-5)
    assert data["strain_share"].sum("component").values[moving] == pytest.approx(1.0, abs=1e-9)
    assert data["kinetic_share"].sum(["part", "motion"]).values[moving] == pytest.approx(1.0, abs=1e-9)
    fast = data.isel(speed=-1)
    names = list(data["name"].values)
    forward, backward = (names.index(f"1st bending of rotor ({w})") for w in ("forward", "backward"))
    assert fast["gyroscopic_share"].values[forward] > 0.1
    assert fast["gyroscopic_share"].values[backward] < -0.1


def test_whirl_energy_in_closed_form(rotor):
    """Tilt: V/T = k/(I_t w^2) and E/T = +-I_p W/(I_t w)."""
    data = pp.solve_campbell(rotor, [800.0], "disc")
    names = list(data["name"].values)
    for word, sign in (("forward", 1.0), ("backward", -1.0)):
        k = names.index(f"tilting of disc ({word})")
        omega = 2.0 * math.pi * data["frequency"].values[0, k]
        ratio = sign * I_P * 800.0 / (I_T * omega)
        assert data["gyroscopic_share"].values[0, k] == pytest.approx(ratio, rel=1e-4)
        assert data["strain_to_kinetic"].values[0, k] == pytest.approx(1.0 - ratio, rel=1e-4)
        assert data["whirl_index"].values[0, k] == pytest.approx(sign, abs=1e-6)


def test_whirl_is_seen_in_the_sense_of_rotation(rotor):
    """A rotor that turns the other way has the same forward modes."""
    one, other = (pp.solve_campbell(rotor, [speed], "disc") for speed in (800.0, -800.0))
    pairs = [dict(zip(d["name"].values, d["frequency"].values[0], strict=True)) for d in (one, other)]
    assert pairs[0] == pytest.approx(pairs[1], rel=1e-9)


def test_two_inertias(tmp_path):
    """Torsion of two inertias on a shaft: f^2 = k (1/J1 + 1/J2), no whirl, driven by nothing that is 1x."""
    text = """\
bodies:
  motor: {motion: torsion, inertia: 0.5, position: [0, 0, 0]}
  pump: {motion: torsion, inertia: 2.0, position: [0, 0, 1]}
torsion_springs: {shaft: {bodies: [motor, pump], stiffness: 2000, damping: 1.0}}
"""
    data = pp.solve_campbell(
        compiled(text)[1], np.linspace(0.0, 300.0, 11), "motor", orders=["1x", "2x", "3"]
    )
    assert list(data["name"].values) == ["rigid rotation", "torsion of motor against pump"]
    omega, decay = math.sqrt(2000.0 * 2.5), 1.0 * 2.5 / 2.0
    for c in ranked_speeds(data):
        assert c.order == "3×"
        assert c.speed == pytest.approx(math.sqrt(omega**2 - decay**2) / 3.0, rel=1e-9)
        assert c.amplification == pytest.approx(omega / (2.0 * decay), rel=1e-9)
    assert data["strain_share"].values[:, 1, 0] == pytest.approx(np.ones(11))
    assert data["kinetic_share"].sel(motion="rotation").values[0, 1] == pytest.approx([0.8, 0.2])


def test_equal_responses_of_harmonics_have_the_lowest_first():
    """Rounding does not decide: all orders of one mode have one response, and equal inertias one effect."""
    text = """\
bodies:
  motor: {motion: torsion, inertia: 0.7, position: [0, 0, 0]}
  pump: {motion: torsion, inertia: 0.7, position: [0, 0, 1]}
torsion_springs: {shaft: {bodies: [motor, pump], stiffness: 2000, damping: 1.0}}
"""
    data = pp.solve_campbell(compiled(text)[1], np.linspace(0.0, 50.0, 6), "motor", orders=list("3456789"))
    ranked = ranked_speeds(data)
    assert [c.order for c in ranked] == [f"{k}×" for k in range(3, 10)]
    assert [[name for name, _ in c.moved_by] for c in ranked] == 7 * [
        [name for name, _ in ranked[0].moved_by]
    ]


def test_orders_of_a_geared_rotor(geared):
    found = follow_modes(geared, np.linspace(300.0, 900.0, 3) * RPM, "rotor")
    orders = excitation_orders(
        geared, found.motions, found.rates, ["1x", "mesh", "2sidebands"], {"BPFO a": 3.5}
    )
    by_name = {order.name: order.value for order in orders}
    assert by_name == pytest.approx(
        {"1× drive": 1 / 3, "1× rotor": 1.0, "BPFO a": 3.5, "mesh stage": 23.0}
        | {
            f"mesh stage {s} {j}× {g}": 23.0 + d * j * o
            for s, d in (("−", -1.0), ("+", 1.0))
            for j in (1, 2)
            for g, o in (("rotor", 1.0), ("drive", 1 / 3))
        }
    )
    with pytest.raises(SolverError, match="'3q' is not an order"):
        excitation_orders(geared, found.motions, found.rates, ["3q"])


def test_crossings_and_speeds_between_are_those_of_the_whole_system(geared):
    """The reduced basis and the inverse iteration against the eigenvalues of all coordinates.

    Matrices that are quadratic in the speed: the modes at the lowest, middle and highest speed span those at
    all others. A fourth one would mean that the double zero of the rigid rotation, which rounding splits, had
    been taken for an oscillation.
    """
    found = follow_modes(geared, np.linspace(300.0, 7200.0, 31) * RPM, "rotor")
    assert found.modes.basis is not None
    assert list(found.modes.exact) == pytest.approx([300.0 * RPM, 3750.0 * RPM, 7200.0 * RPM])
    for s in (3, 12, 22):
        linear = at_one_azimuth(found.modes.linear, found.rates).at(found.speed[s])
        exact = damped_modes(linear, found.modes.modes).values
        assert found.eigenvalue[s, 1:].imag == pytest.approx(
            _matched(found.eigenvalue[s, 1:], exact).imag, rel=1e-7
        )
        assert ratio_of(found.eigenvalue[s, 1:]) == pytest.approx(
            ratio_of(_matched(found.eigenvalue[s, 1:], exact)), abs=1e-7
        )
    orders = excitation_orders(geared, found.motions, found.rates, ["1x", "mesh"])
    for c in critical_speeds(found, orders)[:6]:
        linear = at_one_azimuth(found.modes.linear, found.rates).at(c.speed)
        exact = damped_modes(linear, found.modes.modes).values
        assert np.abs(exact.imag / (2.0 * math.pi) - c.frequency).min() < 1e-6 * c.frequency


def _matched(values, exact):
    """Exact eigenvalues closest to some values."""
    return exact[np.abs(values[:, None] - exact).argmin(axis=1)]


def test_branches_are_continuous_and_say_where_they_change_character(geared):
    """Bending of the disc and of the drive veer near 1500 rpm: curves go on, their shapes change places."""
    found = follow_modes(geared, np.linspace(300.0, 7200.0, 61) * RPM, "rotor")
    assert np.abs(np.diff(found.frequency, axis=0)).max() < 4.0
    assert len(set(found.names)) == len(found.names)
    changed = [k for k in range(len(found.names)) if np.any(found.character[:, k] != k)]
    assert changed
    assert all(np.all(found.character[0, k] == k) or k in changed for k in range(len(found.names)))


def test_selection_and_separation(geared):
    data = pp.solve_campbell(
        geared, np.linspace(300.0, 7200.0, 21) * RPM, "rotor", operating=(4500.0 * RPM, 5000.0 * RPM)
    )
    low = select_modes(data, "bending of rotor", (0.0, 300.0))
    assert [str(n) for n in low["name"].values] == [
        "1st bending of rotor (backward)",
        "1st bending of rotor (forward)",
    ]
    for c in ranked_speeds(low):
        assert c.mode.startswith("1st bending of rotor")
        rpm = c.speed / RPM
        expected = rpm / 5000.0 - 1.0 if rpm > 5000.0 else min(rpm / 4500.0 - 1.0, 0.0)
        assert c.separation == pytest.approx(expected, abs=1e-9)
    assert separation(np.array([90.0]), (100.0, 100.0)) == pytest.approx([-0.1])


def test_modes_and_campbell_have_one_frequency(geared):
    modes = pp.solve_modal(geared, "fast")
    data = pp.solve_campbell(geared, [4500.0 * RPM], "rotor", "fast")
    n = data.sizes["mode"]
    assert data["frequency"].attrs == modes["frequency"].attrs
    assert data["damping_ratio"].attrs == modes["damping_ratio"].attrs
    assert list(data["name"].values) == list(modes["name"].values[:n])
    assert data["frequency"].values[0] == pytest.approx(modes["frequency"].values[:n], rel=1e-7, abs=1e-6)


def test_orders_as_text_are_those_of_the_command(rotor):
    """`mesh,2` in one text, as a list, and with numbers; single letters are no orders."""
    texts = ("1x, 2x,3", ["1x", "2x", "3"], ["1x", "2x", 3])
    found = [pp.solve_campbell(rotor, [100.0, 200.0], "disc", orders=orders) for orders in texts]
    for data in found:
        assert data["excitation"].values.tolist() == ["1× disc", "2× disc", "3×"]
    with pytest.raises(SolverError, match="'bearings' is not an order; .* more_orders"):
        pp.solve_campbell(rotor, [100.0, 200.0], "disc", orders="1x,bearings")


BALLS = (9, 8e-3, 39e-3)
BEARINGS = f"""\
bodies:
  rotor: {{motion: free, mass: 3, inertia: 0.006, transverse_inertia: 0.012}}
rolling_bearings:
  front: {{body: rotor, position: [0, 0, -40 mm], type: ball, elements: {BALLS[0]}, contact_angle: 0 deg,
    element_diameter: {BALLS[1]}, grooves: [0.52, 0.52], pitch_diameter: {BALLS[2]}, damping: 200}}
  rear: {{body: rotor, position: [0, 0, 40 mm], designation: NU 205 ECP, damping: 200}}
bearings: {{end: {{body: rotor, stiffness: {{axial: 1e8}}}}}}
torsion_springs: {{front: {{bodies: [rotor], stiffness: 5000, damping: 0.5}}}}
loads: {{weight: {{body: rotor, force: [0, -2 kN, 0]}}}}
"""


def test_orders_of_bearing_faults():
    """BPFO and BPFI are n/2 (1 -+ d/D) per revolution, and drive modes through their bearing.

    A torsion spring of the same name is not the bearing: its mode has no strain energy there.
    """
    data = campbell_of(
        compiled(BEARINGS)[0], body="rotor", speeds=(10.0, 3000.0), points=12, orders="bearings"
    )
    orders = dict(zip(data["excitation"].values, data["excitation_order"].values, strict=True))
    n, d, pitch = BALLS
    for word, sign in (("BPFO", -1.0), ("BPFI", 1.0)):
        assert orders[f"{word} front"] == pytest.approx(0.5 * n * (1.0 + sign * d / pitch), rel=1e-9)
    assert {name.split()[1] for name in orders} == {"front", "rear"}
    ranked = ranked_speeds(data, least=0.0)
    torsion = [c for c in ranked if c.mode == "torsion of rotor against ground" and c.order == "BPFO front"]
    assert [c.participation for c in torsion] == pytest.approx([0.0], abs=1e-6)
    axial = next(c for c in ranked if c.mode == "axial mode of rotor" and c.order == "BPFO front")
    share = data["strain_share"].sel(component="rolling bearing front")
    expected = share.values[:, list(data["name"].values).index("axial mode of rotor")].mean()
    assert (axial.source, axial.participation) == ("bearing fault", pytest.approx(expected, rel=0.02))
    assert expected > 0.03
    with pytest.raises(SolverError, match="no rolling_bearings"):
        campbell_of(compiled(ROTOR)[0], body="disc", speeds=(10.0, 300.0), orders="bearings")


def test_finely_divided_shafts_need_few_solutions_of_the_whole_system(geared):
    """The basis is complete in energy, not only in mass: its modes at other speeds have small residuals."""
    fine = pp.load_model(EXAMPLE)
    for shaft in ("rotor", "drive"):
        fine = fine.replace(f"shafts.{shaft}.largest_piece", "55 mm")
    found = follow_modes(pp.compile_model(fine, "fast"), np.linspace(300.0, 7200.0, 30) * RPM, "rotor")
    assert found.shape.shape[2] == 132
    assert len(found.modes.exact) < 9
    linear = at_one_azimuth(found.modes.linear, found.rates).at(found.speed[7])
    exact = damped_modes(linear, found.modes.modes).values
    assert found.eigenvalue[7, 1:] == pytest.approx(_matched(found.eigenvalue[7, 1:], exact), rel=1e-8)


def test_what_moves_the_critical_speed_of_a_tilting_disc(rotor):
    """W^2 = k/(I_t -+ I_p) with light damping: 1/2 per stiffness, -1/2 per inertia, also forward at 1x.

    The branch itself moves by half of that or less: it crosses the order at a slope. Damping of 0.2 % and the
    secant between points 75 rad/s apart limit the accuracy.
    """
    data = pp.solve_campbell(rotor, np.linspace(0.0, 3000.0, 41), "disc", orders=["1x"])
    assert data.sizes["crossing"] == 5  # two of translation, two of tilt, the soft torsional support
    np.testing.assert_allclose(data.crossing_stiffness_sensitivity.sum("component"), 0.5, rtol=2e-3)
    np.testing.assert_allclose(data.crossing_inertia_sensitivity.sum("part"), -0.5, rtol=2e-3)


def test_what_moves_critical_speeds_is_what_another_solution_gives():
    """Mass and stiffness changed by 0.2 %: critical speeds of a rotor with an overhung disc."""
    model = pp.load_model(EXAMPLE)
    speeds = np.linspace(3600.0, 6600.0, 11) * RPM

    def solved(changes=None):
        system = pp.compile_model(model.replace_all(changes) if changes else model, "fast")
        return pp.solve_campbell(system, speeds, "rotor", "fast", orders=["1x"])

    data, rel = solved(), 0.002
    disc = {"mass": 4.93, "inertia": 0.02465, "transverse_inertia": 0.01249}
    changed = {
        ("stiffness", "component", "bearing rotor_2"): {"bearings.rotor_2.stiffness.radial": 1e8},
        ("inertia", "part", "disc"): {f"bodies.disc.{key}": value for key, value in disc.items()},
    }
    assert data.sizes["crossing"] == 2
    for (what, over, name), values in changed.items():
        by_whirl = [
            dict(zip(d.crossing_whirl.values, d.crossing_speed.values, strict=True))
            for d in (solved({k: v * (1.0 + sign * rel) for k, v in values.items()}) for sign in (1.0, -1.0))
        ]
        sensitivity = data[f"crossing_{what}_sensitivity"].sel({over: name}).values
        for whirl, speed, found in zip(
            data.crossing_whirl.values, data.crossing_speed.values, sensitivity, strict=True
        ):
            moved = (by_whirl[0][whirl] - by_whirl[1][whirl]) / (2.0 * rel * speed)
            assert found == pytest.approx(moved, rel=0.01), (name, whirl)
            assert abs(moved) > 0.005


def test_slopes_of_branches_do_not_depend_on_rounding():
    """A frequency that does not change with speed but for rounding, 1e-9, in the last steps of a crossing."""
    calls: list[float] = []

    def near(speed: float, value: complex, shape: Any) -> tuple[complex, Any]:
        calls.append(speed)
        return 20j * (1.0 + 2e-9 * (-1) ** len(calls)), shape

    found = SimpleNamespace(
        speed=np.array([0.05, 0.25]),
        frequency=np.full((2, 1), 20.0 / (2.0 * np.pi)),
        eigenvalue=np.full((2, 1), 20j),
        shape=np.ones((2, 1, 1)),
        modes=SimpleNamespace(near=near),
    )
    speed, _, _, slope = _solve(found, 117.0, 0, (0, 1))
    assert len(calls) > 2
    assert speed == pytest.approx(20.0 / 117.0, rel=1e-8)
    assert abs(slope) < 1e-3
