# SPDX-License-Identifier: Apache-2.0
"""Scenes that the package writes, read by the viewer: every form of a table, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.viz.scene.content import (
    Scene,
    SceneArrow,
    SceneBody,
    SceneChannel,
    SceneSolid,
)
from pitchpoint.viz.scene.file import scene_parts, scene_texts
from pitchpoint.viz.scene.spectrum import SceneSpectrum
from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import STATES, asked, matrix
from tests.support.scene_browser import scene as opened
from tests.support.scene_data import box

pytestmark = needs_browser
T = np.linspace(0.0, 2.0, 401)
WAY = np.column_stack([3e-4 * np.sin(9 * T), 2e-4 * np.cos(23 * T), 1e-5 * np.sin(5 * T)])
TURN = 1e-4 * np.sin(17 * T)[:, None] * [0.6, -0.8, 0.0]
LENGTH = 0.5 * T**2
FORCE = (400.0 + 90.0 * np.sin(11 * T))[:, None] * [0.0, 0.8, 0.6]
SIDE = FORCE[:, :1] * 0.0 + np.column_stack([50.0 * np.cos(3 * T), 0.0 * T, 20.0 * np.sin(8 * T)])


def scene() -> Scene:
    points, triangles = box([-0.1, -0.1, -0.1], [0.1, 0.1, 0.1])
    solid = {"kind": "body", "points": points, "triangles": triangles}
    still = {"place": np.array([0.0, 0.0, 0.0]), "axes": np.eye(3)}
    part = {"unit": "N", "shown_unit": "N", "scale": 1.0, "times": T[:-1:4]}
    low, high = (np.array([f(FORCE[k : k + 4, 1]) for k in range(0, 400, 4)]) for f in (min, max))
    return Scene(
        title="numbers",
        bodies=[
            SceneBody(name="shaking", position=WAY, turn=TURN, **still),
            SceneBody(name="sliding", travel=np.column_stack([0 * T, LENGTH, 0 * T]), **still),
        ],
        solids=[SceneSolid(name="a", body=0, **solid), SceneSolid(name="b", body=1, **solid)],
        times=T,
        arrows=[
            SceneArrow(
                name="mesh", kind="mesh", at=np.zeros((1, 3)), components={"radial": FORCE, "axial": SIDE}
            )
        ],
        channels=[
            SceneChannel(
                name="f", label="force", least=low, most=high, mean=0.5 * (low + high), first=True, **part
            ),
            SceneChannel(
                name="g", label="twice", least=2 * low, most=2 * high, mean=low + high, first=True, **part
            ),
        ],
        spectra=[SceneSpectrum("f", "N", 2.5 * np.arange(1.0, 200.0), 1.0 / np.arange(1.0, 200.0), "", 2.5)],
    )


def test_the_viewer_reads_what_the_package_writes(open_page: OpenPage) -> None:
    header, _ = scene_parts(scene())
    # the forms that are tried: planes, columns that follow from fewer, a shared column, a logarithm
    turn, radial = header["bodies"][0]["turn"], header["arrows"][0]["components"]["radial"]
    assert turn["type"] == "planes" and len(turn["mix"]) == 1 and len(radial["mix"]) <= 3
    assert header["channels"][0]["curve"] == header["channels"][1]["curve"]
    assert header["spectra"][0]["amplitude"]["exponent"]
    frames = [0, 137, 400]
    script = STATES % [float(T[k]) for k in frames]
    states = asked(opened(open_page, scene_texts(scene())), script)
    for k, state in zip(frames, states, strict=True):
        (picture,) = state["pictures"]
        first, second = (matrix(body) for body in picture["bodies"])
        assert np.abs(first[:3, 3] - WAY[k]).max() < 25e-9
        x, y, _ = TURN[k]
        small = np.array([[0, 0, y], [0, 0, -x], [-y, x, 0]])
        # the turn by parts of 1e-4 rad, 25 nm at the corners of the box; squares of it are omitted
        assert np.abs(first[:3, :3] - np.eye(3) - small).max() < 25e-9 / 0.17 + 0.51e-8
        assert np.abs(second[:3, 3] - [0.0, LENGTH[k], 0.0]).max() < 25e-9
        (arrow,) = picture["arrows"]
        for part, truth in (("radial", FORCE), ("axial", SIDE)):
            assert (
                np.abs(np.array(arrow["vectors"][part]) - truth[k]).max()
                < header["arrows"][0]["size"] / 16384
            )
    piece = 137 // 4
    words = [text for plot in states[1]["cursor"] for text in plot["readings"]]
    for times, text in zip((1.0, 2.0), words, strict=True):
        read = [float(number.replace("\u2212", "-")) for number in text.split(" \u2026 ")]
        shown = [times * f(FORCE[4 * piece : 4 * piece + 4, 1]) for f in (min, max)]
        assert read == pytest.approx(shown, abs=0.06 * times)
