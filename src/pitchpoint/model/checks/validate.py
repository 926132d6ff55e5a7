# SPDX-License-Identifier: Apache-2.0
"""All checks of a model, in sequence."""

from __future__ import annotations

from pitchpoint.model.assembly import resolve
from pitchpoint.model.checks.beams import check_beams
from pitchpoint.model.checks.bevel_gears import check_bevel_gears, check_bevel_names, check_bevel_pairs
from pitchpoint.model.checks.carried_meshes import check_carried_meshes
from pitchpoint.model.checks.choices import check_given
from pitchpoint.model.checks.contacts import check_contacts
from pitchpoint.model.checks.elastic_bodies import add_elastic_bodies, check_elastic_bodies
from pitchpoint.model.checks.flank_contact import check_flank_contacts
from pitchpoint.model.checks.flexible_rims import check_flexible_rims
from pitchpoint.model.checks.forces import check_forces, check_loads, check_unbalances
from pitchpoint.model.checks.functions import check_functions
from pitchpoint.model.checks.gears import check_choices
from pitchpoint.model.checks.joints import check_joints
from pitchpoint.model.checks.lubricant import check_lubricant, settle_oil_films
from pitchpoint.model.checks.masses import check_masses, check_motions
from pitchpoint.model.checks.mechanism import check_mechanism
from pitchpoint.model.checks.phasing import check_phasing
from pitchpoint.model.checks.planet_clearance import check_planets
from pitchpoint.model.checks.planet_pins import check_pin_names, check_pins
from pitchpoint.model.checks.planetary_stages import check_pin_errors, check_spacing
from pitchpoint.model.checks.references import check_carriers, check_places, check_references
from pitchpoint.model.checks.scenarios import check_scenarios
from pitchpoint.model.checks.seats import check_seats
from pitchpoint.model.checks.signal_places import check_signal_places
from pitchpoint.model.checks.signals import check_signals
from pitchpoint.model.checks.solids import check_directions, check_solids
from pitchpoint.model.checks.stations import check_stations
from pitchpoint.model.checks.supports import (
    check_couplings,
    check_housings,
    check_positions,
    check_rings,
    check_turning,
)
from pitchpoint.model.checks.tooth_faults import check_fault_laws
from pitchpoint.model.checks.wind_boxes import check_wind_boxes
from pitchpoint.model.checks.wind_rotors import check_wind_rotors
from pitchpoint.model.housing import add_housing, connect_housing
from pitchpoint.model.load_cases import apply_load_case
from pitchpoint.model.parts import Parts
from pitchpoint.model.planetary_stages import add_planetary_stages, told_once
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.scissor_gears import add_scissor_gears
from pitchpoint.model.shafts import add_shafts, check_shaft_places

CHECKS = (
    check_given,
    check_lubricant,
    check_pin_errors,
    check_pin_names,
    add_planetary_stages,
    check_solids,
    add_shafts,
    add_elastic_bodies,
    add_scissor_gears,
    add_housing,
    check_references,
    check_bevel_gears,
    check_bevel_names,
    check_places,
    check_carriers,
    check_choices,
    check_directions,
    check_masses,
    check_joints,
    check_forces,
    check_contacts,
    check_elastic_bodies,
    check_signals,
    check_functions,
    check_positions,
    check_spacing,
    resolve,
    connect_housing,
    check_stations,
    check_planets,
    check_pins,
    check_fault_laws,
    check_flank_contacts,
    check_flexible_rims,
    settle_oil_films,
    check_shaft_places,
    check_mechanism,
    check_seats,
    check_carried_meshes,
    check_signal_places,
    check_beams,
    check_wind_rotors,
    check_wind_boxes,
    check_couplings,
    check_housings,
    check_rings,
    check_turning,
    check_motions,
    apply_load_case,
    check_unbalances,
    check_loads,
    check_scenarios,
    check_phasing,
    check_bevel_pairs,
)
"""In order: later checks rely on earlier ones."""


def check(parts: Parts, report: Reader) -> None:
    """Check the parts of a model and compute the derived data; problems are added to `report`."""
    for each in CHECKS:
        each(parts, report)
    report.problems[:] = told_once(parts.planetary_stages, report.problems)
