# SPDX-License-Identifier: Apache-2.0
"""Turbulence from a seed: spectra, coherence, boxes of velocities."""
