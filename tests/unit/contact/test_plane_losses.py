# SPDX-License-Identifier: Apache-2.0
"""Losses of contact planes: oil film and structural damping by their formulas, friction of each plane.

Source of the film and of structural damping: Adams Machinery, "Gear Pair (Advanced 3D Contact)": film share b
= 1 - gap/(2 h), force rate v b^exponent up to b = 1, rate v beyond; structural damping as a fraction of the
elastic force with the sign of the squeeze velocity.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.film_damping import film_force, structural_share
from pitchpoint.contact.friction import static_dynamic
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.elements.mesh.surface.nodes import NODE, ON_PATH
from pitchpoint.system.rules.flank_contact import SurfaceContact
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.flank_levels import flexible
from tests.support.one_mesh import OneMesh, make_pair

RATE, H, V = 1e3, 2e-6, 0.05


@pytest.mark.parametrize("exponent", [0.5, 1.0, 2.0, 3.0])
@pytest.mark.parametrize(("gap", "b"), [(0.0, 1.0), (H, 0.5), (2.0 * H, 0.0), (-H, 1.5), (3.0 * H, -0.5)])
def test_film(exponent: float, gap: float, b: float) -> None:
    force = float(film_force(-gap, V, RATE, H, exponent)[0])
    expected = RATE * V if b >= 1.0 else RATE * V * b**exponent if b > 0.0 else 0.0
    assert force == pytest.approx(expected, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("exponent", [0.5, 1.0, 2.0])
def test_film_is_continuous_in_contact(exponent: float) -> None:
    inside, outside = (float(film_force(x, V, RATE, H, exponent)[0]) for x in (1e-14, -1e-14))
    assert inside == pytest.approx(outside, rel=1e-7)


def test_structural_damping_is_a_fraction_of_the_elastic_force() -> None:
    for sign in (1.0, -1.0):
        assert float(structural_share(sign * 1e3, 0.01, 1e-3)[0]) == pytest.approx(0.01 * sign, rel=1e-6)
    assert float(structural_share(0.0, 0.01, 1e-3)[0]) == 0.0


@pytest.mark.parametrize("level", ["rigid", "flexible"])
@pytest.mark.parametrize("beta", [0.0, 0.3])
def test_friction_of_each_plane_has_its_own_sliding_velocity(level: str, beta: float) -> None:
    """Static friction near the pitch point, dynamic far from it: the loss is the sum over the planes."""
    pair = make_pair(beta=beta)
    laws: dict[str, float] = {"mu": 0.05, "v_eps": 0.05, "mu_s": 0.12, "v_s": 0.01}
    if level == "rigid":
        made = MeshLaws(stiffness=PairShape(c_prime=14e9, S_R=1.0), surface=SurfaceContact(planes=7), **laws)
    else:
        plain = flexible(pair, planes=7)
        made = MeshLaws(stiffness=plain.stiffness, surface=plain.surface, **laws)
    m = OneMesh(pair, made, n_pair=7)
    m.frames["phi"] = [0.05, -0.05 * m.row["r_b1"] / m.row["r_b2"]]
    m.press(1e-6)  # without contacts of tip edges
    speed = 4.0
    m.frames["tw"][0, 5], m.frames["tw"][1, 5] = speed, -speed * m.row["r_b1"] / m.row["r_b2"]
    m.evaluate()
    nodes = m.pool[int(m.row["nodes"]) :][: int(m.row["n_nodes"]) * NODE.itemsize // 8].view(NODE)
    nodes = nodes[nodes["force"] > 0.0]
    assert nodes.size > 7
    assert (nodes["place"] == ON_PATH).all()
    slide = nodes["xi"] * speed * (1.0 + m.row["r_b1"] / m.row["r_b2"])
    share = np.array([static_dynamic(v, 0.12, 0.05, 0.01, 0.05)[0] for v in slide])
    assert np.ptp(np.abs(share)) > 0.01
    loss = float(np.sum(nodes["force"] * np.abs(share * slide))) / np.cos(pair.gear1.beta_b)
    assert m.get("friction_power") == pytest.approx(loss, rel=1e-4)
