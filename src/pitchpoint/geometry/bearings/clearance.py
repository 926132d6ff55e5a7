# SPDX-License-Identifier: Apache-2.0
"""Radial internal clearance by class.

Sources: ISO 5753-1:2009, bearings with cylindrical bore, before mounting. MC1 to MC6, bores below 10 mm: NSK,
*Rolling Bearings*, CAT. No. E1102, table 9.10. CM, motors: Mitsubishi Electric, *SF-PR* instruction manual,
table 14-1 (bores of 10 to 80 mm, which are those of NSK).
"""

from __future__ import annotations

from bisect import bisect_left

from pitchpoint.core.errors import GeometryError

CLASSES = ("C2", "CN", "C3", "C4")
"""Classes of ISO 5753-1."""
MINIATURE = {"MC1": (0, 5), "MC2": (3, 8), "MC3": (5, 10), "MC4": (8, 13), "MC5": (13, 20), "MC6": (20, 28)}
"""Limits [um] of the classes of deep groove ball bearings with a bore below 10 mm, by class."""
MOTOR = "CM"
"""Class of bearings for electric motors."""
ALL_CLASSES = (*CLASSES, *MINIATURE, MOTOR)
"""All classes that are tabulated for some bearings."""
_SMALLEST = 10.0
"""Bore [mm] from which deep groove ball bearings have CM, and below which they have MC1 to MC6."""
_MOTOR_BORES = (18, 30, 50, 80)
_MOTOR = ((4, 11), (5, 12), (9, 17), (12, 22))
_BORES = (
    *(10, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500),
)
"""Upper ends of the ranges of the bore [mm]."""
_SPHERE_BORES = (6, 10, 14, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140)
"""The same of self-aligning ball bearings."""
# limits [um] of each range of the bore: min and max of C2, CN, C3, C4
_BALLS = """
0 7 2 13 8 23 14 29
0 9 3 18 11 25 18 33
0 10 5 20 13 28 20 36
1 11 5 20 13 28 23 41
1 11 6 20 15 33 28 46
1 11 6 23 18 36 30 51
1 15 8 28 23 43 38 61
1 15 10 30 25 51 46 71
1 18 12 36 30 58 53 84
2 20 15 41 36 66 61 97
2 23 18 48 41 81 71 114
2 23 18 53 46 91 81 130
2 25 20 61 53 102 91 147
2 30 25 71 63 117 107 163
2 35 25 85 75 140 125 195
2 40 30 95 85 160 145 225
2 45 35 105 90 170 155 245
2 55 40 115 100 190 175 270
3 60 45 125 110 210 195 300
3 70 55 145 130 240 225 340
3 80 60 170 150 270 250 380
3 90 70 190 170 300 280 420
"""
_ROLLERS = """
0 25 20 45 35 60 50 75
0 25 20 45 35 60 50 75
0 25 20 45 35 60 50 75
0 25 20 45 35 60 50 75
5 30 25 50 45 70 60 85
5 35 30 60 50 80 70 100
10 40 40 70 60 90 80 110
10 45 40 75 65 100 90 125
15 50 50 85 75 110 105 140
15 55 50 90 85 125 125 165
15 60 60 105 100 145 145 190
20 70 70 120 115 165 165 215
25 75 75 125 120 170 170 220
35 90 90 145 140 195 195 250
45 105 105 165 160 220 220 280
45 110 110 175 170 235 235 300
55 125 125 195 190 260 260 330
55 130 130 205 200 275 275 350
65 145 145 225 225 305 305 385
100 190 190 280 280 370 370 460
110 210 210 310 310 410 410 510
110 220 220 330 330 440 440 550
"""
_SPHERICAL = """
10 20 20 35 35 45 45 60
10 20 20 35 35 45 45 60
10 20 20 35 35 45 45 60
15 25 25 40 40 55 55 75
15 30 30 45 45 60 60 80
20 35 35 55 55 75 75 100
20 40 40 65 65 90 90 120
30 50 50 80 80 110 110 145
35 60 60 100 100 135 135 180
40 75 75 120 120 160 160 210
50 95 95 145 145 190 190 240
60 110 110 170 170 220 220 280
65 120 120 180 180 240 240 310
70 130 130 200 200 260 260 340
80 140 140 220 220 290 290 380
90 150 150 240 240 320 320 420
100 170 170 260 260 350 350 460
110 190 190 280 280 370 370 500
120 200 200 310 310 410 410 550
130 220 220 340 340 450 450 600
140 240 240 370 370 500 500 660
140 260 260 410 410 550 550 720
"""
_SELF_ALIGNING = """
1 8 5 15 10 20 15 25
2 9 6 17 12 25 19 33
2 10 6 19 13 26 21 35
3 12 8 21 15 28 23 37
4 14 10 23 17 30 25 39
5 16 11 24 19 35 29 46
6 18 13 29 23 40 34 53
6 19 14 31 25 44 37 57
7 21 16 36 30 50 45 69
8 24 18 40 35 60 54 83
9 27 22 48 42 70 64 96
10 31 25 56 50 83 75 114
10 38 30 68 60 100 90 135
"""
_TABLES = {
    "deep_groove_ball": (_BORES, _BALLS),
    "self_aligning_ball": (_SPHERE_BORES, _SELF_ALIGNING),
    "cylindrical_roller": (_BORES, _ROLLERS),
    "needle_roller": (_BORES, _ROLLERS),
    "spherical_roller": (_BORES, _SPHERICAL),
}
CLASSED = tuple(_TABLES)
"""Types whose clearance is given by a class; that of the others is set when they are mounted."""


def clearance_of(kind: str, bore: float, group: str = "CN") -> tuple[float, float]:
    """Limits of the radial internal clearance [m], before mounting.

    Parameters
    ----------
    kind
        One of `CLASSED`.
    bore
        Bore diameter d [m].
    group
        One of `ALL_CLASSES`.

    Raises
    ------
    GeometryError
        If the bore is beyond the table, or the class is not one of this type and bore.

    Examples
    --------
    >>> [round(1e6 * c) for c in clearance_of("deep_groove_ball", 40e-3, "C3")]
    [15, 33]
    >>> [round(1e6 * c) for c in clearance_of("deep_groove_ball", 8e-3, "MC3")]
    [5, 10]
    >>> [round(1e6 * c) for c in clearance_of("deep_groove_ball", 25e-3, "CM")]
    [5, 12]
    """
    if group not in CLASSES:
        limits = _other_class(kind, round(bore * 1e3, 9), group)
        return limits[0] * 1e-6, limits[1] * 1e-6
    bores, table = _TABLES[kind]
    rows = table.split("\n")[1:-1]
    row = bisect_left(bores, round(bore * 1e3, 9))
    if row >= len(rows):
        raise GeometryError(
            "is beyond the table of radial internal clearances",
            where="inner_diameter",
            value=f"{bore * 1e3:.6g} mm",
            limit=f"{bores[len(rows) - 1]} mm",
            remedy="give clearance",
        )
    k = 2 * CLASSES.index(group)
    low, high = (float(word) * 1e-6 for word in rows[row].split()[k : k + 2])
    return low, high


def _other_class(kind: str, bore: float, group: str) -> tuple[int, int]:
    """Limits [um] of a class that is not one of ISO 5753-1; bore [mm]."""
    ball = kind == "deep_groove_ball"
    if group in MINIATURE:
        if ball and bore < _SMALLEST:
            return MINIATURE[group]
        limit, remedy = f"deep groove ball bearings with a bore below {_SMALLEST:g} mm", "give clearance"
        if group[1:] in CLASSES:
            remedy += f"; a brass cage M with the class {group[1:]} is written M/{group[1:]}"
    else:
        row = bisect_left(_MOTOR_BORES, bore)
        if ball and bore >= _SMALLEST and row < len(_MOTOR):
            return _MOTOR[row]
        limit = f"deep groove ball bearings with a bore of {_SMALLEST:g} to {_MOTOR_BORES[-1]} mm"
        remedy = "give clearance, which is that of the maker of the bearing"
    raise GeometryError(
        "is a clearance class that is not tabulated for this bearing",
        where="clearance_class",
        value=group,
        limit=limit,
        remedy=remedy,
    )


_NUP_BORES = (30, 80, 150, 200, 220, 260)
"""Upper ends of the ranges of the bore [mm] of `_NUP`."""
_NUP = ((37, 140), (47, 155), (62, 180), (87, 230), (95, 230), (95, 250))


def axial_play(bore: float) -> tuple[float, float]:
    """Limits of the axial internal clearance of a cylindrical roller bearing NUP [m].

    Parameters
    ----------
    bore
        Bore diameter d [m].

    Notes
    -----
    Series NUP 2, which has the smallest play; wider and heavier series have up to 1.4 times this. Source:
    SKF, *General Catalogue* (2006), cylindrical roller bearings, table 2.

    Raises
    ------
    GeometryError
        If the bore is beyond the table.

    Examples
    --------
    >>> [round(1e6 * c) for c in axial_play(40e-3)]
    [47, 155]
    """
    row = bisect_left(_NUP_BORES, round(bore * 1e3, 9))
    if row >= len(_NUP_BORES):
        raise GeometryError(
            "is beyond the table of axial clearances",
            where="inner_diameter",
            value=f"{bore * 1e3:.6g} mm",
            limit=f"{_NUP_BORES[-1]} mm",
            remedy="give axial_clearance",
        )
    low, high = _NUP[row]
    return low * 1e-6, high * 1e-6
