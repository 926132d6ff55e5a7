/* SPDX-License-Identifier: Apache-2.0
   FMU of FMI 2.0 for tests: y = 2 u + 3 t, or from t = 5 ms a failure by the parameter `mode`. */
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

typedef void (*Logger)(void *, const char *, int, const char *, const char *, ...);
typedef struct { Logger logger; } Callbacks;
static struct { double u, mode, t; int child; Logger logger; } it;

void *fmi2Instantiate(const char *name, int kind, const char *token, const char *place, const Callbacks *on, int a, int b) {
  it.logger = on->logger;
  return &it;
}
int fmi2SetupExperiment(void *c, int defined, double tolerance, double start, int ends, double stop) { it.t = start; return 0; }
int fmi2EnterInitializationMode(void *c) { return 0; }
int fmi2ExitInitializationMode(void *c) { return 0; }
void fmi2FreeInstance(void *c) {}
int fmi2SetReal(void *c, const unsigned *vr, size_t n, const double *value) {
  for (size_t k = 0; k < n; k++) *(vr[k] == 0 ? &it.u : &it.mode) = value[k];
  return 0;
}
int fmi2GetReal(void *c, const unsigned *vr, size_t n, double *value) {
  for (size_t k = 0; k < n; k++) value[k] = it.mode == 3 && it.t > 0.0045 ? NAN : 2.0 * it.u + 3.0 * it.t;
  return 0;
}
int fmi2DoStep(void *c, double t, double h, int keep) {
  it.t = t + h;
  if (it.t < 0.0045) return 0;
  if (it.mode == 1) abort();
  if (it.mode >= 6 && !it.child) if (!(it.child = fork())) for (;;) sleep(1);
  if (it.mode == 2 || it.mode == 7) for (;;) sleep(1);
  if (it.mode == 4) { it.logger(&it, "it", 3, "", "the engine has no %s", "fuel"); return 3; }
  if (it.mode == 5) exit(7);
  return 0;
}

/* functions that must exist, and are not called */
#define UNUSED(name) int fmi2##name() { return 3; }
UNUSED(GetTypesPlatform) UNUSED(GetVersion) UNUSED(SetDebugLogging) UNUSED(Terminate) UNUSED(Reset)
UNUSED(GetInteger) UNUSED(GetBoolean) UNUSED(GetString) UNUSED(SetInteger) UNUSED(SetBoolean) UNUSED(SetString)
UNUSED(GetFMUstate) UNUSED(SetFMUstate) UNUSED(FreeFMUstate) UNUSED(SerializedFMUstateSize) UNUSED(SerializeFMUstate)
UNUSED(DeSerializeFMUstate) UNUSED(GetDirectionalDerivative) UNUSED(SetRealInputDerivatives)
UNUSED(GetRealOutputDerivatives) UNUSED(CancelStep) UNUSED(GetStatus) UNUSED(GetRealStatus) UNUSED(GetIntegerStatus)
UNUSED(GetBooleanStatus) UNUSED(GetStringStatus)
