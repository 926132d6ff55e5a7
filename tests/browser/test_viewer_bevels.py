# SPDX-License-Identifier: Apache-2.0
"""Contact lines and pair forces of bevel meshes in a browser, against the numbers of the file."""

from __future__ import annotations

import numpy as np

from pitchpoint.report.scene.build import scene_of
from pitchpoint.viz.scene.file import scene_texts
from tests.support.bevel_teeth import PAIR, RUN
from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import STATES, asked
from tests.support.scene_browser import scene as shown
from tests.support.scene_models import seen

pytestmark = needs_browser


def test_lines_and_pair_forces_of_bevel_gears_are_where_the_numbers_put_them(open_page: OpenPage) -> None:
    """Lines are curved in the plane of action; forces of all pairs add up to that of the mesh.

    The force of a pair acts in the middle of its load, which omits how it turns along the line."""
    scene, system, result = seen(PAIR + RUN % 60, "turn")
    contact = scene.contact("stage")
    frames = [40, 151]
    times = [float(scene.times[k]) for k in frames]
    texts = scene_texts(scene_of(system.model, result))
    script = "V.arrows('pair');V.arrows('mesh');" + STATES % times
    for frame, state in zip(frames, asked(shown(open_page, texts), script), strict=True):
        picture = state["pictures"][0]
        (mesh,) = picture["contacts"]["meshes"]
        expected = scene.lines(contact, 1, frame)
        lines = {line["pair"]: line for line in mesh["lines"] if line["force"]}
        assert set(lines) == {pair for pair, line in expected.items() if line["force"]}
        for pair, line in lines.items():
            # the reader looks for the ends of a line on a grid of 4000 steps
            ends = expected[pair]["points"][[0, -1]]
            assert np.abs(np.array([line["from"], line["to"]]) - ends).max() < 2e-5
        whole, *pairs = picture["arrows"]
        size = np.linalg.norm(scene.force("stage", frame))
        for part, vector in whole["vectors"].items():
            total = np.sum([arrow["vectors"][part] for arrow in pairs], axis=0)
            assert np.abs(total - vector).max() < 5e-3 * size
