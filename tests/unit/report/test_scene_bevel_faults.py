# SPDX-License-Identifier: Apache-2.0
"""Broken and displaced teeth of bevel gears in a scene: drawn, marked, without load where they are gone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.flanks import flank_lines
from pitchpoint.report.scene.build import scene_of
from pitchpoint.report.scene.contact_lines import ContactLines
from pitchpoint.report.scene.motion import motion
from tests.support.bevel_teeth import PAIR, RUN
from tests.support.scene_models import seen

FAULTS = """\
    faults: {gone: {type: broken_tooth, tooth: 4}, late: {type: pitch_error, tooth: 9, amount: 20 um},
      toe: {type: broken_tooth, tooth: 2, at: inner, width: 6 mm},
      sound: {type: broken_tooth, tooth: 5, severity: 0}}}
"""
TEXT = PAIR.replace(
    "face_width: 14 mm, bore_diameter: 12 mm}\n", f"face_width: 14 mm, bore_diameter: 12 mm,\n{FAULTS}"
)


def test_teeth_are_drawn_where_they_stand_and_broken_ones_by_themselves():
    model = loads_model(TEXT)
    (solid,) = (s for s in scene_of(model).solids if s.name == "pinion")
    assert [p.fault for p in solid.pieces] == [
        "",
        "",
        "tooth 4: gone (broken tooth)",
        "tooth 2: toe (broken tooth)",
    ]
    pitch = 2.0 * math.pi / 17
    turns = {round(t / pitch): t for piece in solid.pieces if len(piece.turns) < 17 for t in piece.turns}
    assert sorted(turns) == list(range(17))
    gear = model.bevel_gears["pinion"].geometry
    assert turns[9] - 9 * pitch == pytest.approx(20e-6 / (gear.R_m * math.sin(gear.delta)))
    assert turns[8] == pytest.approx(8 * pitch, abs=1e-15)
    assert ("pinion", "left and right", "gone: broken tooth", "severity 1", "tooth 4") in flank_lines(model)


def test_loads_and_marks_follow_the_numbers_of_the_teeth():
    """Pinion tooth 4 carries nothing and tooth 2 nothing on the inner 6 of its 14 mm, whoever counts."""
    scene, system, result = seen(
        TEXT + (RUN % 60).replace("20 ms", "400 ms").replace("10 kHz", "1 kHz"), "turn"
    )
    marks = [mark for mark in scene.header["marks"] if mark["kind"] == "faulty_tooth"]
    assert {m["what"] for m in marks} == {
        f"pinion, tooth {tooth} ({label}) in stage" for tooth, label in ((4, "gone"), (2, "toe"), (9, "late"))
    }
    contact = scene.contact("stage")
    (flank,) = (f for f in contact["flanks"] if f["side"] == 1)
    surface = next(s for s in flank["surfaces"] if s["gear"] == "pinion")
    R_m, gear = contact["cone"][0], system.model.bevel_gears["pinion"].geometry
    edge = R_m * math.log((gear.R_i + 6e-3) / R_m)
    met, torn = {2: 0, 4: 0}, 0
    for frame, t in enumerate(scene.times):
        lines = scene.lines(contact, 1, frame)
        for pair, line in lines.items():
            tooth = (surface["tooth"] + surface["step"] * pair) % surface["teeth"]
            said = [m for m in marks if f"tooth {tooth} " in m["what"] and m["time"] <= t <= m["until"]]
            assert bool(said) == (tooth in (2, 4, 9))
            assert tooth != 4 or not line["loads"].any()
            if tooth == 2:
                assert not line["loads"][line["z"] < edge].any()
                torn += line["loads"][line["z"] > edge + 1e-4].any() and line["z"][0] < edge
            met[tooth] = met.get(tooth, 0) + bool(line["loads"].any())
    assert torn > 3 and met[4] == 0 and len(met) == 17
    _forces_are_those_of_the_kernel(system, result)


def _forces_are_those_of_the_kernel(system, result):
    """Before the scene brings them to those."""
    count = result.sizes["time"]

    def read(name):
        return np.asarray(result[name].values) if name in result else None

    lines = ContactLines(system, read, count)
    motion(system, count, read, result["time"].values, lines.look)
    bevel = lines.meshes["stage"]
    kept = np.stack([result[f"pair_force[stage.{k}]"].values for k in range(bevel.pairs)], axis=1)
    assert bevel.forces[:, 0] == pytest.approx(kept, abs=1e-5 * kept.max())
