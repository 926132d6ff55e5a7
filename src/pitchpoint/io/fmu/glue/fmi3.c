/* SPDX-License-Identifier: Apache-2.0
   Functions of FMI 3.0. */
#include "co_simulation.h"
#include "equilibrium.h"
#include "model_exchange.h"
typedef _Bool Bool;
typedef void (*Logger3)(void *, Status, Str, Str);

static void say(Instance *f, Status s, Str text) {
  Str category = s == fWarning ? "logStatusWarning" : "logStatusError";
  if (f->on.logger) ((Logger3)f->on.logger)(f->on.environment, s, category, text);
}
static Component instantiate(Str name, Str token, void *environment, Logger log, int exchange) {
  Callbacks on = {log, 0, 0, 0, environment};
  return create(name, token, &on, exchange);
}
API Str fmi3GetVersion(void) { return "3.0"; }
API Status fmi3SetDebugLogging(Component c, Bool on, size_t n, const Str *categories) { return fOK; }
API Component fmi3InstantiateCoSimulation(Str name, Str token, Str resources, Bool visible, Bool logging, Bool event_mode,
    Bool early, const VR *needed, size_t n_needed, void *environment, Logger log, void *update) {
  return instantiate(name, token, environment, log, 0);
}
API Component fmi3InstantiateModelExchange(Str name, Str token, Str resources, Bool visible, Bool logging, void *environment, Logger log) {
  return instantiate(name, token, environment, log, 1);
}
API Component fmi3InstantiateScheduledExecution(Str name, Str token, Str resources, Bool visible, Bool logging,
    void *environment, Logger log, void *update, void *lock, void *unlock) {
  if (log) ((Logger3)log)(environment, fError, "logStatusError", "this model is not exported for scheduled execution");
  return 0;
}
API void fmi3FreeInstance(Component c) { free_instance(c); }
API Status fmi3EnterInitializationMode(Component c, Bool tolerant, double tolerance, double start, Bool ends, double end) {
  Status s = set_start(c, start, ends, end);
  return s == fOK ? enter(c) : s;
}
API Status fmi3ExitInitializationMode(Component c) { return end_start(c); }
API Status fmi3Terminate(Component c) { return terminate(c); }
API Status fmi3Reset(Component c) { begin(c); return fOK; }

/* ------------------------------------------------------------------------------------------------ values */

static int agree(Component c, size_t n, size_t m) {
  if (n != m) fail(c, "the numbers of values and of value references differ");
  return n == m;
}
API Status fmi3GetFloat64(Component c, const VR *vr, size_t n, double *value, size_t m) {
  return agree(c, n, m) ? get_numbers(c, vr, n, value) : fError;
}
API Status fmi3SetFloat64(Component c, const VR *vr, size_t n, const double *value, size_t m) {
  return agree(c, n, m) ? set_numbers(c, vr, n, value) : fError;
}
#define NONE(name, type) \
  API Status fmi3Get##name(Component c, const VR *vr, size_t n, type *value, size_t m) { return n ? fail(c, "the model has no variables of type " #name) : fOK; } \
  API Status fmi3Set##name(Component c, const VR *vr, size_t n, const type *value, size_t m) { return n ? fail(c, "the model has no variables of type " #name) : fOK; }
NONE(Float32, float)
NONE(Int8, signed char)
NONE(UInt8, unsigned char)
NONE(Int16, short)
NONE(UInt16, unsigned short)
NONE(Int32, int)
NONE(UInt32, u32)
NONE(Int64, i64)
NONE(UInt64, u64)
NONE(Boolean, Bool)
NONE(String, Str)
API Status fmi3GetBinary(Component c, const VR *vr, size_t n, size_t *sizes, void *values, size_t m) { return n ? fail(c, "the model has no variables of type Binary") : fOK; }
API Status fmi3SetBinary(Component c, const VR *vr, size_t n, const size_t *sizes, void *values, size_t m) { return n ? fail(c, "the model has no variables of type Binary") : fOK; }
API Status fmi3GetClock(Component c, const VR *vr, size_t n, Bool *values) { return n ? fail(c, "the model has no clocks") : fOK; }
API Status fmi3SetClock(Component c, const VR *vr, size_t n, const Bool *values) { return n ? fail(c, "the model has no clocks") : fOK; }
API Status fmi3GetFMUState(Component c, void **state) { return keep_state(c, state); }
API Status fmi3SetFMUState(Component c, void *state) { return restore(c, state); }
API Status fmi3FreeFMUState(Component c, void **state) { return drop_state(c, state); }
API Status fmi3SerializedFMUStateSize(Component c, void *state, size_t *size) { *size = state_size(); return fOK; }
API Status fmi3SerializeFMUState(Component c, void *state, unsigned char *bytes, size_t size) { return serialise(c, state, bytes, size); }
API Status fmi3DeserializeFMUState(Component c, const unsigned char *bytes, size_t size, void **state) { return deserialise(c, bytes, size, state); }
API Status fmi3GetDirectionalDerivative(Component c, const VR *of, size_t n_of, const VR *by, size_t n_by, const double *seed,
    size_t n_seed, double *change, size_t n_change) {
  return agree(c, n_by, n_seed) && agree(c, n_of, n_change) ? directional(c, of, n_of, by, n_by, seed, change) : fError;
}

/* ----------------------------------------------------------------------- co-simulation and model exchange */

API Status fmi3DoStep(Component c, double t, double size, Bool keep, Bool *event, Bool *terminate, Bool *early, double *last) {
  Status s = do_step(c, t, size);
  *event = 0;
  *terminate = 0;
  *early = 0;
  *last = now(c);
  return s;
}
API Status fmi3EnterEventMode(Component c) { return enter_events(c); }
API Status fmi3UpdateDiscreteStates(Component c, Bool *again, Bool *terminate, Bool *nominals, Bool *states, Bool *next, double *at) {
  *again = *terminate = *nominals = *states = *next = 0;
  *at = 0.0;
  return update_events(c);
}
API Status fmi3EnterContinuousTimeMode(Component c) { return enter_continuous(c); }
API Status fmi3CompletedIntegratorStep(Component c, Bool keep, Bool *event, Bool *terminate) { *event = 0; *terminate = 0; return complete_step(c); }
API Status fmi3SetTime(Component c, double t) { return set_time(c, t); }
API Status fmi3SetContinuousStates(Component c, const double *x, size_t n) { return set_states(c, x, n); }
API Status fmi3GetContinuousStates(Component c, double *x, size_t n) { return get_states(c, x, n); }
API Status fmi3GetContinuousStateDerivatives(Component c, double *x, size_t n) { return get_slopes(c, x, n); }
API Status fmi3GetEventIndicators(Component c, double *x, size_t n) { return get_indicators(c, x, n); }
API Status fmi3GetNominalsOfContinuousStates(Component c, double *x, size_t n) { return get_nominals(c, x, n); }
API Status fmi3GetNumberOfEventIndicators(Component c, size_t *n) { *n = (size_t)pp_numbers.n_indicators; return fOK; }
API Status fmi3GetNumberOfContinuousStates(Component c, size_t *n) { *n = 2 * (size_t)pp_numbers.nd; return fOK; }

#define NOT(name, ...) API Status fmi3##name(Component c, ##__VA_ARGS__) { return fail(c, "fmi3" #name " is not available in this FMU"); }
NOT(EnterStepMode)
NOT(EnterConfigurationMode)
NOT(ExitConfigurationMode)
NOT(EvaluateDiscreteStates)
NOT(GetNumberOfVariableDependencies, VR v, size_t *n)
NOT(GetVariableDependencies, VR v, size_t *i, VR *d, size_t *j, int *kinds, size_t n)
NOT(GetAdjointDerivative, const VR *u, size_t nu, const VR *k, size_t nk, const double *seed, size_t ns, double *s, size_t m)
NOT(GetIntervalDecimal, const VR *v, size_t n, double *x, int *q)
NOT(GetIntervalFraction, const VR *v, size_t n, u64 *x, u64 *y, int *q)
NOT(GetShiftDecimal, const VR *v, size_t n, double *x)
NOT(GetShiftFraction, const VR *v, size_t n, u64 *x, u64 *y)
NOT(SetIntervalDecimal, const VR *v, size_t n, const double *x)
NOT(SetIntervalFraction, const VR *v, size_t n, const u64 *x, const u64 *y)
NOT(SetShiftDecimal, const VR *v, size_t n, const double *x)
NOT(SetShiftFraction, const VR *v, size_t n, const u64 *x, const u64 *y)
NOT(GetOutputDerivatives, const VR *v, size_t n, const int *o, double *x, size_t m)
NOT(ActivateModelPartition, VR v, double t)
