# SPDX-License-Identifier: Apache-2.0
"""WT-DRIVE: torsion of two wind turbines, generator locked and free, with the gearbox as a rigid ratio.

Sources: DTU 10 MW, C. Bak et al., Description of the DTU 10 MW reference wind turbine, DTU Wind Energy Report
I-0092 (2013), tables 6.2 and 6.3, as quoted in gfsReboucas/Drivetrain: 0.612 Hz fixed-free, 4.003 Hz
free-free, 2 317 025 352 N m/rad, 1500.5 kg m^2, 1:50. NREL 5 MW, J. Jonkman et al., NREL/TP-500-38060 (2009),
tables 5-1 and 9-1: 0.61495 Hz (mean of FAST and ADAMS), 867.637e6 N m/rad, 534.116 kg m^2, 1:97, a damping
ratio of 5 %, from which its damping follows; 2.180 Hz free-free.

The inertia of the rotor follows from the frequency with the generator locked, as in the sources, since
published inertias are those of rigid blades; the frequency with a free generator is then the test. Tolerance:
half the last digit printed.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

TEXT = """\
bodies:
  rotor: {{inertia: {rotor} kg m^2}}
  slow_side: {{inertia: 1 kg m^2}}
  generator: {{inertia: {generator} kg m^2, position: [1 m, 0, 0]}}
couplings:
  shaft: {{bodies: [rotor, slow_side], stiffness: {{torsion: {stiffness} N m/rad}}}}
ratios:
  gearbox: {{terms: {{slow_side: {ratio}, generator: {sense}}}}}
scenarios:
  free: {{duration: 1 s}}
  locked: {{drive: {{generator: {{speed: 0 rpm}}}}, duration: 1 s}}
"""


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize(
    ("stiffness", "generator", "ratio", "locked", "free"),
    [(2317025352.0, 1500.5, 50, 0.612, 4.003), (867.637e6, 534.116, 97, 0.61495, 2.180)],
    ids=["DTU 10 MW", "NREL 5 MW"],
)
def test_locked_and_free_generator(stiffness, generator, ratio, locked, free, sense):
    """The sense of rotation of the generator does not matter."""
    rotor = stiffness / (math.tau * locked) ** 2
    text = TEXT.format(rotor=rotor, generator=generator, stiffness=stiffness, ratio=ratio, sense=sense)
    model = loads_model(text)
    fixed, open_ended = (
        find_modes(compile_model(model, name), name).frequency for name in ("locked", "free")
    )
    assert fixed[0] == pytest.approx(locked, rel=1e-6)  # the ratio transmits the hold of the generator
    assert open_ended[0] == pytest.approx(0.0, abs=1e-4)
    assert open_ended[1] == pytest.approx(free, abs=0.5e-3)
