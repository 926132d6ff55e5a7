# SPDX-License-Identifier: Apache-2.0
"""Sentences about the installation, such as that kernels are being compiled, each reported once."""

from __future__ import annotations

import logging
from collections.abc import Callable

_listeners: list[Callable[[str], None]] = []
_given: set[str] = set()


def listen(function: Callable[[str], None]) -> None:
    """Let a function receive these sentences; without one they go to the log of the package."""
    _listeners[:] = [function]
    _given.clear()


def notice(text: str, level: int = logging.WARNING) -> None:
    """Report a sentence if it is new.

    Parameters
    ----------
    text
        The sentence.
    level
        Its level where it goes to the log.
    """
    if text in _given:
        return
    _given.add(text)
    for listener in _listeners:
        listener(text)
    if not _listeners:
        logging.getLogger("pitchpoint").log(level, text)
