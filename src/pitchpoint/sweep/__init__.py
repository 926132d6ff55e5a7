# SPDX-License-Identifier: Apache-2.0
"""Parameter studies, data sets and speed sweeps."""
