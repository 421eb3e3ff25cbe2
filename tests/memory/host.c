/* A host that calls the library in every state, rightly and wrongly, for a memory checker to watch.
 *
 * host LIBRARY GUID REAL_INPUT REAL_OUTPUT STRING_PARAMETER: value references. Memory that the library gets is as
 * long as it is told and not a byte longer, and freed at the end. */

#include <dlfcn.h>
#include <stdarg.h>
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

static size_t logged = 0;

/* Reads all of every message. */
static void logger(void *environment, const char *name, int status, const char *category,
                   const char *message, ...) {
    char text[4096];
    va_list arguments;
    (void)environment;
    va_start(arguments, message);
    vsnprintf(text, sizeof text, message, arguments);
    va_end(arguments);
    logged += strlen(name) + strlen(category) + strlen(text) + (size_t)status;
}

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

/* A copy on the heap, so that reading beyond its end is seen. */
static void *copied(const void *from, size_t size) {
    void *copy = malloc(size);
    memcpy(copy, from, size);
    return copy;
}

int main(int argc, char **argv) {
    check("arguments", argc == 6 && (library = dlopen(argv[1], RTLD_NOW)));
    void *(*instantiate)(const char *, int, const char *, const char *, const Callbacks *, int, int) =
        function("fmi2Instantiate");
    int (*setup)(void *, int, double, double, int, double) = function("fmi2SetupExperiment");
    int (*enter)(void *) = function("fmi2EnterInitializationMode");
    int (*leave)(void *) = function("fmi2ExitInitializationMode");
    int (*reset)(void *) = function("fmi2Reset");
    int (*terminate)(void *) = function("fmi2Terminate");
    int (*set_real)(void *, const unsigned *, size_t, const double *) = function("fmi2SetReal");
    int (*get_real)(void *, const unsigned *, size_t, double *) = function("fmi2GetReal");
    int (*set_string)(void *, const unsigned *, size_t, const char *const *) = function("fmi2SetString");
    int (*get_string)(void *, const unsigned *, size_t, const char **) = function("fmi2GetString");
    int (*step)(void *, double, double, int) = function("fmi2DoStep");
    int (*get_state)(void *, void **) = function("fmi2GetFMUstate");
    int (*set_state)(void *, void *) = function("fmi2SetFMUstate");
    int (*free_state)(void *, void **) = function("fmi2FreeFMUstate");
    int (*state_size)(void *, void *, size_t *) = function("fmi2SerializedFMUstateSize");
    int (*serialize)(void *, void *, char *, size_t) = function("fmi2SerializeFMUstate");
    int (*deserialize)(void *, const char *, size_t, void **) = function("fmi2DeSerializeFMUstate");
    void (*release)(void *) = function("fmi2FreeInstance");

    unsigned ids[3];
    for (int i = 0; i < 3; i++)
        ids[i] = (unsigned)strtoul(argv[3 + i], NULL, 10);
    unsigned *input = copied(ids, sizeof *ids), *output = copied(ids + 1, sizeof *ids);
    unsigned *text = copied(ids + 2, sizeof *ids);
    double *value = malloc(sizeof *value), first = 0.0;
    Callbacks callbacks = {logger, calloc, free, NULL, NULL};
    char *name = copied("wheel", 6), *guid = copied(argv[2], strlen(argv[2]) + 1);

    for (int life = 0; life < 3; life++) {
        void *unit = instantiate(name, 1, guid, NULL, &callbacks, 0, life);
        check("fmi2Instantiate", unit != NULL);
        check("another GUID", instantiate(name, 1, "{1}", NULL, &callbacks, 0, 1) == NULL);
        check("a step too early", step(unit, 0.0, 1e-3, 1) == 3);
        char *profile = copied("S1002", 6);
        const char *read = NULL;
        check("fmi2SetString", set_string(unit, text, 1, (const char *const *)&profile) == 0);
        free(profile);
        check("fmi2SetupExperiment", setup(unit, 0, 0.0, 0.0, 0, 0.0) == 0);
        check("fmi2EnterInitializationMode", enter(unit) == 0);
        check("fmi2GetString", get_string(unit, text, 1, &read) == 0 && strcmp(read, "S1002") == 0);
        check("fmi2ExitInitializationMode", leave(unit) == 0);
        *value = -0.4597;
        check("fmi2SetReal", set_real(unit, input, 1, value) == 0);
        check("no values", set_real(unit, input, 1, NULL) == 3);
        check("no count", set_real(unit, NULL, 0, NULL) == 0);
        unsigned none = 1u << 30;
        check("no such variable", set_real(unit, &none, 1, value) == 3);
        for (int i = 0; i < 3; i++)
            check("fmi2DoStep", step(unit, 1e-3 * i, 1e-3, 1) == 0);
        check("fmi2GetReal", get_real(unit, output, 1, value) == 0 && *value < -1e3);
        if (life == 0)
            first = *value;
        check("the same again", memcmp(&first, value, sizeof first) == 0);

        void *state = NULL, *copy = NULL;
        size_t size = 0;
        check("fmi2GetFMUstate", get_state(unit, &state) == 0);
        check("fmi2SerializedFMUstateSize", state_size(unit, state, &size) == 0);
        char *bytes = malloc(size);
        check("too few bytes", serialize(unit, state, bytes, size - 1) == 3);
        check("fmi2SerializeFMUstate", serialize(unit, state, bytes, size) == 0);
        check("fmi2DeSerializeFMUstate", deserialize(unit, bytes, size, &copy) == 0);
        for (size_t cut = 0; cut < size; cut += 37) {
            void *bad = NULL;
            char *part = copied(bytes, cut);
            check("bytes cut off", deserialize(unit, part, cut, &bad) == 3);
            free(part);
        }
        free(bytes);
        check("fmi2SetFMUstate", set_state(unit, copy) == 0);
        check("fmi2FreeFMUstate", free_state(unit, &copy) == 0 && copy == NULL);
        if (life == 1) /* Left to the instance in the other lives. */
            check("fmi2FreeFMUstate", free_state(unit, &state) == 0);
        check("fmi2Terminate", terminate(unit) == 0);
        if (life == 2)
            check("fmi2Reset", reset(unit) == 0);
        release(unit);
        check("a freed instance", step(unit, 0.0, 1e-3, 1) == 3);
        release(unit);
        release(NULL);
    }
    check("messages", logged > 0);
    free(input), free(output), free(text), free(value), free(name), free(guid);
    /* Not closed: the table of instances, one for the whole process, would be taken for lost. */
    return 0;
}
