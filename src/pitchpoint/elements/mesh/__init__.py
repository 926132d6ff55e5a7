# SPDX-License-Identifier: Apache-2.0
"""Common parts of the gear meshes: record, line of action, contact nodes, sums, wrenches and tangents."""
