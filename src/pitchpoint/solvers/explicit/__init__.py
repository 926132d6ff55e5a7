# SPDX-License-Identifier: Apache-2.0
"""Explicit methods: fixed-step methods of fourth order, and Dormand-Prince methods with step control."""
