# SPDX-License-Identifier: Apache-2.0
"""Plans of studies: distributions, samples, and every problem of a bad plan with its line."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.io.yaml_plan import load_study
from pitchpoint.model.reading.plan import model_path
from pitchpoint.sweep.study.check import Study, check_study
from pitchpoint.sweep.study.design import cases_of, count_of
from pitchpoint.sweep.study.factors import Number
from pitchpoint.sweep.study.remarks import remarks
from pitchpoint.sweep.study.run import key_maker
from pitchpoint.sweep.study.run_study import run_study
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.study_files import FREQUENCY, INERTIAS, SERIES, written

RESULT = "results:\n  twist: {channel: 'angle[two]'}\n"


def study_of(folder: Path, text: str, model: str = INERTIAS) -> Study:
    plan = load_study(written(folder, text, model))
    return check_study(plan, load_model(model_path(plan)))


def problems(folder: Path, text: str, model: str = INERTIAS) -> list[str]:
    with pytest.raises(ModelError) as caught:
        study_of(folder, text, model)
    return [str(p) for p in caught.value.problems]


def one_factor(entry: str, more: str = "", evaluate: str = "equilibrium") -> str:
    return f"model: model.yaml\nevaluate: {evaluate}\nsamples: 8\n{more}factors:\n  f: {entry}\n{RESULT}"


def distribution(folder: Path, entry: str) -> Number:
    (factor,) = study_of(folder, one_factor(entry), SERIES).factors
    assert isinstance(factor, Number)
    return factor


TORQUE = "path: loads.outer.torque"
BOTH = "paths: [loads.outer.torque, loads.inner.torque]"


@pytest.mark.parametrize(
    ("entry", "mean", "deviation", "change"),
    [
        (f"{{type: normal, {TORQUE}, deviation: 2 N m}}", 20.0, 2.0, 20.0),
        (f"{{type: normal, {BOTH}, deviation: 10 %, apply: multiply}}", 1.0, 0.1, 20.0),
        (f"{{type: uniform, {TORQUE}, plus_minus: 3 N m}}", 20.0, np.sqrt(3.0), 20.0),
        (f"{{type: uniform, {TORQUE}, low: 10 N m, high: 16 N m}}", 13.0, np.sqrt(3.0), 13.0),
        (f"{{type: triangular, {TORQUE}, low: 10 N m, high: 16 N m}}", 13.0, np.sqrt(1.5), 13.0),
        (f"{{type: tolerance, {BOTH}, limits: [0 N m, 3 N m], capability: 1}}", 1.5, 0.5, 21.5),
        (f"{{type: lognormal, {TORQUE}, deviation: 0.1}}", 20.0 * np.exp(0.005), None, 20.0),
        ("{type: normal, path: bodies.one.mass, mean: 2 kg, deviation: 100 g}", 2.0, 0.1, 2.0),  # not given
    ],
)
def test_distributions(
    tmp_path: Path, entry: str, mean: float, deviation: float | None, change: float
) -> None:
    factor = distribution(tmp_path, entry)
    assert factor.distribution.mean() == pytest.approx(mean)
    if deviation is not None:
        assert factor.distribution.std() == pytest.approx(deviation)
    middle = float(factor.values(np.array([0.5]))[0])
    changes = factor.changes(0.5, middle)
    assert changes[next(iter(factor.numbers))] == pytest.approx(change)


def test_limits_truncate(tmp_path: Path) -> None:
    factor = distribution(tmp_path, f"{{type: normal, {TORQUE}, deviation: 2 N m, low: 19 N m}}")
    assert factor.values(np.array([0.0]))[0] == pytest.approx(19.0)
    entry = f"{{type: tolerance, {TORQUE}, limits: [-1 N m, 1 N m], capability: 0.5, inspected: true}}"
    ends = distribution(tmp_path, entry).values(np.array([0.0, 1.0]))
    assert ends == pytest.approx([-1.0, 1.0], abs=1e-6)


@pytest.mark.parametrize("sampling", ["latin_hypercube", "sobol", "random"])
def test_samples_follow_their_distribution_and_a_longer_plan_continues(tmp_path: Path, sampling: str) -> None:
    entry = f"{{type: uniform, {TORQUE}, low: 10 N m, high: 20 N m}}"
    found = {}
    for n in (16, 32):
        text = one_factor(entry, f"sampling: {sampling}\n").replace("samples: 8", f"samples: {n}")
        study = study_of(tmp_path, text, SERIES)
        key_of = key_maker(study)
        cases = cases_of(study)
        found[n] = [key_of(case) for case in cases]
        values = np.array([case.values["f"] for case in cases])
        assert len(cases) == count_of(study) == n and np.all((values >= 10.0) & (values <= 20.0))
        if sampling != "random":  # one in each interval of equal probability
            assert sorted(np.floor((values - 10.0) / (10.0 / n)).astype(int)) == list(range(n))
    assert (found[32][:16] == found[16]) == (sampling != "latin_hypercube")


def test_full_factorial_and_sobol_indices(tmp_path: Path) -> None:
    text = FREQUENCY.replace("sampling: sobol\nsamples: 32", "sampling: full_factorial\nsamples: 3")
    assert len(cases_of(study_of(tmp_path, text))) == 27
    study = study_of(tmp_path, FREQUENCY.replace("samples: 32", "samples: 4\nsensitivity: sobol_indices"))
    cases = cases_of(study)
    assert len(cases) == 4 * 5 and [c.group for c in cases[:5]] == [0, 1, 2, 3, 4]
    a, b, mixed = (cases[k].values for k in (0, 1, 3))
    assert mixed == {**a, "first inertia": b["first inertia"]}
    assert any("wide intervals" in r for r in remarks(study))


def test_pitch_deviations_close_and_differ(tmp_path: Path) -> None:
    text = (
        "model: model.yaml\nevaluate: equilibrium\nsamples: 200\nfactors:\n"
        "  pitch: {type: pitch_deviations, gears: [g1, g2], deviation: 4 um}\n"
        "results:\n  force: {channel: 'mesh_force[stage]'}\n"
    )
    cases = cases_of(study_of(tmp_path, text, TORSIONAL_PAIR))
    own = np.array([case.changes["gears.g1.deviations.pitch"] for case in cases])
    other = np.array([case.changes["gears.g2.deviations.pitch"] for case in cases])
    assert np.abs(own.sum(axis=1)).max() < 1e-12 and own.shape == (200, 50)
    assert own.std() == pytest.approx(4e-6, rel=0.02)  # 10 000 numbers: 0.7 %
    assert abs(np.corrcoef(own.ravel(), other.ravel())[0, 1]) < 0.05
    sums = np.cumsum(own, axis=1)
    largest = np.maximum(np.ptp(sums, axis=1), np.ptp(np.cumsum(other, axis=1), axis=1))
    assert [case.values["pitch"] for case in cases] == pytest.approx(largest.tolist(), rel=1e-9)
    # range of a Brownian bridge, less 0.5826 deviations at both ends between its 50 steps (D. Siegmund,
    # Sequential Analysis, 1985, 10.2); deviation of the range 0.272 sqrt(50), of the mean of 200 0.14
    expected = np.sqrt(0.5 * np.pi * 50) - 2.0 * 0.5826
    assert np.ptp(sums, axis=1).mean() == pytest.approx(expected * 4e-6, abs=3.0 * 0.14 * 4e-6)


def test_pitch_deviations_of_single_flanks(tmp_path: Path) -> None:
    """Independent flanks have uncorrelated deviations; the left ones are those of equal flanks."""
    text = (
        "model: model.yaml\nevaluate: equilibrium\nsamples: 100\nfactors:\n"
        "  pitch: {{type: pitch_deviations, gears: [g1], deviation: 4 um, flanks: {}}}\n"
        "results:\n  force: {{channel: 'mesh_force[stage]'}}\n"
    )
    found = {}
    for flanks in ("equal", "independent", "left", "right"):
        cases = cases_of(study_of(tmp_path, text.format(flanks), TORSIONAL_PAIR))
        found[flanks] = [case.changes["gears.g1.deviations.pitch"] for case in cases]
    left, right = (np.array([c[side] for c in found["independent"]]) for side in ("left", "right"))
    assert np.array_equal(left, np.array(found["equal"]))
    assert abs(np.corrcoef(left.ravel(), right.ravel())[0, 1]) < 0.05
    assert right.std() == pytest.approx(4e-6, rel=0.03) and np.abs(right.sum(axis=1)).max() < 1e-12
    assert found["left"][0] == {"left": found["equal"][0], "right": []}
    assert found["right"][0] == {"left": [], "right": found["equal"][0]}


PLANETS = """\
model: model.yaml
scenario: slow
samples: 4
factors:
  pin: {type: uniform, path: planetary_stages.set.pin_errors.planet_2.tangential, plus_minus: 20 um}
  pitch: {type: pitch_deviations, gears: [planet_3], deviation: 4 um}
results:
  force: {channel: "mesh_force[sun-planet_1]", statistic: mean}
"""


def test_factors_of_single_planets(tmp_path: Path) -> None:
    """A pin without an error has the error 0; pitch deviations of a planet are those of the single planet."""
    model = Path(__file__).parents[3] / "examples" / "planetary-set" / "model.yaml"
    study = study_of(tmp_path, PLANETS, model.read_text("utf-8"))
    cases = cases_of(study)
    paths = {path for case in cases for path in case.changes}
    assert paths == {
        "planetary_stages.set.pin_errors.planet_2.tangential",
        "planetary_stages.set.single_planets.planet_3.deviations.pitch",
    }
    assert [f.nominal for f in study.factors] == [0.0, 0.0]
    changed = study.model.replace_all(cases[0].changes)
    deviations = changed.gears["planet_3"].deviations
    assert deviations is not None and len(deviations.pitch_of("left")) == 39
    assert changed.gears["planet_1"].deviations is None


def test_all_problems_of_a_plan_at_once(tmp_path: Path) -> None:
    text = """\
model: model.yaml
evaluate: equilibrium
sampling: latin hypercube
samples: 1
factors:
  a: {type: normal, path: loads.outer.torque, deviation: 1 N m}
  b: {type: normal, path: loads.outer.torque, deviation: 1 N m}
  c: {type: uniform, path: loads.inner.torque}
  d: {type: gauss, path: loads.inner.torque}
  e: {type: levels, path: loads.inner.torque, values: 5 N m}
results:
  twist: {chanel: "angle[two]"}
"""
    found = problems(tmp_path, text, SERIES)
    for words in (
        "sampling (line 3): 'latin hypercube' is not allowed; did you mean latin_hypercube?",
        "samples (line 4): 1 is out of range (limit >= 2",
        "factors.c (line 8): gives neither or both of low and plus_minus; give exactly one",
        "factors.d.type (line 9): 'gauss' is not allowed",
        "results.twist.chanel (line 12): is an unknown key; did you mean channel?",
    ):
        assert any(p.startswith(words) for p in found), (words, found)
    assert [int(p.split("line ")[1].split(")")[0]) for p in found] == sorted(
        int(p.split("line ")[1].split(")")[0]) for p in found
    )
    later = text.replace("latin hypercube", "latin_hypercube").replace("samples: 1", "samples: 8")
    later = later.replace("chanel", "channel").replace("inner.torque}", "inner.torque, plus_minus: 1 N m}")
    later = later.replace("gauss", "uniform")
    found = problems(tmp_path, later, SERIES)
    assert any("factors.b (line 7): changes loads.outer.torque, as does a" in p for p in found), found
    assert any("factors.e.values (line 10): '5 N m' is not a list of values" in p for p in found), found


def test_all_problems_with_the_model_at_once(tmp_path: Path) -> None:
    text = """\
model: model.yaml
evaluate: equilibrium
samples: 8
factors:
  a: {type: normal, path: loads.outer.torqe, deviation: 1 N m}
  b: {type: normal, path: torsion_springs.second.stiffness, deviation: -1 N m/rad}
  c: {type: normal, path: bodies.one.inertia, deviation: 0.01 kg m^2}
  d: {type: uniform, path: loads.inner.torque, plus_minus: 1 mm}
  e: {type: normal, path: torsion_springs.first, deviation: 1}
  f: {type: tolerance, path: loads.outer.torque, limits: [5 N m, -5 N m], capability: 1}
results:
  twist: {channel: "angle[tow]"}
  other: {channel: "angle[two]", statistic: max, high: 5 mm}
"""
    found = problems(tmp_path, text, SERIES)
    for words in (
        "factors.a.path (line 5): loads.outer.torqe is an unknown key; did you mean torque?",
        "factors.b.deviation (line 6): -1 N m/rad is not a standard deviation; give a positive deviation",
        "factors.c (line 7): 2.3 % of the values are not permitted for bodies.one.inertia (limit > 0",
        "factors.d.plus_minus (line 8): '1 mm'",
        "factors.e.path (line 9): torsion_springs.first is not a number of the model; name a key with one",
        "factors.f.limits (line 10): 5 N m, -5 N m are not in ascending order",
        "results.twist.channel (line 12): there is no result 'angle[tow]'; did you mean angle[two]",
        "results.other.statistic (line 13): max angle[two] is a single number; omit statistic",
        "results.other.high (line 13): 5 mm has another unit than the result; write a quantity in rad",
    ):
        assert any(p.startswith(words) for p in found), (words, found)


@pytest.mark.parametrize(
    ("entry", "more", "words"),
    [
        (
            f"{{type: normal, {BOTH}, deviation: 1 N m}}",
            "",
            "the numbers at its paths differ; write apply: add",
        ),
        (f"{{type: lognormal, {TORQUE}, deviation: 0.1, apply: add}}", "", "the values have one sign"),
        (
            f"{{type: triangular, {TORQUE}, low: 1 N m, high: 2 N m, mode: 3 N m}}",
            "",
            "not between the limits",
        ),
        (f"{{type: levels, {TORQUE}, values: [1 N m, 2 mm]}}", "", "is rejected: loads.outer.torque"),
        (f"{{type: levels, {TORQUE}, values: [1, 2], weights: [1]}}", "", "has 1 entries for 2 values"),
        (
            "{type: uniform, paths: [loads.outer.torque, bodies.one.inertia], plus_minus: 1}",
            "",
            "has paths of different units",
        ),
        (
            f"{{type: normal, {TORQUE}, deviation: 1 N m}}",
            "sensitivity: sobol_indices\n",
            "requires sampling",
        ),
        (
            f"{{type: normal, {TORQUE}, deviation: 1 N m}}",
            "correlations: [{factors: [f, g], coefficient: 0.5}]\n",
            "there is no factor 'g'",
        ),
        ("{type: pitch_deviations, gears: [g1], deviation: 1 um}", "", "there is no cylindrical gear 'g1'"),
        ("{type: normal, path: loads.outer, deviation: 1}", "", "loads.outer is not a number of the model"),
        (
            "{type: normal, path: bodies.one.mass, deviation: 100 g}",
            "",
            "the model does not give bodies.one.mass; give it in the model, or write absolute values",
        ),
    ],
)
def test_bad_factors(tmp_path: Path, entry: str, more: str, words: str) -> None:
    assert any(words in p for p in problems(tmp_path, one_factor(entry, more), SERIES))


def test_contradicting_correlations(tmp_path: Path) -> None:
    pairs = [("stiffness", "first inertia", 0.9), ("first inertia", "second inertia", 0.9)]
    pairs.append(("stiffness", "second inertia", -0.9))
    listed = ", ".join(f"{{factors: [{a}, {b}], coefficient: {c}}}" for a, b, c in pairs)
    (found,) = problems(tmp_path, FREQUENCY + f"correlations: [{listed}]\n")
    assert "contradict each other: their matrix has the eigenvalue -0.8" in found


def test_backlash_that_does_not_follow_the_centre_distance_is_a_remark(tmp_path: Path) -> None:
    text = (
        "model: model.yaml\nevaluate: equilibrium\nsampling: sobol\nsamples: 12\nfactors:\n"
        "  a: {type: tolerance, path: meshes.stage.center_distance, limits: [-20 um, 20 um], capability: 1}\n"
        "results:\n  force: {channel: 'mesh_force[stage]'}\n"
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        given = list(remarks(study_of(tmp_path, text, TORSIONAL_PAIR)))
        free = TORSIONAL_PAIR.replace("    backlash: {normal: 0.1 mm}\n", "")
        thin = free.replace("profile_shift_coefficient: 0}", "profile_shift_coefficient: 0, {}}").replace(
            "{}", "tooth_thickness_allowance: -60 um"
        )
        follows = remarks(study_of(tmp_path, text, thin))
    assert [r.line for r in given] == [4, 6]
    assert given[0].startswith("samples (line 4): 12 is not a power of two") and "write 8 or 16" in given[0]
    assert "not its backlash: it is given; remove backlash" in given[1]
    assert len(follows) == 1


def test_a_profile_shift_that_follows_a_varied_centre_distance_is_noted(tmp_path: Path) -> None:
    """x at 150.1 mm: (inv alpha_wt - inv alpha) (z_1 + z_2)/(2 tan alpha), in the stored notes."""
    shifted = TORSIONAL_PAIR.replace(", profile_shift_coefficient: 0}", "}", 1)
    text = (
        "model: model.yaml\nevaluate: equilibrium\nsampling: full_factorial\nsamples: 2\nfactors:\n"
        "  a: {type: levels, path: meshes.stage.center_distance, values: [150 mm, 150.1 mm]}\n"
        "results:\n  force: {channel: 'mesh_force[stage]'}\n"
    )
    data = run_study(written(tmp_path, text, shifted))
    (note,) = [note for note in data.attrs["notes"] if "profile shift" in note]
    assert note.startswith("factors.a (line 6): also changes the profile shift of g1")
    alpha = np.radians(20.0)
    working = np.arccos(np.cos(alpha) * 150.0 / 150.1)
    x = 100.0 * (np.tan(working) - working - np.tan(alpha) + alpha) / (2.0 * np.tan(alpha))
    assert f"to {x:.4g} from" in note


def test_whole_numbers_have_levels(tmp_path: Path) -> None:
    text = (
        "model: model.yaml\nevaluate: equilibrium\nsamples: 8\nfactors:\n"
        "  z: {type: normal, path: gears.g1.number_of_teeth, deviation: 1}\n"
        "results:\n  force: {channel: 'mesh_force[stage]'}\n"
    )
    (found,) = problems(tmp_path, text, TORSIONAL_PAIR)
    assert found.startswith(
        "factors.z.path (line 5): gears.g1.number_of_teeth is a whole number of the model; write"
    )
    levels = text.replace("normal,", "levels,").replace("deviation: 1", "values: [49, 50]")
    assert len(cases_of(study_of(tmp_path, levels, TORSIONAL_PAIR))) == 8
