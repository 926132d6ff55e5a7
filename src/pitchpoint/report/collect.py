# SPDX-License-Identifier: Apache-2.0
"""Collect the results of a report: those in files or datasets, by scenario."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import PitchpointError, split_notes
from pitchpoint.core.progress import Progress, report_step
from pitchpoint.report.campbell import KEPT as CAMPBELL
from pitchpoint.report.fatigue import LoadCases, fatigue_loads
from pitchpoint.report.main_channels import drawn_groups
from pitchpoint.report.notes import own_notes
from pitchpoint.report.planets import load_sharing
from pitchpoint.report.result_kinds import kind_of
from pitchpoint.report.rolls import given_roll, without_given
from pitchpoint.report.run_frequencies import mean_mesh_frequencies
from pitchpoint.report.study_data import case_table, sweep_of
from pitchpoint.report.study_result import study_summary
from pitchpoint.report.variants import change_words, variant_words
from pitchpoint.viz.quantities import settle_time_of
from pitchpoint.viz.report.build import (
    CaseTable,
    MeshCycleData,
    ReportResults,
    RollData,
    SourceData,
    TimeRun,
)
from pitchpoint.viz.report.contact import ContactData, contact_result

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.analysis.study.summary import StudySummary
    from pitchpoint.model.model import Model

RESPONSES = ("frequency_response", "mesh_response")
"""Kinds of results in the section of the frequency responses."""


@dataclass
class _Found:
    """Results by name, mostly that of the scenario, and remarks."""

    runs: dict[str, TimeRun] = field(default_factory=dict)
    sweeps: dict[str, dict[str, Any]] = field(default_factory=dict)
    cases: dict[str, CaseTable] = field(default_factory=dict)
    rolls: dict[str, RollData] = field(default_factory=dict)
    contacts: dict[str, ContactData] = field(default_factory=dict)
    reliefs: dict[str, xr.Dataset] = field(default_factory=dict)
    campbells: dict[str, xr.Dataset] = field(default_factory=dict)
    responses: dict[str, xr.Dataset] = field(default_factory=dict)
    studies: dict[str, StudySummary] = field(default_factory=dict)
    sources: list[SourceData] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    notes: list[tuple[str, list[str]]] = field(default_factory=list)
    """Name of a result and its notes."""
    variants: dict[str, tuple[str, str, str]] = field(default_factory=dict)
    """Scenario, text of the model and file by name of the run or sweep."""
    scenarios: list[str] = field(default_factory=list)
    """Scenarios of the runs, sweeps and cases."""
    others: dict[str, str] = field(default_factory=dict)
    """Remarks on other versions of the model by name."""
    names: list[str] = field(default_factory=list)
    """Names in use, each of one result: provenance, states and notes are listed by name."""

    def name(self, wanted: str, other: str) -> str:
        """Name of one more result; `other` is added, then a number, if the name is in use."""
        if wanted in self.names:
            wanted = f"{wanted} ({other})"
        candidates = (wanted, *(f"{wanted} {k}" for k in range(2, len(self.names) + 2)))
        self.names.append(next(n for n in candidates if n not in self.names))
        return self.names[-1]


def collect(
    model: Model,
    results: Sequence[str | os.PathLike[str] | xr.Dataset],
    progress: Progress,
    compare: bool = False,
) -> tuple[ReportResults, list[str]]:
    """Collect the contents of a report: results of the model alone, given results, and remarks.

    `compare`: overlay runs of different scenarios as well.
    """
    from pitchpoint.io.opening import understood
    from pitchpoint.report.linear_parts import UNITS_OF_WORK, conditions_of, linear_parts
    from pitchpoint.report.number_rows import C_PRIME_B, MEAN
    from pitchpoint.report.numbers import cycles_of_model
    from pitchpoint.report.overview import power_part, scene_part
    from pitchpoint.report.same_machine import require_same_machine
    from pitchpoint.report.statics import with_rolls

    require_same_machine(model, results)
    found = _Found()
    words = {C_PRIME_B: "c′·b", MEAN: "mean"}
    for result in results:
        if isinstance(result, str | os.PathLike):
            report_step(f"result {Path(result).name}")
            with understood(result):
                _add_file(found, os.fspath(result), model)
        else:
            _add_dataset(found, result, model)
    compared = _compare(found, compare)
    cycles = {
        name: (
            MeshCycleData(
                stiffness=cycle, stiffness_unit=words.get(relative_to, relative_to), unit_stiffness=unit
            ),
            unit,
        )
        for name, (cycle, relative_to, unit) in cycles_of_model(model, 401).items()
    }
    conditions = conditions_of(model, found.scenarios)
    rolled = with_rolls(model, cycles, progress, UNITS_OF_WORK * len(conditions))
    linear = linear_parts(model, conditions, progress, rolled.count, diagrams=not found.campbells)
    shown = ReportResults(
        mesh_cycles=without_given(rolled.cycles, found.rolls),
        planets=rolled.planets,
        rolls=found.rolls,
        modes=linear.modes,
        campbells=found.campbells or linear.campbells,
        runs=found.runs,
        sweeps=found.sweeps,
        cases=found.cases,
        contacts=found.contacts,
        reliefs=found.reliefs,
        responses=found.responses,
        studies=found.studies,
        powers=power_part(model, found.runs),
        scene=scene_part(model, found.runs),
        compared=compared,
        sources=found.sources,
    )
    return shown, [*rolled.notes, *linear.remarks, *found.remarks, *own_notes(found.notes)]


def _what_differs(model: Model, scenario: str, text: str, file: str) -> str:
    """Sentence on a result of another model than that of the report, with the values that differ, if few."""
    from pitchpoint.model.write import model_text

    words = change_words(model_text(model), text, scenario, file) if text else ""
    return f"{Path(file).name} was computed with {words or 'a different version of the model'}."


def _add_file(found: _Found, file: str, model: Model) -> None:
    """Add the contents of one result file to the data of the report."""
    from pitchpoint.analysis.jumps import sweep_jumps
    from pitchpoint.core.provenance import content_hash
    from pitchpoint.io.case_store import read_cases
    from pitchpoint.io.reading import open_result, read_header
    from pitchpoint.io.sweep_store import read_sweep
    from pitchpoint.report.provenance import source_of

    header = read_header(file)
    name, own = str(header["scenario"] or Path(file).stem), Path(file).name

    scenario, text = str(header.get("scenario", "")), str(header.get("model_text", ""))

    def recorded(key: str) -> str:
        """Name of a result, whose origin, version of the model and notes are recorded."""
        if str(header.get("model_hash", "")) not in ("", content_hash(model)):
            found.others[key] = _what_differs(model, scenario, text, file)
        found.sources.append(source_of(key, header, content_hash(model), own))
        found.notes.append((key, split_notes(str(header.get("notes", "")))))
        return key

    def take(kind: dict[str, Any]) -> str:
        """Recorded name of a result of a kind."""
        key = found.name(name, own)
        if kind is found.runs or kind is found.sweeps:
            found.variants[key] = (scenario, text, file)
        if kind is found.runs or kind is found.sweeps or kind is found.cases:
            found.scenarios.append(scenario)
        return recorded(key)

    if header["kind"] == "sweep":
        found.sweeps[take(found.sweeps)] = read_sweep(file)
    elif header["kind"] == "cases":
        cases = read_cases(file)
        units = header["options"].get("vary_units", {})
        found.cases[take(found.cases)] = CaseTable(cases=cases, units=units)
        for case in cases:
            if case["points"]:
                words = ", ".join(f"{path} = {text}" for path, text in case["values"].items())
                jumps = [
                    {"direction": j.direction, "mesh_frequency": j.frequency}
                    for j in sweep_jumps(case["points"])
                ]
                key = found.name(f"{name}: {words}", own)
                found.sweeps[key] = {"points": case["points"], "jumps": jumps}
    elif header["kind"] == "campbell":
        with open_result(file) as data:
            data.load()
        data.attrs |= {k: header["options"][k] for k in CAMPBELL if k in header["options"]}
        found.campbells[take(found.campbells)] = data
    elif header["kind"] in RESPONSES:
        with open_result(file) as data:
            found.responses[take(found.responses)] = data.load()
    elif header["kind"] == "study":
        with open_result(file) as data:
            found.studies[take(found.studies)] = study_summary(data.load())
    elif header["kind"] == "relief":
        name = str(header["options"].get("mesh", name))
        with open_result(file) as data:
            found.reliefs[take(found.reliefs)] = data.load()
    elif header["kind"] == "contact" and "meshes" in header["options"]:
        for mesh in header["options"]["meshes"]:
            with open_result(file, f"meshes/{mesh}") as data:
                data.load()
            note = str(data.attrs.get("sentence", ""))
            note = note and f"This analysis is not complete: {note}"
            found.contacts[found.name(mesh, own)] = contact_result(data, note)
        found.remarks += [
            f"{own}: mesh {mesh} is omitted: {reason}."
            for mesh, reason in header["options"].get("omitted", {}).items()
        ]
        recorded(found.name(name, own))
    elif header["kind"] in ("time", "quasi_static", "contact"):
        whole = header["status"] == "finished"
        note = "" if whole else f"This run is not complete: {header['status']}. {header['sentence']}"
        with open_result(file) as data:
            data.load()
        if header["kind"] == "time":
            data, lost = without_damaged(data)
            found.remarks += [f"{own}: omitted because they are damaged: {', '.join(lost)}"] if lost else []
        if header["kind"] == "contact":
            name = str(header["options"].get("mesh", name))
            found.contacts[take(found.contacts)] = contact_result(data, note)
            return
        if header["kind"] == "quasi_static":
            found.rolls[take(found.rolls)] = given_roll(data, note, model)
            return
        found.runs[take(found.runs)] = time_run(model, data, header, note)
    else:
        kind = str(header["kind"]).replace("_", "-")
        words = f"a report recomputes {kind} results from the model; those of the file are not shown."
        found.remarks.append(f"{own}: {words}")


def _compare(found: _Found, everything: bool) -> list[tuple[str, dict[str, str]]]:
    """Families of variants among runs and sweeps, which get names by what distinguishes them."""
    families: dict[tuple[str, str], list[str]] = {}
    for kind, results in (("run", found.runs), ("sweep", found.sweeps)):
        for name in results:
            scenario, text, _ = found.variants.get(name, ("", "", ""))
            if text:
                families.setdefault((kind, "" if everything else scenario), []).append(name)
    compared: list[tuple[str, dict[str, str]]] = []
    named: dict[str, str] = {}
    for (_, scenario), names in families.items():
        if len(names) < 2:
            continue
        scenarios = {name: found.variants[name][0] for name in names}
        texts, files = ({name: found.variants[name][k] for name in names} for k in (1, 2))
        words = variant_words(texts, scenarios, files)
        if words:
            named |= {name: f"{scenarios[name]}: {words[name]}" for name in names}
        elif not everything:
            continue
        labels = {name: words.get(name, name) for name in names}
        if len({*scenarios.values()}) > 1:
            labels = {name: named.get(name, name) for name in names}
        title = scenario or "Runs and studies"
        compared.append((title, {labels[name]: named.get(name, name) for name in names}))
    found.runs = {named.get(name, name): run for name, run in found.runs.items()}
    found.sweeps = {named.get(name, name): sweep for name, sweep in found.sweeps.items()}
    found.sources = [replace(source, name=named.get(source.name, source.name)) for source in found.sources]
    found.notes = [(named.get(name, name), own) for name, own in found.notes]
    found.remarks += [words for name, words in found.others.items() if name not in named]
    return compared


def time_run(model: Model, data: xr.Dataset, attrs: Mapping[str, Any], note: str = "") -> TimeRun:
    """Time response with its window of statistics, its notes and its mesh frequencies."""
    settle = settle_time_of(attrs)
    meshes = mean_mesh_frequencies(model, data, settle)
    groups = drawn_groups(model, map(str, data.data_vars), str(attrs.get("scenario", "")))
    planets = load_sharing(model, data, settle)
    about: dict[str, Any] = {"note": note, "groups": groups, "planets": planets}
    if model.wind_rotors:
        report_step("fatigue loads")
        try:
            about["fatigue"] = fatigue_loads(LoadCases(model, [data], [None]))
        except PitchpointError as problem:  # of an unfinished run
            about["note"] = f"{note} No fatigue loads: {problem}.".strip()
    return TimeRun(data=data, settle_time=settle, mesh_frequencies=meshes, **about)


def without_damaged(data: xr.Dataset) -> tuple[xr.Dataset, list[str]]:
    """Record without channels of another shape or type than numbers over time, and their names."""
    lost = [
        str(name)
        for name, values in data.data_vars.items()
        if values.dims != ("event",) and (values.dims != ("time",) or values.dtype.kind not in "fiub")
    ]
    return data.drop_vars(lost), lost


def _add_dataset(found: _Found, data: xr.Dataset, model: Model) -> None:
    """Add a result, identified by its dimensions, to the data of the report."""
    from pitchpoint.core.provenance import content_hash
    from pitchpoint.report.provenance import source_of

    kind = kind_of(data) if hasattr(data, "data_vars") else ""
    if kind == "time":
        name = found.name("time response", str(len(found.runs) + 1))
        found.runs[name] = time_run(model, data, data.attrs)
    elif kind == "sweep":
        name = found.name("sweep", str(len(found.sweeps) + 1))
        found.sweeps[name] = sweep_of(data)
    elif kind == "cases":
        name = found.name("cases", str(len(found.cases) + 1))
        found.cases[name] = case_table(data)
    elif kind == "study":
        name = found.name("study", str(len(found.studies) + 1))
        found.studies[name] = study_summary(data)
    elif kind == "campbell":
        name = found.name("Campbell diagram", str(len(found.campbells) + 1))
        found.campbells[name] = data
    elif kind in RESPONSES:
        name = found.name(kind.replace("_", " "), str(len(found.responses) + 1))
        found.responses[name] = data
    elif kind == "relief":
        mesh = str(data.attrs.get("mesh", "relief"))
        name = found.name(mesh, str(len(found.reliefs) + 1))
        found.reliefs[name] = data
    elif kind == "contact":
        mesh = str(data.attrs.get("mesh", "contact"))
        name = found.name(mesh, str(len(found.contacts) + 1))
        found.contacts[name] = contact_result(data)
    elif kind == "quasi_static":
        name = found.name("slow roll", str(len(found.rolls) + 1))
        found.rolls[name] = given_roll(data, model=model)
    else:
        what = f"a dataset over {', '.join(map(str, data.dims))}" if kind else type(data).__name__
        raise PitchpointError(
            f"results: {what} cannot be shown in a report; "
            "give a dataset of solve_time, solve_quasistatic, solve_campbell, solve_frequency_response, "
            "solve_mesh_response, solve_contact, design_relief, sweep_speed, cases_dataset or run_study, "
            "or the name of a result file"
        )
    scenario = str(data.attrs.get("scenario", ""))
    if kind in ("time", "sweep"):
        source = str(data.encoding.get("source", "result"))
        found.variants[name] = (scenario, str(data.attrs.get("model_text", "")), source)
    if kind in ("time", "sweep", "cases"):
        found.scenarios.append(scenario)
    found.sources.append(source_of(name, {"kind": kind, **data.attrs}, content_hash(model)))
    found.notes.append((name, split_notes(str(data.attrs.get("notes", "")))))
