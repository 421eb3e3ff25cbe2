/* A program that links the library: a wheel that sways over its rail for a hundred steps, forces as hexadecimal numbers. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "wheelrail.h"

static void logger(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status,
                   fmi2String category, fmi2String message, ...) {
    (void)environment;
    (void)status;
    fprintf(stderr, "%s: %s: %s\n", name, category, message);
}

static void check(const char *what, int fine) {
    if (!fine) {
        fprintf(stderr, "%s failed\n", what);
        exit(1);
    }
}

int main(void) {
    static const fmi2CallbackFunctions callbacks = {logger, calloc, free, NULL, NULL};
    static const fmi2ValueReference inputs[] = {WheelRail_wheel_y, WheelRail_wheel_yaw};
    static const fmi2ValueReference outputs[] = {
        WheelRail_wheel_force_x, WheelRail_wheel_force_y, WheelRail_wheel_force_z, WheelRail_patch_1_max_pressure};
    fmi2Component wheel =
        fmi2Instantiate("wheel", fmi2CoSimulation, WheelRail_GUID, NULL, &callbacks, 0, 0);
    int i, k;
    check("fmi2Instantiate", wheel != NULL);
    check("fmi2SetupExperiment", fmi2SetupExperiment(wheel, 0, 0.0, 0.0, 0, 0.0) == fmi2OK);
    check("fmi2EnterInitializationMode", fmi2EnterInitializationMode(wheel) == fmi2OK);
    check("fmi2ExitInitializationMode", fmi2ExitInitializationMode(wheel) == fmi2OK);
    for (i = 0; i < 100; i++) {
        /* Sums of powers of two, the same everywhere. */
        double values[2] = {0.75 + (i - 50) / 8192.0, (i % 16 - 8) / 4096.0}, forces[4];
        check("fmi2SetReal", fmi2SetReal(wheel, inputs, 2, values) == fmi2OK);
        check("fmi2DoStep", fmi2DoStep(wheel, i * 1e-3, 1e-3, 1) == fmi2OK);
        check("fmi2GetReal", fmi2GetReal(wheel, outputs, 4, forces) == fmi2OK);
        for (k = 0; k < 4; k++)
            printf("%.17g%c", forces[k], k < 3 ? ' ' : '\n');
    }
    check("fmi2Terminate", fmi2Terminate(wheel) == fmi2OK);
    fmi2FreeInstance(wheel);
    return 0;
}
