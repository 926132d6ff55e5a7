# SPDX-License-Identifier: Apache-2.0
"""Kinematic frequencies of faulty rolling bearings in time runs, against their closed forms.

With n elements of diameter D on the circle d_m, contact angle alpha, g = (D/d_m) cos(alpha) and f the speed
of one ring against the other [Hz] (T. A. Harris, *Rolling Bearing Analysis*; R. B. Randall and J. Antoni,
Mech. Syst. Signal Process. 25, 2011):

    BPFO = n/2 f (1 - g),   BPFI = n/2 f (1 + g),   BSF = d_m/(2 D) f (1 - g^2),
    FTF = f/2 (1 - g) with the inner ring turning, f/2 (1 + g) with the outer one

A rotor without weight in a preloaded bearing sees the same stiffness from all sides. What a fault does to it
is then periodic in the frame that carries the fault: its force x + i y has lines at f_0 + k f_1 alone, f_0
the speed of that frame and f_1 the frequency of the fault. Frames turn with the outer ring, the inner ring
or the cage.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

MODEL = """\
bodies:
  rotor: {{motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01 kg m^2}}
rolling_bearings:
  b:
    {{ends: [{ends}], elements: 9, element_diameter: 7.94 mm, pitch_diameter: 39.04 mm, {kind},
     damping: 5, clearance: -40 um, faults: {faults}}}
{loads}
scenarios:
  s: {{drive: {{rotor: {{speed: 1797 rpm}}}}, duration: {duration}, sample_rate: 40 kHz, step: 2.5e-5 s}}
"""
KINDS = {
    "ball": ("grooves: [0.52, 0.52]", 0.0),
    "angular contact ball": ("grooves: [0.52, 0.52], contact_angle: 25 deg", 25.0),
    "roller": ("type: roller, effective_length: 8 mm", 0.0),
}
SIZE = "length: 1 mm, depth: 0.1 mm"
FAULTS = {
    "outer": f"type: outer_race, {SIZE}",
    "inner": f"type: inner_race, angle: 20 deg, {SIZE}",
    "element": f"type: rolling_element, element: 3, {SIZE}",
    "cage": "type: cage, element: 2, widening: 3 deg",
}
SPEED = 1797.0 / 60.0
RATE, SETTLED = 40000, 8000


def frequencies(angle=0.0, outer_turns=False):
    """BPFO, BPFI, BSF, FTF [Hz]."""
    g = 7.94 / 39.04 * np.cos(np.radians(angle))
    cage = 0.5 * SPEED * (1.0 + g if outer_turns else 1.0 - g)
    spin = 0.5 * 39.04 / 7.94 * SPEED * (1.0 - g * g)
    return 4.5 * SPEED * (1.0 - g), 4.5 * SPEED * (1.0 + g), spin, cage


def push(fault, kind="ball", ends="rotor, ground", loads="", duration="4.2 s"):
    """Force x + i y on the inner ring in the world [N], at 40 kHz after 0.2 s to settle."""
    faults = "{}" if fault is None else "{f: {" + FAULTS[fault] + "}}"
    text = MODEL.format(ends=ends, kind=KINDS[kind][0], faults=faults, loads=loads, duration=duration)
    run = solve_time(compile_model(loads_model(text), "s"))
    force = run["bearing_force[b.fx]"].values + 1j * run["bearing_force[b.fy]"].values
    return force[SETTLED:-1]


def power_spectrum(signal):
    """Frequencies [Hz] and power of the two-sided spectrum, Hann window."""
    power = np.abs(np.fft.fft((signal - signal.mean()) * np.hanning(signal.size))) ** 2
    return np.fft.fftfreq(signal.size, 1.0 / RATE), power


@pytest.mark.each_value
@pytest.mark.parametrize(
    ("kind", "outer_turns"),
    [
        ("ball", False),
        ("ball", True),
        pytest.param("angular contact ball", False, marks=pytest.mark.study),
        ("angular contact ball", True),
        ("roller", False),
        pytest.param("roller", True, marks=pytest.mark.study),
    ],
)
@pytest.mark.parametrize("fault", FAULTS)
def test_lines_of_a_fault_are_those_of_its_frame(fault, kind, outer_turns):
    """99.9 % of the power within three lines (1.5 Hz) of the predicted ones; by chance it would be 2 to 4 %.

    Most of the rest lies above half of the sample rate and shows at wrong frequencies: with 20 kHz it is ten
    times as large.
    """
    bpfo, bpfi, bsf, ftf = frequencies(KINDS[kind][1], outer_turns)
    standing, turning = (SPEED, 0.0) if outer_turns else (0.0, SPEED)
    first, step = {
        "outer": (standing, bpfo),
        "inner": (turning, bpfi),
        "element": (ftf, bsf),
        "cage": (ftf, 9.0 * ftf),
    }[fault]
    z = push(fault, kind, "ground, rotor" if outer_turns else "rotor, ground", duration="2.2 s")
    f, power = power_spectrum(z)
    off = np.abs((f - first + 0.5 * step) % step - 0.5 * step)
    assert power[off < 1.5].sum() > 0.999 * power.sum()
    largest = f[np.argmax(power)]
    assert largest == pytest.approx(first + step * np.round((largest - first) / step), abs=0.5)


def test_frequencies_of_a_loaded_bearing_to_a_thousandth():
    """Under a radial load lines lie at multiples of the fault frequency, with sidebands of its load zone.

    The outer race meets it in place, the inner race once per turn of the shaft, an element once per turn of
    the cage. Frequencies by interpolation of the highest lines (Hann).
    """
    bpfo, bpfi, bsf, ftf = frequencies()
    load = "loads:\n  w: {body: rotor, force: [2000 N, 0, 0]}\n"
    expected = {"outer": (bpfo, 0.0), "inner": (bpfi, SPEED), "element": (2.0 * bsf, ftf)}
    for fault, (step, side) in expected.items():
        f, power = power_spectrum(push(fault, loads=load).real)
        amplitude = np.sqrt(power)
        for order in (1, 2, 3):
            for band in (-1, 0, 1) if side else (0,):
                wanted = order * step + band * side
                near = np.flatnonzero(np.abs(f - wanted) < 2.0)
                top = near[np.argmax(power[near])]
                a, b, c = amplitude[top - 1 : top + 2]
                shift = (2.0 * c - b) / (b + c) if c > a else -(2.0 * a - b) / (a + b)
                assert f[top] + 0.25 * shift == pytest.approx(wanted, rel=1e-3), (fault, order, band)


def test_severity_brings_the_fault_and_takes_it_away():
    text = MODEL.format(
        ends="rotor, ground",
        kind=KINDS["ball"][0],
        faults="{f: {" + FAULTS["outer"] + "}, i: {" + FAULTS["inner"] + ", severity: 0}}",
        loads="",
        duration="0.4 s",
    )
    model = loads_model(text)
    healthy = solve_time(compile_model(model.replace("rolling_bearings.b.faults", {}), "s"))
    sizes = []
    for severity in (0.0, 0.1, 0.3, 1.0):
        run = solve_time(compile_model(model.replace("rolling_bearings.b.faults.f.severity", severity), "s"))
        assert list(run) == list(healthy)
        sizes.append(float(run["bearing_force[b.fx]"].std()))
        if severity == 0.0:
            for name in healthy:
                scale = max(1.0, np.abs(healthy[name].values).max())  # round-off, as it grows in a run
                np.testing.assert_allclose(
                    run[name].values, healthy[name].values, rtol=0.0, atol=1e-9 * scale
                )
    assert np.all(np.diff(sizes) > 0.0)
