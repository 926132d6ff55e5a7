# SPDX-License-Identifier: Apache-2.0
"""Registries are complete, and what they list keeps to its contract."""

from __future__ import annotations

import ast

import numpy as np
import pytest
from click import Command, Option

from pitchpoint.cli.main import COMMANDS, command_of
from pitchpoint.contact.stiffness import law_function
from pitchpoint.core import status
from pitchpoint.elements.kind import CONSTRAINT, FRAME
from pitchpoint.elements.registry import find, names
from pitchpoint.model.components.stiffness import LAWS
from tests.contracts.source import PACKAGE, functions, imports_that_run, is_kernel

FIRST = ("i", "j", "ii", "ij", "ji", "jj")


#: Files that name a stiffness law for more than its registration, with what they do.
CHECKED = {
    "constant": {"system/rules/bevel_mesh.py"},  # of bevel meshes
    "din3990": {
        "model/components/gear.py",  # factor of the gear blank
        "model/components/mesh.py",  # law if none is given
        "model/remarks/keys_without_effect.py",  # keys without effect
        "system/rules/bevel_mesh.py",  # of bevel meshes
        "system/rules/stiffness.py",  # single stiffness of every mesh
    },
    "energy": {"model/remarks/keys_without_effect.py"},  # keys without effect
    "fourier": {"model/checks/gears.py"},  # range that depends on several keys
    "hertz": {
        "model/remarks/keys_without_effect.py",
        "model/checks/gears.py",
    },  # keys without effect, keys that go together
    "rectangular": {"model/checks/gears.py"},  # range that depends on several keys
    "table": {"contact/stiffness/user.py"},  # becomes one
    "user": {  # runs code
        "system/rules/gear_mesh.py",
        "system/rules/mesh_laws.py",
        "system/rules/stiffness.py",
    },
}


def imports_law(path, name):
    """Whether a file imports the class of a stiffness law, or its function."""
    law = LAWS[name].__name__
    imports = [n for n in imports_that_run(path) if isinstance(n, ast.ImportFrom)]
    classes = {a.name for n in imports if str(n.module).endswith("components.stiffness") for a in n.names}
    return law in classes or any(n.module == f"pitchpoint.contact.stiffness.{name}" for n in imports)


def plain(dtype: np.dtype) -> bool:
    """True if a record holds nothing but int64, float64 and nested arrays of them."""
    if dtype.fields is not None:
        return all(plain(field[0]) for field in dtype.fields.values())
    return dtype.base in (np.dtype(np.int64), np.dtype(np.float64))


@pytest.mark.parametrize("name", names())
def test_element_kinds_keep_to_their_contract(name):
    kind = find(name)
    record = kind.record
    assert record.isalignedstruct
    assert plain(record)
    assert record.names[:6] == FIRST if kind.channel == FRAME else record.names[:2] == FIRST[:2]
    assert record.names[-1] == "out"
    assert set(kind.ends) | set(kind.paired) | set(kind.modal) <= set(record.names)
    assert set(kind.exact) | set(kind.some) | {field for _, field in kind.some.values()} <= set(record.names)
    rows = kind.outputs_of(np.ones(1, record)[0])
    assert all(len(row) == 3 and all(isinstance(x, str) for x in row) for row in rows)
    assert callable(kind.entry)
    assert kind.rows == 0 or (kind.channel == CONSTRAINT and "row" in record.names)
    assert not kind.events or "ev" in record.names
    assert set(kind.bends_of(np.zeros(1, record)[0])) <= {event[0] for event in kind.events}


def test_every_file_with_an_entry_is_a_registered_kind():
    modules = [find(name).module for name in names()]  # tests may have added kinds of their own
    listed = {name.rpartition(".")[2] for name in modules if name.startswith("pitchpoint.")}
    entries = {
        path.stem
        for path in (PACKAGE / "elements").rglob("*.py")
        if any(name == "entry" and is_kernel(function) for name, function in functions(path))
    }
    assert entries == listed


@pytest.mark.parametrize("name", sorted(LAWS))
def test_a_stiffness_law_is_its_file_and_its_class(name):
    assert callable(law_function(name))
    assert (PACKAGE / "contact" / "stiffness" / f"{name}.py").is_file()
    own = {f"contact/stiffness/{name}.py", "model/components/stiffness.py"}
    users = {p.relative_to(PACKAGE).as_posix() for p in PACKAGE.rglob("*.py") if imports_law(p, name)}
    assert users - own == CHECKED.get(name, set())


@pytest.mark.parametrize("name", sorted(COMMANDS))
def test_commands_can_be_found_under_their_name(name):
    command = command_of(name)
    assert isinstance(command, Command)
    assert command.help
    assert all(p.help for p in command.params if isinstance(p, Option))


def test_every_status_has_a_sentence():
    codes = {n: v for n, v in vars(status).items() if n.isupper() and isinstance(v, int)}
    assert len(set(codes.values())) == len(codes)
    assert codes["DIED"] == 0
    assert codes["OK"] == 1
    assert not [n for n, v in codes.items() if "unknown" in status.sentence(v)]
