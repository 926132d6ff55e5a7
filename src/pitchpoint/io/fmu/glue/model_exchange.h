/* SPDX-License-Identifier: Apache-2.0
   Model exchange: the derivative of the state for the integrator of the importing program. The states are the
   coordinates and their rates; spins are not wrapped. */
#ifndef PP_MODEL_EXCHANGE_H
#define PP_MODEL_EXCHANGE_H
#include "instance.h"

/* whether a function is available in the phases from `first` to `last` */
static int is_called_in(Instance *f, int first, int last, Str otherwise) {
  int right = f->c.phase >= first && f->c.phase <= last;
  if (!f->c.exchange) fail(f, "this instance is for co-simulation, and this function for model exchange");
  else if (!right) fail(f, otherwise);
  return f->c.exchange && right;
}
static Status enter_events(Instance *f) {
  if (!is_called_in(f, RUNNING, CONTINUOUS, "the event mode follows the initialisation or the continuous-time mode")) return fError;
  f->c.phase = RUNNING;
  return fOK;
}
static Status update_events(Instance *f) {
  return is_called_in(f, RUNNING, RUNNING, "discrete states are updated in the event mode") ? fOK : fError;
}
static Status enter_continuous(Instance *f) {
  if (!is_called_in(f, RUNNING, RUNNING, "the continuous-time mode follows the event mode")) return fError;
  f->c.phase = CONTINUOUS;
  return fOK;
}
static Status complete_step(Instance *f) {
  return is_called_in(f, CONTINUOUS, CONTINUOUS, "integrator steps are completed in the continuous-time mode") ? fOK : fError;
}
static const char early[] = "states, derivatives and event indicators are known from the begin of the initialisation on";
static int fits(Instance *f, size_t n, i64 needed) {
  if ((i64)n != needed) fail(f, "the number of states or indicators is not that of the model description");
  return (i64)n == needed;
}
static Status set_time(Instance *f, double t) {
  if (!is_called_in(f, RUNNING, CONTINUOUS, "the time is set after the initialisation and before the termination")) return fError;
  if (!finite_number(t)) return fail(f, "the time is not finite");
  if (t != now(f)) f->c.stale = JUMPED;
  f->c.t0 = t;
  f->c.steps = 0;
  return fOK;
}
static Status set_states(Instance *f, const double *x, size_t n) {
  i64 nd = pp_numbers.nd;
  if (!is_called_in(f, CONTINUOUS, CONTINUOUS, "states are set in the continuous-time mode")) return fError;
  if (!fits(f, n, 2 * nd)) return fError;
  if (!all_finite(x, 2 * nd)) return fail(f, "a state is not finite");
  memcpy(reals(f, pp_numbers.q), x, 8 * (size_t)nd);
  memcpy(reals(f, pp_numbers.v), x + nd, 8 * (size_t)nd);
  f->c.stale = JUMPED;
  return fOK;
}
static Status get_states(Instance *f, double *x, size_t n) {
  i64 nd = pp_numbers.nd;
  if (!is_called_in(f, INITIALISING, TERMINATED, early)) return fError;
  if (!fits(f, n, 2 * nd)) return fError;
  memcpy(x, reals(f, pp_numbers.q), 8 * (size_t)nd);
  memcpy(x + nd, reals(f, pp_numbers.v), 8 * (size_t)nd);
  return fOK;
}
/* accelerations at the present state; channels are observed on demand */
static Status accelerate(Instance *f) {
  i64 s = f->c.stale == JUMPED ? request(f, ACCELERATE, 0) : OK;
  if (s == OK && !all_finite(reals(f, pp_numbers.a), pp_numbers.nd)) s = NOT_FINITE;
  if (s != OK) return stop(f, "the accelerations cannot be evaluated", s, "check states, inputs and parameters");
  if (f->c.stale == JUMPED) f->c.stale = STALE;
  return fOK;
}
static Status get_slopes(Instance *f, double *x, size_t n) {
  i64 nd = pp_numbers.nd;
  if (!is_called_in(f, INITIALISING, TERMINATED, early)) return fError;
  if (!fits(f, n, 2 * nd)) return fError;
  f->c.failed = 0; /* the importing program may reject a trial state */
  Status s = accelerate(f);
  if (s != fOK) return fDiscard;
  memcpy(x, reals(f, pp_numbers.v), 8 * (size_t)nd);
  memcpy(x + nd, reals(f, pp_numbers.a), 8 * (size_t)nd);
  return fOK;
}
static Status get_indicators(Instance *f, double *x, size_t n) {
  if (!is_called_in(f, INITIALISING, TERMINATED, early)) return fError;
  if (!fits(f, n, pp_numbers.n_indicators)) return fError;
  if (!n) return fOK;
  i64 s = request(f, EVENTS, address(f->m + pp_numbers.ev1));
  if (s != OK) return fDiscard;
  for (size_t k = 0; k < n; k++) x[k] = reals(f, pp_numbers.ev1)[pp_indicators[k]];
  return fOK;
}
static Status get_nominals(Instance *f, double *x, size_t n) {
  if (!fits(f, n, 2 * pp_numbers.nd)) return fError;
  for (size_t k = 0; k < n; k++) x[k] = 1.0;
  return fOK;
}
/* ------------------------------------------------------------------------------- directional derivatives */

/* largest change of a variable for central differences: small against elastic deflections and its range, large
   against round-off */
static double change_of(Instance *f, VR vr, double seed) {
  const Variable *v = pp_variables + vr;
  double value = v->kind == STATE ? 0.0 : f->values[vr], size = seed < 0 ? -seed : seed;
  if (v->kind == STATE) return (v->first < pp_numbers.nd ? 1e-8 : 1e-4) / size;
  double change = 1e-6 * (1.0 + (value < 0 ? -value : value)), part = 0.25 * (v->most - v->least);
  return (part < change ? part : change) / size;
}
/* largest share of a seed that keeps a variable in its range */
static double room_of(Instance *f, VR vr, double seed) {
  const Variable *v = pp_variables + vr;
  if (v->kind == STATE || seed == 0.0) return 1e300;
  return seed > 0 ? (v->most - f->values[vr]) / seed : (f->values[vr] - v->least) / -seed;
}
static Status add(Instance *f, const VR *by, size_t n, const double *seed, double share) {
  for (size_t k = 0; k < n; k++) {
    const Variable *v = pp_variables + by[k];
    double change = share * seed[k];
    if (v->kind == STATE) {
      *state_at(f, v->first) += change;
      f->c.stale = JUMPED;
    } else {
      double value = f->values[by[k]] + change; /* round-off at a limit: */
      if (value > v->most) value = v->most;
      if (value < v->least) value = v->least;
      if (set_numbers(f, by + k, 1, &value) != fOK) return fError;
    }
  }
  return fOK;
}
/* change of the unknowns with the knowns by central differences, one-sided at a limit; knowns at limits on both
   sides separately; the state and the values are restored */
static Status directional(Instance *f, const VR *of, size_t n_of, const VR *by, size_t n_by, const double *seed, double *change) {
  double share = 1e300;
  if (!f->c.exchange) return fail(f, "directional derivatives are for instances of model exchange");
  for (size_t k = 0; k < n_by; k++) {
    i64 kind = by[k] < pp_numbers.n_variables ? pp_variables[by[k]].kind : OUTPUT;
    if (kind == OUTPUT || kind == SLOPE || kind == TIME || kind == INDICATOR)
      return fail(f, "a known is neither a state nor an input or parameter");
    if (!finite_number(seed[k])) return fail(f, "a seed is not finite");
    if (seed[k] != 0.0 && change_of(f, by[k], seed[k]) < share) share = change_of(f, by[k], seed[k]);
  }
  for (size_t k = 0; k < n_of; k++) change[k] = 0.0;
  if (share == 1e300 || !n_of) return fOK;
  double up = share, down = share;
  for (size_t k = 0; k < n_by; k++) {
    double above = room_of(f, by[k], seed[k]), below = room_of(f, by[k], -seed[k]);
    if (above < up) up = above;
    if (below < down) down = below;
  }
  double *low = allocate(&f->on, 8 * n_of);
  if (n_by > 1 && up < share && down < share) {
    Status one = low ? fOK : fail(f, "no memory for directional derivatives");
    for (size_t k = 0; one == fOK && k < n_by; k++) {
      one = directional(f, of, n_of, by + k, 1, seed + k, low);
      for (size_t i = 0; one == fOK && i < n_of; i++) change[i] += low[i];
    }
    if (low) release(&f->on, low);
    return one;
  }
  if (up < share) up = 0.0;
  else if (down < share) down = 0.0;
  void *before = 0;
  Status s = low ? keep_state(f, &before) : fail(f, "no memory for directional derivatives");
  if (s == fOK) s = add(f, by, n_by, seed, -down);
  if (s == fOK) s = get_numbers(f, of, n_of, low);
  if (s == fOK) s = restore(f, before);
  if (s == fOK) s = add(f, by, n_by, seed, up);
  if (s == fOK) s = get_numbers(f, of, n_of, change);
  for (size_t k = 0; s == fOK && k < n_of; k++) change[k] = (change[k] - low[k]) / (up + down);
  if (before) restore(f, before);
  drop_state(f, &before);
  if (low) release(&f->on, low);
  return s;
}
#endif
