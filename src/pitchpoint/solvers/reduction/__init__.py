# SPDX-License-Identifier: Apache-2.0
"""Reduced systems: what is condensed, how, and how far off the result is."""
