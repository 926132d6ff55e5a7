# SPDX-License-Identifier: Apache-2.0
"""Common parts of the contacts of curves and surfaces: record, contact points, wrenches."""
