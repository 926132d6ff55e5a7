# SPDX-License-Identifier: Apache-2.0
"""Suggestions for misspelled names: keys, components, channels, commands and options."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

LISTED = 12
"""Maximum number of names in a hint."""
_SIMILAR = 0.6
"""Minimum similarity of a suggestion, from 0 to 1. At 0.5, `m9` suggests `m2` and `tacho` suggests `acc`."""
_PART = 4
"""Minimum number of letters for suggestions of names that contain the name as written."""


def nearest(name: object, names: Iterable[str], count: int = 1) -> list[str]:
    """Names of similar spelling, or that contain the name, ignoring case, blanks, hyphens and underscores.

    Parameters
    ----------
    name
        Name as written.
    names
        Existing names.
    count
        Maximum number of suggestions.

    Examples
    --------
    >>> nearest("profil-shift", ["tip_diameter", "profile_shift"])
    ['profile_shift']
    >>> nearest("modul", ["tip_diameter", "normal_module"])
    ['normal_module']
    >>> nearest(20, ["VG 20", "VG 220"])
    ['VG 20']
    """
    from difflib import get_close_matches

    known, written = {_plain(each): each for each in names}, _plain(name)
    close = get_close_matches(written, list(known), count, _SIMILAR)
    if not close and written.isdecimal():  # 220 of ISO VG 220, not 20 of it
        close = [k for k in known if k.endswith(written) and not k.removesuffix(written)[-1:].isdecimal()]
        close = close[:count]
    elif not close and len(written) >= _PART:
        close = [each for each in known if written in each][:count]
    return [known[found] for found in close]


def did_you_mean(name: object, names: Iterable[str], count: int = 1) -> str:
    """Question with the nearest names and a trailing blank; '' if no name is similar.

    Parameters
    ----------
    name
        Name as written.
    names
        Existing names.
    count
        Maximum number of suggestions.

    Examples
    --------
    >>> did_you_mean("wheell", ["pinion", "wheel"])
    'did you mean wheel? '
    """
    near = nearest(name, names, count)
    return f"did you mean {' or '.join(near)}? " if near else ""


def similar_file(folder: Path, name: str, suffixes: Iterable[str] = ()) -> str:
    """Question with the file whose name is nearest, in the folder of a missing file; '' if none is similar.

    Parameters
    ----------
    folder, name
        Folder, and name of the missing file relative to it.
    suffixes
        Endings of the files in question; default: that of the missing file.
    """
    wanted = Path(name)
    endings = tuple(suffixes) or (wanted.suffix.lower(),)
    try:
        files = [each.name for each in (folder / wanted).parent.iterdir() if each.is_file()]
    except (OSError, ValueError):
        return ""
    near = nearest(wanted.name, sorted(each for each in files if Path(each).suffix.lower() in endings))
    return f"did you mean {wanted.with_name(near[0]).as_posix()}? " if near else ""


def hint(name: object, names: Iterable[str], count: int = 1) -> str:
    """Nearest names and list of existing names; with many names only the nearest.

    Parameters
    ----------
    name
        Name as written.
    names
        Existing names.
    count
        Maximum number of suggestions.

    Examples
    --------
    >>> hint("wheell", ["pinion", "wheel"]), hint("sun", ["pinion", "wheel"]), hint("sun", [])
    ('did you mean wheel? there are pinion, wheel', 'there are pinion, wheel', 'there are none')
    """
    known = list(names)
    guess = did_you_mean(name, known, count)
    if guess and len(known) > LISTED:
        return guess.strip()
    more = ", ..." if len(known) > LISTED else ""
    return f"{guess}there are {', '.join(known[:LISTED]) or 'none'}{more}"


def _plain(name: object) -> str:
    return "".join(c for c in str(name).lower() if c not in " -_")
