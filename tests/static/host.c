/* A program that links the library: a wheel that sways over its rail for a hundred steps, forces as hexadecimal numbers. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* The last pressure once more through FMI 3.0, as the first element of an array. */
static void pressure_is_the_same_through_fmi_3(double last) {
    static const fmi3ValueReference inputs[] = {WheelRail_wheel_y, WheelRail_wheel_yaw};
    static const fmi3ValueReference output = WheelRail_patch_max_pressure;
    double values[2] = {0.75 + 49 / 8192.0, (99 % 16 - 8) / 4096.0}, pressures[8], reached;
    bool event, end, early;
    fmi3Instance wheel = fmi3InstantiateCoSimulation("wheel", WheelRail_GUID, NULL, false, false, false, false,
                                                     NULL, 0, NULL, NULL, NULL);
    check("fmi3InstantiateCoSimulation", wheel != NULL);
    check("fmi3EnterInitializationMode",
          fmi3EnterInitializationMode(wheel, false, 0.0, 0.0, false, 0.0) == fmi3OK);
    check("fmi3ExitInitializationMode", fmi3ExitInitializationMode(wheel) == fmi3OK);
    check("fmi3SetFloat64", fmi3SetFloat64(wheel, inputs, 2, values, 2) == fmi3OK);
    check("fmi3DoStep", fmi3DoStep(wheel, 0.0, 1e-3, true, &event, &end, &early, &reached) == fmi3OK);
    check("fmi3GetFloat64", fmi3GetFloat64(wheel, &output, 1, pressures, 8) == fmi3OK);
    check("the same pressure", memcmp(&pressures[0], &last, sizeof last) == 0);
    fmi3FreeInstance(wheel);
}

int main(void) {
    static const fmi2CallbackFunctions callbacks = {logger, calloc, free, NULL, NULL};
    static const fmi2ValueReference inputs[] = {WheelRail_wheel_y, WheelRail_wheel_yaw};
    static const fmi2ValueReference outputs[] = {
        WheelRail_wheel_force_x, WheelRail_wheel_force_y, WheelRail_wheel_force_z, WheelRail_patch_1_max_pressure};
    fmi2Component wheel =
        fmi2Instantiate("wheel", fmi2CoSimulation, WheelRail_GUID, NULL, &callbacks, 0, 0);
    int i, k;
    double last = 0.0;
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
        last = forces[3];
    }
    pressure_is_the_same_through_fmi_3(last);
    check("fmi2Terminate", fmi2Terminate(wheel) == fmi2OK);
    fmi2FreeInstance(wheel);
    return 0;
}
