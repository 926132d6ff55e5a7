# SPDX-License-Identifier: Apache-2.0
"""For any REXS file the import returns a model that reads back, or raises a `ModelError`."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.rexs.reading import read_rexs
from pitchpoint.io.yaml_model import loads_model
from tests.support.rexs_files import GEARBOX, as_json, bevel_unit, rexs, unit
from tests.support.rexs_samples import needs_samples, sample

JSON = as_json(GEARBOX)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("rexs")


def imported(data: bytes, folder: Path) -> None:
    """Import a file; only a model error with at least one problem is permitted."""
    path = folder / "unit.rexs"
    path.write_bytes(data)
    try:
        found = import_rexs(path)
    except ModelError as error:
        assert error.problems
        assert all(str(problem).strip() for problem in error.problems)
        return
    assert loads_model(found.text()) == found.model


def damaged(draw: st.DrawFn, data: bytes) -> bytes:
    """A file cut off, with bytes replaced, a piece removed or repeated."""
    begin = draw(st.integers(0, len(data) - 1))
    end = min(len(data), begin + draw(st.integers(0, 60)))
    how = draw(st.sampled_from(["cut", "bytes", "without", "twice", "swap"]))
    if how == "cut":
        return data[:begin]
    if how == "bytes":
        return data[:begin] + draw(st.binary(max_size=6)) + data[end:]
    if how == "without":
        return data[:begin] + data[end:]
    if how == "twice":
        return data[:end] + data[begin:]
    digit = draw(st.sampled_from([b"0", b"-1", b"1e9", b"9e999", b"nan", b"'", b"<", b"]", b"true"]))
    return data[:begin] + digit + data[begin + 1 :]


@st.composite
def damaged_files(draw: st.DrawFn) -> bytes:
    text = draw(st.sampled_from([GEARBOX, JSON]))
    data = damaged(draw, text.encode())
    if not draw(st.booleans()):
        return data
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("unit.rexs", data)
    return damaged(draw, packed.getvalue()) if draw(st.booleans()) else packed.getvalue()


@given(damaged_files())
def test_damaged_files(folder: Path, data: bytes) -> None:
    imported(data, folder)


NUMBERS = st.one_of(
    st.floats(allow_nan=False, allow_infinity=False),
    st.integers(-3, 200),
    st.sampled_from([0, -0.0, 1e-300, 1e20, -5, 1e9]),
)


@st.composite
def odd_units(draw: st.DrawFn) -> str:
    """A gear unit with values replaced or removed, and with relations removed or between other parts."""
    parts, relations, cases = draw(st.sampled_from([unit, bevel_unit]))()
    for _ in range(draw(st.integers(1, 3))):
        number = draw(st.sampled_from(sorted(parts)))
        kind, values = parts[number]
        changed: dict[str, Any] = dict(values)
        if not changed:
            continue
        key = draw(st.sampled_from(sorted(changed)))
        if draw(st.integers(0, 3)) == 0:
            del changed[key]
        elif isinstance(changed[key], list):
            changed[key] = draw(st.lists(NUMBERS, min_size=2, max_size=4))
        elif isinstance(changed[key], bool):
            changed[key] = not changed[key]
        elif isinstance(changed[key], str):
            changed[key] = draw(st.sampled_from(["no_direction", "positive", "6206", "NU 206", "", "?"]))
        elif key != "reference_component_for_position":
            changed[key] = draw(NUMBERS)
        parts[number] = kind, changed
    for _ in range(draw(st.integers(0, 2))):
        k = draw(st.integers(0, len(relations) - 1))
        kind, roles = relations.pop(k)
        if draw(st.booleans()):
            role = draw(st.sampled_from(sorted(roles)))
            relations.append((kind, {**roles, role: draw(st.sampled_from(sorted(parts)))}))
    return rexs(parts, relations, cases)


@given(odd_units())
def test_gear_units_with_odd_values_and_relations(folder: Path, text: str) -> None:
    imported(text.encode(), folder)


@needs_samples
@given(st.data())
def test_damaged_samples_are_read_or_refused(folder: Path, data: st.DataObject) -> None:
    names = ["FVA_worm_stage_1-4.rexs", "example_json.rexs.zip", "example_xml.rexs.zip"]
    whole = sample(data.draw(st.sampled_from(names))).read_bytes()

    @st.composite
    def damage(draw: st.DrawFn) -> bytes:
        return damaged(draw, whole)

    path = folder / "sample.rexs"
    path.write_bytes(data.draw(damage()))
    try:
        read_rexs(path)
    except ModelError as error:
        assert error.problems
