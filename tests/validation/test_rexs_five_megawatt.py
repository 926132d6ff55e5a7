# SPDX-License-Identifier: Apache-2.0
"""KS-NRELGBX from a REXS file: stages 1 and 3 of the 5 MW reference gearbox against KISSsoft 03/2017 reports.

Source, printed numbers and their rounding: see `test_nrel_gearbox_geometry`. Here the data of the reports
are a REXS 2.0.0 file, as XML and as JSON, with profile shift and tip diameters of gear 1 and the centre
distance as printed; the other shifts follow from the centre distance. Tolerance: half a unit of the last
printed digit, a whole one where a value follows from tip diameters printed to a micrometre (marked).
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.io.rexs.importing import import_rexs
from tests.support.printed import printed
from tests.support.rexs_files import Part, Relation, as_json, place, rexs

FLANK = {"normal_pressure_angle": 20}


def section(length, diameter):
    return {
        "u_coordinate_on_shaft": 0,
        "length": length,
        "outer_diameter_begin": diameter,
        "outer_diameter_end": diameter,
    }


class File:
    """Parts and relations of a file, with the next free number."""

    def __init__(self) -> None:
        self.parts: dict[int, Part] = {}
        self.relations: list[Relation] = []

    def add(self, kind, values, **owner):
        number = len(self.parts) + 1
        self.parts[number] = (kind, values)
        if owner:
            self.relations.append(("assembly", {"assembly": owner["part_of"], "part": number}))
        return number

    def relate(self, kind, **roles):
        self.relations.append((kind, roles))

    def shaft(self, position, length, diameter, unit):
        number = self.add("shaft", place(*position), part_of=unit)
        self.add("shaft_section", section(length, diameter), part_of=number)
        return number

    def gear(self, shaft, u, kind="cylindrical_gear", x=None, **values):
        gear = self.add(kind, {"u_coordinate_on_shaft": u, **values}, part_of=shaft)
        shift = {} if x is None else {"addendum_modification_coefficient": x}
        left, right = (self.add("cylindrical_gear_flank", {**FLANK, **shift}) for _ in "lr")
        self.relate("flank", gear=gear, left=left, right=right)
        return gear

    def mesh(self, one, two, distance, unit):
        stage = self.add("cylindrical_stage", {"center_distance": distance}, part_of=unit)
        self.relate("stage", stage=stage, gear_1=one, gear_2=two)

    def bearing(self, shaft, u, outer):
        number = self.add("concept_bearing", {"u_coordinate_on_shaft_inner_side": u, **SOFT})
        self.relate("side", assembly=number, inner_part=shaft, outer_part=outer)


SOFT = {"radial_stiffness": 1e9, "axial_stiffness": 1e9, "axial_force_absorption": "both_directions"}


def gearbox() -> str:
    """Text of the REXS file."""
    file = File()
    unit = file.add("gear_unit", place(0, 0, 0))
    casing = file.add("gear_casing", {}, part_of=unit)
    # stage 3: helical, 24/95
    high, low = file.shaft((1000, 0, 861), 600, 300, unit), file.shaft((1000, 0, 0), 600, 900, unit)
    helical = {"normal_module": 14, "face_width": 360}
    pinion = file.gear(
        high,
        300,
        number_of_teeth=24,
        helix_angle_reference_diameter=10,
        x=0.48,
        tip_diameter=380.747,
        **helical,
    )
    wheel = file.gear(
        low, 300, number_of_teeth=95, helix_angle_reference_diameter=-10, tip_diameter=1395.376, **helical
    )
    file.mesh(pinion, wheel, 861, unit)
    # stage 1: planetary, 19/17/56
    teeth = {"normal_module": 45, "face_width": 491}
    sun_shaft = file.shaft((0, 0, 0), 600, 600, unit)
    ring_shaft = file.shaft((0, 0, 0), 600, 3200, unit)
    file.parts[ring_shaft + 1] = ("shaft_section", {**section(600, 3200), "inner_diameter_begin": 3000})
    sun = file.gear(sun_shaft, 300, number_of_teeth=19, x=0.617, tip_diameter=978.808, **teeth)
    ring = file.gear(ring_shaft, 300, "ring_gear", number_of_teeth=56, **teeth)
    cutter = file.add(
        "cutter_wheel_tool",
        {
            "number_of_teeth": 36,
            "addendum_coefficient_reference_profile": 1.3134,
            "tip_corner_radius_factor_reference_profile": 0.3,
        },
    )
    settings = file.add("cylindrical_gear_manufacturing_settings", {})
    file.relate("manufacturing_step", workpiece=ring, tool=cutter, manufacturing_settings=settings)
    stage = file.add("planetary_stage", {}, part_of=unit)
    carrier = file.add("planet_carrier", {}, part_of=stage)
    carrier_shaft = file.add("shaft", place(-600, 0, 0), part_of=carrier)
    file.add("shaft_section", section(500, 800), part_of=carrier_shaft)
    file.relate("planet_carrier_shaft", planetary_stage=stage, shaft=carrier_shaft)
    for shaft in (sun_shaft, ring_shaft):
        file.relate("central_shaft", planetary_stage=stage, shaft=shaft)
    for k in range(3):
        angle = math.tau * k / 3
        at = (0, 863 * math.sin(angle), 863 * math.cos(angle))
        planet_shaft, pin = file.shaft(at, 600, 300, unit), file.add("shaft", place(*at), part_of=carrier)
        file.add("shaft_section", section(600, 250), part_of=pin)
        planet = file.gear(planet_shaft, 300, number_of_teeth=17, tip_diameter=905.470, **teeth)
        file.relate("planet_shaft", planetary_stage=stage, shaft=planet_shaft)
        file.relate("planet_pin", planetary_stage=stage, shaft=pin)
        file.mesh(sun, planet, 863, stage)
        file.mesh(planet, ring, 863, stage)
        for u in (150, 450):
            bearing = file.add(
                "concept_bearing",
                {"u_coordinate_on_shaft_inner_side": u, "u_coordinate_on_shaft_outer_side": u, **SOFT},
            )
            file.relate("side", assembly=bearing, inner_part=pin, outer_part=planet_shaft)
    for shaft in (high, low, sun_shaft, ring_shaft, carrier_shaft):
        for u in (50, 450):
            file.bearing(shaft, u, casing)
    return rexs(file.parts, file.relations, version="2.0.0")


@pytest.fixture(scope="module", params=["xml", "json"])
def pairs(request, tmp_path_factory):
    text = gearbox()
    path = tmp_path_factory.mktemp("rexs") / f"gearbox.{request.param}"
    path.write_text(text if request.param == "xml" else as_json(text), encoding="utf-8")
    found = import_rexs(path).model.pairs
    by_teeth = {(pair.gear1.z, pair.gear2.z): pair for pair in found.values()}
    assert len(found) == 7
    return by_teeth[24, 95], by_teeth[19, 17], by_teeth[17, -56]


def millimetres(*pairs, units=0.5):
    for value, text in pairs:
        assert abs(value) * 1e3 == printed(text, units), text


def test_profile_shifts_follow_from_the_centre_distances(pairs):
    helical, sun_planet, planet_ring = pairs
    assert (helical.gear2.x, sun_planet.gear2.x) == (printed("0.6691"), printed("0.8021"))
    assert planet_ring.gear2.x == printed("-0.5013")
    for pair, angle in zip(pairs, ("22.856", "28.118", "17.161"), strict=True):
        assert math.degrees(pair.alpha_wt) == printed(angle)
    assert helical.x_sum == printed("1.1491")


def test_diameters(pairs):
    helical, sun_planet, planet_ring = pairs
    pinion, wheel, sun, planet = helical.gear1, helical.gear2, sun_planet.gear1, sun_planet.gear2
    ring = planet_ring.gear2
    millimetres(
        (pinion.d, "341.183"), (wheel.d, "1350.517"), (pinion.d_b, "320.026"), (wheel.d_b, "1266.770"),
        (pinion.d_f, "319.623"), (wheel.d_f, "1334.252"), (helical.d_w1, "347.294"),
        (helical.d_w2, "1374.706"),
        (pinion.d_Ff, "328.991"), (wheel.d_Ff, "1341.487"),
        (sun.d_f, "798.030"), (planet.d_f, "724.692"), (ring.d_f, "2677.618"), (ring.d_a, "2475.118"),
        (sun.d_Ff, "825.979"), (planet.d_Ff, "748.795"),
        (sun_planet.d_w1, "910.944"), (planet_ring.d_w2, "2478.359"),
    )  # fmt: skip
    # the tip diameters are printed to a micrometre, and what follows from them
    millimetres(
        (helical.d_Nf1, "330.798"), (helical.d_Nf2, "1348.584"), (sun_planet.d_Nf1, "845.350"),
        (sun_planet.d_Nf2, "762.541"), (planet_ring.d_Nf1, "749.170"), (planet_ring.d_Nf2, "2594.369"),
        (ring.d_Ff, "2662.682"),
        units=1.0,
    )  # fmt: skip


def test_paths_of_contact(pairs):
    helical, sun_planet, planet_ring = pairs
    millimetres(
        (helical.p_et, "41.891"), (helical.g_alpha, "61.276"), (helical.T1A, "41.865"),
        (helical.T1E, "103.141"),
        (sun_planet.g_alpha, "148.093"), (planet_ring.g_alpha, "169.815"), (sun_planet.T1A, "131.439"),
        units=1.0,
    )  # fmt: skip
    assert (helical.eps_alpha, helical.eps_beta) == (printed("1.463"), printed("1.421"))
    assert (sun_planet.eps_alpha, planet_ring.eps_alpha) == (printed("1.115"), printed("1.278"))
