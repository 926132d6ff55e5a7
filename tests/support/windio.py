# SPDX-License-Identifier: Apache-2.0
"""A small turbine in both layouts of windIO, with numbers made up for tests."""

from __future__ import annotations

VERSION_1 = """\
name: small turbine
assembly: {rotor_orientation: Upwind, number_of_blades: 3, hub_height: 80.0, rotor_diameter: 63.0}
components:
  blade:
    outer_shape_bem:
      airfoil_position: {grid: [0.0, 0.2, 0.6, 1.0], labels: [round, round, thick, thin]}
      chord: {grid: [0.0, 0.25, 0.5, 0.75, 1.0], values: [2.0, 2.8, 2.2, 1.6, 0.5]}
      twist: {grid: [0.0, 0.5, 1.0], values: [0.2, 0.1, 0.0]}
      pitch_axis: {grid: [0.0, 1.0], values: [0.5, 0.3]}
      reference_axis: &axis
        x: {grid: [0.0, 0.5, 1.0], values: [0.0, -0.2, -1.0]}
        y: {grid: [0.0, 1.0], values: [0.0, 0.0]}
        z: {grid: [0.0, 1.0], values: [0.0, 30.0]}
    elastic_properties_mb:
      six_x_six:
        reference_axis: *axis
        twist: {grid: [0.0, 0.5, 1.0], values: [0.2, 0.1, 0.0]}
        stiff_matrix:
          grid: [0.0, 1.0]
          values:
            - [1e9, 0, 0, 0, 0, 0, 1e9, 0, 0, 0, 0, 1e10, 1e9, 0, 0, 1e10, 0, 0, 4e9, 0, 1e9]
            - [1e7, 0, 0, 0, 0, 0, 1e7, 0, 0, 0, 0, 1e8, 0, 0, 0, 4e7, 0, 0, 1e6, 0, 1e6]
        inertia_matrix:
          grid: [0.0, 1.0]
          values:
            - [500, 0, 0, 0, 0, -50, 500, 0, 0, 0, 10, 500, 50, -10, 0, 300, 0, 0, 100, 0, 400]
            - [20, 0, 0, 0, 0, 0, 20, 0, 0, 0, 0, 20, 0, 0, 0, 1, 0, 0, 0.2, 0, 1.2]
  hub: {diameter: 3.0, cone_angle: 0.05}
  nacelle: {drivetrain: {uptilt: 0.08, overhang: 4.0, distance_tt_hub: 2.0}}
  tower:
    outer_shape_bem:
      reference_axis:
        x: {grid: [0.0, 1.0], values: [0.0, 0.0]}
        y: {grid: [0.0, 1.0], values: [0.0, 0.0]}
        z: {grid: [0.0, 1.0], values: [2.0, 78.0]}
      outer_diameter: {grid: [0.0, 1.0], values: [6.0, 3.0]}
    internal_structure_2d_fem:
      outfitting_factor: 1.1
      layers:
        - name: wall
          material: steel
          thickness: {grid: [0.0, 1.0], values: [0.03, 0.02]}
airfoils:
  - name: round
    relative_thickness: 1.0
    aerodynamic_center: 0.5
    polars:
      - configuration: Default
        re: 1.0e6
        c_l: {grid: [-3.14, 3.14], values: [0.0, 0.0]}
        c_d: {grid: [-3.14, 3.14], values: [0.5, 0.5]}
        c_m: {grid: [-3.14, 3.14], values: [0.0, 0.0]}
  - name: thick
    relative_thickness: 0.4
    aerodynamic_center: 0.25
    polars:
      - configuration: Default
        re: 1.0e6
        c_l: {grid: [-3.1416, -1.6, 0.0, 0.2, 1.6, 3.1416], values: [0.0, -0.1, 0.3, 1.3, 0.1, 0.0]}
        c_d: {grid: [-3.1416, -1.6, 0.0, 0.2, 1.6, 3.1416], values: [0.02, 1.2, 0.012, 0.03, 1.2, 0.02]}
        c_m: {grid: [-3.1416, 0.0, 3.1416], values: [0.0, -0.05, 0.0]}
  - name: thin
    relative_thickness: 0.2
    aerodynamic_center: 0.25
    polars:
      - configuration: Default
        re: 1.0e6
        c_l: {grid: [-3.1416, -1.6, 0.0, 0.2, 1.6, 3.1416], values: [0.0, -0.1, 0.4, 1.6, 0.1, 0.0]}
        c_d: {grid: [-3.1416, -1.6, 0.0, 0.2, 1.6, 3.1416], values: [0.02, 1.2, 0.006, 0.02, 1.2, 0.02]}
        c_m: {grid: [-3.1416, 0.0, 3.1416], values: [0.0, -0.08, 0.0]}
materials:
  - {name: steel, E: 2.0e11, G: 8.0e10, rho: 7800.0}
control: {torque: {VS_maxspd: 2.0}}
"""

VERSION_2 = """\
windIO_version: "2.0"
name: small turbine
assembly: {rotor_orientation: Upwind, number_of_blades: 3, hub_height: 80.0, rotor_diameter: 63.0}
components:
  blade:
    reference_axis:
      x: {grid: [0.0, 0.5, 1.0], values: [0.0, -0.2, -1.0]}
      y: {grid: [0.0, 1.0], values: [0.0, 0.0]}
      z: {grid: [0.0, 1.0], values: [0.0, 30.0]}
    outer_shape:
      airfoils:
        - {name: round, spanwise_position: 0.0, configuration: [default], weight: [1.0]}
        - {name: round, spanwise_position: 0.2, configuration: [default], weight: [1.0]}
        - {name: thick, spanwise_position: 0.6, configuration: [default], weight: [1.0]}
        - {name: thin, spanwise_position: 1.0, configuration: [default], weight: [1.0]}
      chord: {grid: [0.0, 0.25, 0.5, 0.75, 1.0], values: [2.0, 2.8, 2.2, 1.6, 0.5]}
      twist: {grid: [0.0, 0.5, 1.0], values: [11.459155902616466, 5.729577951308233, 0.0]}
      section_offset_y: {grid: [0.0, 0.25, 0.5, 0.75, 1.0], values: [1.0, 1.26, 0.88, 0.56, 0.15]}
    structure:
      elastic_properties:
        stiffness_matrix:
          grid: [0.0, 1.0]
          K11: [1e9, 1e7]
          K22: [1e9, 1e7]
          K33: [1e10, 1e8]
          K34: [1e9, 0]
          K44: [1e10, 4e7]
          K55: [4e9, 1e6]
          K66: [1e9, 1e6]
        inertia_matrix:
          grid: [0.0, 1.0]
          mass: [500, 20]
          cm_x: [0.02, 0]
          cm_y: [0.1, 0]
          i_edge: [300, 1]
          i_flap: [100, 0.2]
          i_plr: [400, 1.2]
          i_cp: [0, 0]
  hub: {diameter: 3.0, cone_angle: 2.864788975654116}
  drivetrain: {outer_shape: {uptilt: 4.583662361046586, overhang: 4.0, distance_tt_hub: 2.0}}
  tower:
    reference_axis:
      x: {grid: [0.0, 1.0], values: [0.0, 0.0]}
      y: {grid: [0.0, 1.0], values: [0.0, 0.0]}
      z: {grid: [0.0, 1.0], values: [2.0, 78.0]}
    outer_shape:
      outer_diameter: {grid: [0.0, 1.0], values: [6.0, 3.0]}
    structure:
      outfitting_factor: 1.1
      layers:
        - name: wall
          material: steel
          thickness: {grid: [0.0, 1.0], values: [0.03, 0.02]}
airfoils:
  - name: round
    rthick: 1.0
    aerodynamic_center: 0.5
    polars:
      - configuration: default
        re_sets:
          - re: 1.0e6
            cl: {grid: [-180.0, 180.0], values: [0.0, 0.0]}
            cd: {grid: [-180.0, 180.0], values: [0.5, 0.5]}
            cm: {grid: [-180.0, 180.0], values: [0.0, 0.0]}
  - name: thick
    rthick: 0.4
    aerodynamic_center: 0.25
    polars:
      - configuration: default
        re_sets:
          - re: 1.0e6
            cl: {grid: [-180, -91.6732, 0.0, 11.4592, 91.6732, 180], values: [0.0, -0.1, 0.3, 1.3, 0.1, 0.0]}
            cd: {grid: [-180, -91.6732, 0, 11.4592, 91.6732, 180],
              values: [0.02, 1.2, 0.012, 0.03, 1.2, 0.02]}
            cm: {grid: [-180, 0.0, 180], values: [0.0, -0.05, 0.0]}
  - name: thin
    rthick: 0.2
    aerodynamic_center: 0.25
    polars:
      - configuration: default
        re_sets:
          - re: 1.0e6
            cl: {grid: [-180, -91.6732, 0.0, 11.4592, 91.6732, 180], values: [0.0, -0.1, 0.4, 1.6, 0.1, 0.0]}
            cd: {grid: [-180, -91.6732, 0, 11.4592, 91.6732, 180],
              values: [0.02, 1.2, 0.006, 0.02, 1.2, 0.02]}
            cm: {grid: [-180, 0.0, 180], values: [0.0, -0.08, 0.0]}
materials:
  - {name: steel, E: 2.0e11, G: 8.0e10, rho: 7800.0}
control: {rated_rotor_speed: 19.098593171027442}
"""
