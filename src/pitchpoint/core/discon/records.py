# SPDX-License-Identifier: Apache-2.0
"""Records of the swap array between a wind turbine and its controller library.

Numbers and meaning are those of the interface of Bladed (user manual, appendix A, as published with the
ServoDyn module of OpenFAST); records above 1000 are the extension of OpenFAST.
"""

from __future__ import annotations

import re
from typing import NamedTuple

SIZE = 3300
"""Number of records."""
TABLE_START = 145
"""Record of the first speed of a torque table: speed and torque in turn."""
LOG_SIZE = 300
MESSAGE_SIZE = 1025
"""Length of the message of a library, with its end."""
IN, OUT, BOTH, SET = "in", "out", "both", "set"
"""Directions: to the library, from it, both; set by the interface."""


class Record(NamedTuple):
    """One record: number from 1, name, direction, unit and meaning."""

    number: int
    name: str
    direction: str
    unit: str
    meaning: str


RECORDS = (
    Record(1, "simulation_status", SET, "1", "0 at the first call, 1 at all others, -1 at the last one"),
    Record(2, "time", SET, "s", "time"),
    Record(3, "interval", SET, "s", "sample time"),
    Record(4, "blade_1_pitch", IN, "rad", "pitch of blade 1"),
    Record(5, "fine_pitch", IN, "rad", "pitch set point below rated"),
    Record(6, "minimum_pitch", IN, "rad", "minimum pitch"),
    Record(7, "maximum_pitch", IN, "rad", "maximum pitch"),
    Record(8, "minimum_pitch_rate", IN, "rad/s", "minimum pitch rate, negative"),
    Record(9, "maximum_pitch_rate", IN, "rad/s", "maximum pitch rate"),
    Record(10, "pitch_actuator", SET, "1", "0: pitch demands are angles, 1: rates"),
    Record(11, "present_pitch_demand", SET, "rad", "pitch demand of the previous call"),
    Record(12, "present_pitch_rate_demand", SET, "rad/s", "pitch rate demand of the previous call"),
    Record(13, "power_demand", IN, "W", "demanded power"),
    Record(14, "shaft_power", IN, "W", "power of the rotor shaft"),
    Record(15, "electrical_power", IN, "W", "electrical power"),
    Record(
        16,
        "optimal_mode_gain",
        IN,
        "N m s^2",
        "generator torque over the square of the speed, below rated",
    ),
    Record(17, "minimum_generator_speed", IN, "rad/s", "minimum generator speed"),
    Record(18, "maximum_optimal_speed", IN, "rad/s", "maximum generator speed below rated"),
    Record(19, "generator_speed_demand", IN, "rad/s", "generator speed above rated"),
    Record(20, "generator_speed", IN, "rad/s", "generator speed"),
    Record(21, "rotor_speed", IN, "rad/s", "rotor speed"),
    Record(22, "rated_torque_demand", IN, "N m", "generator torque above rated"),
    Record(23, "generator_torque", IN, "N m", "generator torque"),
    Record(24, "yaw_error", IN, "rad", "yaw error"),
    Record(25, "torque_table_start", SET, "1", "record of the first speed of the torque table, 0 without"),
    Record(26, "torque_table_points", SET, "1", "points of the torque table"),
    Record(27, "wind_speed", IN, "m/s", "wind speed at the hub"),
    Record(28, "pitch_control", SET, "1", "0: collective, 1: individual"),
    Record(29, "yaw_control", SET, "1", "0: the yaw demand is a rate, 1: a torque"),
    Record(30, "blade_1_out_of_plane_moment", IN, "N m", "root moment of blade 1, out of the rotor plane"),
    Record(31, "blade_2_out_of_plane_moment", IN, "N m", "root moment of blade 2, out of the rotor plane"),
    Record(32, "blade_3_out_of_plane_moment", IN, "N m", "root moment of blade 3, out of the rotor plane"),
    Record(33, "blade_2_pitch", IN, "rad", "pitch of blade 2"),
    Record(34, "blade_3_pitch", IN, "rad", "pitch of blade 3"),
    Record(35, "generator_contactor", BOTH, "1", "0: off, 1: main, 2: low-speed generator"),
    Record(
        36,
        "shaft_brake",
        BOTH,
        "1",
        "sum of 1, 2: shaft brakes; 4: generator brake; 8: third brake; 16: torque of record 107",
    ),
    Record(37, "nacelle_yaw", IN, "rad", "nacelle angle from north"),
    Record(41, "yaw_torque_demand", OUT, "N m", "demanded yaw torque"),
    Record(42, "blade_1_pitch_demand", OUT, "rad", "demanded pitch of blade 1, or its rate"),
    Record(43, "blade_2_pitch_demand", OUT, "rad", "demanded pitch of blade 2, or its rate"),
    Record(44, "blade_3_pitch_demand", OUT, "rad", "demanded pitch of blade 3, or its rate"),
    Record(45, "pitch_demand", OUT, "rad", "demanded collective pitch"),
    Record(46, "pitch_rate_demand", OUT, "rad/s", "demanded collective pitch rate"),
    Record(47, "generator_torque_demand", OUT, "N m", "demanded generator torque"),
    Record(48, "yaw_rate_demand", OUT, "rad/s", "demanded yaw rate"),
    Record(49, "message_size", SET, "1", "length of the message, with its end"),
    Record(50, "infile_size", SET, "1", "length of the name of the input file, with its end"),
    Record(51, "outname_size", SET, "1", "length of the name of output files, with its end"),
    Record(53, "tower_top_fore_aft_acceleration", IN, "m/s^2", "acceleration of the tower top, fore-aft"),
    Record(54, "tower_top_side_acceleration", IN, "m/s^2", "acceleration of the tower top, side to side"),
    Record(55, "pitch_override", OUT, "1", "must be 0"),
    Record(56, "torque_override", OUT, "1", "must be 0"),
    Record(60, "rotor_azimuth", IN, "rad", "azimuth of blade 1"),
    Record(61, "blades", SET, "1", "number of blades"),
    Record(62, "log_size", SET, "1", "maximum number of values for logging"),
    Record(63, "log_start", SET, "1", "record of the first value for logging"),
    Record(64, "log_names_size", SET, "1", "maximum length of the names of values for logging"),
    Record(65, "log_values", OUT, "1", "number of values for logging"),
    Record(66, "platform_start", SET, "1", "record of the first platform motion"),
    Record(69, "blade_1_in_plane_moment", IN, "N m", "root moment of blade 1, in the rotor plane"),
    Record(70, "blade_2_in_plane_moment", IN, "N m", "root moment of blade 2, in the rotor plane"),
    Record(71, "blade_3_in_plane_moment", IN, "N m", "root moment of blade 3, in the rotor plane"),
    Record(72, "start_up_resistance", OUT, "1", "generator resistance at the start"),
    Record(73, "rotating_hub_moment_y", IN, "N m", "moment of the rotating hub about y"),
    Record(74, "rotating_hub_moment_z", IN, "N m", "moment of the rotating hub about z"),
    Record(75, "fixed_hub_moment_y", IN, "N m", "moment of the hub in fixed directions about y"),
    Record(76, "fixed_hub_moment_z", IN, "N m", "moment of the hub in fixed directions about z"),
    Record(77, "yaw_bearing_moment_y", IN, "N m", "moment of the yaw bearing about y"),
    Record(78, "yaw_bearing_moment_z", IN, "N m", "moment of the yaw bearing about z"),
    Record(79, "load_request", OUT, "1", "loads that the controller needs"),
    Record(80, "slip_current_status", OUT, "1", "1: the slip current is demanded"),
    Record(81, "slip_current_demand", BOTH, "1", "demanded slip current"),
    Record(82, "nacelle_roll_acceleration", IN, "rad/s^2", "roll acceleration of the nacelle"),
    Record(83, "nacelle_nodding_acceleration", IN, "rad/s^2", "nodding acceleration of the nacelle"),
    Record(84, "nacelle_yaw_acceleration", IN, "rad/s^2", "yaw acceleration of the nacelle"),
    Record(92, "mean_wind_increment", OUT, "m/s", "change of the mean wind speed"),
    Record(93, "turbulence_increment", OUT, "1", "change of the turbulence intensity"),
    Record(94, "wind_direction_increment", OUT, "rad", "change of the wind direction"),
    Record(95, "air_density", IN, "kg/m^3", "density of the air (OpenFAST)"),
    Record(96, "mean_wind_speed", IN, "m/s", "mean wind speed (OpenFAST)"),
    Record(98, "safety_system", OUT, "1", "number of the safety system to activate"),
    Record(102, "yaw_control_flag", OUT, "1", "4: yaw torque instead of yaw rate"),
    Record(103, "yaw_stiffness", OUT, "N m/rad", "yaw stiffness"),
    Record(104, "yaw_damping", OUT, "N m s/rad", "yaw damping"),
    Record(107, "brake_torque_demand", OUT, "N m", "demanded brake torque"),
    Record(108, "yaw_brake_torque_demand", OUT, "N m", "demanded torque of the yaw brake"),
    Record(109, "shaft_torque", IN, "N m", "torque of the rotor shaft"),
    Record(110, "thrust", IN, "N", "force of the rotor shaft along its axis"),
    Record(111, "shaft_force_y", IN, "N", "force of the rotor shaft in fixed directions along y"),
    Record(112, "shaft_force_z", IN, "N", "force of the rotor shaft in fixed directions along z"),
    Record(117, "controller_state", SET, "1", "0: power production"),
    Record(120, "blade_1_flap_demand", OUT, "1", "user variable 1; flap of blade 1 (OpenFAST)"),
    Record(121, "blade_2_flap_demand", OUT, "1", "user variable 2; flap of blade 2 (OpenFAST)"),
    Record(122, "blade_3_flap_demand", OUT, "1", "user variable 3; flap of blade 3 (OpenFAST)"),
    Record(129, "size", SET, "1", "number of records"),
    Record(1000, "extension", SET, "1", "version of the records above 1000"),
    Record(1001, "platform_translation_x", IN, "m", "translation of the platform along x"),
    Record(1002, "platform_translation_y", IN, "m", "translation of the platform along y"),
    Record(1003, "platform_translation_z", IN, "m", "translation of the platform along z"),
    Record(1004, "platform_rotation_x", IN, "rad", "rotation of the platform about x"),
    Record(1005, "platform_rotation_y", IN, "rad", "rotation of the platform about y"),
    Record(1006, "platform_rotation_z", IN, "rad", "rotation of the platform about z"),
    Record(
        1007,
        "platform_translation_velocity_x",
        IN,
        "m/s",
        "translation velocity of the platform along x",
    ),
    Record(
        1008,
        "platform_translation_velocity_y",
        IN,
        "m/s",
        "translation velocity of the platform along y",
    ),
    Record(
        1009,
        "platform_translation_velocity_z",
        IN,
        "m/s",
        "translation velocity of the platform along z",
    ),
    Record(1010, "platform_rotation_velocity_x", IN, "rad/s", "rotation velocity of the platform about x"),
    Record(1011, "platform_rotation_velocity_y", IN, "rad/s", "rotation velocity of the platform about y"),
    Record(1012, "platform_rotation_velocity_z", IN, "rad/s", "rotation velocity of the platform about z"),
    Record(
        1013,
        "platform_translation_acceleration_x",
        IN,
        "m/s^2",
        "translation acceleration of the platform along x",
    ),
    Record(
        1014,
        "platform_translation_acceleration_y",
        IN,
        "m/s^2",
        "translation acceleration of the platform along y",
    ),
    Record(
        1015,
        "platform_translation_acceleration_z",
        IN,
        "m/s^2",
        "translation acceleration of the platform along z",
    ),
    Record(
        1016,
        "platform_rotation_acceleration_x",
        IN,
        "rad/s^2",
        "rotation acceleration of the platform about x",
    ),
    Record(
        1017,
        "platform_rotation_acceleration_y",
        IN,
        "rad/s^2",
        "rotation acceleration of the platform about y",
    ),
    Record(
        1018,
        "platform_rotation_acceleration_z",
        IN,
        "rad/s^2",
        "rotation acceleration of the platform about z",
    ),
)
BY_NAME = {record.name: record for record in RECORDS}
BY_NUMBER = {record.number: record for record in RECORDS}


def find_record(name: str | int) -> Record | None:
    """The record of a name; None if there is none.

    Parameters
    ----------
    name
        Name or number of the record; `record_N` is the name of any record N.

    Examples
    --------
    >>> find_record("generator_torque_demand").number, find_record("record_47").unit
    (47, 'N m')
    >>> find_record(2600).direction, find_record("record_9999")
    ('both', None)
    """
    number = name if isinstance(name, int) else 0
    if isinstance(name, str):
        if name in BY_NAME:
            return BY_NAME[name]
        match = re.fullmatch(r"record_([1-9]\d{0,3})", name)
        number = int(match[1]) if match else 0
    if not 1 <= number <= SIZE:
        return None
    return BY_NUMBER.get(number) or Record(number, f"record_{number}", BOTH, "1", "without a name")
