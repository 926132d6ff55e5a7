# SPDX-License-Identifier: Apache-2.0
"""Errors of wind files, and sizes that are checked before memory is taken."""

from __future__ import annotations

import math
from pathlib import Path

from pitchpoint.core.errors import Message, PitchpointError

LARGEST = 8 << 30
"""Maximum memory of the velocities of a file [bytes]."""


class WindFileError(PitchpointError, ValueError):
    """Wind file that cannot be read or written; the message gives place, value, limit and remedy."""


def refused(
    path: Path, where: str, value: str, message: str, limit: str | None = None, remedy: str | None = None
) -> WindFileError:
    """Error with its parts.

    Parameters
    ----------
    path, where
        File, and place in it.
    value, message, limit, remedy
        As for `Message`.
    """
    place = f"{path}: {where}" if where else str(path)
    return WindFileError(str(Message(place, message, value or None, limit, remedy)))


def size_of(path: Path) -> int:
    """Size of a regular file [bytes].

    Raises
    ------
    WindFileError
        If there is no such file, or it may not be read.
    """
    try:
        if not path.is_file():
            raise refused(path, "", "", "is not a file", None, "check the name")
        return path.stat().st_size
    except (OSError, ValueError) as error:
        raise unreadable(path, error) from error


def unreadable(path: Path, error: Exception) -> WindFileError:
    """Error for a file that the operating system does not give.

    Parameters
    ----------
    path
        The file.
    error
        Reason.
    """
    return refused(path, "", "", f"cannot be read ({error})", None, "check the file and its permissions")


def check_size(path: Path, there: int, expected: int, remedy: str) -> None:
    """Compare the size of a file with the size that follows from its numbers of points.

    Parameters
    ----------
    path
        The file.
    there, expected
        Sizes [bytes].
    remedy
        Corrective action.

    Raises
    ------
    WindFileError
        If they differ.
    """
    if there < expected:
        raise refused(path, f"byte {there}", f"{there} bytes", "are there: the file is cut off",
                      f"{expected} bytes", remedy)  # fmt: skip
    if there > expected:
        text = "are there, more than the numbers of points require"
        raise refused(path, f"byte {expected}", f"{there} bytes", text, f"{expected} bytes", remedy)


def check_memory(path: Path, samples: int) -> None:
    """Refuse a box that is too large.

    Parameters
    ----------
    path
        The file.
    samples
        Number of velocities, all components.

    Raises
    ------
    WindFileError
        If it needs more than `LARGEST`.
    """
    if 4 * samples > LARGEST:
        value, limit = (f"{n / 2**30:.1f} GiB" for n in (4 * samples, LARGEST))
        raise refused(path, "", value, "are needed for the box", limit, "use fewer points or samples")


def check_finite(path: Path, **numbers: float) -> None:
    """Refuse numbers of a header that are not finite and positive.

    Parameters
    ----------
    path
        The file.
    **numbers
        Numbers by name.

    Raises
    ------
    WindFileError
        For the first such number.
    """
    for name, number in numbers.items():
        if not (math.isfinite(number) and number > 0.0):
            remedy = "the header is damaged or of another format; write the file again"
            raise refused(
                path, name.replace("_", " "), f"{number:g}", "is not a positive number", "> 0", remedy
            )
