# SPDX-License-Identifier: Apache-2.0
"""Units for co-simulation, loaded without Python on their side: the bits of our own run, states, refusals."""

from __future__ import annotations

import ctypes as ct
import dataclasses
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.sampled_control import begin_anew
from pitchpoint.solvers.stepper import Stepper
from pitchpoint.system import evaluate
from tests.support.fmi_host import Unit
from tests.support.fmu_models import DRIVEN, need_linker, own_run, own_start, pair, unit_of
from tests.support.mechanism_files import SLIDER_CRANK
from tests.unit.solvers.test_extrapolated_loads import model as gust_model
from tests.unit.solvers.test_missing_teeth import SPUR, TEXT

H = 1e-5
BACKLASH = "meshes.stage.backlash.normal"
DISTANCE = "meshes.stage.center_distance"


@pytest.fixture(scope="module")
def units(tmp_path_factory):
    """Unpacked units by method and version of FMI."""
    need_linker()
    folder = tmp_path_factory.mktemp("units")
    cases = (("adams", 3, BACKLASH), ("generalized_alpha", 2))
    return {
        case[:2]: Unit(unit_of(case[0], folder, case[1], *case[2:]), folder / f"{case[0]}{case[1]}")
        for case in cases
    }


@pytest.fixture
def unit(units):
    """The unit with the Adams method and FMI 3.0."""
    return units["adams", 3]


def same_bits(a, b):
    """Whether two arrays have the same bits."""
    return np.array_equal(np.asarray(a).view(np.int64), np.asarray(b).view(np.int64))


@pytest.mark.parametrize("case", [("adams", 3), ("generalized_alpha", 2)])
def test_channels_have_the_bits_of_our_own_run(units, case):
    """2000 steps with loss of contact and impacts, in communication steps of four time steps."""
    unit = units[case]
    own = own_run(case[0])
    want = own.advance(2000, every=4)
    assert want.rows[:, 1 + unit.names("output").index("contact_state[stage]")].min() < 1.0
    one = unit.instance().initialise()
    got = one.steps(0, 500, 4 * H, unit.references("output"))
    assert unit.names("output") == [c.name for c in own.system.layout.channels]
    assert same_bits(got, want.rows[:, 1:])
    one.free()


def test_jumps_of_a_load(unit):
    """As a controller of our own run changes a load: the method restarts at every jump."""
    own = own_run("adams")
    bank = own.system.records["torque"]
    one = unit.instance().initialise()
    for k in range(30):
        load = 150.0 * (1.0 + 0.5 * np.sin(0.7 * k))
        bank["value"][0] = load
        if k:
            begin_anew(own)
        want = own.advance(7, every=1).rows[-1, 1:]
        assert one.set({"loads.input.torque": load}) == 0
        assert one.step(k * 7 * H, 7 * H) == 0
        assert same_bits(one.get(unit.references("output")), want)
    one.free()


@pytest.mark.parametrize("case", [("adams", 3), ("generalized_alpha", 2)])
def test_a_communication_step_that_is_no_multiple_shortens_the_time_step(units, case):
    unit, own, t = units[case], own_run(case[0]), 0.0
    one = unit.instance().initialise()
    for size, n in ((5e-5, 5), (3.3e-5, 4), (3.3e-5, 4), (5e-5, 5)):
        if abs(size / n - own.h) > 1e-9 * own.h:
            own.change_step(size / n)
        own.advance(n - 1)
        want = own.advance(1, every=1).rows[-1, 1:]
        assert one.step(t, size) == 0
        t += size
        assert same_bits(one.get(unit.references("output")), want)
    one.free()


@pytest.mark.parametrize("name", ["driven", "loop"])
def test_constraints_allow_any_communication_step(name, tmp_path):
    """Time steps that change with every communication step: errors as those of our own run.

    The unit rescales its history, and the deviation of the rates along the rows by the square of the step;
    our own run starts anew, with derivatives of the accelerations. Reference: it with a 25th of the step.
    """
    need_linker()
    swing = "main: {speed: {spin: 20 rad/s}, type"
    times = "scenarios: {steady: {start: assembled, duration: 0.1 s, step: 50 us, method: adams}}"
    text = {"driven": DRIVEN, "loop": SLIDER_CRANK.replace("main: {type", swing) + times}[name]
    model = loads_model(text.replace("method: adams", "method: generalized_alpha"), False, f"{name}.yaml")
    unit = Unit(unit_of(name, tmp_path, 3, model=model), tmp_path)
    one, t, rows = unit.instance().initialise(), 0.0, []
    steppers = [Stepper(model.replace("scenarios.steady.step", h), "steady") for h in (5e-5, 2e-6)]
    for k in range(40):
        size = (1e-4, 3.3e-4, 2.7e-5, 5e-4)[k % 4]
        assert one.step(t, size) == 0, unit.messages
        t += size
        for each in steppers:
            each.advance(size)
        rows.append([one.get(unit.references("output")), *(list(s.outputs().values()) for s in steppers)])
    got, own, exact = np.moveaxis(np.array(rows), 1, 0)
    size = np.abs(exact).max(axis=0)
    errors, room = (np.abs(x - exact).max(axis=0) for x in (got, own))
    assert np.all(errors <= 5.0 * room + 1e-12 * size) and np.all(room <= 2e-4 * size)
    one.free()


def test_a_parameter_acts_as_in_the_model_file(unit):
    """Twice the backlash, set in the initialisation: the unit starts in the equilibrium of this backlash."""
    want = own_run("adams", pair("adams").replace(BACKLASH, 2e-4)).advance(1000, every=10).rows[:, 1:]
    one = unit.instance().initialise(**{BACKLASH: 2e-4})
    got = one.steps(0, 100, 10 * H, unit.references("output"))
    np.testing.assert_allclose(got, want, rtol=1e-6, atol=1e-9 * np.abs(want).max(axis=0).max())
    other = unit.instance().initialise()
    assert other.set({BACKLASH: 2e-4}) == 0  # later: with a transient
    late = other.steps(0, 100, 10 * H, unit.references("output"))
    assert np.abs(late - want).max() > 1e3 * np.abs(got - want).max()
    assert unit.messages == [] and one.set({"rate[driver.spin]": 1.0}) == 3
    assert unit.messages[-1].startswith("coordinates and rates can be set before")
    one.free()
    other.free()


@pytest.fixture(scope="module")
def helical(tmp_path_factory):
    """The pair of 12 degrees of freedom with a balancing torque: its model and unit."""
    need_linker()
    file = Path(__file__).parents[4] / "benchmarks" / "pair_12dof.yaml"
    model = load_model(str(file)).replace_all({DISTANCE: 0.1319985, "scenarios.steady.method": "adams"})
    folder = tmp_path_factory.mktemp("helical")
    parameters = [BACKLASH, DISTANCE, "bearings.input_bearing.stiffness.radial"]
    return model, Unit(unit_of("helical", folder, 3, *parameters, model=model), folder)


@pytest.mark.parametrize(
    "values",
    [
        {"loads.drive.torque": 300.0},
        {"loads.drive.torque": -50.0, DISTANCE: 0.1321},  # the other flank
        {BACKLASH: 2e-4, DISTANCE: 0.1319},
        {"bearings.input_bearing.stiffness.radial": 2.5e8, "loads.drive.torque": 10.0},
    ],
)
def test_the_start_is_the_equilibrium_of_the_values_set_before(helical, values):
    """Contact, bearings and balancing torque as in a model file with these values."""
    model, unit = helical
    start = own_start("adams", model.replace_all(values))
    evaluate.load(start.system, start.state)
    assert evaluate.accelerations(start.system, 0.0) == 1
    want = evaluate.observe(start.system, evaluate.store(start.system, 0.0))
    one = unit.instance().initialise(**values)
    got = one.get(unit.references("output"))
    units = np.array([channel.unit for channel in start.system.layout.channels])
    for each in set(units):
        room = 1e-9 * np.abs(want[units == each]).max()
        np.testing.assert_allclose(got[units == each], want[units == each], rtol=0, atol=room)
    balanced = one.get([int(unit.variables["loads.brake.torque"].get("valueReference"))])
    assert balanced == pytest.approx(want[unit.names("output").index("torque[brake]")], rel=1e-9)
    one.free()


def test_two_parameters_of_one_number_add_and_ranges_hold(helical):
    """Backlash and centre distance change the same numbers of the mesh; the order does not matter."""
    _, unit = helical
    ends = []
    for order in ((BACKLASH, DISTANCE), (DISTANCE, BACKLASH)):
        one = unit.instance().initialise(
            **{name: {BACKLASH: 1.5e-4, DISTANCE: 0.1321}[name] for name in order}
        )
        ends.append(one.steps(0, 5, 5e-5, unit.references("output")))
        one.free()
    assert same_bits(*ends)
    limits = unit.variables[DISTANCE]
    assert float(limits.get("max")) - float(limits.get("min")) == pytest.approx(0.004 * 0.1319985)
    one = unit.instance().initialise()
    assert one.set({DISTANCE: 0.14}) == 3 and "0.14 is above 0.132" in unit.messages[-1]
    one.free()


def test_directional_derivatives_at_a_limit_of_a_parameter(helical):
    """One-sided at the limit, against a difference from outside; zero for opposite changes of one number."""
    _, unit = helical
    limits = unit.variables[DISTANCE]
    most, distance = float(limits.get("max")), [int(limits.get("valueReference"))]
    slopes = [int(v.get("valueReference")) for name, v in unit.variables.items() if name.startswith("der(r")]
    one = unit.instance(exchange=True).initialise(**{DISTANCE: most})
    got = one.directional(slopes, distance, [1.0])
    np.testing.assert_array_equal(one.directional(slopes, 2 * distance, [1.0, -1.0]), 0.0)
    at, step = one.get(slopes), 1e-6
    assert one.set({DISTANCE: most - step}) == 0
    want = (at - one.get(slopes)) / step
    np.testing.assert_allclose(got, want, rtol=0, atol=1e-4 * np.abs(want).max())
    one.free()


def test_instants_without_an_equilibrium_are_skipped_with_a_message(tmp_path):
    """The balancing torque is the mean of the others, as in our own start; flank friction needs the mean."""
    need_linker()
    text = TEXT.format(**SPUR, law="din3990").replace("tooth: 4", "tooth: 20")
    text = text.replace("begin: {start: assembled,", "steady: {method: adams,")
    model = loads_model(text.replace("{law: din3990}", "{law: din3990}, friction: {mu: 0.05, v_eps: 1 mm/s}"))
    unit = Unit(unit_of("adams", tmp_path, 3, model=model), tmp_path)
    start = own_start("adams", model.replace("loads.brake.torque", 210.0))
    own = start.system
    missing = 16 * (2.0 - model.pairs["stage"].eps_alpha)  # only the missing tooth would carry
    (note,) = start.notes
    assert note.startswith(f"the balancing torques are means without {round(missing)} of 16 instants")
    one = unit.instance()
    no, zero = ct.c_bool(False), ct.c_double(0.0)
    assert one.call("EnterInitializationMode", no, zero, zero, no, zero) == 0
    assert one.set({"loads.brake.torque": 210.0}) == 0
    assert one.call("ExitInitializationMode") == 1
    assert "balancing torques are means without the instants that have no equilibrium" in unit.messages[-1]
    torque = one.get([int(unit.variables["loads.motor.torque"].get("valueReference"))])
    want = own.records["torque"]["value"][own.names["torque"].index("motor")]
    assert torque == pytest.approx(want, rel=1e-9)
    one.free()


@pytest.mark.parametrize("case", [("adams", 3), ("generalized_alpha", 2)])
def test_a_state_can_be_restored_here_and_elsewhere(units, case):
    unit = units[case]
    references = unit.references("output")
    one = unit.instance().initialise()
    one.steps(0, 50, 4 * H, references)
    state = one.keep()
    data = one.serialise(state)
    want = one.steps(50, 50, 4 * H, references)
    one.set({"loads.input.torque": 200.0})
    assert not same_bits(one.steps(100, 5, 4 * H, references), want[:5])
    assert one.restore(state) == 0
    assert same_bits(one.steps(50, 50, 4 * H, references), want)
    one.drop(state)
    one.free()
    other = unit.instance().initialise()
    status, copy = other.deserialise(data)
    assert status == 0 and other.restore(copy) == 0
    assert same_bits(other.steps(50, 50, 4 * H, references), want)
    other.drop(copy)
    assert other.deserialise(b"x" * 30 + data[30:])[0] == 3 and "another FMU" in unit.messages[-1]
    assert other.deserialise(data[:-1])[0] == 3 and "number is wrong" in unit.messages[-1]
    other.free()


@pytest.mark.parametrize("case", [("adams", 3), ("generalized_alpha", 2)])
def test_the_state_of_another_unit_is_refused(units, case):
    unit, another = units[case], next(u for key, u in units.items() if key != case)
    one, other = unit.instance().initialise(), another.instance().initialise()
    want = one.steps(0, 3, H, unit.references("output"))
    state = other.keep()
    one.call("Reset")
    one.initialise()
    assert one.restore(state) == 3 and unit.messages[-1] == "this state is that of another FMU"
    assert same_bits(one.steps(0, 3, H, unit.references("output")), want)
    other.drop(state)
    for each in (one, other):
        each.free()


@pytest.mark.study
def test_extrapolated_loads_of_blades_are_part_of_the_state(tmp_path_factory):
    """Rotor in a gust with `step`: the bits of our own run, also after a state is restored."""
    need_linker()
    model = gust_model("step: 20 ms").replace("loads.torque.torque", -2.0e6)
    model = dataclasses.replace(model, scenarios={"steady": model.scenarios["gust"]})
    folder = tmp_path_factory.mktemp("rotor")
    unit = Unit(unit_of("generalized_alpha", folder, 3, model=model), folder / "unit")
    references = unit.references("output")
    h = model.scenarios["steady"].step
    want = own_run("generalized_alpha", model).advance(100, every=1)
    one = unit.instance().initialise()
    assert same_bits(one.steps(0, 30, h, references), want.rows[:30, 1:])
    state = one.keep()
    assert same_bits(one.steps(30, 70, h, references), want.rows[30:, 1:])
    assert one.restore(state) == 0
    assert same_bits(one.steps(30, 70, h, references), want.rows[30:, 1:])
    one.drop(state)
    one.free()


def test_a_hundred_instances_do_not_disturb_each_other(unit):
    references = unit.references("output")
    many = [unit.instance().initialise(**{"loads.input.torque": 150.0 + k}) for k in range(100)]
    for k in range(20):
        assert all(one.step(k * 4 * H, 4 * H) == 0 for one in many)
    for k in (0, 57, 99):
        alone = unit.instance().initialise(**{"loads.input.torque": 150.0 + k})
        assert same_bits(alone.steps(0, 20, 4 * H, references)[-1], many[k].get(references))
        alone.free()
    for one in many:
        one.free()


def test_instances_run_in_threads(unit):
    """ctypes calls the library without the lock of the interpreter, so that four instances run at once."""
    references = unit.references("output")

    def values(load):
        """Outputs of an instance of its own after 4000 steps."""
        one = unit.instance().initialise(**{"loads.input.torque": load})
        for k in range(40):
            assert one.step(k * 100 * H, 100 * H) == 0
        found = one.get(references)
        one.free()
        return found

    loads = [150.0, 160.0, 170.0, 180.0]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(values, loads))
    assert all(same_bits(a, values(load)) for a, load in zip(together, loads, strict=True))


def test_a_reset_instance_starts_again(unit):
    one = unit.instance().initialise()
    want = one.steps(0, 20, H, unit.references("output"))
    assert one.call("Reset") == 0
    assert same_bits(one.initialise().steps(0, 20, H, unit.references("output")), want)
    one.free()


@pytest.mark.parametrize("case", [("adams", 3), ("generalized_alpha", 2)])
def test_wrong_calls_are_refused_with_a_sentence(units, case):
    unit = units[case]
    assert unit.instance(token="{no}") is None and "is not that of this library" in unit.messages[-1]
    one = unit.instance().initialise()
    for value in (np.nan, np.inf):
        assert one.set({"loads.input.torque": value}) == 3 and "not finite" in unit.messages[-1]
    assert one.set({"speed[driver]": 1.0}) == 3 and "neither an input" in unit.messages[-1]
    numbers = {99.0: "99", -1.25e-7: "-1.25e-7", 0.0125: "0.0125", 123456.7: "123457", 2e120: "infinite"}
    for t, shown in numbers.items():
        words = f"the communication point {shown}"
        assert one.step(t, H) == 3 and unit.messages[-1].startswith(words), unit.messages[-1]
        assert unit.messages[-1].endswith(" s is not the time of the model, 0 s")
    assert one.step(0.0, -H) == 3 and "must be positive" in unit.messages[-1]
    assert one.step(0.0, 4 * H) == 0  # none of these has changed the instance
    one.free()


@pytest.mark.parametrize("case", [("adams", 3), ("generalized_alpha", 2)])
def test_calls_in_a_wrong_order_are_refused(units, case):
    unit = units[case]
    zero, yes = ct.c_double(0.0), ct.c_int(1)
    begin = ["SetupExperiment"] if unit.version == 2 else ["EnterInitializationMode"]
    one = unit.instance()
    for name in ("ExitInitializationMode", "Terminate"):
        assert one.call(name) == 3 and "initialis" in unit.messages[-1]
    assert one.step(0.0, H) == 3 and "initialisation has not ended" in unit.messages[-1]
    assert one.call(*begin, yes, zero, ct.c_double(1.0), yes, ct.c_double(0.5)) == 3
    assert "stop time is before the start time" in unit.messages[-1]
    one.initialise()
    state = one.keep()
    assert one.call("ExitInitializationMode") == 3 and "ended before" in unit.messages[-1]
    assert one.call(*begin, yes, zero, zero, ct.c_int(0), zero) == 3 and "reset" in unit.messages[-1]
    want = one.steps(0, 3, H, unit.references("output"))
    assert one.call("Terminate") == 0 and one.call("Terminate") == 3
    assert one.step(3 * H, H) == 3 and "is terminated" in unit.messages[-1]
    assert one.call("Reset") == 0 and one.restore(state) == 0  # the phase is part of a state
    assert same_bits(one.steps(0, 3, H, unit.references("output")), want)
    one.drop(state)
    one.free()


def test_a_run_that_fails_says_why_and_can_be_reset(unit):
    one, t, status = unit.instance().initialise(), 0.0, 0
    assert one.set({"loads.input.torque": 1e90}) == 0
    while not status and t < 1.0:
        status, t = one.step(t, 100 * H), t + 100 * H
    assert status == 3
    assert unit.messages[-1].startswith("the run failed: ") and "shorter time step" in unit.messages[-1]
    assert one.step(t, H) == 3 and "has failed before" in unit.messages[-1]
    assert one.call("Reset") == 0 and one.initialise().step(0.0, H) == 0
    one.free()


def test_a_stepper_has_the_bits_of_the_unit(unit):
    """The same calls: loads that jump, and communication steps that are no multiples of the time step."""
    one, stepper, t = unit.instance().initialise(), Stepper(pair("adams"), "steady"), 0.0
    for k in range(40):
        load, size = 150.0 + 100.0 * np.sin(0.5 * k), (4e-5, 3.3e-5)[k // 3 % 2]
        stepper.set({"loads.input.torque": load})
        stepper.advance(size)
        assert one.set({"loads.input.torque": load}) == 0 and one.step(t, size) == 0
        t += size
        assert same_bits(one.get(unit.references("output")), list(stepper.outputs().values()))
    one.free()


def test_the_library_needs_no_python(units):
    for unit in units.values():
        data = unit.library.read_bytes()
        for name in (b"libpython", b"NRT_", b"PyErr", b"numba"):
            assert name not in data
        assert len(data) < 300_000


def test_drives_blocks_and_a_set_point(tmp_path):
    """A prescribed speed, and a controller of blocks, whose speed follows the closed form of its loop."""
    need_linker()
    model = loads_model(DRIVEN, False, "driven.yaml")
    gain, target = "blocks.wanted.proportional", "blocks.error.offset"
    unit = Unit(unit_of("driven", tmp_path, 3, gain, model=model, inputs=[target]), tmp_path)
    one = unit.instance().initialise(**{gain: 1.0, target: 100.0})
    reference = [
        unit.references("output")[unit.names("output").index(n)] for n in ("speed[motor]", "speed[fan]")
    ]
    rows = one.steps(0, 100, 1e-3, reference)
    assert rows[:, 0] == pytest.approx(1000.0 * np.pi / 30.0, rel=1e-9)
    # J w'' + P w' + I w = I target + P target', from rest: w = target (1 - combination of two exponentials)
    t, inertia = 1e-3 * np.arange(1, 101), 0.02
    a, b = np.roots([inertia, 1.0, 2.0])
    rise = 1.0 / inertia  # w'(0) / target
    first, second = (rise + b) / (a - b), -(rise + a) / (a - b)
    np.testing.assert_allclose(
        rows[:, 1], 100.0 * (1.0 + first * np.exp(a * t) + second * np.exp(b * t)), rtol=1e-6
    )
    one.free()


def test_a_table_of_speeds_belongs_to_its_time(tmp_path):
    need_linker()
    table = "{table: [[0 s, 1000 rpm], [0.1 s, 1100 rpm]]}"
    model = loads_model(DRIVEN.replace("speed: 1000 rpm", f"speed: {table}"), False, "driven.yaml")
    unit = Unit(unit_of("table", tmp_path, 3, model=model), tmp_path)
    assert unit.names("input") == ["loads.brake.torque"]
    one = unit.instance()
    with pytest.raises(AssertionError):
        one.initialise(start=5.0)
    assert "drives prescribe positions" in unit.messages[-1]
    one.free()


@pytest.mark.parametrize("method", ["adams", "generalized_alpha"])
def test_the_speed_of_a_drive_is_an_input(method, tmp_path):
    """It varies linearly within a communication step: angle, speed and torque follow from its polygon."""
    need_linker()
    model = loads_model(DRIVEN.replace("method: adams", f"method: {method}"), False, "driven.yaml")
    unit = Unit(unit_of("driven", tmp_path, 3, model=model), tmp_path)
    one, stepper = unit.instance().initialise(start=2.0), Stepper(model, "steady")
    start, H = 1000.0 * np.pi / 30.0, 1e-3
    speeds = start + 20.0 * np.sin(0.3 * np.arange(101))
    names = ["angle[motor]", "speed[motor]", "torque[motor]", "coupling_force[shaft.mz]"]
    places = [unit.names("output").index(name) for name in names]
    rows = []
    for k, speed in enumerate(speeds[1:]):
        assert one.set({"drive.motor.speed": speed}) == 0
        stepper.set({"drive.motor.speed": speed})
        assert one.step(2.0 + k * H, H) == 0, unit.messages
        stepper.advance(H)
        found = one.get(unit.references("output"))
        own = np.array(list(stepper.outputs().values()))
        # the time is another one, and generalised-alpha of the unit restarts without derivatives (0052)
        room = (1e-9 if method == "adams" else 1e-5) * np.abs(own).max()
        np.testing.assert_allclose(found, own, rtol=0, atol=room)
        rows.append(found[places])
    angle, speed, torque, coupling = np.array(rows).T
    gain = np.diff(speeds) / H
    np.testing.assert_allclose(speed, speeds[1:], rtol=1e-9)
    np.testing.assert_allclose(angle, H * np.cumsum(0.5 * (speeds[1:] + speeds[:-1])), rtol=1e-9)
    np.testing.assert_allclose(torque, 0.02 * gain - coupling, rtol=0, atol=1e-6 * np.abs(torque).max())
    one.free()
