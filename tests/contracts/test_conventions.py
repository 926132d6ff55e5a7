# SPDX-License-Identifier: Apache-2.0
"""Signs, frames and definitions: one test for every line of docs/conventions.md, no line without a test."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis.gear_signals import gear_signals
from pitchpoint.analysis.indicators import signal_indicators, standardised_moment
from pitchpoint.analysis.noise import with_white_noise
from pitchpoint.analysis.rattle import rattle
from pitchpoint.analysis.statistics import contact_statistics, signal_statistics
from pitchpoint.analysis.synchronous_average import synchronous_average
from pitchpoint.cli.main import run_command
from pitchpoint.cli.output import NOTHING, plain, shown
from pitchpoint.contact.stiffness.description import PairShape, PhaseStiffness
from pitchpoint.core import status
from pitchpoint.core.errors import ModelError
from pitchpoint.core.formula.formula import Formula, FormulaError
from pitchpoint.core.units import parse_quantity
from pitchpoint.elements import registry
from pitchpoint.elements.mesh.record import N_OUT
from pitchpoint.elements.shaft_beam import shaft_row
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.geometry.bevel.tooth import placed
from pitchpoint.geometry.deviations import Deviations, Runout, separation
from pitchpoint.geometry.modifications import roll_length
from pitchpoint.geometry.shaft_solid import shaft_solid
from pitchpoint.geometry.tooth_faults import break_level, displaced_gap
from pitchpoint.geometry.tooth_form import gear_outline
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.frames import body_frame
from pitchpoint.model.model import Model
from pitchpoint.model.phasing import tooth_twist
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.iec import Gust, RotorSite, WindClass
from pitchpoint.model.wind.steady import SteadyWind
from pitchpoint.multibody import bodies as joints
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FREE as SHAFT
from pitchpoint.report.numbers import geometry_of_model
from pitchpoint.report.scene.bevel_gears import bevel_axes
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.sampling import accumulate, new_statistics, read_statistics
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.mesh_laws import MeshLaws
from pitchpoint.system.system import System, assemble
from pitchpoint.system.wind import WindField
from tests.support.bevel_files import bevel_file
from tests.support.mesh_alone import moved
from tests.support.model_files import TORSIONAL_PAIR, gear, pair
from tests.support.one_mesh import OneMesh, make_pair
from tests.support.rotors import AERODYN

PAGE = Path(__file__).parents[2] / "docs" / "conventions.md"
FOURIER = PhaseStiffness(mean=4e8, cosine=[-0.2, 0.1], sine=[0.15, 0.0])
BEVEL = """\
bevel_gears:
  a: {number_of_teeth: 20, mean_normal_module: 2 mm, pitch_cone_angle: 30 deg, face_width: 9 mm, opens: +z,
    spiral_angle: 30 deg, hand: right, initial_angle: 30 deg}
bodies: {one: {bevel_gears: {a: 50 mm}}}
"""
BODIES_OF_PAIR = (
    "bodies: {one: {gears: [a]}, two: {gears: [b]}}\n"
    "loads: {in: {body: one, torque: 20 N m}, out: {body: two, torque: balance}}\n"
)
PARABOLA = PairShape(c_prime=14e9, S_R=0.8, T_R=0.3)
FREE = """\
gears: {g: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies: {rotor: {gears: [g], motion: free}}
bearings:
  b: {body: rotor, stiffness: {radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad, torsion: 1e5 N m/rad}}
"""


def one(beta: float = 0.3, stiffness: PairShape | PhaseStiffness = PARABOLA, **more):
    """A mesh element of its own; `more` is for the pair or for the laws."""
    shape = {k: more.pop(k) for k in ("internal", "z2", "b") if k in more}
    place = {k: more.pop(k) for k in ("offset", "n_pair") if k in more}
    return OneMesh(make_pair(beta=beta, **shape), MeshLaws(stiffness=stiffness, **more), **place)


def loaded(text: str, scenario: str | None = None):
    """Equilibrium of a text: a function that gives a channel."""
    model = loads_model(text)
    found = solve_equilibrium(compile_model(model, scenario))
    return lambda name: float(found[name])


# ------------------------------------------------------------------------------------- the page itself


def test_the_page_names_every_test_once_and_nothing_else() -> None:
    named = re.findall(r"`(test_\w+)`", PAGE.read_text(encoding="utf-8"))
    own = re.findall(r"^def (test_\w+)", Path(__file__).read_text(encoding="utf-8"), re.MULTILINE)
    assert len(named) == len(set(named))
    assert set(named) == set(own) - {"test_the_page_names_every_test_once_and_nothing_else"}
    assert len(named) == sum(
        line.startswith("| ") for line in PAGE.read_text().splitlines() if "`test_" in line
    )


# --------------------------------------------------------------------------------------- units, frames


def test_bare_numbers_are_si_and_radians() -> None:
    assert parse_quantity(0.5, "angle") == 0.5
    assert parse_quantity("180 deg", "angle") == pytest.approx(math.pi, rel=1e-15)
    assert parse_quantity("60 rpm", "angular_speed") == pytest.approx(2.0 * math.pi, rel=1e-15)
    assert parse_quantity("1 Hz", "angular_speed") == pytest.approx(2.0 * math.pi, rel=1e-15)


def test_units_in_a_formula_must_give_what_is_wanted() -> None:
    names = ("t", "angle", "speed")
    right = ("5 N m/s * t", "1 N m/rad * angle", "1 N m s/rad * speed", "5 N m * (1 + 0.1*sin(157*t))", "5*t")
    for text in (*right, "1 + 5 N m * sin(2*pi*25 Hz*t)"):
        Formula.parse(text, names, "torque")
    for text in ("5 N m * t", "5 N m * speed", "1.2 * 5 kg * t", "1 kg + 5 N m * t", "5 N m * sin(25 Hz*t)"):
        with pytest.raises(FormulaError):
            Formula.parse(text, names, "torque")
    assert Formula.parse("25 Hz")(0.0) == 25.0


def test_a_parameter_retains_its_dimension() -> None:
    text = "parameters: {gap: VALUE}\nbodies: {a: {inertia: 1 kg m^2, position: [2*gap, 0, 0]}}"
    model = loads_model(text.replace("VALUE", "3 mm"))
    assert model.bodies["a"].position[0] == 0.006
    for given in ("0.003", "3 N", "3 deg"):
        with pytest.raises(ModelError):
            loads_model(text.replace("VALUE", given))
        if given != "0.003":
            with pytest.raises(ModelError):
                model.replace("parameters.gap", given)
    assert model.replace("parameters.gap", 0.004).bodies["a"].position[0] == 0.008  # in Python in SI


def test_spin_axis_is_the_third_axis_of_a_right_handed_frame() -> None:
    system = compile_model(loads_model(FREE))
    evaluate.prepare(system)
    R = system.workspace.fr["R"][1]
    assert np.allclose(np.cross(R[:, 0], R[:, 1]), R[:, 2])
    assert np.allclose(R[:, 2], [0.0, 0.0, 1.0])
    tilted = compile_model(loads_model(FREE.replace("motion: free", "motion: free, axes: {z: [3, 0, 4]}")))
    evaluate.prepare(tilted)
    assert np.allclose(tilted.workspace.fr["R"][1][:, 2], [0.6, 0.0, 0.8])


def test_bodies_in_mesh_share_their_axes() -> None:
    bodies = "bodies: {one: {gears: [a]}, two: {gears: [b], axes: {z: [0, 1, 0], x: [0, 0, 1]}}}\n"
    model = loads_model(pair(gear("a"), gear("b"), "", bodies))
    for body in ("one", "two"):
        assert np.allclose(body_frame(model, body)[1], np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]]))
    other = pair(gear("a"), gear("b"), "", bodies.replace("gears: [a]", "gears: [a], axes: {z: [0, -1, 0]}"))
    with pytest.raises(ModelError, match="opposite z axes"):
        loads_model(other)


def test_line_of_centres_runs_from_gear_1_to_gear_2() -> None:
    text = pair(gear("a"), gear("b"), "direction: 90 deg", "bodies: {one: {gears: [a]}, two: {gears: [b]}}\n")
    model = loads_model(text)
    way = np.subtract(model.bodies["two"].origin, model.bodies["one"].origin)
    assert np.allclose(way, [0.0, model.pairs["m"].a_w, 0.0], atol=1e-15)
    assert loads_model(pair(gear("a"), gear("b"))).meshes["m"].theta == 0.0
    turned = loads_model(text.replace("gears: [a]}", "gears: [a], axes: {z: [0, 1, 0], x: [0, 0, 1]}}"))
    way = np.subtract(turned.bodies["two"].origin, turned.bodies["one"].origin)
    assert np.allclose(way, [model.pairs["m"].a_w, 0.0, 0.0], atol=1e-15)  # y of the body is x of the world


def jointed(joint: str, more: str = "", body: str = "mass: 2, inertia_tensor: [1, 1, 1, 0, 0, 0]"):
    """One body `b` with a joint `j` at the origin: its system and the first state."""
    text = f"bodies:\n  b: {{{body}}}\njoints:\n  j: {{{joint}, position: [0, 0, 0]{more}}}\n"
    system = compile_model(loads_model(text))
    return system, system.initial_state()


def test_a_joint_shifts_then_turns_about_x_y_z() -> None:
    start = ", start: {x: 1, y: 2, z: 3, alpha: 0.3, beta: 0.2, spin: 0.5}"
    system, state = jointed("type: shaft, bodies: [ground, b]", start)
    evaluate.residual(system, state)
    f = system.workspace.fr[1]
    assert f["r"].tolist() == [1.0, 2.0, 3.0]
    turns = []
    for axis, angle in enumerate((0.3, 0.2, 0.5)):
        i, j = (axis + 1) % 3, (axis + 2) % 3
        turn = np.eye(3)
        turn[i, i] = turn[j, j] = math.cos(angle)
        turn[j, i], turn[i, j] = math.sin(angle), -math.sin(angle)
        turns.append(turn)
    c, s = math.cos(f["phi"]), math.sin(f["phi"])
    spun = f["R"] @ [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
    assert np.allclose(spun, turns[0] @ turns[1] @ turns[2], atol=1e-15)
    still = jointed("type: shaft, bodies: [ground, b]")
    evaluate.residual(*still)
    assert np.allclose(still[0].workspace.fr["R"][1], np.eye(3))


def test_channels_of_carried_bodies_are_coordinates_of_their_joints() -> None:
    system, state = jointed(
        "type: cylindrical, bodies: [ground, b]", ", axes: {z: [1, 0, 0]}, start: {z: 2 mm, spin: 400 deg}"
    )
    found = dict(zip((c.name for c in system.layout.channels), evaluate.observe(system, state), strict=True))
    assert found["displacement[b.z]"] == 0.002
    assert found["angle[b]"] == pytest.approx(math.radians(400.0))


def test_a_joint_turned_round_keeps_its_coordinates() -> None:
    # ground against b: a turn by +0.3 about z of ground is one by -0.3 of b
    system, state = jointed("type: revolute, bodies: [b, ground]", ", start: {spin: 0.3}")
    assert state.q[0] == 0.3
    evaluate.residual(system, state)
    f = system.workspace.fr[1]
    x = math.cos(f["phi"]) * f["R"][:, 0] + math.sin(f["phi"]) * f["R"][:, 1]
    assert np.allclose(x, [math.cos(0.3), -math.sin(0.3), 0.0])


def test_a_positive_lead_is_a_right_hand_thread() -> None:
    system, state = jointed("type: screw, bodies: [ground, b], lead: 5 mm", ", start: {spin: 720 deg}")
    evaluate.residual(system, state)
    assert system.workspace.fr["r"][1, 2] == pytest.approx(0.01)


def test_products_of_inertia_are_the_entries_of_the_matrix() -> None:
    # two masses of 1 kg at +-(1, 1, 0) and two of 1 kg on the z axis at +-1
    x = np.array([[1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    about = sum(p @ p * np.eye(3) - np.outer(p, p) for p in x)
    body = f"mass: 4, inertia_tensor: [{about[0, 0]}, {about[1, 1]}, {about[2, 2]}, -2, 0, 0]"
    system, _ = jointed("type: spherical, bodies: [ground, b]", body=body)
    assert np.allclose(system.bodies[0].inertia, about)


def test_a_solid_lies_in_its_file_as_in_its_body(tmp_path: Path) -> None:
    # a rod of 20 mm along z of the file, from 0 to 0.2 m
    np.save(tmp_path / "rod.npy", shaft_solid([(0.2, 0.02, 0.0)], 90))
    text = "bodies: {rod: {motion: free, position: [1, 0, 0], solid: {file: rod.npy, unit: 1 m%s}%s}}"

    def inertia(solid: str = "", body: str = ""):
        (tmp_path / "model.yaml").write_text(text % (solid, body))
        return load_model(tmp_path / "model.yaml").body_inertia("rod")

    own = inertia()
    assert own.place == pytest.approx((0.0, 0.0, 0.1), abs=1e-12)
    assert own.polar < 0.1 * own.central
    # x of the body along z of the file, its origin at 0.05 m along the rod
    turned = inertia(", axes: {z: [1, 0, 0], x: [0, 0, 1]}, origin: [0, 0, 50 mm]")
    assert turned.place == pytest.approx((0.05, 0.0, 0.0), abs=1e-12)
    assert turned.about_center()[0, 0] == pytest.approx(own.polar, rel=1e-12)
    assert inertia("", ", mass: 3 kg").mass == 3.0
    assert inertia("", ", mass: 3 kg").polar == own.polar


def test_positive_torque_turns_counter_clockwise_seen_from_plus_z() -> None:
    get = loaded(FREE + "loads: {t: {body: rotor, torque: 10 N m}}\n")
    assert get("angle[rotor]") == pytest.approx(10.0 / 1e5, rel=1e-6)
    # counter-clockwise seen from +z: x turns towards y
    system = compile_model(loads_model(FREE))
    evaluate.prepare(system)
    x, y, z = system.workspace.fr["R"][1].T
    assert np.allclose(np.cross(z, x), y)


ALONG_X = FREE.replace("motion: free", "motion: free, axes: {z: [1, 0, 0], x: [0, 1, 0]}")
"""The same rotor along x of the world: its x is y there, its y is z."""


def test_displacements_are_those_of_the_body_origin_in_its_axes() -> None:
    push = "loads: {f: {body: rotor, force: [100 N, 50 N, -20 N]}}\n"
    get = loaded(FREE + push)
    found = [get(f"displacement[rotor.{k}]") for k in "xyz"]
    assert found == pytest.approx([100.0 / 1e8, 50.0 / 1e8, -20.0 / 1e8], rel=1e-6)
    get = loaded(ALONG_X + push)
    found = [get(f"displacement[rotor.{k}]") for k in "zxy"]
    assert found == pytest.approx([100.0 / 1e8, 50.0 / 1e8, -20.0 / 1e8], rel=1e-6)


def test_tilts_are_right_handed_about_x_and_y() -> None:
    # a force along y at z = 0.1 m has the moment -10 N m about x
    get = loaded(FREE + "loads: {f: {body: rotor, force: [0 N, 100 N, 0 N], position: [0, 0, 100 mm]}}\n")
    assert get("displacement[rotor.rx]") == pytest.approx(-10.0 / 1e6, rel=1e-4)


def test_bearing_force_acts_on_the_body() -> None:
    get = loaded(FREE + "loads: {f: {body: rotor, force: [100 N, 50 N, -20 N], position: [0, 0, 100 mm]}}\n")
    force = [get(f"bearing_force[b.{k}]") for k in ("fx", "fy", "fz", "mx", "my")]
    assert force == pytest.approx([-100.0, -50.0, 20.0, 5.0, -10.0], rel=1e-3)
    get = loaded(
        ALONG_X + "loads: {f: {body: rotor, force: [-20 N, 100 N, 50 N], position: [0, 0, 100 mm]}}\n"
    )
    again = [get(f"bearing_force[b.{k}]") for k in ("fx", "fy", "fz", "mx", "my")]
    assert again == pytest.approx(force, rel=1e-9)


def test_beam_forces_are_those_of_the_part_beyond():
    beam = Beam(section=tube(0.02), length=0.5, E=2e11, G=8e10)
    tip = Body(
        motion=SHAFT, position=(0, 0, 0.5), mass=1.0, polar_inertia=1.0, transverse_inertia=1.0, name="tip"
    )
    system = assemble([tip], {"shaft_beam": shaft_row(beam, bodies=(0, 1))}, names={"shaft_beam": ["rod"]})
    state = system.initial_state()
    state.q[system.layout.coordinate("tip.z")] = 1e-5
    state.q[system.layout.coordinate("tip.spin")] = 1e-3
    found = evaluate.observe(system, state)
    for end in "ij":
        tension = found[system.layout.channel(f"beam_force[rod.{end}.fz]")]
        torque = found[system.layout.channel(f"beam_force[rod.{end}.mz]")]
        assert tension == pytest.approx(2e11 * beam.section.A * 2e-5)
        assert torque == pytest.approx(8e10 * beam.section.J * 2e-3)


def test_angles_are_unwrapped() -> None:
    text = TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.2 s")
    model = loads_model(text)
    system = compile_model(model, "steady")
    done = run_time(system, model.scenarios["steady"])
    turned = 2.0 * math.pi * 1500.0 / 60.0 * done.t_end
    assert done.channels["angle[driver]"]["max"] == pytest.approx(turned, abs=0.05)
    assert done.channels["angle[driven]"]["min"] == pytest.approx(-turned, abs=0.05)


def test_speed_is_the_rate_of_the_angle() -> None:
    system = compile_model(loads_model(FREE))
    state = system.initial_state()
    names = list(system.layout.coordinates)
    state.q[names.index("rotor.beta")], state.v[names.index("rotor.alpha")] = 0.2, 3.0
    state.v[system.spin("rotor")] = 50.0
    out = evaluate.observe(system, state)
    assert out[system.layout.channel("speed[rotor]")] == 50.0
    frame = system.workspace.fr[1]
    along = float(frame["R"][:, 2] @ frame["tw"][3:])
    assert along == pytest.approx(50.0 + math.sin(0.2) * 3.0, rel=1e-14)


def test_shaft_and_gear_share_no_material() -> None:
    text = (
        "gears: {g: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, "
        "profile_shift_coefficient: 0%s}}\n"
        "shafts: {s: {sections: [{length: 100 mm, diameter: 50 mm%s}], gears: {g: 40 mm}, "
        "position: [0, 0, 0]}}\n"
    )
    alone = 7830.0 * math.pi / 4.0 * 0.05**2 * 0.1

    def mass(gear: str = "", section: str = "") -> float:
        return loads_model(text % (gear, section)).body_inertia("s").mass

    bored = mass(", bore_diameter: 50 mm")
    assert mass() == pytest.approx(bored, rel=1e-12)
    assert mass(", bore_diameter: 20 mm") == pytest.approx(bored, rel=1e-12)
    hollow = mass("", ", bore: 20 mm")
    assert bored - hollow == pytest.approx(alone * (20.0 / 50.0) ** 2, rel=1e-12)
    assert mass(", mass: 2 kg") == pytest.approx(alone + 2.0, rel=1e-12)


def test_a_given_mass_does_not_move_the_centre_of_mass() -> None:
    def inertia(more: str):
        return loads_model(FREE.replace("gears: [g]", "gears: {g: 30 mm}" + more)).body_inertia("rotor")

    own = inertia("")
    assert inertia(", mass: 5 kg").center == own.center == pytest.approx(0.03, rel=1e-14)
    assert inertia(", mass: 5 kg").central == pytest.approx(own.central, rel=1e-14)
    assert inertia(", center_of_mass: 10 mm").center == 0.01
    assert inertia(", center_of_mass: 10 mm").central == pytest.approx(own.central + own.mass * 0.02**2)
    about_origin = inertia(", transverse_inertia: 0.05 kg m^2")
    assert about_origin.transverse == pytest.approx(0.05, rel=1e-14)
    assert about_origin.central == pytest.approx(0.05 - own.mass * 0.03**2, rel=1e-14)


# ---------------------------------------------------------------------------------------------- gears


def test_hand_is_the_sign_of_beta() -> None:
    text = pair(
        gear("a", more="helix_angle: 15 deg, hand: right"), gear("b", more="helix_angle: 15 deg, hand: left")
    )
    model = loads_model(text)
    assert model.gears["a"].geometry.beta == pytest.approx(math.radians(15.0))
    assert model.gears["b"].geometry.beta == pytest.approx(-math.radians(15.0))


def test_right_hand_teeth_turn_counter_clockwise_along_z() -> None:
    model = loads_model(
        pair(
            gear("a", more="helix_angle: 15 deg, hand: right"),
            gear("b", more="helix_angle: 15 deg, hand: left"),
        )
    )
    assert tooth_twist(model.gears["a"], 1e-3) > 0.0 > tooth_twist(model.gears["b"], 1e-3)


def test_bevel_gears_open_from_their_apex_towards_plus_or_minus_z() -> None:
    """The apex lies 50 mm up the z axis of the body; tooth 0 stands 30° from its x axis, about its z axis."""
    for opens, way in (("+z", 1.0), ("-z", -1.0)):
        model = loads_model(BEVEL.replace("opens: +z", f"opens: {opens}"))
        assert way * (model.body_inertia("one").center - 0.05) > 0.0
        tooth = bevel_axes(model.bevel_gears["a"], model.bevel_angles["a"])
        assert tooth[:, 2] == pytest.approx([0.0, 0.0, way])
        assert tooth[:, 0] == pytest.approx([math.cos(math.radians(30.0)), 0.5, 0.0])


def test_right_hand_spirals_turn_clockwise_outwards_seen_from_the_apex() -> None:
    """Who looks along the third axis sees positive angles go clockwise."""
    for hand, sign in (("right", 1.0), ("left", -1.0)):
        shape = loads_model(BEVEL.replace("hand: right", f"hand: {hand}")).bevel_gears["a"].geometry
        assert sign * shape.beta_m > 0.0
        inner, outer = (
            placed(shape, np.array(shape.delta), np.array(0.0), R) for R in (shape.R_i, shape.R_e)
        )
        assert outer[2] > inner[2] > 0.0
        assert sign * (math.atan2(outer[1], outer[0]) - math.atan2(inner[1], inner[0])) > 0.0


def test_hands_are_opposite_for_external_and_equal_for_internal_pairs() -> None:
    right, left = "helix_angle: 15 deg, hand: right", "helix_angle: 15 deg, hand: left"
    ring = f"type: internal, {right}"
    loads_model(pair(gear("a", more=right), gear("b", more=left)))
    loads_model(pair(gear("a", more=right), gear("b", z=90, more=ring)))
    with pytest.raises(ModelError, match="hand"):
        loads_model(pair(gear("a", more=right), gear("b", more=right)))
    with pytest.raises(ModelError, match="hand"):
        loads_model(pair(gear("a", more=left), gear("b", z=90, more=ring)))


def test_internal_gears_are_negative_inside_and_positive_outside() -> None:
    model = loads_model(pair(gear("a"), gear("b", z=90, more="type: internal")))
    ring = model.gears["b"].geometry
    assert ring.z == -90
    assert max(ring.d, ring.d_b, ring.d_a, ring.d_f, model.pairs["m"].a_w, model.pairs["m"].d_w2) < 0.0
    numbers = geometry_of_model(model)
    assert numbers["gears"]["b"]["z"] == 90
    assert min(numbers["gears"]["b"]["d_a"], numbers["meshes"]["m"]["a_w"]) > 0.0


def test_positive_x_thickens_teeth_of_external_and_internal_gears() -> None:
    for z in (30, -90):
        thin, thick = (CylindricalGear(z=z, m_n=3e-3, x=x) for x in (0.0, 0.3))
        assert thick.s_n > thin.s_n
        assert thick.d_a > thin.d_a  # signed: the tip circle of an internal gear shrinks
    # printed pair with the opposite sign for internal gears: x +0.5 there is -0.5 here
    printed = GearPair(CylindricalGear(z=16, m_n=3e-3), CylindricalGear(z=-24, m_n=3e-3, x=-0.5), -0.0131683)
    assert printed.x_sum == pytest.approx(-0.5, abs=5e-5)


def test_teeth_count_counter_clockwise_from_tooth_0_on_the_x_axis() -> None:
    wheel = CylindricalGear(z=20, m_n=3e-3, b=0.02)
    points = gear_outline(wheel, 40)
    tip = points[np.hypot(*points.T) > 0.499 * wheel.d_a]
    angle = np.arctan2(tip[:, 1], tip[:, 0])
    nearest = angle[abs(angle) < math.pi / 20]
    assert nearest.mean() == pytest.approx(0.0, abs=1e-6)
    # runout towards a quarter turn: tooth 5 of 20 stands there and moves outwards
    gap = separation(
        wheel, "left", [0.0], [0.02], deviations=Deviations(runout=Runout(amount=2e-6, phase=math.pi / 2))
    )
    other = separation(
        wheel, "right", [0.0], [0.02], deviations=Deviations(runout=Runout(amount=2e-6, phase=math.pi / 2))
    )
    middle = 0.5 * (gap + other)[:, 0, 0]
    assert int(np.argmin(middle)) == 5


def test_left_flank_is_on_the_counter_clockwise_side() -> None:
    # a tooth displaced counter-clockwise brings its left flank forward and takes its right flank back
    wheel = CylindricalGear(z=20, m_n=3e-3, b=0.02)
    late = Deviations(pitch=[0.0] * 10 + [5e-6, -5e-6] + [0.0] * 8)
    left, right = (separation(wheel, f, [0.0], [0.02], deviations=late)[:, 0, 0] for f in ("left", "right"))
    assert left[10] - left[9] < 0.0 < right[10] - right[9]


def test_faults_begin_at_the_lowest_z_and_displace_counter_clockwise() -> None:
    gear = CylindricalGear(z=30, m_n=3e-3, b=0.02)
    level = break_level(
        gear, [-0.01, 0.01], [roll_length(gear, gear.d_a)], width=5e-3, height=2e-3, at="start"
    )
    assert level[0, 0] > 0.0 > level[1, 0]
    # the left flank is on the counter-clockwise side: it comes nearer to its mate
    assert displaced_gap(gear, "left", 1e-6) < 0.0 < displaced_gap(gear, "right", 1e-6)


def test_gear_1_of_the_first_mesh_stands_with_tooth_0_at_angle_0() -> None:
    model = loads_model(pair(gear("a", 31), gear("b", 30), "direction: 90 deg"))
    assert model.phasing.tooth_angle["a"] == 0.0
    assert model.phasing.offset["m"] == pytest.approx(0.0, abs=1e-15)
    turned = loads_model(pair(gear("a", 31, more="initial_angle: 3 deg"), gear("b", 30)))
    assert turned.phasing.tooth_angle["a"] == pytest.approx(math.radians(3.0))
    bodies = "bodies: {one: {gears: [a], axes: {z: [0, 0, 1], x: [0, 1, 0]}}, two: {gears: [b]}}\n"
    assert loads_model(pair(gear("a"), gear("b"), "", bodies)).phasing.tooth_angle["a"] == 0.0


# ----------------------------------------------------------------------------------------------- mesh


def test_backlash_is_the_total_gap_in_a_named_direction() -> None:
    helix = "helix_angle: 15 deg, hand: {}"
    gears = gear("a", more=helix.format("right")), gear("b", more=helix.format("left"))
    for name in ("normal", "base_tangent", "circumferential"):
        model = loads_model(pair(*gears, f"backlash: {{{name}: 0.1 mm}}"))
        p = model.pairs["m"]
        factor = {
            "normal": 1.0 / math.cos(p.gear1.beta_b),
            "base_tangent": 1.0,
            "circumferential": math.cos(p.alpha_wt),
        }
        assert model.backlash("m") == pytest.approx(1e-4 * factor[name], rel=1e-12)
    per_module = loads_model(pair(*gears, "backlash: {factor: 0.04}"))
    by_circle = loads_model(pair(*gears, f"backlash: {{circumferential: {0.04 * p.gear1.m_n} m}}"))
    assert per_module.backlash("m") == pytest.approx(by_circle.backlash("m"), rel=1e-12)
    with pytest.raises(ModelError, match="gives circumferential and factor together"):
        loads_model(pair(*gears, "backlash: {circumferential: 0.1 mm, factor: 0.04}"))
    geometric = GearPair(p.gear1, p.gear2, p.a_w + 1e-4)
    assert geometric.j_wt == pytest.approx(geometric.j_bt / math.cos(geometric.alpha_wt))
    assert geometric.j_bn == pytest.approx(geometric.j_bt * math.cos(p.gear1.beta_b))


def test_the_backlash_channel_follows_the_actual_centre_distance() -> None:
    """2 (r_b1 + r_b2)(inv alpha_wt - inv alpha_w0), so 2 sin(alpha_wt) da to first order; a < 0 internal."""
    for internal in (False, True):
        m = one(internal=internal, z2=70)
        m.evaluate()
        rest = m.get("backlash")
        assert rest == pytest.approx(m.pair.j_bt, abs=1e-15)
        line = np.array([math.cos(m.theta), math.sin(m.theta), 0.0])
        for apart in (1e-7, 5e-5, -2e-5):
            m.frames["r"][1] += apart * line
            m.evaluate()
            m.frames["r"][1] -= apart * line
            a = m.pair.a_w + (-apart if internal else apart)
            assert m.get("backlash") == pytest.approx(m.pair.backlash(a).j_bt, abs=1e-13)
            if apart == 1e-7:
                change = 2.0 * math.sin(m.pair.alpha_wt) * (a - m.pair.a_w)
                assert m.get("backlash") - rest == pytest.approx(change, rel=1e-4)


def test_travel_is_r_b1_phi1_plus_r_b2_phi2_from_mid_gap() -> None:
    for internal in (False, True):
        m = one(internal=internal, z2=70)
        m.evaluate()
        assert m.get("transmission_error") == pytest.approx(0.0, abs=1e-15)
        m.frames["phi"] = [2e-4, 1e-4]
        m.evaluate()
        r1, r2 = 0.5 * m.pair.gear1.d_b, 0.5 * m.pair.gear2.d_b
        assert (r2 < 0.0) == internal
        assert m.get("transmission_error") == pytest.approx(2e-4 * r1 + 1e-4 * r2, rel=1e-9)


def test_axial_shift_adds_tan_beta_b_times_z2_less_z1() -> None:
    m = one(beta=0.3)
    m.evaluate(moved(m.frames, 1, np.array([0, 0, 1e-4, 0, 0, 0.0])))
    assert m.get("transmission_error") == pytest.approx(1e-4 * math.tan(m.pair.gear1.beta_b), rel=1e-9)


def test_front_flank_touches_beyond_plus_half_the_gap() -> None:
    m = one()
    for side in (1, -1):
        m.press(1e-7, side)
        assert m.get("contact_state") == side
        assert side * m.get("deflection") > 0.5 * m.row["now"]["gap"]
        m.press(-1e-7, side)
        assert m.get("contact_state") == 0.0


def test_contact_state_is_2_where_both_flanks_carry() -> None:
    m = OneMesh(make_pair(widening=-2e-5), MeshLaws(stiffness=PARABOLA))
    m.evaluate()
    assert m.row["now"]["gap"] < 0.0
    assert m.get("contact_state") == 2.0


def test_mesh_force_is_positive_on_the_front_flank_and_brakes_gear_1() -> None:
    for internal in (False, True):
        m = one(beta=0.0, internal=internal, z2=70)
        m.press(5e-6)
        F, force = m.evaluate(), m.get("mesh_force")
        assert force > 0.0
        assert F[:, 5] == pytest.approx([-force * m.row["r_b1"], -force * m.row["r_b2"]], rel=1e-9)
        m.press(5e-6, -1)
        assert m.get("mesh_force") < 0.0


def test_deflection_is_travel_less_excitation_and_counts_the_gap() -> None:
    m = one(beta=0.0, stiffness=FOURIER, e_cos=np.array([3e-6]), e_sin=np.array([0.0]))
    m.press(5e-6)
    e = 3e-6 * math.cos(2.0 * math.pi * m.get("mesh_phase"))
    assert m.get("transmission_error") - m.get("deflection") == pytest.approx(e, rel=1e-9)
    stretch = m.get("mesh_force") / m.get("mesh_stiffness")
    assert m.get("deflection") == pytest.approx(0.5 * m.row["now"]["gap"] + stretch, rel=1e-9)


def test_mesh_phase_counts_base_pitches_from_point_A() -> None:
    m = one(beta=0.0)
    psi, state = [], []
    for k in range(5):
        m.frames["phi"] = [k * 0.1 * 2 * math.pi / m.pair.gear1.z, -k * 0.1 * 2 * math.pi / m.pair.gear2.z]
        m.evaluate()
        psi.append(m.get("mesh_phase"))
        state.append(0.0 <= psi[-1] < 1.0)
    assert np.diff(psi) % 1.0 == pytest.approx(0.1, abs=1e-9)  # grows counter-clockwise, 1 per tooth
    assert all(state)
    # psi = 0: a pair stands at A, where the tip circle of gear 2 cuts the line of action
    m.frames["phi"] -= psi[-1] * 2 * math.pi * np.array([1.0 / m.pair.gear1.z, -1.0 / m.pair.gear2.z])
    m.evaluate()
    assert (m.get("mesh_phase") + 0.5) % 1.0 == pytest.approx(0.5, abs=1e-9)
    assert m.row["now"]["xi_A"] == pytest.approx(m.pair.T1A - m.pair.T1C, rel=1e-9)


def test_mesh_phase_is_the_mean_travel_of_both_gears() -> None:
    m = one(beta=0.0)
    m.evaluate()
    before = m.get("mesh_phase")
    s = 0.1 * m.row["p_bt"]
    m.frames["phi"] = [s / m.row["r_b1"], s / m.row["r_b2"]]  # opposite travel: deflection only
    m.evaluate()
    assert m.get("mesh_phase") == pytest.approx(before, abs=1e-12)
    m.frames["phi"] = [s / m.row["r_b1"], 0.0]
    m.evaluate()
    assert (m.get("mesh_phase") - before) % 1.0 == pytest.approx(0.05, abs=1e-9)


def test_back_flank_has_its_own_phase_and_runs_the_other_way() -> None:
    m = one(beta=0.0, stiffness=FOURIER)
    turn = 2.0 * math.pi * np.array([1.0 / m.pair.gear1.z, -1.0 / m.pair.gear2.z])
    for share in (0.07, 0.31):
        values = []
        for flank in (1, -1):
            m.frames["phi"] = flank * share * turn
            m.press(5e-6, flank)
            values.append(m.get("mesh_stiffness"))
        assert values[1] == pytest.approx(values[0], rel=1e-9)


def test_excitation_over_shaft_angle_counts_turns_of_its_gear() -> None:
    m = one(beta=0.0, stiffness=FOURIER, orders1=np.array([[2.0, 1e-6, 0.5]]))
    m.frames["phi"] = [0.3, -0.3 * m.row["r_b1"] / m.row["r_b2"]]
    m.evaluate()
    e = m.get("transmission_error") - m.get("deflection")
    assert e == pytest.approx(1e-6 * math.cos(2.0 * 0.3 + 0.5), rel=1e-6)


def test_force_parts_are_those_on_gear_2() -> None:
    m = one(beta=0.3)
    for flank in (1, -1):
        m.press(5e-6, flank)
        F = m.evaluate()[1]
        e = np.array([math.cos(m.theta), math.sin(m.theta), 0.0])
        t = np.cross([0.0, 0.0, 1.0], e)
        assert m.get("circumferential_force") == pytest.approx(F[:3] @ t, rel=1e-9)
        assert m.get("radial_force") == pytest.approx(F[:3] @ e, rel=1e-9)
        assert m.get("radial_force") > 0.0
        assert m.get("axial_force") == pytest.approx(F[2], rel=1e-9)
        assert m.get("normal_force") == pytest.approx(np.linalg.norm(F[:3]), rel=1e-9)
        assert flank * m.get("circumferential_force") > 0.0
    both = OneMesh(make_pair(beta=0.0, widening=-2e-5), MeshLaws(stiffness=PhaseStiffness(mean=4e8)))
    F = both.evaluate()[1]
    assert both.get("contact_state") == 2.0
    # each flank pushes with k |j|/2; around, they cancel
    assert both.get("normal_force") == pytest.approx(4e8 * abs(both.row["now"]["gap"]), rel=1e-9)
    assert np.linalg.norm(F[:3]) == pytest.approx(
        both.get("normal_force") * float(both.row["now"]["sin_a"]), rel=1e-9
    )


def test_mesh_damper_is_part_of_mesh_force_alone() -> None:
    m = one(beta=0.0, d_gap=1e3)
    m.frames["tw"][0, 5] = 10.0
    m.evaluate()
    assert m.get("contact_state") == 0.0
    assert m.get("mesh_force") == pytest.approx(1e3 * 10.0 * m.row["r_b1"], rel=1e-9)
    assert m.get("normal_force") == m.get("circumferential_force") == 0.0


def test_eccentric_teeth_are_displaced_towards_their_phase() -> None:
    text = pair(gear("a", 30), gear("b", 45), "stiffness: {law: constant, value: 4e8}", BODIES_OF_PAIR)
    model = loads_model(text)
    alpha = model.pairs["m"].alpha_wt
    towards = model.meshes["m"].theta + 0.5 * math.pi - alpha  # the line of action of the front flank
    found = []
    for amount in (0.0, 1e-6):
        phase = towards - model.phasing.tooth_angle["a"]
        fault = {"type": "eccentricity", "amount": amount, "phase": phase}
        rest = solve_equilibrium(compile_model(model.replace("gears.a.faults", {"e": fault})))
        found.append(float(rest["transmission_error[m]"]))
    assert found[1] - found[0] == pytest.approx(-1e-6, abs=1e-9)


def test_teeth_of_bevel_gears_count_about_the_direction_into_the_gear() -> None:
    """Tooth 1 of gear a, on the pitch ray, stands 20 µm ahead on the pitch cone: front flanks touch after
    20 µm cos(alpha) less travel, to what 1 N m bends. About the z of a body that opens to -z it is behind."""
    for opens, way in (("+z", 1.0), ("-z", -1.0)):
        # axis 2 is x of the world, which is -y or y of the body
        at = -way * (0.5 * math.pi + 2.0 * math.pi / 20)
        ends = f"  in: {{body: first, torque: {way}}}\n  out: {{body: second, torque: balance}}\n"
        text = bevel_file(opens=(opens, "+z"), mesh="backlash: {normal: 0.1 mm}", rest=f"loads:\n{ends}")
        error = []
        for amount in ("0 um", "20 um"):
            fault = f"faults: {{x: {{type: pitch_error, tooth: 1, amount: {amount}}}}}, initial_angle: {at}"
            found = loaded(text.replace(f"opens: {opens}", f"opens: {opens}, {fault}", 1))
            error.append(found("transmission_error[m]"))
            assert found("contact_state[m]") == 1.0
        assert error[1] - error[0] == pytest.approx(-20e-6 * math.cos(math.radians(20.0)), rel=0.02)


def test_bevel_meshes_count_about_the_directions_from_the_apex() -> None:
    """A torque about +z of a body presses the front flank where the cone opens to +z, the back flank else."""
    loads = "loads:\n  in: {body: first, torque: 80 N m}\n  out: {body: second, torque: balance}\n"
    for opens, flank in (("+z", 1.0), ("-z", -1.0)):
        model = loads_model(bevel_file(opens=(opens, "+z"), rest=loads))
        found = solve_equilibrium(compile_model(model))
        pair = model.bevel_pairs["m"]
        r_b1 = pair.R_m * math.sin(pair.gear1.delta_b)
        assert float(found["contact_state[m]"]) == flank
        assert float(found["mesh_force[m]"]) == pytest.approx(flank * 80.0 / r_b1, rel=1e-9)
        for name in ("axial_force", "radial_force", "axial_force_1", "radial_force_1"):
            assert float(found[f"{name}[m]"]) > 0.0


def test_misalignment_is_the_lean_of_axis_2() -> None:
    """A spur gear 2 that is tilted by the same lean is pushed askew alike: the force leans too, 5 %."""
    for k, name in enumerate("te"):
        moments = []
        for tilted in (False, True):
            m = OneMesh(make_pair(beta=0.0), MeshLaws(stiffness=FOURIER))
            m.evaluate()
            turn = np.cross([0.0, 0.0, 1.0], 1e-4 * m.row["now"][name])
            if tilted:
                m.frames = moved(m.frames, 1, np.array([0.0, 0.0, 0.0, *turn]))
            else:
                m.rec["skew"][0, k] = 1e-4
            m.press(5e-6)
            moments.append(m.evaluate()[1, 3:5])
        assert np.abs(moments[0]).max() > 0.5
        np.testing.assert_allclose(moments[1], moments[0], atol=0.05 * np.abs(moments[0]).max())


def test_friction_turns_round_at_the_pitch_point() -> None:
    m = one(beta=0.0, mu=0.1, v_eps=1e-6)
    r1, r2 = m.row["r_b1"], m.row["r_b2"]
    m.frames["spin"] = [50.0, -50.0 * r1 / r2]
    m.frames["tw"][:, 5] = m.frames["spin"]
    m.press(5e-6)
    pitch = -m.row["now"]["xi_A"] / m.row["p_bt"] - m.get("mesh_phase")
    start = m.frames["phi"].copy()
    for beyond in (-0.05, 0.05):
        way = (pitch + beyond) * m.row["p_bt"]
        m.frames["phi"] = start + way / np.array([r1, -r2])
        m.evaluate()
        arms = np.array([r1, r2]) * math.tan(m.pair.alpha_wt) + [
            beyond * m.row["p_bt"],
            -beyond * m.row["p_bt"],
        ]
        expected = -math.copysign(0.1 * m.get("mesh_force"), beyond) * arms
        assert m.friction_torques() == pytest.approx(expected, rel=1e-3)


def test_pair_forces_add_up_to_the_force_of_the_flanks() -> None:
    m = one(beta=0.3, n_pair=4)
    m.press(5e-6, -1)
    assert m.out[N_OUT : N_OUT + 4].sum() == pytest.approx(m.get("mesh_force"), rel=1e-9)
    wide = one(beta=0.5, b=0.2, n_pair=13)  # as many as there are
    wide.press(5e-6, -1)
    assert (wide.out[N_OUT:] < 0.0).sum() in (11, 12)
    assert wide.out[N_OUT:].sum() == pytest.approx(wide.get("mesh_force"), rel=1e-9)


# ----------------------------------------------------------------------------------- loads and drives


def test_positive_torques_on_both_gears_load_the_front_flank() -> None:
    assert loaded(TORSIONAL_PAIR)("contact_state[stage]") == 1.0
    assert loaded(TORSIONAL_PAIR.replace("150 N m", "-150 N m"))("contact_state[stage]") == -1.0


def test_the_place_of_a_force_does_not_spin() -> None:
    text = FREE + "loads: {f: {body: rotor, force: [0, 100 N, 0], position: [20 mm, 0, 30 mm]}}\n"
    system = compile_model(loads_model(text))
    state = system.initial_state()
    spin = system.spin("rotor")
    plain = compile_model(loads_model(FREE))
    for turned in (0.0, 1.0, -2.0):
        state.q[spin] = turned
        pushed = evaluate.residual(plain, state) - evaluate.residual(system, state)
        assert np.allclose(pushed, [0.0, 100.0, 0.0, -3.0, 0.0, 2.0], atol=1e-9)
    # along x of the world: the force is still along y there, its place 20 mm along x of the body, which is y
    system = compile_model(loads_model(ALONG_X + text[len(FREE) :]))
    pushed = evaluate.residual(compile_model(loads_model(ALONG_X)), state) - evaluate.residual(system, state)
    assert np.allclose(pushed, [100.0, 0.0, 0.0, 0.0, 3.0, 0.0], atol=1e-9)


def test_balance_holds_the_train_where_a_run_starts() -> None:
    text = TORSIONAL_PAIR.replace(
        "output: {body: driven, torque: 150 N m}", "output: {body: driven, torque: balance}"
    ).replace("g2: {number_of_teeth: 50", "g2: {number_of_teeth: 75")
    text = text.replace("center_distance: 150 mm", "center_distance: 187.5 mm")
    model = loads_model(text)
    start = prepare_start(compile_model(model, "steady"), model.scenarios["steady"])
    row = evaluate.observe(start.system, start.state)
    assert row[start.system.layout.channel("torque[output]")] == pytest.approx(150.0 * 75 / 50, rel=1e-6)


def test_speeds_of_mating_gears_have_opposite_signs_if_external() -> None:
    model = loads_model(TORSIONAL_PAIR)
    speeds = model.start_speeds("steady")
    assert speeds["driven"] == pytest.approx(-speeds["driver"])
    bodies = "bodies: {one: {gears: [a]}, two: {gears: [b]}}\n"
    bodies += "scenarios: {s: {speed: {one: 10 rad/s}, duration: 1 s}}\n"
    ring = loads_model(pair(gear("a"), gear("b", z=90, more="type: internal"), "", bodies))
    assert ring.start_speeds("s")["two"] == pytest.approx(10.0 * 30 / 90)


# ------------------------------------------------------------------------------------- force elements


def two_shafts(kind: str, turned: float = 1.0, **numbers: object) -> System:
    """Two free shafts at one place, the second on ground or on the first, and one element between them."""
    axes = np.diag([1.0, turned, turned])
    inertia = {"mass": 1.0, "polar_inertia": 0.2, "transverse_inertia": 0.1}
    bodies = [
        Body(motion=joints.FREE, name="one", **inertia),
        Body(motion=joints.FREE, axes=axes, name="two", **inertia),
        Body(motion=joints.TORSION, parent=1, name="rider", **inertia),
        Body(polar_inertia=1.0, name="state"),
    ]
    record = np.zeros(1, registry.find(kind).record)
    for name in ("A_i", "A_j"):
        if name in record.dtype.names:
            record[name] = np.eye(3)
    for name, value in numbers.items():
        record[name] = value
    return assemble(bodies, {kind: record}, names={kind: ["n"]})


def shown_by(system: System, **coordinates: float) -> Callable[[str], float]:
    """Observations where some coordinates (q) and rates (with v_ before the name) are not zero."""
    state = system.initial_state()
    for name, value in coordinates.items():
        rate, place = name.startswith("v_"), name.removeprefix("v_").replace("__", ".")
        (state.v if rate else state.q)[system.layout.coordinate(place)] = value
    row = evaluate.observe(system, state)
    return lambda channel: float(row[system.layout.channel(channel)])


def test_angles_between_bodies_count_all_spins_from_ground() -> None:
    turns = {"one__spin": 0.3, "two__spin": 0.5, "rider__spin": 0.7}
    for i, j, side, angle in ((1, 2, 1.0, -0.2), (1, 2, -1.0, 0.8), (3, 2, 1.0, 0.5), (3, 1, 1.0, 0.7)):
        system = two_shafts("coupling", side, i=i, j=j, k=10.0)
        get = shown_by(system, **turns)
        assert get("twist[n]") == pytest.approx(angle, abs=1e-15)
        assert get("torque[n]") == pytest.approx(-10.0 * angle, abs=1e-14)
        state = system.initial_state()
        state.turns[1] = 2
        evaluate.observe(system, state)
        wrench = system.workspace.fr["F"]
        assert wrench[i, 5] == pytest.approx(-wrench[j, 5])
        carried = 0.0 if (i, j) == (3, 1) else 4.0 * math.pi
        assert wrench[i, 5] == pytest.approx(-10.0 * carried)


def test_tension_draws_the_ends_together() -> None:
    system = two_shafts("spring_damper", i=1, j=2, p_i=(0.0, 0.0, 0.5), k=10.0, free=0.2)
    get = shown_by(system)
    assert get("elongation[n]") == pytest.approx(0.3)
    assert get("tension[n]") == pytest.approx(3.0)
    assert system.workspace.fr["F"][1, 2] == pytest.approx(-3.0)
    assert system.workspace.fr["F"][2, 2] == pytest.approx(3.0)


def test_bushing_force_is_that_on_the_first_body_in_axes_of_the_second() -> None:
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    system = two_shafts("bushing", i=1, j=2, A_i=turn, A_j=turn, K=7.0 * np.eye(6))
    assert shown_by(system, one__x=0.1)("bushing_force[n.fy]") == pytest.approx(0.7)
    assert system.workspace.fr["F"][1, 0] == pytest.approx(-0.7)
    system = two_shafts(
        "clearance_bearing", i=1, j=2, A_i=turn, A_j=turn, gap=0.1, stiffness=7.0, exponent=1.0
    )
    assert shown_by(system, one__x=0.3)("bearing_force[n.fy]") == pytest.approx(1.4)
    assert system.workspace.fr["F"][1, 0] == pytest.approx(-1.4)


def test_axes_of_bearing_forces_do_not_spin_with_the_outer_ring() -> None:
    """A planet is 50 µm off its pin along x of the carrier, whatever the angles of both are."""
    text = (
        "bodies:\n  carrier: {inertia: 1 kg m^2, position: [0, 0, 0]}\n"
        "  planet: {motion: planar, mass: 1 kg, inertia: 1 kg m^2, position: [100 mm, 0, 0]}\n"
        "joints: {pin: {type: planar, bodies: [carrier, planet], position: [100 mm, 0, 0]}}\n"
        "plain_bearings: {b: {ends: [carrier, planet], clearance: 20 um, stiffness: 1e9, exponent: 1}}\n"
    )
    system = compile_model(loads_model(text.replace("motion: planar, ", "")))
    state = system.initial_state()
    state.q[system.layout.coordinate("planet.x")] = 50e-6
    first = system.layout.channel("bearing_force[b.fx]")
    for turned, carried in ((0.0, 0.0), (1.0, 0.0), (-2.0, 0.0), (1.0, 0.7)):
        state.q[system.spin("planet")], state.q[system.spin("carrier")] = turned, carried
        force = evaluate.observe(system, state)[first : first + 2]
        assert np.allclose(force, [40e-6 * 1e9, 0.0], rtol=1e-6, atol=1.0)


def test_a_positive_contact_angle_carries_along_plus_z() -> None:
    numbers = {"i": 1, "j": 2, "n": 8, "pitch": 0.1, "element": 0.01, "stiffness": 1e6, "exponent": 1.5}
    system = two_shafts("rolling_bearing", angle=0.4, **numbers)
    assert shown_by(system, one__z=1e-3)("bearing_force[n.fz]") < -1.0
    assert shown_by(system, one__z=-1e-3)("bearing_force[n.fz]") == 0.0
    system = two_shafts("rolling_bearing", gap=1e-3, **numbers)
    assert shown_by(system, one__x=0.99e-3)("bearing_force[n.fx]") == 0.0
    assert shown_by(system, one__x=1.01e-3)("bearing_force[n.fx]") < 0.0


def test_faults_of_rolling_bearings_are_where_their_angles_say() -> None:
    """Under preload the inner ring is pushed to where an element drops in: element 1, at 40 deg here."""
    bearing = (
        "bodies: {rotor: {motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01 kg m^2}}\n"
        "rolling_bearings:\n  b: {ends: [rotor, ground], elements: 9, element_diameter: 8 mm, "
        "pitch_diameter: 40 mm, stiffness: 1e9, clearance: -40 um, "
        "faults: {f: {type: %s, length: 1 mm, depth: 10 um}}}\n"
    )
    for fault in ("outer_race, angle: 40 deg", "inner_race, angle: 40 deg", "rolling_element, element: 1"):
        system = compile_model(loads_model(bearing % fault))
        row = evaluate.observe(system, system.initial_state())
        fx, fy = (row[system.layout.channel(f"bearing_force[b.{c}]")] for c in ("fx", "fy"))
        assert math.hypot(fx, fy) > 1.0
        assert math.degrees(math.atan2(fy, fx)) == pytest.approx(40.0, abs=1e-9)


@pytest.mark.filterwarnings("ignore:.*is not used")
def test_a_ring_on_ground_is_where_the_other_ring_is() -> None:
    """A rotor along world x away from the origin; only the bearing for +z presses back on a shift to +z."""
    text = (
        "bodies: {rotor: {motion: free, position: [0.3, 0.2, 0.1], axes: {z: [1, 0, 0]}, mass: 2 kg, "
        "inertia: 0.01 kg m^2, transverse_inertia: 0.01 kg m^2, markers: {m: {position: [0, 0, 40 mm]}}}}\n"
        "rolling_bearings:\n  a: {%s, designation: 30208, axial_force_absorption: %s}\n"
    )
    for place in ("ends: [rotor.m, ground]", "body: rotor, position: [0, 0, 40 mm]"):
        for direction, loaded in (("positive", True), ("negative", False)):
            system = compile_model(loads_model(text % (place, direction)))
            record = system.records["rolling_bearing"][0]
            np.testing.assert_allclose(record["p_j"], [0.34, 0.2, 0.1], atol=1e-15)
            np.testing.assert_allclose(record["A_j"][:, 2], [1.0, 0.0, 0.0], atol=1e-15)
            state = system.initial_state()
            state.q[system.layout.coordinate("rotor.z")] = 20e-6
            row = evaluate.observe(system, state)
            axial = row[system.layout.channel("bearing_force[a.axial]")]
            assert axial < -1.0 if loaded else axial == 0.0


def test_friction_acts_against_the_slip_speed() -> None:
    system = two_shafts("friction_clutch", i=1, j=2, value=5.0, ratio=2.0, v_s=0.1, v_eps=0.1)
    get = shown_by(system, v_one__spin=3.0, v_two__spin=1.0)
    assert get("slip_speed[n]") == pytest.approx(2.0)
    assert get("torque[n]") == pytest.approx(-5.0)
    assert get("friction_power[n]") == pytest.approx(10.0)


# ----------------------------------------------------------------------------------------------- wind


def test_the_wind_turns_from_x_towards_y() -> None:
    plain = SteadyWind(speed=8.0, hub_height=90.0)
    up = SteadyWind(speed=8.0, hub_height=90.0, inflow_angle=0.1)
    left = SteadyWind(speed=8.0, hub_height=90.0, direction=0.2)
    veer = SteadyWind(speed=8.0, hub_height=90.0, veer=0.01)
    turned = Gust(shape="rise", start=0.0, duration=1.0, amplitude=0.0, angle=0.3)
    assert WindField(plain).velocity([[0.0, 0.0, 90.0]], 0.0)[0] == pytest.approx([8.0, 0.0, 0.0])
    assert WindField(up).velocity([[0.0, 0.0, 90.0]], 0.0)[0, 2] == pytest.approx(8.0 * math.sin(0.1))
    for wind, gust, z, angle in (
        (left, None, 90.0, 0.2),
        (veer, None, 100.0, 0.1),
        (plain, turned, 90.0, 0.3),
    ):
        v = WindField(wind, gust).velocity([[0.0, 0.0, z]], 2.0)[0]
        assert math.atan2(v[1], v[0]) == pytest.approx(angle)


def test_a_positive_shear_is_faster_above_and_at_the_left() -> None:
    steady = SteadyWind(speed=8.0, hub_height=90.0, profile="uniform")
    site = RotorSite(WindClass("I", "A"), hub_height=90.0, diameter=100.0)
    for direction, point in (("vertical", [0.0, 0.0, 110.0]), ("horizontal", [0.0, 20.0, 90.0])):
        gust = site.wind_shear(8.0, direction, sign=1)
        assert WindField(steady, gust).velocity([point], 6.0)[0, 0] > 9.0


def test_rotors_are_driven_about_the_downwind_axis() -> None:
    """Parked in wind, the twist of the blades drives it; the stations of blade 1 are above the hub."""
    at = {"inertia": 1e7, "position": (0.0, 0.0, 90.0), "axes": {"z": (1.0, 0.0, 0.0), "x": (0.0, 0.0, 1.0)}}
    rotor = {"hub": "hub", "aerodyn": str(AERODYN), "hub_radius": 1.5, "tower_position": (5.0, 0.0)}
    model = Model.from_dict(
        {
            "bodies": {"hub": at},
            "winds": {"w": {"speed": 8.0, "height": 90.0}},
            "wind_rotors": {"rotor": rotor},
        }
    )
    torque = []
    for turned in (model, model.replace("wind_rotors.rotor.pitch", "20 deg")):
        system = compile_model(turned)
        row = evaluate.observe(system, system.initial_state())
        thrust, found = (row[system.layout.channel(f"{w}[rotor]")] for w in ("rotor_thrust", "rotor_torque"))
        assert thrust > 0.0
        torque.append(found)
    assert 0.0 < torque[0] < torque[1]  # at rest a leading edge upwind gives more torque
    place = system.records["blade_station"]["x"][:, 0]
    blades = place.reshape(3, -1, 3)[:, -1]
    assert blades[0, 2] > 150.0
    assert blades[1, 1] < 0.0 < blades[2, 1]  # clockwise for a view downwind


def test_a_box_moves_downwind() -> None:
    velocity = np.arange(48, dtype=np.float32).reshape(4, 2, 2, 3)
    numbers = {"spacing": (6.0, 8.0), "bottom": 86.0, "hub_height": 90.0, "mean_speed": 10.0}
    field = WindField(box=WindBox(velocity=velocity, time_step=1.0, **numbers))
    for x, t in ((0.0, 1.0), (10.0, 2.0), (-10.0, 0.0)):
        assert field.velocity([[x, -3.0, 86.0]], t)[0] == pytest.approx(velocity[1, 0, 0])
        assert field.velocity([[x, 3.0, 94.0]], t)[0] == pytest.approx(velocity[1, 1, 1])


# -------------------------------------------------------------------------------------------- signals

SLIDE = """\
gravity: [0, -9.81, 0]
bodies:
  slide: {mass: 2 kg, inertia_tensor: [1, 1, 1, 0, 0, 0]}
  wheel: {motion: torsion, inertia: 0.5 kg m^2, position: [0, 0, 1]}
joints:
  way: {type: prismatic, bodies: [ground, slide], position: [0, 0, 0], axes: {z: [1, 0, 0]}, start: {z: 0.3}}
sensors:
  place: {type: frames, quantity: position, ends: [slide, ground], axis: x}
  seen: {type: frames, quantity: position, ends: [ground, slide], axis: x}
  turning: {type: frames, quantity: angular_velocity, ends: [wheel, ground]}
  load: {type: load, at: slide, axis: y}
blocks:
  one: {type: sum, offset: 1}
"""


def of_slide(more: str = "") -> tuple[System, Callable[[str], float]]:
    """Observations of the slide 0.3 m along x and the wheel that turns counter-clockwise, by name."""
    system = compile_model(loads_model(SLIDE + more))
    state = system.initial_state()
    state.v[system.spin("wheel")] = 2.0
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    row = evaluate.observe(system, evaluate.store(system, 0.0))
    rates = evaluate.store(system, 0.0).a
    names = {c.name: float(row[k]) for k, c in enumerate(system.layout.channels)}
    names |= {f"a {c}": float(rates[k]) for k, c in enumerate(system.layout.coordinates)}
    return system, lambda name: names[name]


def test_sensors_say_how_the_first_is_seen_from_the_second() -> None:
    _, get = of_slide()
    assert get("signal[place]") == pytest.approx(0.3)
    assert get("signal[seen]") == pytest.approx(-0.3)
    assert get("signal[turning]") == pytest.approx(2.0)
    assert get("signal[load]") == pytest.approx(2.0 * 9.81)


def test_positive_signals_act_on_the_first() -> None:
    for actuator, name, wanted in (
        ("{type: torque, signal: one, bodies: [wheel]}", "a wheel.spin", 2.0),
        ("{type: strut, signal: one, ends: [ground, slide]}", "a slide.z", 0.5),
        ("{type: force, signal: one, ends: [slide, ground], axis: x}", "a slide.z", 0.5),
        ("{type: force, signal: one, ends: [ground, slide], axis: x}", "a slide.z", -0.5),
    ):
        _, get = of_slide(f"actuators:\n  m: {actuator}\n")
        assert get(name) == pytest.approx(wanted)


# ----------------------------------------------------------------------------------------- statistics


def test_rms_is_that_of_the_alternating_part() -> None:
    t = np.arange(1000) / 1000.0
    found = signal_statistics(7.0 + 3.0 * np.sin(2 * np.pi * 5 * t))
    assert found.mean == pytest.approx(7.0)
    assert found.rms == pytest.approx(3.0 / math.sqrt(2.0))
    assert (found.min, found.max) == pytest.approx((4.0, 10.0))


def test_window_starts_at_a_fifth_of_the_duration() -> None:
    model = loads_model(TORSIONAL_PAIR)
    assert model.scenarios["steady"].statistics_start == pytest.approx(0.1)
    given = loads_model(TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.5 s, settle_time: 30 ms"))
    assert given.scenarios["steady"].statistics_start == pytest.approx(0.03)


def test_every_step_of_the_window_counts_once_stored_or_not() -> None:
    text = TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.02 s, step: 5 us")
    model = loads_model(text)
    found = []
    for rate in ("100 kHz", "10 kHz"):
        scenario = loads_model(text.replace("100 kHz", rate)).scenarios["steady"]
        found.append(run_time(compile_model(model, scenario), scenario).channels["mesh_force[stage]"])
    assert found[0] == pytest.approx({k: v for k, v in found[1].items() if k != "unit"} | {"unit": "N"})


def test_statistics_of_nothing_are_no_numbers() -> None:
    found = read_statistics(new_statistics(2))
    assert found.count == 0
    for values in (found.mean, found.rms, found.least, found.most, found.share_negative, found.share_zero):
        assert np.isnan(values).all()
    assert plain({"mean": float(found.mean[0])}) == {"mean": None}
    assert shown(float(found.mean[0]), "force") == NOTHING


@pytest.mark.parametrize("method", ["generalized_alpha", "rk4", "runge_kutta"])
def test_a_run_ends_at_its_duration_samples_lie_at_multiples(method: str) -> None:
    for rest, last in (
        ("1 ms, sample_rate: 20 kHz", 1e-3),
        ("1.03 ms, sample_rate: 20 kHz", 1e-3),
        ("1.03 ms", 1.03e-3),
    ):
        text = TORSIONAL_PAIR.replace("0.5 s, sample_rate: 100 kHz", f"{rest}, step: 7 us, method: {method}")
        model = loads_model(text)
        memory = Memory()
        done = run_time(compile_model(model, "steady"), sink=memory)
        times = np.concatenate(memory.times)
        assert done.t_end == pytest.approx(model.scenarios["steady"].duration, rel=1e-12)
        assert done.window[1] == done.t_end
        assert times[-1] == pytest.approx(last, rel=1e-12)
        assert np.diff(times) == pytest.approx(times[1], rel=1e-9)


def test_an_impact_begins_after_a_state_without_contact() -> None:
    """On the back flank, then on the front flank; the change of the flank at the end is none."""
    state, force = [1, 0, -1, -1, 0, 1, -1], [3.0, 0.0, -4.0, -2.0, 0.0, 5.0, -1.0]
    found = rattle(np.arange(7.0), state, [1.0, 0.5, -1.5, -1.2, 0.0, 3.0, -1.0], force)
    assert (found.front_impacts, found.back_impacts) == (1, 1)
    assert (found.closing_speed_max, found.closing_speed_mean) == (3.0, 2.5)
    assert (found.impulse_max, found.impulse_mean) == (6.0, 5.5)


def test_shares_count_separation_and_the_back_flank_alone() -> None:
    sums = new_statistics(1)
    for state in (1.0, 0.0, 0.0, -1.0, 2.0, 1.0, 1.0, 1.0):
        accumulate(np.array([state]), sums.sums)
    found = read_statistics(sums)
    assert found.share_zero[0] == pytest.approx(2 / 8)
    assert found.share_negative[0] == pytest.approx(1 / 8)
    # of a stored signal both flanks at once count for front and back
    both = contact_statistics(np.arange(4.0), [2, 2, 2, 2])
    assert (both.front_contact_share, both.back_contact_share, both.loss_share) == (1.0, 1.0, 0.0)


# ------------------------------------------------------------------------------------------- diagnosis


def test_average_begins_where_the_reference_angle_is_zero() -> None:
    angle = 1.0 + 2.0 * np.pi * np.arange(5000) / 500
    mean = synchronous_average(np.cos(angle - 0.7), angle)
    assert mean.angle[0] == 0.0
    np.testing.assert_allclose(mean.values, np.cos(mean.angle - 0.7), atol=1e-6)
    # a gear that turns the other way counts its own turns forward
    np.testing.assert_allclose(
        synchronous_average(np.cos(angle - 0.7), -angle).values, mean.values, atol=1e-12
    )


def test_residual_keeps_first_order_sidebands_and_difference_does_not() -> None:
    angle = 2.0 * np.pi * np.arange(256) / 256
    parts = gear_signals(5.0 + sum(np.cos(k * angle) for k in (1, 2, 3, 19, 20, 21, 22, 40)), teeth=20)
    for signal, orders in ((parts.residual, {3, 19, 21, 22}), (parts.difference, {3, 22})):
        assert set(np.flatnonzero(np.abs(np.fft.rfft(signal)) > 1.0)) == orders


def test_kurtosis_of_gaussian_noise_is_three() -> None:
    noise = np.random.default_rng(1).standard_normal(100_000)
    assert standardised_moment(noise, 4) == pytest.approx(3.0, abs=3.0 * math.sqrt(24.0 / noise.size))
    sine = signal_indicators(7.0 + np.sin(2.0 * np.pi * np.arange(1000) / 1000))
    assert (sine.kurtosis, sine.crest_factor) == pytest.approx((1.5, math.sqrt(2.0)))


def test_signal_to_noise_ratio_is_that_of_the_alternating_part() -> None:
    square = 100.0 + np.tile([2.0, -2.0], 500)
    assert with_white_noise(square, signal_to_noise=20.0, seed=0).noise_deviation == pytest.approx(0.2)


# -------------------------------------------------------------------------------------------- statuses


def test_statuses_and_their_sentences() -> None:
    page = PAGE.read_text(encoding="utf-8")
    names = {k: v for k, v in vars(status).items() if k.isupper() and isinstance(v, int)}
    for name, value in names.items():
        assert f"{value} `{name}`" in page, name
    assert (status.DIED, status.OK) == (0, 1)


def test_exit_codes(tmp_path: Path) -> None:
    good, bad, law = (tmp_path / f"{n}.yaml" for n in ("good", "bad", "law"))
    good.write_text(pair(gear("a"), gear("b")))
    bad.write_text(pair(gear("a"), gear("c")))
    law.write_text(TORSIONAL_PAIR.replace("torque: 150 N m}      #", 'torque: "1 / (t - t)"}      #'))
    assert run_command(["check", str(good)]) == 0
    assert run_command(["check", str(bad)]) == 2
    assert run_command(["run", str(law), "-s", "steady", "-o", str(tmp_path / "x.h5"), "-q"]) == 3
