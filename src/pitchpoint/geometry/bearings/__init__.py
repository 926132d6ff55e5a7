# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings: load ratings, inner geometry, internal clearance, designations."""
