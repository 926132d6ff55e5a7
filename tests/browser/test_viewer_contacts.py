# SPDX-License-Identifier: Apache-2.0
"""Contact lines, forces of pairs, patterns, gaps and marks in a browser, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import STATES, asked, refused
from tests.support.scene_browser import scene as shown
from tests.support.scene_contact_data import (
    ALPHA,
    FORCE,
    HELIX,
    LOAD,
    PENETRATION,
    PITCH,
    SLOPE,
    SLOTS,
    STEP,
    TOOTH,
    pairs_at,
    pressure,
    reached,
    share,
    touching,
    travel,
)
from tests.support.scene_data import LENGTH, TEETH, TIMES, texts_of

pytestmark = needs_browser


@pytest.fixture(scope="module")
def scene() -> tuple[str, str]:
    return texts_of(*touching())


def test_lines_and_forces_of_pairs_are_where_the_numbers_put_them(
    same_scene: OpenPage, scene: tuple[str, str]
) -> None:
    """At frames and half-way between two, where lines move on and loads of pairs in both frames are held."""
    times = [float(TIMES[37]), float(TIMES[301]), 0.5 * float(TIMES[444] + TIMES[445])]
    script = "V.arrows('pair');" + STATES % times
    for t, state in zip(times, asked(same_scene(scene), script), strict=True):
        picture = state["pictures"][0]
        (mesh,) = picture["contacts"]["meshes"]
        expected = pairs_at(t)
        lines = {line["pair"]: line for line in mesh["lines"]}
        assert set(lines) == set(expected) and len(lines) >= 2
        arrows = [arrow for arrow in picture["arrows"] if arrow["kind"] == "pair"]
        assert len(arrows) == SLOTS
        before, after = (pairs_at(float(TIMES[k])) for k in np.searchsorted(TIMES, [t, t + 1e-9]) - [1, 0])
        for pair, (low, high) in expected.items():
            line = lines[pair]
            assert np.abs(np.array([line["from"], line["to"]]) - [low, high]).max() < 1e-12
            arrow = arrows[pair % SLOTS]
            if pair not in before or pair not in after:
                continue  # it comes or goes between two frames
            force = FORCE * share(pair)
            assert line["force"] == pytest.approx(force, abs=force / 65535)
            loads = LOAD * share(pair) * np.linspace(1.0, 3.0, 5)
            assert line["loads"] == pytest.approx(loads, abs=0.5 * 3 * LOAD * 1.3 / 255 + 1)
            # on gear 2: towards y with gear 1, outwards, and against the lean of the lines
            parts = {
                "circumferential": [0, np.cos(ALPHA), 0],
                "radial": [np.sin(ALPHA), 0, 0],
                "axial": [0, 0, -np.tan(HELIX)],
            }
            for part, direction in parts.items():
                wanted = force * np.array(direction)
                assert np.abs(np.array(arrow["vectors"][part]) - wanted).max() < force / 3e4
                assert arrow["lengths"][part] > 0
            # loads rise from 1 to 3 along the line: their middle is at 0.625 of it for five places
            assert arrow["at"] == pytest.approx(low + 0.625 * (high - low), abs=2e-5)
        total = sum(np.array(a["vectors"]["circumferential"])[1] for a in arrows)
        assert total == pytest.approx(sum(line["force"] for line in lines.values()) * np.cos(ALPHA), rel=1e-6)


def test_forces_of_pairs_are_shown_when_asked_for(same_scene: OpenPage, scene: tuple[str, str]) -> None:
    script = """
      V.seek(0.06); V.draw();
      const rows = () => [...document.querySelectorAll(".ppv-legend tbody tr")].filter((r) => !r.hidden)
        .map((row) => row.innerText.split("\\t")[0].trim());
      const before = rows(); named("Forces").click();
      const labels = [...document.querySelectorAll(".ppv-panel label")];
      labels.find((l) => /tooth pairs/.test(l.innerText)).querySelector("input").click(); V.draw();
      return {before, after: rows(), legend: $(".ppv-flanks").innerText};
    """
    found = asked(same_scene(scene), script)
    assert found["before"] == ["stage_1", "bearing_a"]
    slots = sorted(1 + pair % SLOTS for pair in pairs_at(0.06))
    assert found["after"][2:] == [f"stage_1, pair {slot}" for slot in slots]
    # the largest load is that of a pair of the last slot, at the end of its line
    assert f"{3 * LOAD * 1.3 / 1e3:.1f}\u2009N/mm" in found["legend"]


def test_pattern_keeps_the_largest_load_so_far(same_scene: OpenPage, scene: tuple[str, str]) -> None:
    times = [float(TIMES[k]) for k in (3, 150, 600, 3)]
    script = (
        "const none = (V.draw(), S().pictures[0].contacts); V.pattern('each');" + STATES % times
    ).replace("return out;", "return {none, out};")
    found = asked(same_scene(scene), script)
    assert found["none"]["pattern"] == "off" and found["none"]["meshes"][0]["pattern"] == []
    covered = []
    for t, state in zip(times, found["out"], strict=True):
        contacts = state["pictures"][0]["contacts"]
        assert contacts["pattern"] == "each"
        (front,) = contacts["meshes"][0]["pattern"]
        covered.append(front["covered"])
        seen = {pair for k in range(int(np.searchsorted(TIMES, t)) + 1) for pair in pairs_at(float(TIMES[k]))}
        for g, teeth in enumerate(front["teeth"]):
            expected = {(TOOTH[g] + STEP[g] * pair) % TEETH[g] for pair in seen}
            # a line that only just touches a corner of the face may miss every point of the grid
            assert set(teeth) <= expected and len(expected) - len(teeth) <= 1
    assert covered[0] < covered[1] == covered[2] == 1.0
    assert covered[3] == covered[0], "back in time, the pattern is that of then"
    last = found["out"][2]["pictures"][0]["contacts"]["meshes"][0]["pattern"][0]
    # the outermost points of the grid are at the end of the face, where lines of the last slot end
    assert last["greatest"] == pytest.approx(3 * LOAD * 1.3, rel=1e-6)


def test_colours_tell_pressure_when_asked_for(same_scene: OpenPage, scene: tuple[str, str]) -> None:
    """Pressure of every station from its place on the path and its load; legend and largest of all."""
    t = float(TIMES[301])
    script = """
      V.seek(%r); V.draw(); named("Flanks").click();
      const select = [...document.querySelectorAll(".ppv-panel select")].find((s) =>
        [...s.options].some((o) => /Hertz/.test(o.text)));
      const load = S().pictures[0].contacts; select.value = "pressure";
      select.dispatchEvent(new Event("change")); V.draw();
      const out = {load: load.shade, contacts: S().pictures[0].contacts, legend: $(".ppv-flanks").innerText};
      V.shade("load"); V.draw();
      return {...out, chosen: select.value, after: $(".ppv-flanks").innerText};
    """
    found = asked(same_scene(scene), script % t)
    assert found["load"] == "load" and found["contacts"]["shade"] == "pressure"
    now = 0.0
    for line in found["contacts"]["meshes"][0]["lines"]:
        place = float(travel(t)) - line["pair"] * PITCH
        z = np.linspace(*reached(place), 5)
        wanted = pressure(place + SLOPE * z, LOAD * share(line["pair"]) * np.linspace(1.0, 3.0, 5))
        # loads have 255 steps of the largest, pressures the root of that
        assert line["values"] == pytest.approx(wanted, rel=0.5 * 0.5 * 3.9 / 255 + 1e-6)
        now = max(now, max(line["values"]))
    # the largest at any station of any frame, from the loads in 255 steps; places have 24 bits
    step = 3.0 * LOAD * 1.3 / 255
    far = 0.0
    for frame in TIMES:
        for pair in pairs_at(float(frame)):
            place = float(travel(frame)) - pair * PITCH
            loads = np.rint(LOAD * share(pair) * np.linspace(1.0, 3.0, 5) / step) * step
            far = max(far, *pressure(place + SLOPE * np.linspace(*reached(place), 5), loads))
    assert found["contacts"]["greatestPressure"] == pytest.approx(far, rel=1e-5)
    words = found["legend"]
    assert "Hertzian pressure" in words and f"current {now / 1e6:.1f}\u2009MPa" in words
    assert found["chosen"] == "load" and "N/mm" in found["after"] and "MPa" not in found["after"]


def test_pattern_is_painted_on_the_picture(same_scene: OpenPage, scene: tuple[str, str]) -> None:
    """Pixels change with the pattern, and come back without it."""
    script = """
      V.seek(0.1); V.lines(false); for (const kind of ["mesh", "bearing"]) V.arrows(kind, false);
      V.look([0.048, 0, 0], [0.3, 1, 0.6], 0.08);
      const bytes = async () => (V.draw(), new Uint8Array(await V.file("png").arrayBuffer()).join(""));
      const shots = [await bytes()];
      for (const mode of ["all", "off"]) { V.pattern(mode); shots.push(await bytes()); }
      V.pattern("all"); V.shade("pressure"); shots.push(await bytes());
      return [0, 0, 1].map((k, n) => shots[k] === shots[n + 1]);
    """
    assert asked(same_scene(scene), script) == [False, True, False]


def test_gap_is_told_by_the_channels_and_drawn_magnified(
    same_scene: OpenPage, scene: tuple[str, str]
) -> None:
    script = """
      V.seek(%s); V.draw(); V.gauge(0); V.draw();
      const fitting = S().pictures[0].contacts.meshes[0].magnified; V.gauge(0, 40); V.draw();
      const out = {fitting, words: $(".ppv-gap").textContent, mesh: S().pictures[0].contacts.meshes[0]};
      V.gauge(-1); V.draw(); out.gone = S().pictures[0].contacts.meshes[0].plates.length;
      return out;
    """
    t = 0.25 * LENGTH
    front, back = PENETRATION[0] + 1e-6, PENETRATION[1] - 1e-6
    found = asked(same_scene(scene), script % t)
    assert (
        "front flank penetration 5.00\u2009µm, back flank gap 97.0\u2009µm; magnification × 40"
        in found["words"]
    )
    a, b, c, d = np.array(found["mesh"]["plates"])
    thick = 0.03 * np.pi * 4e-3 * np.cos(ALPHA)
    for (one, two), side, deep in (((a, b), 1, front), ((c, d), -1, back)):
        normal = np.array([np.sin(ALPHA), side * np.cos(ALPHA), 0.0])
        assert (two - one) @ normal == pytest.approx(thick - 40 * deep, abs=1e-9)
        assert np.abs(np.cross(two - one, normal)).max() < 1e-12
    assert found["fitting"] in (1, 2, 5, 10, 20, 50, 100) and found["gone"] == 0


def test_box_of_the_flanks_is_there_when_it_has_something_to_say(open_page: OpenPage) -> None:
    """A law that tells no loads: only a gap fills it."""
    header, block = touching()
    for flank in header["contacts"][0]["flanks"]:
        del flank["loads"], flank["forces"]
    script = """
      const box = () => (V.draw(), $(".ppv-flanks").checkVisibility() && $(".ppv-flanks").innerText);
      const out = [box()]; V.gauge(0, 40); out.push(box()); V.gauge(-1); out.push(box()); return out;
    """
    before, gap, after = asked(shown(open_page, texts_of(header, block)), script)
    assert before is after is False and gap.endswith("magnification × 40")


def test_marks_are_listed_and_lead_to_their_instants(open_page: OpenPage, scene: tuple[str, str]) -> None:
    script = """
      named("Marks").click();
      const rows = () => [...document.querySelectorAll(".ppv-marklist button")];
      const all = rows().map((row) => row.innerText.replace(/\\s+/g, " "));
      rows()[1].click(); const at = S().time;
      document.querySelector(".ppv-panel input[type=checkbox]").click();
      return {all, at, fewer: rows().length};
    """
    found = asked(shown(open_page, scene), script)
    assert len(found["all"]) == 3 and found["fewer"] == 2
    assert "faulty tooth in mesh, Z1, tooth 3, 20.0\u2009ms" in found["all"][1].replace(" ms", "\u2009ms")
    assert found["at"] == pytest.approx(0.03)


def test_damaged_contacts_are_refused_in_a_sentence(open_page: OpenPage, scene: tuple[str, str]) -> None:
    header, numbers = scene
    damage = {
        "refers to an unknown body": ('"body": 1, "gear"', '"body": 99, "gear"'),
        "has no pressure_angle": ('"pressure_angle"', '"angle"'),
        "has no flanks": ('"base_pitch": 0', '"base_pitch": -0'),
    }
    assert all(old in header for old, _ in damage.values())
    texts = {says: (header.replace(old, new), numbers) for says, (old, new) in damage.items()}
    said = refused(open_page, texts)
    assert all(says in said[says] for says in damage), said
