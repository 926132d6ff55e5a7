# SPDX-License-Identifier: Apache-2.0
"""Contents of a report that need no result: numbers of the model, power flow, drawing, sources."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.viz.report.build import ReportModel
from pitchpoint.viz.report.gearbox import GearboxData

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

SOURCES = (
    "Geometry: ISO 21771:2007.",
    "Mesh stiffness: DIN 3990-1:1987 and ISO 6336-1:2006, method B.",
    "Stiffness over the mesh cycle: L. Mauer, SIMPACK User Meeting 2006.",
)
MAX_FLOWS = 3
"""Largest number of power flows at constant speed with tables in a report."""
BEVEL_SOURCES = ("Bevel gears: ISO 23509:2016; virtual cylindrical gears: ISO 10300-1:2014.",)


def describe(model: Model) -> ReportModel:
    """Collector of the contents of a report on a model."""
    from pitchpoint.core.provenance import content_hash, package_version
    from pitchpoint.model.signals import signal_lines
    from pitchpoint.report.assumptions import assumptions_of
    from pitchpoint.report.flanks import flank_lines, inactive_faults
    from pitchpoint.report.numbers import geometry_of_model
    from pitchpoint.report.overview import counts_of
    from pitchpoint.report.parameters import parameter_lines

    numbers = geometry_of_model(model)
    bodies = {name: model.body_of(mesh.gears[0]) for name, mesh in model.every_mesh.items()}
    return ReportModel(
        title=model.title or "Gears",
        model_hash=content_hash(model),
        version=package_version(),
        gears=numbers["gears"],
        meshes=numbers["meshes"],
        bevels=(numbers["bevel_gears"], numbers["bevel_meshes"]),
        flanks=flank_lines(model),
        inactive_faults=inactive_faults(model),
        pairs={name: (pair, *model.meshes[name].gears) for name, pair in model.pairs.items()},
        shafts={mesh: body for mesh, body in bodies.items() if body},
        counts=counts_of(model),
        signals=signal_lines(model),
        parameters=parameter_lines(model),
        assumptions=assumptions_of(model),
        sources=_sources(model),
        gearbox=_gearbox(model),
    )


def _gearbox(model: Model) -> GearboxData:
    """Drawing in section and power flow at constant speed."""
    from pitchpoint.report.machine_tables import machine_tables
    from pitchpoint.report.power_tables import flow_texts, further_flows
    from pitchpoint.report.section.build import gearbox_drawing
    from pitchpoint.report.static_power import static_powers

    flows = static_powers(model)
    texts = [flow for flow in flow_texts(flows) if flow.tables]
    drawing = gearbox_drawing(model, flows) or ""
    tables = [*further_flows(texts[MAX_FLOWS:]), *machine_tables(model)]
    return GearboxData(drawing=drawing, flows=texts[:MAX_FLOWS], tables=tables)


def _sources(model: Model) -> tuple[str, ...]:
    """Standards and papers used for a model."""
    of_gears = SOURCES[:1] if model.gears else ()
    of_meshes = SOURCES[1:] if model.every_mesh else ()
    return (*of_gears, *(BEVEL_SOURCES if model.bevel_gears else ()), *of_meshes)
