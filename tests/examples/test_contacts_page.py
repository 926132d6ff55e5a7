# SPDX-License-Identifier: Apache-2.0
"""The page on contacts: its file and its numbers are tried as they stand there."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import fsolve

from pitchpoint.contact.rolling import roller_stiffness
from pitchpoint.geometry.triangle_file import LARGEST, MAX_TRIANGLES, SMALLEST
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.contact import SURFACES
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.system.compile import compile_model

DOCS = Path(__file__).parents[2] / "docs"
TEXT = (DOCS / "contacts.md").read_text(encoding="utf-8")
WORDS = " ".join(TEXT.split())


def test_the_roller_stands_as_the_page_says():
    """Against SciPy: 1e-4 for the tilt, which moves the lowest line by r t = 2 um under the load at 3 mm."""
    found = re.search(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)
    assert found
    system = compile_model(loads_model(found[1]))
    rest = find_equilibrium(system)
    seen = dict(zip([c.name for c in system.layout.channels], rest.observe(system), strict=True))
    depth = -rest.state.q[system.layout.coordinate("roller.x")]
    tilt = rest.state.q[system.layout.coordinate("roller.spin")]
    assert f"{1e6 * depth:.2f} um deep" in WORDS
    assert f"{1e3 * tilt:.3f} mrad" in WORDS
    assert f"{-1e6 * seen['gap[line]']:.2f} um" in WORDS
    length, K, e = 0.03, 9930.0 / 1e-5**1.1111, 1.1111

    def missing(p):
        def law(x):
            return K / length * max(0.0, 1e-6 * p[0] + 1e-4 * p[1] * x) ** e

        force = quad(law, -length / 2, length / 2)[0]
        moment = quad(lambda x: x * law(x), -length / 2, length / 2)[0]
        return force / 5000.0 - 1.0, moment / (5000.0 * (3e-3 + 0.01 * 1e-4 * p[1])) - 1.0

    u, t = fsolve(missing, (5.0, 1.0), xtol=1e-12)
    assert depth == pytest.approx(1e-6 * u, rel=1e-4)
    assert tilt == pytest.approx(1e-4 * t, rel=1e-4)


def test_other_numbers():
    """Palmgren's constant, the crossed cylinders against Hertz, limits of files."""
    K = roller_stiffness(30e-3, 2.0 * 0.91 / 206e9)
    assert 1e-5 ** (10.0 / 9.0) * K == pytest.approx(9930.0, rel=5e-3)
    # line of springs pi/4 E*/L against 4/3 E* sqrt(R) u^1.5 of equal cylinders at a right angle, d = 2 R
    ratio = math.pi / 4.0 * 4.0 / 3.0 * math.sqrt(4.0) / (4.0 / 3.0)
    assert f"({ratio:.1f} times it" in WORDS
    assert f"more than {MAX_TRIANGLES} triangles" in WORDS
    assert f"below {1e3 * SMALLEST:g} mm or above {LARGEST:g} m" in WORDS
    assert all(shape in TEXT for shape in SURFACES)


def test_named_tests_exist():
    names = set(re.findall(r"`(test_\w+)`", TEXT))
    source = "".join(p.read_text(encoding="utf-8") for p in (DOCS.parent / "tests").rglob("test_*.py"))
    assert names
    assert all(f"def {name}(" in source for name in names)


def test_a_ball_of_triangles_is_as_far_off_as_the_page_says():
    from tests.support.contacts import ball, contact, pair, read

    R, u, k = 0.05, 2e-3, 1e11
    from pitchpoint.contact.impact import set_impact
    from pitchpoint.elements.surface_surface import set_mesh_on_shape

    for level, faces in ((4, 5120), (5, 20480)):
        surface = ball(R, level)
        assert len(surface.faces) == faces

        def shapes(record, pool, surface=surface):
            set_mesh_on_shape(record, pool, surface, "plane")
            set_impact(record, k, 1.0)

        def law(record):
            set_impact(record, k, 1.0)

        system = pair(
            "surface_surface",
            contact("surface_surface", shapes, law),
            (0, 0, R - u),
            np.random.default_rng(1),
        )
        force = read(system, system.initial_state(), "contact_force[surface_surface0]")
        short = 100.0 * (1.0 - force / (math.pi * k * R * u * u))
        said = {5120: "5 % below", 20480: "20480 faces 1.2 %"}[faces]
        assert said in WORDS
        assert short == pytest.approx(5.0 if faces == 5120 else 1.2, abs=0.5 if faces == 5120 else 0.15)
