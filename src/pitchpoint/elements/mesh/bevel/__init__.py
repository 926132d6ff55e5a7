# SPDX-License-Identifier: Apache-2.0
"""Parts of bevel meshes that cylindrical ones do not have."""
