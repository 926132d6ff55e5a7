# SPDX-License-Identifier: Apache-2.0
"""Torques and speeds at constant speed from balance alone, against closed forms and the full model."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.carried_trains import relation
from pitchpoint.model.model import Model
from pitchpoint.model.speed_ratios import links_of
from pitchpoint.report.static_power import static_power
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.solvers.torque_paths import torque_paths
from pitchpoint.system.compile import compile_model

RPM = math.pi / 30.0
EXACT = 1e-12
HOUSE = Path(__file__).parents[3]
STARTERS = HOUSE / "src/pitchpoint/cli/starters"


def flow_of(model: Model, name: str = "run") -> dict[str, Any]:
    """Power flow of one scenario, whose power must balance."""
    found = static_power(model, model.scenarios[name], name)
    if found["power_in"]:
        assert found["power_out"] == pytest.approx(found["power_in"], rel=EXACT)
    return found


def gear(z: int, m: int = 4, *, internal: bool = False) -> str:
    kind = "type: internal, " if internal else ""
    size = f"number_of_teeth: {z}, normal_module: {m} mm, face_width: 30 mm"
    return f"{{{kind}{size}, profile_shift_coefficient: 0}}"


def torques(flow: dict[str, Any]) -> dict[str, float]:
    return {row["name"]: row["torque"] for row in flow["external"]}


def test_two_stages_by_hand() -> None:
    flow = flow_of(load_model(STARTERS / "two-stage.yaml"), "steady")
    i_1, i_2 = 75 / 21, 61 / 20
    speeds = {name: row["speed"] / RPM for name, row in flow["shafts"].items()}
    assert speeds == pytest.approx({"input": 1500.0, "middle": -1500.0 / i_1, "output": 1500.0 / i_1 / i_2})
    assert flow["links"]["stage_1"]["torques"] == pytest.approx([-60.0, -60.0 * i_1], rel=EXACT)
    assert flow["links"]["stage_2"]["torques"] == pytest.approx([60.0 * i_1, 60.0 * i_1 * i_2], rel=EXACT)
    assert torques(flow)["machine"] == pytest.approx(-60.0 * i_1 * i_2, rel=EXACT)
    stage = flow["links"]["stage_1"]
    d_w1 = 2.0 * 0.1 / (1.0 + i_1)
    assert stage["tangential_force"] == pytest.approx(120.0 / d_w1, rel=EXACT)
    assert stage["pitch_line_velocity"] == pytest.approx(math.pi * d_w1 * 25.0, rel=EXACT)
    assert stage["mesh_frequency"] == pytest.approx(21 * 25.0, rel=EXACT)


GRC = f"""
gears:
  sun: {gear(21, 10)}
  ring: {gear(99, 10, internal=True)}
  wheel_1: {gear(82)}
  pinion_1: {gear(23)}
  wheel_2: {gear(88)}
  pinion_2: {gear(22)}
bodies:
  carrier: {{inertia: 60 kg m^2}}
  ring: {{gears: [ring], motion: fixed}}
  low: {{gears: [sun, wheel_1]}}
  middle: {{gears: [pinion_1, wheel_2]}}
  high: {{gears: [pinion_2]}}
planetary_stages:
  stage: {{sun: sun, ring: ring, carrier: carrier, planets: 3, planet: {gear(39, 10)}}}
meshes:
  one: {{gears: [wheel_1, pinion_1]}}
  two: {{gears: [wheel_2, pinion_2]}}
loads:
  rotor: {{body: carrier, torque: 323 kN m}}
  generator: {{body: high, torque: balance}}
scenarios:
  run: {{speed: {{carrier: 22.09 rpm}}, duration: 1 s}}
"""


def test_the_wind_drive_train_of_the_reliability_collaborative() -> None:
    """NREL GRC 750 kW, 21/39/99, 82/23, 88/22: 22.09 rpm to 1800 rpm (machine data of the GRC reports)."""
    flow = flow_of(loads_model(GRC))
    ratio = (1.0 + 99 / 21) * (82 / 23) * (88 / 22)
    assert ratio == pytest.approx(81.490683, abs=5e-7)
    assert flow["shafts"]["high"]["speed"] / RPM == pytest.approx(22.09 * ratio, rel=EXACT)
    assert 1.0 / flow["shafts"]["high"]["ratio"] == pytest.approx(ratio, rel=EXACT)
    assert torques(flow)["generator"] == pytest.approx(-323e3 / ratio, rel=EXACT)
    assert torques(flow)["ring, fixed"] == pytest.approx(-323e3 * 99 / 120, rel=EXACT)
    for k in (1, 2, 3):  # equal planets carry a third each
        on_sun, _ = flow["links"][f"sun-planet_{k}"]["torques"]
        assert on_sun == pytest.approx(323e3 * 21 / 120 / 3, rel=1e-9)


SET = f"""
gears: {{sun: {gear(21, 3)}, ring: {gear(99, 3, internal=True)}}}
bodies:
  sun: {{gears: [sun]}}
  ring: {{gears: [ring], inertia: 0.2 kg m^2}}
  carrier: {{inertia: 0.1 kg m^2}}
planetary_stages: {{stage: {{sun: sun, ring: ring, carrier: carrier, planets: 3, planet: {gear(39, 3)}}}}}
loads:
"""
SET_FREE = SET.replace("loads:\n", "")
HELD = {
    "ring": ("sun", "carrier", 1.0 + 99 / 21),
    "carrier": ("sun", "ring", -99 / 21),
    "sun": ("ring", "carrier", 1.0 + 21 / 99),
}


@pytest.mark.parametrize("held", HELD)
def test_any_member_of_a_planetary_set_can_be_held(held: str) -> None:
    """Willis: i = 1 - i_0, i_0, 1 - 1/i_0 with i_0 = -z_r/z_s; the held member takes the difference."""
    driving, driven, ratio = HELD[held]
    text = SET + (
        f"  motor: {{body: {driving}, torque: 100 N m}}\n  machine: {{body: {driven}, torque: balance}}\n"
        f"scenarios: {{run: {{speed: {{{driving}: 900 rpm, {held}: 0 rpm}}, "
        f"hold: [{held}], duration: 1 s}}}}\n"
    )
    flow = flow_of(loads_model(text))
    assert flow["shafts"][driven]["speed"] == pytest.approx(900 * RPM / ratio, rel=EXACT)
    assert torques(flow)["machine"] == pytest.approx(-100.0 * ratio, rel=EXACT)
    assert torques(flow)[f"{held}, held"] == pytest.approx(100.0 * (ratio - 1.0), rel=EXACT)


def test_a_set_with_two_inputs() -> None:
    """Sun and ring driven at given speeds add up on the carrier, with torques as z_s : z_r : -(z_s + z_r)."""
    text = SET + (
        "  machine: {body: carrier, torque: -240 N m}\n"
        "scenarios: {run: {drive: {sun: {speed: 900 rpm}, ring: {speed: 100 rpm}}, duration: 1 s}}\n"
    )
    flow = flow_of(loads_model(text))
    assert flow["shafts"]["carrier"]["speed"] == pytest.approx((21 * 900 + 99 * 100) / 120 * RPM, rel=EXACT)
    assert torques(flow)["drive of sun"] == pytest.approx(240.0 * 21 / 120, rel=EXACT)
    assert torques(flow)["drive of ring"] == pytest.approx(240.0 * 99 / 120, rel=EXACT)
    assert flow["power_in"] == pytest.approx(240.0 * flow["shafts"]["carrier"]["speed"], rel=EXACT)


def test_a_bevel_differential_divides_the_torque_equally() -> None:
    """In a bend: half of the torque on each wheel at different speeds, whose mean is that of the cage."""
    flow = flow_of(load_model(HOUSE / "examples/bevel-drive/differential.yaml"), "bend")
    speed = {name: row["speed"] for name, row in flow["shafts"].items()}
    assert speed["one"] + speed["two"] == pytest.approx(2.0 * speed["cage"], rel=EXACT)
    assert speed["one"] != pytest.approx(speed["two"], rel=0.1)
    assert torques(flow)["engine"] == pytest.approx(120.0, rel=EXACT)
    assert [flow["shafts"][name]["torque"] for name in ("one", "two")] == pytest.approx(
        [60.0, 60.0], rel=EXACT
    )


def test_clutches_transmit_their_capacity_or_like_a_coupling() -> None:
    text = """
bodies: {engine: {inertia: 0.2 kg m^2, position: [0, 0, 0]}, load: {inertia: 0.4 kg m^2, position: [0, 0, 0]}}
clutches: {plate: {bodies: [engine, load], capacity: 80 N m}}
loads: {gas: {body: engine, torque: balance}, drag: {body: load, torque: -50 N m}}
scenarios:
  stuck: {speed: {engine: 900 rpm, load: 900 rpm}, duration: 1 s}
  slip: {speed: {engine: 900 rpm, load: 300 rpm}, hold: [load], duration: 1 s}
"""
    model = loads_model(text)
    stuck = flow_of(model, "stuck")
    assert stuck["links"]["plate"]["torques"] == pytest.approx([-50.0, 50.0], rel=EXACT)
    slip = static_power(model, model.scenarios["slip"], "slip")
    assert torques(slip)["gas"] == pytest.approx(80.0, rel=EXACT)
    assert torques(slip)["load, held"] == pytest.approx(-30.0, rel=EXACT)
    # in and out differ by the heat in the clutch, which is one of the external powers
    assert slip["power_out"] == pytest.approx(slip["power_in"], rel=EXACT)


def test_links_of_one_name_are_all_listed() -> None:
    flow = flow_of(
        loads_model(PATHS.replace("loads:", "ratios: {ab: {terms: {input: 1, output: -6.6}}}\nloads:"))
    )
    assert {"ab", "ratios.ab"} <= flow["links"].keys()


def test_a_power_split_with_recirculation() -> None:
    """The input drives the sun and, through wheels of ratio -k, the ring; the carrier is the output.

    Torques of the members are as 1 : z_r/z_s : -(1 + z_r/z_s). Input balance: M = T_s + T_r w_r/w_s. With the
    ring driven backwards its power comes back to the input: the sun transmits more than the input power.
    """
    text = SET.replace("loads:", "ratios: {split: {terms: {sun: 12, ring: 99}}}\nloads:") + (
        "  motor: {body: sun, torque: 100 N m}\n  machine: {body: carrier, torque: balance}\n"
        "scenarios: {run: {speed: {sun: 900 rpm}, duration: 1 s}}\n"
    )
    flow = flow_of(loads_model(text))
    k, i_0 = 12 / 99, 99 / 21
    T_s = 100.0 / (1.0 - k * i_0)
    assert torques(flow)["machine"] == pytest.approx(-T_s * (1.0 + i_0), rel=EXACT)
    assert flow["shafts"]["carrier"]["speed"] == pytest.approx(
        900 * RPM * (1.0 - k * i_0) / (1.0 + i_0), rel=EXACT
    )
    on_sun = -sum(flow["links"][f"sun-planet_{j}"]["torques"][0] for j in (1, 2, 3))
    assert on_sun == pytest.approx(T_s, rel=EXACT)
    assert on_sun > 200.0  # more than twice the input power circulates through the sun
    assert flow["links"]["split"]["torques"][1] * flow["shafts"]["ring"]["speed"] < 0.0


RAVIGNEAUX = f"""
gears:
  large_sun: {gear(30)}
  small_sun: {gear(24)}
  ring: {gear(70, internal=True)}
  long: {gear(20)}
  short: {gear(15)}
bodies:
  large: {{gears: {{large_sun: 0 mm}}, position: [0, 0, 0]}}
  small: {{gears: {{small_sun: 40 mm}}, position: [0, 0, 0]}}
  hollow: {{gears: {{ring: 0 mm}}, position: [0, 0, 0], inertia: 0.3 kg m^2}}
  carrier: {{inertia: 0.1 kg m^2, position: [0, 0, 0]}}
  long: {{gears: {{long: 20 mm}}, position: [100 mm, 0, 0]}}
  short: {{gears: {{short: 40 mm}}, position: [55.916666667 mm, 54.380967805 mm, 0]}}
joints:
  long_pin: {{type: revolute, bodies: [carrier, long]}}
  short_pin: {{type: revolute, bodies: [carrier, short]}}
meshes:
  a: {{gears: [large_sun, long]}}
  b: {{gears: [long, ring]}}
  c: {{gears: [small_sun, short]}}
  d: {{gears: [short, long]}}
loads: {{motor: {{body: small, torque: 50 N m}}, out: {{body: hollow, torque: balance}}}}
scenarios:
  first: {{speed: {{small: 3000 rpm, carrier: 0 rpm}}, hold: [carrier], duration: 1 s}}
  second: {{speed: {{small: 3000 rpm, large: 0 rpm}}, hold: [large], duration: 1 s}}
"""


@pytest.mark.parametrize(
    ("gear_", "ratio", "held"),
    [("first", 70 / 24, "carrier"), ("second", (1 + 30 / 24) / (1 + 30 / 70), "large")],
)
def test_the_gears_of_a_ravigneaux_set(gear_: str, ratio: float, held: str) -> None:
    """Two suns, long and short planets on one carrier, one ring.

    With the carrier speed c: ring - c = (z_small/z_ring)(small - c) = -(z_large/z_ring)(large - c).
    """
    flow = flow_of(loads_model(RAVIGNEAUX), gear_)
    assert flow["shafts"]["hollow"]["ratio"] == pytest.approx(ratio, rel=1e-11)
    assert torques(flow)["out"] == pytest.approx(-50.0 * ratio, rel=1e-11)
    assert torques(flow)[f"{held}, held"] == pytest.approx(50.0 * (ratio - 1.0), rel=1e-11)


PATHS = f"""
gears: {{a: {gear(20)}, b: {gear(60)}, c: {gear(60)}, d: {gear(25)}, e: {gear(25)}, f: {gear(55)}}}
bodies:
  input: {{gears: [a], position: [0, 0, 0]}}
  left: {{gears: [b, d], position: [-160 mm, 0, 0]}}
  right: {{gears: [c, e], position: [160 mm, 0, 0]}}
  output: {{gears: [f], position: [0, 0, 0]}}
meshes:
  ab: {{gears: [a, b]}}
  ac: {{gears: [a, c]}}
  df: {{gears: [d, f]}}
  ef: {{gears: [e, f]}}
loads: {{motor: {{body: input, torque: 90 N m}}, machine: {{body: output, torque: balance}}}}
scenarios: {{run: {{speed: {{input: 600 rpm}}, duration: 1 s}}}}
"""


def test_equal_parallel_paths_share_equally() -> None:
    flow = flow_of(loads_model(PATHS))
    for mesh, share in (("ab", -45.0), ("ac", -45.0), ("df", 135.0), ("ef", 135.0)):
        assert flow["links"][mesh]["torques"][0] == pytest.approx(share, rel=EXACT)
    assert torques(flow)["machine"] == pytest.approx(-90.0 * 3 * 55 / 25, rel=EXACT)
    assert "as if equally stiff" in flow["notes"][-1]


def test_parallel_couplings_share_equally_and_their_shares_are_noted() -> None:
    """Shaft and hub joined by a fit and a key, as two joints of a file of another maker."""
    text = f"""
gears: {{a: {gear(20)}, b: {gear(40)}}}
bodies: {{hub: {{gears: [a]}}, shaft: {{inertia: 0.1 kg m^2}}, two: {{gears: [b]}}}}
meshes: {{ab: {{gears: [a, b]}}}}
couplings:
  fit: {{bodies: [shaft, hub], stiffness: {{torsion: 1e7 N m/rad}}}}
  key: {{bodies: [shaft, hub], stiffness: {{torsion: 1e7 N m/rad}}}}
loads: {{motor: {{body: shaft, torque: 90 N m}}, machine: {{body: two, torque: balance}}}}
scenarios: {{run: {{speed: {{shaft: 600 rpm}}, duration: 1 s}}}}
"""
    flow = flow_of(loads_model(text))
    for coupling in ("fit", "key"):
        assert abs(flow["links"][coupling]["torques"][0]) == pytest.approx(45.0, rel=EXACT)
    assert torques(flow)["machine"] == pytest.approx(180.0, rel=EXACT)
    assert any("fit" in note and "key" in note and "as if equally stiff" in note for note in flow["notes"])


def test_several_outputs_and_an_unloaded_branch() -> None:
    text = f"""
gears: {{a: {gear(20)}, b: {gear(40)}, c: {gear(30)}, d: {gear(25)}}}
bodies: {{one: {{gears: [a]}}, two: {{gears: [b]}}, three: {{gears: [c]}}, four: {{gears: [d]}}}}
meshes:
  ab: {{gears: [a, b]}}
  ac: {{gears: [a, c], direction: 180 deg}}
  ad: {{gears: [a, d], direction: 90 deg}}
loads: {{pump: {{body: two, torque: 20 N m}}, fan: {{body: three, torque: 15 N m}}}}
scenarios: {{run: {{drive: {{one: {{speed: 1000 rpm}}}}, duration: 1 s}}}}
"""
    flow = flow_of(loads_model(text))
    assert torques(flow)["drive of one"] == pytest.approx(20.0 * 20 / 40 + 15.0 * 20 / 30, rel=EXACT)
    assert flow["links"]["ad"]["torques"] == pytest.approx([0.0, 0.0], abs=1e-12)


def test_what_balance_does_not_decide_is_not_given() -> None:
    """Two drives on one train; loads that do not balance."""
    twice = loads_model(
        PATHS.replace(
            "speed: {input: 600 rpm}", "drive: {input: {speed: 600 rpm}, output: {speed: 90.90909 rpm}}"
        )
    )
    flow = flow_of(twice)
    assert torques(flow)["drive of input"] is None and flow["links"]["ab"]["torques"] == [None, None]
    assert any("statically indeterminate" in note for note in flow["notes"])
    loose = flow_of(loads_model(PATHS.replace("torque: balance", "torque: -500 N m")))
    assert loose["power_in"] is None and any("do not balance" in note for note in loose["notes"])
    assert "-94 N m on output" in loose["notes"][-1]  # 90 * 3 * 55/25 = 594


def test_a_train_about_any_axis_has_the_same_torques() -> None:
    text = (STARTERS / "two-stage.yaml").read_text()
    turned = text.replace(
        "    position: [0, 0, 0]", "    position: [0, 0, 0]\n    axes: {z: [0, 1, 0], x: [0, 0, 1]}"
    )
    assert turned != text
    one, two = (flow_of(loads_model(each), "steady") for each in (text, turned))
    assert two["links"] == one["links"]


@pytest.mark.parametrize(
    ("file", "tolerance"),
    [(STARTERS / "two-stage.yaml", 3e-3), (HOUSE / "examples/planetary-set/model.yaml", 8e-3)],
)
def test_tooth_forces_are_those_of_the_static_solution(file: Path, tolerance: float) -> None:
    """Deflections of shafts and bearings change lever arms and pressure angles by less than the tolerance."""
    model = load_model(file)
    rest = solve_equilibrium(compile_model(model, "steady"))
    for name, row in flow_of(model, "steady")["links"].items():
        part = {key: float(rest[f"{key}_force[{name}]"]) for key in ("circumferential", "radial", "axial")}
        size = row["tangential_force"]
        assert row["tangential_force"] == pytest.approx(abs(part["circumferential"]), abs=tolerance * size)
        assert row["radial_force"] == pytest.approx(part["radial"], abs=tolerance * size)
        assert row["axial_force"] == pytest.approx(-part["axial"], abs=tolerance * size)


@pytest.mark.parametrize("kind", ["straight", "spiral"])
def test_forces_of_bevel_gears_are_those_of_a_slow_roll(kind: str) -> None:
    """Without motion of the shafts. The contact moves about the pitch point: the mean over a mesh cycle is
    near."""
    text = (HOUSE / f"examples/bevel-drive/{kind}.yaml").read_text()
    text = text.replace("motion: free", "motion: torsion").replace(", friction: {mu: 0.04}", "")
    text = text[: text.index("bearings:")] + text[text.index("bevel_meshes:") :].replace(
        "points: 41", "points: 12"
    )
    model = loads_model(text)
    roll = solve_quasistatic(compile_model(model, "roll"))
    row = flow_of(model, "steady")["links"]["stage"]
    for part in ("radial", "axial"):
        mean = float(roll[f"{part}_force_1[stage]"].mean())
        assert row[f"{part}_force"] == pytest.approx(mean, abs=0.025 * row["tangential_force"])


@pytest.mark.parametrize("text", [SET_FREE, RAVIGNEAUX, PATHS], ids=["planetary", "ravigneaux", "split"])
def test_rows_of_meshes_are_those_of_the_compiled_model(text: str) -> None:
    """The relation of the model file and that of the equations are the same row, but for a factor."""
    model = loads_model(text)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # gears of the split at one position
        system = compile_model(model)
    names = {
        int(body["spin"]): name
        for body, name in zip(system.program["body"], system.layout.bodies, strict=True)
    }
    compiled = {
        system.names[path.kind][path.number]: {names[s]: value for s, value in path.row.items()}
        for path in torque_paths(system)
        if path.kind in ("gear_mesh",)
    }
    machine: Any = model
    turning = [name for name, seat in model.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    for link in links_of(machine):
        row = relation(machine, place, link)
        own = {turning[k]: float(row[k]) for k in range(len(row)) if abs(row[k]) > 1e-12}
        other = compiled[str(link[0][1])]
        assert own.keys() == other.keys()
        factors = [other[name] / value for name, value in own.items()]
        assert factors == pytest.approx([factors[0]] * len(factors), rel=EXACT)
