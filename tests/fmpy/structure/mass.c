/* A unit of the tests: a mass that falls on what holds it, for co-simulation. Exact under the force that is held over a step. */
#include <stddef.h>
#include <stdlib.h>

enum { FORCE, Z, VZ, MASS, LOAD, COUNT };

typedef struct {
    double values[COUNT];
} Body;

typedef struct {
    void *logger, *allocate, *release, *finished, *environment;
} Callbacks;

const char *fmi2GetTypesPlatform(void) { return "default"; }
const char *fmi2GetVersion(void) { return "2.0"; }

void *fmi2Instantiate(const char *name, int type, const char *guid, const char *location, const Callbacks *callbacks,
                      int visible, int logging) {
    Body *body = calloc(1, sizeof *body);
    (void)name, (void)type, (void)guid, (void)location, (void)callbacks, (void)visible, (void)logging;
    if (body != NULL) {
        body->values[Z] = -0.45975;
        body->values[MASS] = 1500.0;
        body->values[LOAD] = 160e3;
    }
    return body;
}

void fmi2FreeInstance(void *body) { free(body); }
int fmi2SetDebugLogging(void *body, int on, size_t count, const char *const names[]) {
    return (void)body, (void)on, (void)count, (void)names, 0;
}
int fmi2SetupExperiment(void *body, int defined, double tolerance, double start, int stops, double stop) {
    return (void)body, (void)defined, (void)tolerance, (void)start, (void)stops, (void)stop, 0;
}
int fmi2EnterInitializationMode(void *body) { return (void)body, 0; }
int fmi2ExitInitializationMode(void *body) { return (void)body, 0; }
int fmi2Terminate(void *body) { return (void)body, 0; }
int fmi2Reset(void *body) { return (void)body, 3; }

int fmi2GetReal(void *body, const unsigned references[], size_t count, double out[]) {
    for (size_t i = 0; i < count; i++) {
        if (references[i] >= COUNT)
            return 3;
        out[i] = ((Body *)body)->values[references[i]];
    }
    return 0;
}

int fmi2SetReal(void *body, const unsigned references[], size_t count, const double values[]) {
    for (size_t i = 0; i < count; i++) {
        if (references[i] >= COUNT)
            return 3;
        ((Body *)body)->values[references[i]] = values[i];
    }
    return 0;
}

int fmi2DoStep(void *body, double time, double step, int is_final) {
    double *v = ((Body *)body)->values, acceleration = (v[LOAD] + v[FORCE]) / v[MASS];
    (void)time, (void)is_final;
    v[Z] += step * (v[VZ] + 0.5 * step * acceleration);
    v[VZ] += step * acceleration;
    return 0;
}

/* What importers look for and the tests do not use. */
#define UNUSED(name) int name(void) { return 3; }
UNUSED(fmi2GetInteger) UNUSED(fmi2GetBoolean) UNUSED(fmi2GetString) UNUSED(fmi2SetInteger) UNUSED(fmi2SetBoolean)
UNUSED(fmi2SetString) UNUSED(fmi2GetFMUstate) UNUSED(fmi2SetFMUstate) UNUSED(fmi2FreeFMUstate)
UNUSED(fmi2SerializedFMUstateSize) UNUSED(fmi2SerializeFMUstate) UNUSED(fmi2DeSerializeFMUstate)
UNUSED(fmi2GetDirectionalDerivative) UNUSED(fmi2SetRealInputDerivatives) UNUSED(fmi2GetRealOutputDerivatives)
UNUSED(fmi2CancelStep) UNUSED(fmi2GetStatus) UNUSED(fmi2GetRealStatus) UNUSED(fmi2GetIntegerStatus)
UNUSED(fmi2GetBooleanStatus) UNUSED(fmi2GetStringStatus)
