# SPDX-License-Identifier: Apache-2.0
"""The state a scenario starts from: bodies, filters and integrals, clutches."""
