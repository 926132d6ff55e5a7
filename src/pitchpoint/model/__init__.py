# SPDX-License-Identifier: Apache-2.0
"""Model description: components, scenarios and their validation. No numerics."""
