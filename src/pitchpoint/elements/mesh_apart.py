# SPDX-License-Identifier: Apache-2.0
"""Contact lines of pairs with a tooth that has grids of its own, behind an address of their own.

Most meshes have none: their kernel compiles in three quarters of the time without these.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.gear_mesh_record import RECORD
from pitchpoint.elements.mesh_pairs import pair_line
from pitchpoint.multibody.channels import CTL


@kernel
def apart(record, control, watch):
    """Sum over the contact line that begins at line[0] with the penetration line[1]; its force to line[2].

    `watch` 1: something is observed.
    """
    b = view(record, 1, RECORD)[0]
    c = view(control, 1, CTL)[0]
    line = b["line"]
    if watch == 1:
        line[2] = pair_line(b, c, 1, line[0], line[1], 1)
    else:
        line[2] = pair_line(b, c, None, line[0], line[1], 1)
    return OK
