# SPDX-License-Identifier: Apache-2.0
"""Input files of OpenFAST, read as text: AeroDyn with its blades and airfoils."""
