# SPDX-License-Identifier: Apache-2.0
"""Constraint rows: consistent initial conditions, free directions, notes."""
