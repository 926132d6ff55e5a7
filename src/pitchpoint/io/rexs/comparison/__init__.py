# SPDX-License-Identifier: Apache-2.0
"""Comparison of two gear units of REXS files."""
