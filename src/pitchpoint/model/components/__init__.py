# SPDX-License-Identifier: Apache-2.0
"""Components of a model, one file each: a frozen dataclass whose fields describe themselves."""
