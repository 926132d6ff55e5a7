# SPDX-License-Identifier: Apache-2.0
"""STL files as other programs write them: for tests of reading."""

from __future__ import annotations

import struct

import numpy as np


def binary(triangles, title=b"made for a test", normals=None):
    """Bytes of a binary STL file."""
    data = [title.ljust(80)[:80], struct.pack("<I", len(triangles))]
    for k, corners in enumerate(np.asarray(triangles, float)):
        n = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        n = n / max(np.linalg.norm(n), 1e-300) if normals is None else normals[k]
        data.append(struct.pack("<12fH", *n, *corners.ravel(), 0))
    return b"".join(data)


def text(triangles):
    """Text of an STL file."""
    lines = ["solid part"]
    for corners in np.asarray(triangles, float):
        n = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        lines += ["  facet normal {:e} {:e} {:e}".format(*n), "    outer loop"]
        lines += ["      vertex {:.9e} {:.9e} {:.9e}".format(*c) for c in corners]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, "endsolid part"]) + "\n"
