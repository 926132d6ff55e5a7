# SPDX-License-Identifier: Apache-2.0
"""`--set` of commands that evaluate a model: values of keys and parameters in place of those of the file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from pitchpoint.model.reading.bare_numbers import Bare

META = "pitchpoint.cli.settings"
CASE = "pitchpoint.cli.load_case"


def set_option(function: Any) -> Any:
    """Add `--set` and `--load-case` to a command; `reading.read_model` applies the values."""

    def keep(context: click.Context, _: click.Parameter, given: tuple[str, ...]) -> None:
        """Store the values for `read_model`."""
        context.meta[META] = given

    def choose(context: click.Context, _: click.Parameter, given: str | None) -> None:
        """Store the load case for `read_model`."""
        context.meta[CASE] = given

    case = click.option(
        "--load-case",
        metavar="NAME",
        callback=choose,
        expose_value=False,
        help="Load case in effect: its speeds and loads replace those of loads and scenarios.",
    )
    settings = click.option(
        "--set",
        multiple=True,
        metavar="PATH=VALUE",
        callback=keep,
        expose_value=False,
        help="Change the value of a key or parameter, such as gears.pinion.faults.chip.severity=0.5 or "
        "parameters.load='200 N m'; may be repeated.",
    )
    return settings(case(function))


def settings_of_command() -> tuple[str, ...]:
    """Values of `--set` of the running command; none outside a command."""
    context = click.get_current_context(silent=True)
    return context.meta.get(META, ()) if context is not None else ()


def load_case_of_command() -> dict[str, Any]:
    """Load case of `--load-case` of the running command, by its key."""
    context = click.get_current_context(silent=True)
    chosen = context.meta.get(CASE) if context is not None else None
    return {} if chosen is None else {"load_case": chosen}


def changes_of(settings: Sequence[str], file: str) -> dict[str, Any]:
    """Values of `--set` by path.

    Parameters
    ----------
    settings
        Arguments of `--set`.
    file
        Model file, whose names determine the end of a path if they contain an equals sign.
    """
    known = known_in(file) if any(text.count("=") > 1 for text in settings) else None
    changes: dict[str, Any] = {}
    for text in settings:
        path, sign, value = (part.strip() for part in split_at_path(text, known))
        if not sign or not path or not value:
            raise click.BadParameter(f"{text!r} is not of the form PATH=VALUE", param_hint="--set")
        if path in changes:
            raise click.BadParameter(f"{path} is set twice", param_hint="--set")
        changes[path] = scalar(value, "--set")
    return changes


def known_in(file: str) -> Callable[[str], bool]:
    """Function that recognises paths of values in a model file, which need not be valid."""
    from pitchpoint.io.yaml_model import data_of
    from pitchpoint.model.changes import leads_to

    data = data_of(file)

    def known(path: str) -> bool:
        """Whether a path, or the component of its last key, is in the file."""
        above = path.rpartition(".")[0]
        return leads_to(data, path) or ("." in above and leads_to(data, above))

    return known


def say_bare(numbers: Iterable[Bare], options: Mapping[str, str]) -> None:
    """Print remarks on numbers without unit that are rarely meant in SI; `options` by path give them."""
    from pitchpoint.cli.failure import say
    from pitchpoint.model.changes import named
    from pitchpoint.model.reading.bare_numbers import messages_on

    for message in named(messages_on(numbers), options):
        say(f"warning: {message}")


def say_bare_option(text: str, dimension: str, option: str) -> None:
    """Print a remark on the quantity of an option without unit that is rarely meant in SI."""
    from pitchpoint.cli.failure import say
    from pitchpoint.model.reading.bare_numbers import message_on_option

    message = message_on_option(text, dimension, option)
    if message is not None:
        say(f"warning: {message}")


def split_at_path(text: str, known: Callable[[str], bool] | None = None) -> tuple[str, str, str]:
    """Split `PATH=VALUE` like `str.partition`; names in the model may contain an equals sign.

    `known` is a function that recognises existing paths.
    """
    if known is not None:
        for k, letter in enumerate(text):
            if letter == "=" and known(text[:k].strip()):
                return text[:k], "=", text[k + 1 :]
    return text.partition("=")


def scalar(text: str, option: str) -> Any:
    """Read a value as in a model file: number, list, mapping or text."""
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.model.reading.yaml_tree import value_of

    try:
        return value_of(text)
    except PitchpointError as error:
        raise click.BadParameter(f"{text!r}: {error}", param_hint=option) from None
