# SPDX-License-Identifier: Apache-2.0
"""A ring of straight beam elements: another model of a flexible rim."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.structure import Structure, make_structure


def beam_ring(radius: float, height: float, width: float, count: int, E: float = 206e9) -> Structure:
    """Ring of `count` beams in the plane z = 0, the first node on the x axis; steel."""
    theta = math.tau * np.arange(count) / count
    places = np.column_stack([radius * np.cos(theta), radius * np.sin(theta), 0.0 * theta])
    n = 6 * count
    K, M = np.zeros((n, n)), np.zeros((n, n))
    section = rectangle(height, width)
    for k in range(count):
        ends = k, (k + 1) % count
        chord = places[ends[1]] - places[ends[0]]
        length = float(np.linalg.norm(chord))
        beam = Beam(section=section, length=length, E=E, G=E / 2.6, rho=7830.0)
        t = chord / length
        axes = np.column_stack([np.cross((0.0, 0.0, -1.0), t), (0.0, 0.0, -1.0), t])
        turn = np.kron(np.eye(4), axes)
        rows = np.concatenate([6 * end + np.arange(6) for end in ends])
        K[np.ix_(rows, rows)] += turn @ beam.stiffness() @ turn.T
        M[np.ix_(rows, rows)] += turn @ beam.consistent_mass() @ turn.T
    return make_structure(K, M, places)
