# SPDX-License-Identifier: Apache-2.0
"""Conversion of plain data to a `DatasetPlan`, and its check against the model; all problems are
collected."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import hint
from pitchpoint.core.nomenclature import can_be_filtered
from pitchpoint.model.checks.choices import check_keys
from pitchpoint.model.dataset_plan import DatasetPlan, Level, ObservedChannel, TachoChannel
from pitchpoint.model.keys import BAD, Key, Place
from pitchpoint.model.model import Model
from pitchpoint.model.numbers import number_at
from pitchpoint.model.reading.plan import check_mapping, in_order, plan_values
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.show import shown

OWN = ("factors", "jitter")
MAX_CASES = 10_000_000
RESERVED = ("case", "file", "status", "status_code", "sentence", "seed", "steps")
"""Columns of every table of cases in addition to the labels."""
_SHARE = Key("quantity", "standard deviation over the value", "dimensionless", minimum=0.0, maximum=1.0)
_HOW = "write PATH: [VALUE, ...], or named conditions NAME: {PATH: VALUE, ...}"


def read_plan(data: Any, reader: Reader, file: str | None = None) -> DatasetPlan:
    """Create a plan from the nested mappings of a file.

    Parameters
    ----------
    data
        Mappings, lists, strings and numbers.
    reader
        Reader with the line numbers of the file; its previous problems are reported too.
    file
        Name of the file for messages.

    Raises
    ------
    ModelError
        With all problems of the plan itself, in the order of the file.
    """
    check_mapping(data, reader, file)
    values = plan_values(DatasetPlan, data, reader, OWN)
    values["factors"] = _factors(data.get("factors"), reader)
    values["jitter"] = _jitter(data.get("jitter"), reader)
    check_keys(values.get("channels", {}), ("channels",), reader)
    if (
        not values.get("channels")
        and ("channels",) not in reader.tainted
        and data.get("channels") is not None
    ):
        reader.problem(("channels",), "is empty: nothing would be recorded", remedy="name a channel")
    if "length" in values and "sample_rate" in values and values["length"] * values["sample_rate"] < 2.0:
        reader.problem(
            ("length",),
            "contains less than two samples",
            remedy="increase length or sample_rate",
            taint=False,
        )
    if reader.problems:
        raise ModelError(in_order(reader.problems), file)
    plan = DatasetPlan(**values, file=file, lines=reader.lines, allow_code=reader.allow_code)
    if len(plan) > MAX_CASES:
        limit = f"at most {MAX_CASES}"
        raise ModelError([Message("factors", f"give {len(plan)} cases", None, limit, "split the plan")], file)
    return plan


def _factors(data: Any, reader: Reader) -> dict[str, tuple[Level, ...]]:
    """Read the levels of every factor; a path may occur in one factor only."""
    if data is None:
        return {}
    if not isinstance(data, Mapping):
        reader.problem(("factors",), "is not a mapping", value=shown(data), remedy=_HOW)
        return {}
    found: dict[str, tuple[Level, ...]] = {}
    taken: dict[str, str] = {}
    for name, entry in data.items():
        at = ("factors", str(name))
        if not reader.good_name(name, ("factors",)):
            continue
        if name in RESERVED:
            reader.problem(at, "is a reserved column name", remedy="give the factor another name")
            continue
        levels = _levels(entry, at, reader)
        for path in dict.fromkeys(p for level in levels for p in level.changes):
            if taken.setdefault(path, str(name)) != name:
                reader.problem(
                    at,
                    f"changes {path}, as does {taken[path]}",
                    remedy="change it in one factor only",
                    taint=False,
                )
        found[str(name)] = levels
    return found


def _levels(data: Any, at: Place, reader: Reader) -> tuple[Level, ...]:
    """Read the levels of one factor."""
    if not isinstance(data, Mapping) or not data:
        reader.problem(at, "is not a mapping with entries", value=shown(data), remedy=_HOW)
        return ()
    if all(isinstance(entry, list) for entry in data.values()):
        if len(data) > 1:
            remedy = "make each path a factor, or write named conditions"
            reader.problem(at, f"has lists for {len(data)} paths", remedy=remedy)
            return ()
        [(path, values)] = data.items()
        if not values:
            reader.problem((*at, path), "is an empty list", remedy="name at least one value")
        return tuple(Level(_text(v), {path: v}, (*at, path, k)) for k, v in enumerate(values))
    levels: list[Level] = []
    for label, changes in data.items():
        here = (*at, str(label))
        if not isinstance(changes, Mapping):
            reader.problem(here, "is not a mapping of paths to values", value=shown(changes), remedy=_HOW)
            continue
        lists = [v if isinstance(v, list) else [v] for v in changes.values()]
        empty = [p for p, v in zip(changes, lists, strict=True) if not v]
        for path in empty:
            reader.problem((*here, path), "is an empty list", remedy="name at least one value")
        for chosen in itertools.product(*lists):
            levels.append(Level(str(label), dict(zip(changes, chosen, strict=True)), here))
    return tuple(levels)


def _text(value: Any) -> str:
    """A value as a label."""
    return value if isinstance(value, str) else shown(value)


def _jitter(data: Any, reader: Reader) -> dict[str, float]:
    """Read the relative standard deviations by path."""
    if data is None:
        return {}
    if not isinstance(data, Mapping):
        remedy = "write PATH: SHARE, such as loads.brake.torque: 2 %"
        reader.problem(("jitter",), "is not a mapping", value=shown(data), remedy=remedy)
        return {}
    found = {}
    for path, value in data.items():
        share = reader.number(_SHARE, value, ("jitter", str(path)))
        if share is not BAD:
            found[str(path)] = share
    return found


def check_plan(plan: DatasetPlan, model: Model, channels: tuple[str, ...]) -> DatasetPlan:
    """Check a plan against its model and return it with the name of its scenario.

    Parameters
    ----------
    plan
        The plan.
    model
        Its model.
    channels
        Names of the observations of the model; empty if unknown, then they are not checked.

    Raises
    ------
    ModelError
        With all levels that the model rejects, and all unknown names.
    """
    report = Reader(lines=plan.lines)
    over_time = [name for name, s in model.scenarios.items() if s.kind == "time"]
    scenario = plan.scenario or (over_time[0] if len(over_time) == 1 else None)
    if scenario is None:
        listed = ", ".join(over_time) or "none"
        report.problem(("scenario",), "is missing", remedy=f"name a time response; there are: {listed}")
    elif scenario not in over_time:
        report.problem(
            ("scenario",), f"is not a time response: {scenario}", remedy=hint(scenario, over_time, 3)
        )
    for levels in plan.factors.values():
        for level in levels:
            _check_level(level, model, report, plan.allow_code)
    for path in plan.jitter:
        changed = next((lv.changes for f in plan.factors.values() for lv in f if path in lv.changes), {})
        try:
            if (
                number_at(
                    model.replace_all({path: changed[path]}, allow_code=plan.allow_code)
                    if changed
                    else model,
                    path,
                )
                is None
            ):
                remedy = "name a key of the model with a single number"
                report.problem(("jitter", path), "is not a number of the model", remedy=remedy)
        except ModelError:
            continue  # reported for the level
    for name, channel in plan.channels.items():
        _check_channel(name, channel, model, channels, report)
    if report.problems:
        raise ModelError(in_order(report.problems), plan.file)
    return replace(plan, scenario=scenario)


def _check_level(level: Level, model: Model, report: Reader, allow_code: bool) -> None:
    """Report the problems of the model with the values of a level, with their lines if known."""
    if not level.changes:
        return
    try:
        model.replace_all(level.changes, allow_code=allow_code)
    except ModelError as error:
        for problem in error.problems:
            near = [p for p in level.changes if problem.where.startswith(p) or p.startswith(problem.where)]
            at = (*level.place, near[0]) if near else level.place
            limits = f" (limit {problem.limit})" if problem.limit else ""
            value = f"{problem.value} " if problem.value else ""
            report.problem(
                at if at in report.lines else level.place,
                f"is rejected: {problem.where}: {value}{problem.text}{limits}",
                remedy=problem.remedy,
                taint=False,
            )


def _check_channel(name: str, channel: Any, model: Model, channels: tuple[str, ...], report: Reader) -> None:
    """Check the names of observations and bodies."""
    at = ("channels", name)
    if isinstance(channel, ObservedChannel) and channels and channel.channel not in channels:
        report.problem(
            (*at, "channel"),
            f"there is no observation {channel.channel!r}",
            remedy=hint(channel.channel, channels, 3),
        )
    elif (
        isinstance(channel, ObservedChannel)
        and channel.noise is not None
        and not can_be_filtered(channel.channel)
    ):
        report.problem(
            (*at, "noise"), f"is added to {channel.channel}, a state or phase", remedy="remove the noise"
        )
    elif isinstance(channel, TachoChannel) and channel.body not in model.bodies:
        report.problem(
            (*at, "body"),
            f"there is no body {channel.body!r}",
            remedy=hint(channel.body, tuple(model.bodies), 3),
        )
    elif isinstance(channel, TachoChannel) and channels and f"angle[{channel.body}]" not in channels:
        report.problem((*at, "body"), f"{channel.body} does not spin", remedy="name a body with a spin")
