# SPDX-License-Identifier: Apache-2.0
"""Models of several files: merging, places of messages, refusals, stored results."""

from __future__ import annotations

import json
import pickle
import tracemalloc

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io import missing_include
from pitchpoint.io.yaml_model import dump_model, load_model, loads_model
from pitchpoint.model import files as files_of_models
from pitchpoint.model.remarks.collect import remarks_of_file
from tests.support.cli_files import json_of

MAIN = """\
title: pair
include: [gears.yaml, drives/loads.yaml]
parameters: {m_n: 3 mm}
bodies:
  a: {gears: [pinion], inertia: 0.01 kg m^2}
  b: {gears: [wheel], inertia: 0.01 kg m^2}
meshes:
  stage: {gears: [pinion, wheel], stiffness: {law: constant, value: 4e8 N/m}, damper: {ratio: 0.1}}
scenarios: {run: {speed: {a: 60}, duration: 1 ms, step: 10 us}}
"""
GEARS = """\
# gears of stage 1
gears:
  pinion: {number_of_teeth: 20, normal_module: m_n, face_width: 20 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 40, normal_module: m_n, face_width: 20 mm, profile_shift_coefficient: 0}
"""
LOADS = """\
include: gears.yaml
parameters: {torque: 50 N m}
loads:
  drive: {body: a, torque: torque}
  brake: {body: b, torque: balance}
"""


@pytest.fixture
def files(tmp_path):
    def write(**texts):
        """Write the files of the model, with some changed or added."""
        (tmp_path / "drives").mkdir(exist_ok=True)
        texts = {"model": MAIN, "gears": GEARS, "drives/loads": LOADS, **texts}
        for name, text in texts.items():
            (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
        return tmp_path / "model.yaml"

    return write


def problems_of(file):
    with pytest.raises(ModelError) as found:
        load_model(file)
    return [str(problem) for problem in found.value.problems]


def test_sections_of_several_files_are_merged(files):
    model = load_model(files())
    assert model.origin.files == ("gears.yaml", "drives/loads.yaml")
    one = MAIN.replace("include: [gears.yaml, drives/loads.yaml]\n", "").replace(
        "{m_n", "{torque: 50 N m, m_n"
    )
    whole = loads_model(one + GEARS + LOADS[LOADS.index("loads:") :])
    assert content_hash(model) == content_hash(whole)
    assert content_hash(loads_model(dump_model(model))) == content_hash(model)


def test_the_content_of_an_included_file_belongs_to_the_hash(files):
    before = content_hash(load_model(files()))
    assert content_hash(load_model(files(gears=GEARS.replace("40,", "41,")))) != before


def test_messages_name_the_included_file(files):
    found = problems_of(files(gears=GEARS.replace("m_n, face_width: 20 mm", "m_m, face_width: 20 mmm", 1)))
    assert len(found) == 2
    assert all("(gears.yaml, line 3)" in problem for problem in found)
    model = load_model(files(gears=GEARS.replace("20 mm", "20 m", 1).replace("20 m,", "2,")))
    [bare, speed] = remarks_of_file(model)
    assert (bare.line, bare.file, bare.parts["file"]) == (3, "gears.yaml", "gears.yaml")
    assert (speed.line, speed.file) == (9, None) and "file" not in speed.parts
    assert pickle.loads(pickle.dumps(bare)) == bare
    assert pickle.loads(pickle.dumps(model)).line(("gears", "pinion")).file == "gears.yaml"


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (
            {"model": MAIN.replace("gears.yaml", "../gears.yaml")},
            "'../gears.yaml' names a file that does not",
        ),
        (
            {"model": MAIN.replace("gears.yaml", "../../etc/hosts")},
            "is not the relative name of a model file",
        ),
        ({"model": MAIN.replace("gears.yaml", "/etc/g.yaml")}, "is not the relative name of a model file"),
        ({"model": MAIN.replace("gears.yaml", "gear.yaml")}, "'gear.yaml' names a file that does not exist"),
        (
            {"model": MAIN.replace("gears.yaml", "gear.yaml")},
            "'gear.yaml' names a file that does not exist; did you mean gears.yaml? file names are",
        ),
        ({"drives/load": "", "model": MAIN.replace("loads.y", "laods.y")}, "did you mean drives/loads.yaml?"),
        ({"model": MAIN.replace("gears.yaml", "drives")}, "include (line 2): 'drives' names a folder"),
        (
            {"model": MAIN.replace("include", "includes")},
            "includes (line 2): is an unknown key; did you mean include?",
        ),
        ({"model": MAIN.replace("gears.yaml", "3")}, "3 is not the name of a file"),
        ({"model": MAIN.replace("[gears.yaml, drives/loads.yaml]", "{a: b}")}, "is not a list of files"),
        (
            {"gears": "include: model.yaml\n" + GEARS},
            "include (gears.yaml, line 1): forms a circle: model.yaml -> gears.yaml -> model.yaml",
        ),
        (
            {"drives/loads": LOADS + GEARS.replace("wheel", "idler")},
            "gears.pinion (drives/loads.yaml, line 8): is given twice, also in gears.yaml, line 3",
        ),
        ({"gears": GEARS + "title: gears\n"}, "title (line 1): is given twice, also in gears.yaml, line 5"),
        ({"gears": "- 3\n"}, "(gears.yaml, line 1): is not a mapping of keys"),
        ({"gears": GEARS + "  wheel: {}\n"}, "gears.wheel (gears.yaml, line 5): is given twice, in line 4"),
        ({"gears": GEARS + "]"}, "YAML syntax (gears.yaml, line 5)"),
        (
            {"gears": GEARS + "shfts: {}\n"},
            "shfts (gears.yaml, line 5): is an unknown key; did you mean shafts?",
        ),
    ],
)
def test_what_cannot_be_included_is_refused_with_file_and_line(files, changes, words):
    found = problems_of(files(**changes))
    assert any(words in problem for problem in found), found
    assert len(found) == 1 or "drives" in str(changes), found


def test_two_variants_are_one_problem(files, tmp_path):
    """Files that define the same parts exclude each other; names that only differ in a part do not."""
    four = GEARS + "".join(
        f"  {n}: {{number_of_teeth: 30, normal_module: 3 mm, face_width: 9 mm}}\n" for n in "cd"
    )
    [found] = problems_of(files(gears=four, other=four, model=MAIN.replace("gears.y", "other.yaml, gears.y")))
    assert found == (
        "gears.pinion (gears.yaml, line 3): is given twice, also in other.yaml, line 3; so are gears.wheel, "
        "gears.c and 1 other of these two files; include one of them only"
    )


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"include": "gears.yml"}, "include (--set): 'gears.yml' names a file that does not exist"),
        ({"include": 3}, "include (--set): 3 is not a list of files; write [gears.yaml]"),
        ({"includ": "gears.yaml"}, "includ (--set): is an unknown key; did you mean include?"),
    ],
)
def test_an_include_of_an_option_names_the_option(files, changes, words):
    file = files()
    with pytest.raises(ModelError) as found:
        loads_model(MAIN, file=str(file), changes=changes, options=dict.fromkeys(changes, "--set"))
    [problem] = found.value.problems
    assert words in str(problem)


def test_include_is_among_the_keys_of_a_file(files):
    [found] = problems_of(files(model=MAIN + "zzz: 3\n"))
    assert "allowed are include, title" in found


def test_files_beside_the_folder_of_the_model(files, tmp_path):
    file = files(gears="include: ../common/teeth.yaml\n")
    (tmp_path.parent / "common").mkdir()
    teeth = tmp_path.parent / "common" / "teeth.yaml"
    teeth.write_text(GEARS, encoding="utf-8")
    assert load_model(file).origin.files == ("gears.yaml", "../common/teeth.yaml", "drives/loads.yaml")
    teeth.write_text(GEARS.replace("40,", "40 mm,"), encoding="utf-8")
    assert any("(../common/teeth.yaml, line 4)" in problem for problem in problems_of(file))


def test_a_name_that_begins_with_dots_is_in_the_folder(files, tmp_path):
    file = files(
        model=MAIN.replace("gears.yaml", "..parts.txt"), **{"drives/loads": LOADS.partition("\n")[2]}
    )
    (tmp_path / "..parts.txt").write_text(GEARS, encoding="utf-8")
    assert load_model(file).origin.files == ("..parts.txt", "drives/loads.yaml")


def test_a_file_that_is_too_large_is_not_read_whole(files, tmp_path, monkeypatch):
    monkeypatch.setattr(files_of_models, "MAX_BYTES", 2_000_000)
    with (tmp_path / "zeros.yaml").open("wb") as stream:
        stream.truncate(50_000_000)
    tracemalloc.start()
    with pytest.raises(ModelError, match="larger than 2 MB"):
        load_model(tmp_path / "zeros.yaml")
    assert tracemalloc.get_traced_memory()[1] < 10_000_000
    tracemalloc.stop()


def test_a_link_to_another_kind_of_file_is_refused(files, tmp_path):
    outside = tmp_path.parent / f"{tmp_path.name}-outside.txt"
    outside.write_text(GEARS)
    file = files()
    (tmp_path / "gears.yaml").unlink()
    (tmp_path / "gears.yaml").symlink_to(outside)
    assert any("is not the relative name of a model file" in problem for problem in problems_of(file))


def test_other_included_files(files, tmp_path):
    """`include` is set like any other key, also in a file without it."""
    file = files(other=GEARS.replace("40,", "60,") + LOADS.partition("\n")[2])
    other = load_model(file, changes={"include": "other.yaml"})
    assert other.gears["wheel"].number_of_teeth == 60 and other.origin.files == ("other.yaml",)
    changes = {"include": ["other.yaml"], "parameters.m_n": "4 mm"}
    assert load_model(file, changes=changes).gears["wheel"].normal_module == 0.004
    file.write_text(MAIN.replace("include: [gears.yaml, drives/loads.yaml]\n", ""), encoding="utf-8")
    assert load_model(file, changes={"include": "other.yaml"}).gears["wheel"].number_of_teeth == 60


def test_a_result_contains_the_whole_model(files, capsys, tmp_path):
    from pitchpoint.report.stored_model import stored_model

    file = files(model=MAIN.replace("a: 60", "a: 60 rpm"))
    out = tmp_path / "out" / "run.h5"
    json_of(["run", str(file), "-s", "run", "-o", str(out), "--set", "parameters.torque=20 N m"], capsys)
    kept = stored_model(str(out))
    assert kept.parameters["torque"].value == "20 N m" and kept.loads["drive"].torque.value == 20.0
    json_of(["run", str(file), "-s", "run", "-o", str(out)], capsys)
    assert content_hash(stored_model(str(out))) == content_hash(load_model(file))
    found = json_of(["check", str(file)], capsys)
    assert found["included"] == ["gears.yaml", "drives/loads.yaml"]
    assert json.dumps(found["parameters"]["torque"]) == json.dumps(
        {"written": "50 N m", "value": 50.0, "unit": "N m", "text": ""}
    )


def test_a_removed_include_is_one_problem_with_the_files_that_have_the_names(files):
    main = MAIN.replace("include: [gears.yaml, drives/loads.yaml]\n", "").replace("20 mm", "width")
    text = main + "loads: {drive: {body: a, torque: torque}, brake: {body: wheel_seat, torque: 2*torque}}\n"
    more = GEARS + "bodies: {wheel_seat: {inertia: 1 kg m^2}}\nparameters: {torque: 50 N m}\n"
    file = files(model=text, gears=more)
    (problem,) = problems_of(file)
    assert problem.startswith("include (line 1): ")
    assert (
        "is missing: 7 problems are names that this model does not define, and that gears.yaml has" in problem
    )
    assert problem.endswith("write include: [gears.yaml]")
    files(model=text, gears=more, variant=more)
    (problem,) = problems_of(file)
    assert "each of gears.yaml and variant.yaml has" in problem
    assert problem.endswith("write include: [gears.yaml], or another of them")


def test_a_complete_model_in_the_same_folder_is_no_missing_file(files):
    main = MAIN.replace("include: [gears.yaml, drives/loads.yaml]\n", "")
    other = main + GEARS
    assert not any(p.startswith("include") for p in problems_of(files(model=main, gears=other)))


def test_files_without_the_names_are_not_parsed(files, monkeypatch):
    """A folder may have many large files, each half a second."""
    main = MAIN.replace("include: [gears.yaml, drives/loads.yaml]\n", "")
    file = files(model=main, gears="loads: {pinion: {body: a, torque: 1 N m}}\n")
    monkeypatch.setattr(missing_include, "Tree", None)
    assert not any(p.startswith("include") for p in problems_of(file))
