# SPDX-License-Identifier: Apache-2.0
"""Writing of REXS files."""
