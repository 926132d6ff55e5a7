# SPDX-License-Identifier: Apache-2.0
"""Controllers of wind turbines as libraries with the interface of Bladed (DISCON)."""
