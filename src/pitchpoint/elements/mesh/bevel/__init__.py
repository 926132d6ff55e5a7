# SPDX-License-Identifier: Apache-2.0
"""Parts specific to bevel gear meshes."""
