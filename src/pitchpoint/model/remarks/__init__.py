# SPDX-License-Identifier: Apache-2.0
"""Data that are allowed but have no effect, or one that few users want."""
