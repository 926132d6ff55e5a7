/* SPDX-License-Identifier: Apache-2.0
   Start of an instance whose inputs or parameters were changed in its initialisation: balancing torques and
   equilibrium as of a model file with these values (solvers.equilibrium.solve, without jumps of forces). */
#ifndef PP_EQUILIBRIUM_H
#define PP_EQUILIBRIUM_H
#include "instance.h"

enum { RESIDUAL = 1, WRAP = 5, ITERATIONS = 200 };

static double size_of(double x) { return x < 0 ? -x : x; }
/* residual in the memory of the model; with a matrix also mass M + stiffness K */
static i64 residual(Instance *f, int matrix, double mass, double stiffness) {
  Ctl *c = (Ctl *)(f->m + pp_numbers.ctl);
  c->t = now(f); c->jac = matrix; c->cm = mass; c->cd = 0; c->ck = stiffness;
  return pp_entries[1](address(c), RESIDUAL, 0);
}
/* dense matrix of the free coordinates; place: position among them or -1, by coordinate */
static void gather(Instance *f, const i64 *place, i64 n, double *A) {
  const double *blocks = reals(f, pp_numbers.A);
  for (i64 k = 0; k < n * n; k++) A[k] = 0.0;
  for (i64 k = 0; k < pp_numbers.n_entries; k++) {
    i64 i = place[pp_entries_of_matrix[3 * k]], j = place[pp_entries_of_matrix[3 * k + 1]];
    if (i >= 0 && j >= 0) A[i * n + j] = blocks[pp_entries_of_matrix[3 * k + 2]];
  }
}
/* factors of A with row exchanges in `order`; 0 if a pivot vanishes */
static int factorise(double *A, i64 n, i64 *order) {
  for (i64 k = 0; k < n; k++) {
    i64 best = k;
    for (i64 i = k + 1; i < n; i++) if (size_of(A[i * n + k]) > size_of(A[best * n + k])) best = i;
    order[k] = best;
    if (!(size_of(A[best * n + k]) > 1e-300)) return 0;
    for (i64 j = 0; j < n && best != k; j++) { double x = A[k * n + j]; A[k * n + j] = A[best * n + j]; A[best * n + j] = x; }
    for (i64 i = k + 1; i < n; i++) {
      double part = A[i * n + k] /= A[k * n + k];
      for (i64 j = k + 1; j < n; j++) A[i * n + j] -= part * A[k * n + j];
    }
  }
  return 1;
}
static void solve(const double *A, i64 n, const i64 *order, double *x) {
  for (i64 k = 0; k < n; k++) {
    double y = x[order[k]]; x[order[k]] = x[k]; x[k] = y;
  }
  for (i64 i = 1; i < n; i++) for (i64 j = 0; j < i; j++) x[i] -= A[i * n + j] * x[j];
  for (i64 i = n; i-- > 0;) {
    for (i64 j = i + 1; j < n; j++) x[i] -= A[i * n + j] * x[j];
    x[i] /= A[i * n + i];
  }
}
/* square of the length of a step, in the mass norm */
static double length_of(const double *x, const double *mass, i64 n) {
  double sum = 0.0;
  for (i64 k = 0; k < n; k++) sum += mass[k] * x[k] * x[k];
  return sum;
}
/* whether a broken tooth leaves no pair in contact: the next one penetrates too far (equilibrium.failure) */
static int in_gap(Instance *f) {
  if (request(f, OBSERVE, address(f->row)) != OK) return 1;
  for (i64 k = 0; k < pp_numbers.n_gaps; k++) if (size_of(f->row[pp_gaps[k]]) > pp_depths[k]) return 1;
  return 0;
}
/* equilibrium of the free coordinates by pseudo-transient continuation; 0 if there is none */
static int settle(Instance *f, const u32 *free, i64 n) {
  i64 nd = pp_numbers.nd, found = 0;
  char *room = allocate(&f->on, (size_t)(8 * (2 * n * n + 5 * n + 2 * nd + n)));
  if (!room) return 0;
  double *A = (double *)room, *B = A + n * n, *step = B + n * n, *next = step + n, *mass = next + n, *before = mass + n;
  double *wanted = before + n, *last = wanted + n;
  i64 *place = (i64 *)(last + nd), *order = place + nd;
  double *q = reals(f, pp_numbers.q), *R = reals(f, pp_numbers.R), loads = 0.0, mu = 1e4;
  const double *weight = reals(f, pp_numbers.weight); /* residuals are compared as forces: torques over this length */
  for (i64 k = 0; k < nd; k++) { place[k] = -1; last[k] = q[k]; q[k] = 0.0; reals(f, pp_numbers.a)[k] = 0.0; }
  for (i64 k = 0; k < n; k++) place[free[k]] = k;
  i64 s = residual(f, 0, 0.0, 0.0); /* loads of the undeflected machine */
  for (i64 k = 0; k < nd; k++) if (size_of(R[k]) / weight[k] > loads) loads = size_of(R[k]) / weight[k];
  for (i64 k = 0; k < nd; k++) q[k] = last[k];
  if (s == OK) s = residual(f, 1, 1.0, 0.0);
  gather(f, place, n, A);
  for (i64 k = 0; k < n; k++) mass[k] = A[k * n + k];
  int fresh = 1;
  for (i64 count = 0; s == OK && count < ITERATIONS && mu < 1e20; count++) {
    if (fresh) {
      s = residual(f, 1, 0.0, 1.0);
      if (s != OK) break;
      gather(f, place, n, A);
      found = 1;
      for (i64 i = 0; i < n; i++) { /* the force error of rounded positions limits the residual */
        double rounded = 0.0;
        for (i64 j = 0; j < n; j++) rounded += size_of(A[i * n + j]) * (size_of(q[free[j]]) + pp_extents[free[j]]);
        double least = 1e-12 * loads * weight[free[i]];
        wanted[i] = 1.8e-15 * rounded > least ? 1.8e-15 * rounded : least;
        next[i] = R[free[i]];
        if (!(size_of(next[i]) <= wanted[i])) found = 0;
      }
      if (found) break;
      s = residual(f, 1, 1.0, 0.0);
      if (s != OK) break;
      for (i64 k = 0; k < n * n; k++) B[k] = A[k];
      gather(f, place, n, A);
      for (i64 k = 0; k < n * n; k++) { double x = A[k]; A[k] = B[k]; B[k] = x; } /* A: stiffness, B: mass */
      for (i64 k = 0; k < n; k++) { before[k] = q[free[k]]; }
    }
    double *C = allocate(&f->on, (size_t)(8 * n * n));
    if (!C) break;
    for (i64 k = 0; k < n * n; k++) C[k] = A[k] + mu * B[k];
    int regular = factorise(C, n, order);
    double ratio = 1.0;
    for (i64 k = 0; k < n; k++) step[k] = -next[k];
    if (regular) {
      solve(C, n, order, step);
      for (i64 k = 0; k < n; k++) q[free[k]] = before[k] + step[k];
      i64 trial = residual(f, 0, 0.0, 0.0);
      double *after = wanted;
      for (i64 k = 0; k < n; k++) after[k] = R[free[k]];
      regular = trial == OK && all_finite(after, n);
      if (regular) {
        double along = 0.0, greatest = 0.0; /* along > 0: the forces oppose the step, which went too far */
        for (i64 k = 0; k < n; k++) {
          along += after[k] * step[k];
          if (size_of(after[k]) / weight[free[k]] > greatest) greatest = size_of(after[k]) / weight[free[k]];
        }
        solve(C, n, order, after);
        ratio = length_of(after, mass, n) / length_of(step, mass, n); /* of squares */
        regular = ratio < 0.81 || (ratio <= (greatest <= loads ? 4.0 : 1.02) && !(along > 0.0));
      }
    }
    release(&f->on, C);
    fresh = regular;
    mu *= regular ? (ratio < 0.25 ? 0.1 : 0.5) : 8.0;
    if (regular && mu < 1e-3) mu = 1e-3;
    if (!regular) for (i64 k = 0; k < n; k++) q[free[k]] = before[k];
  }
  if (found && pp_numbers.n_gaps) {
    found = !in_gap(f);
    residual(f, 0, 0.0, 0.0);
  }
  if (!found) for (i64 k = 0; k < nd; k++) q[k] = last[k];
  release(&f->on, room);
  return (int)found;
}
/* torques of the balancing loads, which are inputs, as means over the instants of a mesh cycle; those without an
   equilibrium, such as at a missing tooth, are skipped and counted */
static int balance(Instance *f, i64 *skipped) {
  i64 nd = pp_numbers.nd, n = pp_numbers.n_balancing;
  double *q = reals(f, pp_numbers.q), *v = reals(f, pp_numbers.v), *R = reals(f, pp_numbers.R);
  double *at = allocate(&f->on, (size_t)(8 * (nd + n))), counted = 0.0;
  double *sum = at + nd;
  int done = at && settle(f, pp_free_balancing, pp_numbers.n_free_balancing);
  for (i64 k = 0; done && k < nd; k++) at[k] = q[k];
  for (i64 i = 0; done && i < pp_numbers.n_instants; i++) {
    double t = pp_instants[2 * i], weight = pp_instants[2 * i + 1];
    if (!(weight > 0.0)) continue;
    for (i64 k = 0; k < nd; k++) q[k] = at[k];
    for (i64 k = 0; k < pp_numbers.n_spins; k++) q[pp_spins[k]] += t * v[pp_spins[k]];
    if (t != 0.0 && !settle(f, pp_free_balancing, pp_numbers.n_free_balancing)) { ++*skipped; continue; }
    counted += weight;
    for (i64 k = 0; k < n; k++) sum[k] += weight * R[pp_balancing[2 * k]];
  }
  for (i64 k = 0; done && k < nd; k++) q[k] = at[k];
  if (done && !(counted > 0.0)) { /* no other instant */
    done = residual(f, 0, 0.0, 0.0) == OK;
    for (i64 k = 0; k < n; k++) sum[k] = R[pp_balancing[2 * k]];
    counted = 1.0;
  }
  for (i64 k = 0; done && k < n; k++) {
    i64 variable = pp_balancing[2 * k + 1];
    f->values[variable] += sum[k] / counted;
    put(f, variable);
  }
  if (at) release(&f->on, at);
  return done;
}
static Status enter(Instance *f) {
  if (f->c.phase != INSTANTIATED) return fail(f, "the initialisation has begun before; reset the instance");
  f->c.phase = INITIALISING;
  return fOK;
}
static Status terminate(Instance *f) {
  if (f->c.phase != RUNNING && f->c.phase != CONTINUOUS) return fail(f, "only an initialised instance can be terminated, and once");
  f->c.phase = TERMINATED;
  return fOK;
}
/* initial state for the values set in the initialisation; from now on states are no longer set */
static Status end_start(Instance *f) {
  if (f->c.phase != INITIALISING) return fail(f, "the initialisation has not begun, or has ended before");
  Status s = fOK;
  if (f->c.begun == VALUES_SET && pp_numbers.n_free) {
    i64 skipped = 0;
    int own = 1; /* balancing torques that were not set */
    for (i64 k = 0; k < pp_numbers.n_balancing; k++) {
      i64 variable = pp_balancing[2 * k + 1];
      if (f->values[variable] != pp_variables[variable].start) own = 0;
    }
    int found = !(pp_numbers.n_balancing && own) || balance(f, &skipped);
    if (!found || !settle(f, pp_free, pp_numbers.n_free)) {
      s = fWarning;
      say(f, s, "no equilibrium was found for these inputs and parameters: the run starts in the state of the model description");
    } else if (skipped) {
      s = fWarning;
      say(f, s, "the balancing torques are means without the instants that have no equilibrium, such as those at a missing tooth");
    }
    Ctl *c = (Ctl *)(f->m + pp_numbers.ctl);
    pp_entries[1](address(c), WRAP, 0);
    f->c.stale = JUMPED;
  }
  Status t = refresh(f);
  if (t != fOK) return t;
  f->c.begun = BEGUN;
  f->c.phase = RUNNING;
  return s;
}
#endif
