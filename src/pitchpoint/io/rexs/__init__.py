# SPDX-License-Identifier: Apache-2.0
"""REXS, the exchange format of gear unit models (FVA e.V., www.rexs.info): reading, and import as a model."""
