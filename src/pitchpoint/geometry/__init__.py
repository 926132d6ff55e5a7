# SPDX-License-Identifier: Apache-2.0
"""Geometry of cylindrical involute gears (ISO 21771) and bevel gears and of their pairs; SI units, radians.

Symbols follow the standard; internal gears have negative tooth numbers, diameters and centre distances.
"""

from pitchpoint.geometry.backlash import Backlash, backlash_at
from pitchpoint.geometry.bevel.cones import pitch_angles, spherical_involute
from pitchpoint.geometry.bevel.gear import BevelGear
from pitchpoint.geometry.bevel.pair import BevelPair
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.form_diameter import root_form_diameter_internal, root_form_diameter_rack
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.involute import (
    base_helix_angle,
    inv,
    inverse_inv,
    transverse_pressure_angle,
    working_pressure_angle,
)
from pitchpoint.geometry.measures import (
    ball_center_angle,
    ball_contact_diameter,
    dimension_over_balls,
    dimension_over_pins,
    ideal_ball_diameter,
    radial_dimension_over_ball,
    span,
    span_contact_diameter,
    span_tooth_count,
)
from pitchpoint.geometry.problems import (
    gear_problems,
    gear_warnings,
    pair_problems,
    pair_warnings,
    tip_overlap_gap,
)
from pitchpoint.geometry.profile_shift import (
    center_distance_for_profile_shift,
    missing_profile_shift,
    pressure_angle_at_center_distance,
    profile_shift_for_center_distance,
    reference_center_distance,
)
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.sliding import (
    SlidingFactors,
    SpecificSliding,
    loss_factor_integral,
    loss_factor_ohlendorf,
    sliding_factor_at,
    sliding_factors,
    specific_sliding,
    specific_sliding_at,
)
from pitchpoint.geometry.tooth_thickness import (
    chordal_thickness,
    helix_angle_at,
    normal_space_width,
    normal_tooth_thickness,
    pressure_angle_at,
    tip_thickness,
    transverse_tooth_thickness,
)

__all__ = [
    "Backlash",
    "BasicRack",
    "BevelGear",
    "BevelPair",
    "CylindricalGear",
    "GearPair",
    "SlidingFactors",
    "SpecificSliding",
    "backlash_at",
    "ball_center_angle",
    "ball_contact_diameter",
    "base_helix_angle",
    "center_distance_for_profile_shift",
    "chordal_thickness",
    "dimension_over_balls",
    "dimension_over_pins",
    "gear_problems",
    "gear_warnings",
    "helix_angle_at",
    "ideal_ball_diameter",
    "inv",
    "inverse_inv",
    "loss_factor_integral",
    "loss_factor_ohlendorf",
    "missing_profile_shift",
    "normal_space_width",
    "normal_tooth_thickness",
    "pair_problems",
    "pair_warnings",
    "pitch_angles",
    "pressure_angle_at",
    "pressure_angle_at_center_distance",
    "profile_shift_for_center_distance",
    "radial_dimension_over_ball",
    "reference_center_distance",
    "root_form_diameter_internal",
    "root_form_diameter_rack",
    "sliding_factor_at",
    "sliding_factors",
    "span",
    "span_contact_diameter",
    "span_tooth_count",
    "specific_sliding",
    "specific_sliding_at",
    "spherical_involute",
    "tip_overlap_gap",
    "tip_thickness",
    "transverse_pressure_angle",
    "transverse_tooth_thickness",
    "working_pressure_angle",
]
