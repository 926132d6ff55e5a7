# SPDX-License-Identifier: Apache-2.0
"""Notices on the installation, such as the compilation of kernels, each reported once."""

from __future__ import annotations

import logging
from collections.abc import Callable

_listeners: list[Callable[[str], None]] = []
_given: set[str] = set()


def listen(function: Callable[[str], None]) -> None:
    """Set the function that receives the notices; without it they are logged."""
    _listeners[:] = [function]
    _given.clear()


def notice(text: str, level: int = logging.WARNING) -> None:
    """Report a notice once.

    Parameters
    ----------
    text
        Sentence of the notice.
    level
        Level in the log.
    """
    if text in _given:
        return
    _given.add(text)
    for listener in _listeners:
        listener(text)
    if not _listeners:
        logging.getLogger("pitchpoint").log(level, text)
