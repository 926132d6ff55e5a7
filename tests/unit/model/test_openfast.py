# SPDX-License-Identifier: Apache-2.0
"""Files of AeroDyn: what is read, and a sentence with file and line for what is not."""

from __future__ import annotations

import random
import shutil
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.model.openfast.aerodyn import read_aerodyn, read_aerodyn_blade
from pitchpoint.model.openfast.airfoil import read_airfoil
from pitchpoint.model.openfast.beamdyn import read_beamdyn
from pitchpoint.model.openfast.elastodyn import read_elastodyn
from tests.support.rotors import AERODYN, AIRFOILS, BLADE, FOLDER, aerodyn


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """Copy of all files; the path of the primary one."""
    shutil.copytree(FOLDER, tmp_path / "turbine")
    return tmp_path / "turbine" / "onshore" / "AeroDyn.dat"


def test_blade_and_airfoils_of_the_nrel_5mw() -> None:
    found = aerodyn()
    blade = found.blade
    assert (len(blade.span), blade.length, blade.chord[4], len(blade.polars)) == (19, 61.4999, 4.557, 8)
    assert np.degrees(blade.twist[5]) == pytest.approx(11.48)
    assert blade.polars[blade.polar_index[-1]].name == "NACA64_A17"
    assert blade.prebend[5] == pytest.approx(-0.11573354)
    assert blade.polars[6].at(np.radians(-4.2))[0] == pytest.approx(0.0, abs=0.01)  # zero lift of the DU 21
    assert found.flow.skewed_wake and found.flow.drag_in_axial_induction and found.flow.density == 1.225
    assert found.flow.tower is not None and found.flow.tower.radius_at(0.0) == 3.0


def test_files_of_version_4(copy: Path) -> None:
    """Wake_Mod, UA_Mod, Skew_Mod: other names of the same options."""
    text = copy.read_text()
    text = text.replace("2   WakeMod ", "1   Wake_Mod").replace("2   AFAeroMod", "0   UA_Mod")
    text = text.replace("2   SkewMod ", "0   Skew_Mod").replace('"default"     AirDens', "1.2  AirDens")
    copy.write_text(text.replace("True          TanInd", "False         TanInd"))
    found = read_aerodyn(copy)
    assert not found.flow.skewed_wake and not found.flow.tangential_induction
    assert found.flow.density == 1.2 and not found.notes


@pytest.mark.parametrize(
    ("file", "old", "new", "expected"),
    [
        ("main", "8   NumAFfiles", "9   NumAFfiles", "NumAFfiles"),
        (
            "main",
            "8   NumAFfiles",
            "x   NumAFfiles",
            "NumAFfiles (AeroDyn.dat, line 49): 'x' is not a number",
        ),
        (
            "main",
            "Airfoils/DU40_A17.dat",
            "Airfoils/DU41.dat",
            "DU41.dat (AeroDyn.dat, line 52): cannot be read: No such file",
        ),
        ("main", "2   WakeMod", "3   WakeMod", "3 is the free vortex wake, which is not available"),
        (
            "main",
            "ADBlFile(1)",
            "ADBlFile(4)",
            "is cut off, or of another version than a primary file of AeroDyn v15: it has no ADBlFile(1)",
        ),
        ("main", "True          TipLoss", "maybe         TipLoss", "'True or False'"),
        ("main", '"default"     AirDens', "-1.0          AirDens", "-1 kg/m^3 is out of range (limit > 0)"),
        ("main", "8.5261000E+00  5.7", "0.0  5.7", "0 m does not increase (limit > 0 m)"),
        ("blade", "19   NumBlNds", "40   NumBlNds", "is the number of rows before the table ends"),
        (
            "blade",
            "4.6520000E+00        4",
            "4.6520000E+00        9",
            "BlAFID, row 6 (line 12): 9",
        ),
        ("blade", "1.0250000E+01 -1.0", "1.0250000E+00 -1.0", "does not increase"),
        (
            "blade",
            "3.8540000E+00",
            "3854",
            "BlChord, row 3 (line 9): 3854 m",
        ),
        (
            "blade",
            "1.1480000E+01",
            "114.8",
            "BlTwist, row 6 (line 12): 114.8",
        ),
        ("blade", "4.1670000E+00", "-4.16", "-4.16 m is out of range (limit > 0)"),
        ("blade", "3.8540000E+00", "3.85x", "'3.85x' is not a number"),
        ("blade", "BlTwist", "Twist", "BlTwist"),
        (
            "NACA64_A17",
            "NumAlf",
            "NumAlfa",
            "'NACA64_A17.dat' is not an airfoil file of AeroDyn v15: it has no NumAlf",
        ),
        (
            "NACA64_A17",
            "-180.00",
            "-179.00",
            "NACA64_A17.dat (AeroDyn.dat, line 57): -179 to 180 deg is the range of the angles of attack",
        ),
        ("DU21_A17", "-150.00", "-170.00", "does not increase"),
        ("DU21_A17", "142   NumAlf", "2   NumAlf", "2 is not a number of rows"),
    ],
)
def test_mistakes_are_named(copy: Path, file: str, old: str, new: str, expected: str) -> None:
    base = copy.parents[1] / "5MW_Baseline"
    names = {"main": copy, "blade": base / BLADE.name}
    path = names.get(file, base / "Airfoils" / f"{file}.dat")
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(ModelError) as error:
        read_aerodyn(copy)
    assert expected.strip("'") in str(error.value)


OTHERS = {
    "v14": "AERODYN v14.02.* INPUT FILE\nBEDDOES StallMod\n8 NumFoil\n",
    "blade": "------- AERODYN v15.00.* BLADE DEFINITION INPUT FILE ----\n19 NumBlNds\n",
    "model": "title: mine\nbodies: {}\n",
    "empty": "",
}


@pytest.mark.parametrize("kind", OTHERS)
@pytest.mark.parametrize("reader", [read_aerodyn, read_airfoil, read_beamdyn, read_elastodyn])
def test_a_file_of_another_kind_is_one_sentence(tmp_path: Path, kind: str, reader) -> None:
    file = tmp_path / "given.dat"
    file.write_text(OTHERS[kind])
    with pytest.raises(ModelError) as error:
        reader(file)
    [problem] = error.value.problems
    if kind == "empty":
        assert str(problem).startswith("'given.dat' is empty and not a")
        return
    assert str(problem).startswith("'given.dat' is not a") and ": it has no " in problem
    assert f"begins with '{OTHERS[kind].splitlines()[0].strip('- ')}'" in problem


def test_a_polar_in_radians_is_recognised(copy: Path) -> None:
    file = copy.parents[1] / "5MW_Baseline" / "Airfoils" / "DU21_A17.dat"
    lines = [
        f"{float(words[0]) * 0.0174532925} {' '.join(words[1:])}" if len(words) == 4 and k > 53 else line
        for k, line in enumerate(file.read_text().splitlines())
        for words in [line.split()]
    ]
    file.write_text("\n".join(lines))
    with pytest.raises(ModelError, match="give the angles in degrees; these seem to be in radians"):
        read_aerodyn(copy)


def test_a_cut_file_is_one_sentence(copy: Path) -> None:
    """Cut anywhere, the primary file gives one problem, or none if only comments are missing."""
    text = copy.read_text()
    for end in range(0, len(text), 97):
        copy.write_text(text[:end])
        try:
            read_aerodyn(copy)
        except ModelError as error:
            assert len(error.problems) == 1, error


def test_all_problems_at_once(copy: Path) -> None:
    base = copy.parents[1] / "5MW_Baseline" / "Airfoils"
    for name in ("DU21_A17", "DU40_A17"):
        (base / f"{name}.dat").write_bytes(b"\0\1\2")
    with pytest.raises(ModelError, match="2 problems"):
        read_aerodyn(copy)


def test_tables_of_several_reynolds_numbers(tmp_path: Path) -> None:
    one = "3 NumAlf\n-180 0 .5 0\n0 {} .5 0\n180 0 .5 0\n"
    file = tmp_path / "two.dat"
    file.write_text("2 NumTabs\n" + one.format(0.1) + one.format(0.2))
    assert read_airfoil(file, 2).at(0.0)[0] == 0.2
    with pytest.raises(ModelError, match=r"3 is not a table of the file \(limit 1 to 2\)"):
        read_airfoil(file, 3)


def test_blade_alone_needs_its_polars() -> None:
    with pytest.raises(ModelError, match=r"line 14\): 5 is not the number of an airfoil \(limit 1 to 4"):
        read_aerodyn_blade(BLADE, aerodyn().blade.polars[:4])
    with pytest.raises(ModelError, match="NumBlNds"):
        read_aerodyn_blade(AIRFOILS / "Cylinder1.dat", aerodyn().blade.polars)


@pytest.mark.parametrize("seed", range(60))
def test_damaged_files_give_a_sentence(copy: Path, seed: int) -> None:
    """Bytes changed, lines lost or doubled, files cut: read, or refused with a sentence."""
    rng = random.Random(seed)
    base = copy.parents[1] / "5MW_Baseline"
    path = rng.choice([copy, base / BLADE.name, base / "Airfoils" / "DU30_A17.dat"])
    data = bytearray(path.read_bytes())
    lines = data.split(b"\n")
    for _ in range(rng.randint(1, 4)):
        k = rng.randrange(len(lines))
        kind = rng.randrange(5)
        if kind == 0:
            del lines[k]
        elif kind == 1:
            lines.insert(k, lines[rng.randrange(len(lines))])
        elif kind == 2 and lines[k]:
            lines[k][rng.randrange(len(lines[k]))] = rng.randrange(256)
        elif kind == 3:
            lines = lines[: max(1, k)]
        else:
            lines[k] = bytearray(
                rng.choice([b"1e999", b"nan", b"-1", b'"', b"1e5 NumAlf", b"99999999999 NumBlNds"])
            )
    path.write_bytes(b"\n".join(lines))
    try:
        read_aerodyn(copy)
    except PitchpointError as error:
        assert len(str(error)) > 20


def test_missing_and_large_files(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="cannot be read"):
        read_aerodyn(tmp_path / "none.dat")
    with pytest.raises(ModelError, match="cannot be read"):
        read_airfoil(tmp_path)
    with pytest.raises(ModelError, match="NumAFfiles"):
        read_aerodyn(AIRFOILS / "Cylinder1.dat")
    assert AERODYN.exists()


TABLES = [BLADE.with_name(f"NRELOffshrBsline5MW_{n}.dat") for n in ("Blade", "Onshore_ElastoDyn_Tower")]


@settings(max_examples=80, deadline=None)
@given(
    source=st.sampled_from(TABLES),
    cut=st.floats(0.0, 2.0),
    changes=st.lists(st.tuples(st.floats(0.0, 1.0), st.binary(max_size=4), st.integers(0, 60)), max_size=3),
)
def test_damaged_files_of_elastodyn(tmp_path_factory, source, cut, changes) -> None:
    """Bytes replaced, inserted or lost, and files cut: read, or refused with a sentence."""
    path = tmp_path_factory.getbasetemp() / "elastodyn.dat"
    data = source.read_bytes()
    for place, new, lost in changes:
        k = int(place * len(data))
        data = data[:k] + new + data[k + lost :]
    path.write_bytes(data[: int(cut * len(data))] if cut < 1.0 else data)
    try:
        read_elastodyn(path)
    except PitchpointError as error:
        assert len(str(error)) > 20
