# SPDX-License-Identifier: Apache-2.0
"""Bevel gears: macro-geometry, pairs, teeth, blanks, meshes of triangles, problems."""
