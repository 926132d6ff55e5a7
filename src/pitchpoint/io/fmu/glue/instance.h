/* SPDX-License-Identifier: Apache-2.0
   Instance of an exported model, common to FMI 2.0 and 3.0.

   The model is the data pp_*, which the exporter writes: an image of the memory of a started run, the places in
   it that hold addresses, and the compiled entry points. An instance is a relocated copy of the image; a state
   is such a copy with offsets in place of addresses. There is no writable data outside of the instances.
   No headers and no library but calloc, free, memcpy and mathematics. */
#ifndef PP_INSTANCE_H
#define PP_INSTANCE_H

typedef unsigned long long u64;
typedef long long i64;
typedef unsigned u32;
typedef __SIZE_TYPE__ size_t;
#define API __attribute__((visibility("default")))
extern void *calloc(size_t, size_t);
extern void free(void *);
extern void *memcpy(void *, const void *, size_t);

/* ------------------------------------------------------------------------------------------------- model */

/* kind OUTPUT: channel `first`; INPUT and PARAMETER: `count` places from `first`; STATE, SLOPE, INDICATOR: index `first`;
   SPEED, ACCELERATION: place `first` is the record of a drive */
enum { OUTPUT, INPUT, PARAMETER, STATE, SLOPE, TIME, INDICATOR, SPEED, ACCELERATION };
typedef struct { i64 kind, first, count; double start, least, most; } Variable;
/* word at `offset` of the memory = base + c1 d + c2 d^2 + ... with d = value - start of the variable, c from `first`;
   if it is shared, the changes by several variables add */
typedef struct { i64 offset, first, count, shared; double base; } Place;
typedef struct {
  i64 size, n_moved, n_code, n_variables, n_indicators, n_drives;
  i64 n_entries, n_free, n_free_balancing, n_balancing, n_instants, n_spins, n_gaps;
  i64 ctl, q, v, a, lam, fr, R, A, G, g, gt, x, row, real, clock, al, ap, lp, ev1, weight, per_q, order, order_t0, order_h, order_tol, order_first, order_n;
  i64 nd, nc, no, ne, slope_at, past, valid, implicit, exchange, driven;
  double t0, h, rate, far;
} Numbers;
typedef i64 (*Entry)(i64, i64, i64);
extern const Numbers pp_numbers;
extern const char pp_token[];
extern const u64 pp_image[];
extern const u32 pp_moved[], pp_code[]; /* code: offset and number of the entry point, in turn */
extern const Entry pp_entries[];        /* 0: the loop, 1: single evaluations */
extern const Variable pp_variables[];
extern const Place pp_places[];
extern const double pp_coefficients[];
extern const u32 pp_indicators[];       /* event functions that are event indicators */
extern const char *const pp_sentences[];/* by status of the compiled code */
extern const i64 pp_n_sentences;
/* equilibrium: rows, columns and places of the matrix; free coordinates, also while the balancing bodies are held;
   spin and input of each balancing torque; times and weights of a mean; spins that advance with the time;
   size of each coordinate whose rounding error it has at least; channels of the deflections of meshes with a broken
   tooth, and their largest values in an equilibrium. far: largest distance of a body from the origin, at least 1 m */
extern const u32 pp_entries_of_matrix[], pp_free[], pp_free_balancing[], pp_balancing[], pp_spins[], pp_gaps[];
extern const double pp_instants[], pp_extents[], pp_depths[];
extern int pp_processor(void);          /* 1: the processor has the instructions of the code */

/* Head of multibody.channels.CTL, solvers.sampling.RECORDER, codes of system.requests and core.status. */
typedef struct { double t, ck, cd, cm; i64 jac; } Ctl;
typedef struct {
  i64 every, stride, rows, n_rows, columns, sums, n_sums, counts, n_counts, found, n_found, done, picked, n_picked;
} Recorder;
/* Head of elements.drive.RECORD, and its forms. */
typedef struct { i64 i, j, ii, ij, ji, jj, form, dof_i, spin_i, q_i, linear, row; double angle, speed, since, gain; } Drive;
enum { RAMP = 3, RATE = 4 };
enum { OBSERVE = 2, EVENTS = 3, ACCELERATE = 4, SOLVE = 6 };
enum { OK = 1, NOT_FINITE = 4 };

/* ---------------------------------------------------------------------------------------------- instance */

typedef void *Component;
typedef u32 VR;
typedef const char *Str;
typedef int Status;
enum { fOK, fWarning, fDiscard, fError, fFatal };
typedef void (*Logger)();
typedef struct {
  Logger logger;
  void *(*allocate)(size_t, size_t);
  void (*release)(void *);
  void *step_finished, *environment;
} Callbacks;
enum { UNCHANGED, VALUES_SET, POSITIONS_SET, BEGUN };
/* phase; part of a saved state, as in FMI. RUNNING: in model exchange the event mode */
enum { INSTANTIATED, INITIALISING, RUNNING, CONTINUOUS, TERMINATED };
/* FRESH: channels are those of the state; STALE: to be observed; JUMPED: the forces have changed, too */
enum { FRESH, STALE, JUMPED };
typedef struct { double t0, h; i64 steps, stale, failed, exchange, begun, phase; } Clock; /* begun: what the initialisation has set, or that it has ended */
typedef struct {
  Callbacks on;
  Str name;
  Clock c;
  double *values, *row, *line; /* inputs and parameters; channels; channels with the time in front */
  char *m;                     /* memory of the model */
  char text[480];              /* message */
} Instance;

static void say(Instance *f, Status s, Str text); /* by the version of FMI */

static Status fail(Instance *f, Str text) { say(f, fError, text); return fError; }
static i64 address(const void *p) { return (i64)(size_t)p; }
static double *reals(Instance *f, i64 at) { return (double *)(f->m + at); }
static i64 *integers(Instance *f, i64 at) { return (i64 *)(f->m + at); }
static double now(Instance *f) { return f->c.t0 + f->c.steps * f->c.h; }
static int same(Str a, Str b) { while (*a && *a == *b) a++, b++; return *a == *b; }
static int finite_number(double x) { return x < 1e100 && x > -1e100; }
static int all_finite(const double *x, i64 n) {
  for (i64 k = 0; k < n; k++) if (!finite_number(x[k])) return 0;
  return 1;
}
static void append(Instance *f, Str more) {
  size_t n = 0;
  while (f->text[n]) n++;
  for (; *more && n + 1 < sizeof f->text; n++, more++) f->text[n] = *more;
  f->text[n] = 0;
}
/* six digits, with an exponent if it is large or small */
static void append_number(Instance *f, double x) {
  char s[24];
  if (!finite_number(x)) { append(f, "infinite or not a number"); return; }
  int n = 0, exponent = 0, digits = 6;
  if (x < 0) { s[n++] = '-'; x = -x; }
  while (x >= 10) { x /= 10; exponent++; }
  while (x > 0 && x < 1) { x *= 10; exponent--; }
  i64 whole = (i64)(x * 1e5 + 0.5);
  if (whole >= 1000000) { whole /= 10; exponent++; }
  while (digits > 1 && whole % 10 == 0) { whole /= 10; digits--; }
  char d[8];
  for (int k = digits; k-- > 0; whole /= 10) d[k] = (char)('0' + whole % 10);
  int power = exponent < -3 || exponent > 5 ? exponent : 0, point = exponent - power; /* digits before the point, less one */
  for (int k = point < 0 ? point : 0; k < digits || k <= point; k++) {
    s[n++] = k >= 0 && k < digits ? d[k] : '0';
    if (k == point && k + 1 < digits) s[n++] = '.';
  }
  if (power) {
    s[n++] = 'e';
    if (power < 0) { s[n++] = '-'; power = -power; }
    if (power > 99) s[n++] = (char)('0' + power / 100);
    if (power > 9) s[n++] = (char)('0' + power / 10 % 10);
    s[n++] = (char)('0' + power % 10);
  }
  s[n] = 0;
  append(f, s);
}
/* sentence with two numbers; its parts stand before, between and after them */
static Status fail_with(Instance *f, Str before, double x, Str between, double y, Str after) {
  f->text[0] = 0;
  append(f, before);
  append_number(f, x);
  append(f, between);
  append_number(f, y);
  append(f, after);
  return fail(f, f->text);
}
/* the run cannot go on: what happened, why, and what to do */
static Status stop(Instance *f, Str what, i64 status, Str remedy) {
  f->c.failed = 1;
  f->text[0] = 0;
  append(f, what);
  if (status >= 0 && status < pp_n_sentences) { append(f, ": "); append(f, pp_sentences[status]); }
  append(f, "; ");
  append(f, remedy);
  return fail(f, f->text);
}

static void move(char *m, i64 by) {
  for (i64 k = 0; k < pp_numbers.n_moved; k++) *(i64 *)(m + pp_moved[k]) += by;
}
static void relocate(Instance *f, const void *image) {
  memcpy(f->m, image, (size_t)pp_numbers.size);
  move(f->m, address(f->m));
  for (i64 k = 0; k < pp_numbers.n_code; k++)
    *integers(f, pp_code[2 * k]) = address((void *)pp_entries[pp_code[2 * k + 1]]);
}
static void begin(Instance *f) {
  relocate(f, pp_image);
  for (i64 k = 0; k < pp_numbers.n_variables; k++) f->values[k] = pp_variables[k].start;
  Clock c = {pp_numbers.t0, pp_numbers.h, 0, STALE, 0, f->c.exchange, 0, INSTANTIATED};
  f->c = c;
}

/* --------------------------------------------------------------------------------- speeds of drives as inputs */

static Drive *drive_of(Instance *f, i64 k) { return (Drive *)(f->m + pp_places[pp_variables[k].first].offset); }
/* model exchange: speed and its derivative are those of the inputs at every time */
static void follow_inputs(Instance *f) {
  for (i64 k = 0; pp_numbers.n_drives && k < pp_numbers.n_variables; k++) {
    i64 kind = pp_variables[k].kind;
    if (kind != SPEED && kind != ACCELERATION) continue;
    Drive *d = drive_of(f, k);
    d->form = RATE;
    d->since = now(f);
    *(kind == SPEED ? &d->speed : &d->gain) = f->values[k];
  }
}
/* from now on angle, speed and derivative of the speed are given */
static void turn_on(Instance *f, Drive *d, double angle, double speed, double gain) {
  d->form = RAMP; d->angle = angle; d->since = now(f); d->speed = speed; d->gain = gain;
}
/* co-simulation: the speed varies linearly to its input in the next communication step (solvers.input_places.lead) */
static void lead(Instance *f, double size) {
  for (i64 k = 0; pp_numbers.n_drives && k < pp_numbers.n_variables; k++) {
    if (pp_variables[k].kind != SPEED) continue;
    Drive *d = drive_of(f, k);
    double gain = d->form == RAMP ? d->gain : 0.0, x = d->form == RAMP ? now(f) - d->since : now(f);
    double angle = d->angle + x * (d->speed + 0.5 * gain * x), speed = d->speed + gain * x, value = f->values[k];
    double change = value - speed, same = 1e-14 * ((value < 0 ? -value : value) + (speed < 0 ? -speed : speed));
    if (change <= same && -change <= same) speed = value;
    change = (value - speed) / size;
    if (change == 0.0 && gain == 0.0) continue;
    turn_on(f, d, angle, speed, change);
    f->c.stale = JUMPED;
  }
}
static i64 request(Instance *f, i64 what, i64 where) {
  if (f->c.exchange) follow_inputs(f);
  Ctl *c = (Ctl *)(f->m + pp_numbers.ctl);
  c->t = now(f); c->jac = 0; c->cm = 0; c->cd = 0;
  c->ck = what == ACCELERATE ? pp_numbers.rate : 0;
  return pp_entries[1](address(c), what, where);
}

/* A run with generalised-alpha keeps accelerations and multipliers a fraction of a step ahead and one step
   behind (Run.change_step); their distances from the present values are proportional to the step. */
static void rescale(Instance *f, double by) {
  double *a = reals(f, pp_numbers.a), *al = reals(f, pp_numbers.al), *ap = reals(f, pp_numbers.ap);
  double *lam = reals(f, pp_numbers.lam), *lp = reals(f, pp_numbers.lp);
  for (i64 k = 0; k < pp_numbers.nd; k++) {
    al[k] = a[k] + (al[k] - a[k]) * by;
    ap[k] = a[k] + (ap[k] - a[k]) * by;
  }
  for (i64 k = 0; k < pp_numbers.nc; k++) lp[k] = lam[k] + (lp[k] - lam[k]) * by;
  integers(f, pp_numbers.clock)[pp_numbers.valid] = 0;
}
/* after a jump of the forces, as solvers.sampled_control.begin_anew */
static i64 restart(Instance *f) {
  i64 s = request(f, ACCELERATE, 0);
  if (pp_numbers.implicit) rescale(f, 0.0);
  else reals(f, pp_numbers.real)[pp_numbers.slope_at] = __builtin_nan("");
  integers(f, pp_numbers.clock)[pp_numbers.valid] = 0;
  f->c.stale = STALE;
  return s;
}
/* channels at the present state */
static Status refresh(Instance *f) {
  i64 s = OK;
  if (f->c.stale == FRESH) return fOK;
  if (f->c.stale == JUMPED) s = f->c.exchange ? request(f, ACCELERATE, 0) : restart(f);
  if (s == OK) s = request(f, OBSERVE, address(f->row));
  if (s == OK && !all_finite(f->row, pp_numbers.no)) s = NOT_FINITE;
  if (s != OK) return stop(f, "the forces cannot be evaluated", s, "check inputs and parameters");
  f->c.stale = FRESH;
  return fOK;
}

/* ---------------------------------------------------------------------------- creation, values and states */

static i64 numbers_of_state(void) { return pp_numbers.n_variables + pp_numbers.no; }
static void *allocate(const Callbacks *on, size_t n) { return on->allocate ? on->allocate(n, 1) : calloc(n, 1); }
static void release(const Callbacks *on, void *p) { if (on->release) on->release(p); else free(p); }

static Instance *create(Str name, Str token, const Callbacks *on, int exchange) {
  Instance first;
  first.on = *on;
  first.name = name;
  Str wrong = !token || !same(token, pp_token) ? "the identifier in the model description is not that of this library"
            : !pp_processor() ? "this library needs a processor with AVX2 and FMA (x86-64-v3)"
            : exchange && !pp_numbers.exchange ? "this model is exported for co-simulation only" : 0;
  if (wrong) { say(&first, fError, wrong); return 0; }
  size_t length = 0;
  while (name && name[length]) length++;
  i64 head = (sizeof(Instance) + 63) / 64 * 64, numbers = 8 * (numbers_of_state() + pp_numbers.no + 1);
  char *p = allocate(on, (size_t)(head + pp_numbers.size + numbers) + length + 1);
  if (!p) { say(&first, fError, "no memory for an instance"); return 0; }
  Instance *f = (Instance *)p;
  f->on = *on;
  f->m = p + head;
  f->values = (double *)(f->m + pp_numbers.size);
  f->row = f->values + pp_numbers.n_variables;
  f->line = f->row + pp_numbers.no;
  char *copy = (char *)(f->line + pp_numbers.no + 1);
  for (size_t k = 0; k < length; k++) copy[k] = name[k];
  copy[length] = 0;
  f->name = copy;
  f->c.exchange = exchange;
  begin(f);
  return f;
}
static void free_instance(Instance *f) { if (f) { Callbacks on = f->on; release(&on, f); } }
static Status set_start(Instance *f, double start, int ends, double end) {
  if (f->c.phase != INSTANTIATED) return fail(f, "the start time is set before the initialisation; reset the instance");
  if (ends && !(end >= start)) return fail(f, "the stop time is before the start time");
  if (!finite_number(start)) return fail(f, "the start time is not finite");
  if (pp_numbers.driven && start != pp_numbers.t0)
    return fail(f, "the start time must be that of the model description: drives prescribe positions over the time");
  f->c.t0 = start;
  f->c.steps = 0;
  if (start == pp_numbers.t0) return fOK;
  f->c.stale = JUMPED;
  for (i64 k = 0; pp_numbers.n_drives && k < pp_numbers.n_variables; k++) {
    if (pp_variables[k].kind != SPEED) continue;
    Drive *d = drive_of(f, k);
    turn_on(f, d, d->angle + pp_numbers.t0 * d->speed, d->speed, 0.0);
  }
  return fOK;
}

/* a coordinate or rate of the model */
static double *state_at(Instance *f, i64 i) {
  i64 nd = pp_numbers.nd;
  return reals(f, i < nd ? pp_numbers.q : pp_numbers.v) + (i < nd ? i : i - nd);
}
static Status get_numbers(Instance *f, const VR *vr, size_t n, double *value) {
  for (size_t k = 0; k < n; k++) {
    if (vr[k] >= pp_numbers.n_variables) return fail(f, "no variable with a floating-point value has this value reference");
    const Variable *v = pp_variables + vr[k];
    if (v->kind == TIME) { value[k] = now(f); continue; }
    if (v->kind == INPUT || v->kind == PARAMETER || v->kind == SPEED || v->kind == ACCELERATION) {
      value[k] = f->values[vr[k]];
      continue;
    }
    if (v->kind == INDICATOR) {
      if (request(f, EVENTS, address(f->m + pp_numbers.ev1)) != OK) return fDiscard;
      value[k] = reals(f, pp_numbers.ev1)[pp_indicators[v->first]];
      continue;
    }
    Status s = refresh(f);
    if (s != fOK) return s;
    i64 i = v->first, nd = pp_numbers.nd;
    if (v->kind == OUTPUT) value[k] = f->row[i];
    else if (v->kind == STATE) value[k] = *state_at(f, i);
    else value[k] = reals(f, i < nd ? pp_numbers.v : pp_numbers.a)[i < nd ? i : i - nd];
  }
  return fOK;
}
static double change_by(Instance *f, i64 variable, const Place *p) {
  double change = f->values[variable] - pp_variables[variable].start, sum = 0.0;
  for (i64 k = p->first + p->count; k-- > p->first;) sum = (sum + pp_coefficients[k]) * change;
  return sum;
}
/* words of an input or parameter */
static void put(Instance *f, i64 variable) {
  const Variable *v = pp_variables + variable;
  for (const Place *p = pp_places + v->first; p < pp_places + v->first + v->count; p++) {
    double sum = 0.0;
    for (i64 k = 0; p->shared && k < pp_numbers.n_variables; k++) {
      const Variable *w = pp_variables + k;
      if (w->kind != INPUT && w->kind != PARAMETER) continue;
      for (const Place *r = pp_places + w->first; r < pp_places + w->first + w->count; r++)
        if (r->offset == p->offset) sum += change_by(f, k, r);
    }
    *reals(f, p->offset) = p->base + (p->shared ? sum : change_by(f, variable, p));
  }
}
static Status set_numbers(Instance *f, const VR *vr, size_t n, const double *value) {
  for (size_t k = 0; k < n; k++) {
    i64 kind = vr[k] < pp_numbers.n_variables ? pp_variables[vr[k]].kind : OUTPUT;
    if (kind == STATE && f->c.begun == BEGUN) return fail(f, "coordinates and rates can be set before the end of the initialisation only");
    if (kind == OUTPUT || kind == SLOPE || kind == TIME || kind == INDICATOR)
      return fail(f, "this variable is neither an input nor a parameter");
    if (!finite_number(value[k])) return fail(f, "an input or parameter is not finite");
    const Variable *v = pp_variables + vr[k];
    if (value[k] < v->least) return fail_with(f, "a parameter is out of the range in its description: ", value[k], " is below ", v->least, "");
    if (value[k] > v->most) return fail_with(f, "a parameter is out of the range in its description: ", value[k], " is above ", v->most, "");
  }
  for (size_t k = 0; k < n; k++) {
    const Variable *v = pp_variables + vr[k];
    if (v->kind == STATE) {
      if (*state_at(f, v->first) == value[k]) continue;
      *state_at(f, v->first) = value[k];
      f->c.stale = JUMPED;
      if (v->first < pp_numbers.nd) f->c.begun = POSITIONS_SET;
      else if (f->c.begun == UNCHANGED) f->c.begun = VALUES_SET;
      continue;
    }
    if (f->values[vr[k]] == value[k]) continue;
    f->values[vr[k]] = value[k];
    if (f->c.begun == UNCHANGED) f->c.begun = VALUES_SET;
    if (v->kind == INPUT || v->kind == PARAMETER) put(f, vr[k]);
    else if (!f->c.exchange) continue; /* speeds of drives change in the next communication step */
    f->c.stale = JUMPED;
  }
  return fOK;
}

/* a state begins with the identifier of the FMU, in 40 bytes */
enum { HEAD = 40 };
static size_t state_size(void) { return HEAD + sizeof(Clock) + 8 * (size_t)numbers_of_state() + (size_t)pp_numbers.size; }
static Status keep_state(Instance *f, void **state) {
  if (!state) return fail(f, "no place for the state is given");
  if (!*state) *state = allocate(&f->on, state_size());
  char *s = *state;
  if (!s) return fail(f, "no memory for a state");
  for (int k = 0; k < HEAD; k++) s[k] = 0;
  for (int k = 0; k < HEAD && pp_token[k]; k++) s[k] = pp_token[k];
  size_t n = 8 * (size_t)numbers_of_state();
  memcpy(s += HEAD, &f->c, sizeof(Clock));
  memcpy(s += sizeof(Clock), f->values, n);
  memcpy(s += n, f->m, (size_t)pp_numbers.size);
  move(s, -address(f->m));
  for (i64 k = 0; k < pp_numbers.n_code; k++) *(i64 *)(s + pp_code[2 * k]) = 0;
  return fOK;
}
static int is_own(const char *state) {
  int k = 0;
  while (k < HEAD && pp_token[k] && state[k] == pp_token[k]) k++;
  return k == HEAD || (!pp_token[k] && !state[k]);
}
static Status restore(Instance *f, const char *s) {
  if (!s) return fail(f, "no state is given");
  if (!is_own(s)) return fail(f, "this state is that of another FMU");
  size_t n = 8 * (size_t)numbers_of_state();
  i64 exchange = f->c.exchange;
  memcpy(&f->c, s += HEAD, sizeof(Clock));
  memcpy(f->values, s += sizeof(Clock), n);
  relocate(f, s + n);
  f->c.exchange = exchange;
  if (!exchange && f->c.phase == CONTINUOUS) f->c.phase = RUNNING;
  return fOK;
}
static Status drop_state(Instance *f, void **state) {
  if (state && *state) { release(&f->on, *state); *state = 0; }
  return fOK;
}
static Status serialise(Instance *f, const void *state, unsigned char *bytes, size_t size) {
  if (!state || size < state_size()) return fail(f, "the buffer is smaller than the serialised state, or no state is given");
  memcpy(bytes, state, state_size());
  return fOK;
}
static Status deserialise(Instance *f, const unsigned char *bytes, size_t size, void **state) {
  if (size != state_size()) return fail(f, "these bytes are not a state of this FMU: their number is wrong");
  if (!is_own((const char *)bytes)) return fail(f, "these bytes are a state of another FMU");
  if (!*state) *state = allocate(&f->on, state_size());
  if (!*state) return fail(f, "no memory for a state");
  memcpy(*state, bytes, state_size());
  return fOK;
}
#endif
