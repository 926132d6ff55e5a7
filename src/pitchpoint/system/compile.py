# SPDX-License-Identifier: Apache-2.0
"""Compilation of a model: the rules of its sections convert components to records for `assemble`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING

from pitchpoint.core.errors import CompileError, ModelError
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.elements import registry
from pitchpoint.elements.kind import CONSTRAINT
from pitchpoint.model.checks.forces import states_of
from pitchpoint.model.frames import axes_of
from pitchpoint.model.load_cases import in_own_load_case
from pitchpoint.model.remarks.collect import warn_of_remarks
from pitchpoint.model.sections import Section, find, groups_of
from pitchpoint.model.signals import SECTIONS as SIGNALS
from pitchpoint.system.link import prepare_kernels
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.beam import beam_stations
from pitchpoint.system.rules.bearing import housing_seats
from pitchpoint.system.rules.bodies import bodies, body_numbers, end_of, world_place
from pitchpoint.system.rules.damping import damping_bank
from pitchpoint.system.rules.drive import drive_bank
from pitchpoint.system.rules.gravity import gravity_bank
from pitchpoint.system.rules.places import Places, hidden_bodies
from pitchpoint.system.source import with_lines
from pitchpoint.system.system import Law, System, assemble

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario


def compile_model(model: Model, scenario: Scenario | str | None = None) -> System:
    """Compile a model to the flat arrays that solvers use.

    Parameters
    ----------
    model
        A valid model with at least one body.
    scenario
        Scenario (or its name) whose prescribed motions become constraints and whose load case applies; None:
        no prescribed motions.

    Returns
    -------
    System
        Frozen; use `System.copy` for each further thread.

    Raises
    ------
    CompileError
        If the model has no bodies, the scenario does not exist, or a component cannot be represented.
    ModelError
        If a referenced code or data file is invalid.
    """
    try:
        return _compile(model, scenario)
    except ModelError as error:
        raise with_lines(model, error) from None


def _compile(model: Model, scenario: Scenario | str | None) -> System:
    if not model.bodies:
        raise CompileError("the model has no bodies; add `bodies`")
    chosen = _named(model, scenario) if isinstance(scenario, str) else scenario
    if chosen is not None:
        model, chosen = in_own_load_case(model, chosen)
    numbered = bodies(model) | beam_stations(model)
    tree = [*(numbered[k] for k in sorted(numbered)), *housing_seats(model)]
    states: dict[str, int] = {}
    places = Places(
        end=partial(end_of, model),
        world=partial(world_place, model),
        axes=partial(axes_of, model),
        state=states.__getitem__,
        model=model,
        scenario=chosen,
        numbers=body_numbers(model),
        tree=tree,
    )
    elements = [n for names in states_of(model).values() for n in names]
    if model.wind_rotors:
        from pitchpoint.system.rules.wind_rotor import state_names

        elements += state_names(model)
    states |= {name: k for k, name in enumerate(elements, start=len(places.tree) + 1)}
    used = [found for name in groups_of(model) if getattr(model, name) and (found := find(name)) is not None]
    banks = [damping_bank(model), gravity_bank(model)]
    if chosen is not None:
        banks.append(drive_bank(model, chosen))
    if model.housing is not None:
        from pitchpoint.system.rules.housing import housing_bank

        banks.append(housing_bank(places))
    banks += _banks([section for section in used if not section.needs], places)
    late = [section for section in used if section.needs]
    kinds = {b.kind for b in banks if b.records.size} | {kind for section in late for kind in section.needs}
    trees = any(not body.is_round for body in places.tree)
    prepare_kernels(kinds, trees)
    warn_of_remarks(model)
    banks += _banks(late, places)
    every_body = [*places.tree, *hidden_bodies(elements)]
    if any(getattr(model, section) for section in SIGNALS):
        # imported and compiled only for models with signals
        from pitchpoint.system.rules.signals import net_of_model
        from pitchpoint.system.signals import assemble_controlled

        net, controllers = net_of_model(model, every_body, places)
        prepare_kernels({net.kind}, trees)
        assembled = partial(assemble_controlled, net, controllers=controllers)
    else:
        assembled = partial(assemble, every_body)
    banks = [b for b in banks if b.records.size]
    system = assembled(
        {b.kind: b.records for b in banks if not _is_constraint(b)},
        {b.kind: b.records for b in banks if _is_constraint(b)},
        names={b.kind: b.names for b in banks},
        pools={b.kind: b.pool for b in banks if b.pool is not None},
        laws=_laws(banks),
    )
    return replace(system, model=model, scenario=chosen)


def _banks(used: Iterable[Section], places: Places) -> list[Bank]:
    """Banks created by the rules of the given sections; rule modules are imported only if needed."""
    found: list[Bank] = []
    for rule in dict.fromkeys(rule for section in used for rule in section.rules):
        module, _, function = rule.partition(":")
        where = module if "." in module else f"pitchpoint.system.rules.{module}"
        made = getattr(import_module(where), function)(places)
        found += [made] if isinstance(made, Bank) else made
    return found


def _named(model: Model, scenario: str) -> Scenario:
    """Scenario of this name; the error message suggests the nearest spelling."""
    if scenario not in model.scenarios:
        listed = ", ".join(model.scenarios) or "none"
        guess = did_you_mean(scenario, model.scenarios)
        raise CompileError(f"scenario: there is no {scenario!r}; {guess}there are: {listed}")
    return model.scenarios[scenario]


def _is_constraint(bank: Bank) -> bool:
    return registry.find(bank.kind).channel == CONSTRAINT


def _laws(banks: list[Bank]) -> dict[str, tuple[Law | None, ...]]:
    """User laws of each kind that has any."""
    return {b.kind: b.laws for b in banks if b.laws is not None and any(law is not None for law in b.laws)}
