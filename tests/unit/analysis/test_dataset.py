# SPDX-License-Identifier: Apache-2.0
"""Every tool of the table gives on a dataset what its function gives on arrays, with units and dimensions."""

from __future__ import annotations

import dataclasses
import inspect
import json
import operator

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.bandwidth import lost_harmonics
from pitchpoint.analysis.dataset import analyse, channel_names, tool_options
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.tool_rows import SOURCES
from pitchpoint.analysis.tools import TOOLS

RATE = 2048.0
TIME = 0.25 + np.arange(8192) / RATE
ANGLE = 2 * np.pi * (3.0 * TIME + 2.0 * TIME**2)  # a run-up
FORCE = 5.0 + 2.0 * np.cos(17 * ANGLE)
OPTIONS = {
    "tracked_spectrum": {"highest_order": 40},
    "order_levels": {"order": 17.0, "reference": 1e-6, "harmonics": 1},
    "order_map": {"highest_order": 40.0, "frames": 20},
    "resample_over_angle": {"samples_per_revolution": 128},
    "harmonic_table": {"fundamental": 300.0},
    "sideband_table": {"mesh": 300.0, "spacing": 20.0},
    "envelope_spectrum": {"band": (100.0, 400.0), "squared": True},
    "gear_signals": {"teeth": 17},
    "gear_indicators": {"teeth": 17},
    "white_noise": {"signal_to_noise": 3.0, "seed": [1, 2]},
    "synchronous_average": {"samples_per_turn": 128},
    "tones": {"expected": [300.0], "reach": [20.0]},
    "scalogram": {"frequencies": [50.0, 200.0]},
    "find_period": {"shortest": 0.2, "longest": 1.5},
    "period_evidence": {"periods": [0.5, 3.0]},
}


@pytest.fixture(scope="module")
def record():
    return xr.Dataset(
        {
            "force": ("time", FORCE, {"units": "N"}),
            "travel": ("time", 1e-6 * FORCE**2, {"units": "m/s^2"}),
            "turn": ("time", ANGLE, {"units": "rad"}),
            "speed": ("time", 2 * np.pi * (3.0 + 4.0 * TIME), {"units": "rad/s"}),
            "table": (("time", "x"), np.ones((TIME.size, 2))),
        },
        coords={"time": TIME},
        attrs={"sha256": "abc", "source_file": "rig.csv", "notes": "no matter"},
    )


def over_angle(record):
    return analyse(record, "resample_over_angle", channel="force", angle="turn", samples_per_revolution=128)


@pytest.mark.parametrize("tool", sorted(TOOLS))
def test_a_row_fits_its_function(tool):
    row = TOOLS[tool]
    function = row.load()
    parameters = inspect.signature(function).parameters
    assert set(row.takes) <= set(SOURCES) & set(parameters)
    result = inspect.get_annotations(function, eval_str=True)["return"]
    fields = {f.name for f in dataclasses.fields(result)}
    assert {o.field.partition(".")[0] for o in row.outputs} | set(row.without) == fields


@pytest.mark.parametrize("tool", sorted(TOOLS))
def test_a_tool_gives_what_its_function_gives(record, tool):
    row = TOOLS[tool]
    data = record
    if "samples_per_revolution" in row.takes:
        data = over_angle(record)
    elif "average" in row.takes:
        data = analyse(record, "synchronous_average", channel="force", angle="turn", samples_per_turn=128)
    channel = "values" if data is not record else "force"
    found = analyse(data, tool, channel=channel, angle="turn", **OPTIONS.get(tool, {}))
    sources = {
        "values": np.asarray(data[channel]),
        "sample_rate": RATE,
        "time": TIME,
        "start": 0.25,
        "angle": ANGLE,
        "samples_per_revolution": 128.0,
        "average": np.asarray(data[channel]),
    }
    expected = row.load()(**{name: sources[name] for name in row.takes}, **OPTIONS.get(tool, {}))
    for output in row.outputs:
        value = operator.attrgetter(output.field)(expected)
        if np.asarray(value).dtype.kind == "U":
            np.testing.assert_array_equal(found[output.variable], value)
        else:
            # the sample rate comes from the time axis: rounding of 13 digits
            np.testing.assert_allclose(found[output.variable], value, rtol=1e-9, atol=1e-9)
        assert found[output.variable].dims == tuple(output.dims.split())
        assert "{" not in found[output.variable].units
    assert found.attrs["tool"] == tool and found.attrs["channel"] == channel
    assert found.attrs["sha256"] == "abc" and json.loads(found.attrs["options"]) == json.loads(
        json.dumps(OPTIONS.get(tool, {}))
    )


def test_a_gear_tool_makes_the_mean_turn_it_needs(record):
    """Of the shaft that is named; the same as in two steps."""
    average = analyse(record, "synchronous_average", channel="force", angle="turn")
    twice = analyse(average, "gear_signals", channel="values", teeth=17)
    once = analyse(record, "gear_signals", channel="force", angle="turn", teeth=17)
    np.testing.assert_array_equal(once["residual"], twice["residual"])
    np.testing.assert_array_equal(once["angle"], average["angle"])
    assert once.attrs["angle"] == "turn" and once["residual"].units == "N"


def test_noise_is_a_record_to_go_on_with(record):
    noisy = analyse(record, "white_noise", channel="force", signal_to_noise=0.0, seed=3)
    found = analyse(noisy, "amplitude_spectrum", channel="values")
    assert found["amplitude"].units == "N" and found.attrs["sha256"] == "abc"
    alone = analyse(noisy, "signal_statistics", channel="noise")
    # 8192 samples: the rms scatters by 0.8 %
    assert float(alone["rms"]) == pytest.approx(float(noisy["noise_deviation"]), rel=0.04)


def test_units_of_what_is_made(record):
    assert analyse(record, "power_spectral_density", channel="force")["density"].units == "N^2/Hz"
    assert analyse(record, "power_spectral_density", channel="travel")["density"].units == "(m/s^2)^2/Hz"
    bare = record.drop_vars("table").assign(x=("time", FORCE))
    assert analyse(bare, "power_spectral_density", channel="x")["density"].units == "1/Hz"
    assert analyse(bare, "amplitude_spectrum", channel="x")["amplitude"].units == "1"


def test_a_known_line_is_found_from_the_angle_and_from_the_speed(record):
    by_angle = analyse(record, "tracked_spectrum", channel="force", angle="turn", highest_order=40)
    by_speed = analyse(record, "tracked_spectrum", channel="force", angle="speed", highest_order=40)
    for found in (by_angle, by_speed):
        assert found["order"].values[1:][np.argmax(found["amplitude"].values[1:])] == 17.0
        # the trapezoid rule is exact for a speed that grows linearly; the slope of the filter costs 0.1 %
        assert float(found["amplitude"].sel(order=17.0)) == pytest.approx(2.0, rel=2e-3)


def test_several_channels_get_a_dimension(record):
    found = analyse(record, "signal_statistics", channel=["turn", "turn"])
    assert found["mean"].dims == ("channel",)
    two = record[["force"]].assign(again=record["force"] * 2.0)
    two["again"].attrs["units"] = "N"
    found = analyse(two, "amplitude_spectrum", channel=["force", "again"])
    assert found["amplitude"].dims == ("channel", "frequency")
    np.testing.assert_allclose(found["amplitude"][1], 2.0 * found["amplitude"][0], atol=1e-9)
    with pytest.raises(SignalError, match="different units"):
        analyse(record, "signal_statistics", channel=["force", "turn"])


def test_a_channel_alone_is_enough(record):
    assert channel_names(record) == ["force", "travel", "turn", "speed"]
    alone = analyse(record["force"], "signal_statistics")
    assert float(alone["max"]) == pytest.approx(7.0, abs=1e-3)


def test_single_precision_is_analysed_in_double(record):
    narrow = record.assign(force=record["force"].astype("f4").assign_attrs(units="N"))
    found = analyse(narrow, "amplitude_spectrum", channel="force")
    assert found["amplitude"].dtype == np.float64


@pytest.mark.parametrize(
    "arguments, options, sentence",
    [
        (("amplitude_spektrum",), {}, "did you mean amplitude_spectrum"),
        (("zzz",), {}, "there are signal_statistics"),
        (("amplitude_spectrum",), {}, "channel: 4 are in the record (limit 1); choose of force"),
        (("amplitude_spectrum",), {"channel": "forc"}, "did you mean force?"),
        (("amplitude_spectrum",), {"channel": []}, "channel: none is named"),
        (("amplitude_spectrum",), {"channel": "force", "windw_name": "hann"}, "did you mean window_name?"),
        (("amplitude_spectrum",), {"channel": "force", "window_name": 3}, "is 3 (limit a text)"),
        (
            ("amplitude_spectrum",),
            {"channel": "force", "window_name": "x"},
            "amplitude_spectrum of force: window",
        ),
        (("power_spectral_density",), {"channel": "force", "segment": 2.5}, "is 2.5 (limit a whole number)"),
        (
            ("power_spectral_density",),
            {"channel": "force", "segment": True},
            "is True (limit a whole number)",
        ),
        (("time_frequency_map",), {"channel": "force", "frames": None}, "is None (limit a whole number)"),
        (("envelope_spectrum",), {"channel": "force", "band": "wide"}, "is 'wide' (limit two numbers)"),
        (("envelope_spectrum",), {"channel": "force", "band": (1.0, 2.0, 3.0)}, "(limit two numbers)"),
        (("envelope_spectrum",), {"channel": "force", "squared": 1}, "is 1 (limit true or false)"),
        (
            ("synchronous_average",),
            {"channel": "force", "angle": "turn", "ratio": 0.5},
            "whole number or a fraction",
        ),
        (
            ("white_noise",),
            {"channel": "force", "signal_to_noise": 1, "seed": [1, 2.5]},
            "several whole numbers",
        ),
        (("gear_signals",), {"channel": "force", "teeth": 17}, "create it with synchronous_average"),
        (("order_map",), {"channel": "force", "angle": "turn"}, "needs the option highest_order"),
        (("order_map",), {"channel": "force", "highest_order": float("nan")}, "is nan (limit a number)"),
        (("resample_over_angle",), {"channel": "force"}, "channels in rad or rad/s are: turn, speed"),
        (
            ("resample_over_angle",),
            {"channel": "force", "angle": "travel"},
            "travel is in m/s^2 (limit rad or rad/s)",
        ),
        (("order_spectrum",), {"channel": "force"}, "is over time, not over an angle"),
    ],
)
def test_wrong_questions_get_a_sentence(record, arguments, options, sentence):
    with pytest.raises(SignalError) as caught:
        analyse(record, *arguments, **options)
    assert sentence in str(caught.value)


def test_a_signal_over_an_angle_has_no_sample_rate(record):
    with pytest.raises(SignalError, match="is over an angle, not over time"):
        analyse(over_angle(record), "amplitude_spectrum", channel="values")


def test_uneven_times_are_refused_where_even_ones_are_needed(record):
    uneven = record.isel(time=np.r_[0:100, 105:300])
    with pytest.raises(SignalError, match="not uniformly spaced"):
        analyse(uneven, "amplitude_spectrum", channel="force")
    assert analyse(uneven, "signal_statistics", channel="force")["max"] <= 7.0
    with pytest.raises(SignalError, match="samples"):
        analyse(record.isel(time=slice(0, 1)), "amplitude_spectrum", channel="force")


def test_none_is_an_option_where_the_function_takes_it(record):
    found = analyse(record, "power_spectral_density", channel="force", segment=None)
    assert int(found["n_segments"]) > 1
    assert list(tool_options("order_map")) == ["highest_order", "revolutions", "frames", "window_name"]


def test_lost_harmonics_are_those_from_half_the_rate_on():
    assert lost_harmonics(1000.0, {"a": 100.0}, harmonics=4) == ""
    assert "harmonic 5 of a" in lost_harmonics(1000.0, {"a": 100.0}, harmonics=5)  # at half the rate: lost
    assert "harmonics 3 to 5 of a" in lost_harmonics(1000.0, {"a": 200.0}, harmonics=5)
    text = lost_harmonics(1000.0, {"a": 700.0, "b": 10.0, "c": 300.0})
    assert "all harmonics of a (700 Hz), harmonics 2 and 3 of c (300 Hz)" in text and " b " not in text
    assert text.endswith("sample with 5376 Hz or more")  # 2.56 * 2100
    assert "the first harmonic of a" in lost_harmonics(100.0, {"a": 50.0}, harmonics=1)
    for bad in (0.0, -1.0, float("nan")):
        with pytest.raises(SignalError):
            lost_harmonics(100.0, {"a": bad})
    with pytest.raises(SignalError, match="harmonics"):
        lost_harmonics(100.0, {"a": 1.0}, harmonics=0)
