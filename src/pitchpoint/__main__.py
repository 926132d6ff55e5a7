# SPDX-License-Identifier: Apache-2.0
"""`python -m pitchpoint` is `pitchpoint`; files of the working folder do not take the place of libraries."""

import os
import sys

_PACKAGES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
if not sys.flags.safe_path and sys.path[:1] == [os.getcwd()] and sys.path[0] != _PACKAGES:
    del sys.path[0]

from pitchpoint.cli.main import main  # noqa: E402

main()
