# SPDX-License-Identifier: Apache-2.0
"""The study of the shovel gearbox as one page, from tooth geometry to a broken tooth detected in noise.

Run it with `python story.py [OUT.html]`; it computes everything anew, in some minutes, and writes a page
that needs nothing else.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path

import story_sections as parts
from diagnosis import CHANNEL, Pair, Readings, curves, pair_of, readings
from levels import LAWS, Level
from levels import run as run_law
from story_diagnosis import detection, noise
from study import Run, healthy_and_faulty, simulate, without_friction

from pitchpoint import __version__
from pitchpoint.analysis.detection import DetectionCurves
from pitchpoint.viz.quantities import number
from pitchpoint.viz.report.page import Section, page
from pitchpoint.viz.tables import plain_table

TITLE = "From teeth to a broken tooth: the crawler gearbox of a mining shovel"
SOURCE = "“Nonlinear Contact Analysis of Gear Teeth for Malfunction Diagnostics” (the paper)"


@dataclass(frozen=True)
class Story:
    """Everything that the page shows.

    Attributes
    ----------
    healthy, faulty, frictionless, run_up, elastic
        Runs; `elastic` may be missing.
    laws, law_seconds
        What the three laws give, and how long they were run [s].
    pair
        Bearing force, healthy and faulty, as the paper sampled it.
    readings
        Periods read from a5 at each ratio of signal to noise.
    curves
        Rates of detection.
    """

    healthy: Run
    faulty: Run
    frictionless: Run
    run_up: Run
    elastic: Run | None
    laws: Mapping[str, Level]
    law_seconds: float
    pair: Pair
    readings: tuple[Readings, ...]
    curves: DetectionCurves


def tell(
    *, law_seconds: float = 15.0, seeds: int = 20, healthy_seeds: int = 100, elastic: bool = True
) -> Story:
    """Compute everything.

    Parameters
    ----------
    law_seconds
        Length of the run of each law [s].
    seeds, healthy_seeds
        Noisy signals from which periods are read, and those for false alarms and rates of detection.
    elastic
        Whether the gearbox on elastic shafts runs, too.
    """
    simulate("warm-up", record=0.1, settle=0.1)  # compiling is not part of the run times
    healthy, faulty = healthy_and_faulty()
    pair = pair_of(healthy, faulty)
    return Story(
        healthy=healthy,
        faulty=faulty,
        frictionless=without_friction(),
        run_up=simulate("run-up", scenario="run_up", record=15.0, settle=0.0),
        elastic=simulate("elastic", "model.yaml", record=2.0) if elastic else None,
        laws={law: run_law(law, law_seconds) for law in LAWS},
        law_seconds=law_seconds,
        pair=pair,
        readings=tuple(readings(pair, r, seeds=seeds, healthy_seeds=healthy_seeds) for r in (0.0, -5.0)),
        curves=curves(pair, seeds=healthy_seeds),
    )


def origin(story: Story) -> Section:
    """Runs with hashes, solvers and real-time factors."""
    section = Section("origin", "9 Where the numbers come from")
    runs = (story.healthy, story.faulty, story.frictionless, story.run_up, story.elastic)
    rows = []
    for run in runs:
        if run is None:
            continue
        attrs = run.data.attrs
        where = f"scenarios.{run.scenario}."
        changes = [f"{path.removeprefix(where)} = {value}" for path, value in run.changes.items()]
        if len(changes) > 3:
            changes = [*changes[:3], f"{len(changes) - 3} more like it"]
        options = [f"{key} {number(value, 4)}" for key, value in json.loads(attrs["options"]).items()]
        cells = (
            run.label,
            f"{run.file}: {run.scenario}",
            ", ".join(changes),
            attrs["model_hash"],
            " ".join((attrs["solver"], *options)),
            str(attrs["steps"]),
            f"{float(run.data.time[-1]):g} s",
            f"{number(run.processor_s, 3)} s",
            number(run.real_time_factor, 3),
        )
        rows.append(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in cells)}</tr>")
    head = (
        "run",
        "scenario",
        "changes",
        "model hash",
        "solver, SI",
        "steps",
        "simulated",
        "processor",
        "real time ×",
    )
    section.add(plain_table(head, rows, numbers=False))
    attrs = story.healthy.data.attrs
    section.add(
        f"<p>pitchpoint {escape(attrs['pitchpoint_version'])}, Python {attrs['python']}, NumPy "
        f"{attrs['numpy']}; one core. Every table above names in its last column the run, the channel and "
        "the function a number comes from. The hashes are those of the models with the changes listed; "
        "<code>pitchpoint run FILE --set PATH=VALUE</code> computes any of these runs again.</p>"
        f"<p>Numbers of others: {escape(SOURCE)}. Its figures were not at hand, only its text.</p>"
    )
    return section


def html(story: Story) -> str:
    """The page."""
    sections = [
        parts.gearbox(),
        parts.contact(),
        parts.laws(story.laws, story.law_seconds),
        parts.forces(story.healthy, story.frictionless, story.run_up),
        parts.supports(story.healthy, story.elastic),
        parts.fault(story.healthy, story.faulty, CHANNEL),
        noise(story.pair, story.readings),
        detection(story.curves, story.readings),
        origin(story),
    ]
    facts = (
        ("version", __version__),
        ("model", story.healthy.data.attrs["model_hash"]),
        ("bearing force", CHANNEL),
    )
    return page(TITLE, facts, sections, f"Made by pitchpoint {__version__}.")


if __name__ == "__main__":
    target = Path(sys.argv[1] if len(sys.argv) > 1 else "story.html")
    target.write_text(html(tell()), encoding="utf-8")
    print(f"written to {target}")
