# SPDX-License-Identifier: Apache-2.0
"""`report_html`: everything known about a model and its results as one HTML page to look at, print, send on.

It takes data, not models or files: `pitchpoint.report` collects them. Sections appear only when their data
are there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from numpy.typing import ArrayLike

from pitchpoint.viz.power_flow import PowerFlow
from pitchpoint.viz.report import sections as parts
from pitchpoint.viz.report.cycles import mesh_cycle_section, roll_section
from pitchpoint.viz.report.extremes import extreme_section
from pitchpoint.viz.report.overview import provenance_section, scene_section, summary_section
from pitchpoint.viz.report.page import page
from pitchpoint.viz.report.power import power_section
from pitchpoint.viz.report.spectra import spectrum_section
from pitchpoint.viz.report.tables import case_section, mode_section, signal_section
from pitchpoint.viz.scene.content import Scene


@dataclass(frozen=True, kw_only=True)
class ReportModel:
    """Contents of a report about the model.

    Attributes
    ----------
    title
        Title of the model file.
    model_hash, version
        Fingerprint of the model and version of the package that computed the results.
    date
        Shown only if given, so that the same data give the same file.
    gears, meshes
        SI values by identifier (`m_n`, `d_a`, `eps_alpha` …), by the name of the gear or mesh.
    bevels
        The same of bevel gears and of bevel meshes.
    flanks
        What flanks have besides the involute: gear, flanks, what, amount, extent.
    inactive_faults
        How many faults of teeth have severity 0 and are not among the flanks.
    pairs
        `GearPair` and the names of its two gears, by the name of the mesh; these are drawn.
    shafts
        Body of gear 1 by the name of the mesh: orders of a mesh refer to it at first.
    counts
        What there is of each part, words and text, for the summary.
    signals
        Sensors, blocks, controllers and actuators: signal, what it is, what it is made of, who reads it.
    warnings, assumptions, sources
        Sentences for the last section.
    """

    title: str
    model_hash: str = ""
    version: str = ""
    date: str | None = None
    gears: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    meshes: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    bevels: tuple[Mapping[str, Mapping[str, Any]], Mapping[str, Mapping[str, Any]]] = ({}, {})
    flanks: Sequence[Sequence[str]] = ()
    inactive_faults: int = 0
    pairs: Mapping[str, tuple[Any, str, str]] = field(default_factory=dict)
    shafts: Mapping[str, str] = field(default_factory=dict)
    counts: Sequence[tuple[str, str]] = ()
    signals: Sequence[Sequence[str]] = ()
    warnings: Sequence[str] = ()
    assumptions: Sequence[str] = ()
    sources: Sequence[str] = ()


@dataclass(frozen=True, kw_only=True)
class SourceData:
    """Where a result comes from.

    Attributes
    ----------
    name
        Its name in the report.
    kind
        Time response, slow roll, speed sweep, cases.
    finished
        Whether it came to its end.
    sentence
        How it ended.
    rows
        All that is known, words and text.
    """

    name: str
    kind: str = ""
    finished: bool = True
    sentence: str = ""
    rows: Sequence[tuple[str, str]] = ()


@dataclass(frozen=True, kw_only=True)
class SceneData:
    """The 3-D scene of a report.

    Attributes
    ----------
    scene
        What it shows; None where there is nothing to show.
    run
        Name of the time response that it shows; empty at rest.
    words
        What it shows, or why there is none.
    """

    scene: Scene | None = None
    run: str = ""
    words: str = ""


@dataclass(frozen=True, kw_only=True)
class MeshCycleData:
    """One mesh cycle of one mesh.

    Attributes
    ----------
    stiffness
        `contact.mesh_cycle.MeshCycle`, or anything with `phase`, `stiffness_ratio`, `mean`, `minimum`,
        `maximum`.
    stiffness_unit
        What the ratio refers to.
    error_phase, errors
        Phases [base pitches], shape (n,), and transmission errors [m], shape (n,), by load case.
    cycles, repeats
        Mesh cycles that these phases cover, and after how many everything repeats, 0 if that is not known;
        a single cycle that repeats is drawn twice, anything else once.
    loaded_ratio
        Slope of the force under load at the same phases, in the unit of the stiffness, if it is of interest.
    share_way, share
        Way of a tooth pair since the beginning of contact [base pitches] and its share in the load.
    """

    stiffness: Any = None
    stiffness_unit: str = "c′·b"
    error_phase: ArrayLike = ()
    errors: Mapping[str, ArrayLike] = field(default_factory=dict)
    cycles: int = 1
    repeats: int = 1
    loaded_ratio: ArrayLike = ()
    share_way: ArrayLike = ()
    share: ArrayLike = ()


@dataclass(frozen=True, kw_only=True)
class RollData:
    """A slow roll that was computed before.

    Attributes
    ----------
    curves
        By mesh: its periods since the start [-], shape (n,), and transmission errors [m], shape (n,), by load
        case.
    mesh
        The mesh whose periods were rolled.
    note
        Sentence shown above the curves (the status of a roll that did not finish).
    """

    curves: Mapping[str, tuple[ArrayLike, Mapping[str, ArrayLike]]]
    mesh: str = ""
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class ModeData:
    """Modes about the loaded state: names, frequencies [Hz], shares of critical damping (nan: none).

    `held` names the bodies whose motion the scenario prescribes: they do not vibrate. `total` is the number
    of all modes if these are the lowest of more.
    """

    names: Sequence[str]
    frequency: Sequence[float]
    damping_ratio: Sequence[float]
    held: Sequence[str] = ()
    total: int = 0


@dataclass(frozen=True, kw_only=True)
class CaseTable:
    """Independent cases.

    Attributes
    ----------
    cases
        Mappings with `values` (texts by path), `numbers` (SI by path), `status`, `sentence` (how it ended),
        and `channels` (statistics).
    units
        SI unit of the numbers by path.
    """

    cases: Sequence[Mapping[str, Any]]
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class TimeRun:
    """One time response.

    Attributes
    ----------
    data
        `xarray.Dataset` over `time`, or a mapping with `time` and channels (`viz.quantities.Channel` or
        arrays).
    settle_time
        Start of the window of statistics and spectra, after the first sample [s].
    angle
        Name of the channel whose angle orders refer to; default that of the shaft of gear 1 of each mesh.
    highest_order
        End of order maps and order spectra [-]; default 3.2 times the largest number of teeth, or 100.
    note
        Sentence shown above the signals (the status of a run that did not finish).
    """

    data: Any
    settle_time: float = 0.0
    angle: str | None = None
    highest_order: float | None = None
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class CampbellData:
    """Speeds [rad/s] (n_speed,), natural frequencies [Hz] (n_speed, n_mode), orders by name, names of the
    modes; `shaft` is the body whose speed it is, `note` a sentence for below the picture."""

    speed: ArrayLike
    mode_frequencies: ArrayLike
    orders: Mapping[str, float]
    mode_names: Sequence[str] = ()
    shaft: str = ""
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class ReportResults:
    """Results by name; whatever is omitted has no section.

    Attributes
    ----------
    mesh_cycles
        By the name of the mesh.
    rolls
        Slow rolls by the name of the scenario.
    runs
        Time responses by the name of the scenario.
    sweeps
        By the name of the scenario: a mapping with `points` and `jumps`, as `pitchpoint sweep --json` prints
        it.
    campbell
        Natural frequencies over speed.
    modes
        Modes about the loaded state.
    cases
        Independent cases by the name of the scenario.
    powers
        Power flow of a time response by its name, or a sentence that states why there is none.
    scene
        The 3-D scene.
    sources
        Where the results come from.
    """

    mesh_cycles: Mapping[str, MeshCycleData] = field(default_factory=dict)
    rolls: Mapping[str, RollData] = field(default_factory=dict)
    runs: Mapping[str, TimeRun] = field(default_factory=dict)
    sweeps: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    campbell: CampbellData | None = None
    modes: ModeData | None = None
    cases: Mapping[str, CaseTable] = field(default_factory=dict)
    powers: Mapping[str, PowerFlow | str] = field(default_factory=dict)
    scene: SceneData = field(default_factory=SceneData)
    sources: Sequence[SourceData] = ()


def report_html(model: ReportModel, results: ReportResults) -> str:
    """The report as text; the same input gives the same characters."""
    facts = (("version", model.version), ("model", model.model_hash[:12]), ("date", model.date or ""))
    teeth = [int(gear["z"]) for gear in model.gears.values() if isinstance(gear.get("z"), int)]
    # a little more than three mesh orders, so that the third one is not on the frame
    highest = 3.2 * max(teeth) if teeth else 100.0
    seen = results.scene.run if results.scene.scene is not None else ""
    sections = [
        summary_section(model.counts, results),
        scene_section(results.scene),
        power_section(results.powers),
        parts.gear_section(model.gears, model.meshes, model.flanks, model.bevels, model.inactive_faults),
        parts.drawing_section(model.pairs),
        signal_section(model.signals),
        mesh_cycle_section(results.mesh_cycles),
        roll_section(results.rolls),
        mode_section(results.modes),
        parts.campbell_section(results.campbell),
        parts.sweep_section(results.sweeps),
        case_section(results.cases),
        parts.time_section(results.runs, seen),
        spectrum_section(results.runs, highest, model.shafts),
        extreme_section(results.runs, seen),
        provenance_section(results.sources),
        parts.notes_section(model.warnings, model.assumptions, model.sources),
    ]
    footer = f"Made by pitchpoint {model.version}".rstrip()
    if model.model_hash:
        footer += f" from the model {model.model_hash}"
    alerts = [f"{s.name} is not complete: {s.sentence}." for s in results.sources if not s.finished]
    return page(model.title, facts, sections, footer + ".", alerts)
