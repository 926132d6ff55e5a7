# SPDX-License-Identifier: Apache-2.0
"""Parts of beams: record, forces at large rotations, exact tangents."""
