# SPDX-License-Identifier: Apache-2.0
"""Many cases of one system: plan, run, store."""
