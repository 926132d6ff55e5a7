# SPDX-License-Identifier: Apache-2.0
"""Input of `pitchpoint contact`: mesh, torques, misalignment and operating conditions from its options."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import one_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

mesh_option = click.option("--mesh", "-m", metavar="NAME", help="Mesh; default: the only one with contact.")
"""Option of all commands of one mesh."""
torques_option = click.option(
    "--torque",
    "-t",
    "torques",
    multiple=True,
    metavar="QUANTITY",
    help="Torque on gear 1, repeatable; or a range FIRST:LAST:COUNT, such as '50 N m:400 N m:8'. "
    "Default: from the constant torques of the loads, through the gear ratios if they are on other bodies.",
)
"""Option of all commands for several torques."""
flank_option = click.option(
    "--flank",
    type=click.Choice(["front", "back"]),
    help="Flanks in contact; default: by the sign of the default torque, else front.",
)
"""Option of all commands of one flank."""
misalignment_help = (
    "Gap between the flanks in the plane of action, increasing towards +z: length over the common face "
    "width, or angle; default: misalignment of the mesh."
)
"""Help of the misalignment of the flanks."""
MOST = 500
"""Maximum number of torques."""


@contextmanager
def refused_input() -> Iterator[None]:
    """Input that an analysis refuses, without a result, is wrong input of the command."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import INCONSISTENT

    try:
        yield
    except SolverError as error:
        if error.status != INCONSISTENT or error.partial is not None:
            raise
        raise click.UsageError(str(error).removeprefix("relief design: ")) from None


def mesh_with_contact(model: Model, name: str | None, levels: tuple[str, ...] = ()) -> str:
    """Name of the mesh: the given one, or the only one with contact, of any or some levels."""
    contacts = {key: mesh.contact for key, mesh in model.meshes.items()}
    touching = [k for k, own in contacts.items() if own is not None and (not levels or own.level in levels)]
    kind = f"contact of level {' or '.join(levels)}" if levels else "contact of tooth surfaces"
    needed = f"give the mesh one, such as `contact: {{level: {levels[0] if levels else 'rigid'}}}`"
    if name is None and len(touching) == 1:
        return touching[0]
    if name is None and not touching:
        raise click.UsageError(f"no mesh has a {kind}; {needed}")
    chosen = one_of(name, touching if name is None else list(model.meshes), "mesh")
    if chosen not in touching:
        own = contacts[chosen]
        has = "a stiffness law" if own is None else f"a contact of level {own.level}"
        raise click.BadParameter(f"{chosen} has {has}; {needed}", param_hint="--mesh")
    return chosen


def meshes_on_shafts(model: Model, options: dict[str, Any]) -> tuple[str, ...]:
    """Meshes to analyse on their shafts: the given ones, or all that can be analysed."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.solvers.contact_analysis.mesh_choice import chosen_meshes

    try:
        found = chosen_meshes(model, options["meshes"] or None)
    except SolverError as error:
        raise click.UsageError(str(error)) from None
    if len(found) > 1 and options["speed"] is not None:
        raise click.UsageError(
            f"--speed is that of gear 1 of one mesh, and there are {len(found)}; choose one with --mesh"
        )
    return found


def refuse_fixed(model: Model, options: dict[str, Any]) -> None:
    """Reject options of fixed axes for shafts in equilibrium, and unknown scenarios."""
    from pitchpoint.cli.results import known_scenario, refuse_without_effect

    given = {f"--{name}": options[name] for name in ("misalignment", "flank")}
    refuse_without_effect("with --shafts", {"--torque": options["torques"] or None, **given})
    if options["scenario"] is not None:
        known_scenario(model, options["scenario"])


def loads_of(model: Model, mesh: str, texts: tuple[str, ...], side: str | None) -> tuple[list[float], int]:
    """Torques [N m] and flank, 1 or -1."""
    if texts:
        torques = [value for text in texts for value in torques_of(text)]
        if len(torques) > MOST:
            raise click.BadParameter(f"{len(torques)} torques (limit {MOST})", param_hint="--torque")
        return torques, side_of(side)
    found = torque_of_loads(model, mesh)
    return [abs(found)], side_of(side, 1 if found > 0.0 else -1)


def side_of(side: str | None, default: int = 1) -> int:
    """Flank, 1 or -1, of the text of `--flank`."""
    return {"front": 1, "back": -1, None: default}[side]


def torques_of(text: str) -> list[float]:
    """Torques of one option [N m]: a quantity, or a range with first, last and count.

    Examples
    --------
    >>> torques_of("0.2 kN m"), torques_of("50 N m:200:4")
    ([200.0], [50.0, 100.0, 150.0, 200.0])
    """
    parts = [part.strip() for part in text.split(":")]
    if len(parts) == 1:
        return [_quantity(text, "torque", "--torque")]
    if len(parts) != 3 or not parts[2].isdigit() or int(parts[2]) < 2:
        raise click.BadParameter(
            f"{text!r} is not a range FIRST:LAST:COUNT with a count of 2 or more, such as '50 N m:400 N m:8'",
            param_hint="--torque",
        )
    first, last = (_quantity(part, "torque", "--torque") for part in parts[:2])
    count = int(parts[2])
    if count > MOST:
        raise click.BadParameter(f"{count} torques (limit {MOST})", param_hint="--torque")
    return [first + (last - first) * k / (count - 1) for k in range(count)]


def _quantity(text: str, dimension: str, option: str) -> float:
    """Positive SI value of the text of an option; a number without unit is in SI."""
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import parse_quantity

    try:
        value: str | float = float(text)
    except ValueError:
        value = text
    try:
        return parse_quantity(value, dimension, positive=True)
    except UnitError as error:
        raise click.BadParameter(str(error), param_hint=option) from None


def torque_of_loads(model: Model, mesh: str) -> float:
    """Torque on gear 1 [N m] from constant torques of the loads on its body, or on the rest of its train."""
    from pitchpoint.core.errors import CompileError, SolverError
    from pitchpoint.model.components.law import Constant
    from pitchpoint.solvers.contact_analysis.torque_balance import torque_of_train

    body = model.body_of(model.meshes[mesh].gears[0])
    on_body = [name for name, one in model.every_mesh.items() if body in map(model.body_of, one.gears)]
    laws = [load.torque for load in model.loads.values() if load.body == body and load.torque is not None]
    values = [law.value for law in laws if isinstance(law, Constant)]
    if on_body == [mesh] and values and len(values) == len(laws) and sum(values) != 0.0:
        return sum(values)
    try:
        return torque_of_train(model, mesh)
    except (SolverError, CompileError) as error:
        raise click.UsageError(
            f"the loads do not give the torque on gear 1 of {mesh} ({model.meshes[mesh].gears[0]}): {error}; "
            "give --torque, such as --torque '200 N m'"
        ) from None


def misalignment_of(text: str, model: Model, mesh: str) -> float:
    """Misalignment in the plane of action [rad] from a length over the common face width, or an angle."""
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import format_quantity, parse_quantity
    from pitchpoint.model.components.mesh import STEEPEST

    hint = "--misalignment"
    try:
        float(text)
    except ValueError:
        pass
    else:
        raise click.BadParameter(f"{text} has no unit; write '{text} um' or '{text} deg'", param_hint=hint)
    try:
        angle = parse_quantity(text, "length") / model.pairs[mesh].b_w
    except UnitError:
        try:
            angle = parse_quantity(text, "angle")
        except UnitError:
            raise click.BadParameter(
                f"{text!r} is neither a length nor an angle; write '20 um' or '0.05 deg'", param_hint=hint
            ) from None
    if abs(angle) > STEEPEST:
        width = format_quantity(STEEPEST * model.pairs[mesh].b_w, "length", 4)
        raise click.BadParameter(
            f"{text} is too large (limit {format_quantity(STEEPEST, 'angle', 4)}, {width} over the common "
            "face width); write '20 um' or '0.05 deg'",
            param_hint=hint,
        )
    return angle


def operation_of(model: Model, mesh: str, options: dict[str, Any]) -> dict[str, Any]:
    """Operating conditions: of the options, otherwise those of mesh, lubricant and load case."""
    from pitchpoint.model.load_cases import oil_of

    own = model.meshes[mesh].friction
    found = {n: options[n] for n in ("friction", "speed", "viscosity", "pressure_viscosity")}
    if found["friction"] is None and own is not None:
        found["friction"] = own.mu
    if found["speed"] is None:
        found["speed"] = speed_of_load_case(model, mesh)
    oil = oil_of(model)
    if oil is not None and found["speed"] is not None and found["viscosity"] is None:
        found["viscosity"] = oil.dynamic_viscosity
        found["pressure_viscosity"] = options["pressure_viscosity"] or oil.pressure_coefficient
    for name in ("viscosity", "pressure_viscosity"):
        needed = "speed" if name == "viscosity" else "viscosity"
        if options[name] is not None and found[needed] is None:
            raise click.UsageError(f"--{name.replace('_', '-')} requires --{needed}")
    return {name: value for name, value in found.items() if value is not None}


def speed_of_load_case(model: Model, mesh: str) -> float | None:
    """Speed of gear 1 in the load case in effect [rad/s]; None without one, or at rest."""
    from pitchpoint.model.load_cases import speeds_in_effect
    from pitchpoint.model.scenario import Scenario

    speeds = speeds_in_effect(model)
    body = model.body_of(model.meshes[mesh].gears[0])
    if not speeds or body is None:
        return None
    return model.start_speeds(Scenario(speed=speeds))[body] or None
