# SPDX-License-Identifier: Apache-2.0
"""Model files with a planetary stage, and the same machine written by hand."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model

TEETH = "normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0"
LAW = "stiffness: {law: constant, value: 5e8 N/m}, damper: {ratio: 0.05}"
ARM = 90e-3
"""Distance of the pins from the axis of 21/39/99 teeth [m]."""
PIN_BEARING = "stiffness: {radial: 5e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}"
JOINTS = {"torsion": "revolute", "planar": "planar", "free": "shaft"}


def machine(sun: str = "torsion", torque: float = 600.0, axes: str = "") -> str:
    """Bodies of sun, ring and carrier, their loads and scenarios; `sun` is the motion of the sun."""
    floating = sun != "torsion"
    spline = "{radial: 1e3 N/m, axial: 1e7 N/m, tilt: 1e5 N m/rad}"
    return "\n".join(
        [
            "bodies:",
            f"  sun: {{gears: [sun], motion: {sun}, position: [0, 0, 0]{axes}}}",
            f"  ring: {{gears: [ring], motion: fixed, position: [0, 0, 0]{axes}}}",
            f"  carrier: {{inertia: 0.1 kg m^2, mass: 10 kg, position: [0, 0, 0]{axes}}}",
            *(["bearings:", f"  spline: {{body: sun, stiffness: {spline}}}"] if floating else []),
            "loads:",
            f"  motor: {{body: sun, torque: {torque!r} N m}}",
            "  brake: {body: carrier, torque: balance}",
            "scenarios:",
            "  steady: {speed: {sun: 1000 rpm}, duration: 5 ms, settle_time: 2 ms}",
            "  slow: {quasi_static: {mesh: sun-planet_1, points: 4}}",
        ]
    )


def gears() -> str:
    """Sun and ring."""
    return (
        f"gears:\n  sun: {{number_of_teeth: 21, {TEETH}}}\n"
        f"  ring: {{type: internal, number_of_teeth: 99, {TEETH}, tip_diameter: 292.5 mm}}\n"
    )


def stage_file(more: str = "planets: 3", *, mesh: str = LAW, **how: str | float) -> str:
    """Model file with a stage; `more` are its further keys, `how` arguments of `machine`."""
    return (
        gears()
        + "planetary_stages:\n  set:\n    sun: sun\n    ring: ring\n    carrier: carrier\n"
        + f"    planet: {{number_of_teeth: 39, {TEETH}}}\n"
        + f"    sun_mesh: {{{mesh}}}\n    ring_mesh: {{{mesh}}}\n"
        + "".join(f"    {line}\n" for line in more.splitlines())
        + machine(**how)  # type: ignore[arg-type]
        + "\n"
    )


def pin(angle: float, radial: float = 0.0, tangential: float = 0.0) -> tuple[float, float]:
    """Place of a pin in the plane of the carrier [m]."""
    out = ARM + radial
    return (
        out * math.cos(angle) - tangential * math.sin(angle),
        out * math.sin(angle) + tangential * math.cos(angle),
    )


def by_hand(
    errors: tuple[tuple[float, float], ...] = ((0.0, 0.0),) * 3,
    *,
    motion: str = "torsion",
    mesh: str = LAW,
    **how: str | float,
) -> str:
    """The stage with planets at equal angles, written by hand; `errors` are radial and tangential."""
    n = len(errors)
    own, text = [], gears()
    text += "".join(f"  planet_{k}: {{number_of_teeth: 39, {TEETH}}}\n" for k in range(1, n + 1))
    axes = str(how.get("axes", ""))
    for k, error in enumerate(errors, start=1):
        x, y = pin(math.tau * (k - 1) / n, *error)
        own.append(f"  planet_{k}: {{gears: [planet_{k}], position: [{x!r} m, {y!r} m, 0]{axes}}}")
    lines = machine(**how).split("\n")  # type: ignore[arg-type]
    bearings = [
        f"  planet_{k}-bearing: {{body: planet_{k}, housing: carrier, {PIN_BEARING}}}"
        for k in range(1, n + 1)
        if motion != "torsion"
    ]
    if bearings and "bearings:" in lines:
        lines[lines.index("bearings:") + 2 : lines.index("bearings:") + 2] = bearings
    elif bearings:
        lines[4:4] = ["bearings:", *bearings]
    lines[4:4] = own
    joints = [
        f"  planet_{k}-pin: {{type: {JOINTS[motion]}, bodies: [carrier, planet_{k}]}}"
        for k in range(1, n + 1)
    ]
    meshes = [f"  sun-planet_{k}: {{gears: [sun, planet_{k}], {mesh}}}" for k in range(1, n + 1)]
    meshes += [f"  planet_{k}-ring: {{gears: [planet_{k}, ring], {mesh}}}" for k in range(1, n + 1)]
    return "\n".join([text.rstrip("\n"), *lines, "joints:", *joints, "meshes:", *meshes, ""])


def planet_set(sun: int, planet: int, ring: int, count: int, module: float = 4.0) -> Model:
    """Model of a set with its ring held, planets written by hand; torque into the sun, out of the carrier."""
    gear = (
        "number_of_teeth: {}, normal_module: {} mm, face_width: 40 mm, profile_shift_coefficient: 0, "
        "normal_pressure_angle: 25 deg"
    )
    arm = 0.5 * module * (sun + planet)
    angles = 2.0 * np.pi * np.arange(count) / count
    places = [(float(arm * np.cos(a)), float(arm * np.sin(a))) for a in angles]
    mesh = "stiffness: {law: constant, value: 5e8 N/m}, damper: {ratio: 0.05}"
    lines = [
        "gears:",
        f"  sun: {{{gear.format(sun, module)}}}",
        f"  ring: {{{gear.format(ring, module)}, type: internal}}",
        *(f"  p{k}: {{{gear.format(planet, module)}}}" for k in range(count)),
        "bodies:",
        "  sun: {gears: [sun], position: [0, 0, 0]}",
        "  carrier: {inertia: 0.5 kg m^2, mass: 10 kg, position: [0, 0, 0]}",
        "  ring: {gears: [ring], motion: fixed, position: [0, 0, 0]}",
        *(f"  b{k}: {{gears: [p{k}], position: [{x!r} mm, {y!r} mm, 0]}}" for k, (x, y) in enumerate(places)),
        "joints:",
        *(f"  pin{k}: {{type: revolute, bodies: [carrier, b{k}]}}" for k in range(count)),
        "meshes:",
        *(f"  s{k}: {{gears: [sun, p{k}], {mesh}}}" for k in range(count)),
        *(f"  r{k}: {{gears: [p{k}, ring], {mesh}}}" for k in range(count)),
        "loads:",
        "  in: {body: sun, torque: 300 N m}",
        "  out: {body: carrier, torque: balance}",
        "scenarios:",
        "  steady: {speed: {sun: 1000 rpm}, duration: 20 ms}",
    ]
    return loads_model("\n".join(lines))
