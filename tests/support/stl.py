# SPDX-License-Identifier: Apache-2.0
"""STL files as other programs write them: for tests of reading."""

from __future__ import annotations

import struct

import numpy as np


def binary(triangles, title=b"made for a test", normals=None):
    """Bytes of a binary STL file."""
    corners = np.asarray(triangles, float)
    if normals is None:
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    facets = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    facets["normal"], facets["corners"] = normals, corners
    return title.ljust(80)[:80] + struct.pack("<I", len(corners)) + facets.tobytes()


def text(triangles):
    """Text of an STL file."""
    lines = ["solid part"]
    for corners in np.asarray(triangles, float):
        n = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        lines += ["  facet normal {:e} {:e} {:e}".format(*n), "    outer loop"]
        lines += ["      vertex {:.9e} {:.9e} {:.9e}".format(*c) for c in corners]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, "endsolid part"]) + "\n"
