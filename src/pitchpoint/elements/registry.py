# SPDX-License-Identifier: Apache-2.0
"""Registry of element kinds: lookup by module name or by package entry point.

A kind is imported only when a model uses it. The kinds of this package are the constants ``KIND`` of the
modules of `pitchpoint.elements`. Other packages add kinds by an entry point of the same name in the group
``pitchpoint.kinds``, or by calling `register`. The traits of a kind are documented in `elements.kind.Kind`.
"""

from __future__ import annotations

import importlib
import importlib.util
import pkgutil
from collections.abc import Iterable

from pitchpoint.core.errors import CompileError
from pitchpoint.core.plugins import plugin_objects
from pitchpoint.elements.kind import CONSTRAINT, COORDINATE, FRAME, FRICTION, MOTION, Kind

_KINDS: dict[str, Kind] = {}


def register(kind: Kind) -> None:
    """Register a kind at run time; a name that is already in use is refused."""
    known = _KINDS.get(kind.name)
    if known is not None and known.module != kind.module:
        raise CompileError(f"the kind {kind.name!r} is already registered ({known.module})")
    if kind.channel not in (FRAME, COORDINATE, CONSTRAINT, MOTION, FRICTION):
        raise CompileError(f"the kind {kind.name!r} has an unknown channel: {kind.channel!r}")
    _KINDS.setdefault(kind.name, kind)


def find(name: str) -> Kind:
    """Kind of a given name: registered, of this package, or of an entry point of another package."""
    if name not in _KINDS:
        found = _of_this_package(name) or _of_others(name)
        if found is None:
            raise CompileError(f"{name!r} is not an element kind; known: {', '.join(names())}")
        register(found)
    return _KINDS[name]


def names(others: bool = False) -> tuple[str, ...]:
    """Sorted names of all kinds of this package and of all registered kinds.

    Parameters
    ----------
    others
        Also search all installed packages.
    """
    for kind in plugin_objects(Kind) if others else ():
        register(kind)
    package = importlib.import_module("pitchpoint.elements")
    for module in pkgutil.iter_modules(package.__path__):
        found = None if module.name in _KINDS else _of_this_package(module.name)
        if found is not None:
            register(found)
    return tuple(sorted(_KINDS))


def of_role(kinds: Iterable[str], role: str) -> list[str]:
    """Sorted names of the kinds that have a given role."""
    return [name for name in sorted(kinds) if find(name).role == role]


def _of_this_package(name: str) -> Kind | None:
    if not name.isidentifier() or importlib.util.find_spec(f"pitchpoint.elements.{name}") is None:
        return None
    kind = getattr(importlib.import_module(f"pitchpoint.elements.{name}"), "KIND", None)
    return kind if isinstance(kind, Kind) and kind.name == name else None


def _of_others(name: str) -> Kind | None:
    return next((kind for kind in plugin_objects(Kind, name) if kind.name == name), None)
