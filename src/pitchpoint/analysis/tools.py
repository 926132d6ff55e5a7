# SPDX-License-Identifier: Apache-2.0
"""Table of the analysis functions for datasets: one row per tool.

A row gives the function, its arguments from the dataset, and the fields of its result with dimensions
(coordinates if a field has the same name) and units, where `{u}` is the unit of the channel. Functions that
require the result of another one, or several records, are not in this table.
"""

from __future__ import annotations

from pitchpoint.analysis.tool_rows import Output, Tool, spectrum_outputs


def _prominence(axis: str, unit: str) -> tuple[Output, ...]:
    """Fields of `line_prominence.LineProminence` over frequency or order."""
    return (
        Output("frequency", axis, unit, axis),
        Output("prominence", axis, "dB"),
        Output("amplitude", axis, "{u}"),
        Output("background", axis, "{u}"),
        Output("probability", axis),
        Output("resolution", "", unit),
    )


_CEPSTRUM = (Output("quefrency", "quefrency", "s"), Output("cepstrum", "quefrency"))

TOOLS: dict[str, Tool] = {
    "signal_statistics": Tool(
        "statistics.signal_statistics",
        "Mean, RMS of the alternating part, minimum and maximum.",
        ("values", "time"),
        (
            Output("mean", "", "{u}"),
            Output("rms", "", "{u}"),
            Output("min", "", "{u}"),
            Output("max", "", "{u}"),
        ),
    ),
    "amplitude_spectrum": Tool(
        "spectra.amplitude_spectrum",
        "Peak amplitudes over frequency.",
        ("values", "sample_rate"),
        spectrum_outputs("frequency", "Hz"),
        "spectrum",
    ),
    "power_spectral_density": Tool(
        "spectra.power_spectral_density",
        "Power spectral density over frequency, averaged over segments.",
        ("values", "sample_rate"),
        (
            Output("frequency", "frequency", "Hz"),
            Output("density", "frequency", "{u2}/Hz"),
            Output("n_segments"),
        ),
    ),
    "time_frequency_map": Tool(
        "time_frequency.time_frequency_map",
        "Amplitudes over time and frequency.",
        ("values", "sample_rate", "start"),
        (
            Output("time", "time", "s"),
            Output("frequency", "frequency", "Hz"),
            Output("amplitude", "time frequency", "{u}"),
        ),
        "time_frequency",
    ),
    "resample_over_angle": Tool(
        "orders.resample_over_angle",
        "The signal at equal steps of a shaft angle.",
        ("values", "angle"),
        (Output("angle", "angle", "rad"), Output("values", "angle", "{u}"), Output("samples_per_revolution")),
    ),
    "order_spectrum": Tool(
        "spectra.order_spectrum",
        "Peak amplitudes over orders, of a signal over an angle.",
        ("values", "samples_per_revolution"),
        spectrum_outputs("order", "1"),
        "order_spectrum",
    ),
    "tracked_spectrum": Tool(
        "orders.tracked_spectrum",
        "Peak amplitudes over orders of a shaft, of a signal over time.",
        ("values", "angle"),
        spectrum_outputs("order", "1"),
        "order_spectrum",
    ),
    "order_map": Tool(
        "orders.order_map",
        "Amplitudes over time and orders of a run-up.",
        ("values", "angle", "time"),
        (
            Output("time", "time", "s"),
            Output("speed", "time", "rad/s"),
            Output("order", "order"),
            Output("amplitude", "time order", "{u}"),
            Output("speed_change", "time", "rad/s"),
        ),
        "order_map",
    ),
    "order_levels": Tool(
        "order_levels.order_levels",
        "Levels of the harmonics of one order of a shaft.",
        ("values", "angle", "time"),
        (
            Output("order", "order"),
            Output("frequency", "order", "Hz"),
            Output("amplitude", "order", "{u}"),
            Output("level", "order", "dB"),
            Output("total", "", "dB"),
        ),
    ),
    "signal_indicators": Tool(
        "indicators.signal_indicators",
        "RMS, peak, kurtosis, crest, shape and impulse factor.",
        ("values",),
        (
            Output("rms", "", "{u}"),
            Output("peak", "", "{u}"),
            Output("peak_to_peak", "", "{u}"),
            Output("kurtosis"),
            Output("crest_factor"),
            Output("shape_factor"),
            Output("impulse_factor"),
        ),
    ),
    "tones": Tool(
        "harmonics.read_tones",
        "Frequencies and amplitudes of the highest lines near given frequencies.",
        ("values", "sample_rate"),
        (
            Output("expected", "expected", "Hz"),
            Output("frequency", "expected", "Hz"),
            Output("amplitude", "expected", "{u}"),
            Output("background", "expected", "{u}"),
            Output("is_peak", "expected"),
            Output("resolution", "", "Hz"),
        ),
        "tones",
    ),
    "harmonic_table": Tool(
        "harmonics.harmonic_table",
        "Frequencies and amplitudes of the harmonics of one frequency.",
        ("values", "sample_rate"),
        (
            Output("harmonic", "harmonic"),
            Output("frequency", "harmonic", "Hz"),
            Output("amplitude", "harmonic", "{u}"),
            Output("background", "harmonic", "{u}"),
            Output("fundamental", "", "Hz"),
            Output("lost"),
        ),
    ),
    "sideband_table": Tool(
        "sidebands.sideband_table",
        "Sidebands of mesh harmonics at multiples of a shaft frequency.",
        ("values", "sample_rate"),
        (
            Output("harmonic", "harmonic"),
            Output("order", "sideband", name="sideband"),
            Output("frequency", "harmonic sideband", "Hz"),
            Output("amplitude", "harmonic sideband", "{u}"),
            Output("level", "harmonic sideband", "dB"),
            Output("background", "harmonic sideband", "{u}"),
            Output("ratio", "harmonic"),
            Output("index", "harmonic", "{u}"),
            Output("asymmetry", "harmonic distance"),
            Output("lost"),
        ),
    ),
    "envelope": Tool(
        "envelope.band_envelope",
        "Amplitude of a band over time.",
        ("values", "sample_rate"),
        (Output("envelope", "time", "{u}"), Output("low", "", "Hz"), Output("high", "", "Hz")),
    ),
    "envelope_spectrum": Tool(
        "envelope.envelope_spectrum",
        "Amplitudes of the envelope of a band over frequency.",
        ("values", "sample_rate"),
        spectrum_outputs("frequency", "Hz", "{squared}"),
        "spectrum",
    ),
    "kurtogram": Tool(
        "kurtogram.kurtogram",
        "Kurtosis of the envelopes of all bands: band of impacts.",
        ("values", "sample_rate"),
        (
            Output("level", "band"),
            Output("low", "band", "Hz"),
            Output("high", "band", "Hz"),
            Output("kurtosis", "band"),
            Output("spread", "band"),
            Output("best_low", "", "Hz"),
            Output("best_high", "", "Hz"),
            Output("best_kurtosis"),
            Output("best_spread"),
        ),
        "kurtogram",
    ),
    "cepstral_whitening": Tool(
        "cepstrum.cepstral_whitening",
        "Signal whose spectral lines have equal amplitudes: impacts without tones.",
        ("values",),
        (Output("values", "time"),),
    ),
    "line_prominence": Tool(
        "line_prominence.line_prominence",
        "Levels of lines above the running median of the spectrum.",
        ("values", "sample_rate"),
        _prominence("frequency", "Hz"),
        "line_prominence",
    ),
    "order_prominence": Tool(
        "line_prominence.order_prominence",
        "Levels of orders above the running median, of a signal over an angle.",
        ("values", "samples_per_revolution"),
        _prominence("order", "1"),
        "order_prominence",
    ),
    "spectral_coherence": Tool(
        "spectral_coherence.spectral_coherence",
        "Periodic modulation over cyclic and carrier frequency, and envelope spectra.",
        ("values", "sample_rate"),
        (
            Output("cyclic_frequency", "cyclic_frequency", "Hz"),
            Output("frequency", "frequency", "Hz"),
            Output("coherence", "cyclic_frequency frequency"),
            Output("threshold", "cyclic_frequency"),
            Output("density", "frequency", "{u2}/Hz"),
            Output("enhanced", "cyclic_frequency"),
            Output("enhanced_threshold", "cyclic_frequency"),
            Output("improved", "cyclic_frequency"),
            Output("improved_threshold", "cyclic_frequency"),
            Output("low", "", "Hz"),
            Output("high", "", "Hz"),
            Output("segments"),
        ),
        "spectral_coherence",
    ),
    "real_cepstrum": Tool(
        "cepstrum.real_cepstrum", "Families of lines over their period.", ("values", "sample_rate"), _CEPSTRUM
    ),
    "power_cepstrum": Tool(
        "cepstrum.power_cepstrum", "Echoes and families of lines.", ("values", "sample_rate"), _CEPSTRUM
    ),
    "synchronous_average": Tool(
        "synchronous_average.synchronous_average",
        "Mean revolution of a shaft.",
        ("values", "angle"),
        (
            Output("angle", "angle", "rad"),
            Output("values", "angle", "{u}"),
            Output("averages"),
            Output("scatter", "", "{u}"),
            Output("highest_order"),
        ),
    ),
    "gear_signals": Tool(
        "gear_signals.gear_signals",
        "Regular, residual and difference signal of a synchronous average.",
        ("average",),
        (
            Output("regular", "angle", "{u}"),
            Output("residual", "angle", "{u}"),
            Output("difference", "angle", "{u}"),
            Output("mesh_orders", "harmonic"),
        ),
        "gear_signals",
    ),
    "gear_indicators": Tool(
        "gear_indicators.gear_indicators",
        "FM0, FM4, M6A, M8A and others of a synchronous average.",
        ("average",),
        (
            Output("fm0"),
            Output("fm4"),
            Output("m6a"),
            Output("m8a"),
            Output("energy_operator"),
            Output("sideband_level_factor"),
        ),
    ),
    "wavelet_levels": Tool(
        "wavelets.wavelet_levels",
        "Discrete wavelet transform: the part of the signal in every octave.",
        ("values", "sample_rate"),
        (
            Output("names", "level", "", "level"),
            Output("signals", "level time", "{u}"),
            Output("lengths", "level", name="coefficients"),
            Output("band", "level edge", "Hz"),
            Output("energy_share", "level"),
            Output("wavelet", unit=""),
            Output("extension", unit=""),
        ),
        "wavelet_levels",
        ("coefficients",),
    ),
    "wavelet_packets": Tool(
        "wavelets.wavelet_packets",
        "Energy in bands of equal width, and their wavelet coefficients over time.",
        ("values", "sample_rate", "start"),
        (
            Output("time", "time", "s"),
            Output("band", "packet edge", "Hz"),
            Output("energy_share", "packet"),
            Output("coefficients", "packet time", "{u}"),
            Output("wavelet", unit=""),
            Output("extension", unit=""),
        ),
        "wavelet_packets",
    ),
    "scalogram": Tool(
        "scalogram.scalogram",
        "Continuous wavelet transform: amplitudes over time and frequency.",
        ("values", "sample_rate", "start"),
        (
            Output("time", "time", "s"),
            Output("frequency", "frequency", "Hz"),
            Output("amplitude", "frequency time", "{u}"),
            Output("edge", "frequency", "s"),
            Output("wavelet", unit=""),
            Output("extension", unit=""),
        ),
        "scalogram",
    ),
    "find_period": Tool(
        "periodicity.find_period",
        "Period of repeated impacts between two limits, if there is one.",
        ("values", "sample_rate"),
        (
            Output("found"),
            Output("period", "", "s"),
            Output("deviation", "", "s"),
            Output("p_value"),
            Output("false_alarm"),
            Output("turns"),
            Output("trial_period", "trial_period", "s"),
            Output("trial_score", "trial_period"),
            Output("lines.orders", "harmonic", name="harmonic"),
            Output("lines.frequency", "harmonic", "Hz"),
            Output("lines.amplitude", "harmonic", "{u}"),
            Output("lines.noise", "harmonic", "{u}"),
            Output("lines.p_value", "harmonic", name="line_p_value"),
        ),
        "find_period",
    ),
    "period_evidence": Tool(
        "periodicity.period_evidence",
        "Evidence of repeated impacts with given periods, such as shaft revolutions.",
        ("values", "sample_rate"),
        (
            Output("period", "period", "s"),
            Output("p_value", "period"),
            Output("turns", "period"),
            Output("lines", "period"),
        ),
        "period_evidence",
    ),
    "white_noise": Tool(
        "noise.with_white_noise",
        "Signal with white noise of a given signal-to-noise ratio.",
        ("values",),
        (
            Output("values", "time", "{u}"),
            Output("noise", "time", "{u}"),
            Output("signal_rms", "", "{u}"),
            Output("noise_deviation", "", "{u}"),
        ),
    ),
}
