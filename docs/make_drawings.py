# SPDX-License-Identifier: Apache-2.0
"""Drawings of the conventions: signs, frames, path of contact, backlash, flanks, hands, forces.

Outlines, circles, paths and gaps come from `pitchpoint.geometry`, so a drawing cannot contradict
the package does. ``python docs/make_drawings.py FOLDER`` writes the SVG files.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from sheet import FILLS, INK, SOFT, Sheet

from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.geometry.placement import mesh_outlines
from pitchpoint.geometry.tooth_form import gear_outline, tooth_form
from pitchpoint.viz.theme import FORCE_PARTS, GREEN, PURPLE, RED

Array = NDArray[np.float64]


def moved(point: Array, x: float, y: float) -> Array:
    """A point moved by x and y [m]."""
    return point + np.array([x, y])


def front_contact(pair: GearPair, phi1: float) -> float:
    """Rotation of gear 2 at which the front flanks touch: r_b1 phi1 + r_b2 phi2 = j_bt/2."""
    return (0.5 * pair.j_bt - pair.gear1.r_b * phi1) / pair.gear2.r_b


def directions(pair: GearPair, flank: int) -> tuple[Array, Array]:
    """Pitch point [m] and unit vector of the line of action, n_f = f cos(alpha) t + sin(alpha) e."""
    e, t = np.array([1.0, 0.0]), np.array([0.0, 1.0])
    n = flank * math.cos(pair.alpha_wt) * t + math.sin(pair.alpha_wt) * e
    return np.array([0.5 * pair.d_w1, 0.0]), n


def signs(target: Path) -> None:
    """Both axes, positive rotations, line of centres, line of action of the front flank."""
    one = CylindricalGear(z=15, m_n=4e-3, x=0.3, b=20e-3)
    pair = GearPair.at_distance(one, CylindricalGear(z=21, m_n=4e-3, x=0.1, b=20e-3), 74.2e-3)
    sheet = Sheet(860, 430, [0.5 * pair.a_w, 0.0], 4600.0)
    sheet.gears(pair, 0.16, front_contact(pair, 0.16))
    for place, side, name in ((0.0, -0.018, "1"), (pair.a_w, 0.022, "2")):
        centre = np.array([place, 0.0])
        start = math.radians(115 if side < 0.0 else -65)
        sheet.turn(centre, abs(side), (start, start + math.radians(130)), GREEN)
        anchor = "end" if side < 0.0 else "start"
        sheet.text(
            moved(centre, 0.5 * side, 0.9 * abs(side)),
            f"φ{name}, ω{name}, T{name}",
            (0, 6),
            colour=GREEN,
            anchor=anchor,
        )
        sheet.out(centre)
        sheet.text(centre, f"z{name}", (16, -16))
    sheet.arrow([0.0, 0.0], [0.021, 0.0])
    sheet.arrow([0.0, 0.0], [0.0, 0.021])
    sheet.text([0.021, 0.0], "x", (10, 12))
    sheet.text([0.0, 0.021], "y", (-13, 0))
    pitch, n = directions(pair, 1)
    sheet.line([pitch - 0.026 * n, pitch + 0.026 * n], RED, 1.2, 'stroke-dasharray="5 4"')
    sheet.arrow(pitch, pitch + 0.019 * n, RED, 2.6)
    sheet.text(pitch + 0.019 * n, "n, front flank", (10, 4), colour=RED, anchor="start")
    sheet.arrow(pitch, moved(pitch, 0.012, 0.0))
    sheet.arrow(pitch, moved(pitch, 0.0, 0.012))
    sheet.text(moved(pitch, 0.012, 0.0), "e", (9, 0))
    sheet.text(moved(pitch, 0.0, 0.012), "t", (-10, 3))
    sheet.dot(pitch)
    sheet.text(pitch, "C", (-12, -12))
    sheet.text([0.0, -0.036], "gear 1", (0, -16))
    sheet.text([pair.a_w, -0.036], "gear 2", (0, -16))
    sheet.save(target / "signs.svg", "Positive directions of an external pair")


def path_of_contact(target: Path) -> None:
    """The path from A to E on the line of action, with base and tip circles."""
    one = CylindricalGear(z=18, m_n=4e-3, b=20e-3)
    pair = GearPair.at_distance(one, CylindricalGear(z=27, m_n=4e-3, b=20e-3), 90e-3)
    sheet = Sheet(860, 560, [0.5 * pair.d_w1 + 1e-3, 0.0], 12500.0)
    sheet.gears(pair, 0.05, front_contact(pair, 0.05))
    angles = (-1.0, 1.0)
    for centre, gear, base in (([0.0, 0.0], one, 0.0), ([pair.a_w, 0.0], pair.gear2, math.pi)):
        ends = (base + angles[0], base + angles[1])
        sheet.arc(centre, gear.r_b, ends, SOFT, 'stroke-dasharray="8 4"')
        sheet.arc(centre, 0.5 * gear.d_a, ends, SOFT)
    pitch, n = directions(pair, 1)
    place = {name: pitch + (getattr(pair, f"T1{name}") - pair.T1C) * n for name in "ABCDE"}
    ends = [pitch - pair.T1C * n, pitch + (pair.T1T2 - pair.T1C) * n]
    sheet.line([ends[0] - 0.002 * n, ends[1] + 0.002 * n], RED, 1.4, 'stroke-dasharray="6 4"')
    sheet.line([place["A"], place["E"]], RED, 3.6, 'stroke-linecap="round"')
    for name, point in (*place.items(), ("T1", ends[0]), ("T2", ends[1])):
        sheet.dot(point)
        sheet.text(point, name, (16, -2) if name not in ("C",) else (18, -4), weight="700")
    sheet.line([pitch - [0.0, 0.016], moved(pitch, 0.0, 0.017)], SOFT, 1.0)
    sheet.arc(pitch, 0.0135, (math.pi / 2 - pair.alpha_wt, math.pi / 2), INK)
    middle = math.pi / 2 - 0.5 * pair.alpha_wt
    sheet.text(pitch + 0.0135 * np.array([math.cos(middle), math.sin(middle)]), "α_wt", (0, 11))
    for words, at in (
        ("base circle 1", [one.r_b * math.cos(-0.62) - 3e-3, one.r_b * math.sin(-0.62)]),
        ("tip circle 1", [0.5 * one.d_a * math.cos(0.5) - 4e-3, 0.5 * one.d_a * math.sin(0.5)]),
        (
            "tip circle 2",
            [pair.a_w - 0.5 * pair.gear2.d_a * math.cos(0.3) + 3.5e-3, -0.5 * pair.gear2.d_a * math.sin(0.3)],
        ),
        (
            "base circle 2",
            [pair.a_w - pair.gear2.r_b * math.cos(0.28) + 4.5e-3, pair.gear2.r_b * math.sin(0.28)],
        ),
    ):
        sheet.text(at, words, (0, 0), colour=SOFT)
    words = f"ε_α = (T1E − T1A)/p_bt = {pair.eps_alpha:.3f};  two pairs on AB and DE, one on BD"
    sheet.text(sheet.middle, words, (0, -258))
    sheet.save(target / "path-of-contact.svg", "Path of contact from A to E on the line of action")


def backlash(target: Path) -> None:
    """Front flanks touch; the whole gap is open at the back, in three directions."""
    one = CylindricalGear(z=18, m_n=4e-3, b=20e-3)
    pair = GearPair.at_distance(one, CylindricalGear(z=27, m_n=4e-3, b=20e-3), 91e-3)
    pitch, n_back = directions(pair, -1)
    phi1 = math.radians(4.0)
    phi2 = front_contact(pair, phi1)
    sheet = Sheet(860, 470, [pitch[0] + 0.5e-3, 0.0], 26000.0)
    sheet.gears(pair, phi1, phi2)
    _, n_front = directions(pair, 1)
    sheet.line([pitch - 0.014 * n_front, pitch + 0.014 * n_front], RED, 1.3, 'stroke-dasharray="6 4"')
    sheet.line([pitch - 0.014 * n_back, pitch + 0.014 * n_back], PURPLE, 1.3, 'stroke-dasharray="6 4"')
    # where the outlines of both gears cut the line of action of the back flank: the gap lies between them
    outlines = mesh_outlines(pair, phi1, 400, phi2=phi2)
    cuts = [crossing(outline, pitch, n_back) for outline in outlines]
    span = (min(cuts[0], key=abs), min(cuts[1], key=abs))
    best = min(((a, b) for a in cuts[0] for b in cuts[1]), key=lambda ab: abs(abs(ab[0] - ab[1]) - pair.j_bt))
    if abs(abs(best[0] - best[1]) - pair.j_bt) > 1e-8:
        raise SystemExit(
            f"docs/make_drawings.py: the gap of the outlines is not j_bt: {span}, {best}, {pair.j_bt}"
        )
    ends = [pitch + s * n_back for s in best]
    sheet.line(ends, PURPLE, 5.0)
    for point in ends:
        sheet.dot(point, PURPLE)
    sheet.text(0.5 * (ends[0] + ends[1]), "j_bt", (30, -10), colour=PURPLE, weight="700")
    touch = [pitch + s * n_front for s in touching(outlines, pitch, n_front)]
    for point in touch:
        sheet.dot(point, RED, RED)
    sheet.text(touch[0], "front flanks touch", (14, 6), colour=RED, anchor="start")
    sheet.arc([0.0, 0.0], 0.5 * pair.d_w1, (-0.35, 0.35), SOFT, 'stroke-dasharray="10 3 2 3"')
    sheet.arc(
        [pair.a_w, 0.0],
        0.5 * pair.d_w2,
        (math.pi - 0.25, math.pi + 0.25),
        SOFT,
        'stroke-dasharray="10 3 2 3"',
    )
    sheet.dot(pitch, SOFT)
    sheet.text(pitch, "C", (-14, 0))
    numbers = f"a = 91 mm: j_bt = {pair.j_bt * 1e6:.1f} µm, j_wt = j_bt/cos α_wt = {pair.j_wt * 1e6:.1f} µm"
    sheet.text(sheet.middle, numbers + " on the working circles", (0, -216))
    sheet.text([pitch[0], 0.0], "gear 1", (-330, 120))
    sheet.text([pitch[0], 0.0], "gear 2", (330, 120))
    sheet.save(target / "backlash.svg", "Backlash along the base tangent, with the front flanks in touch")


def crossing(outline: Array, origin: Array, n: Array) -> list[float]:
    """Places [m] along a line at which it crosses a closed outline, near its origin."""
    across = np.array([-n[1], n[0]])
    away, along = (outline - origin) @ across, (outline - origin) @ n
    after, further = np.roll(away, -1), np.roll(along, -1)
    cut = (away * after <= 0.0) & (np.abs(along) < 0.02)
    share = away[cut] / (away[cut] - after[cut])
    return [float(s) for s in along[cut] + share * (further[cut] - along[cut])]


def touching(outlines: tuple[Array, Array], origin: Array, n: Array) -> list[float]:
    """Places on the line of action at which both outlines meet within a micrometre."""
    one, two = (crossing(outline, origin, n) for outline in outlines)
    return [0.5 * (a + b) for a in one for b in two if abs(a - b) < 1e-6]


def flanks(target: Path) -> None:
    """Numbers of teeth, left and right flanks, a tooth whose pitch is too long."""
    gear = CylindricalGear(z=12, m_n=5e-3, x=0.2, b=20e-3)
    sheet = Sheet(640, 500, [0.0, 0.0], 6200.0)
    sheet.area(gear_outline(gear, 30), FILLS[0])
    form = tooth_form(gear)
    r = np.linspace(form.r_Ff, form.r_Fa, 30)
    half = form.involute_half_angle(r)
    for tooth in range(gear.z):
        middle = 2.0 * math.pi * tooth / gear.z
        for side, colour in ((1.0, GREEN), (-1.0, PURPLE)):
            angle = middle + side * half
            sheet.line(np.column_stack([r * np.cos(angle), r * np.sin(angle)]), colour, 3.2)
        out = 0.5 * gear.d_a + 2.2e-3
        sheet.text([out * math.cos(middle), out * math.sin(middle)], str(tooth), weight="700")
    sheet.arrow([0.0, 0.0], [0.019, 0.0])
    sheet.arrow([0.0, 0.0], [0.0, 0.019])
    sheet.text([0.019, 0.0], "x", (4, 12))
    sheet.text([0.0, 0.019], "y", (-12, 0))
    sheet.out([0.0, 0.0])
    sheet.text([0.0, 0.0], "z", (-15, -12))
    sheet.text([0.0, -0.010], "left flanks", (0, 0), colour=GREEN, weight="700")
    sheet.text([0.0, -0.014], "right flanks", (0, 0), colour=PURPLE, weight="700")
    sheet.turn([0.0, 0.0], 0.0235, (math.radians(100), math.radians(170)), INK)
    sheet.text([-0.0125, 0.0125], "counting", (0, 0))
    sheet.save(target / "flanks.svg", "Numbers of teeth, left and right flanks, seen from +z")


def hands(target: Path) -> None:
    """Right-hand and left-hand gear from the side, the axis upwards."""
    sheet = Sheet(760, 400, [0.0, -2e-3], 3600.0)
    for beta, words, place in ((25.0, "right hand, β > 0", -0.055), (-25.0, "left hand, β < 0", 0.055)):
        gear = CylindricalGear(z=22, m_n=3e-3, beta=math.radians(beta), b=56e-3)
        form = tooth_form(gear)
        z = np.linspace(-0.5 * gear.b, 0.5 * gear.b, 120)
        twist = z * math.tan(gear.beta) / (0.5 * gear.d)
        r_a, r_f = 0.5 * gear.d_a, form.r_f
        sheet.area(
            [[place + s * r_f, h * gear.b / 2] for s, h in ((-1, -1), (1, -1), (1, 1), (-1, 1))], "#c3ced9"
        )
        faces = []
        for tooth in range(gear.z):
            middle = 2.0 * math.pi * tooth / gear.z
            for low, high, fill in (
                ((r_f, -form.root_half_angle), (r_a, -form.tip_half_angle), "#b4c0cd"),
                ((r_a, form.tip_half_angle), (r_f, form.root_half_angle), "#cfd8e2"),
                ((r_a, -form.tip_half_angle), (r_a, form.tip_half_angle), "#eef2f6"),
            ):
                # seen from +x: y to the right; what looks away is omitted
                depth = np.cos(middle + 0.5 * (low[1] + high[1]) + twist)
                seen = depth > 0.0
                left, right = (place + r * np.sin(middle + angle + twist[seen]) for r, angle in (low, high))
                outline = [*zip(left, z[seen], strict=True), *zip(right[::-1], z[seen][::-1], strict=True)]
                if len(outline) > 3:
                    faces.append((float(depth[seen].mean()), outline, fill))
        for _, outline, fill in sorted(faces, key=lambda face: face[0]):
            sheet.area(outline, fill, "#8694a3")
        sheet.arrow([place, 0.5 * gear.b + 1e-3], [place, 0.5 * gear.b + 14e-3])
        sheet.text([place, 0.5 * gear.b + 14e-3], "z", (12, -4))
        sheet.text([place, -0.5 * gear.b], words, (0, -26), weight="700")
    sheet.save(target / "hands.svg", "Right hand and left hand, seen from the side")


def internal(target: Path) -> None:
    """Pinion in a ring: the axis of gear 2 lies behind gear 1, both turn the same way."""
    one = CylindricalGear(z=16, m_n=3e-3, b=20e-3)
    pair = GearPair.at_distance(one, CylindricalGear.internal(z=40, m_n=3e-3, b=20e-3), 36.4e-3)
    sheet = Sheet(640, 560, [pair.a_w, 0.0], 3600.0)
    sheet.gears(pair, 0.1)
    pitch, n = directions(pair, 1)
    for place, r, name in ((0.0, 0.012, "1"), (pair.a_w, 0.020, "2")):
        centre = np.array([place, 0.0])
        sheet.turn(centre, r, (math.radians(100), math.radians(250)), GREEN)
        sheet.out(centre)
        sheet.text(centre, f"z{name}", (12, 16))
    sheet.arrow(pitch, pitch + 0.017 * n, RED, 2.6)
    sheet.text(pitch + 0.017 * n, "n", (10, 4), colour=RED)
    sheet.dot(pitch)
    sheet.text(pitch, "C", (-12, -12))
    sheet.line([[pair.a_w, -0.046], [0.0, -0.046]], INK)
    for x in (pair.a_w, 0.0):
        sheet.line([[x, -0.049], [x, 0.0]], SOFT, 1.0)
    sheet.text([0.5 * pair.a_w, -0.046], f"a_w = {pair.a_w * 1e3:.1f} mm", (0, 12))
    sheet.save(target / "internal.svg", "A pinion in an internal gear")


def forces(target: Path) -> None:
    """Parts of the force on gear 2 at the pitch point, 500 N around at 20 and 10 degrees."""
    one = CylindricalGear(z=19, m_n=4e-3, beta=-math.radians(10), b=30e-3)
    pair = GearPair.from_profile_shifts(one, CylindricalGear(z=25, m_n=4e-3, beta=math.radians(10), b=30e-3))
    around = 500.0
    # the left flank of gear 1 pushes: its outward normal is inclined towards -z on a right hand, +z on a
    # left hand
    apart, along = around * math.tan(pair.alpha_wt), -around * math.tan(one.beta)
    pitch, _ = directions(pair, 1)
    sheet = Sheet(760, 470, pitch, 8200.0)
    sheet.gears(pair, 0.1, front_contact(pair, 0.1))
    scale = 0.044 / around * 0.5
    total = [pitch, moved(pitch, scale * apart, scale * around)]
    sheet.arrow(*total, INK, 2.4)
    sheet.arrow(pitch, moved(pitch, 0.0, scale * around), FORCE_PARTS["circumferential"], 3.2, 12.0)
    sheet.arrow(pitch, moved(pitch, scale * apart, 0.0), FORCE_PARTS["radial"], 3.2, 12.0)
    sheet.out(pitch, FORCE_PARTS["axial"])
    sheet.text(moved(pitch, 0.0, scale * around), f"circumferential {around:.0f} N", (-10, 4), anchor="end",
               colour=FORCE_PARTS["circumferential"], weight="700")  # fmt: skip
    sheet.text(moved(pitch, scale * apart, 0.0), f"radial {apart:.2f} N", (10, 0), anchor="start",
               colour=FORCE_PARTS["radial"], weight="700")  # fmt: skip
    sheet.text(pitch, f"axial {along:.2f} N, along +z", (0, -24), colour=FORCE_PARTS["axial"], weight="700")
    sheet.text(total[1], "in the transverse plane", (12, 0), anchor="start")
    sheet.text(pitch, "gear 1 (left hand)", (-190, -200))
    sheet.text(pitch, "gear 2, on which the parts act", (190, -200))
    sheet.save(target / "forces.svg", "Parts of the mesh force on gear 2")


def write_drawings(target: Path) -> None:
    """Write all drawings into a folder."""
    target.mkdir(parents=True, exist_ok=True)
    for drawing in (signs, path_of_contact, backlash, flanks, hands, internal, forces):
        drawing(target)


if __name__ == "__main__":
    write_drawings(Path(sys.argv[1]))
