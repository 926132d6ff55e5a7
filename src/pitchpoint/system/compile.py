# SPDX-License-Identifier: Apache-2.0
"""From a model to a system: every rule turns one kind of component into records for the assembler."""

from __future__ import annotations

import difflib
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from pitchpoint.core.errors import CompileError, ModelError
from pitchpoint.model.force_check import states_of
from pitchpoint.model.frames import axes_of
from pitchpoint.model.signal_names import SECTIONS
from pitchpoint.system.link import prepare_kernels
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.beam import beam_bank, beam_stations
from pitchpoint.system.rules.bearing import bearing_bank, housing_seats
from pitchpoint.system.rules.bevel_mesh import bevel_bank
from pitchpoint.system.rules.bodies import bodies, body_numbers, end_of, world_place
from pitchpoint.system.rules.bushing import bushing_bank
from pitchpoint.system.rules.closure import closure_bank
from pitchpoint.system.rules.clutch import clutch_bank
from pitchpoint.system.rules.contact import cam_banks, curve_banks, surface_banks
from pitchpoint.system.rules.damping import damping_bank
from pitchpoint.system.rules.drive import drive_bank
from pitchpoint.system.rules.elastic_body import elastic_bank
from pitchpoint.system.rules.gear_mesh import mesh_bank
from pitchpoint.system.rules.gravity import gravity_bank
from pitchpoint.system.rules.guide import guide_bank
from pitchpoint.system.rules.joint_friction import friction_bank
from pitchpoint.system.rules.load import load_banks
from pitchpoint.system.rules.loose_bearing import loose_bearing_bank
from pitchpoint.system.rules.places import Places, hidden_bodies
from pitchpoint.system.rules.ratio import ratio_bank
from pitchpoint.system.rules.rolling_bearing import plain_bearing_bank, rolling_bearing_bank
from pitchpoint.system.rules.shaft import shaft_bank
from pitchpoint.system.rules.spring import (
    maxwell_bank,
    spring_bank,
    torsion_maxwell_bank,
    torsion_spring_bank,
)
from pitchpoint.system.source import with_lines
from pitchpoint.system.system import Law, System, assemble

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario


def compile_model(model: Model, scenario: Scenario | str | None = None) -> System:
    """Turn a model into flat arrays that solvers can use.

    Parameters
    ----------
    model
        A valid model with at least one body.
    scenario
        Scenario (or its name) whose prescribed motions become constraints; None leaves all bodies free.

    Returns
    -------
    System
        Frozen; `System.copy` gives each thread its own.

    Raises
    ------
    CompileError
        If the model has no bodies or no such scenario, or something of it cannot be expressed.
    ModelError
        If a file that it names, of code or numbers, is not what it should be.
    """
    try:
        return _compile(model, scenario)
    except ModelError as error:
        raise with_lines(model, error) from None


def _compile(model: Model, scenario: Scenario | str | None) -> System:
    if not model.bodies:
        raise CompileError("the model has no bodies: there is nothing that could move; add `bodies`")
    chosen = _named(model, scenario) if isinstance(scenario, str) else scenario
    tree = [*bodies(model), *housing_seats(model)]
    states: dict[str, int] = {}
    places = Places(
        end=partial(end_of, model),
        world=partial(world_place, model),
        axes=partial(axes_of, model),
        state=states.__getitem__,
    )
    beams = beam_bank(model, places, len(tree) + 1)
    tree += beam_stations(model, places)
    elements = [n for names in states_of(model).values() for n in names]
    states |= {name: k for k, name in enumerate(elements, start=len(tree) + 1)}
    followers, held = cam_banks(model.cam_contacts, places.end)
    curves, held_curves = curve_banks(model.curve_contacts, places.end)
    *surfaces, held_balls = surface_banks(model.surface_contacts, places.end)
    others = [
        bevel_bank(model),
        bearing_bank(model),
        loose_bearing_bank(model),
        shaft_bank(model, body_numbers(model)),
        elastic_bank(model, body_numbers(model)),
        *load_banks(model),
        damping_bank(model),
        gravity_bank(model),
        guide_bank(model, chosen),
        friction_bank(model, tree),
        spring_bank(model.springs, places),
        maxwell_bank(model.maxwells, places),
        torsion_spring_bank(model.torsion_springs, places),
        torsion_maxwell_bank(model.torsion_maxwells, places),
        bushing_bank(model.bushings, places),
        beams,
        clutch_bank(model.clutches, places),
        rolling_bearing_bank(model.rolling_bearings, places),
        plain_bearing_bank(model.plain_bearings, places),
        followers,
        curves,
        *surfaces,
    ]
    constraints = [closure_bank(model), ratio_bank(model), held, held_curves, held_balls]
    if chosen is not None:
        constraints.append(drive_bank(model, chosen))
    used = {b.kind for b in (*others, *constraints) if b.records.size}
    trees = any(not body.is_round for body in tree)
    prepare_kernels(used | {"gear_mesh"} if model.meshes else used, trees)
    banks = [mesh_bank(model), *others]
    everybody = [*tree, *hidden_bodies(elements)]
    if any(getattr(model, section) for section in SECTIONS):
        # only machines with signals wait for what these need
        from pitchpoint.system.rules.signals import net_of_model
        from pitchpoint.system.signals import assemble_controlled

        net, controllers = net_of_model(model, everybody, places)
        prepare_kernels({net.kind}, trees)
        assembled = partial(assemble_controlled, net, controllers=controllers)
    else:
        assembled = partial(assemble, everybody)
    system = assembled(
        {b.kind: b.records for b in banks if b.records.size},
        {b.kind: b.records for b in constraints if b.records.size},
        names={b.kind: b.names for b in (*banks, *constraints)},
        pools={b.kind: b.pool for b in (*banks, *constraints) if b.pool is not None and b.records.size},
        laws=_laws([*banks, *constraints]),
    )
    return replace(system, model=model, scenario=chosen)


def _named(model: Model, scenario: str) -> Scenario:
    """Scenario of this name, or an error with the nearest spelling."""
    if scenario not in model.scenarios:
        near = difflib.get_close_matches(scenario, model.scenarios, 1, 0.6)
        guess = f"did you mean {near[0]}? " if near else ""
        listed = ", ".join(model.scenarios) or "none"
        raise CompileError(f"scenario: there is no {scenario!r}; {guess}there are: {listed}")
    return model.scenarios[scenario]


def _laws(banks: list[Bank]) -> dict[str, tuple[Law | None, ...]]:
    """User laws of the kinds that have any."""
    return {b.kind: b.laws for b in banks if b.laws is not None and any(law is not None for law in b.laws)}
