# SPDX-License-Identifier: Apache-2.0
"""Parts of `solvers.modal`: names, energies and planet modes, unstable modes, sparse eigenvalue problems."""
