# SPDX-License-Identifier: Apache-2.0
"""Random gears: either there is a sound tooth, or a `PitchpointError` says why not."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.core.errors import PitchpointError
from pitchpoint.geometry.cutter import PinionCutter
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import gear_mass_properties, section_integrals
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.tooth_form import gear_outline, tooth_form


@st.composite
def gears(draw: st.DrawFn) -> CylindricalGear:
    """Gears from sensible to absurd; many of them cannot exist."""
    internal = draw(st.booleans())
    z = draw(st.integers(1, 200))
    rack = BasicRack(
        h_aP_star=draw(st.floats(0.5, 1.5)),
        h_fP_star=draw(st.floats(0.8, 2.0)),
        rho_fP_star=draw(st.floats(0.0, 0.8)),
    )
    cutter = None
    if internal and draw(st.booleans()):
        cutter = PinionCutter(z_0=draw(st.integers(1, 220)), x_0=draw(st.floats(-0.5, 0.5)))
    return CylindricalGear(
        z=-z if internal else z,
        m_n=1e-3,
        alpha_n=draw(st.floats(math.radians(14.5), math.radians(30.0))),
        beta=draw(st.floats(-0.7, 0.7)),
        x=draw(st.floats(-1.5, 1.5)),
        rack=rack,
        thickness_allowance=draw(st.floats(-2e-4, 0.0)),
        cutter=cutter,
    )


@settings(max_examples=150, deadline=None)
@given(gear=gears())
def test_tooth_is_sound_or_refused(gear: CylindricalGear) -> None:
    try:
        form = tooth_form(gear)
    except PitchpointError:
        return
    r, half, _ = form.flank(60)
    assert np.isfinite(r).all()
    assert (half > 0.0).all()
    assert (half <= form.half_pitch_angle * (1.0 + 1e-9)).all()
    # from root to tip, apart from round-off
    assert (form.sign * np.diff(r) > -1e-12 * form.r_b).all()
    area, polar = section_integrals(form)
    x, y = gear_outline(gear, 60).T
    polygon = 0.5 * float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())
    assert abs(polygon / area - 1.0) < 2e-3 + 0.5 / abs(gear.z) ** 2
    assert 0.0 < polar < area * max(form.r_a, form.r_f) ** 2
    found = gear_mass_properties(gear, 7800.0)
    assert found.mass > 0.0
    assert found.transverse_inertia > 0.5 * found.polar_inertia


@settings(max_examples=60, deadline=None)
@given(gear=gears())
def test_form_diameter_agrees_with_the_macro_geometry(gear: CylindricalGear) -> None:
    try:
        form = tooth_form(gear)
        expected = abs(gear.d_Ff)
    except PitchpointError:
        return
    assert math.isclose(2.0 * form.r_Ff, expected, rel_tol=1e-9)
