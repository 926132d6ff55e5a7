# SPDX-License-Identifier: Apache-2.0
"""What the user describes: components, scenarios and their validation. No numerics."""
