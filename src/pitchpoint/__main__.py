# SPDX-License-Identifier: Apache-2.0
"""`python -m pitchpoint` is `pitchpoint`."""

from pitchpoint.cli.main import main

main()
