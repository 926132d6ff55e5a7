# SPDX-License-Identifier: Apache-2.0
"""`report_html`: report on a model and its results as one HTML page.

The input is plain data, which `pitchpoint.report` collects from models and files. Sections without data are
omitted.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from pitchpoint.core.progress import report_step
from pitchpoint.viz.power_flow import PowerFlow
from pitchpoint.viz.quantities import printed
from pitchpoint.viz.report import sections as parts
from pitchpoint.viz.report.campbell import campbell_section
from pitchpoint.viz.report.cases import case_section
from pitchpoint.viz.report.compare import compare_section
from pitchpoint.viz.report.contact import ContactData, contact_section
from pitchpoint.viz.report.cycles import mesh_cycle_section, roll_section
from pitchpoint.viz.report.extremes import extreme_section
from pitchpoint.viz.report.gearbox import GearboxData, gearbox_section
from pitchpoint.viz.report.overview import provenance_section, scene_section
from pitchpoint.viz.report.page import Section, page
from pitchpoint.viz.report.power import power_section
from pitchpoint.viz.report.relief import relief_section
from pitchpoint.viz.report.responses import response_section
from pitchpoint.viz.report.spectra import default_highest_order, spectrum_section
from pitchpoint.viz.report.studies import study_section
from pitchpoint.viz.report.summary import summary_section
from pitchpoint.viz.report.sweeps import sweep_section
from pitchpoint.viz.report.tables import mode_section, parameter_section, signal_section
from pitchpoint.viz.report.time import time_section
from pitchpoint.viz.scene.content import Scene

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.analysis.study.summary import StudySummary


@dataclass(frozen=True, kw_only=True)
class ReportModel:
    """Model data of a report.

    Attributes
    ----------
    title
        Title of the model file.
    model_hash, version
        Fingerprint of the model and version of the package that computed the results.
    date
        Date shown if given; without it the same data give the same file.
    gears, meshes
        SI values by identifier (`m_n`, `d_a`, `eps_alpha` …), by name of the gear or mesh.
    bevels
        The same for bevel gears and bevel meshes.
    flanks
        Modifications, deviations and faults of flanks: gear, flanks, kind, amount, extent.
    inactive_faults
        Number of tooth faults with severity 0, which are not among the flanks.
    pairs
        `GearPair` and the names of its gears, by name of the mesh, for the drawings.
    shafts
        Body of gear 1 by name of the mesh: default reference of the orders of the mesh.
    counts
        Number and names of the components of each section, for the summary.
    signals
        Sensors, blocks, controllers and actuators: signal, type, inputs, users.
    parameters
        Parameters: name, text of the file, value, description.
    warnings
        Remarks on the model and its results, for the summary.
    assumptions
        Omitted keys and the values in effect, by component in words.
    sources
        Standards and papers.
    gearbox
        Drawing in section, and power flow at constant speed.
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
    parameters: Sequence[Sequence[str]] = ()
    warnings: Sequence[str] = ()
    assumptions: Sequence[tuple[str, Sequence[tuple[str, str]]]] = ()
    sources: Sequence[str] = ()
    gearbox: GearboxData = field(default_factory=GearboxData)


@dataclass(frozen=True, kw_only=True)
class SourceData:
    """Provenance of a result.

    Attributes
    ----------
    name
        Name in the report.
    kind
        Time response, slow roll, speed sweep, cases.
    finished
        Whether the computation finished.
    sentence
        Status in words.
    rows
        Further properties as pairs of name and text.
    """

    name: str
    kind: str = ""
    finished: bool = True
    sentence: str = ""
    rows: Sequence[tuple[str, str]] = ()


@dataclass(frozen=True, kw_only=True)
class SceneData:
    """3-D scene of a report.

    Attributes
    ----------
    scene
        Contents of the scene; None if there is no scene.
    run
        Name of the displayed time response; empty for a scene at rest.
    words
        Caption, or the reason why there is no scene.
    hint
        Sentence about the controls, on the screen only.
    """

    scene: Scene | None = None
    run: str = ""
    words: str = ""
    hint: str = ""


@dataclass(frozen=True, kw_only=True)
class MeshCycleData:
    """Mesh cycle of one mesh.

    Attributes
    ----------
    stiffness
        `contact.mesh_cycle.MeshCycle`, or anything with `phase`, `stiffness_ratio`, `mean`, `minimum`,
        `maximum`.
    stiffness_unit, unit_stiffness
        Reference of the ratio, and its value [N/m]; None if it is not a stiffness.
    error_phase, errors
        Phases [base pitches], shape (n,), and transmission errors [m], shape (n,), by load case.
    cycles, repeats
        Number of mesh cycles of these phases, and number after which the curves repeat, 0 if not known; a
        single cycle that repeats is drawn twice, other curves once.
    loaded_ratio
        Slope of the force under load at the same phases, in the unit of the stiffness; optional.
    share_way, share
        Travel of a tooth pair since the start of contact [base pitches] and its load share.
    """

    stiffness: Any = None
    stiffness_unit: str = "c′·b"
    unit_stiffness: float | None = None
    error_phase: ArrayLike = ()
    errors: Mapping[str, ArrayLike] = field(default_factory=dict)
    cycles: int = 1
    repeats: int = 1
    loaded_ratio: ArrayLike = ()
    share_way: ArrayLike = ()
    share: ArrayLike = ()


@dataclass(frozen=True, kw_only=True)
class RollData:
    """Slow roll from a result.

    Attributes
    ----------
    curves
        By mesh: periods since the start [-], (n,), and transmission errors [m], (n,), by load case.
    mesh
        Mesh that defines the periods of the roll.
    note
        Sentence above the curves (status of an unfinished roll).
    planets
        Load sharing of planetary stages, see `planet_table`.
    """

    curves: Mapping[str, tuple[ArrayLike, Mapping[str, ArrayLike]]]
    mesh: str = ""
    note: str = ""
    planets: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class ModeData:
    """Modes about the loaded state: names, frequencies [Hz], damping ratios (nan: none).

    `scenarios` lists the scenarios with these modes, `others` those with other prescribed motions, `held` the
    bodies with prescribed motion, which do not vibrate, `engaged` the engaged clutches. `total` is the number
    of all modes if only the lowest are given. `strain_share` are the shares of `components` in the strain
    energy, shape (number of modes, number of components). `at` is the state of a sweep, in words. `sources`
    are the components that feed unstable modes, "" for the others; `undamped`: the model has no damping.
    """

    names: Sequence[str]
    frequency: Sequence[float]
    damping_ratio: Sequence[float]
    scenarios: Sequence[str] = ()
    others: Sequence[str] = ()
    held: Sequence[str] = ()
    engaged: Sequence[str] = ()
    total: int = 0
    components: Sequence[str] = ()
    strain_share: ArrayLike = ()
    at: str = ""
    sources: Sequence[str] = ()
    undamped: bool = False


@dataclass(frozen=True, kw_only=True)
class CaseTable:
    """Independent cases.

    Attributes
    ----------
    cases
        Mappings with `values` (texts by path), `numbers` (SI by path), `status`, `sentence` (status in
        words), and `channels` (statistics).
    units
        SI unit of the numbers by path.
    """

    cases: Sequence[Mapping[str, Any]]
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class TimeRun:
    """Time response.

    Attributes
    ----------
    data
        `xarray.Dataset` over `time`, or a mapping with `time` and channels (`viz.quantities.Channel` or
        arrays).
    settle_time
        Start of the window of statistics and spectra, after the first sample [s].
    angle
        Angle channel of the reference shaft of orders; default: shaft of gear 1 of each mesh.
    highest_order
        End of order maps and order spectra [-]; default 3.2 times the largest number of teeth, or 10. Without
        it, maps end at their last significant order, after three orders of the fastest mesh.
    mesh_frequencies
        Mean mesh frequencies by mesh [Hz], marked in spectra and maps.
    groups
        Titles and names of the channels to be drawn, by meaning; default: the main quantities.
    note
        Sentence above the signals (status of an unfinished run).
    planets
        Load sharing of planetary stages, see `planet_table`.
    fatigue
        Fatigue loads, see `add_fatigue`.
    """

    data: Any
    settle_time: float = 0.0
    angle: str | None = None
    highest_order: float | None = None
    note: str = ""
    mesh_frequencies: Mapping[str, float] = field(default_factory=dict)
    groups: Sequence[tuple[str, Sequence[str]]] = ()
    planets: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    fatigue: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class ReportResults:
    """Results by name; omitted results have no section.

    Attributes
    ----------
    mesh_cycles
        By the name of the mesh.
    planets
        Load sharing of planetary stages in the rolls of the report itself, see `planet_table`.
    rolls
        Slow rolls by the name of the scenario.
    runs
        Time responses by the name of the scenario.
    sweeps
        By the name of the scenario: a mapping with `points` and `jumps`, as `pitchpoint sweep --json` prints
        it.
    campbells
        Campbell diagrams by name, datasets of `solve_campbell`, or a sentence with the reason why there is
        none; those of the report itself by the names of their scenarios.
    modes
        Modes about the loaded state, by the names of their scenarios.
    cases
        Independent cases by the name of the scenario.
    contacts
        Contact analyses by the name of the mesh.
    reliefs
        Relief designs by the name of the mesh: datasets of `design_relief`.
    responses
        By name: datasets of `solve_frequency_response` and `solve_mesh_response`.
    studies
        Summaries of studies by name.
    powers
        Power flow by name of the time response, or a sentence with the reason why there is none.
    scene
        3-D scene.
    compared
        Families of variants: title, and names of runs or sweeps by what distinguishes them.
    sources
        Provenance of the results.
    """

    mesh_cycles: Mapping[str, MeshCycleData] = field(default_factory=dict)
    planets: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    rolls: Mapping[str, RollData] = field(default_factory=dict)
    runs: Mapping[str, TimeRun] = field(default_factory=dict)
    sweeps: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    campbells: Mapping[str, xr.Dataset | str] = field(default_factory=dict)
    modes: Mapping[str, ModeData] = field(default_factory=dict)
    cases: Mapping[str, CaseTable] = field(default_factory=dict)
    contacts: Mapping[str, ContactData] = field(default_factory=dict)
    reliefs: Mapping[str, xr.Dataset] = field(default_factory=dict)
    responses: Mapping[str, xr.Dataset] = field(default_factory=dict)
    studies: Mapping[str, StudySummary] = field(default_factory=dict)
    powers: Mapping[str, PowerFlow | str] = field(default_factory=dict)
    scene: SceneData = field(default_factory=SceneData)
    compared: Sequence[tuple[str, Mapping[str, str]]] = ()
    sources: Sequence[SourceData] = ()


def report_html(model: ReportModel, results: ReportResults) -> str:
    """HTML text of the report; the same input gives the same text."""
    facts = (("version", model.version), ("model", model.model_hash[:12]), ("date", model.date or ""))
    teeth = [int(gear["z"]) for gear in model.gears.values() if isinstance(gear.get("z"), int)]
    highest = default_highest_order(teeth)
    seen = results.scene.run if results.scene.scene is not None else ""
    overlaid = {name for _, members in results.compared for name in members.values()}
    makers: list[Callable[[], Section]] = [
        lambda: summary_section(model.counts, results, model.warnings),
        lambda: gearbox_section(model.gearbox),
        lambda: compare_section(results.compared, results),
        lambda: scene_section(results.scene),
        lambda: power_section(results.powers),
        lambda: time_section(results.runs, seen, overlaid),
        lambda: sweep_section(results.sweeps),
        lambda: case_section(results.cases),
        lambda: study_section(results.studies),
        lambda: spectrum_section(results.runs, highest, model.shafts, overlaid=overlaid),
        lambda: campbell_section(results.campbells),
        lambda: mode_section(results.modes),
        lambda: response_section(results.responses),
        lambda: contact_section(results.contacts),
        lambda: relief_section(results.reliefs),
        lambda: roll_section(results.rolls),
        lambda: mesh_cycle_section(results.mesh_cycles, results.planets),
        lambda: parts.gear_section(
            model.gears, model.meshes, model.flanks, model.bevels, model.inactive_faults
        ),
        lambda: parts.drawing_section(model.pairs),
        lambda: parameter_section(model.parameters),
        lambda: signal_section(model.signals),
        lambda: extreme_section(results.runs, seen),
        lambda: provenance_section(results.sources),
        lambda: parts.notes_section(model.assumptions, model.sources),
    ]
    sections = []
    for k, make in enumerate(makers):
        report_step(f"page, {100.0 * k / len(makers):.0f} %")
        sections.append(make())
    footer = f"Made by pitchpoint {model.version}".rstrip()
    if model.model_hash:
        footer += f" from the model {model.model_hash}"
    alerts = [f"{s.name} is not complete: {s.sentence}." for s in results.sources if not s.finished]
    return page(printed(model.title), facts, sections, footer + ".", alerts)
