# SPDX-License-Identifier: Apache-2.0
"""Contact laws: compliance, Hertzian contact, damping, friction and mesh stiffness."""
