# SPDX-License-Identifier: Apache-2.0
"""Constraint rows: initial conditions that fit them, directions that they leave free, notes."""
