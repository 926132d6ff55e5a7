# SPDX-License-Identifier: Apache-2.0
"""Parts of a model as components of REXS."""
