# SPDX-License-Identifier: Apache-2.0
"""Kinds of elements carry their traits: nothing above them knows a kind by its name."""

from __future__ import annotations

import ast
import dataclasses
import inspect
from pathlib import Path

import pytest

from pitchpoint.elements import kind as traits
from pitchpoint.elements.kind import Kind
from pitchpoint.elements.registry import find, names
from pitchpoint.model.sections import GROUPS, SECTIONS
from pitchpoint.report.scene.connections import SCHEMATICS
from tests.contracts.source import PACKAGE

OWN = tuple(name for name in names() if find(name).module.startswith("pitchpoint."))
LAYERS = ("solvers", "report", "system", "sweep")
TABLES = {"records", "names", "pools", "laws"}
"""Attributes of a system that are looked up by the name of a kind."""

#: Words that are names of kinds and mean something else in these files, with what they mean.
OTHERWISE = {
    "report/bearing_loads.py": {"force": "dimension"},
    "report/diagnosis/change_words.py": {"bearing": "class of evidence"},
    "report/diagnosis/levels.py": {"bearing": "class of evidence"},
    "report/diagnosis/many.py": {"bearing": "class of evidence"},
    "report/diagnosis/origin.py": {"bearing": "option"},
    "report/diagnosis/pictures.py": {"bearing": "class of evidence"},
    "report/diagnosis/study.py": {"bearing": "class of evidence"},
    "report/diagnosis/tables.py": {"bearing": "class of evidence", "ratio": "head of a column"},
    "report/diagnosis/words.py": {"bearing": "class of evidence"},
    "report/external_torques.py": {"drive": "key of a scenario", "torque": "dimension"},
    "report/live.py": {"damping": "key of a mesh"},
    "report/main_channels.py": {"torque": "quantity"},
    "report/power_flow.py": {
        "damping": "name of a loss",
        "coupling": "class of a link in the drawing",
        "ratio": "class of a link in the drawing",
    },
    "report/power_tables.py": {
        "bearing": "head of a column",
        "force": "dimension",
        "ratio": "head of a column",
        "torque": "dimension",
    },
    "report/rolls.py": {"force": "dimension"},
    "report/scene/curves.py": {"torque": "quantity"},
    "report/scene/bearings.py": {"bearing": "class of a solid and of an arrow in the scene"},
    "report/scene/forces.py": {"bearing": "class of an arrow in the scene"},
    "report/scene/live.py": {"bearing": "class of an arrow in the scene"},
    "report/scene/connections.py": {
        "bearing": "class of a solid in the scene",
        "bushing": "name of a schematic",
    },
    "report/scene/schematics.py": {"bearing": "class of a solid in the scene"},
    "report/section/build.py": {"torque": "dimension"},
    "report/static_power.py": {
        "drive": "key of a scenario",
        "ratio": "gear ratio",
        "torque": "quantity",
    },
    "report/scene/spectra.py": {"torque": "quantity"},
    "solvers/contact_analysis/lubrication.py": {"torque": "dimension"},
    "solvers/contact_analysis/mesh_path.py": {"torque": "quantity"},
    "solvers/contact_analysis/relief/design.py": {"torque": "quantity"},
    "solvers/contact_analysis/solve.py": {"torque": "quantity"},
    "solvers/input_places.py": {"force": "name of an input"},
    "solvers/locked_clutches.py": {"torque": "dimension"},
    "solvers/mean_balance.py": {"torque": "dimension"},
    "solvers/speed_drift.py": {"torque": "dimension"},
    "system/source.py": {"drive": "key of a scenario"},
}


def named(path: Path) -> tuple[set[str], set[str]]:
    """Names of kinds among the texts of a file: of lookups, and all others but names of record fields."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    looked_up, fields = set(), set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
            if isinstance(node.value, ast.Attribute) and node.value.attr in TABLES:
                looked_up.add(node.slice.value)
            else:
                fields.add(id(node.slice))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "get":
            table = node.func.value
            if isinstance(table, ast.Attribute) and table.attr in TABLES and node.args:
                looked_up.add(getattr(node.args[0], "value", None))
    texts = {n.value for n in ast.walk(tree) if isinstance(n, ast.Constant) and id(n) not in fields}
    return looked_up & set(OWN), (texts & set(OWN)) - looked_up


def test_no_layer_above_the_elements_names_a_kind():
    found, used = {}, {}
    for layer in LAYERS:
        for path in sorted((PACKAGE / layer).rglob("*.py")):
            file = path.relative_to(PACKAGE).as_posix()
            if file.startswith("system/rules/"):  # the only place where components and records are both known
                continue
            looked_up, others = named(path)
            used[file] = others
            wrong = looked_up | (others - set(OTHERWISE.get(file, {})))
            if wrong:
                found[file] = sorted(wrong)
    assert not found, f"read a trait (elements/kind.py) or search for a role instead: {found}"
    idle = {file: set(words) - used.get(file, set()) for file, words in OTHERWISE.items()}
    assert not {file: words for file, words in idle.items() if words}, "take these off the list"


def test_every_trait_is_described_and_read():
    page = inspect.getdoc(Kind) or ""
    source = "".join(p.read_text(encoding="utf-8") for p in PACKAGE.rglob("*.py"))
    for trait in dataclasses.fields(Kind):
        assert any(trait.name in line.split(", ") for line in page.splitlines()), trait.name
        read = source.count(f".{trait.name}") + source.count(f".{trait.name}_of(")
        assert read, f"nothing reads {trait.name}"


@pytest.mark.parametrize("name", OWN)
def test_traits_fit_each_other(name):
    kind = find(name)
    assert set(kind.sections) <= set(GROUPS)
    assert {s for s in kind.sections.values() if s} <= set(SCHEMATICS)
    assert kind.channel in (
        traits.FRAME,
        traits.COORDINATE,
        traits.CONSTRAINT,
        traits.MOTION,
        traits.FRICTION,
    )
    assert kind.scope in (traits.BETWEEN, traits.SINGLE, traits.EVERYWHERE)
    assert callable(kind.spins) or kind.spins in (traits.FREE, traits.TOGETHER, traits.GEARED, traits.HOLDS)
    assert kind.power is None or kind.power.torque.count("{}") == bool(kind.power.torque)


@pytest.mark.parametrize("section", GROUPS)
def test_rules_of_sections_exist(section):
    for rule in SECTIONS[section].rules:
        module, _, function = rule.partition(":")
        text = (PACKAGE / "system" / "rules" / f"{module}.py").read_text(encoding="utf-8")
        assert f"def {function}(places: Places)" in text
    assert set(SECTIONS[section].needs) <= set(OWN)


def imported(path: Path) -> set[str]:
    """Modules of kinds that a file imports."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module == "pitchpoint.elements":
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            package, _, module = node.module.rpartition(".")
            found |= {module} if package == "pitchpoint.elements" else set()
    return found & set(OWN)


#: Kinds that solvers write to or make themselves, by file.
MADE = {
    "solvers/equilibrium/balancing.py": {"torque"},  # balances it
    "solvers/load_cycle.py": {"torque"},  # evaluates its law over the period
    "solvers/quasistatic/loads.py": {"torque"},  # evaluates its law at a speed
    "solvers/speed_stability.py": {"torque"},  # evaluates the slope of its law
    "solvers/model_damping.py": {"damping"},  # fills it in
    # makes them
    "solvers/reduction/condensed_part.py": {"coupling", "linear_hold", "linear_modes", "linear_part"},
    "solvers/initial_state/start.py": {"drive"},  # its signals
    "solvers/initial_state/speeds.py": {"drive", "ratio"},  # their signals and coordinates
    "solvers/step_choice.py": {"drive", "ratio"},  # their signals and coordinates
    "sweep/speed.py": {"drive"},  # sets its speed
    "solvers/input_places.py": {"drive"},  # sets its speed
    "solvers/locked_clutches.py": {"friction_clutch"},  # locks it
    "solvers/initial_state/clutches.py": {"friction_clutch", "torque"},  # bends its bristles, balances it
    "solvers/torque_paths.py": {"ratio"},  # its coordinates
    "solvers/gear_trains.py": {"ratio"},  # its coordinates
}


def test_an_element_needs_four_source_files():
    """Its module, the component, the row of its section, its rule: no other file imports a kind."""
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        file = path.relative_to(PACKAGE).as_posix()
        more = imported(path) - MADE.get(file, set())
        if more and not file.startswith(("elements/", "system/rules/")):
            found[file] = sorted(more)
    assert not found, f"read a trait (elements/kind.py) or search for a role instead: {found}"


def test_a_section_of_another_package_needs_no_file_of_ours():
    """The package of tests/support/outside has an element, a section and a rule; nothing here knows it."""
    package = PACKAGE.parents[1] / "tests" / "support" / "outside" / "pitchpoint_magnets"
    assert {p.stem for p in package.glob("*.py")} == {"__init__", "element", "rule", "section"}
    assert not [p for p in PACKAGE.rglob("*.py") if "magnet" in p.read_text(encoding="utf-8").lower()]
