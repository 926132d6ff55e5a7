# SPDX-License-Identifier: Apache-2.0
"""`--set` of commands that evaluate a model: values of keys and parameters in place of those of the file."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.reading.bare_numbers import Bare

META = "pitchpoint.cli.settings"


def set_option(function: Any) -> Any:
    """Add `--set` to a command; `reading.read_model` applies the values."""

    def keep(context: click.Context, _: click.Parameter, given: tuple[str, ...]) -> None:
        """Store the values for `read_model`."""
        context.meta[META] = given

    return click.option(
        "--set",
        multiple=True,
        metavar="PATH=VALUE",
        callback=keep,
        expose_value=False,
        help="Change the value of a key or parameter, such as gears.pinion.faults.chip.severity=0.5 or "
        "parameters.load='200 N m'; may be repeated.",
    )(function)


def settings_of_command() -> tuple[str, ...]:
    """Values of `--set` of the running command; none outside a command."""
    context = click.get_current_context(silent=True)
    return context.meta.get(META, ()) if context is not None else ()


def with_settings(model: Model, settings: Sequence[str], *, remarks: bool = True) -> Model:
    """Model with the values of `--set`.

    Parameters
    ----------
    model
        Model of the file.
    settings
        Arguments of `--set`.
    remarks
        Print a remark on numbers without unit that are rarely meant in SI.
    """
    changes: dict[str, Any] = {}
    for text in settings:
        path, sign, value = (part.strip() for part in split_at_path(text, model))
        if not sign or not path or not value:
            raise click.BadParameter(f"{text!r} is not of the form PATH=VALUE", param_hint="--set")
        if path in changes:
            raise click.BadParameter(f"{path} is set twice", param_hint="--set")
        changes[path] = scalar(value, "--set")
    if not changes:
        return model
    changed = model.replace_all(changes)
    if remarks:
        say_bare(bare for bare in changed.origin.bare if not bare.in_file)
    return changed


def say_bare(numbers: Iterable[Bare]) -> None:
    """Print remarks on numbers without unit that are rarely meant in SI."""
    from pitchpoint.cli.failure import say
    from pitchpoint.model.reading.bare_numbers import messages_on

    for message in messages_on(numbers):
        say(f"warning: {message}")


def say_bare_option(text: str, dimension: str, option: str) -> None:
    """Print a remark on the quantity of an option without unit that is rarely meant in SI."""
    from pitchpoint.cli.failure import say
    from pitchpoint.model.reading.bare_numbers import message_on_option

    message = message_on_option(text, dimension, option)
    if message is not None:
        say(f"warning: {message}")


def split_at_path(text: str, model: Model | None = None) -> tuple[str, str, str]:
    """Split `PATH=VALUE` like `str.partition`; names in the model may contain an equals sign."""
    if model is not None:
        from pitchpoint.model.numbers import has_path

        for k, letter in enumerate(text):
            if letter == "=" and has_path(model, text[:k].strip()):
                return text[:k], "=", text[k + 1 :]
    return text.partition("=")


def scalar(text: str, option: str) -> Any:
    """Read a value as in a model file: number, list, mapping or text."""
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.io.yaml_tree import value_of

    try:
        return value_of(text)
    except PitchpointError as error:
        raise click.BadParameter(f"{text!r}: {error}", param_hint=option) from None
