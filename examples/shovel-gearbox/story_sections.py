# SPDX-License-Identifier: Apache-2.0
"""Sections of the page about the gearbox itself: geometry, contact, laws, forces, supports, fault."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from levels import Level
from study import (
    FAULT,
    HERE,
    LOSSLESS,
    PINION_PERIOD,
    PINION_SPEED,
    PRINTED,
    RATED,
    SHAFTS,
    STAGES,
    TOTAL_RATIO,
    Run,
    frequencies,
    in_mm,
    stages,
    support_forces,
    tooth_forces,
)

from pitchpoint import load_model
from pitchpoint.analysis.orders import order_map
from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.time_frequency import time_frequency_map
from pitchpoint.contact.damping import ramp
from pitchpoint.geometry.modifications import roll_length
from pitchpoint.geometry.tooth_faults import break_level, tooth_height
from pitchpoint.report.describe import describe
from pitchpoint.viz import theme
from pitchpoint.viz.compared_table import Compared, compared_table, sourced_table
from pitchpoint.viz.flank_plot import plot_missing
from pitchpoint.viz.frequency_marks import mark_frequencies
from pitchpoint.viz.gear_drawing import pair_svg
from pitchpoint.viz.quantities import Channel, number
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.report.sections import gear_section
from pitchpoint.viz.signals_plot import plot_signals
from pitchpoint.viz.spectrum_plots import plot_order_map, plot_spectrum, plot_time_frequency

PAPER = "paper"


def gearbox() -> Section:
    """Table 1 of the paper, and what follows from it."""
    section = Section("gearbox", "1 The gearbox")
    model = load_model(HERE / "paper.yaml")
    train = frequencies(model)
    rows = []
    for k, stage in enumerate(stages(model)):
        names = " and ".join(stage.gears)
        rows.append(
            Compared(
                f"ratio of {names}", stage.ratio, f"paper.yaml, teeth {stage.teeth}", "", PRINTED["ratio"][k]
            )
        )
    where = f"train_frequencies of the teeth at {RATED:g} 1/min"
    ratio = float(train.speed[0] / abs(train.speed[-1]))
    rows.append(Compared("total ratio", ratio, where, "", TOTAL_RATIO))
    for k, mesh in enumerate(train.mesh):
        rows.append(
            Compared(
                f"mesh frequency of stage {k + 1}", float(mesh), where, "Hz", PRINTED["mesh_frequency"][k]
            )
        )
    turning = float(train.shaft[2])
    rows.append(Compared("speed of pinion Z5", 60.0 * turning, where, "1/min", PINION_SPEED))
    rows.append(Compared("period of pinion Z5", 1.0 / turning, where, "s", PINION_PERIOD))
    section.add(
        "<p>The crawler gearbox of a 12 m³ mining shovel: two motors, three helical stages on each side, "
        "one output on each side. Teeth, modules, helix angles, widths, centre distances, materials, speed "
        "and load are those of the paper; the model takes the sum of the profile shifts from the centre "
        "distances.</p>"
    )
    section.add(compared_table(rows, published=PAPER))
    drawings = [pair_svg(model.pairs[m], names=model.meshes[m].gears) for m in STAGES]
    section.add(f'<div class="pair">{"".join(f"<figure>{d}</figure>" for d in drawings)}</div>')
    told = describe(model)
    gears = {g: told.gears[g] for m in STAGES for g in model.meshes[m].gears}
    tables = gear_section(gears, {m: told.meshes[m] for m in STAGES}).parts
    section.add(
        "<details><summary>Teeth, diameters, contact ratios and measures by ISO 21771, from: "
        f"describe(paper.yaml)</summary>{''.join(tables)}</details>"
    )
    return section


def contact() -> Section:
    """Table 4 under both readings of d1, damping, friction, and what is odd in the paper."""

    section = Section("contact", "2 Contact parameters")
    model = load_model(HERE / "paper.yaml")
    rows = []
    unit = "10⁵ N/mm^1.5"
    for k, stage in enumerate(stages(model)):
        names, table4 = " and ".join(stage.gears), PRINTED["stiffness"][k] / 1e5
        for words, value, option in (
            ("operating", stage.stiffness_working, "operating"),
            ("standard", stage.stiffness_reference, "reference"),
        ):
            source = f'hertz_constant(pair of {stage.mesh}, "{option}")'
            rows.append(Compared(f"K of {names}, {words} d1", in_mm(value, 1.5) / 1e5, source, unit, table4))
    for stage in stages(model):
        source = f"paper.yaml, meshes.{stage.mesh}.damping.pair over K"
        rows.append(Compared(f"C/K of {stage.mesh}", 100 * stage.damping_share, source, "%", "0.1 to 1", 3))
    for stage in stages(model):
        source = "(F/K)^(2/3) at the mean force without losses"
        rows.append(Compared(f"penetration of {stage.mesh}", 1e3 * stage.penetration, source, "mm", None, 4))
    friction = model.meshes["stage_3"].friction
    for words, key, unit, factor, printed in (
        ("static coefficient of friction", "static", "", 1.0, 0.1),
        ("its sliding velocity", "static_speed", "mm/s", 1e3, 1.0),
        ("dynamic coefficient of friction", "mu", "", 1.0, 0.08),
        ("its sliding velocity", "v_eps", "mm/s", 1e3, 10.0),
    ):
        source = f"paper.yaml, meshes.stage_3.friction.{key}"
        rows.append(Compared(words, factor * getattr(friction, key), source, unit, printed))
    section.add(compared_table(rows, published=PAPER))
    section.add(
        "<p>Eq. (3) gives Table 4 only if d1 is the <em>operating</em> pitch diameter; with the standard "
        "one that the nomenclature names it is 0.5 to 2 % lower. Physically the standard reading is exact: "
        "d1 cos αt is then the base diameter, and the radius that of the involute at the pitch point. The "
        "runs of this page use the operating diameter, as Table 4 does (<code>stiffness.diameter</code> of "
        "every mesh).</p><p>The step function of the damping is printed with the deformation in mm itself, "
        "(3 − 2Δ)Δ². At d = 0.1 mm it would reach 0.028 and then jump to 1. It is meant with Δ/d, as here: "
        "half of the damping at d/2. With C = 1000 N s/mm the third stage lies below the paper's own range "
        "of 0.1 to 1 % of K.</p>"
    )
    figure = theme.figure("penetration [mm]", "share of the damping", height=300)
    depth = np.linspace(0.0, 0.12, 241)
    ours = [ramp(1e-3 * u, 1e-4)[0] for u in depth]
    literal = np.where(depth < 0.1, (3.0 - 2.0 * depth) * depth**2, 1.0)
    for words, values in (("with Δ/d (contact.damping.ramp)", ours), ("as printed, Δ in mm", literal)):
        figure.add_scatter(x=depth, y=values, mode="lines", name=words)
    section.add_figure(figure, "Share of the damping that is active over the penetration; d = 0.1 mm.")
    return section


def laws(found: Mapping[str, Level], duration: float) -> Section:
    """Three laws of contact side by side."""
    section = Section("laws", "3 Three laws of contact")
    rows: list[list[str]] = []
    for mesh in STAGES:
        for words, channel, unit, factor, which in (
            ("tooth force, mean", f"normal_force[{mesh}]", "kN", 1e-3, 0),
            ("tooth force, alternating rms", f"normal_force[{mesh}]", "kN", 1e-3, 1),
            ("penetration, mean", f"penetration[{mesh}]", "µm", 1e6, 0),
            ("penetration, largest", f"penetration[{mesh}]", "µm", 1e6, 2),
        ):
            cells = [number(level.channels[channel][which] * factor, 4) for level in found.values()]
            rows.append([f"{mesh}: {words}", unit, *cells, channel])
    for shaft, end, axis in ((s, e, a) for s in SHAFTS for e in "ab" for a in "xy"):
        channel = f"signal[{shaft}_{end}_{axis}]"
        pairs = [[1e-3 * v for v in level.channels[channel][:2]] for level in found.values()]
        cells = [f"{number(mean, 4)} ± {number(rms, 3)}" for mean, rms in pairs]
        rows.append([f"bearing {shaft}_{end}, {axis}: mean ± rms", "kN", *cells, channel])
    times = [number(level.wall_s, 3) for level in found.values()]
    rows.append([f"run time of {duration:g} s", "s", *times, "TimeSummary.wall_s"])
    softer = [
        found["impact"].channels[f"penetration[{m}]"][0] / found["din3990"].channels[f"penetration[{m}]"][0]
        for m in STAGES
    ]
    section.add(
        "<p>The same gearbox under the impact force of the paper (Hertz K, exponent 1.5, cubic step of the "
        "damping), the same with a coefficient of restitution, and the flank law with the stiffness of DIN "
        "3990. K of Eq. (3) does not know the face width: teeth overlap "
        f"{number(min(softer), 2)} to {number(max(softer), 2)} times as far as by DIN 3990. Neither is "
        "tuned to the other. Mean forces hardly feel the law, ripples do.</p>"
    )
    section.add(sourced_table(("quantity", "unit", *found), rows))
    section.add(f"<p>From: levels.run(law, {duration:g}) on paper.yaml, changes as in levels.LAWS.</p>")
    return section


def forces(run: Run, frictionless: Run, run_up: Run) -> Section:
    """Tooth forces with their spectra, the ripple of each stage in the others, and the run-up."""
    section = Section("forces", "4 Tooth forces")
    train = frequencies(load_model(HERE / "paper.yaml"))
    found = tooth_forces(run, frictionless, train.mesh)
    rows = []
    for k, force in enumerate(found):
        mean = f"run {frictionless.label}: {force.channel}, mean"
        rows.append(
            Compared(
                f"mean force of stage {k + 1}, no friction",
                force.lossless / 1e3,
                mean,
                "kN",
                LOSSLESS[k] / 1e3,
            )
        )
    for k, force in enumerate(found):
        source = f"run {run.label}: {force.channel}, mean"
        rows.append(Compared(f"mean force of stage {k + 1}", force.mean / 1e3, source, "kN", None))
    for k, force in enumerate(found):
        source = f"run {run.label}: {force.channel}, harmonic_table"
        rows.append(
            Compared(
                f"mesh frequency of stage {k + 1}",
                force.frequency,
                source,
                "Hz",
                PRINTED["mesh_frequency"][k],
                7,
            )
        )
    section.add(compared_table(rows, published="expected"))
    section.add(
        "<p>Expected forces are T/(r<sub>b</sub> cos β<sub>b</sub>) of 437 kN m without losses; friction "
        "costs the stages before the output more. The paper prints the mesh frequencies, and figures of "
        "the forces, whose numbers are not in its text.</p>"
    )
    marks = {f"stage {k + 1}": float(f) for k, f in enumerate(train.mesh)}
    time = run.times()
    for k, force in enumerate(found):
        values = run.record(force.channel)
        spectrum = amplitude_spectrum(values, run.rate)
        figure = plot_spectrum(
            {force.channel: spectrum},
            unit="N",
            quantity="force",
            highest=3.6 * float(train.mesh[k]),
            labels=0,
        )
        mark_frequencies(figure, marks, harmonics=3)
        figure.update_layout(margin={"t": 50})
        last = time < 6.0 / float(train.mesh[k])
        channel = Channel(force.channel, values[last], "N")
        section.add(f"<h3>Stage {k + 1}</h3>")
        section.add_figure(
            figure, f"Amplitude spectrum of {force.channel} over {time.size / run.rate:g} s, run {run.label}."
        )
        section.add_figure(plot_signals(time[last], [channel]), "The same force over six tooth meshes.")
    section.add("<h3>The ripple of one stage in the others</h3>")
    shares = [
        [
            f"stage {k + 1}",
            "%",
            *(number(100 * a / force.mean, 3) for a in (*force.others, force.background.max())),
        ]
        for k, force in enumerate(found)
    ]
    lines = [[*cells, f"{force.channel}, read_tones"] for cells, force in zip(shares, found, strict=True)]
    head = (
        "amplitude over mean force",
        "unit",
        *(f"at {f:.3f} Hz" for f in train.mesh),
        "next to them, most",
    )
    section.add(sourced_table(head, lines))
    section.add(
        f"<p>Run {run.label}. The shafts are rigid, and still every stage feels "
        "the two others: its ripple turns the shafts between them.</p>"
    )
    add_run_up(section, run_up)
    return section


def add_run_up(section: Section, run_up: Run) -> None:
    """Maps of a run-up over frequency and over order."""
    channel = "normal_force[stage_1]"
    time = run_up.data.time.values
    values = run_up.data[channel].values
    section.add("<h3>Run-up</h3>")
    data = time_frequency_map(values, run_up.rate, highest_frequency=600.0)
    section.add_figure(
        plot_time_frequency(data, unit="N", quantity=channel),
        f"Run {run_up.label}: {channel} from standstill to {RATED:g} 1/min in {time[-1]:g} s. Mesh orders "
        "rise with the speed; what is at rest is a natural frequency; "
        "falling lines are orders beyond half the sample rate, folded back.",
    )
    moving = time > 1.0
    angle = run_up.data["angle[input]"].values[moving]
    tracked = order_map(values[moving], angle, time[moving], highest_order=35.0, revolutions=8.0)
    section.add_figure(
        plot_order_map(tracked, unit="N", quantity=channel),
        "The same over orders of the motor shaft: 11 is the mesh of stage 1, 1.63 that of stage 2.",
    )


def supports(run: Run, elastic: Run | None) -> Section:
    """Bearing forces in all directions."""
    section = Section("supports", "5 Bearing forces")
    rows = []
    for found in support_forces(run, elastic):
        values = (found.mean, found.rms, found.elastic_mean, found.elastic_rms)
        cells = [number(1e-3 * v, 4) if math.isfinite(v) else "–" for v in values]
        source = f"{found.channel}; {found.elastic_channel}"
        rows.append([f"{found.bearing}, {found.axis}", "kN", *cells, source])
    section.add(
        "<p>Forces on the bearings of the left side. On rigid shafts (paper.yaml) each joint carries force "
        "and moment, which two bearings share; on elastic shafts (model.yaml) bearings are springs in a "
        "housing on mounts. z runs along the shafts; the first bearing of each shaft holds it.</p>"
    )
    section.add(
        sourced_table(("bearing and direction", "unit", "rigid: mean", "rms", "elastic: mean", "rms"), rows)
    )
    time = run.times()
    last = time < 2.0
    for end in "ab":
        names = [f"third_{end}_{axis}" for axis in "xy"]
        channels = [Channel(name, run.record(f"signal[{name}]")[last], "N") for name in names]
        section.add_figure(
            plot_signals(time[last], channels, title="force"), f"Run {run.label}, bearing third_{end}."
        )
    return section


def fault(healthy: Run, faulty: Run, channel: str) -> Section:
    """The broken tooth and what it does to a bearing force."""
    section = Section("fault", "6 A broken tooth on Z5")
    gear = load_model(HERE / "paper.yaml").replace(FAULT, 1).gears["Z5"]
    broken, shape = gear.faults["broken"], gear.geometry
    width, height = broken.sizes(gear.face_width, tooth_height(shape))
    z = np.linspace(-0.5 * gear.face_width, 0.5 * gear.face_width, 241)
    d = np.linspace(shape.d_Ff, shape.d_a, 121)
    corner = broken.shape == "corner"
    level = break_level(
        shape, z, roll_length(shape, d), width=width, height=height, at=broken.at, corner=corner
    )
    section.add_figure(
        plot_missing(z, d, level),
        f"Flank of tooth {broken.tooth} of Z5, from: paper.yaml with {FAULT} = 1. {number(1e3 * width, 4)} "
        f"mm of {number(1e3 * gear.face_width, 4)} mm are missing over the height of "
        f"{number(1e3 * height, 4)} mm. The paper removes part of a tooth and shows it in a picture; sizes "
        "are not printed, these are ours.",
    )
    time = healthy.times()
    name = channel.partition("[")[2].rstrip("]")
    both = [Channel(f"{name}, {run.label}", run.record(channel), "N") for run in (healthy, faulty)]
    section.add_figure(
        plot_signals(time, both, rows=[[0], [1]]),
        f"{channel} of both runs: once per turn of the third shaft half a tooth is missing, and "
        "the load moves along the width towards this bearing.",
    )
    start = int(np.argmax(np.abs(both[1].values - both[0].values)))
    near = slice(max(0, start - 1000), start + 1000)
    zoom = [Channel(c.name, c.values[near], "N") for c in both]
    section.add_figure(
        plot_signals(time[near], zoom, rows=[[0, 1]], title="force"),
        "Both runs about the passage of the broken tooth.",
    )
    return section
