# SPDX-License-Identifier: Apache-2.0
"""Explicit methods: equal steps of fourth order, Dormand-Prince with step control."""
