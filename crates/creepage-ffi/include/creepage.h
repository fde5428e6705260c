/*
 * Rolling contact of two elastic bodies with dry friction: the C interface of creepage.
 * Made by cbindgen from crates/creepage-ffi; do not edit.
 *
 * Every function that can fail returns CREEPAGE_OK or one of the codes below, and writes what is
 * wrong, in words that end with a zero byte, to `message`, which has room for `message_size` bytes
 * (it may be NULL; 256 is enough for most). Nothing else is written then, but where said. Of a
 * call that does not fail the message is empty.
 *
 * Handles may be used by many threads at a time; nothing is global. A handle is freed once, when
 * no call uses it any more.
 *
 * Arrays are flat, case by case: xi, eta, chi of the first case, then of the second. That is a
 * 3 x n matrix in Fortran and MATLAB. `count` is the number of cases. The arrays of one call must
 * not overlap.
 *
 *   xi = upsilon_x rho / (mu c), eta = upsilon_y rho / (mu c), chi = phi rho / mu    (1)
 *   f_x = F_x / (mu N), f_y = F_y / (mu N), m_z = M_z / (mu N c)                     (1)
 *
 * with c = sqrt(a b), the velocity of the upper body relative to the lower, and forces of the
 * upper body on the lower; x is the rolling direction, z points into the lower body.
 */

#ifndef CREEPAGE_H
#define CREEPAGE_H

#include <stddef.h>
#include <stdint.h>

/*
 The version of this header: major, minor, patch. That of the library is creepage_version().
 */
#define CREEPAGE_VERSION_MAJOR 0

/*
 See CREEPAGE_VERSION_MAJOR.
 */
#define CREEPAGE_VERSION_MINOR 1

/*
 See CREEPAGE_VERSION_MAJOR.
 */
#define CREEPAGE_VERSION_PATCH 0

/*
 Done.
 */
#define CREEPAGE_OK 0

/*
 A pointer that is needed is NULL.
 */
#define CREEPAGE_NULL 1

/*
 A number is out of range, or not finite.
 */
#define CREEPAGE_INVALID 2

/*
 A text is not UTF-8, names no theory, or holds no option of it.
 */
#define CREEPAGE_TEXT 3

/*
 A file cannot be read, or is not what it should be.
 */
#define CREEPAGE_FILE 4

/*
 So many cases that their arrays would not fit into memory.
 */
#define CREEPAGE_COUNT 5

/*
 The theory does not give what was asked for.
 */
#define CREEPAGE_UNSUPPORTED 6

/*
 A defect of the library; nothing can be said of what was written.
 */
#define CREEPAGE_DEFECT 7

/*
 No creepage gives the forces that are wanted.
 */
#define CREEPAGE_NOT_REACHABLE 8

/*
 There is less room than needed; nothing was written to it.
 */
#define CREEPAGE_ROOM 9

/*
 The traction vanishes at the edge, as (1 - x^2/a^2 - y^2/b^2)^(1/2) times polynomials.
 */
#define CREEPAGE_VANISHING 0

/*
 The traction is singular at the edge, as (1 - x^2/a^2 - y^2/b^2)^(-1/2) times polynomials.
 */
#define CREEPAGE_SINGULAR 1

/*
 The lower body, such as a rail.
 */
#define CREEPAGE_LOWER 0

/*
 The upper body, such as a wheel.
 */
#define CREEPAGE_UPPER 1

/*
 The surfaces stick.
 */
#define CREEPAGE_ADHESION 0

/*
 The surfaces slip.
 */
#define CREEPAGE_SLIP 1

/*
 Outside the contact.
 */
#define CREEPAGE_OUTSIDE 2

/*
 The theory's equations are solved.
 */
#define CREEPAGE_SOLVED 0

/*
 The iteration ended before its tolerance was met.
 */
#define CREEPAGE_NOT_CONVERGED 1

/*
 Solved, but creepage is too small for the theory's resolution.
 */
#define CREEPAGE_CREEPAGE_TOO_SMALL 2

/*
 Solved, but spin is beyond the bound up to which the theory holds.
 */
#define CREEPAGE_SPIN_TOO_LARGE 3

/*
 A status that this version of the interface does not know.
 */
#define CREEPAGE_DOUBTFUL 4

/*
 Solved, but as if the bodies were alike: their difference matters, and only "exact" counts it.
 */
#define CREEPAGE_UNLIKE_BODIES 5

/*
 Solved, but the error bars of the force are larger than the accuracy that was asked for.
 */
#define CREEPAGE_ACCURACY_NOT_REACHED 6

/*
 Solved, but a number looks like one in another unit: the contact is too large for its bodies, the
 pressure above the shear modulus, or a creepage above 0.3.
 */
#define CREEPAGE_CHECK_UNITS 7

/*
 The values are no case, such as NaN; their numbers are NaN.
 */
#define CREEPAGE_NO_CASE 8

/*
 No load presses the bodies together: no contact, and no force.
 */
#define CREEPAGE_NO_CONTACT 9

/*
 Solved from friction at rest, but friction falls so steeply that another solution exists.
 */
#define CREEPAGE_SEVERAL_SOLUTIONS 10

/*
 A case file, read and checked.
 */
typedef struct CreepageCase CreepageCase;

/*
 A contact map, as `creepage map` makes it.
 */
typedef struct CreepageMap CreepageMap;

/*
 A contact and what it remembers.
 */
typedef struct CreepageRolling CreepageRolling;

/*
 A table of creep force, as `creepage table build` makes it.
 */
typedef struct CreepageTable CreepageTable;

/*
 A theory, prepared for one contact.
 */
typedef struct CreepageTheory CreepageTheory;

/*
 A wheelset file, read and checked.
 */
typedef struct CreepageWheelset CreepageWheelset;

/*
 A position of a wheelset, solved: from where a call may start.
 */
typedef struct CreepageWheelsetState CreepageWheelsetState;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/*
 The version of the library, as "0.1.0"; the text is the library's own.
 */
const char *creepage_version(void);

/*
 Reads a case file and keeps it.

 path: the file, in TOML; or the text of one, if it has a line break.
 theory: the theory to use, with its usual options unless it is the file's own; NULL for the
   file's own.
 made: becomes the handle, to be freed with creepage_case_free; NULL if the call fails.

 You promise:
 Texts end with a zero byte; made and message point to as much room as said.
 */
int32_t creepage_case_new(const char *path,
                          const char *theory,
                          struct CreepageCase **made,
                          char *message,
                          size_t message_size);

/*
 Frees a case. NULL is left alone.

 You promise:
 made is NULL, or of creepage_case_new, and not used again.
 */
void creepage_case_free(struct CreepageCase *made);

/*
 Forces in SI units of many cases that differ from the one of a file in some quantities, such as
 a measured history; one after the other.

 table: the table by which to look forces up; NULL for the case's theory.
 quantities: what differs, by names with commas: longitudinal, lateral, spin (rad/m),
   normal_force (N), friction, upper_radius_rolling, upper_radius_lateral,
   lower_radius_rolling, lower_radius_lateral, semi_axis_rolling, semi_axis_lateral (m), speed
   (m/s). A radius is infinite where the body is flat.
 count: number of cases.
 values: count times as many numbers as there are quantities, those of a case together.
 forces: room for 3 count numbers, those of the upper body on the lower: longitudinal (N), lateral
   (N), moment (N m).
 dimensionless: room for 3 count numbers, f_x, f_y, m_z (1); or NULL.
 errors: room for 3 count numbers, the error bars of f_x, f_y, m_z (1); or NULL.
 powers: room for 2 count numbers, the energy turned to heat per metre rolled (J/m) and the
   frictional power (W), which is NaN without a speed; or NULL.
 statuses: room for count numbers, CREEPAGE_SOLVED and so on; or NULL.

 Values that are no case, such as NaN, have NaN for numbers and the status CREEPAGE_NO_CASE; the
 others are solved, the call does not fail, and message says what is wrong with the first.
 CREEPAGE_UNSUPPORTED where errors are not NULL and there are no error bars.

 You promise:
 Handles are alive; quantities ends with a zero byte; arrays and message point to as much room as
 said.
 */
int32_t creepage_case_force(const struct CreepageCase *made,
                            const struct CreepageTable *table,
                            const char *quantities,
                            size_t count,
                            const double *values,
                            double *forces,
                            double *dimensionless,
                            double *errors,
                            double *powers,
                            int32_t *statuses,
                            char *message,
                            size_t message_size);

/*
 Solves a case file: creepages to forces, or with a section `wanted` forces to creepages.

 path: the file, in TOML; `creepage init` writes an example.
 theory: the theory to use, with its usual options unless it is the file's own; NULL for the
   file's own.
 creepage: room for 3 numbers, those of the upper body relative to the lower, given or found:
   longitudinal creepage, lateral creepage, spin (rad/m); or NULL.
 force: room for 3 numbers, those of the upper body on the lower: longitudinal force (N),
   lateral force (N), moment (N m).
 status: room for one number, CREEPAGE_SOLVED and so on; or NULL. CREEPAGE_UNLIKE_BODIES where
   the theory takes bodies for alike whose difference matters, CREEPAGE_ACCURACY_NOT_REACHED
   where no resolution has error bars within the accuracy of the file.

 CREEPAGE_NOT_REACHABLE where no creepage gives the wanted forces; CREEPAGE_UNSUPPORTED where
 forces are wanted of another theory than "exact".

 You promise:
 Texts end with a zero byte; arrays and message point to as much room as said.
 */
int32_t creepage_case_solve(const char *path,
                            const char *theory,
                            double *creepage,
                            double *force,
                            int32_t *status,
                            char *message,
                            size_t message_size);

/*
 Presses two bodies of any shape together and rolls them: contact areas and forces.

 path: the case file with a section gap, in TOML, files of points beside it; or the text of one, if
   it has a line break.
 points: 3 numbers a point, x, y and the undeformed distance there (m), of a rectangular grid in any
   order, in place of the file's gap; NULL for the file's own.
 point_count: their number.
 creepage: 3 numbers, longitudinal and lateral creepage and spin (rad/m) at the origin of coordinates, in
   place of what the file gives or wants; NULL for the file's own.
 force: room for 3 numbers, those of the upper body on the lower: longitudinal force (N), lateral force
   (N), moment about the origin (N m).
 error: room for 3 numbers, the error bars of the force, NaN by a theory without; or NULL.
 contact: room for 8 numbers, normal force (N), approach (m), area (m^2), largest pressure (Pa), then
   their error bars; or NULL.
 status: room for one number, CREEPAGE_SOLVED and so on; or NULL.

 A call whose shape, materials and load or approach are those of one of the thread's last calls takes the
 contact from there: it is much quicker, and its numbers are the same.

 CREEPAGE_NOT_REACHABLE where no creepage gives the wanted forces; CREEPAGE_INVALID where the bodies
 have no contact area.

 You promise:
 path ends with a zero byte; arrays and message point to as much room as said.
 */
int32_t creepage_gap_force(const char *path,
                           const double *points,
                           size_t point_count,
                           const double *creepage,
                           double *force,
                           double *error,
                           double *contact,
                           int32_t *status,
                           char *message,
                           size_t message_size);

/*
 Displacement differences of two like bodies by a traction on an ellipse: (2.47), (3.5) of the thesis.

 A polynomial in x and y is its coefficients in the order 1, x, y, x^2, xy, y^2, x^3 and so on, a whole
 number of degrees: 1, 3, 6, 10, ... of them.

 semi_axes: 2 numbers, a and b (m).
 poisson: the combined Poisson's ratio (1).
 edge: CREEPAGE_VANISHING or CREEPAGE_SINGULAR.
 count: coefficients of each polynomial of the traction.
 traction: 3 count numbers, those of X, then of Y, then of Z, over the combined shear modulus.
 room: coefficients of each polynomial of the displacements that there is room for: count where the
   traction is singular, those of two degrees more where it vanishes.
 displacement: room for 3 room numbers, those of u, then of v, then of w (m over m^(p+q)).

 You promise:
 Arrays and message point to as much room as said.
 */
int32_t creepage_half_space_displacement(const double *semi_axes,
                                         double poisson,
                                         int32_t edge,
                                         size_t count,
                                         const double *traction,
                                         size_t room,
                                         double *displacement,
                                         char *message,
                                         size_t message_size);

/*
 The traction on an ellipse that causes displacement differences inside it: the inverse of
 creepage_half_space_displacement, with its conventions.

 edge: CREEPAGE_SINGULAR, which always exists; CREEPAGE_VANISHING, which exists for special
   displacements, else CREEPAGE_NOT_REACHABLE.
 count: coefficients of each polynomial of the displacements.
 displacement: 3 count numbers, those of u, then of v, then of w.
 traction: room for 3 count numbers, those of X, then of Y, then of Z, over the combined shear modulus;
   zero beyond their degree.

 You promise:
 Arrays and message point to as much room as said.
 */
int32_t creepage_half_space_traction(const double *semi_axes,
                                     double poisson,
                                     int32_t edge,
                                     size_t count,
                                     const double *displacement,
                                     double *traction,
                                     char *message,
                                     size_t message_size);

/*
 Solves a problem without rolling: a die, a shift, a twist, a shift with partial slip.

 path: a statics file, in TOML, as `creepage statics` takes it; with a line break in it, the text
   itself.
 report: room for size bytes, the report as JSON with a zero byte at its end; or NULL to ask for needed
   only.
 needed: becomes the number of bytes of the report, the zero byte with them. If size is smaller,
   nothing is written to report and CREEPAGE_ROOM is returned.

 You promise:
 path ends with a zero byte; report, needed and message point to as much room as said.
 */
int32_t creepage_statics(const char *path,
                         char *report,
                         size_t size,
                         size_t *needed,
                         char *message,
                         size_t message_size);

/*
 The contact ellipse of two bodies and its pressure, by Hertz.

 upper, lower: 4 numbers each: shear modulus (Pa), Poisson's ratio (1), radii of curvature along and
   across the rolling direction (m), positive where convex, negative where hollow, infinite where
   flat.
 angle: from the upper body's rolling section to the lower's (degrees).
 normal_force: N (N).
 contact: room for 9 numbers: semi-axes along and across (m), peak pressure (Pa), approach (m),
   curvature length rho (m), angle from the upper body's rolling direction to the first semi-axis
   (degrees), combined shear modulus (Pa), combined Poisson's ratio (1), kappa (1).
 status: room for one number, CREEPAGE_SOLVED, or CREEPAGE_CHECK_UNITS where a number looks like one
   in another unit; or NULL.

 You promise:
 Arrays and message point to as much room as said.
 */
int32_t creepage_hertz(const double *upper,
                       const double *lower,
                       double angle,
                       double normal_force,
                       double *contact,
                       int32_t *status,
                       char *message,
                       size_t message_size);

/*
 Pressure, traction and slip in the contact of a case, in SI units.

 count: number of positions.
 positions: 2 count numbers, x and y of each from the middle of the contact (m).
 pressures: room for count numbers (Pa); or NULL.
 tractions: room for 2 count numbers, along and across, of the upper body on the lower (Pa); or
   NULL.
 slips: room for 2 count numbers, velocity of the upper body relative to the lower over the rolling
   velocity (1), NaN where the theory does not give it; or NULL.
 regions: room for count numbers, CREEPAGE_ADHESION, CREEPAGE_SLIP, CREEPAGE_OUTSIDE; or NULL.

 You promise:
 The handle is alive; arrays and message point to as much room as said.
 */
int32_t creepage_case_field(const struct CreepageCase *made,
                            size_t count,
                            const double *positions,
                            double *pressures,
                            double *tractions,
                            double *slips,
                            int32_t *regions,
                            char *message,
                            size_t message_size);

/*
 Stress and displacement inside one body of a case.

 body: CREEPAGE_LOWER or CREEPAGE_UPPER.
 count: number of points.
 points: 3 count numbers, x, y and z of each from the middle of the contact (m), z into that body.
 stresses: room for 6 count numbers, xx, yy, zz, xy, yz, xz (Pa), positive in tension; or NULL.
 displacements: room for 3 count numbers, u, v, w (m), w into the body; they vanish far away; or NULL.
 settled: room for one number, the depth (m) less than which stresses depend on the elements of the
   theory; or NULL.

 You promise:
 The handle is alive; arrays and message point to as much room as said.
 */
int32_t creepage_case_below(const struct CreepageCase *made,
                            int32_t body,
                            size_t count,
                            const double *points,
                            double *stresses,
                            double *displacements,
                            double *settled,
                            char *message,
                            size_t message_size);

/*
 Reads a contact map.

 path: the file.
 map: becomes the handle, to be freed with creepage_map_free; NULL if the call fails.

 You promise:
 path ends with a zero byte; map and message point to as much room as said.
 */
int32_t creepage_map_load(const char *path,
                          struct CreepageMap **map,
                          char *message,
                          size_t message_size);

/*
 Frees a map. NULL is left alone.

 You promise:
 map is NULL, or of creepage_map_load, and not used again.
 */
void creepage_map_free(struct CreepageMap *map);

/*
 Forces on the rails, looked up: some microseconds each, the same bits whatever was asked before, by any
 number of threads. What lies outside the map is an error (CREEPAGE_INVALID) whose words name the state and the bound;
 answers of the states before it are written.

 count: number of states.
 states: 12 count numbers, of each state y (m), z (m, down), roll (rad), yaw (rad), axle load (N), speed
   (m/s), pitch rate (rad/s), lateral and vertical velocity (m/s), roll rate, yaw rate (rad/s),
   friction; NaN is the wheelset's own, of z and axle load one presses it.
 answers: room for 21 count numbers, of each state in track axes, x forward, y right, z down: force (N) and
   moment about the origin of the rail's profile (N m) on the left rail, then on the right; force and moment
   of the rails on the wheelset about its centre; z (m), roll (rad), pitch rate (rad/s).
 errors: room for 4 count numbers, the map's largest measured error at the left wheel, of the tangential
   force in parts of mu N and of the normal force in parts of N, then at the right wheel; or NULL.
 derivatives: room for 96 count numbers, of each state those of the first force on the left rail by y, z,
   roll, yaw, speed, pitch rate, lateral velocity, yaw rate, then of the second force; NaN by what is found;
   or NULL.

 You promise:
 The handle is alive; arrays and message point to as much room as said.
 */
int32_t creepage_map_solve(const struct CreepageMap *map,
                           size_t count,
                           const double *states,
                           double *answers,
                           double *errors,
                           double *derivatives,
                           char *message,
                           size_t message_size);

/*
 Solves a case of any contact, a line contact, a wheelset, a bearing or a problem without rolling, and gives
 quantities of its report.

 path: the file in TOML, files of points and profiles beside it; or the text of one, if it has a line break.
 theory: the name of a theory in place of the file's; NULL for the file's own, as for a bearing and without rolling.
 count: number of quantities.
 keys: their keys, with the section before a point, such as contact.peak_pressure_pa or lower_body.lateral_n: those of
   report.json, which the guide lists with their units; of a wheelset left.force.lateral_n or left.patches.0.area_m2,
   0 being the most loaded contact, of a bearing balls.0.inner.heat_w, without rolling found.shift_x_m. An unknown
   key is CREEPAGE_TEXT.
 values: room for count numbers, NaN for a quantity that is unknown.
 errors: room for count numbers, their error bars, zero for what was given, NaN where nothing is known; or NULL.
 status: room for one number, CREEPAGE_SOLVED and so on; or NULL.

 CREEPAGE_NOT_REACHABLE where no creepage gives the wanted forces; CREEPAGE_INVALID where the bodies
 have no contact area.

 You promise:
 path, theory and each of the keys end with a zero byte; arrays and message point to as much room as said.
 */
int32_t creepage_report(const char *path,
                        const char *theory,
                        size_t count,
                        const char *const *keys,
                        double *values,
                        double *errors,
                        int32_t *status,
                        char *message,
                        size_t message_size);

/*
 Prepares a contact that rolls, in the state that its case file names.

 path: the file, in TOML, as of the command creepage roll; or the text of one, if it has a line break.
 made: becomes the handle, to be freed with creepage_rolling_free; NULL if the call fails.

 You promise:
 path ends with a zero byte; made and message point to as much room as said.
 */
int32_t creepage_rolling_new(const char *path,
                             struct CreepageRolling **made,
                             char *message,
                             size_t message_size);

/*
 Frees a contact that rolls. NULL is left alone.

 You promise:
 made is NULL, or of creepage_rolling_new, and not used again.
 */
void creepage_rolling_free(struct CreepageRolling *made);

/*
 Rolls on. If the call fails, the contact is as it was.

 distance: length of the step (m), positive; finer steps in between are the library's affair.
 motion: 3 numbers, longitudinal, lateral and spin: each a creepage (spin in rad/m) or the force on the
   lower body (N; moment N m) that it is to have.
 held: 3 numbers, not zero where that of motion is a force; or NULL if all are creepages. A line
   contact has no spin: its number is 0, and a creepage.
 normal_force: in the step (N), zero where the bodies separate; NaN for that of the case file.
 forces: room for 3 numbers, longitudinal and lateral force (N) and moment (N m) on the lower body at
   the end of the step; of a line contact per metre.
 creepages: room for 3 numbers, those of the end of the step, given or found; or NULL.
 adhesion: room for one number, the share of the contact area that adheres; or NULL.
 statuses: room for one number, CREEPAGE_SOLVED and so on; or NULL.

 You promise:
 The handle is alive; arrays and message point to as much room as said.
 */
int32_t creepage_rolling_step(const struct CreepageRolling *made,
                              double distance,
                              const double *motion,
                              const int32_t *held,
                              double normal_force,
                              double *forces,
                              double *creepages,
                              double *adhesion,
                              int32_t *statuses,
                              char *message,
                              size_t message_size);

/*
 Writes what the contact remembers, to go back to it with creepage_rolling_restore: for a step that is
 rejected later, or to go on in another run.

 state: room for size bytes; or NULL to ask for needed only.
 needed: becomes the number of bytes that the state has now; it changes from step to step. If size is
   smaller, nothing is written to state and CREEPAGE_ROOM is returned.

 You promise:
 The handle is alive; state, needed and message point to as much room as said.
 */
int32_t creepage_rolling_save(const struct CreepageRolling *made,
                              uint8_t *state,
                              size_t size,
                              size_t *needed,
                              char *message,
                              size_t message_size);

/*
 Goes back, or on, to what creepage_rolling_save wrote: the steps after it are the same to the last
 bit. If the call fails, the contact is as it was.

 state: the bytes, as many as needed said.

 You promise:
 The handle is alive; state and message point to as much as said.
 */
int32_t creepage_rolling_restore(const struct CreepageRolling *made,
                                 const uint8_t *state,
                                 size_t size,
                                 char *message,
                                 size_t message_size);

/*
 Reads a table.

 path: the file.
 table: becomes the handle, to be freed with creepage_table_free; NULL if the call fails.

 You promise:
 path ends with a zero byte; table and message point to as much room as said.
 */
int32_t creepage_table_read(const char *path,
                            struct CreepageTable **table,
                            char *message,
                            size_t message_size);

/*
 Builds a table of a theory, on all cores, and measures its error.

 theory, options: as of creepage_theory_new.
 a_over_b: 2 numbers, the first and the last ratio of the semi-axes (1); the same for one only.
 shapes: number of ratios, in equal steps of their logarithm; 1 for one only.
 poisson: 2 numbers, the first and the last of Poisson's ratios (1).
 materials: number of Poisson's ratios; 1 for one only.
 intervals: 3 numbers, along theta, phi (even) and t; NULL for the usual 20, 16, 48.
 places: at how many random places the error is measured, and at about as many where the force bends
   most; 500 is usual.
 table: becomes the handle, to be freed with creepage_table_free; NULL if the call fails.

 You promise:
 Texts end with a zero byte; arrays, table and message point to as much room as said.
 */
int32_t creepage_table_build(const char *theory,
                             const char *options,
                             const double *a_over_b,
                             size_t shapes,
                             const double *poisson,
                             size_t materials,
                             const size_t *intervals,
                             size_t places,
                             struct CreepageTable **table,
                             char *message,
                             size_t message_size);

/*
 Writes a table to a file, which appears when it is whole.

 You promise:
 The handle is alive; path ends with a zero byte; message points to as much room as said.
 */
int32_t creepage_table_write(const struct CreepageTable *table,
                             const char *path,
                             char *message,
                             size_t message_size);

/*
 Frees a table. NULL is left alone.

 You promise:
 table is NULL, or of creepage_table_read or creepage_table_build, and not used again.
 */
void creepage_table_free(struct CreepageTable *table);

/*
 The largest error of the table against its theory at random places and where the force bends
 most, as measured when the table was built.

 errors: room for 2 numbers, of the force in parts of mu N and of the moment in parts of
   mu N c (1).

 You promise:
 The handle is alive; errors and message point to as much room as said.
 */
int32_t creepage_table_error(const struct CreepageTable *table,
                             double *errors,
                             char *message,
                             size_t message_size);

/*
 Looks many forces up, for one contact.

 a_over_b: semi-axis along over semi-axis across the rolling direction, within the table's
   range (1).
 poisson: combined Poisson's ratio, within the table's range (1).
 kappa_over_mu: how dissimilar the bodies are, as of creepage_theory_new. A table neglects it;
   status says where it matters.
 count: number of cases.
 creepages: 3 count numbers, xi, eta, chi of each case (1).
 forces: room for 3 count numbers, f_x, f_y, m_z of each case (1).
 derivatives: room for 9 count numbers; or NULL. Of each case the derivative of f_x by xi, by
   eta and by chi, then of f_y, then of m_z (1).
 status: room for one number, that of all cases: CREEPAGE_SOLVED or CREEPAGE_UNLIKE_BODIES; or
   NULL.

 You promise:
 The handle is alive; arrays and message point to as much room as said.
 */
int32_t creepage_table_force(const struct CreepageTable *table,
                             double a_over_b,
                             double poisson,
                             double kappa_over_mu,
                             size_t count,
                             const double *creepages,
                             double *forces,
                             double *derivatives,
                             int32_t *status,
                             char *message,
                             size_t message_size);

/*
 Prepares a theory.

 name: "exact", "fastsim", and so on, as `creepage theories` lists them.
 options: its options as in the section `solve` of a case file, for instance
   "resolution = 'fine'"; NULL or "" for the usual ones.
 a_over_b: semi-axis along over semi-axis across the rolling direction (1).
 poisson: combined Poisson's ratio, 0 to 0.5 (1).
 kappa_over_mu: how dissimilar the bodies are, kappa over the coefficient of friction; 0 for like
   bodies (1). Theories other than "exact" neglect it, and say so where it matters.
 theory: becomes the handle, to be freed with creepage_theory_free; NULL if the call fails.

 You promise:
 Texts end with a zero byte; theory and message point to as much room as said.
 */
int32_t creepage_theory_new(const char *name,
                            const char *options,
                            double a_over_b,
                            double poisson,
                            double kappa_over_mu,
                            struct CreepageTheory **theory,
                            char *message,
                            size_t message_size);

/*
 Frees a theory. NULL is left alone.

 You promise:
 theory is NULL, or of creepage_theory_new, and not used again.
 */
void creepage_theory_free(struct CreepageTheory *theory);

/*
 Forces of many cases, one after the other.

 count: number of cases.
 creepages: 3 count numbers, xi, eta, chi of each case (1).
 forces: room for 3 count numbers, f_x, f_y, m_z of each case (1).
 errors: room for 3 count numbers, the error bars of f_x, f_y, m_z (1); or NULL.
 derivatives: room for 9 count numbers; or NULL. Of each case the derivative of f_x by xi, by
   eta and by chi, then of f_y, then of m_z (1); one-sided where the force has a kink.
 statuses: room for count numbers, CREEPAGE_SOLVED and so on; or NULL.

 All creepages are checked before any case is solved. CREEPAGE_UNSUPPORTED where errors are not
 NULL and the theory is not "exact", and where derivatives are not NULL and it is "variational".

 You promise:
 The handle is alive; arrays and message point to as much room as said.
 */
int32_t creepage_theory_force(const struct CreepageTheory *theory,
                              size_t count,
                              const double *creepages,
                              double *forces,
                              double *errors,
                              double *derivatives,
                              int32_t *statuses,
                              char *message,
                              size_t message_size);

/*
 Rolls a wheelset in steps through a table of positions: its contacts remember their tractions. The numbers of
 `creepage roll` with a wheelset file, to the last bit. The theory is "exact", and the pitch rate given.

 start: 0 without traction, 1 as if the first row's motion had always been, -1 as the file says.
 count: number of columns.
 names: their names: distance (m), which is needed and rises from row to row; s (m) and pitch (rad), where surfaces
   vary along rolling; wheel_load (N) of one wheel; y, z (m), roll, yaw (rad), axle_load (N), roll_moment (N m),
   speed (m/s), pitch_rate (rad/s), lateral_velocity, vertical_velocity (m/s), roll_rate, yaw_rate (rad/s). An
   unknown name is CREEPAGE_TEXT. What is left out is the file's own.
 rows: number of rows. A row's motion acts from the distance of the row before, or zero, to its own.
 values: rows times count numbers, row by row; NaN where the file's own holds.
 found: room for rows times 19 numbers: distance (m); of the left wheel the force on its rail in track axes, x
   forward, y right, z down (N), the sum of normal forces (N), the peak pressure (Pa), the number of contacts and
   the share of their area that adheres; the same of the right wheel; how many contacts appeared, vanished, split
   and joined in this row. NaN for a side that is not solved.
 statuses: room for rows numbers, CREEPAGE_SOLVED and so on.

 Where a row cannot be solved the message names it, and the rows before it are written.

 You promise:
 The handle is alive; each of the names ends with a zero byte; arrays and message point to as much room as said.
 */
int32_t creepage_wheelset_roll(const struct CreepageWheelset *made,
                               int32_t start,
                               size_t count,
                               const char *const *names,
                               size_t rows,
                               const double *values,
                               double *found,
                               int32_t *statuses,
                               char *message,
                               size_t message_size);

/*
 Reads a wheelset file and keeps it.

 path: the file, in TOML, its profiles beside it; or the text of one, if it has a line break.
 made: becomes the handle, to be freed with creepage_wheelset_free; NULL if the call fails.

 You promise:
 path ends with a zero byte; made and message point to as much room as said.
 */
int32_t creepage_wheelset_new(const char *path,
                              struct CreepageWheelset **made,
                              char *message,
                              size_t message_size);

/*
 Frees a wheelset. NULL is left alone.

 You promise:
 made is NULL, or of creepage_wheelset_new, and not used again.
 */
void creepage_wheelset_free(struct CreepageWheelset *made);

/*
 Solves a position and a motion of a wheelset. The same answer to the same question: without a start the
 same bits whatever was asked before; with one, found from there, several times quicker where it is near (tenths of
 a millimetre and of a milliradian), the same within the error bars.

 asked: 12 numbers, NaN where the file's own holds: y (m, positive right), z (m, down), roll (rad), yaw
   (rad, positive turns the axle's right end back), axle load (N), roll moment (N m, about x with which it
   presses on the track under its axle load), speed (m/s), pitch rate (rad/s), lateral velocity, vertical
   velocity (m/s), roll rate, yaw rate (rad/s). z or the axle load presses it.
 start: a state that an earlier call gave, or NULL. It is not changed.
 answers: room for 22 numbers in track axes, x forward, y right, z down: force (N) and moment about the
   origin of the rail's profile (N m) on the left rail, then on the right; force and moment of the
   rails on the wheelset about its centre; z (m), roll (rad), pitch rates of the left and of the right wheel
   (rad/s). NaN for a side that is not solved.
 derivatives: room for 96 numbers, or NULL: those of the first force by y, z (m), roll, yaw (rad), speed
   (m/s), pitch rate (rad/s), lateral velocity (m/s), yaw rate (rad/s), then of the second of the 12 forces on the
   rails, and so on. Total ones: what is free follows; NaN by what is free.
 errors: room for as many, what differences may have made of each; or NULL.
 status: room for one number, CREEPAGE_SOLVED and so on; or NULL.
 state: becomes a state, to be freed with creepage_wheelset_state_free; or NULL. A state can be kept as long
   as wanted, and asked from again, as after a step that was rejected.

 You promise:
 The handles are alive; arrays and message point to as much room as said.
 */
int32_t creepage_wheelset_solve(const struct CreepageWheelset *made,
                                const double *asked,
                                const struct CreepageWheelsetState *start,
                                double *answers,
                                double *derivatives,
                                double *errors,
                                int32_t *status,
                                struct CreepageWheelsetState **state,
                                char *message,
                                size_t message_size);

/*
 Frees a state. NULL is left alone.

 You promise:
 state is NULL, or of creepage_wheelset_solve, and not used again.
 */
void creepage_wheelset_state_free(struct CreepageWheelsetState *state);

/*
 Solves many positions and motions on all cores, each by itself with the bits of creepage_wheelset_solve
 without a start.

 n: how many.
 asked: n times 12 numbers, as of creepage_wheelset_solve.
 answers: room for n times 22 numbers; NaN for one that cannot be solved.
 statuses: room for n numbers, CREEPAGE_SOLVED and so on; CREEPAGE_NOT_CONVERGED for one that cannot be
   solved.

 You promise:
 The handle is alive; arrays and message point to as much room as said.
 */
int32_t creepage_wheelset_solve_many(const struct CreepageWheelset *made,
                                     size_t n,
                                     const double *asked,
                                     double *answers,
                                     int32_t *statuses,
                                     char *message,
                                     size_t message_size);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CREEPAGE_H */
