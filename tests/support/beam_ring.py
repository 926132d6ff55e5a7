# SPDX-License-Identifier: Apache-2.0
"""A ring of straight beam elements: another model of a flexible rim."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.structure import Member, Structure, beam_frame


def beam_ring(radius: float, height: float, width: float, count: int, E: float = 206e9) -> Structure:
    """Ring of `count` beams in the plane z = 0, the first node on the x axis; steel."""
    theta = math.tau * np.arange(count) / count
    places = np.column_stack([radius * np.cos(theta), radius * np.sin(theta), 0.0 * theta])
    beam = Beam(section=rectangle(height, width), length=1.0, E=E, G=E / 2.6, rho=7830.0)
    outwards = places / radius
    members = [
        Member((k, (k + 1) % count), beam, tuple(outwards[k] + outwards[(k + 1) % count]))
        for k in range(count)
    ]
    return beam_frame(places, members)
