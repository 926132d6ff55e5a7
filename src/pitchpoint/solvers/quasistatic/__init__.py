# SPDX-License-Identifier: Apache-2.0
"""Slow roll through whole mesh periods."""
