# SPDX-License-Identifier: Apache-2.0
"""Names of modes of several machines, and shares of the energies of a joint on a moving body."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.modes.names import ordinal
from pitchpoint.system.compile import compile_model
from tests.support.planet_stages import planet_set
from tests.support.planetary import lin_parker

EXAMPLES = Path(__file__).parents[3] / "examples"
CART, BLOCK, NEAR, BETWEEN, FAR = 1.0, 4.0, 1e2, 1e4, 3e4
SLED = f"""\
bodies:
  post: {{motion: fixed, position: [0, 0, -1]}}
  cart: {{mass: {CART} kg}}
  block: {{mass: {BLOCK} kg}}
joints:
  rail: {{type: prismatic, bodies: [ground, cart], position: [0, 0, 0]}}
  slide: {{type: prismatic, bodies: [cart, block], position: [0, 0, 1]}}
springs:
  near: {{ends: [post, cart], stiffness: {NEAR} N/m}}
  between: {{ends: [cart, block], stiffness: {BETWEEN} N/m}}
  far: {{ends: [post, block], stiffness: {FAR} N/m}}
"""


def test_shares_of_a_block_that_slides_on_a_cart() -> None:
    """Shares of the coordinates are beyond 0 and 1 in a tree; those of the parts are energies of bodies.

    Mass and stiffness in the coordinates of the joints, z of the cart and way of the block on it, are
    [[m1 + m2, m2], [m2, m2]] and diag(k1, k2) + k3 everywhere.
    """
    M = np.array([[CART + BLOCK, BLOCK], [BLOCK, BLOCK]])
    squares, columns = eigh(np.diag([NEAR, BETWEEN]) + FAR, M)
    modes = find_modes(compile_model(loads_model(SLED)))
    assert modes.frequency == pytest.approx(np.sqrt(squares) / (2.0 * np.pi), rel=1e-9)
    energy = columns.T * (columns.T @ M)
    assert modes.kinetic == pytest.approx(energy, rel=1e-6)
    assert energy.max() > 1.4
    assert energy.min() < 0.0
    cart, way = columns
    parts = np.column_stack([CART * cart**2, BLOCK * (cart + way) ** 2])
    found = modes.energies.kinetic.sum(axis=2)
    assert found[:, [modes.groups.parts.index(p) for p in ("cart", "block")]] == pytest.approx(
        parts, rel=1e-6
    )
    assert modes.energies.kinetic.sum(axis=(1, 2)) == pytest.approx([1.0, 1.0], rel=1e-12)
    assert modes.names == ("translation z of block", "translation z of cart")


def test_a_pendulum_rotates_and_its_disc_has_torsion() -> None:
    """Upright pendulum on a spring: gravity takes energy away, shares of the strain energy still sum to 1."""
    text = """\
gravity: [0, -10 m/s^2, 0]
bodies:
  disc: {motion: torsion, inertia: 0.1 kg m^2, position: [0, 0, 0]}
  rod:
    {mass: 1 kg, center_of_mass: [0, 0.5, 0], inertia_tensor: [0.1, 0.1, 0.1, 0, 0, 0], position: [0, 0, 0]}
joints: {pin: {type: revolute, bodies: [ground, rod], position: [0, 0, 0]}}
torsion_springs:
  hold: {bodies: [rod, disc], stiffness: 20 N m/rad}
  foot: {bodies: [disc], stiffness: 100 N m/rad}
"""
    modes = find_modes(compile_model(loads_model(text)))
    assert modes.energies.strain.min() < 0.0
    assert modes.energies.strain.sum(axis=1) == pytest.approx(1.0, rel=1e-9)
    assert all(name.startswith("torsion of ") for name in modes.names)


@pytest.mark.parametrize(("axis", "soft"), [("", 1), ("axis: [0, 1, 0], ", 0)])
def test_modes_of_a_beam_are_counted_along_each_axis(axis: str, soft: int) -> None:
    """A flat bar, 20 mm along axis 1 and 10 mm along axis 2; without `axis`, axis 1 is x."""
    text = f"""\
bodies:
  tip: {{motion: free, mass: 1 g, inertia_tensor: [1e-9, 1e-9, 1e-9, 0, 0, 0], position: [0, 0, 0.5]}}
beams: {{bar: {{ends: [ground, tip], {axis}section: {{width: 20 mm, height: 10 mm}}}}}}
"""
    modes = find_modes(compile_model(loads_model(text)))
    assert modes.names[:3] == (
        "1st bending of bar (axis 2)",
        "1st bending of bar (axis 1)",
        "2nd bending of bar (axis 2)",
    )
    assert np.argmax(np.abs(modes.body_shape[0, modes.bodies.index("tip"), :3])) == soft


def test_modes_of_a_geared_rotor() -> None:
    """Names at 4500 rpm: the whirl of the disc, the torsion, axial modes, the drive shaft."""
    model = load_model(EXAMPLES / "geared-rotor" / "model.yaml")
    modes = find_modes(compile_model(model, "fast"), "fast")
    assert modes.names[:7] == (
        "rigid rotation",
        "1st bending of rotor (backward)",
        "1st bending of rotor (forward)",
        "torsion of rotor against drive",
        "2nd bending of rotor (x)",
        "axial mode of rotor",
        "2nd bending of rotor (backward)",
    )
    assert len(set(modes.names)) == len(modes.names)
    at_rest = find_modes(compile_model(model))
    assert at_rest.names[1:3] == ("1st bending of rotor (y)", "1st bending of rotor (x)")


@pytest.mark.parametrize(("n", "planet"), [(3, 0), (4, 3), (5, 3)])
def test_types_of_a_planetary_set(n: int, planet: int) -> None:
    """Lin and Parker (1999): five rotational modes besides the rigid one, six translational pairs, and three
    planet modes of multiplicity n - 3."""
    names = find_modes(lin_parker(n)).names
    assert len(set(names)) == len(names)
    words = Counter(
        word for name in names for word in ("rotational", "translational", "planet ") if f" {word}" in name
    )
    assert (words["rotational"], words["translational"], words["planet "]) == (5, 12, planet * (n - 3))
    pairs = [name for name in names if "translational" in name]
    assert [name.replace("(b)", "(a)") for name in pairs[1::2]] == pairs[::2]


def test_modes_of_a_set_whose_central_gears_only_rotate() -> None:
    """Kahraman (1994): two rotational modes, and the planet mode n - 1 times."""
    for n in (3, 4):
        names = find_modes(compile_model(planet_set(24, 24, 72, n), "steady"), "steady").names
        assert sum("rotational" in name for name in names) == 2
        assert sum("planet mode" in name for name in names) == n - 1


@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
def test_modes_of_an_engine_train_and_of_a_gearbox() -> None:
    """Camshaft train on flexible shafts, and a gearbox in an elastic housing on mounts."""
    train = find_modes(compile_model(load_model(EXAMPLES / "camshaft-drive" / "shafts.yaml")), count=8).names
    assert train[:4] == (
        "rigid rotation",
        "axial mode of camshaft",
        "axial mode of idler",
        "torsion of crankshaft against camshaft",
    )
    rig = find_modes(compile_model(load_model(EXAMPLES / "phm-2009-rig" / "model.yaml"))).names
    assert sum("of housing" in name for name in rig) == 6
    assert {"mesh mode of stage_1", "mesh mode of stage_2"} <= set(rig)
    assert len(set(rig)) == len(rig)


def test_numbers() -> None:
    assert [ordinal(k) for k in (1, 12, 21, 33)] == ["1st", "12th", "21st", "33rd"]


def test_planets_of_a_stage_and_their_bearings_have_the_names_of_the_file() -> None:
    """Bearings between planets and carrier are bearings, not couplings; the set has the name of the stage."""
    model = load_model(EXAMPLES / "planetary-set" / "model.yaml")
    modes = find_modes(compile_model(model.replace("planetary_stages.set.pin_errors", {})))
    assert "1st rotational mode of planetary stage set" in modes.names
    assert {"bearing planet_1-bearing", "bearing spline"} < set(modes.groups.components)
    assert not any(component.startswith("coupling") for component in modes.groups.components)


BESIDE = """\
gears:
  sun: {number_of_teeth: 28, normal_module: 4 mm, face_width: 60 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 92, normal_module: 4 mm, face_width: 60 mm,
    profile_shift_coefficient: 0}
shafts:
  main:
    position: [0, 0, -1 m]
    sections: [{length: 1 m, diameter: 80 mm}]
    markers: {hub: {position: [0, 0, 0]}, end: {position: [0, 0, 1 m]}}
bodies:
  rotor: {mass: 500 kg, inertia_tensor: [20, 20, 40, 0, 0, 0], position: [0, 0, -1 m]}
  carrier: {mass: 30 kg, inertia_tensor: [0.3, 0.3, 0.5, 0, 0, 0], position: [0, 0, 0]}
  sun_shaft: {gears: [sun], position: [0, 0, 0]}
  ring_body: {gears: [ring], motion: fixed}
joints:
  a: {type: fixed, bodies: [main.hub, rotor]}
  b: {type: fixed, bodies: [main.end, carrier]}
bearings:
  one: {body: main, position: [0, 0, 300 mm], stiffness: {radial: 2e9 N/m, axial: 1e9 N/m}}
  two: {body: main, position: [0, 0, 950 mm], stiffness: {radial: 2e9 N/m}}
planetary_stages:
  st:
    sun: sun
    ring: ring
    carrier: carrier
    planets: 4
    planet: {number_of_teeth: 32, normal_module: 4 mm, face_width: 60 mm, profile_shift_coefficient: 0}
    motion: planar
    bearing: {stiffness: {radial: 3e8 N/m}}
    sun_mesh: {stiffness: {law: constant, value: 1.0e9 N/m}}
    ring_mesh: {stiffness: {law: constant, value: 1.3e9 N/m}}
loads:
  wind: {body: main, torque: 1500 N m}
  gen: {body: sun_shaft, torque: balance}
"""


def test_a_shaft_beside_a_stage_has_its_own_modes() -> None:
    """The rotor at the free end, and main shaft and carrier, move on the stiffness of the shaft.

    Modes of the stage have its meshes and planet bearings; four planets have three planet modes.
    """
    modes = find_modes(compile_model(loads_model(BESIDE)))
    names = modes.names
    assert {*names[1:3]} == {"1st bending of main (x)", "1st bending of main (y)"}
    assert names[3].startswith("torsion of ")
    assert {*names[4:7]} == {"2nd bending of main (x)", "2nd bending of main (y)", "axial mode of main"}
    energies, components = modes.energies, modes.groups.components
    own = [e for e, name in enumerate(components) if "planet" in name]
    strain = np.abs(energies.strain)
    strain[1:] /= strain[1:].sum(axis=1, keepdims=True)
    stage = np.array(["planetary stage" in name for name in names])
    share = strain[:, own].sum(axis=1)
    assert share[stage].min() > 0.5
    assert share[~stage].max() < 0.5
    assert sum("planet mode" in name for name in names) == 3


def crank(housing: bool) -> str:
    """A crankshaft gear with three wheels around it, on bearings to ground or in a housing."""
    wheel = "{number_of_teeth: 41, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}"
    on = ", housing: housing" if housing else ""
    wheels, turns = ("one", "two", "three"), (0, 120, 240)
    stiff = "stiffness: {radial: 2e8 N/m}"
    lines = ["gears:", f"  pinion: {wheel.replace('41', '23')}", *(f"  g_{w}: {wheel}" for w in wheels)]
    lines += ["bodies:", "  crank: {gears: [pinion], motion: planar, position: [0, 0, 0]}"]
    lines += [f"  {w}: {{gears: [g_{w}], motion: planar}}" for w in wheels]
    lines += [
        "  housing: {mass: 90 kg, inertia: 2 kg m^2, transverse_inertia: 2 kg m^2, motion: free}"
    ] * housing
    lines += ["bearings:", f"  b_crank: {{body: crank, {stiff}{on}}}"]
    lines += [f"  b_{w}: {{body: {w}, {stiff}{on}}}" for w in wheels]
    feet = "stiffness: {radial: 5e7 N/m, axial: 5e7 N/m, tilt: 5e6 N m/rad, torsion: 5e6 N m/rad}"
    lines += [f"  feet: {{body: housing, {feet}}}"] * housing
    law = "stiffness: {law: constant, value: 3e8 N/m}"
    lines += ["meshes:"]
    lines += [
        f"  m_{w}: {{gears: [pinion, g_{w}], direction: {turn} deg, {law}}}"
        for w, turn in zip(wheels, turns, strict=True)
    ]
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("housing", [False, True])
def test_wheels_around_a_crank_are_no_planets(housing: bool) -> None:
    """Three wheels on fixed axes are no planetary set, also if one housing carries them."""
    names = find_modes(compile_model(loads_model(crank(housing)))).names
    assert not [name for name in names if "planet" in name]


def test_a_pin_error_does_not_separate_the_translational_pairs() -> None:
    """The loads of the planets split the frequencies of the pairs by up to 0.5 %: both keep one number."""
    modes = find_modes(compile_model(load_model(EXAMPLES / "planetary-set" / "model.yaml")))
    pairs = [k for k, name in enumerate(modes.names) if "translational" in name]
    split = modes.frequency[pairs[1::2]] / modes.frequency[pairs[::2]] - 1.0
    assert split.max() > 4e-3
    words = "{} translational mode of planetary stage set ({})"
    assert [modes.names[k] for k in pairs] == [
        words.format(ordinal(n), x) for n in (1, 2, 3, 4) for x in "ab"
    ]


def test_a_wheel_that_rolls_on_its_bearings_has_no_torsion_against_ground() -> None:
    """It rolls on a heavy wheel: all strain is in a bearing, which does not resist the rotation."""
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    text = (
        f"gears:\n  a: {{number_of_teeth: 20, {gear}}}\n  b: {{number_of_teeth: 60, {gear}}}\n"
        "bodies:\n  roller: {gears: [a], motion: planar, mass: 0.1 kg, inertia: 0.01 kg m^2}\n"
        "  heavy: {gears: [b], motion: torsion, inertia: 1e4 kg m^2}\n"
        "meshes:\n  m: {gears: [a, b], stiffness: {law: constant, value: 1e9 N/m}}\n"
        "bearings:\n  l: {body: roller, stiffness: {radial: 1e6 N/m}}\n"
        "loads:\n  in: {body: roller, torque: 10 N m}\n  out: {body: heavy, torque: 30 N m}\n"
    )
    free = find_modes(compile_model(loads_model(text))).names
    assert "rotation of roller" in free
    assert not any("ground" in name for name in free)
