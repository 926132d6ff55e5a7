# SPDX-License-Identifier: Apache-2.0
"""Matrices of other programs: every format gives the same numbers; damaged files are refused."""

from __future__ import annotations

import gzip

import numpy as np
import pytest
from scipy.io import mmwrite
from scipy.sparse import coo_array

from pitchpoint.core.errors import ModelError
from pitchpoint.multibody.square_matrix import read_square

A = np.array([[4.0, -1.5e-3, 0.0], [-1.5e-3, 2e8, 1.0], [0.0, 1.0, 3.0]])


def test_every_format_gives_the_same_matrix(tmp_path):
    np.savetxt(tmp_path / "a.csv", A, delimiter=",", header="x, y, z")
    (tmp_path / "b.csv").write_text("".join(";".join(map(repr, map(float, row))) + ";\n\n" for row in A))
    np.savetxt(tmp_path / "a.txt", A)
    np.save(tmp_path / "a.npy", A)
    np.savez(tmp_path / "a.npz", K=A)
    mmwrite(tmp_path / "a.mtx", coo_array(A), symmetry="symmetric")
    (tmp_path / "b.mtx.gz").write_bytes(gzip.compress((tmp_path / "a.mtx").read_bytes()))
    for file in sorted(tmp_path.iterdir()):
        np.testing.assert_allclose(read_square(file), A, rtol=1e-15, err_msg=file.name)


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.csv", b"1, 2\n3, x\n", "(line 2): is not a row of numbers"),
        ("a.csv", b"1, 2\n3\n", "(line 2): has 1 numbers, the first row 2; give every row"),
        ("a.csv", b"1, 2\n", "is not a square matrix: 1 x 2"),
        ("a.csv", b"", "is not a square matrix"),
        ("a.csv", b"1, nan\n3, 4\n", "has entries that are not finite"),
        ("a.npy", b"\x93NUMPY nothing", "cannot be read"),
        ("a.npz", b"PK nothing", "cannot be read"),
        ("a.mtx", b"%%MatrixMarket nothing\n", "is not a Matrix Market file"),
        ("a.xls", b"1", "is not a file with a matrix (.csv, .txt, .mtx, .mtx.gz, .npy or .npz)"),
    ],
)
def test_damaged_files_are_refused(tmp_path, name, content, words):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(ModelError) as caught:
        read_square(tmp_path / name)
    assert words in str(caught.value)


def test_archives_with_several_or_executable_arrays_are_refused(tmp_path):
    np.savez(tmp_path / "two.npz", K=A, M=A)
    with pytest.raises(ModelError, match="has 2 arrays"):
        read_square(tmp_path / "two.npz")
    np.save(tmp_path / "object.npy", np.array([print, print], dtype=object), allow_pickle=True)
    with pytest.raises(ModelError, match="cannot be read"):
        read_square(tmp_path / "object.npy")
