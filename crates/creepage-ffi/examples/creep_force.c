/*
 * The C interface at work: a case file, one theory over many creepages, the full theory with
 * error bars and derivatives, a table.
 *
 *   cc creep_force.c $(pkg-config --cflags --libs creepage) -o creep_force
 *   ./creep_force CASE.toml [TABLE.nc]
 */
#include <stdio.h>
#include <stdlib.h>

#include "creepage.h"

#define CASES 100

static char message[256];

/* Ends the program with the library's words if a call failed. */
static void check(int32_t code)
{
    if (code != CREEPAGE_OK) {
        fprintf(stderr, "creepage: %s (code %d)\n", message, (int)code);
        exit(1);
    }
}

static void print(const char *name, const double *numbers, int count)
{
    printf("%s", name);
    for (int k = 0; k < count; k++)
        printf(" %.17g", numbers[k]);
    printf("\n");
}

/* Creepages (1, 1, rad/m) and forces (N, N, N m) of a case file, which gives some of the six and
 * has the others found. */
static void case_file(const char *path)
{
    double creepage[3], force[3];
    int32_t status;
    check(creepage_case_solve(path, NULL, creepage, force, &status, message, sizeof message));
    print("creepage", creepage, 3);
    print("case", force, 3);
    printf("status %d\n", (int)status);
}

/* A creep-force curve by FASTSIM: many cases in one call. */
static void curve(void)
{
    CreepageTheory *theory;
    double creepages[3 * CASES] = {0}, forces[3 * CASES], middle[3];
    for (int k = 0; k < CASES; k++)
        creepages[3 * k] = 0.05 * k;
    check(creepage_theory_new("fastsim", "grid = [30, 30]", 1.5, 0.28, 0.0, &theory, message,
                              sizeof message));
    check(creepage_theory_force(theory, CASES, creepages, forces, NULL, NULL, NULL, message,
                                sizeof message));
    creepage_theory_free(theory);
    for (int k = 0; k < 3; k++)
        middle[k] = forces[3 * (CASES / 2) + k];
    print("curve", middle, 3);
}

/* The full theory, with error bars and the derivative that a simulation needs. */
static void exact(void)
{
    CreepageTheory *theory;
    const double creepage[3] = {0.9, -0.3, 0.5};
    double force[3], error[3], derivative[9];
    check(creepage_theory_new("exact", "resolution = 'fast'", 1.5, 0.28, 0.0, &theory, message,
                              sizeof message));
    check(creepage_theory_force(theory, 1, creepage, force, error, derivative, NULL, message,
                                sizeof message));
    creepage_theory_free(theory);
    print("exact", force, 3);
    print("error", error, 3);
    print("derivative", derivative, 9);
}

/* A force looked up. */
static void table(const char *path)
{
    CreepageTable *table;
    const double creepage[3] = {0.9, -0.3, 0.5};
    double force[3], error[2];
    check(creepage_table_read(path, &table, message, sizeof message));
    check(creepage_table_force(table, 1.0, 0.28, 0.0, 1, creepage, force, NULL, NULL, message,
                               sizeof message));
    check(creepage_table_error(table, error, message, sizeof message));
    creepage_table_free(table);
    print("table", force, 3);
    print("table_error", error, 2);
}

/* What goes wrong is told in words. */
static void mistake(void)
{
    CreepageTheory *theory;
    int32_t code = creepage_theory_new("exactly", NULL, 1.0, 0.28, 0.0, &theory, message,
                                       sizeof message);
    printf("mistake %d %s\n", (int)code, message);
}

int main(int count, char **arguments)
{
    if (count < 2) {
        fprintf(stderr, "usage: creep_force CASE.toml [TABLE.nc]\n");
        return 2;
    }
    printf("version %s\n", creepage_version());
    case_file(arguments[1]);
    curve();
    exact();
    if (count > 2)
        table(arguments[2]);
    mistake();
    return 0;
}
