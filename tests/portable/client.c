/* Loads the library of an FMU and asks it for the forces of wheel positions: a host on any platform.
 *
 * client LIBRARY GUID RESOURCES, then on standard input, as numbers: how many inputs, their value
 * references, how many outputs, their value references, and rows of inputs. One row of outputs follows
 * for each. Reals are written as the hexadecimal digits of their bits, which no library rounds. */

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#define open_library(path) ((void *)LoadLibraryA(path))
#define find(library, name) ((void *)GetProcAddress((HMODULE)(library), name))
#else
#include <dlfcn.h>
#define open_library(path) dlopen(path, RTLD_NOW)
#define find(library, name) dlsym(library, name)
#endif

typedef struct {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*step_finished)(void *, int);
    void *environment;
} Callbacks;

static void logger(void *environment, const char *name, int status, const char *category,
                   const char *message, ...) {
    va_list arguments;
    (void)environment;
    fprintf(stderr, "%s: status %d, %s: ", name, status, category);
    va_start(arguments, message);
    vfprintf(stderr, message, arguments);
    va_end(arguments);
    fprintf(stderr, "\n");
}

static void check(const char *what, int fine) {
    if (!fine) {
        fprintf(stderr, "%s failed\n", what);
        exit(1);
    }
}

static size_t references(unsigned **list) {
    unsigned count, i;
    check("number of references", scanf("%u", &count) == 1);
    *list = calloc(count, sizeof **list);
    for (i = 0; i < count; i++)
        check("a reference", scanf("%u", *list + i) == 1);
    return count;
}

int main(int argc, char **argv) {
    static Callbacks callbacks = {logger, calloc, free, NULL, NULL};
    unsigned *inputs, *outputs;
    size_t input_count, output_count, i;
    double *values, *answers, time = 0.0;
    void *library, *unit;
    check("arguments: LIBRARY GUID RESOURCES", argc == 4);
    library = open_library(argv[1]);
    check("loading the library", library != NULL);

    void *(*instantiate)(const char *, int, const char *, const char *, const Callbacks *, int, int) =
        find(library, "fmi2Instantiate");
    int (*setup)(void *, int, double, double, int, double) = find(library, "fmi2SetupExperiment");
    int (*enter)(void *) = find(library, "fmi2EnterInitializationMode");
    int (*leave)(void *) = find(library, "fmi2ExitInitializationMode");
    int (*set)(void *, const unsigned *, size_t, const double *) = find(library, "fmi2SetReal");
    int (*step)(void *, double, double, int) = find(library, "fmi2DoStep");
    int (*get)(void *, const unsigned *, size_t, double *) = find(library, "fmi2GetReal");
    int (*terminate)(void *) = find(library, "fmi2Terminate");
    void (*release)(void *) = find(library, "fmi2FreeInstance");
    check("finding the functions", instantiate && setup && enter && leave && set && step && get &&
                                       terminate && release);

    unit = instantiate("wheel", 1, argv[2], argv[3], &callbacks, 0, 0);
    check("fmi2Instantiate", unit != NULL);
    check("fmi2SetupExperiment", setup(unit, 0, 0.0, 0.0, 0, 0.0) == 0);
    check("fmi2EnterInitializationMode", enter(unit) == 0);
    check("fmi2ExitInitializationMode", leave(unit) == 0);
    input_count = references(&inputs);
    output_count = references(&outputs);
    values = calloc(input_count, sizeof *values);
    answers = calloc(output_count, sizeof *answers);
    for (;;) {
        for (i = 0; i < input_count; i++) {
            uint64_t bits;
            if (scanf("%" SCNx64, &bits) != 1)
                break;
            memcpy(values + i, &bits, sizeof bits);
        }
        if (i < input_count)
            break;
        check("fmi2SetReal", set(unit, inputs, input_count, values) == 0);
        /* 1 is a warning, such as of a wheel that slides: the logger has it, answers are there. */
        check("fmi2DoStep", step(unit, time, 1e-3, 1) <= 1);
        check("fmi2GetReal", get(unit, outputs, output_count, answers) <= 1);
        for (i = 0; i < output_count; i++) {
            uint64_t bits;
            memcpy(&bits, answers + i, sizeof bits);
            printf("%" PRIx64 "%c", bits, i + 1 < output_count ? ' ' : '\n');
        }
        time += 1e-3;
    }
    check("fmi2Terminate", terminate(unit) == 0);
    release(unit);
    return 0;
}
