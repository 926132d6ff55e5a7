# SPDX-License-Identifier: Apache-2.0
"""WT-IEA15: the IEA 15 MW rotor from its windIO file against its report, its AeroDyn file and CCBlade.

Source: E. Gaertner et al., Definition of the IEA 15-Megawatt Offshore Reference Wind Turbine,
NREL/TP-5000-75698 (2020), and its repository IEAWindTask37/IEA-15-240-RWT (Apache License 2.0), file
Documentation/IEA-15-240-RWT_tabular.xlsx, sheet Rotor Performance. WISDEM computed the sheet; the exponent of
the shear is that of the windIO file, 0.12. Its rotor diameter is 241.94 m, that of the shape 240.8 m.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.windio.rotor import WindIORotor, read_windio_rotor
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.rotor_performance import solve_rotor_performance
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.rotors import FOLDER

RPM = np.pi / 30.0
FILE = FOLDER.parent / "iea_15mw" / "IEA-15-240-RWT.yaml"

# U [m/s], rpm, pitch [deg], aerodynamic power (power times the ratio of both coefficients) [MW], thrust [MN]
SHEET = [
    (3.0000, 5.0000, 3.9203, 0.0444, 0.20291),
    (3.5495, 5.0000, 3.9130, 0.3055, 0.27578),
    (4.5539, 5.0000, 3.3479, 1.0251, 0.45401),
    (6.4619, 5.0000, 0.8917, 3.4512, 0.91818),
    (7.5009, 5.3290, 0.0000, 5.4574, 1.22224),
    (9.3856, 6.6680, 0.0000, 10.6916, 1.91364),
    (10.6584, 7.4992, 0.0000, 15.6648, 2.44734),
    (11.6993, 7.4992, 5.3965, 15.6648, 1.76914),
    (13.4652, 7.4992, 9.1243, 15.6647, 1.42307),
    (17.6743, 7.4992, 15.1057, 15.6648, 1.04541),
    (21.6609, 7.4992, 19.5694, 15.6648, 0.86654),
    (25.0000, 7.4992, 22.8802, 15.6648, 0.77248),
]


@cache
def turbine() -> WindIORotor:
    """The file of the turbine, shortened."""
    return read_windio_rotor(FILE)


def performance(pitch: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Power [MW] and thrust [MN] at the points of the sheet, with the pitch changed by some degrees."""
    u, rpm, theta, _, _ = np.array(SHEET).T
    flow = RotorFlow(skewed_wake=False, shear_exponent=0.12)
    found = solve_rotor_performance(turbine().rotor, u, rpm * RPM, np.radians(theta + pitch), flow=flow)
    return found.rotor_power.values / 1e6, found.rotor_thrust.values / 1e6


def test_rotor_performance_of_the_report() -> None:
    """Thrust to 1 % and power to 1.2 % from 4.5 m/s to the rated speed, and to 0.02 MW below, where power
    is a small difference. Above it both are those of a pitch that differs by less than 0.15 deg."""
    u, _, _, power, thrust = np.array(SHEET).T
    ours = performance()
    slow, rated = u < 4.0, u < 10.7
    np.testing.assert_allclose(ours[1][rated], thrust[rated], rtol=0.01)
    np.testing.assert_allclose(ours[0][rated & ~slow], power[rated & ~slow], rtol=0.012)
    np.testing.assert_allclose(ours[0][slow], power[slow], atol=0.02)
    more = performance(0.1)
    for own, turned, theirs in zip(ours, more, (power, thrust), strict=True):
        degrees = 0.1 * (theirs - own) / (turned - own)
        assert np.abs(degrees[~rated]).max() < 0.15


CCBLADE = {
    "straight": ([0.04522297, 16.57334495, 16.98499018], [0.21386554, 1.48765042, 0.84303187], 1e-5),
    "inclined": ([0.03875611, 16.23342521, 16.34852654], [0.20917259, 1.45875082, 0.81656923], 5e-3),
}
"""Power [MW], thrust [MN], tolerance."""


def test_same_rotor_as_ccblade() -> None:
    """CCBlade of WISDEM 4.2.9 (Apache-2.0) with our stations and polars at three points of the sheet.

    Without cone and prebend to 1e-5; with cone 4 deg and prebend to 0.5 %: it takes lengths along the blade
    as radii of tip loss and of the balance of momentum.
    """
    u, rpm, pitch, _, _ = np.array(SHEET)[[0, 8, 11]].T
    blade = turbine().rotor.blade
    zero = np.zeros(blade.span.size)
    straight = replace(blade, prebend=zero, sweep=zero, curve_angle=zero)
    rotors = {
        "straight": replace(turbine().rotor, blade=straight, precone=0.0, tilt=0.0),
        "inclined": replace(turbine().rotor, tilt=0.0),
    }
    for name, (power, thrust, close) in CCBLADE.items():
        found = solve_rotor_performance(
            rotors[name], u, rpm * RPM, np.radians(pitch), flow=RotorFlow(sectors=1)
        )
        np.testing.assert_allclose(found.rotor_power.values[1:] / 1e6, power[1:], rtol=close)
        np.testing.assert_allclose(found.rotor_power.values[0] / 1e6, power[0], atol=2e-3)
        np.testing.assert_allclose(found.rotor_thrust.values / 1e6, thrust, rtol=close)


# AeroDyn file of the repository: span, prebend, sweep [m], twist [deg] of rows 1, 3, 11, 21, 31, 41, 50
AERODYN = [
    (0.0, -6.35412236e-03, -2.276626484e-02, 15.5945530),
    (4.775507409, 6.621685688e-02, 8.694386659e-02, 15.4108347),
    (23.87753705, 1.862701718e-01, -4.162773968e-01, 8.5515222),
    (47.75507409, 1.739385891e-01, -2.286827196e-01, 3.0769139),
    (71.63261114, -5.691577197e-01, -1.431497272e-01, 0.4370289),
    (95.51014818, -2.093586929, -1.785402748e-01, -2.0862301),
    (116.9999315, -3.998718788, -5.907701780e-02, -1.2423877),
]


def test_stations_of_the_aerodyn_file_of_the_same_blade() -> None:
    """Aerodynamic centres of both files: reference axis, and their distance from it along the twisted chord.

    To 4 mm, and 20 mm along the chord, where the aerodynamic centres of root sections are interpolated by
    another polynomial. Signs of prebend, sweep and twist would be seen.
    """
    span, prebend, sweep, twist = np.array(AERODYN).T
    blade = turbine().rotor.blade
    for name, theirs, close in (("prebend", prebend, 4e-3), ("sweep", sweep, 2e-2)):
        ours = np.interp(span, blade.span, getattr(blade, name))
        np.testing.assert_allclose(ours, theirs, atol=close)
    np.testing.assert_allclose(np.interp(span, blade.span, np.degrees(blade.twist)), twist, atol=2e-3)
    rotor = turbine().rotor
    assert rotor.blades == 3 and rotor.hub_radius == pytest.approx(3.97)
    assert np.degrees([rotor.precone, rotor.tilt]) == pytest.approx([4.0, 6.0], abs=1e-4)
    assert turbine().tower is not None and turbine().tower.radius_at(20.0) == 5.0


def test_numbers_of_the_page() -> None:
    """docs/howto/rotor_performance.md: 5.49 MW and 1.231 MN."""
    flow = RotorFlow(shear_exponent=0.12, skewed_wake=False)
    found = solve_rotor_performance(turbine().rotor, 7.5009, 5.329 * RPM, flow=flow)
    assert float(found.rotor_power[0]) / 1e6 == pytest.approx(5.49, abs=5e-3)
    assert float(found.rotor_thrust[0]) / 1e6 == pytest.approx(1.231, abs=5e-4)


def test_elastic_turbine_of_the_example() -> None:
    """The model of the example at 8 m/s. Rigid blades have the thrust of the sheet to 1.2 %; elastic ones
    lose 5 to 6.5 % of it, as torsion turns the leading edge upwind by 1 deg. Their tips move by 10 m."""
    model = load_model(FOLDER.parent / "iea_15mw.yaml")
    thrust, seen = {}, {}
    for name, each in (("elastic", model), ("rigid", model.replace("wind_rotors.rotor.beams", ()))):
        system = compile_model(each, "production")
        begin = prepare_start(system, system.scenario)
        row = evaluate.observe(begin.system, begin.state)
        seen[name] = dict(zip((c.name for c in begin.system.layout.channels), row, strict=True))
        thrust[name] = seen[name]["rotor_thrust[rotor]"]
    assert thrust["rigid"] == pytest.approx(1.37999e6, rel=0.012)
    assert 0.935 < thrust["elastic"] / thrust["rigid"] < 0.95
    assert seen["elastic"]["displacement[tip_1.x]"] == pytest.approx(10.3, abs=0.3)
    assert np.degrees(seen["elastic"]["attitude[tip_1.z]"]) == pytest.approx(-1.1, abs=0.15)
