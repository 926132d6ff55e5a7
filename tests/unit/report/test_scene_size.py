# SPDX-License-Identifier: Apache-2.0
"""The promise of `docs/view.md`: ten gears and 2000 frames are a page of at most 4.5 MB, viewer included.

The record is noise throughout, no channel follows from another, and none is smooth from frame to frame:
nothing packs worse. What is read back is as exact as `docs/scene_format.md` says.
"""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene.build import scene_of
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.scene.file import scene_texts
from pitchpoint.viz.scene.page import scene_page
from tests.support.scene_reader import Seen

PAIRS, SAMPLES, RATE = 5, 19_991, 500.0
SPEED, RATIO = 150.0, 23 / 41
MAX_BYTES = 4.5e6

GEARS = """\
  a{k}: {{number_of_teeth: 23, normal_module: {m} mm, helix_angle: 15 deg, hand: left, face_width: 30 mm, profile_shift_coefficient: 0.2}}
  b{k}: {{number_of_teeth: 41, normal_module: {m} mm, helix_angle: 15 deg, hand: right, face_width: 30 mm, profile_shift_coefficient: 0}}
"""  # noqa: E501
BODIES = """\
  in{k}: {{gears: [a{k}], motion: free, position: [0, 0, {z} mm]}}
  out{k}: {{gears: [b{k}], motion: free}}
"""
MESHES = "  m{k}: {{gears: [a{k}, b{k}], stiffness: {{law: din3990}}, backlash: {{normal: 0.1 mm}}}}\n"
SPRING = "{{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}"
BEARINGS = "".join(
    f"  {body}{{k}}_{end}: {{{{body: {body}{{k}}, stiffness: {SPRING}}}}}\n"
    for body in ("in", "out")
    for end in ("left", "right")
)
LOADS = "  t{k}: {{body: in{k}, torque: 100 N m}}\n  u{k}: {{body: out{k}, torque: balance}}\n"
SIZES = {
    "displacement": (1e-5, 2e-5),
    "angle": (0.0, 1e-4),
    "speed": (SPEED, 0.5),
    "deflection": (1.2e-5, 2e-6),
    "penetration": (1.2e-5, 2e-6),
    "transmission_error": (1.2e-5, 2e-6),
    "pair_force": (1500.0, 300.0),
    "mesh_phase": (0.5, 0.2),
    "contact_state": (1.0, 0.0),
}
"""Mean and rms of the channels of a quantity; forces and all else below."""
ELSE = (3000.0, 500.0)


def text() -> str:
    def parts(head: str, one: str) -> str:
        return head + ":\n" + "".join(one.format(k=k, m=2 + k, z=100 * k) for k in range(PAIRS))

    sections = {"gears": GEARS, "bodies": BODIES, "meshes": MESHES, "bearings": BEARINGS, "loads": LOADS}
    speeds = ", ".join(f"in{k}: 1400 rpm" for k in range(PAIRS))
    scenario = f"scenarios:\n  on: {{speed: {{{speeds}}}, duration: 40 s, sample_rate: {RATE:g} Hz}}\n"
    return "title: ten gears\n" + "".join(parts(*item) for item in sections.items()) + scenario


def record(system) -> xr.Dataset:
    """A long result with every channel that a run keeps."""
    random = np.random.default_rng(7)
    time = np.arange(SAMPLES) / RATE
    found = {}
    for channel in system.layout.channels:
        quantity, _, owner = channel.name.partition("[")
        mean, rms = SIZES.get(quantity, ELSE)
        values = mean + rms * random.standard_normal(SAMPLES)
        if owner.endswith(("rx]", "ry]")):
            values *= 2.0
        if quantity == "angle":
            values += time * (SPEED if owner.startswith("in") else -SPEED * RATIO)
        found[channel.name] = ("time", values, {"units": channel.unit})
    return xr.Dataset(found, {"time": ("time", time, {"units": "s"})}, {"scenario": "on"})


@pytest.fixture(scope="module")
def long():
    model = loads_model(text())
    system = compile_model(model, "on")
    result = record(system)
    scene = scene_of(model, result)
    return scene, Seen(*scene_texts(scene)), result


def test_ten_gears_with_2000_frames_take_less_than_5_megabytes(long):
    scene, read, _ = long
    header = read.header
    assert sum(solid["kind"] == "gear" for solid in header["solids"]) == 2 * PAIRS
    assert len(read.times) == 2000
    # besides the bodies of the model there are the cages of their bearings
    bodies = [body for body in header["bodies"] if not body.get("part")]
    assert len(header["contacts"]) == PAIRS and len(bodies) == 2 * PAIRS
    assert len(header["bodies"]) == 6 * PAIRS
    assert sum(arrow["kind"] == "bearing" for arrow in header["arrows"]) == 4 * PAIRS
    for contact in header["contacts"]:
        assert np.any(read.array(contact["flanks"][0]["forces"]))
    assert len(scene_page(scene).encode()) < MAX_BYTES


def near(read: np.ndarray, truth: np.ndarray, error: float) -> None:
    """Within an error, and round-off of the numbers themselves."""
    assert np.abs(read - truth).max() <= error * (1.0 + 1e-6) + 1e-12 * np.abs(truth).max()


def unseen(track: np.ndarray, error: float) -> float:
    return min(error, float(np.ptp(track, axis=0).max()) / 4094)


def test_motions_are_as_exact_as_the_format_says(long):
    scene, read, _ = long
    for body, entry in zip(scene.bodies, read.header["bodies"], strict=True):
        if body.part:
            continue
        near(read.array(entry["position"]), body.position, unseen(body.position, 25e-9))
        # an angle moves nothing on the body by more than that: a gear of 2 to 6 mm modules and 23 or 41 teeth
        reach = np.hypot(*read.mesh(body.name.replace("in", "a").replace("out", "b"))[0].T[:2]).max()
        near(read.array(entry["turn"]), body.turn, unseen(body.turn, 25e-9 / reach))
        # the body that guides all others has no deviation
        spin = read.array(entry["spin"]) if "spin" in entry else 0.0
        angle = entry["ratio"] * read.array(entry["gross"]) + spin
        near(angle, body.angle, unseen(body.angle - body.ratio * body.gross, 25e-9 / reach))


def test_forces_and_contacts_are_as_exact_as_the_format_says(long):
    scene, read, _ = long
    for arrow, entry in zip(scene.arrows, read.header["arrows"], strict=True):
        for part, force in arrow.components.items():
            near(read.array(entry["components"][part]), force, entry["size"] / 16384)
    for contact, entry in zip(scene.contacts, read.header["contacts"], strict=True):
        near(read.array(entry["at"]), contact.at, 25e-9)
        near(read.array(entry["penetration"]), contact.penetration, unseen(contact.penetration, 5e-9))
        for flank, kept in zip(contact.flanks, entry["flanks"], strict=True):
            near(read.array(kept["travel"]), flank.travel, 25e-9)
            for part, steps in (("forces", 8191), ("loads", 255)):
                truth = getattr(flank, part)
                near(read.array(kept[part]), truth, 0.501 * np.abs(truth).max() / steps)
                # no contact is distinguished from a small force
                assert not read.array(kept[part])[truth == 0.0].any()


def test_curves_spectra_and_solids_are_as_exact_as_the_format_says(long):
    scene, read, _ = long
    assert len(scene.channels) > 200
    for channel in scene.channels:
        times, least, most, mean = read.channel(channel.name)
        way = channel.most.max() - channel.least.min()
        for kept, truth in ((least, channel.least), (most, channel.most)):
            near(kept, truth, 0.501 * way / (65535 if channel.first else 2047))
        assert np.abs(mean - channel.mean).max() <= way * (0.502 / 63 + 2 / 2047)
        assert np.array_equal(times, channel.times)
    for spectrum, entry in zip(scene.spectra, read.header["spectra"], strict=True):
        assert read.array(entry["lines"]) == pytest.approx(spectrum.lines, rel=1e-6)
        assert read.array(entry["amplitude"]) == pytest.approx(spectrum.amplitude, rel=1.001e-3)
    for solid, entry in zip(scene.solids, read.header["solids"], strict=True):
        for piece, kept in zip(solid.pieces, entry.get("pieces", []), strict=True):
            for level, surface in zip(piece.levels, kept["levels"], strict=True):
                near(read.array(surface["points"]), level.points, 5e-8 * np.abs(level.points).max())
                assert np.array_equal(read.array(surface["triangles"]), level.triangles)
