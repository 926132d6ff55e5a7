# SPDX-License-Identifier: Apache-2.0
"""Co-simulation from Python: bits of our own run, closed forms, order, saved states, failures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.status import CONTROLLER, UNBOUNDED
from tests.support.controlled_rotors import controlled, rotor
from tests.support.fmu_models import DRIVEN, pair
from tests.support.fmu_models import own_run as begun

LOOP = rotor(
    "motor: {body: rotor, torque: 0 N m}, brake: {body: rotor, torque: -30 N m}",
    'duration: 1 s, step: 1 ms, channels: ["speed[*]"]',
    speed=0.0,
)
SAMPLED = controlled(
    'type: python, function: "law.py:law", inputs: [speed], outputs: [wanted], period: 3 ms, delay: 1 ms, '
    "unit: N m"
)
LAW = """
def law(t, inputs, state, parameters):
    state["sum"] = state.get("sum", 0.0) + 0.1 * (10.0 - inputs[0])
    if inputs[0] > 1e3:
        raise ValueError("too fast")
    return 20.0 * (10.0 - inputs[0]) + state["sum"]
"""


def same_bits(a, b):
    """Whether two arrays have the same bits."""
    return np.array_equal(np.asarray(a).view(np.int64), np.asarray(b).view(np.int64))


def go_on(stepper, n, step):
    """Take n communication steps."""
    for _ in range(n):
        stepper.advance(step)


def loop():
    """Rotor of 2 kg m^2 whose motor torque is given from outside."""
    return pp.load_model(text=LOOP)


@pytest.fixture
def sampled(tmp_path):
    """The same with a controller in Python."""
    (tmp_path / "law.py").write_text(LAW)
    (tmp_path / "model.yaml").write_text(LOOP + SAMPLED)
    return pp.load_model(tmp_path / "model.yaml", allow_code=True)


@pytest.mark.parametrize("method", ["adams", "rk4", "generalized_alpha"])
def test_constant_inputs_give_the_bits_of_a_run(method):
    """2000 steps with loss of contact, read at every fourth."""
    model = pair(method)
    want = pp.solve_time(pp.compile_model(model.replace("scenarios.steady.sample_rate", 25e3), "steady"))
    stepper = pp.Stepper(model, "steady")
    for k in range(500):
        stepper.advance(4e-5)
        assert stepper.value("speed[driver]") == float(want["speed[driver]"][k + 1])
    got = stepper.dataset()
    assert want["contact_state[stage]"].min() < 1.0
    assert list(got.data_vars) == list(want.data_vars)
    assert all(same_bits(got[name], want[name]) for name in [*want.data_vars, "time"])
    assert {name: array.attrs["units"] for name, array in got.items()} == {
        name: stepper.units[name] for name in got.data_vars
    }


@pytest.mark.parametrize("method", ["adams", "generalized_alpha"])
def test_a_saved_state_continues_with_the_same_bits(method):
    """Inputs, time step and failures of the other branch leave no trace."""
    stepper = pp.Stepper(pair(method), "steady")
    load = "loads.input.torque"

    def branch():
        """Channels after each of 60 communication steps with a changing load."""
        found = []
        for k in range(60):
            stepper.set({load: 150.0 + 20.0 * np.sin(0.3 * k)})
            stepper.advance(4e-5)
            found.append(list(stepper.outputs().values()))
        return found

    first = stepper.save()
    begin = branch()
    middle = stepper.save()
    want = branch()
    stepper.set({load: 900.0})
    stepper.outputs()
    stepper.advance(3.3e-5)
    stepper.restore(middle)
    assert same_bits(branch(), want) and len(stepper.dataset()["time"]) == 121
    stepper.set({load: 1e90})
    with pytest.raises(pp.SolverError):
        stepper.advance(0.03)
    with pytest.raises(pp.SolverError, match="restore a state"):
        stepper.advance(1e-5)
    stepper.restore(middle)
    assert same_bits(branch(), want)
    stepper.restore(first)
    assert stepper.t == 0.0 and stepper.inputs[load] == 150.0 and same_bits(branch(), begin)
    with pytest.raises(pp.ModelError, match="another stepper"):
        pp.Stepper(pair(method), "steady").restore(first)


def test_jumps_of_an_input_as_in_our_own_run():
    """The method restarts at every jump, and reading outputs in between changes nothing."""
    from pitchpoint.solvers.sampled_control import begin_anew

    own, stepper = begun("adams"), pp.Stepper(pair("adams"), "steady")
    for k in range(30):
        load = 150.0 * (1.0 + 0.5 * np.sin(0.7 * k))
        own.system.records["torque"]["value"][0] = load
        if k:
            begin_anew(own)
        want = own.advance(7, every=1).rows[-1, 1:]
        stepper.set({"loads.input.torque": load})
        stepper.outputs()
        stepper.advance(7e-5)
        assert same_bits(list(stepper.outputs().values()), want)


def control(period, target=10.0, gain=40.0, reset=300.0, duration=0.6):
    """Speeds of the rotor with a PI law outside, at multiples of the period, and the sampled closed form.

    Rotor and law are linear: w' = w + h (u - 30 N m) / J, with u constant in a step.
    """
    stepper, integral, w = pp.Stepper(loop(), "run"), 0.0, 0.0
    sampled = [0.0]
    for _ in range(round(duration / period)):
        error = target - stepper.value("speed[rotor]")
        stepper.set({"loads.motor.torque": gain * error + integral})
        stepper.advance(period)
        torque = gain * (target - w) + integral
        integral += reset * period * error
        w += period * (torque - 30.0) / 2.0
        sampled.append(w)
    data = stepper.dataset()
    return data["time"].values, data["speed[rotor]"].values, np.array(sampled)


def closed_form(t, target=10.0, gain=40.0, reset=300.0, inertia=2.0):
    """Speed of a rotor from rest with a continuous PI law: inertia w'' + gain w' + reset w = reset target."""
    a, b = np.roots([inertia, gain, reset])
    slope = (gain * target - 30.0) / inertia
    first = (slope + target * b) / (a - b)
    return target + first * np.exp(a * t) - (first + target) * np.exp(b * t)


def test_a_pi_law_outside_follows_its_closed_form_to_first_order():
    errors = []
    for period in (8e-3, 4e-3, 2e-3, 1e-3):
        t, speed, sampled = control(period)
        np.testing.assert_allclose(speed, sampled, rtol=1e-11, atol=1e-12)
        errors.append(np.abs(speed - closed_form(t)).max())
    ratios = np.divide(errors[:-1], errors[1:])
    np.testing.assert_allclose(ratios, 2.0, rtol=0.1)
    assert abs(ratios[-1] - 2.0) < abs(ratios[0] - 2.0) and errors[-1] < 0.06


def test_a_set_point_of_the_model_file_is_an_input():
    """A controller of blocks inside; 100 rad/s given from outside acts as in the model file."""
    target = "blocks.error.offset"
    model = pp.load_model(text=DRIVEN)
    stepper = pp.Stepper(model, "steady", inputs=[target])
    assert stepper.units[target] and stepper.inputs[target] == 0.0
    other = pp.Stepper(model.replace(target, 100.0), "steady")
    for one in (stepper, other):
        assert one.value("speed[fan]") == 0.0
        one.set({name: 100.0 for name in one.inputs if name == target})
        go_on(one, 20, 2e-3)
    assert stepper.value("speed[fan]") == pytest.approx(other.value("speed[fan]"), rel=1e-12)
    assert stepper.value("speed[fan]") > 30.0


def test_an_input_has_a_range_where_its_effect_is_not_affine():
    """The words of a centre distance are polynomials, valid near the value of the file."""
    name = "meshes.stage.center_distance"
    stepper = pp.Stepper(pair("adams"), "steady", inputs=[name])
    start = stepper.inputs[name]
    with pytest.raises(pp.ModelError, match=rf"{name}: 0.1545 m is out of range .*0.1\d* to 0.1\d*"):
        stepper.set({name: 1.03 * start, "loads.input.torque": 1.0})
    assert stepper.inputs[name] == start and stepper.inputs["loads.input.torque"] == 150.0
    stepper.set({name: 1.001 * start})
    assert stepper.inputs[name] == 1.001 * start
    ratio = "meshes.stage.damper.ratio"  # affine, within the limits of the model file
    with pytest.raises(pp.ModelError, match=rf"{ratio}: -0.01 1 is out of range \(limit 0 to 10\)"):
        pp.Stepper(pair("adams"), "steady", inputs=[ratio]).set({ratio: -0.01})


def test_the_speed_of_a_drive_is_an_input():
    """Linear in a communication step: the angle is the area; a table of speeds ends with the scenario."""
    stepper = pp.Stepper(pp.load_model(text=DRIVEN), "steady")
    first = stepper.inputs["drive.motor.speed"]
    stepper.advance(0.15)  # constant speeds have no end
    angle = stepper.value("angle[motor]")
    assert angle == pytest.approx(0.15 * first, rel=1e-9)
    stepper.set({"drive.motor.speed": first + 8.0})
    state = stepper.save()
    ends = []
    for _ in range(2):
        stepper.restore(state)
        stepper.advance(0.02)
        assert stepper.value("angle[motor]") - angle == pytest.approx(0.02 * (first + 4.0), rel=1e-8)
        stepper.advance(0.01)  # it keeps the speed
        assert stepper.value("speed[motor]") == pytest.approx(first + 8.0, rel=1e-9)
        ends.append(list(stepper.outputs().values()))
    assert same_bits(*ends)
    table = DRIVEN.replace("speed: 1000 rpm", "speed: {table: [[0 s, 1000 rpm], [0.1 s, 1100 rpm]]}")
    stepper = pp.Stepper(pp.load_model(text=table), "steady")
    assert list(stepper.inputs) == ["loads.brake.torque"]
    with pytest.raises(pp.ModelError, match="drives are defined"):
        stepper.advance(0.11)


def test_a_hundred_steppers_do_not_disturb_each_other():
    model = pair("adams")
    many = [pp.Stepper(model, "steady") for _ in range(100)]
    for k, one in enumerate(many):
        one.set({"loads.input.torque": 150.0 + k})
    for _ in range(20):
        for one in many:
            one.advance(4e-5)
    for k in (0, 57, 99):
        alone = pp.Stepper(model, "steady")
        alone.set({"loads.input.torque": 150.0 + k})
        go_on(alone, 20, 4e-5)
        assert alone.outputs() == many[k].outputs()


def test_controllers_in_python_are_called_at_their_instants(sampled):
    """Period, delay and private state as in a run, also after a restored state."""
    data = pp.solve_time(pp.compile_model(sampled.replace("scenarios.run.sample_rate", 200.0), "run"))
    stepper = pp.Stepper(sampled, "run")
    for k in range(200):
        if k == 71:
            saved = stepper.save()
            stepper.set({"loads.motor.torque": 50.0})
            go_on(stepper, 10, 5e-3)
            stepper.restore(saved)
        stepper.advance(5e-3)
    assert same_bits(stepper.dataset()["speed[rotor]"], data["speed[rotor]"])
    with pytest.raises(pp.ModelError, match="multiples of 0.001 s"):
        stepper.advance(1.5e-3)


def test_a_failed_controller_is_named_and_the_result_kept(sampled):
    stepper = pp.Stepper(sampled, "run")
    stepper.set({"loads.motor.torque": 1e6})
    with pytest.raises(pp.SolverError, match=r"controllers.control .*raised ValueError: too fast") as failure:
        go_on(stepper, 10, 1e-3)
    assert failure.value.status == CONTROLLER
    assert list(failure.value.partial["time"]) == pytest.approx([0.0, 1e-3, 2e-3, 3e-3])


def test_a_run_that_fails_says_why():
    stepper = pp.Stepper(pair("adams"), "steady")
    stepper.advance(1e-4)
    stepper.set({"loads.input.torque": 1e90})
    with pytest.raises(pp.SolverError, match="grew without bound") as failure:
        stepper.advance(1e-3)
    assert failure.value.status == UNBOUNDED and len(failure.value.partial["time"]) == 2


def test_events_are_recorded_and_forgotten_with_a_restored_state():
    model = pair("adams").replace("scenarios.steady.events", ["contact"])
    stepper = pp.Stepper(model, "steady")
    run = pp.solve_time(pp.compile_model(model, "steady"))
    start = stepper.save()
    for _ in range(2):
        go_on(stepper, 100, 2e-4)
        assert [t for t, _, _ in stepper.events] == list(run["event_time"].values)
        stepper.restore(start)
    assert len(run["event_time"]) > 2 and not stepper.events


def test_what_is_impossible_is_refused_with_a_sentence():
    with pytest.raises(pp.ModelError, match=r"scenarios.run.method: runge_kutta has variable steps"):
        pp.Stepper(loop().replace("scenarios.run.method", "runge_kutta"), "run")
    stepper = pp.Stepper(loop(), "run", record=False)
    with pytest.raises(pp.ModelError) as found:
        stepper.set({"loads.moter.torque": 1.0, "loads.brake.torque": np.nan, "loads.motor.torque": 5.0})
    assert len(found.value.problems) == 2 and "did you mean loads.motor.torque" in str(found.value)
    assert stepper.inputs["loads.motor.torque"] == 0.0
    for step in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(pp.ModelError, match="out of range"):
            stepper.advance(step)
    with pytest.raises(pp.ModelError, match="is not an output"):
        stepper.value("speed[roter]")
    stepper.advance(1e-2)
    assert stepper.dataset().sizes["time"] == 0 and stepper.t == 1e-2


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda s: s.restore(None), "state: None is not a saved state; use a state from `save`"),
        (
            lambda s: s.set({"loads.motor.torque": "200 N m"}),
            "loads.motor.torque: '200 N m' is not a number; write the number in N m",
        ),
        (lambda s: s.set({"loads.motor.torque": None}), "loads.motor.torque: None is not a number"),
        (lambda s: s.set([1]), r"values: \[1\] are not a mapping of names to numbers"),
        (lambda s: s.advance("1 ms"), "communication step: '1 ms' is not a number; write the number in s"),
        (lambda s: s.advance(None), "communication step: None is not a number"),
        (lambda s: pp.Stepper("pair.yaml", "run"), "model: 'pair.yaml' is not a model; .*load_model"),
        (
            lambda s: pp.Stepper(loop(), "run", inputs="loads.motor"),
            r"inputs: 'loads.motor' is a text, not a list of texts; write inputs=\['loads.motor'\]",
        ),
        (
            lambda s: pp.export_fmu(loop(), "no.fmu", "run", platforms=["x"]),
            "platforms: no library can be made for 'x'; ",
        ),
        (lambda s: pp.export_fmu(loop(), "no.fmu", "run", version=1), "version: 1 is not supported"),
        (
            lambda s: pp.export_fmu(loop(), "no.fmu", "run", parameters="meshes.a"),
            "parameters: 'meshes.a' is a text, not a list",
        ),
    ],
)
def test_values_of_a_wrong_type_are_refused_with_a_sentence(call, sentence):
    stepper = pp.Stepper(loop(), "run")
    with pytest.raises(pp.ModelError, match=sentence):
        call(stepper)
    assert stepper.t == 0.0 and stepper.inputs["loads.motor.torque"] == 0.0


def test_a_sweep_is_refused():
    model = pp.load_model(Path(__file__).parents[3] / "examples" / "backlash-oscillator" / "model.yaml")
    sentence = "'sweep' is of the kind sweep, not time; of that kind there are: steady"
    with pytest.raises(pp.ModelError, match=sentence):
        pp.Stepper(model, "sweep")
    with pytest.raises(pp.ModelError, match=sentence):
        pp.export_fmu(model, "no.fmu", "sweep")
