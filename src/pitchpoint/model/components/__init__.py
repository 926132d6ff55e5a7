# SPDX-License-Identifier: Apache-2.0
"""Components of a model, one file each: frozen dataclasses whose fields hold their own documentation."""
