# SPDX-License-Identifier: Apache-2.0
"""Parts of the gear meshes: record, line of action, nodes of the flanks, sums, wrenches and tangents."""
