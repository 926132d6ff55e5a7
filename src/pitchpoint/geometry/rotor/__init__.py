# SPDX-License-Identifier: Apache-2.0
"""Rotors of wind turbines and propellers: polars, blades, position of the blade stations."""
