# SPDX-License-Identifier: Apache-2.0
"""Progress of long computations on stderr: a bar on terminals, else a line every few seconds.

Computations of less than two seconds show no progress.
"""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Any, Self

import click

from pitchpoint.core.progress import listening

PATIENCE = 2.0
LINE_EVERY = 3.0
BAR_EVERY = 0.1
COMPLETE = 0.9995
"""Share above which the computation counts as complete: a last short step is not shown."""


def duration_text(seconds: float) -> str:
    """Duration in words.

    Examples
    --------
    >>> duration_text(8.2), duration_text(125), duration_text(7300)
    ('8 s', '2 min 05 s', '2 h 01 min')
    """
    whole = max(round(seconds), 0)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"


class ProgressDisplay:
    """Progress display, called as `display(done, total, note)`.

    Parameters
    ----------
    title
        Name of the computation.
    unit
        Unit of `done` and `total` in words, for the rate ("s", "points").
    quiet
        Disable the display.
    """

    def __init__(self, title: str, unit: str = "", *, quiet: bool = False) -> None:
        self.title = title
        self.unit = unit
        self.quiet = quiet
        self._terminal = sys.stderr.isatty()
        self._start = time.monotonic()
        self._last = self._start
        self._first: tuple[float, float] | None = None
        self._bar: Any = None
        self._task: Any = None
        self.lines = 0
        self._left_out: tuple[float, float, str] | None = None
        self._done: tuple[float, float | None] = (0.0, None)
        self._heard: Any = None

    def __call__(self, done: float, total: float, note: str = "") -> None:
        """Update the progress; drawn at most ten times per second."""
        now = time.monotonic()
        if self._first is None:
            # Compilation precedes the first report; it would distort the estimate.
            self._first = (now, done)
        if self.quiet or now - self._start < PATIENCE:
            return
        if now - self._last < (BAR_EVERY if self._terminal else LINE_EVERY) and self.lines:
            self._left_out = (done, total, note)
            return
        self._show(now, done, total, note)

    def aside(self, words: str) -> None:
        """Show a step before or between the parts of the computation, without a known share."""
        now = time.monotonic()
        waited = now - self._last >= (BAR_EVERY if self._terminal else LINE_EVERY) or not self.lines
        if self.quiet or now - self._start < PATIENCE or not waited:
            return
        self._last = now
        self.lines += 1
        if self._terminal:
            self._draw(*self._done, "", float("inf"), words)
        else:
            click.echo(f"{self.title}: {words}", err=True)

    def _show(self, now: float, done: float, total: float, note: str) -> None:
        """Draw the bar, or print a line."""
        self._last, self._left_out, self._done = now, None, (done, total)
        self.lines += 1
        since, before = self._first or (now, done)
        rate = (done - before) / (now - since) if now > since else 0.0
        remaining = (total - done) / rate if rate > 0.0 else float("inf")
        if self._terminal:
            self._draw(done, total, self._rate_text(rate), remaining, note)
        else:
            share = 100.0 * done / total if total > 0.0 else 0.0
            parts = [f"{self.title}: {share:.0f} %", self._rate_text(rate)]
            if 0.0 < remaining < float("inf"):
                parts.append(f"{duration_text(remaining)} left")
            click.echo(", ".join([p for p in parts if p] + ([note] if note else [])), err=True)

    def _rate_text(self, rate: float) -> str:
        return f"{rate:.3g} {self.unit}/s" if self.unit and rate > 0.0 else ""

    def _draw(self, done: float, total: float | None, rate: str, remaining: float, note: str) -> None:
        if self._bar is None:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

            console = Console(stderr=True)
            self._bar = Progress(
                TextColumn("{task.description}"),
                BarColumn(),
                TaskProgressColumn(),
                TextColumn("{task.fields[rate]}"),
                TextColumn("{task.fields[remaining]}"),
                TextColumn("{task.fields[note]}"),
                console=console,
                auto_refresh=False,
                transient=True,
                disable=not console.is_interactive,  # as with TTY_INTERACTIVE=0, for pages of documentation
            )
            self._task = self._bar.add_task(self.title, total=total, rate="", remaining="", note="")
            self._bar.start()
        left = f"{duration_text(remaining)} left" if 0.0 < remaining < float("inf") else ""
        self._bar.update(self._task, completed=done, total=total, rate=rate, remaining=left, note=note)
        self._bar.refresh()

    def __enter__(self) -> Self:
        self._heard = listening(self.aside)
        self._heard.__enter__()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._heard.__exit__(kind, error, trace)
        if self._left_out is not None and self.lines:
            done, total, note = self._left_out
            if done >= total * COMPLETE:  # always show the end
                self._show(time.monotonic(), total, total, note)
        if self._bar is not None:
            self._bar.stop()
