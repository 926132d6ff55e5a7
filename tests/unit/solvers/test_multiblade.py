# SPDX-License-Identifier: Apache-2.0
"""Rotors in multi-blade coordinates: whirl on an isotropic support in closed form; what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.multiblade import find_multiblade_modes, solve_multiblade_modes
from pitchpoint.system.compile import compile_model

HUB_INERTIA, BLADE_INERTIA, SEAT, HINGE = 2.0, 1.0, 300.0, 60.0


def rotor(count, speed, heavier=1.0, more="", parts="joints:\n", roped=False):
    """Rods of 1 m on hinges at the centre of a hub that turns on a body that tilts in all directions."""
    blades, hinges, springs, markers = "", "", "", []
    for k in range(count):
        c, s = math.cos(math.tau * k / count), math.sin(math.tau * k / count)
        axes = f"{{z: [{-s!r}, {c!r}, 0], x: [{c!r}, {s!r}, 0]}}"
        mass = 3.0 * BLADE_INERTIA * (heavier if k == 0 else 1.0)
        blades += (
            f"  blade_{k}: {{mass: {mass} kg, center_of_mass: [0.5 m, 0, 0], inertia_tensor: "
            f"[1e-9, {mass / 12}, {mass / 12}, 0, 0, 0], position: [0, 0, 0], axes: {axes}"
            f"{', markers: {tip: {position: [1 m, 0, 0]}}' if roped else ''}}}\n"
        )
        hinges += (
            f"  hinge_{k}: {{type: revolute, bodies: [hub, blade_{k}], position: [0, 0, 0], axes: {axes}}}\n"
        )
        springs += (
            f"  spring_{k}: {{ends: [hub.at_{k}, blade_{k}], stiffness: {{torsion: {HINGE} N m/rad}}}}\n"
        )
        markers.append(f"at_{k}: {{position: [0, 0, 0], axes: {axes}}}")
    if roped:
        markers.append("top: {position: [0, 0, 1 m]}")
    text = (
        f"bodies:\n  nacelle: {{mass: 1 kg, inertia_tensor: {3 * [HUB_INERTIA] + 3 * [0.0]},"
        f" position: [0, 0, 0]}}\n  hub: {{inertia: 1e-6 kg m^2, position: [0, 0, 0], markers: "
        f"{{{', '.join(markers)}}}}}\n{blades}{parts}"
        "  mount: {type: universal, bodies: [ground, nacelle], position: [0, 0, 0]}\n"
        "  bearing: {type: revolute, bodies: [nacelle, hub], position: [0, 0, 0]}\n"
        f"{hinges}bushings:\n  seat: {{ends: [ground, nacelle], stiffness: {{tilt: {SEAT} N m/rad}}}}\n"
        f"{springs}scenarios: {{turn: {{drive: {{hub: {{speed: {speed} rad/s}}}}, duration: 1 s}}}}\n{more}"
    )
    return compile_model(loads_model(text), "turn")


def names(count):
    return [f"blade_{k}" for k in range(count)]


@pytest.mark.parametrize(("count", "speed"), [(3, 5.0), (3, -5.0), (4, 5.0), (5, 3.0), (3, 0.0)])
def test_whirl_of_flapping_blades_on_a_tilting_hub(count, speed):
    """With z = z_flap + z_hub, complex in axes that do not turn, blades of inertia I about their hinges have

        I (z'' - 2 i Omega z') + k z_flap = 0,   B/2 I (z'' - 2 i Omega z') + I_h z_hub'' + k_h z_hub = 0:

    their centrifugal stiffness I Omega^2 balances that of the transformation. With A = I (w^2 - 2 Omega w),
    (k_h - I_h w^2)(k - A) = B/2 k A for whirl, w > 0 forward; sqrt(Omega^2 + k/I) for the collective mode and
    that of alternate blades, and 2 Omega more and less for those that bend in the shape cos 2 psi.
    """
    w = np.poly1d([1.0, 0.0])
    A = BLADE_INERTIA * (w * w - 2.0 * abs(speed) * w)
    roots = ((SEAT - HUB_INERTIA * w * w) * (HINGE - A) - 0.5 * count * HINGE * A).roots.real
    flap = math.hypot(speed, math.sqrt(HINGE / BLADE_INERTIA))
    rest = [flap, *([flap] if count == 4 else []), *([flap - 6.0, flap + 6.0] if count == 5 else [])]
    found = find_multiblade_modes(rotor(count, speed), hub="hub", blades=names(count), azimuths=2)
    np.testing.assert_allclose(found.eigenvalue.imag, np.sort(np.abs([*roots, *rest])), rtol=1e-7)
    np.testing.assert_allclose(found.damping_ratio, 0.0, atol=1e-9)
    assert found.speed == speed
    if speed:
        for root in roots:
            at = np.argmin(np.abs(found.eigenvalue.imag - abs(root)))
            np.testing.assert_allclose(found.blades[at], [0.0, root > 0.0, root < 0.0], atol=1e-5)


def test_the_mean_over_azimuths_is_any_of_them_for_an_isotropic_rotor():
    one, six = (
        find_multiblade_modes(rotor(3, 5.0), hub="hub", blades=names(3), azimuths=n).eigenvalue
        for n in (1, 6)
    )
    np.testing.assert_allclose(one, six, rtol=1e-9, atol=1e-9)


def test_the_dataset_has_the_modes():
    found = solve_multiblade_modes(rotor(3, 5.0), "turn", hub="hub", blades=names(3))
    assert found.frequency.attrs["units"] == "Hz"
    assert found.forward.values.round(6).tolist() == [0.0, 0.0, 1.0, 0.0, 1.0]
    assert float(found.frequency[1]) == pytest.approx(math.sqrt(85.0) / math.tau)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"blades": ["blade_0", "blade_1"]}, "2 blades .limit 3."),
        ({"blades": ["blade_0", "blade_1", "wing"]}, "wing: no body or beam has this name"),
        ({"blades": ["blade_0", "blade_1", "nacelle"]}, "nacelle: is not carried by hub"),
        ({"blades": ["blade_0", "blade_1", "blade_1"]}, "are not equal branches"),
        ({"hub": "blade_0"}, "blade_0: is not carried by blade_0"),
    ],
)
def test_wrong_blades_are_told(arguments, words):
    with pytest.raises(CompileError, match=words):
        find_multiblade_modes(rotor(3, 5.0), **{"hub": "hub", "blades": names(3), **arguments})


def test_a_heavier_blade_is_told():
    with pytest.raises(CompileError, match="masses differ by 2 %"):
        find_multiblade_modes(rotor(3, 5.0, heavier=1.02), hub="hub", blades=names(3))


def test_a_missing_blade_is_told():
    with pytest.raises(CompileError, match="angles between them differ by 25 %"):
        find_multiblade_modes(rotor(4, 5.0), hub="hub", blades=names(3))


def test_ratios_between_blades_are_refused():
    more = "ratios: {pair: {terms: {blade_0: 1, blade_1: -1}}}\n"
    with pytest.raises(CompileError, match="closed loops or ratios"):
        find_multiblade_modes(rotor(3, 5.0, more=more), hub="hub", blades=names(3))


def test_a_gearbox_of_the_support_has_its_own_modes():
    """A wheel of 1 kg m^2 on a spring with a motor of 0.5 kg m^2 at twice its speed: w^2 = k/(J + 4 J_m)."""
    more = (
        "  wheel: {inertia: 1, position: [0, 0, 1]}\n  motor: {inertia: 0.5, position: [1, 0, 1]}\n"
        "ratios: {teeth: {terms: {wheel: 2, motor: -1}}}\n"
        "torsion_springs: {rod: {bodies: [wheel], stiffness: 48}}\njoints:\n"
    )
    found = find_multiblade_modes(rotor(3, 5.0, parts=more), hub="hub", blades=names(3), azimuths=2)
    alone = find_multiblade_modes(rotor(3, 5.0), hub="hub", blades=names(3), azimuths=2)
    expected = np.sort([*alone.eigenvalue.imag, 4.0])
    np.testing.assert_allclose(found.eigenvalue.imag, expected, rtol=1e-9)


def test_states_of_elements_on_the_blades():
    """Maxwell elements from the tips of the blades to a point 1 m above the hub, at 45 deg: with K = k/2, C =
    c/2 the collective mode has (I s^2 + k_h + I Omega^2) (K + C s) + K C s = 0. Relaxation is not a mode."""
    springs = [f"rope_{k}: {{ends: [hub.top, blade_{k}.tip], stiffness: 80, damping: 10}}" for k in range(3)]
    system = rotor(3, 5.0, roped=True, more=f"maxwells: {{{', '.join(springs)}}}\n")
    found = find_multiblade_modes(system, hub="hub", blades=names(3), azimuths=2)
    s = np.poly1d([1.0, 0.0])
    roots = ((BLADE_INERTIA * s * s + HINGE + BLADE_INERTIA * 25.0) * (40.0 + 5.0 * s) + 200.0 * s).roots
    assert len(found.eigenvalue) == 5
    collective = found.eigenvalue[np.argmax(found.blades[:, 0])]
    assert collective == pytest.approx(roots[roots.imag > 0.0][0], rel=1e-6)
