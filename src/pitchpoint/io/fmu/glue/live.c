/* SPDX-License-Identifier: Apache-2.0
   Functions of FMI 3.0 for a page, and the frames of the bodies for its scene. */
#include "fmi3.c"
API void *live_frames(Component c) { return ((Instance *)c)->m + pp_numbers.fr; }
