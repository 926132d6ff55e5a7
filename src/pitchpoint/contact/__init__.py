# SPDX-License-Identifier: Apache-2.0
"""From separation to force: compliance, Hertz, damping, friction and the shape of mesh stiffness."""
