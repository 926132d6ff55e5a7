# SPDX-License-Identifier: Apache-2.0
"""Flank contact of tooth surfaces in contact planes over the face width."""
