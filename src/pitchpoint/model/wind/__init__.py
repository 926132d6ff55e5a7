# SPDX-License-Identifier: Apache-2.0
"""Descriptions of wind: steady wind, gusts of IEC 61400-1, turbulence, boxes of sampled velocities."""
