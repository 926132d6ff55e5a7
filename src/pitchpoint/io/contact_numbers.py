# SPDX-License-Identifier: Apache-2.0
"""Single numbers in result files: impacts, closing speeds, impulses, contact shares."""

from __future__ import annotations

RATTLE = (
    ("contact_loss_share", "1", "share of the time without contact"),
    ("back_contact_share", "1", "share of the time with contact on the back flank"),
    ("impact_rate", "1/s", "impacts per time after separations"),
    ("closing_speed_max", "m/s", "largest speed at which flanks meet, normal to them"),
    ("impulse_max", "N s", "largest impulse of an impact"),
    ("contact_frequency", "Hz", "frequency with which contact of one flank begins"),
    ("front_impacts", "1", "number of impacts on the front flank"),
    ("back_impacts", "1", "number of impacts on the back flank"),
    ("closing_speed_mean", "m/s", "mean speed at which flanks meet"),
    ("closing_speed_rms", "m/s", "rms of the speed at which flanks meet"),
    ("impulse_mean", "N s", "mean impulse of an impact"),
    ("front_contact_share", "1", "share of the time with contact on the front flank"),
    ("both_flanks_share", "1", "share of the time with contact on both flanks"),
    ("longest_loss", "s", "longest time without contact"),
    ("shortest_contact", "s", "shortest contact after an impact"),
    ("resolution", "s", "largest step between two checks of the contact"),
    ("rattle_index", "1", "inertia torque of the idle gear over its drag torque"),
    ("load_reversal", "1", "load of the back flank over that of the front flank, smaller over larger"),
    ("peak_force_ratio", "1", "largest mesh force over the mean load of the mesh"),
    ("flank_changes_per_revolution", "1", "changes of the flank in contact per revolution of gear 1"),
    ("impact_energy_per_revolution", "J", "kinetic energy of the impacts per revolution of gear 1"),
)
"""Numbers of the contact of a mesh: name, unit, description; see `analysis.rattle.Rattle` and
`solvers.contact_counts`."""
