# SPDX-License-Identifier: Apache-2.0
"""Registries are complete, and what they list keeps to its contract."""

from __future__ import annotations

import importlib

import numpy as np
import pytest
from click import Command, Option

from pitchpoint.cli.main import COMMANDS
from pitchpoint.contact.stiffness import REGISTRY
from pitchpoint.core import status
from pitchpoint.elements.registry import FRAME, find, names
from tests.contracts.source import PACKAGE, functions, is_kernel

FIRST = ("i", "j", "ii", "ij", "ji", "jj")


def plain(dtype: np.dtype) -> bool:
    """True if a record holds nothing but int64, float64 and nested arrays of them."""
    if dtype.fields is not None:
        return all(plain(field[0]) for field in dtype.fields.values())
    return dtype.base in (np.dtype(np.int64), np.dtype(np.float64))


@pytest.mark.parametrize("name", names())
def test_element_kinds_keep_to_their_contract(name):
    kind = find(name)
    module = kind.load()
    record = module.RECORD
    assert record.isalignedstruct
    assert plain(record)
    assert record.names[:6] == FIRST if kind.channel == FRAME else record.names[:2] == FIRST[:2]
    assert record.names[-1] == "out"
    for pair in kind.pairs:
        assert set(pair) <= set(record.names)
    assert all(
        len(row) == 3 and all(isinstance(x, str) for x in row) for row in getattr(module, "OUTPUTS", ())
    )
    assert callable(module.entry)


def test_every_file_with_an_entry_is_a_registered_kind():
    modules = [find(name).module for name in names()]  # tests may have added kinds of their own
    listed = {name.rpartition(".")[2] for name in modules if name.startswith("pitchpoint.")}
    entries = {
        path.stem
        for path in (PACKAGE / "elements").glob("*.py")
        if any(name == "entry" and is_kernel(function) for name, function in functions(path))
    }
    assert entries == listed


@pytest.mark.parametrize("name", sorted(REGISTRY))
def test_stiffness_sources_can_be_found_under_their_name(name):
    source = REGISTRY[name]
    assert callable(source.function)
    assert source.summary
    assert (PACKAGE / "contact" / "stiffness" / f"{name}.py").is_file()


@pytest.mark.parametrize("name", sorted(COMMANDS))
def test_commands_can_be_found_under_their_name(name):
    function = name.replace("-", "_")
    command = getattr(importlib.import_module(f"pitchpoint.cli.{function}"), function)
    assert isinstance(command, Command)
    assert command.help
    assert all(p.help for p in command.params if isinstance(p, Option))


def test_every_status_has_a_sentence():
    codes = {n: v for n, v in vars(status).items() if n.isupper() and isinstance(v, int)}
    assert len(set(codes.values())) == len(codes)
    assert codes["DIED"] == 0
    assert codes["OK"] == 1
    assert not [n for n, v in codes.items() if "unknown" in status.sentence(v)]
