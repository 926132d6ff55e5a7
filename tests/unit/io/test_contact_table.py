# SPDX-License-Identifier: Apache-2.0
"""Files of contact tables: what is written is read, and anything else is refused with a sentence."""

from __future__ import annotations

import dataclasses
import io
import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

from pitchpoint.contact.potential_axes import TableAxis
from pitchpoint.contact.potential_build import NominalValues, build_potential_table
from pitchpoint.contact.potential_fit import PotentialTable, fit_potential
from pitchpoint.contact.potential_range import TableRange
from pitchpoint.contact.potential_table import MAX_QUANTITIES
from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import package_version
from pitchpoint.elements.mesh.record import RECORD
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.io.contact_table import (
    LARGEST_FILE,
    SUFFIX,
    ContactTableError,
    StaleTableError,
    read_contact_table,
    write_contact_table,
)
from pitchpoint.io.sealed_file import sealed, unsealed
from pitchpoint.io.target import OutputError

GEAR = CylindricalGear(z=17, m_n=1e-3, b=0.01)
INPUTS = {
    "gears": [GEAR, dataclasses.replace(GEAR, z=43)],
    "relief": {"tip": np.array([1e-5, 2e-5]), "root": None},
    "material": {"E": 2.06e11, "nu": 0.3},
    "options": {"foundation": "half plane", "slices": 21, "coupled": True},
}


def small_table() -> PotentialTable:
    """A table with all axes, two further quantities and errors."""
    places = (
        TableAxis("phase", np.array([0.0, 0.2, 0.55, 0.8]), True, 1.0),
        TableAxis("approach", np.linspace(-1e-5, 4e-5, 6)),
        TableAxis("misalignment", np.array([-1e-3, 0.0, 1e-3]), True),
        TableAxis("centre_distance", np.array([0.1]), True, tolerance=1e-5),
    )
    s, x, kappa, _ = np.meshgrid(*(axis.points for axis in places), indexing="ij")
    V, c = x - 2e-6 * np.sin(2 * np.pi * s) + 1e-3 * kappa, 2e8
    up = c * np.maximum(V, 0.0)
    columns = [0.5 * up**2 / c, -4e-6 * np.pi * np.cos(2 * np.pi * s) * up, up, 1e-3 * up, 0.1 * up]
    values = np.stack([*columns, 0.03 * up, up * s], -1)
    table = fit_potential(places, values, {"loss": "m", "friction": "1"})
    return dataclasses.replace(
        table, errors={"force": (1e-4, 2.5e-3, 1.1), "tilting_moment": (0.0, 0.0, 0.0)}
    )


def both(front: PotentialTable) -> dict[str, PotentialTable]:
    """Tables of both flanks; that of the back has an axis and a quantity less."""
    return {"front": front, "back": PotentialTable.of_spring(1e8, 0.0, 3e-5)}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return write_contact_table(tmp_path / f"pair{SUFFIX}", both(small_table()), INPUTS)


def test_a_written_table_is_read(file: Path) -> None:
    table, found = small_table(), read_contact_table(file, INPUTS)
    front = found.tables["front"]
    assert np.array_equal(front.coefficients, table.coefficients)
    assert np.array_equal(front.ratios, table.ratios.astype(np.float32))
    assert front.errors == table.errors
    assert list(front.quantities.items()) == [("loss", "m"), ("friction", "1")]
    assert [axis.name for axis in front.axes] == [axis.name for axis in table.axes]
    assert np.array_equal(found.tables["back"].packed, both(table)["back"].packed)
    assert list(found.tables) == ["front", "back"]
    assert found.version == package_version()
    assert found.created.startswith("20")
    assert found.inputs["options"] == INPUTS["options"]
    assert read_contact_table(file).inputs == found.inputs
    assert sorted(p.name for p in file.parent.iterdir()) == [file.name]


def test_tables_of_other_inputs_are_refused_by_name(file: Path) -> None:
    for change, words in (
        ({"gears": [GEAR, dataclasses.replace(GEAR, z=44)]}, "gears.1.z is 44, was 43"),
        ({"relief": {"tip": np.array([1e-5, 2.1e-5]), "root": None}}, "relief.tip.2.1 is 2.1e-05, was 2e-05"),
        ({"relief": {"tip": np.array([1e-5]), "root": None}}, "relief.tip.1.0 is 1, was 2"),
        ({"material": {"E": 2.06e11}}, "material.nu is missing, was 0.3"),
        ({"spall": 3.0}, "spall is 3.0, was missing"),
    ):
        with pytest.raises(StaleTableError, match=words) as caught:
            read_contact_table(file, {**INPUTS, **change})
        assert str(file) in str(caught.value)
        assert "compute the table again" in str(caught.value)
    with pytest.raises(StaleTableError, match=r"and 3 more; compute") as caught:
        read_contact_table(file, {**INPUTS, "options": dict.fromkeys("abc", 1.0)})
    assert len(caught.value.differences) == 6
    assert caught.value.differences["options.a"] == (None, 1.0)
    assert caught.value.differences["options.slices"] == (21, None)


def test_an_older_table_is_replaced_and_other_files_are_not(file: Path, tmp_path: Path) -> None:
    other = dataclasses.replace(small_table(), errors={})
    write_contact_table(file, both(other), {"z": 1})
    assert read_contact_table(file, {"z": 1}).tables["front"].errors == {}
    text = tmp_path / "notes.txt"
    text.write_text("mine")
    with pytest.raises(OutputError, match="exists and is not a readable contact table"):
        write_contact_table(text, both(other), INPUTS)
    assert text.read_text() == "mine"
    with pytest.raises(OutputError):
        write_contact_table(tmp_path, both(other), INPUTS)


def test_a_failed_write_leaves_the_older_table(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = file.read_bytes()

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OutputError, match="No space left"):
        write_contact_table(file, both(small_table()), {"z": 2})
    assert file.read_bytes() == before
    assert [p.name for p in file.parent.iterdir()] == [file.name]


def test_missing_empty_and_other_files(tmp_path: Path) -> None:
    name = tmp_path / "pair.gcp.h5"
    with pytest.raises(ContactTableError, match="there is no such contact table"):
        read_contact_table(name)
    with pytest.raises(ContactTableError, match="cannot be read"):
        read_contact_table(tmp_path)
    for contents in (b"", b"text", sealed(b"text"), b"\x89HDF\r\n\x1a\n", sealed(b"\x89HDF\r\n\x1a\n")):
        name.write_bytes(contents)
        with pytest.raises(ContactTableError, match=r"is not a contact table.*compute it again"):
            read_contact_table(name)
    with name.open("wb") as hollow:
        hollow.truncate(LARGEST_FILE + 1)
    with pytest.raises(ContactTableError, match="is not read; compute a smaller table"):
        read_contact_table(name)


def changed(file: Path, change: Callable[[h5py.File], Any]) -> Path:
    """The file with a change inside and a valid checksum."""
    contents = io.BytesIO(bytes(unsealed(file.read_bytes()) or b""))
    with h5py.File(contents, "r+") as inside:
        change(inside)
    file.write_bytes(sealed(contents.getvalue()))
    return file


def replaced(name: str, value: Any, **options: Any) -> Callable[[h5py.File], None]:
    """Change of one array."""

    def change(inside: h5py.File) -> None:
        group = inside if name == "description" else inside["front"]
        del group[name]
        group.create_dataset(name, data=value, **options)

    return change


def described(change: Callable[[dict[str, Any]], Any]) -> Callable[[h5py.File], None]:
    """Change of the description."""

    def apply(inside: h5py.File) -> None:
        data = json.loads(inside["description"][()])
        change(data)
        replaced("description", np.bytes_(json.dumps(data).encode()))(inside)

    return apply


def version(text: Any) -> Callable[[h5py.File], None]:
    """Change of the version of the format."""
    return lambda inside: inside.attrs.__setitem__("format", text)


def of_front(change: Callable[[dict[str, Any]], Any]) -> Callable[[h5py.File], None]:
    """Change of the description of the table of the front flank."""
    return described(lambda data: change(data["tables"]["front"]))


def bomb(inside: h5py.File) -> None:
    """Arrays of 10^13 values without contents, as large as axes of 2048 points require."""
    for name, points in (("phase", np.arange(2048) / 2048.0), ("approach", np.arange(2048.0))):
        replaced(name, points)(inside)
    del inside["front/coefficients"]
    inside["front"].create_dataset("coefficients", (4096, 2048, 1024, 1024), "f8", chunks=(64, 64, 4, 4))


def linked(inside: h5py.File) -> None:
    del inside["front/phase"]
    inside["front/phase"] = h5py.ExternalLink("other.h5", "/phase")


def elsewhere(inside: h5py.File) -> None:
    del inside["front/phase"]
    inside["front"].create_dataset("phase", (4,), "f8", external=[("/dev/zero", 0, 32)])


def large(inside: h5py.File) -> None:
    """Axes within their limits, a table beyond its own."""
    for name in ("phase", "approach", "misalignment"):
        replaced(name, np.arange(300.0) / (300.0 if name == "phase" else 1.0))(inside)
    del inside["front/coefficients"]
    inside["front"].create_dataset("coefficients", (600, 300, 599, 2), "f8", chunks=(4, 4, 4, 2))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            lambda f: f.attrs.__setitem__("format", "gear-contact-potential-1"),
            "has the version 1 of the format, not 3",
        ),
        (lambda f: f.attrs.__setitem__("format", "pitchpoint-1"), "another format"),
        (lambda f: f.attrs.__delitem__("format"), "another format"),
        (lambda f: f.attrs.__setitem__("format", np.zeros(3)), "another format"),
        (lambda f: f.__delitem__("front/ratios"), "ratios"),
        (lambda f: f["front/coefficients"].__setitem__((0, 0, 0, 0), np.nan), "not finite"),
        (lambda f: f["front/coefficients"].__setitem__((0, 3, 0, 0), np.inf), "not finite"),
        (lambda f: f["front/coefficients"].__setitem__((0, 0, 0, 0), 1.0), "begin in contact"),
        (lambda f: f["front/ratios"].__setitem__((0, 0, 0, 0, 0), -np.inf), "not finite"),
        (lambda f: f["front/approach"].__setitem__(2, np.nan), "finite"),
        (lambda f: f["front/approach"].__setitem__(2, 1.0), "do not increase"),
        (lambda f: f["front/approach"].__setitem__(5, 1e300), "too uneven"),
        (lambda f: f["front/phase"].__setitem__(0, -0.1), "not one period"),
        (replaced("coefficients", np.zeros((8, 6, 5, 2), "f4")), "type float32"),
        (replaced("coefficients", np.zeros((8, 6, 5, 2), "i8")), "type int64"),
        (replaced("coefficients", np.zeros((8, 6, 5))), "has the shape"),
        (replaced("ratios", np.zeros((0, 4, 6, 3, 1))), "has the shape"),
        (replaced("phase", 0.0), "too small|has the shape"),
        (replaced("phase", np.zeros(1)), "too small"),
        (replaced("approach", np.zeros(0)), "too small|limit|finite"),
        (replaced("misalignment", np.array([b"a", b"b", b"c"])), "type"),
        (replaced("description", np.zeros(4)), "not a text"),
        (replaced("description", np.bytes_(b"{")), "is not a contact table"),
        (replaced("description", np.bytes_(b"[" * 100000)), "is not a contact table"),
        (replaced("description", np.bytes_(b"[1, 2]")), "is not a contact table"),
        (lambda f: f.move("front/phase", "phase"), "phase"),
        (lambda f: f.move("back", "rear"), "back"),
        (lambda f: f.__delitem__("back") or f.__setitem__("back", np.zeros(3)), "is not a contact table"),
        (lambda f: f.__delitem__("back") or f.__setitem__("back", h5py.SoftLink("/front")), "is a link"),
        (described(lambda d: d["tables"].pop("back")), "back"),
        (of_front(lambda d: d["axes"].pop()), "is not a contact table"),
        (of_front(lambda d: d["axes"][0].update(doubled=1)), "options of the axis phase"),
        (of_front(lambda d: d["axes"][3].update(tolerance=-1.0)), "tolerance"),
        (
            of_front(lambda d: d["axes"][3].update(tolerance=float("nan"))),
            "options of the axis",
        ),
        (of_front(lambda d: d["errors"].update(force=[1.0, 2.0])), "measured errors"),
        (
            of_front(lambda d: d["errors"].update(force=[1.0, 2.0, float("nan")])),
            "measured errors",
        ),
        (
            of_front(lambda d: d["errors"].update(force=[1.0, -2.0, 3.0])),
            "measured errors",
        ),
        (
            of_front(lambda d: d["errors"].update(force=[1.0, True, 3.0])),
            "measured errors",
        ),
        (
            of_front(lambda d: d.update(quantities=[["a", 1], ["b", "m"]])),
            "further quantities",
        ),
        (of_front(lambda d: d.update(quantities=[["loss", "m"]])), "has the shape"),
        (described(lambda d: d["inputs"].update(z=3)), "differ from their checksum"),
        (described(lambda d: d.pop("inputs")), "inputs"),
        (bomb, "points .limit"),
        (large, "values .limit"),
        (linked, "is a link to somewhere else"),
        (elsewhere, "is stored in another file"),
    ],
)
def test_wrong_contents_with_a_valid_checksum(file: Path, change, words) -> None:
    with pytest.raises(ContactTableError, match=words) as caught:
        read_contact_table(changed(file, change))
    assert str(file) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_nothing_that_is_not_finite_becomes_a_table() -> None:
    table = small_table()
    with pytest.raises(ModelError, match="not finite"):
        dataclasses.replace(table, coefficients=table.coefficients * np.nan)
    with pytest.raises(ModelError, match="is not the shape"):
        dataclasses.replace(table, ratios=table.ratios[:1])
    with pytest.raises(ModelError, match="errors.*not finite"):
        dataclasses.replace(table, errors={"force": (float("nan"), 1.0, 1.0)})


def of_quantities(count: int) -> PotentialTable:
    """A table with further quantities, all zero."""
    table = PotentialTable.of_spring(1e8, 0.0, 3e-5)
    names = {f"pair_force_{k}": "1" for k in range(count)}
    return dataclasses.replace(table, ratios=np.zeros((count, 8, 6, 1, 1)), quantities=names)


def test_every_table_that_can_be_written_can_be_read_and_evaluated(tmp_path: Path) -> None:
    """As many quantities as the scratch of a mesh holds; more are refused when made and when read."""
    most = of_quantities(MAX_QUANTITIES)
    assert RECORD["gcp_ratios"].shape == (3, MAX_QUANTITIES)
    file = write_contact_table(tmp_path / f"pair{SUFFIX}", both(most), INPUTS)
    assert np.array_equal(read_contact_table(file).tables["front"].packed, most.packed)
    words = rf"{MAX_QUANTITIES + 1} is too large a number.*limit <= {MAX_QUANTITIES}.; use flexible contact"
    with pytest.raises(ModelError, match=words):
        of_quantities(MAX_QUANTITIES + 1)
    larger = np.zeros((MAX_QUANTITIES + 1, 8, 6, 1, 1), "f4")
    changed(file, replaced("ratios", larger))
    changed(file, of_front(lambda d: d["quantities"].append(["one more", "1"])))
    with pytest.raises(ContactTableError, match=words) as caught:
        read_contact_table(file)
    assert str(file) in str(caught.value)


def test_too_many_quantities_are_refused_before_they_are_computed() -> None:
    names = {f"pair_force_{k}": "1" for k in range(MAX_QUANTITIES + 1)}
    with pytest.raises(ModelError, match="is too large a number of further quantities"):
        build_potential_table(None, TableRange((0.0, 3e-5)), NominalValues(1e3, 0.01, 0.02), None, names)
