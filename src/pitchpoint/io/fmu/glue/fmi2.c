/* SPDX-License-Identifier: Apache-2.0
   Functions of FMI 2.0. */
#include "co_simulation.h"
#include "equilibrium.h"
#include "model_exchange.h"
typedef int Bool;
typedef void (*Logger2)(void *, Str, Status, Str, Str, ...);

static void say(Instance *f, Status s, Str text) {
  Str category = s == fWarning ? "logStatusWarning" : "logStatusError";
  if (f->on.logger) ((Logger2)f->on.logger)(f->on.environment, f->name, s, category, "%s", text);
}
API Str fmi2GetTypesPlatform(void) { return "default"; }
API Str fmi2GetVersion(void) { return "2.0"; }
API Status fmi2SetDebugLogging(Component c, Bool on, size_t n, const Str *categories) { return fOK; }
API Component fmi2Instantiate(Str name, int type, Str guid, Str resources, const Callbacks *on, Bool visible, Bool logging) {
  return on ? create(name, guid, on, type == 0) : 0;
}
API void fmi2FreeInstance(Component c) { free_instance(c); }
API Status fmi2SetupExperiment(Component c, Bool tolerant, double tolerance, double start, Bool ends, double end) {
  return set_start(c, start, ends, end);
}
API Status fmi2EnterInitializationMode(Component c) { return enter(c); }
API Status fmi2ExitInitializationMode(Component c) { return end_start(c); }
API Status fmi2Terminate(Component c) { return terminate(c); }
API Status fmi2Reset(Component c) { begin(c); return fOK; }

/* ------------------------------------------------------------------------------------------------ values */

API Status fmi2GetReal(Component c, const VR *vr, size_t n, double *value) { return get_numbers(c, vr, n, value); }
API Status fmi2SetReal(Component c, const VR *vr, size_t n, const double *value) { return set_numbers(c, vr, n, value); }
#define NONE(name, type) \
  API Status fmi2Get##name(Component c, const VR *vr, size_t n, type *value) { return n ? fail(c, "the model has no variables of type " #name) : fOK; } \
  API Status fmi2Set##name(Component c, const VR *vr, size_t n, const type *value) { return n ? fail(c, "the model has no variables of type " #name) : fOK; }
NONE(Integer, int)
NONE(Boolean, Bool)
NONE(String, Str)
API Status fmi2GetFMUstate(Component c, void **state) { return keep_state(c, state); }
API Status fmi2SetFMUstate(Component c, void *state) { return restore(c, state); }
API Status fmi2FreeFMUstate(Component c, void **state) { return drop_state(c, state); }
API Status fmi2SerializedFMUstateSize(Component c, void *state, size_t *size) { *size = state_size(); return fOK; }
API Status fmi2SerializeFMUstate(Component c, void *state, unsigned char *bytes, size_t size) { return serialise(c, state, bytes, size); }
API Status fmi2DeSerializeFMUstate(Component c, const unsigned char *bytes, size_t size, void **state) { return deserialise(c, bytes, size, state); }
API Status fmi2GetDirectionalDerivative(Component c, const VR *of, size_t n_of, const VR *by, size_t n_by, const double *seed, double *change) {
  return directional(c, of, n_of, by, n_by, seed, change);
}

/* ----------------------------------------------------------------------------------------- co-simulation */

API Status fmi2SetRealInputDerivatives(Component c, const VR *vr, size_t n, const int *order, const double *value) {
  return n ? fail(c, "inputs are constant between communication points") : fOK;
}
API Status fmi2GetRealOutputDerivatives(Component c, const VR *vr, size_t n, const int *order, double *value) {
  return n ? fail(c, "derivatives of outputs are not available") : fOK;
}
API Status fmi2DoStep(Component c, double t, double size, Bool keep) { return do_step(c, t, size); }
API Status fmi2CancelStep(Component c) { return fail(c, "no step is in progress"); }
API Status fmi2GetStatus(Component c, int what, Status *s) { return fDiscard; }
API Status fmi2GetRealStatus(Component c, int what, double *s) {
  if (what != 2) return fDiscard;
  *s = now(c); /* last successful time */
  return fOK;
}
API Status fmi2GetIntegerStatus(Component c, int what, int *s) { return fDiscard; }
API Status fmi2GetBooleanStatus(Component c, int what, Bool *s) {
  if (what != 3) return fDiscard;
  *s = ((Instance *)c)->c.failed != 0; /* terminated */
  return fOK;
}
API Status fmi2GetStringStatus(Component c, int what, Str *s) { return fDiscard; }

/* ---------------------------------------------------------------------------------------- model exchange */

typedef struct { Bool again, terminate, nominals, states, next; double at; } EventInfo;
API Status fmi2EnterEventMode(Component c) { return enter_events(c); }
API Status fmi2NewDiscreteStates(Component c, EventInfo *e) {
  EventInfo none = {0, 0, 0, 0, 0, 0.0};
  *e = none;
  return update_events(c);
}
API Status fmi2EnterContinuousTimeMode(Component c) { return enter_continuous(c); }
API Status fmi2CompletedIntegratorStep(Component c, Bool keep, Bool *event, Bool *terminate) { *event = 0; *terminate = 0; return complete_step(c); }
API Status fmi2SetTime(Component c, double t) { return set_time(c, t); }
API Status fmi2SetContinuousStates(Component c, const double *x, size_t n) { return set_states(c, x, n); }
API Status fmi2GetContinuousStates(Component c, double *x, size_t n) { return get_states(c, x, n); }
API Status fmi2GetDerivatives(Component c, double *x, size_t n) { return get_slopes(c, x, n); }
API Status fmi2GetEventIndicators(Component c, double *x, size_t n) { return get_indicators(c, x, n); }
API Status fmi2GetNominalsOfContinuousStates(Component c, double *x, size_t n) { return get_nominals(c, x, n); }
