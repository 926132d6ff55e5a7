# SPDX-License-Identifier: Apache-2.0
"""Compliance of gear teeth for contact of flanks: teeth, gear bodies, coupling along the face width."""
