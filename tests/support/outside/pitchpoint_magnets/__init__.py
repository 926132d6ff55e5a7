# SPDX-License-Identifier: Apache-2.0
"""Magnetic couplings for pitchpoint: a package of its own, installed next to it."""
