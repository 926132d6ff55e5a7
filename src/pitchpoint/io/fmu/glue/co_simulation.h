/* SPDX-License-Identifier: Apache-2.0
   Co-simulation: communication steps with the compiled loop of the exported run. */
#ifndef PP_CO_SIMULATION_H
#define PP_CO_SIMULATION_H
#include "instance.h"

/* n time steps; the channels of the last one are observed while its forces are summed, as in a run with rows */
static i64 advance(Instance *f, i64 n, i64 observed) {
  i64 done[3] = {0, 0, 0};
  Recorder r = {observed, 1, address(f->line), observed, pp_numbers.no + 1, 0, 0, 0, 0, 0, 0, address(done), 0, 0};
  *reals(f, pp_numbers.order_t0) = f->c.t0;
  *reals(f, pp_numbers.order_h) = f->c.h;
  *integers(f, pp_numbers.order_first) = f->c.steps;
  *integers(f, pp_numbers.order_n) = n;
  i64 s = pp_entries[0](address(f->m + pp_numbers.ctl), address(f->m + pp_numbers.order), address(&r));
  f->c.steps += done[0];
  if (s != OK || !observed) return s;
  for (i64 k = 0; k < pp_numbers.no; k++) f->row[k] = f->line[k + 1];
  return all_finite(f->row, pp_numbers.no) ? OK : NOT_FINITE;
}
/* time step h from now on */
static void change_step(Instance *f, double h) {
  double t = now(f);
  if (pp_numbers.implicit) rescale(f, h / f->c.h);
  else reals(f, pp_numbers.real)[pp_numbers.past] = 0.0;
  f->c.t0 = t;
  f->c.steps = 0;
  f->c.h = h;
}
static Status do_step(Instance *f, double t, double size) {
  double at = now(f), off = t - at, room = 1e-6 * f->c.h + 1e-12 * (at < 0 ? -at : at);
  if (f->c.exchange) return fail(f, "this instance is for model exchange");
  if (f->c.phase == TERMINATED) return fail(f, "the run is terminated; reset the instance");
  if (f->c.phase != RUNNING) return fail(f, "the initialisation has not ended; a communication step comes after it");
  if (f->c.failed) return fail(f, "the run has failed before; reset the instance or restore a state");
  if (!(size > 0.0 && size < 1e300)) return fail(f, "the communication step must be positive");
  if (!(off <= room && -off <= room)) return fail(f, "the communication point is not the time of the model");
  double most = size / pp_numbers.h * (1.0 - 1e-9);
  if (most > 1e15) return fail(f, "the communication step has more than 1e15 time steps");
  i64 n = (i64)most + 1;
  double h = size / n, change = h - f->c.h;
  if (change > 1e-9 * h || -change > 1e-9 * h) {
    if (pp_numbers.implicit && pp_numbers.nc)
      return fail(f, "the communication step must be a multiple of the time step: generalised-alpha with constraints keeps it");
    change_step(f, h);
  }
  lead(f, size);
  i64 s = f->c.stale == JUMPED ? restart(f) : OK;
  if (s == OK && n > 1) s = advance(f, n - 1, 0);
  if (s == OK) s = advance(f, 1, 1);
  f->c.stale = FRESH;
  return s == OK ? fOK : stop(f, "the run failed", s, "export it with a shorter time step, or check inputs and parameters");
}
#endif
