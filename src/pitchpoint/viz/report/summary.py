# SPDX-License-Identifier: Apache-2.0
"""First section of a report: status and main numbers of every result, remarks, components of the model."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.campbell_ranking import LARGE, RankedSpeed, ranked_speeds
from pitchpoint.analysis.mesh_sweep import MeshSweep, mesh_sweeps
from pitchpoint.analysis.statistics import contact_statistics
from pitchpoint.core.status import OK
from pitchpoint.viz.power_flow import OUTSIDE, PowerFlow, PowerLink
from pitchpoint.viz.quantities import (
    ROUND_OFF,
    Array,
    Channel,
    amount,
    channel_scale,
    channels,
    number,
    span,
    window_words,
)
from pitchpoint.viz.report.bearing_forces import bearing_forces, with_resultants
from pitchpoint.viz.report.campbell import named_speeds, range_words
from pitchpoint.viz.report.case_results import case_quantities
from pitchpoint.viz.report.cases import short_path
from pitchpoint.viz.report.contact_times import working_flank
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.report.tables import MAX_MODES
from pitchpoint.viz.run_record import owner, settled_part, statistics_window
from pitchpoint.viz.sweep_meshes import jump_words
from pitchpoint.viz.tables import plain_table, text_html

MAX_RUNS = 4
"""Runs next to each other in one table; more continue in another table."""
MAX_ENDS = 4
"""Inputs or outputs named for one run."""
NO_POWER = 1e-3
"""Power relative to the largest one below which an element does not count as input or output."""
SPEEDS = "Speeds of input and output"
"""Title of the speeds among the curves of a run."""
VARIES = 0.02
"""Variation of a speed relative to its largest value from which its range is given."""
RIPPLE = 1.005
"""Ratio of the maximum of a mesh force to its mean from which it is given."""


def summary_section(counts: Sequence[tuple[str, str]], results: Any, warnings: Sequence[str] = ()) -> Section:
    """Section with main numbers of all results, remarks, and the components of the model.

    Parameters
    ----------
    counts
        Number and names of the components.
    results
        `ReportResults`.
    warnings
        Remarks on the model and its results.
    """
    section = Section("summary", "Summary")
    states = {source.name: "finished" if source.finished else source.sentence for source in results.sources}
    columns = {name: _run(name, run, states.get(name, ""), results) for name, run in results.runs.items()}
    names = list(columns)
    for k in range(0, len(names), MAX_RUNS):
        section.add(_side_by_side("time response", {name: columns[name] for name in names[k : k + MAX_RUNS]}))
    section.add(_sweeps(results.sweeps, states))
    section.add(_cases(results.cases, states))
    shown = {*results.runs, *results.sweeps, *results.cases}
    items = "".join(
        f"<li>{escape(source.kind[:1].upper() + source.kind[1:])} <b>{escape(source.name)}</b>: "
        f"{escape(states[source.name])}</li>"
        for source in results.sources
        if source.name not in shown
    )
    found = [*_unstable(results.modes), *_critical(results.campbells)]
    items += "".join(f"<li>{escape(words)}</li>" for words in found)
    section.add(f'<ul class="notes">{items}</ul>' if items else "")
    listed = "".join(f"<li>{text_html(line)}</li>" for line in warnings)
    section.add(f'<h3>Remarks</h3><ul class="notes warnings">{listed}</ul>' if listed else "")
    known = facts_list(counts)
    section.add(f"<h3>Model</h3>{known}" if known else "")
    return section


def facts_list(rows: Sequence[tuple[str, str]]) -> str:
    """Definition list in columns."""
    items = "".join(f"<div><dt>{escape(key)}</dt><dd>{escape(text)}</dd></div>" for key, text in rows)
    return f'<dl class="known">{items}</dl>' if items else ""


def _side_by_side(head: str, columns: Mapping[str, Mapping[str, str]]) -> str:
    """Table with one column per result; rows without any entry are omitted."""
    keys = list(dict.fromkeys(key for column in columns.values() for key in column))
    body = []
    for key in keys:
        cells = [column.get(key, "") for column in columns.values()]
        if any(cells):
            body.append(f'<tr><th scope="row">{text_html(key)}</th>{_cells(cells)}</tr>')
    return plain_table((head, *columns), body, numbers=False)


def _cells(cells: Sequence[str]) -> str:
    return "".join(f"<td>{cell or '–'}</td>" for cell in cells)


def _run(name: str, run: Any, state: str, results: Any) -> dict[str, str]:
    """Main numbers of one time response, by their names; HTML."""
    time, found = channels(run.data)
    if time.size < 2:
        return {"status": escape(state)}
    window = settled_part(time, run.settle_time)
    flow = results.powers.get(name)
    words = window_words(*statistics_window(time, found, run.settle_time))
    row = {"status": escape(state), "window": escape(words)}
    if isinstance(flow, PowerFlow):
        torques = _torques(found, window)
        inputs = [link for link in flow.links if link.start == OUTSIDE]
        outputs = [link for link in flow.links if link.end == OUTSIDE]
        row["input"] = _ends(flow, inputs, torques, starts=True)
        row["output"] = _ends(flow, outputs, torques, starts=False)
        row["input power"] = amount(flow.put_in, "W") if flow.put_in else ""
        row["losses"] = amount(flow.lost, "W") if flow.lost else ""
    row["speed"] = _speeds(run, found, window, known=bool(row.get("input") or row.get("output")))
    row["maximum mesh force"] = _largest(
        found, "mesh_force", window, lambda low, high: max(abs(low), abs(high)), over_mean=True
    )
    row["transmission error, p–p"] = _largest(
        found, "transmission_error", window, lambda low, high: _without_noise(high - low, low, high)
    )
    row |= {
        f"mesh load factor K_γ of the planets, {stage}": _factor(loads)
        for stage, loads in run.planets.items()
        if loads["load_sharing_factor"] is not None
    }
    row |= _contact(found, time, window)
    forces = bearing_forces(time, with_resultants(found), window)
    for key, size in (("radial", "maximum"), ("axial", "axial_maximum")):
        sizes = {bearing: getattr(force, size) for bearing, force in forces.items()}
        top = max(sizes, key=lambda b: sizes[b], default="")
        if top and sizes[top] > 1e-6 * max(force.maximum for force in forces.values()):
            row[f"maximum {key} bearing force"] = f"{amount(sizes[top], 'N')}, {escape(top)}"
    return row


def _factor(loads: Mapping[str, Any]) -> str:
    """Mesh load factor of the means, and the largest at a carrier position."""
    words = number(loads["load_sharing_factor"], 4)
    positions = loads.get("positions")
    return words if positions is None else f"{words}, largest {number(positions['load_sharing_factor'], 4)}"


def _torques(found: Mapping[str, Channel], window: np.ndarray) -> dict[str, float]:
    """Mean torque of every drive and load on its body [N m], with the sign of its channel."""
    torques = {}
    for channel in found.values():
        if channel.quantity == "torque" and channel.values[window].size:
            known = channel.statistics or {"mean": float(channel.values[window].mean())}
            torques[owner(channel)] = known["mean"]
            torques[f"reaction of {owner(channel)}"] = -known["mean"]
    return torques


def _ends(flow: PowerFlow, links: Sequence[PowerLink], torques: Mapping[str, float], *, starts: bool) -> str:
    """Speed, torque and power of each input or output; signs as in `speed` and `torque`."""
    rows = []
    powers = {link.name: link.given if starts else link.taken for link in links}
    # elements against ground transmit torques without power
    links = [link for link in links if powers[link.name] > NO_POWER * max(powers.values(), default=0.0)]
    links.sort(key=lambda link: -powers[link.name])
    for link in links[:MAX_ENDS]:
        speed = flow.blocks[link.end if starts else link.start].speed
        power = link.given if starts else link.taken
        torque = f", {amount(torques[link.name], 'N m')}" if link.name in torques else ""
        rows.append(f"{escape(link.name)}: {amount(speed, 'rad/s')}{torque}, {amount(power, 'W')}")
    rows += [f"{len(links) - MAX_ENDS} more"] if len(links) > MAX_ENDS else []
    return "<br>".join(rows)


def _speeds(run: Any, found: Mapping[str, Channel], window: np.ndarray, *, known: bool) -> str:
    """Speeds of the ends of the machine; only those that vary if the mean ones are `known`."""
    names = [name for title, own in run.groups if title == SPEEDS for name in own if name in found]
    rows = []
    for channel in (found[name] for name in names[:MAX_ENDS]):
        values = channel.values[window]
        if not values.size or not np.all(np.isfinite(values)):
            continue
        low, high = float(values.min()), float(values.max())
        steady = high - low <= VARIES * max(abs(low), abs(high))
        if steady and not known:
            rows.append(f"{escape(owner(channel))}: {amount(float(values.mean()), 'rad/s')}")
        elif not steady:
            rows.append(f"{escape(owner(channel))}: {span(low, high, 'rad/s')}")
    return "<br>".join(rows)


def _without_noise(size: float, low: float, high: float) -> float:
    """Peak to peak value; round-off of a constant is zero."""
    return size if size > 1e-7 * max(abs(low), abs(high)) else 0.0


def _largest(
    found: Mapping[str, Channel],
    quantity: str,
    window: np.ndarray,
    size: Callable[[float, float], float],
    over_mean: bool = False,
) -> str:
    """Largest value of a quantity over all meshes, with the name of the mesh and its ratio to the mean."""
    sizes = {}
    for channel in found.values():
        if channel.quantity != quantity or not np.all(np.isfinite(channel.values)) or not window.any():
            continue
        low, high = float(channel.values[window].min()), float(channel.values[window].max())
        known = channel.statistics or {"min": low, "max": high}
        sizes[owner(channel)] = size(min(low, known["min"]), max(high, known["max"]))
    if not sizes:
        return ""
    name = max(sizes, key=lambda key: sizes[key])
    unit = next(c.unit for c in found.values() if c.quantity == quantity)
    text = channel_scale(quantity, unit, np.array([sizes[name]])).text(sizes[name])
    text += f", {escape(name)}" if len(sizes) > 1 else ""
    if over_mean:
        channel = found[f"{quantity}[{name}]"]
        mean = abs((channel.statistics or {"mean": float(channel.values[window].mean())})["mean"])
        shown = RIPPLE * mean < sizes[name] < 10.0 * mean
        text += f", {number(sizes[name] / mean, 3)} times its mean" if shown else ""
    return text


def _contact(found: Mapping[str, Channel], time: Array, window: np.ndarray) -> dict[str, str]:
    """Largest contact loss, and the flank in work of every mesh."""
    states = {owner(c): c for c in found.values() if c.quantity == "contact_state"}
    if not states or window.sum() < 2:
        return {}
    shares = {}
    for name, channel in states.items():
        counted = channel.contact
        values = channel.values[window]
        shares[name] = (
            contact_statistics(time[window], values).loss_share
            if counted is None
            else counted["contact_loss_share"]
        )
    most = max(shares, key=lambda key: shares[key])
    loss = f"{100.0 * shares[most]:.3g} %" + (f", {escape(most)}" if len(shares) > 1 and shares[most] else "")
    flanks: dict[str, list[str]] = {}
    for name, channel in states.items():
        flanks.setdefault(working_flank(channel.values[window]), []).append(name)
    words = [
        f"{escape(', '.join(names))}: {flank}" if len(states) > 1 and len(flanks) > 1 else flank
        for flank, names in flanks.items()
    ]
    return {"maximum contact loss": loss, "flank in work": "<br>".join(words)}


def _sweeps(sweeps: Mapping[str, Mapping[str, Any]], states: Mapping[str, str]) -> str:
    """Table of sweeps: peak of the swept mesh; jumps; largest force and contact loss of all meshes."""
    body = []
    for name, sweep in sweeps.items():
        points = sweep.get("points", ())
        found = mesh_sweeps(points)
        speeds = {float(p["mesh_frequency"]): float(p["speed"]) for p in points if p.get("speed") is not None}
        several = len({one.mesh for one in found}) > 1
        for direction in dict.fromkeys(one.direction for one in found):
            own = [one for one in found if one.direction == direction]
            forces = [one for one in own if np.isfinite(one.force)]
            losses = [one for one in own if np.isfinite(one.loss)]
            force = max(forces, key=lambda one: abs(one.force), default=None)
            loss = max(losses, key=lambda one: one.loss, default=None)
            cells = [
                escape(direction),
                escape(states.get(name, "")),
                _peak("deflection", "m", own[0].rms, own[0].rms_at, speeds) + _of(own[0], several),
                _peak("mesh_force", "N", force.force, force.force_at, speeds) + _of(force, several)
                if force
                else "–",
                escape(jump_words(own)),
                _range([100.0 * loss.least_loss, 100.0 * loss.loss], "%")
                + _of(loss, several and loss.loss > 0.0)
                if loss
                else "–",
            ]
            body.append(f'<tr><th scope="row">{escape(name)}</th>{_cells(cells)}</tr>')
    head = ("speed sweep", "direction", "status", "peak of deflection, rms", "peak of mesh force")
    return plain_table((*head, "jumps at", "contact loss"), body, numbers=False) if body else ""


def _of(one: MeshSweep, named: bool) -> str:
    """Name of the mesh of a result, if there are several."""
    return f", {escape(one.mesh)}" if named else ""


def _peak(quantity: str, unit: str, peak: float, at: float, speeds: Mapping[float, float]) -> str:
    """Largest value along a sweep with its mesh frequency and speed."""
    if not np.isfinite(peak):
        return "–"
    speed = f", {amount(speeds[at], 'rad/s')}" if at in speeds else ""
    return f"{channel_scale(quantity, unit, np.array([peak])).text(peak)} at {amount(at, 'Hz')}{speed}"


def _range(values: Sequence[float], unit: str) -> str:
    low, high = (number(v, 4) for v in (min(values), max(values)))
    return (f"{low} {unit}" if low == high else f"{low} to {high} {unit}").rstrip()


def _cases(tables: Mapping[str, Any], states: Mapping[str, str]) -> str:
    """Table of case tables: number of cases, varied values, ranges of the main results."""
    body = []
    for name, table in tables.items():
        if not table.cases:
            continue
        fine = [case for case in table.cases if case["status"] == OK]
        varied = dict.fromkeys(path for case in table.cases for path in case["values"])
        ranges = []
        for quantity in case_quantities(fine):
            values = quantity.largest[np.isfinite(quantity.largest)] * quantity.scale.factor
            ranges.append(f"{escape(quantity.title)}: {_range(values.tolist(), quantity.scale.unit)}")
        cells = [
            escape(states.get(name, "")),
            f"{len(fine)} of {len(table.cases)} finished",
            escape(", ".join(short_path(path, list(varied)) for path in varied)),
            "<br>".join(ranges[:MAX_ENDS]),
        ]
        body.append(f'<tr><th scope="row">{escape(name)}</th>{_cells(cells)}</tr>')
    head = ("cases", "status", "number", "varied", "range of results")
    return plain_table(head, body, numbers=False) if body else ""


def _unstable(modes: Mapping[str, Any]) -> list[str]:
    """Listed modes with negative damping, in words, by loaded state."""
    lines = []
    for of, own in modes.items():
        sources = own.sources or [""] * len(own.names)
        rows = list(zip(own.names, own.frequency, own.damping_ratio, sources, strict=True))[:MAX_MODES]
        rows = [row for row in rows if row[2] < -ROUND_OFF and row[1] > 0.0]
        if not rows:
            continue
        found = [
            f"{name} ({amount(frequency, 'Hz')}, damping ratio {number(100.0 * ratio, 2)} %"
            + (f", driven by {source})" if source else ")")
            for name, frequency, ratio, source in rows
        ]
        words = f"{'' if own.undamped else 'Unstable '}about the loaded state{f' of {of}' * (len(modes) > 1)}"
        listed = ", ".join(found[:MAX_ENDS])
        if own.undamped:
            least = number(-100.0 * min(ratio for _, _, ratio, _ in rows), 2)
            words = f"The model has no damping, so that modes grow {words}"
            listed += f". Damping ratios above {least} % make them stable"
        lines.append(f"{words}: {listed}.")
    return lines


def _critical(diagrams: Mapping[str, Any]) -> list[str]:
    """Critical speeds within the operating range, else the nearest one, in words, per Campbell diagram."""
    found = []
    for name, data in diagrams.items():
        if isinstance(data, str) or "crossing_separation" not in data or not data["frequency"].size:
            continue
        ranked = ranked_speeds(data)
        known = [ranked[k] for k in named_speeds(ranked)]
        of = f" of {name}" if len(diagrams) > 1 else ""
        if not known:
            found.append(f"No critical speed{of} with a response above {LARGE:g} in the Campbell diagram.")
            continue
        body = f" of {data.attrs['body']}" if data.attrs.get("body") else ""
        if known[0].separation == 0.0:
            words = "; ".join(f"{amount(c.speed, 'rad/s')} ({_resonance(c)})" for c in known)
            more = sum(c.separation == 0.0 and c.response >= LARGE for c in ranked) - len(known)
            words += f"; {more} more in the Campbell diagram" if more > 0 else ""
            place = range_words(data.attrs["operating_speed"])
            found.append(f"Critical speeds{of} within the operating {place}{body}: {words}.")
            continue
        place = range_words(data.attrs["operating_speed"])
        if len(known) > 1:
            words = "; ".join(f"{amount(c.speed, 'rad/s')}, {_apart(c)} ({_resonance(c)})" for c in known)
            found.append(f"Critical speeds{of} close to the operating {place}{body}: {words}.")
        else:
            near = f"{amount(known[0].speed, 'rad/s')}{body}, {_apart(known[0])} the operating {place}"
            found.append(f"Nearest critical speed{of}: {near} ({_resonance(known[0])}).")
    return found


def _apart(critical: RankedSpeed) -> str:
    """Distance from the operating range, in words."""
    side = "above" if critical.separation > 0.0 else "below"
    return f"{number(abs(100.0 * critical.separation), 2)} % {side}"


def _resonance(critical: RankedSpeed) -> str:
    """Order, mode and response of a critical speed."""
    return f"{critical.order}, {critical.mode}, response {number(critical.response, 3)}"
