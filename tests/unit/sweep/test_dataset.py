# SPDX-License-Identifier: Apache-2.0
"""Cases of a data set: same bits, stated noise, filtered samples, pulses, failures with a status."""

from __future__ import annotations

import dataclasses
import threading
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core import status as st
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.io.yaml_plan import load_plan
from pitchpoint.model.dataset_plan import DatasetPlan, PlannedCase
from pitchpoint.model.model import Model
from pitchpoint.model.reading.dataset_plan import check_plan
from pitchpoint.sweep.dataset import CaseRecord, compute_case, compute_cases, key_maker, treatment
from tests.support.dataset_files import PLAN, written

STATES = """state: {type: observation, channel: "contact_state[stage]"}
  phase: {type: observation, channel: "mesh_phase[stage]"}"""


def both(folder: Path, text: str = PLAN) -> tuple[DatasetPlan, Model]:
    plan = load_plan(written(folder, text))
    model = load_model(folder / "pair.yaml")
    return check_plan(plan, model, ()), model


@pytest.fixture(scope="module")
def planned(tmp_path_factory: pytest.TempPathFactory) -> tuple[DatasetPlan, Model]:
    return both(tmp_path_factory.mktemp("plan"))


def computed(plan: DatasetPlan, model: Model, case: PlannedCase) -> CaseRecord:
    return compute_case(plan, model, case, key_maker(plan, model)(case))


def test_threads_change_no_bit(planned: tuple[DatasetPlan, Model]) -> None:
    plan, model = planned
    key_of = key_maker(plan, model)
    cases = [(c, key_of(c)) for c in plan.cases()][:4]
    runs = []
    for jobs in (1, 3):
        kept: dict[str, CaseRecord] = {}
        told: list[CaseRecord] = []
        assert compute_cases(
            plan, model, cases, told.append, keep=lambda r, kept=kept: kept.update({r.key: r}), jobs=jobs
        )
        assert sorted(r.case.index for r in told) == [0, 1, 2, 3]
        assert all(not r.channels for r in told)  # samples are not handed on
        runs.append(kept)
    for key, one in runs[0].items():
        other = runs[1][key]
        assert one.numbers == other.numbers
        for name, channel in one.channels.items():
            np.testing.assert_array_equal(channel.values, other.channels[name].values)


def test_seeds_differ_in_noise_and_jitter_and_in_nothing_else(planned: tuple[DatasetPlan, Model]) -> None:
    plan, model = planned
    one, two = (computed(plan, model, c) for c in list(plan.cases())[:2])
    torques = [r.numbers["loads.input.torque"][0] for r in (one, two)]
    assert torques[0] != torques[1]
    assert all(abs(t - 100.0) < 5.0 for t in torques)  # five standard deviations of 1 %
    still = dataclasses.replace(plan, jitter={})
    one, two = (computed(still, model, c) for c in list(plan.cases())[:2])
    np.testing.assert_array_equal(one.channels["clean"].values, two.channels["clean"].values)
    assert np.abs(one.channels["force"].values - two.channels["force"].values).max() > 0.0


def test_noise_is_what_was_asked_for(tmp_path: Path) -> None:
    """rms of 2000 samples of white noise: standard error 1/sqrt(2 n) = 1.6 %, five of them."""
    plan, model = both(tmp_path, PLAN.replace("length: 5 ms", "length: 100 ms"))
    record = computed(plan, model, next(plan.cases()))
    clean, noisy = record.channels["clean"], record.channels["force"]
    assert clean.noise_rms == 0.0
    noise = noisy.values - clean.values
    assert noisy.noise_rms == pytest.approx(clean.values.std() / 10.0, rel=1e-12)  # 20 dB
    assert noise.std() == pytest.approx(noisy.noise_rms, rel=0.08)
    white = np.corrcoef(noise[1:], noise[:-1])[0, 1]
    assert abs(white) < 5.0 / np.sqrt(noise.size)
    assert record.channels["motion"].noise_rms == 0.01


def test_samples_begin_after_the_settling_time(planned: tuple[DatasetPlan, Model]) -> None:
    """Against the same machine run and sampled by itself, through the filter's flat band (ripple 1e-4)."""
    from pitchpoint.solvers.time import solve_time
    from pitchpoint.system.compile import compile_model

    plan, model = planned
    plan = dataclasses.replace(plan, jitter={}, oversampling=8)
    record = computed(plan, model, next(plan.cases()))
    changed = model.replace("loads.input.torque", "100 N m")
    scenario = dataclasses.replace(changed.scenarios["steady"], duration=0.012, sample_rate=20000.0)
    data = solve_time(compile_model(changed, scenario), scenario)
    speed = data["speed[driven]"].values
    first = 40  # settle_time 2 ms at 20 kHz, and the filter needs no more than 26 samples
    wanted = speed[first : first + 100]
    found = record.channels["motion"].values - 0.0
    noise = record.channels["motion"].noise_rms
    assert found.shape == (100,)
    # mesh frequency 1250 Hz and its harmonics up to 8 kHz pass; what is above is stopped in one of the two
    apart = found - wanted
    assert np.abs(apart).max() < 5.0 * noise + 0.02 * np.ptp(speed)


def test_states_and_phases_are_not_filtered(tmp_path: Path) -> None:
    """A rattling pair: the states stay whole, the phase starts again at 1; both are the machine's own."""
    text = PLAN.replace('clean: {type: observation, channel: "mesh_force[stage]"}', STATES)
    plan, model = both(tmp_path, text.replace("[100 N m, 150 N m]", "[1 N m, 2 N m]"))
    plan = dataclasses.replace(plan, jitter={}, length=0.05)
    record = computed(plan, model, next(plan.cases()))
    bare = computed(dataclasses.replace(plan, oversampling=1), model, next(plan.cases()))
    state, phase = (record.channels[n].values for n in ("state", "phase"))
    assert len(set(state.tolist())) > 1
    assert set(state.tolist()) <= {-1.0, 0.0, 1.0, 2.0}
    assert phase.min() >= 0.0
    assert phase.max() < 1.0
    assert np.abs(np.diff(phase)).max() > 0.5  # it starts again within the record
    apart = np.abs(phase - bare.channels["phase"].values)
    # both settle for 40 samples, more than the 26 of the filter: the same instants of the same machine
    assert np.minimum(apart, 1.0 - apart).max() < 1e-9
    np.testing.assert_array_equal(state, bare.channels["state"].values)
    assert "not filtered: state, phase" in treatment(plan)


def test_states_have_no_noise(tmp_path: Path) -> None:
    text = PLAN.replace('channel: "speed[driven]", noise', 'channel: "contact_state[stage]", noise')
    with pytest.raises(ModelError, match=r"channels.motion.noise .*contact_state\[stage\].*remove the noise"):
        both(tmp_path, text)


def test_pulses_of_the_tacho(planned: tuple[DatasetPlan, Model]) -> None:
    """1500 rpm, 60 pulses a turn: 1500 pulses a second, at a speed that ripples by less than a per cent."""
    plan, model = planned
    record = computed(
        dataclasses.replace(plan, jitter={}), model, PlannedCase(0, {}, {}, 1)
    )  # torques in balance
    begun = record.pulses["tacho"]
    assert 7 <= begun.size <= 8
    np.testing.assert_allclose(np.diff(begun), 1.0 / 1500.0, rtol=0.01)
    levels = record.channels["tacho"].values
    assert set(levels.tolist()) == {0, 1}
    rises = np.flatnonzero(np.diff(levels) == 1)
    starts = begun[begun > 0.0]
    assert np.array_equal(rises, np.ceil(starts * 20000.0).astype(int)[: rises.size] - 1)


def test_what_goes_into_the_name(tmp_path: Path) -> None:
    plan, model = both(tmp_path)
    case = next(plan.cases())
    name = key_maker(plan, model)(case)
    same = dataclasses.replace(plan, title="other", factors={}, seeds=7)
    assert key_maker(same, model)(dataclasses.replace(case, index=5, labels={})) == name
    for other in (
        key_maker(plan, model)(dataclasses.replace(case, seed=2)),
        key_maker(plan, model)(dataclasses.replace(case, changes={"loads.input.torque": "101 N m"})),
        key_maker(dataclasses.replace(plan, length=0.006), model)(case),
        key_maker(dataclasses.replace(plan, jitter={}), model)(case),
        key_maker(dataclasses.replace(plan, channels=dict(list(plan.channels.items())[:1])), model)(case),
        key_maker(plan, model.replace("loads.output.torque", "140 N m"))(case),
    ):
        assert other != name


def test_a_changed_file_that_a_value_names_is_another_case(tmp_path: Path) -> None:
    plan, model = both(tmp_path)
    case = dataclasses.replace(next(plan.cases()), changes={"loads.input.torque": {"python": "law.py:f"}})
    names = set()
    for factor in (1.0, 2.0):
        text = f"def f(t, x, parameters):\n    return {factor}\n"
        (Path(model.file).parent / "law.py").write_text(text, encoding="utf-8")
        names |= {key_maker(plan, model)(case), key_maker(plan, model)(case)}
    assert len(names) == 2


def test_failures_have_a_status_and_a_sentence(planned: tuple[DatasetPlan, Model]) -> None:
    plan, model = planned
    case = next(plan.cases())
    for changes, status, words in (
        ({"meshes.stage.center_distance": "300 mm"}, st.REFUSED, "tips apart"),
        ({"loads.output.torque": "150 N m * sqrt(0.003 - t)"}, st.NOT_FINITE, "(at t = 0.00"),
        ({"loads.input.torque": "10 N m * t/(1 s)"}, st.REFUSED, "loads.input.torque is not a number"),
    ):
        record = computed(plan, model, dataclasses.replace(case, changes=changes))
        assert record.status == status
        assert words in record.sentence
        assert not record.channels
    stop = threading.Event()
    stop.set()
    assert compute_case(plan, model, case, "k", stop).status == st.INTERRUPTED


def test_noise_over_a_constant_has_no_level(tmp_path: Path) -> None:
    text = PLAN.replace(
        'channel: "speed[driven]", noise: {rms: 0.01}', 'channel: "torque[output]", noise: {snr: 3}'
    )
    plan, model = both(tmp_path, text)
    record = computed(plan, model, next(plan.cases()))
    assert record.status == st.REFUSED
    assert "channels.motion: is constant" in record.sentence


def test_the_treatment_is_stated(planned: tuple[DatasetPlan, Model]) -> None:
    plan, _ = planned
    assert treatment(plan).startswith(
        "sampled at 40000 Hz, zero-delay linear-phase low-pass filter (pass band to 8000 Hz"
    )
    assert "without anti-aliasing filter" in treatment(dataclasses.replace(plan, oversampling=1))


def test_without_a_filter_the_samples_are_those_of_the_machine(planned: tuple[DatasetPlan, Model]) -> None:
    plan, model = planned
    bare = dataclasses.replace(plan, jitter={}, oversampling=1, settle_time=0.0)
    found = computed(bare, model, next(plan.cases())).channels["clean"].values
    dense = dataclasses.replace(bare, sample_rate=40000.0)
    every = computed(dense, model, next(plan.cases())).channels["clean"].values
    np.testing.assert_allclose(found, every[::2], rtol=1e-9)
