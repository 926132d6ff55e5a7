# SPDX-License-Identifier: Apache-2.0
"""Tables of `pitchpoint check`, one module per topic."""
