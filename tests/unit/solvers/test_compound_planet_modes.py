# SPDX-License-Identifier: Apache-2.0
"""Kinds of modes of compound sets: those of single sets, with all groups of planets together.

D. R. Kiracofe, R. G. Parker, Structured vibration modes of general compound planetary gear systems, J. Vib.
Acoust. 129 (2007) 1: with c central members, and d coordinates of the planets of all groups at one angle,
there are c + d rotational modes, c + d pairs of translational modes (2 c lateral coordinates), and N - 3
times d planet modes. Lateral supports of the central members change only translational modes, and planet
modes do not depend on the number of planets.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.planet_gearboxes import ravigneaux, simpson

PLANETS = "bearing: {stiffness: {radial: 3e8 N/m}}"


def lateral(text: str, central: dict[str, str], stiffness: float) -> str:
    """The model with lateral motion of central members; `central` are the lines of their bodies."""
    bearings = "bearings:\n"
    for body, line in central.items():
        mass = "" if "gears" in line else ", mass: 3 kg"
        assert line in text
        text = text.replace(line, line.removesuffix("}") + f", motion: planar{mass}}}")
        bearings += f"  {body}: {{body: {body}, stiffness: {{radial: {stiffness!r} N/m}}}}\n"
    return text + bearings


def ravigneaux_set(count: int, stiffness: float) -> str:
    """Ravigneaux set of 24/36/72 teeth, which fits for three and four planets."""
    text = ravigneaux(motion="planar", more=PLANETS).replace("planets: 3", f"planets: {count}")
    text = text.replace("number_of_teeth: 27", "number_of_teeth: 24")
    lines = {body: f"{{gears: [{body}], position: [0, 0, 0]}}" for body in ("large_sun", "ring")}
    lines["small_sun"] = "{gears: [small_sun], position: [0, 0, 25 mm]}"
    lines["carrier"] = "{inertia: 4e-3 kg m^2}"
    return lateral(text, lines, stiffness)


def by_kind(text: str, stages: str) -> dict[str, np.ndarray]:
    """Frequencies [Hz] by kind; the rigid rotation is a rotational mode."""
    found = find_modes(compile_model(loads_model(text)))
    kinds: dict[str, list[float]] = {"rotational": [], "translational": [], "planet": []}
    for frequency, name in zip(found.frequency, found.names, strict=True):
        kind = next((k for k in kinds if f"{k} mode of planetary stages {stages}" in name), "")
        if not kind:
            assert frequency == 0.0 or name.startswith("translation of"), name
            kind = "rotational" if frequency == 0.0 else "translational"
        kinds[kind].append(float(frequency))
    return {kind: np.array(values) for kind, values in kinds.items()}


@pytest.mark.parametrize("count", [3, 4])
def test_a_ravigneaux_set(count):
    c, d = 4, 6
    soft, stiff = (by_kind(ravigneaux_set(count, k), "short and long") for k in (1e8, 4e8))
    for found in (soft, stiff):
        assert {kind: len(values) for kind, values in found.items()} == {
            "rotational": c + d,
            "translational": 2 * (c + d),
            "planet": (count - 3) * d,
        }
        pairs = found["translational"]
        assert pairs[::2] == pytest.approx(pairs[1::2], rel=1e-7)
    for kind in ("rotational", "planet"):
        assert soft[kind] == pytest.approx(stiff[kind], rel=1e-9, abs=1e-3)
    assert np.all(stiff["translational"] >= soft["translational"] * (1.0 - 1e-9))
    assert stiff["translational"][0] > 1.5 * soft["translational"][0]


def test_a_simpson_set():
    """Two stages of three planets on revolute pins, on common bodies: rotational modes, and planet modes in
    pairs, as the central members do not move sideways."""
    found = by_kind(simpson(), "front and rear")
    assert {kind: len(values) for kind, values in found.items()} == {
        "rotational": 4 + 2,
        "translational": 0,
        "planet": 2 * 2,
    }
    assert found["planet"][::2] == pytest.approx(found["planet"][1::2], rel=1e-9)
    assert np.sum(found["rotational"] == 0.0) == 2
