/* A wheel that begins to pull: a step is taken, rejected, and taken again. The first argument is the
 * case file of a contact that rolls. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <creepage.h>

static char message[256];

static void check(int32_t code) {
    if (code != CREEPAGE_OK) {
        fprintf(stderr, "%s\n", message);
        exit(1);
    }
}

/* Rolls on by a millimetre at a longitudinal force (N). */
static void step(struct CreepageRolling *rolling, double force) {
    double motion[3] = {force, 0.0, 0.0}, forces[3], creepages[3], adhesion;
    int32_t held[3] = {1, 0, 0}, status;
    check(creepage_rolling_step(rolling, 1e-3, motion, held, NAN, forces, creepages, &adhesion,
                                &status, message, sizeof message));
    printf("step %.17g %.17g %.17g\n", forces[0], creepages[0], adhesion);
}

int main(int count, char **arguments) {
    struct CreepageRolling *rolling;
    uint8_t *state;
    size_t size;
    if (count != 2) {
        return 1;
    }
    check(creepage_rolling_new(arguments[1], &rolling, message, sizeof message));
    step(rolling, 5e3);
    creepage_rolling_save(rolling, NULL, 0, &size, message, sizeof message);
    state = malloc(size);
    if (state == NULL) {
        return 1;
    }
    check(creepage_rolling_save(rolling, state, size, &size, message, sizeof message));
    step(rolling, 9e3);
    check(creepage_rolling_restore(rolling, state, size, message, sizeof message));
    step(rolling, 9e3);
    free(state);
    creepage_rolling_free(rolling);
    return 0;
}
