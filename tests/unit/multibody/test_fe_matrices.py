# SPDX-License-Identifier: Apache-2.0
"""Matrices from files: what was written comes back, what is wrong is reported with its line."""

from __future__ import annotations

import gzip

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.io import mmwrite

from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.multibody import fe_matrices
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.craig_bampton import craig_bampton
from pitchpoint.multibody.fe_matrices import read_dmig, read_npz, structure_from_dmig
from pitchpoint.multibody.matrix_market import read_matrix_market, read_parts, read_places
from pitchpoint.multibody.structure import beam_line

LINE = beam_line([Beam(section=tube(0.05), length=0.3, E=2.1e11, G=8.1e10, rho=7850.0)] * 2)


def exponent(value, digits=9):
    return f"{value:.{digits}E}".replace("E", "D")


def punch(structure, grids=True):
    """Punch file of a structure as Nastran writes it; nodes are numbered 11, 12, ..."""
    lines = ["$ written by a test", "ENDDATA_LIKE"]
    if grids:
        for k, (x, y, z) in enumerate(structure.places):
            if k % 2:
                lines.append(f"{'GRID*':8}{11 + k:16d}{'':16}{exponent(x):>16}{exponent(y):>16}")
                lines.append(f"{'*':8}{exponent(z):>16}")
            else:
                lines.append(f"{'GRID':8}{11 + k:8d}{'':8}{x:8.3f}{y:8.3f}{z:8.3f}")
    for name, matrix in (("KAAX", structure.K), ("MAAX", structure.M)):
        dense = matrix.toarray()
        lines.append(f"{'DMIG':8}{name:8}{'0':>8}{6:8d}{2:8d}{0:8d}{'':16}{structure.size:8d}")
        for c in range(structure.size):
            head = 11 + structure.node[c], structure.direction[c] + 1
            lines.append(f"{'DMIG*':8}{name:16}{head[0]:16d}{head[1]:16d}")
            for r in range(c, structure.size):
                if dense[r, c] != 0.0:
                    value = exponent(dense[r, c])
                    at = f"{11 + structure.node[r]:16d}{structure.direction[r] + 1:16d}"
                    lines.append(f"{'*':8}{at}{value:>16}")
    return "\n".join(lines) + "\n"


def test_a_punch_file_comes_back(tmp_path):
    file = tmp_path / "model.pch"
    file.write_text(punch(LINE))
    found, nodes = structure_from_dmig(read_dmig(file))
    assert nodes == [11, 12, 13]
    np.testing.assert_allclose(found.K.toarray(), LINE.K.toarray(), rtol=1e-9)  # ten digits are written
    np.testing.assert_allclose(found.M.toarray(), LINE.M.toarray(), rtol=1e-9)
    np.testing.assert_allclose(found.places, LINE.places, atol=1e-12)


def test_places_may_come_from_elsewhere(tmp_path):
    file = tmp_path / "model.pch"
    file.write_text(punch(LINE, grids=False))
    content = read_dmig(file)
    with pytest.raises(ModelError, match="grid 11: has no position; add GRID"):
        structure_from_dmig(content)
    found, _ = structure_from_dmig(content, places={11 + k: p for k, p in enumerate(LINE.places)})
    np.testing.assert_array_equal(found.places, LINE.places)
    with pytest.raises(ModelError, match="the file contains: KAAX, MAAX"):
        structure_from_dmig(content, stiffness="K2GG")


def test_small_fields_and_short_exponents(tmp_path):
    file = tmp_path / "small.pch"
    head = f"{'DMIG':8}{'KAAX':8}{'0':>8}{1:8d}{1:8d}{0:8d}{'':16}{1:8d}"
    file.write_text(f"{head}\n{'DMIG':8}{'KAAX':8}{5:8d}{2:8d}{'':8}{5:8d}{2:8d}{'-1.5+3':>8}\n")
    assert read_dmig(file).matrices["KAAX"] == {((5, 2), (5, 2)): -1500.0}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda t: t.replace("D+0", "X+0", 9), r"line \d+\).*is not a number"),
        (lambda t: t.replace("       6       2", "       6       4", 1), "is complex"),
        (lambda t: t.replace("       6       2", "       9       2", 1), "form 9"),
        (lambda t: "\n".join(x for x in t.split("\n") if "  0   " not in x[8:30]), "precedes the header"),
        (lambda t: t + t[t.index("DMIG*") : t.index("DMIG*") + 160], "is listed twice"),
        (lambda t: "GRID           1\n", "has no DMIG"),
        (lambda t: "x" * 5000, "not a text file with lines"),
        (
            lambda t: t.replace("GRID          11        ", "GRID          11       7"),
            "uses the coordinate system 7",
        ),
    ],
)
def test_punch_files_that_are_wrong(tmp_path, change, message):
    file = tmp_path / "model.pch"
    file.write_text(change(punch(LINE)))
    with pytest.raises(ModelError, match=message):
        read_dmig(file)


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_damaged_punch_files_end_in_a_sentence(tmp_path_factory, data):
    text = list(punch(LINE)[:4000])
    for _ in range(data.draw(st.integers(1, 8))):
        at = data.draw(st.integers(0, len(text) - 1))
        text[at] = data.draw(st.sampled_from("\0\n*+-.,9D$ XéDMIG"))
    file = tmp_path_factory.mktemp("fuzz") / "model.pch"
    file.write_text("".join(text), encoding="utf-8")
    try:
        structure_from_dmig(read_dmig(file))
    except PitchpointError as error:
        assert str(error)


@settings(max_examples=100, deadline=None)
@given(st.binary(max_size=400))
def test_noise_ends_in_a_sentence(tmp_path_factory, noise):
    folder = tmp_path_factory.mktemp("noise")
    readers = {"a.pch": read_dmig, "a.mtx": read_matrix_market, "a.npz": read_npz}
    for name, read in readers.items():
        file = folder / name
        file.write_bytes(noise)
        with pytest.raises(PitchpointError):
            read(file)


@pytest.mark.parametrize("symmetry", ["symmetric", "general"])
@pytest.mark.parametrize("dense", [True, False])
@pytest.mark.parametrize("packed", [True, False])
def test_matrix_market(tmp_path, symmetry, dense, packed):
    """As SciPy writes it, an implementation of its own; it writes 16 digits."""
    file = tmp_path / "k.mtx"
    mmwrite(file, LINE.K.toarray() if dense else LINE.K, symmetry=symmetry, comment=" of a test")
    if packed:
        (tmp_path / "k.mtx.gz").write_bytes(gzip.compress(file.read_bytes()))
        file = tmp_path / "k.mtx.gz"
    np.testing.assert_allclose(read_matrix_market(file).toarray(), LINE.K.toarray(), rtol=1e-14)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("%%MatrixMarket matrix coordinate real general\n3 2 1\n1 1 5.0\n", "limit square"),
        ("%%MatrixMarket matrix coordinate complex general\n1 1 1\n1 1 5.0 0.0\n", "complex"),
        ("%%MatrixMarket matrix coordinate real general\n9 9 100000\n1 1 5.0\n", "specifies 100000 entries"),
        (
            "%%MatrixMarket matrix coordinate real general\n2 2 2\n1 1 5.0\n",
            "specifies 2 entries, but it has 1x3",
        ),
        ("%%MatrixMarket matrix coordinate real general\n2 2 1\n7 1 5.0\n", "entry 1 has the indices 7, 1"),
        ("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 1 nan\n", "not finite|cannot be read"),
        ("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 one 5.0\n", "cannot be read.*'one'"),
        ("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 1 5.0\n1 2 5.0\n", "specifies 1 entries"),
        ("%%MatrixMarket matrix coordinate real general\n2 2\n", "no line of 3 sizes"),
        ("K\n1 1 1\n", "not a Matrix Market file"),
    ],
)
def test_matrix_market_files_that_are_wrong(tmp_path, text, message):
    file = tmp_path / "k.mtx"
    file.write_text(text)
    with pytest.raises(ModelError, match=message):
        read_matrix_market(file)


@pytest.mark.parametrize("dense", [True, False])
def test_numpy_archive(tmp_path, dense):
    file = tmp_path / "body.npz"
    if dense:
        np.savez(file, K=LINE.K.toarray(), M=LINE.M.toarray(), places=LINE.places)
    else:
        both = {"K": LINE.K, "M": LINE.M}
        names = ("data", "indices", "indptr")
        parts = {f"{name}_{p}": getattr(m, p) for name, m in both.items() for p in names}
        np.savez(file, places=LINE.places, node=LINE.node, direction=LINE.direction, **parts)
    found = read_npz(file)
    np.testing.assert_allclose(found.K.toarray(), LINE.K.toarray())
    np.testing.assert_array_equal(found.direction, LINE.direction)


def test_numpy_archives_that_are_wrong(tmp_path, monkeypatch):
    file = tmp_path / "body.npz"
    np.savez(file, K=np.eye(6), M=np.eye(6))
    with pytest.raises(ModelError, match="'places'"):
        read_npz(file)
    np.savez(file, K=np.eye(6), places=np.zeros((1, 3)))
    with pytest.raises(ModelError, match="no matrix 'M'"):
        read_npz(file)
    np.savez(file, K=np.array([object()]), M=np.eye(6), places=np.zeros((1, 3)))
    with pytest.raises(ModelError, match="plain arrays"):
        read_npz(file)
    parts = {"K_data": np.ones(1), "K_indices": np.array([99]), "K_indptr": np.array([0, 1])}
    np.savez(file, M=np.eye(1), places=np.zeros((1, 3)), **parts)
    with pytest.raises(ModelError, match="inconsistent arrays"):
        read_npz(file)
    np.savez(file, K=np.eye(6), M=np.eye(6), places=np.array(["a"]))
    with pytest.raises(ModelError, match="does not contain real numbers"):
        read_npz(file)
    monkeypatch.setattr(fe_matrices, "MAX_BYTES", 100)
    np.savez_compressed(file, K=np.zeros((50, 50)))
    with pytest.raises(ModelError, match="limit 100"):
        read_npz(file)


def parts_of(structure, folder, digits="123456"):
    """Matrices and table of nodes of a structure as three files."""
    mmwrite(folder / "k.mtx", structure.K, symmetry="symmetric")
    mmwrite(folder / "m.mtx", structure.M, symmetry="symmetric")
    lines = [f"{x:.9g}, {y:.9g} {z:.9g} {digits}  # node" for x, y, z in structure.places]
    (folder / "places.txt").write_text("% x y z in m\n\n" + "\n".join(lines) + "\n")
    return folder / "k.mtx", folder / "m.mtx", folder / "places.txt"


@pytest.mark.parametrize("digits", ["", "123456"])
def test_two_matrices_and_a_table_of_places(tmp_path, digits):
    found = read_parts(*parts_of(LINE, tmp_path, digits))
    np.testing.assert_allclose(found.K.toarray(), LINE.K.toarray(), rtol=1e-14)
    np.testing.assert_allclose(found.places, LINE.places, atol=1e-12)
    np.testing.assert_array_equal(found.direction, LINE.direction)


def test_nodes_may_differ_in_their_displacements(tmp_path):
    file = tmp_path / "places.txt"
    file.write_text("0 0 0 123\n1 2 3 4561\n")
    places, node, direction = read_places(file)
    assert places.tolist() == [[0, 0, 0], [1, 2, 3]]
    assert node.tolist() == [0, 0, 0, 1, 1, 1, 1]
    assert direction.tolist() == [0, 1, 2, 3, 4, 5, 0]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0 0 0\n1 2\n", r"line 2\).*has 2 numbers"),
        ("0 0 0\n1 2 z\n", r"line 2\).*'z' is not a number; write x y z in m"),
        ("0 0 0 123\n1 2 3\n", "only some nodes"),
        ("0 0 0 127\n", "not a list of digits"),
        ("0 0 0 113\n", "not a list of digits"),
        ("0 0 1e999\n", "not finite"),
        ("# nothing\n", "has no node"),
        ("1" * 5000, "not a node table"),
    ],
)
def test_tables_of_places_that_are_wrong(tmp_path, text, message):
    file = tmp_path / "places.txt"
    file.write_text(text)
    with pytest.raises(ModelError, match=message):
        read_places(file)


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_damaged_parts_end_in_a_sentence(tmp_path_factory, data):
    """One of the three files is damaged at a few places; what still can be read is a body or told."""
    folder = tmp_path_factory.mktemp("fuzz")
    files = parts_of(LINE, folder)
    damaged = data.draw(st.sampled_from(files))
    text = list(damaged.read_text())
    for _ in range(data.draw(st.integers(1, 6))):
        at = data.draw(st.integers(0, len(text) - 1))
        text[at] = data.draw(st.sampled_from("\0\n%#+-.,;9e5 Xé7"))
    damaged.write_text("".join(text), encoding="utf-8")
    try:
        structure = read_parts(*files)
        craig_bampton(structure, (0, 2), 4)
    except PitchpointError as error:
        assert str(error)


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_damaged_archives_end_in_a_sentence(tmp_path_factory, data):
    file = tmp_path_factory.mktemp("fuzz") / "body.npz"
    np.savez(file, K=LINE.K.toarray(), M=LINE.M.toarray(), places=LINE.places)
    content = bytearray(file.read_bytes())
    for _ in range(data.draw(st.integers(1, 4))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    file.write_bytes(bytes(content[: data.draw(st.integers(1, len(content)))]))
    try:
        read_npz(file)
    except PitchpointError as error:
        assert str(error)


def test_missing_files(tmp_path):
    for read in (read_dmig, read_matrix_market, read_npz, read_places):
        with pytest.raises(ModelError, match="file not found"):
            read(tmp_path / "none")
