# SPDX-License-Identifier: Apache-2.0
"""Integer statuses of the compiled core and their messages.

A compiled entry point returns zero after an uncaught exception, so that zero means "died" and one "finished";
no kernel returns zero deliberately.
"""

from __future__ import annotations

DIED = 0
OK = 1
REFUSED = 2
SINGULAR = 3
NOT_FINITE = 4
DIVERGED = 5
SLOW = 6
INCONSISTENT = 7
STEP_UNDERFLOW = 8
INTERRUPTED = 9
BAD_CENTRE = 10
TABLE_RANGE = 11
CONTROLLER = 12
JAMMED = 13
UNBOUNDED = 14
NOT_WRITTEN = 15
OFF_SPEED = 16
OUTSIDE_BOX = 17

_SENTENCES = {
    DIED: "an element kernel stopped with an exception",
    OK: "finished",
    REFUSED: "these values describe no possible model",
    SINGULAR: "the iteration matrix is singular: some motion has neither inertia nor stiffness",
    NOT_FINITE: "a force or coordinate became infinite or not a number",
    DIVERGED: "the Newton iteration diverged",
    SLOW: "the Newton iteration converges too slowly",
    INCONSISTENT: "the constraints contradict each other",
    STEP_UNDERFLOW: "the step size fell below the resolution of the time axis",
    INTERRUPTED: "interrupted by the user; the result so far is kept",
    BAD_CENTRE: "two gears came closer than their base circles allow",
    TABLE_RANGE: "a table was evaluated outside its range",
    CONTROLLER: "a controller failed",
    JAMMED: "friction and the loads that cause it do not settle: the mechanism jams, or a controller feeds a "
    "sensed load back with too high a gain; reduce the coefficient of friction or the gain",
    UNBOUNDED: "the solution grew without bound",
    OFF_SPEED: "the mean speed left the speed of the sweep",
    OUTSIDE_BOX: "a blade left the box of turbulence; use a larger grid (pitchpoint wind --width) "
    "or a longer duration",
    NOT_WRITTEN: "the result cannot be written to the disk",
}


def sentence(status: int) -> str:
    """Message of a status.

    Examples
    --------
    >>> sentence(9)
    'interrupted by the user; the result so far is kept'
    """
    return _SENTENCES.get(int(status), f"stopped with the unknown status {int(status)}")
