# SPDX-License-Identifier: Apache-2.0
"""Studies: factors with distributions, their samples, evaluation of all cases, statistics of the results."""
