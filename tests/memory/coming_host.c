/* A host that loads the library, runs it and unloads it, many times, with settings of its own in the floating point
 * unit.
 *
 * coming_host LIBRARY GUID REAL_INPUT REAL_OUTPUT LIVES: value references. Prints how many bytes a life leaves behind. */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <fenv.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*step_finished)(void *, int);
    void *environment;
} Callbacks;

static void check(const char *what, int fine) {
    if (!fine) {
        fprintf(stderr, "%s failed\n", what);
        exit(1);
    }
}

static void *library;

static void *function(const char *name) {
    void *found = dlsym(library, name);
    check(name, found != NULL);
    return found;
}

/* As a host that looks for its own faults: every exception ends the process, and numbers are rounded upwards. */
static void own_settings(void) {
    fesetround(FE_UPWARD);
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_ALL_EXCEPT);
}

static void usual_settings(void) {
    check("exceptions of the host stay unmasked", fegetexcept() == FE_ALL_EXCEPT);
    check("the host's way of rounding stays", fegetround() == FE_UPWARD);
    fedisableexcept(FE_ALL_EXCEPT);
    fesetround(FE_TONEAREST);
}

/* The force of one life of the library. */
static double life(char **argv, const unsigned ids[2], int own) {
    check("dlopen", (library = dlopen(argv[1], RTLD_NOW)) != NULL);
    void *(*instantiate)(const char *, int, const char *, const char *, const Callbacks *, int, int) =
        function("fmi2Instantiate");
    int (*setup)(void *, int, double, double, int, double) = function("fmi2SetupExperiment");
    int (*enter)(void *) = function("fmi2EnterInitializationMode");
    int (*leave)(void *) = function("fmi2ExitInitializationMode");
    int (*set_real)(void *, const unsigned *, size_t, const double *) = function("fmi2SetReal");
    int (*get_real)(void *, const unsigned *, size_t, double *) = function("fmi2GetReal");
    int (*step)(void *, double, double, int) = function("fmi2DoStep");
    void (*release)(void *) = function("fmi2FreeInstance");
    Callbacks callbacks = {NULL, calloc, free, NULL, NULL};
    const double height = -0.4597;
    double force = 0.0;
    int fine = 1;
    if (own)
        own_settings();
    void *unit = instantiate("wheel", 1, argv[2], NULL, &callbacks, 0, 0);
    fine &= unit != NULL && setup(unit, 0, 0.0, 0.0, 0, 0.0) == 0 && enter(unit) == 0 && leave(unit) == 0;
    fine &= set_real(unit, ids, 1, &height) == 0 && step(unit, 0.0, 1e-3, 1) == 0;
    fine &= get_real(unit, ids + 1, 1, &force) == 0;
    release(unit);
    if (own)
        usual_settings();
    check("a run", fine);
    check("dlclose", dlclose(library) == 0);
    return force;
}

int main(int argc, char **argv) {
    check("arguments", argc == 6);
    const unsigned ids[2] = {(unsigned)strtoul(argv[3], NULL, 10), (unsigned)strtoul(argv[4], NULL, 10)};
    const int lives = atoi(argv[5]);
    const double usual = life(argv, ids, 0);
    check("contact", usual < -1e3);
    const double own = life(argv, ids, 1);
    check("the same bits with the host's settings", memcmp(&usual, &own, sizeof usual) == 0);
    const size_t before = mallinfo2().uordblks + mallinfo2().hblkhd;
    for (int i = 0; i < lives; i++)
        life(argv, ids, 0);
    const size_t after = mallinfo2().uordblks + mallinfo2().hblkhd;
    printf("%.0f\n", ((double)after - (double)before) / lives);
    return 0;
}
