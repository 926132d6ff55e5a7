# SPDX-License-Identifier: Apache-2.0
"""Model files of compound planetary gearboxes: stepped planets, Ravigneaux, Simpson and Lepelletier sets."""

from __future__ import annotations

MESH = "{stiffness: {law: constant, value: 4e8 N/m}, damper: {ratio: 0.05}}"


def gear(z: int, *, module: float = 2.0, width: float = 20.0, more: str = "") -> str:
    """Keys of a gear without profile shift; more begins with a comma."""
    return (
        f"{{number_of_teeth: {z}, normal_module: {module} mm, face_width: {width} mm, "
        f"profile_shift_coefficient: 0, tooth_thickness_allowance: -30 um{more}}}"
    )


def ring(z: int, *, module: float = 2.0, width: float = 20.0, more: str = "") -> str:
    """Keys of a ring with shortened teeth; more begins with a comma."""
    words = f", type: internal, tip_diameter: {module * (z - 1)} mm{more}"
    return gear(z, module=module, width=width, more=words)


def stage(name: str, planet: str, count: int, carrier: str, *lines: str) -> str:
    """Entry of `planetary_stages`; its planets have its name."""
    own = [
        f"  {name}:",
        f"    planet_name: {name}",
        f"    planet: {planet}",
        f"    planets: {count}",
        f"    carrier: {carrier}",
        *(f"    {side}_mesh: {MESH}" for side in ("sun", "ring", "planet")),
        *(f"    {line}" for line in lines),
    ]
    return "\n".join(own) + "\n"


def ravigneaux(loads: str = "", scenarios: str = "", more: str = "", motion: str = "torsion") -> str:
    """Ravigneaux set of suns of 27 and 36 and a ring of 72 teeth; bodies have the names of their gears."""
    return (
        "gears:\n"
        f"  small_sun: {gear(27)}\n  large_sun: {gear(36)}\n  ring: {ring(72)}\n"
        "bodies:\n"
        "  small_sun: {gears: [small_sun], position: [0, 0, 25 mm]}\n"
        "  large_sun: {gears: [large_sun], position: [0, 0, 0]}\n"
        "  ring: {gears: [ring], position: [0, 0, 0]}\n"
        "  carrier: {inertia: 4e-3 kg m^2}\n"
        "planetary_stages:\n"
        + stage("short", gear(18), 3, "carrier", "sun: small_sun", f"motion: {motion}", *more.splitlines())
        + stage(
            "long",
            gear(18, width=45.0),
            3,
            "carrier",
            "sun: large_sun",
            "ring: ring",
            "inner_planets: short",
            "position: 12.5 mm",
            f"motion: {motion}",
            *more.splitlines(),
        )
        + loads
        + scenarios
    )


def simpson(scenarios: str = "", couplings: str = "") -> str:
    """Simpson set of two equal stages 30/21/72: common sun, front carrier and rear ring on the output."""
    return (
        "gears:\n"
        f"  front_sun: {gear(30)}\n  rear_sun: {gear(30)}\n"
        f"  front_ring: {ring(72)}\n  rear_ring: {ring(72)}\n"
        "bodies:\n"
        "  sun: {gears: {front_sun: 0, rear_sun: 60 mm}, position: [0, 0, 0]}\n"
        "  input: {gears: [front_ring], position: [0, 0, 0]}\n"
        "  output: {gears: {rear_ring: 60 mm}, inertia: 0.01 kg m^2, position: [0, 0, 0]}\n"
        "  rear_carrier: {inertia: 0.01 kg m^2, position: [0, 0, 60 mm]}\n"
        "planetary_stages:\n"
        + stage("front", gear(21), 3, "output", "sun: front_sun", "ring: front_ring")
        + stage("rear", gear(21), 3, "rear_carrier", "sun: rear_sun", "ring: rear_ring")
        + couplings
        + scenarios
    )


def lepelletier(couplings: tuple[tuple[str, str], ...], scenarios: str = "") -> str:
    """Simple set 40/20/80 with fixed sun, whose carrier or ring drives a Ravigneaux set by clutches."""
    front = f"gears:\n  front_sun: {gear(40)}\n  front_ring: {ring(80)}\n"
    bodies = (
        "bodies:\n"
        "  front_sun: {gears: [front_sun], motion: fixed, position: [0, 0, -80 mm]}\n"
        "  input: {gears: [front_ring], position: [0, 0, -80 mm]}\n"
        "  front_carrier: {inertia: 2e-3 kg m^2, position: [0, 0, -80 mm]}\n"
    )
    stages = "planetary_stages:\n" + stage(
        "front", gear(20), 3, "front_carrier", "sun: front_sun", "ring: front_ring"
    )
    clutches = "couplings:\n" + "".join(
        f"  clutch_{k}: {{bodies: [{one}, {two}], stiffness: {{torsion: 1e6 N m/rad}}}}\n"
        for k, (one, two) in enumerate(couplings)
    )
    text = ravigneaux(scenarios=clutches + scenarios)
    text = text.replace("gears:\n", front, 1).replace("bodies:\n", bodies, 1)
    return text.replace("planetary_stages:\n", stages, 1)


def stepped(
    count: int = 3,
    *,
    step: int = 18,
    output: int = 78,
    first_ring: int | None = None,
    more: str = "",
    step_more: str = "",
    fixed: str = "output_ring",
    loads: str = "",
) -> str:
    """Stepped planets of 39 teeth with a sun of 21, and a step with a ring; module 3 mm, 90 mm apart.

    `first_ring`: teeth of a ring in mesh with the 39 teeth, as in a Wolfrom set.
    """
    rings = f"  first_ring: {ring(first_ring, module=3.0)}\n" if first_ring else ""
    own = "  first_ring: {gears: [first_ring], position: [0, 0, 0]}\n" if first_ring else ""
    bodies = (
        "bodies:\n"
        "  sun: {gears: [sun], position: [0, 0, 0]}\n"
        "  output_ring: {gears: [output_ring]}\n"
        f"{own}"
        "  carrier: {inertia: 0.05 kg m^2, mass: 5 kg}\n"
    ).replace(f"gears: [{fixed}]", f"gears: [{fixed}], motion: fixed")
    lines = ["sun: sun", *(["ring: first_ring"] if first_ring else []), *more.splitlines()]
    lines += [
        "steps:",
        "  small:",
        f"    gear: {gear(step, module=3.0)}",
        "    position: 30 mm",
        "    ring: output_ring",
        *(f"    {line}" for line in step_more.splitlines()),
    ]
    return (
        f"gears:\n  sun: {gear(21, module=3.0)}\n  output_ring: {ring(output, module=3.0)}\n{rings}{bodies}"
        "planetary_stages:\n" + stage("planet", gear(39, module=3.0), count, "carrier", *lines) + loads
    )


def eight_speed(scenarios: str) -> str:
    """Automatic of four sets with 48/96, 48/96, 69/111 and 23/85 teeth, brakes A, B and clutches C to E."""
    sets = {
        "p1": (48, 24, 96, 1.5),
        "p2": (48, 24, 96, 1.5),
        "p3": (69, 21, 111, 1.25),
        "p4": (23, 31, 85, 1.75),
    }
    carriers = {"p1": "c1_r4", "p2": "input", "p3": "carrier_3", "p4": "output"}
    lines = ["gears:"]
    for k, (sun, _, teeth, module) in enumerate(sets.values(), start=1):
        lines += [f"  s{k}: {gear(sun, module=module)}", f"  r{k}: {ring(teeth, module=module)}"]
    lines += [
        "bodies:",
        "  s12: {gears: {s1: 0 mm, s2: 40 mm}, motion: torsion, position: [0, 0, 0]}",
        "  ring_1: {gears: [r1], motion: torsion}",
        "  c1_r4: {gears: {r4: 120 mm}, motion: torsion, inertia: 5e-3 kg m^2, position: [0, 0, 0]}",
        "  input: {motion: torsion, inertia: 0.1 kg m^2, position: [0, 0, 40 mm]}",
        "  r2_s3: {gears: {r2: 0 mm, s3: 40 mm}, motion: torsion, position: [0, 0, 40 mm]}",
        "  r3_s4: {gears: {r3: 0 mm, s4: 40 mm}, motion: torsion, position: [0, 0, 80 mm]}",
        "  carrier_3: {motion: torsion, inertia: 3e-3 kg m^2, position: [0, 0, 80 mm]}",
        "  output: {motion: torsion, inertia: 0.5 kg m^2, position: [0, 0, 120 mm]}",
        "planetary_stages:",
    ]
    for k, (name, (_, planet, _, module)) in enumerate(sets.items(), start=1):
        own = stage(
            name,
            gear(planet, module=module),
            4,
            carriers[name],
            f"sun: s{k}",
            f"ring: r{k}",
            "motion: torsion",
        )
        lines += own.splitlines()
    lines += [
        "clutches:",
        "  A: {bodies: [s12], capacity: 3 kN m}",
        "  B: {bodies: [ring_1], capacity: 3 kN m}",
        "  C: {bodies: [input, r3_s4], capacity: 3 kN m}",
        "  D: {bodies: [carrier_3, output], capacity: 3 kN m}",
        "  E: {bodies: [r2_s3, r3_s4], capacity: 3 kN m}",
        "loads:",
        "  engine: {body: input, torque: 300 N m}",
        "  road: {body: output, torque: balance}",
        "scenarios:",
    ]
    return "\n".join(lines) + "\n" + scenarios
