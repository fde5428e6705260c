/*
 * The C interface at work: a case file, a history in SI units, Hertz, one theory over many
 * creepages, the full theory with error bars and derivatives, a table.
 *
 *   cc creep_force.c $(pkg-config --cflags --libs creepage) -o creep_force
 *   ./creep_force CASE.toml [TABLE.nc [CASE.toml]]
 */
#include <math.h>
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

/* A history: creepages, spin and normal force of their own in each case, the rest as in the file. */
static void history(const char *path)
{
    CreepageCase *made;
    const double values[] = {-1e-3, 5e-4, 0.1, 70e3, /* longitudinal, lateral, spin, normal force */
                             -2e-3, 0.0,  0.2, 90e3};
    double forces[6], powers[4];
    int32_t statuses[2];
    check(creepage_case_new(path, "fastsim", &made, message, sizeof message));
    check(creepage_case_force(made, NULL, "longitudinal,lateral,spin,normal_force", 2, values, forces,
                              NULL, NULL, powers, statuses, message, sizeof message));
    creepage_case_free(made);
    print("history", forces, 6);
    print("power", powers, 4);
    printf("statuses %d %d\n", (int)statuses[0], (int)statuses[1]);
}

/* The contact ellipse of a wheel on a rail, and its pressure. */
static void hertz(void)
{
    const double wheel[4] = {82e9, 0.28, 0.46, HUGE_VAL}, rail[4] = {82e9, 0.28, HUGE_VAL, 0.30};
    double contact[9];
    check(creepage_hertz(wheel, rail, 0.0, 80e3, contact, NULL, message, sizeof message));
    print("hertz", contact, 9);
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
        fprintf(stderr, "usage: creep_force CASE.toml [TABLE.nc [CASE.toml]]\n");
        return 2;
    }
    printf("version %s\n", creepage_version());
#if CREEPAGE_VERSION_MAJOR == 0 && CREEPAGE_VERSION_MINOR < 1
#error "a later creepage.h is needed"
#endif
    case_file(arguments[1]);
    hertz();
    curve();
    exact();
    if (count > 2)
        table(arguments[2]);
    if (count > 3)
        history(arguments[3]);
    mistake();
    return 0;
}
