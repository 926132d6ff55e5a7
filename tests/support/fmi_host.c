/* SPDX-License-Identifier: Apache-2.0
   Importing program in plain C for a unit of FMI 3.0: library, token, number of outputs, number and size of the
   communication steps. Writes the outputs after every step as binary numbers to stdout. */
#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

static void log_message(void *environment, int status, const char *category, const char *text) {
  fprintf(stderr, "%d %s: %s\n", status, category, text);
}

int main(int argc, char **argv) {
  void *library = argc == 6 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : 0;
  if (!library) return 1;
  unsigned n = (unsigned)atoi(argv[3]), steps = (unsigned)atoi(argv[4]);
  double size = atof(argv[5]), last;
  void *(*instantiate)() = (void *(*)())dlsym(library, "fmi3InstantiateCoSimulation");
  int (*begin)(void *, bool, double, double, bool, double) = (int (*)(void *, bool, double, double, bool, double))dlsym(library, "fmi3EnterInitializationMode");
  int (*end)(void *) = (int (*)(void *))dlsym(library, "fmi3ExitInitializationMode");
  int (*step)(void *, double, double, bool, bool *, bool *, bool *, double *) = (int (*)(void *, double, double, bool, bool *, bool *, bool *, double *))dlsym(library, "fmi3DoStep");
  int (*get)(void *, const unsigned *, size_t, double *, size_t) = (int (*)(void *, const unsigned *, size_t, double *, size_t))dlsym(library, "fmi3GetFloat64");
  void (*release)(void *) = (void (*)(void *))dlsym(library, "fmi3FreeInstance");
  void *(*create)(const char *, const char *, const char *, bool, bool, bool, bool, const unsigned *, size_t, void *, void *, void *) =
      (void *(*)(const char *, const char *, const char *, bool, bool, bool, bool, const unsigned *, size_t, void *, void *, void *))instantiate;
  void *one = create("one", argv[2], "", false, false, false, false, 0, 0, 0, (void *)log_message, 0);
  if (!one || begin(one, false, 0.0, 0.0, false, 0.0) || end(one)) return 2;
  unsigned *references = malloc(n * sizeof *references);
  double *values = malloc(n * sizeof *values);
  for (unsigned k = 0; k < n; k++) references[k] = k;
  for (unsigned k = 0; k < steps; k++) {
    bool event, terminate, early;
    if (step(one, k * size, size, true, &event, &terminate, &early, &last)) return 3;
    if (get(one, references, n, values, n)) return 4;
    fwrite(values, sizeof *values, n, stdout);
  }
  release(one);
  free(references);
  free(values);
  return 0;
}
