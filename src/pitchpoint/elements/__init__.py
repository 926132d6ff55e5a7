# SPDX-License-Identifier: Apache-2.0
"""Force elements as records and kernels: numbers only, reached through their addresses."""
