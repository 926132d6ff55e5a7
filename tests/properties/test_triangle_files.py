# SPDX-License-Identifier: Apache-2.0
"""Whatever stands in a file of triangles, triangles with their faults or a `PitchpointError` come out."""

from __future__ import annotations

import contextlib
import io

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.contact.triangles import TriangleSurface
from pitchpoint.core.errors import PitchpointError
from pitchpoint.geometry.triangle_file import Triangles, placed_triangles, read_triangles, triangle_faults
from tests.support.contacts import box
from tests.support.stl import binary, text

SURFACE = box((30.0, 20.0, 10.0), 1)
BOX = SURFACE.vertices[SURFACE.faces]
ARRAY = io.BytesIO()
np.save(ARRAY, BOX)
FORMS = {
    "stl": [binary(BOX), text(BOX).encode(), b"solid", b""],
    "npy": [ARRAY.getvalue(), b"\x93NUMPY", b""],
}
EDITS = st.lists(
    st.tuples(st.integers(0, 10**6), st.integers(0, 40), st.binary(max_size=12)), min_size=0, max_size=4
)


@given(st.sampled_from([(end, k) for end, forms in FORMS.items() for k in range(len(forms))]), EDITS)
def test_files_are_read_or_refused(tmp_path_factory, form, edits):
    end, k = form
    data = FORMS[end][k]
    for at, length, put in edits:
        at %= len(data) + 1
        data = data[:at] + put + data[at + length :]
    file = tmp_path_factory.getbasetemp() / f"fuzz.{end}"
    file.write_bytes(data)
    with contextlib.suppress(PitchpointError):
        found = read_triangles(file)
        if triangle_faults(found, 1e-3) == []:
            surface = TriangleSurface.from_triangles(placed_triangles(found, 1e-3))
            assert np.isfinite(surface.packed()).all()


@given(
    st.lists(
        st.lists(st.floats(-20, 20) | st.integers(-2, 2), min_size=9, max_size=9), min_size=1, max_size=9
    )
)
def test_what_has_no_fault_can_be_packed(numbers):
    corners = np.array(numbers, float).reshape(-1, 3, 3)
    if triangle_faults(Triangles(corners, np.zeros((len(corners), 3))), 1e-3, open_edges=True) == []:
        assert np.isfinite(TriangleSurface.from_triangles(1e-3 * corners).packed()).all()
