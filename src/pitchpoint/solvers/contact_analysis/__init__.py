# SPDX-License-Identifier: Apache-2.0
"""Static contact analysis of tooth surfaces (loaded tooth contact analysis)."""
