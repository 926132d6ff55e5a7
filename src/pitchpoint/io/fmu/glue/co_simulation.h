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
/* Newton tolerance of generalised-alpha with constraints (Run.left): multipliers divide position errors by h^2 */
static void tolerate(Instance *f, double h) {
  double left = 0.25 * h * h * 2e-3, round = 4e-15, *per_q = reals(f, pp_numbers.per_q), *weight = reals(f, pp_numbers.weight);
  if (left > 1e-11) left = 1e-11;
  if (left < round * pp_numbers.far) left = round * pp_numbers.far;
  *reals(f, pp_numbers.order_tol) = left;
  for (i64 k = 0; pp_numbers.per_q && k < pp_numbers.nd; k++) per_q[k] = 1.0 / (left > round * weight[k] ? left / weight[k] : round);
}
/* rates of index 3 deviate along the rows, in proportion to the square of the step (solvers.implicit.start_values) */
static i64 shift_rates(Instance *f, double by) {
  i64 nd = pp_numbers.nd, nc = pp_numbers.nc;
  double *G = reals(f, pp_numbers.G), *g = reals(f, pp_numbers.g), *gt = reals(f, pp_numbers.gt), *x = reals(f, pp_numbers.x);
  double *v = reals(f, pp_numbers.v), *a = reals(f, pp_numbers.a), *lam = reals(f, pp_numbers.lam), *R = reals(f, pp_numbers.R);
  double *kept = allocate(&f->on, 8 * (size_t)(nd + nc));
  if (!kept) return OK; /* with larger errors of the next steps */
  for (i64 k = 0; k < nd; k++) kept[k] = a[k];
  for (i64 k = 0; k < nc; k++) kept[nd + k] = lam[k];
  i64 s = request(f, ACCELERATE, 0); /* rows and factors of the mass matrix at this state */
  for (i64 k = 0; k < nd; k++) { a[k] = kept[k]; R[k] = 0.0; }
  for (i64 k = 0; k < nc; k++) {
    lam[k] = kept[nd + k];
    g[k] = gt[k];
    for (i64 i = 0; i < nd; i++) g[k] += G[k * nd + i] * v[i];
    g[k] *= 1.0 - by * by;
  }
  if (s == OK) s = request(f, SOLVE, 0);
  if (s == OK && all_finite(x, nd)) for (i64 k = 0; k < nd; k++) v[k] += x[k];
  release(&f->on, kept);
  return s;
}
/* time step h from now on */
static i64 change_step(Instance *f, double h) {
  double t = now(f);
  i64 s = OK;
  if (pp_numbers.implicit && pp_numbers.nc) tolerate(f, h);
  if (pp_numbers.implicit && pp_numbers.nc && !pp_numbers.per_q && f->c.stale != JUMPED) s = shift_rates(f, h / f->c.h);
  if (pp_numbers.implicit) rescale(f, h / f->c.h);
  else reals(f, pp_numbers.real)[pp_numbers.past] = 0.0;
  f->c.t0 = t;
  f->c.steps = 0;
  f->c.h = h;
  return s;
}
static Status do_step(Instance *f, double t, double size) {
  double at = now(f), off = t - at, room = 1e-6 * f->c.h + 1e-12 * (at < 0 ? -at : at);
  if (f->c.exchange) return fail(f, "this instance is for model exchange");
  if (f->c.phase == TERMINATED) return fail(f, "the run is terminated; reset the instance");
  if (f->c.phase != RUNNING) return fail(f, "the initialisation has not ended; a communication step comes after it");
  if (f->c.failed) return fail(f, "the run has failed before; reset the instance or restore a state");
  if (!(size > 0.0 && size < 1e300)) return fail(f, "the communication step must be positive");
  if (!(off <= room && -off <= room)) return fail_with(f, "the communication point ", t, " s is not the time of the model, ", at, " s");
  double most = size / pp_numbers.h * (1.0 - 1e-9);
  if (most > 1e15) return fail(f, "the communication step has more than 1e15 time steps");
  i64 n = (i64)most + 1;
  double h = size / n, change = h - f->c.h;
  i64 s = change > 1e-9 * h || -change > 1e-9 * h ? change_step(f, h) : OK;
  lead(f, size);
  if (s == OK && f->c.stale == JUMPED) s = restart(f);
  if (s == OK && n > 1) s = advance(f, n - 1, 0);
  if (s == OK) s = advance(f, 1, 1);
  f->c.stale = FRESH;
  return s == OK ? fOK : stop(f, "the run failed", s, "export it with a shorter time step, or check inputs and parameters");
}
#endif
