# SPDX-License-Identifier: Apache-2.0
"""Models made in Python: objects, dictionaries and texts give the model of the same file."""

from __future__ import annotations

import copy
import dataclasses
import pickle
import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.components.gear import Rack
from pitchpoint.model.components.law import Constant, FormulaLaw, PythonLaw
from pitchpoint.model.sections import GROUPS, SECTIONS
from pitchpoint.model.stand_ins import own_parts
from pitchpoint.system.compile import compile_model

ROOT = Path(__file__).parents[3]
TEXTS = {
    path: path.read_text(encoding="utf-8")
    for folder in ("examples/*", "docs/reference/snippets", "src/pitchpoint/cli/starters")
    for path in sorted(ROOT.glob(f"{folder}/*.yaml"))
}
FILES = [
    path
    for path, text in TEXTS.items()
    if path.name != "precomputed.yaml"  # its table is computed first
    and re.search(r"^(gears|bodies|include):", text, re.M)
    and (path.parent.parent.name != "examples" or re.search(r"^title:", text, re.M))  # parts have no title
]

TEXT = """
title: helical stage
parameters: {m_n: 2 mm, clearance: {value: 20 um, text: of the bearings}}
gears:
  pinion: {number_of_teeth: 24, normal_module: m_n, face_width: 20 mm, profile_shift_coefficient: 0,
    rack: {addendum: 1.1}}
  wheel: {number_of_teeth: 48, normal_module: m_n, face_width: 10 * m_n, profile_shift_coefficient: 0}
bodies:
  input: {gears: [pinion], motion: torsion}
  output: {gears: {wheel: 5 mm}, motion: torsion}
meshes:
  stage: {gears: [pinion, wheel], backlash: {normal: 2 * clearance}, center_distance: 72 mm,
    stiffness: {law: constant, value: 4e8 N/m}}
loads:
  motor: {body: input, torque: 10 N m * (1 + 0.1 * sin(2 * pi * 5 Hz * t))}
  brake: {body: output, torque: balance}
scenarios:
  steady: {speed: {input: 1500 rpm}, duration: 0.1 s}
"""


@cache
def read(path: Path) -> pp.Model:
    """The model of a file."""
    return load_model(path, allow_code=True)


def made() -> pp.Model:
    """The model of the text, from objects and dictionaries in turn."""
    return pp.Model(
        title="helical stage",
        parameters={"m_n": "2 mm", "clearance": pp.Parameter("20 um", "of the bearings")},
        gears={
            "pinion": pp.Gear(
                number_of_teeth=24,
                normal_module="m_n",
                face_width=0.02,
                profile_shift_coefficient=0,
                rack={"addendum": 1.1},
            ),
            "wheel": {
                "number_of_teeth": 48,
                "normal_module": "m_n",
                "face_width": "10 * m_n",
                "profile_shift_coefficient": 0,
            },
        },
        bodies={
            "input": pp.Body(gears=["pinion"], motion="torsion"),
            "output": pp.Body(gears={"wheel": "5 mm"}, motion="torsion"),
        },
        meshes={
            "stage": pp.Mesh(
                gears=["pinion", "wheel"],
                backlash={"normal": "2 * clearance"},
                center_distance="72 mm",
                stiffness={"law": "constant", "value": 4e8},
            )
        },
        loads={
            "motor": {"body": "input", "torque": "10 N m * (1 + 0.1 * sin(2 * pi * 5 Hz * t))"},
            "brake": pp.Load(body="output", torque="balance"),
        },
        scenarios={"steady": pp.Scenario(speed={"input": "1500 rpm"}, duration="0.1 s")},
    )


def problems_of(**keys: Any) -> list[str]:
    """Problems of a model, each as text."""
    with pytest.raises(pp.ModelError) as caught:
        pp.Model(**keys)
    assert all(p.line is None for p in caught.value.problems)
    return [str(p) for p in caught.value.problems]


# --- the same model as a file --------------------------------------------------------------------------
def test_objects_and_dictionaries_give_the_model_of_the_file() -> None:
    model = made()
    assert model == loads_model(TEXT)
    assert content_hash(model) == content_hash(loads_model(TEXT))
    assert model.gears["wheel"].face_width == pytest.approx(0.02, rel=1e-15)
    assert model.meshes["stage"].backlash.normal == pytest.approx(40e-6, rel=1e-15)


@pytest.mark.parametrize(
    "path",
    [path for path in FILES if "\ninclude:" not in path.read_text()],  # included files are for files
    ids=lambda p: f"{p.parent.name}/{p.name}",
)
def test_every_file_is_rebuilt_from_its_sections(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from pitchpoint.model.keys import keys_of
    from pitchpoint.model.reading.yaml_tree import Tree

    monkeypatch.chdir(path.parent)
    data = Tree(path.read_text()).data
    model = read(path)
    own = {name: part for name, part in data.items() if name in keys_of(pp.Model)}
    again = pp.Model(**own, allow_code=True)
    assert content_hash(again) == content_hash(pp.Model.from_dict(data, allow_code=True))
    assert {g: list(getattr(again, g)) for g in GROUPS} == {g: list(getattr(model, g)) for g in GROUPS}
    assert again.to_yaml() == model.to_yaml()


def test_values_are_converted_when_a_component_is_made() -> None:
    gear = pp.Gear(number_of_teeth=24, normal_module="2 mm", face_width="2 cm", rack={"addendum": 1.1})
    assert (gear.normal_module, gear.face_width, gear.rack) == (0.002, 0.02, Rack(addendum=1.1))
    assert pp.Load(body="a", torque=3).torque == Constant(3.0)
    assert isinstance(pp.Load(body="a", torque="3 N m * sin(t/1 s)").torque, FormulaLaw)
    assert pp.Body(position=["1 mm", 0, "2 mm"]).position == (0.001, 0, 0.002)
    assert pp.Body(gears=["a", "b"]).gears == {"a": 0.0, "b": 0.0}
    assert pp.Bearing(body="a", stiffness={"radial": "2e8 N/m"}).stiffness.radial == 2e8


def test_numbers_are_in_si_units_and_whole_ones_become_floats() -> None:
    gear = pp.Gear(number_of_teeth=24, normal_module=0.002, face_width=1, profile_shift_coefficient=0)
    assert gear.face_width == 1.0 and isinstance(gear.face_width, float)
    assert isinstance(gear.number_of_teeth, int)
    assert all(isinstance(v, float) for v in pp.Body(position=(0, 0, 1)).position)
    assert isinstance(pp.Scenario(speed={"a": 100}, duration=1).speed["a"], float)


def test_a_parameter_changes_what_was_made_with_it() -> None:
    larger = made().replace_all({"parameters.m_n": "2.5 mm", "meshes.stage.center_distance": "90 mm"})
    assert larger.gears["pinion"].normal_module == 0.0025
    assert larger.gears["wheel"].face_width == 0.025


def test_a_component_can_be_replaced_by_one_with_parameters() -> None:
    gear = pp.Gear(
        number_of_teeth=24, normal_module="m_n", face_width="12 * m_n", profile_shift_coefficient=0.0
    )
    changed = made().replace("gears.pinion", gear)
    assert changed.gears["pinion"].face_width == pytest.approx(0.024, rel=1e-15)
    assert "face_width: 12 * m_n" in changed.to_yaml()


def test_a_component_with_unread_values_can_be_copied() -> None:
    gear = pp.Gear(number_of_teeth=24, normal_module="m_n", face_width="20 mm")
    assert copy.deepcopy(gear) == pickle.loads(pickle.dumps(gear)) == gear
    assert repr(gear) == "Gear(number_of_teeth=24, normal_module='m_n', face_width='20 mm')"


def test_code_is_refused_unless_it_is_allowed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "laws.py").write_text("def f(t, x, p):\n    return p[0]\n")
    monkeypatch.chdir(tmp_path)
    keys = {
        "bodies": {"a": {"inertia": "1 kg m^2", "motion": "torsion"}},
        "loads": {"l": pp.Load(body="a", torque={"python": "laws.py:f", "parameters": ["2 N m / 1 N m"]})},
    }
    assert "names Python code" in problems_of(**keys)[0]
    law = pp.Model(**keys, allow_code=True).loads["l"].torque
    assert isinstance(law, PythonLaw) and law.parameters == (2.0,)


# --- messages --------------------------------------------------------------------------------------------
def test_all_problems_are_reported_with_the_path_of_their_key() -> None:
    found = problems_of(
        gears={
            "a": {"number_of_teeth": 2, "normal_module": "2 kg", "face_width": "20 mm"},
            "b": {"number_of_teeth": 24, "normal_modul": "2 mm", "face_width": "20 mm"},
            "c": pp.Gear(number_of_teeth=24, normal_module="module", face_width="1 mm", rack={"adendum": 1}),
        },
        bodies={"d": pp.Load(body="x"), "e": {"position": ["0 mm", "1 s", 0]}},
        loads=[1],
    )
    for begin in (
        "gears.a.normal_module: '2 kg'",
        "gears.a.number_of_teeth: 2 is out of range",
        "gears.b.normal_modul: is an unknown key; did you mean normal_module?",
        "gears.c.normal_module: 'module'",
        "gears.c.rack.adendum: is an unknown key",
        "bodies.d: Load is of the wrong type (limit Body)",
        "bodies.e.position[1]: '1 s'",
        "loads: a list of 1 is not a mapping of names",
    ):
        assert sum(text.startswith(begin) for text in found) == 1, (begin, found)


def test_texts_that_no_parameter_can_resolve_are_reported_at_once() -> None:
    with pytest.raises(pp.ModelError) as caught:
        pp.Gear(number_of_teeth="24", normal_module="2 mmm", face_width="2 kg")
    assert list(map(str, caught.value.problems)) == [
        "Gear.number_of_teeth: '24' is not a whole number (limit >= 3 and <= 10000); write 24 without quotes",
        "Gear.normal_module: '2 mmm': unknown unit 'mmm'; write a length such as 3 mm",
        "Gear.face_width: '2 kg': 'kg' is not the unit of a length; write a length such as 3 mm",
    ]
    with pytest.raises(pp.ModelError, match=r"Body\.position\[1\]: '1 s'"):
        pp.Body(position=["0 mm", "1 s", 0])
    for text in ("m_n", "2*m_n", "m_n + 1 kg", "14 N/m_n", "2 mm * cos(m_n)"):
        pp.Gear(number_of_teeth=24, normal_module=text, face_width="20 mm")


@pytest.mark.parametrize("teeth", [np.int64(21), np.int32(21), 21.0, np.float64(21.0), np.array(21)])
def test_whole_numbers_of_numpy_and_whole_floats_are_numbers_of_teeth(teeth: Any) -> None:
    given = {
        "normal_module": np.float32(0.003),
        "face_width": "30 mm",
        "profile_shift_coefficient": np.int64(0),
    }
    gear = pp.Gear(number_of_teeth=teeth, **given)
    assert type(gear.number_of_teeth) is int and gear.number_of_teeth == 21
    for part in (gear, {"number_of_teeth": teeth, **given}):
        model = pp.Model.from_dict({"gears": {"a": part}})
        assert model == pp.Model(gears={"a": part})
        assert type(model.gears["a"].number_of_teeth) is int
        assert model.replace("gears.a.number_of_teeth", teeth + 1).gears["a"].geometry.z == 22
        assert pp.load_model(text=model.to_yaml()) == model
    assert (
        pp.CylindricalGear(z=teeth[()] if isinstance(teeth, np.ndarray) else teeth, m_n=np.float32(1)).z == 21
    )


def test_a_fraction_of_a_tooth_has_the_limit_of_a_file() -> None:
    for teeth, words in ((24.5, "24.5 is not a whole number"), (np.float64(2.0), "2.0 is out of range")):
        (problem,) = problems_of(
            gears={
                "a": pp.Gear(
                    number_of_teeth=teeth, normal_module=0.002, face_width=0.02, profile_shift_coefficient=0
                )
            }
        )
        assert problem.startswith(f"gears.a.number_of_teeth: {words}"), problem


def test_arrays_are_lists() -> None:
    t = np.linspace(0.0, 1.0, 5)
    load = pp.Load(body="a", torque={"table": np.column_stack([t, t**2]), "over": "time"})
    assert load.torque.values == (0.0, 0.0625, 0.25, 0.5625, 1.0)
    body = {"inertia": np.float64(2.0), "position": np.array([0, 0, 0.5])}
    for part in (pp.Body(**body), body):
        model = pp.Model(bodies={"a": part}, loads={"l": load})
        assert model.bodies["a"].position == (0.0, 0.0, 0.5)
        moved = model.replace("bodies.a.position", np.array([0, 0.1, 0.5]))
        assert moved.bodies["a"].position == (0.0, 0.1, 0.5)
        assert pp.load_model(text=moved.to_yaml()) == moved


def test_an_unknown_section_of_a_dictionary_is_reported() -> None:
    with pytest.raises(pp.ModelError, match="gear: is an unknown key; did you mean gears"):
        pp.Model.from_dict({"gear": {}, "bodies": {"a": {"inertia": 1.0}}})


def test_objects_in_a_dictionary_are_checked() -> None:
    with pytest.raises(pp.ModelError, match=r"bodies\.a\.inertia: -1"):
        pp.Model.from_dict({"bodies": {"a": pp.Body(inertia=-1.0)}})


# --- written back ----------------------------------------------------------------------------------------
def test_texts_and_formulas_are_written_as_given() -> None:
    text = loads_model(TEXT.replace("face_width: 20 mm", "face_width: 0.02 m")).to_yaml()
    for part in (
        "m_n: 2 mm",
        "normal_module: m_n",
        "face_width: 0.02 m",
        "10 * m_n",
        "normal: 2 * clearance",
    ):
        assert part in text
    assert text.index("gears:") < text.index("bodies:") < text.index("meshes:") < text.index("scenarios:")


def test_a_text_is_not_written_for_another_value() -> None:
    from dataclasses import replace

    model = loads_model(TEXT)
    wider = replace(model.gears["pinion"], face_width=0.025)
    text = replace(model, gears={**model.gears, "pinion": wider}).to_yaml()
    assert "face_width: 25 mm" in text and loads_model(text).gears["pinion"].face_width == 0.025


@pytest.mark.parametrize("path", FILES, ids=lambda p: f"{p.parent.name}/{p.name}")
def test_what_is_written_is_read_back(path: Path) -> None:
    model = read(path)
    text = model.to_yaml()
    again = loads_model(text, allow_code=True, file=str(path))
    assert again == model
    assert again.to_yaml() == text
    assert not any(line != line.rstrip() for line in text.splitlines())


# --- representation --------------------------------------------------------------------------------------
@pytest.mark.parametrize("path", FILES, ids=lambda p: f"{p.parent.name}/{p.name}")
def test_the_representation_of_a_component_makes_it_again(path: Path) -> None:
    model = read(path)
    for group in GROUPS:
        for part in own_parts(getattr(model, group)).values():
            text = repr(part)
            if ".py:" in text or ", ..., " in text:  # code is not allowed here; long lists are shortened
                continue
            again = eval(text, {type(part).__name__: type(part)})
            assert again == part, text
    assert len(repr(model)) < 500


def test_a_model_and_a_system_are_described_in_one_line() -> None:
    model = made()
    assert repr(model) == "Model 'helical stage': 2 gears, 2 bodies, 1 mesh, 2 loads; scenario steady"
    assert repr(pp.Model()) == "Model: empty"
    text = repr(compile_model(model, "steady"))
    assert text.startswith("System 'helical stage': 2 bodies, 2 coordinates") and len(text) < 200


def test_gear_pairs_bad_components_and_pictures_have_short_representations() -> None:
    model = pp.load_model(text=PAIR_TEXT)
    pair = model.pairs["st"]
    assert repr(pair) == (
        "GearPair(gear1=CylindricalGear(z=24, m_n=0.002, beta=0.2, b=0.02), "
        "gear2=CylindricalGear(z=49, m_n=0.002, beta=-0.2, b=0.02), a_w=0.0744847357)"
    )
    one, two = (
        eval(repr(gear), {"CylindricalGear": pp.CylindricalGear}) for gear in (pair.gear1, pair.gear2)
    )
    assert (one, two) == (pair.gear1, pair.gear2)
    bad = pp.Gear(number_of_teeth=24, normal_module=float("nan"), face_width="20 mm", helix_angle="m_n")
    assert repr(bad) == "Gear(number_of_teeth=24, normal_module=nan, helix_angle='m_n', face_width=0.02)"
    assert repr(pp.plot(model)).startswith("<Picture: HTML, ")


PAIR_TEXT = """
gears:
  p: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0,
    helix_angle: 0.2 rad, hand: right}
  w: {number_of_teeth: 49, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0,
    helix_angle: 0.2 rad, hand: left}
bodies: {i: {gears: [p]}, o: {gears: [w]}}
meshes: {st: {gears: [p, w]}}
"""


def test_the_tables_of_a_notebook_have_printed_symbols() -> None:
    html = pp.load_model(text=PAIR_TEXT)._repr_html_()
    heads = re.findall("<th>(.*?)</th>", html)
    assert heads[3:5] == ["m<sub>n</sub>", "β"] and "ε<sub>α</sub>" in heads
    assert not [head for head in heads if "_" in head]


def test_long_lists_are_shortened() -> None:
    text = repr(pp.Load(body="a", torque={"table": [[i, i] for i in range(100)], "over": "time"}))
    assert len(text) < 200 and ", ..., " in text


# --- completion ------------------------------------------------------------------------------------------
def test_every_section_has_its_class_in_the_package() -> None:
    for name, section in SECTIONS.items():
        if not isinstance(section.component, dict):  # those with a type are written as dictionaries
            assert getattr(pp, section.component.__name__) is section.component, name
            assert section.component.__name__ in dir(pp)


def test_ipython_completes_sections_and_names() -> None:
    from IPython.core.completer import IPCompleter, provisionalcompleter

    completer = IPCompleter(namespace={"model": made(), "pp": pp}, global_namespace={})
    completer.use_jedi = False
    completer.custom_matchers = []
    completer.disable_matchers = ["IPCompleter.magic_matcher"]  # needs a running shell

    def found(text: str) -> list[str]:
        """Completions at the end of a line."""
        with provisionalcompleter():
            return [one.text for one in completer.completions(text, len(text))]

    assert [one.lstrip(".") for one in found("model.gea")] == ["gears"]
    assert {"pinion", "wheel"} <= set(found('model.gears["'))
    assert any("normal_module" in one for one in found('model.gears["pinion"].norm'))
    assert any("Gear" in one for one in found("pp.Ge"))
    assert made().gears._ipython_key_completions_() == ["pinion", "wheel"]


def test_an_unknown_key_of_a_component_is_a_problem_with_the_nearest_name():
    """All of them at once, as in a file."""
    with pytest.raises(ModelError) as caught:
        pp.Gear(number_of_teth=20, modul=2)
    first, second = (str(problem) for problem in caught.value.problems)
    assert first.startswith(
        "Gear.number_of_teth: is an unknown key; did you mean number_of_teeth? allowed are type,"
    )
    assert second.startswith("Gear.modul: is an unknown key; did you mean normal_module? allowed are")
    with pytest.raises(ModelError, match=r"Model.gaers: is an unknown key; did you mean gears\?"):
        pp.Model(gaers={})


def test_components_are_copied_and_pickled():
    gear = pp.Gear(number_of_teeth=20, normal_module="2 mm", face_width=0.02)
    assert copy.deepcopy(gear) == gear
    assert pickle.loads(pickle.dumps(gear)) == gear
    assert dataclasses.replace(gear, number_of_teeth=21).number_of_teeth == 21
