//! The case in SI units, Hertz, the field and tables, as a caller from C sees them.

use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};

use creepage_ffi::*;
use creepage_study::{BulkCase, CaseFile, Solver, Varied, solve};

use crate::caller::{Message, WHEEL};

/// A wheel on a rail by a quick theory.
fn rolling() -> String {
    let creepage = "[creepage]\nlongitudinal = -1e-3\nlateral = 4e-4\n";
    format!("{WHEEL}{creepage}[solve]\ntheory = \"fastsim\"\ngrid = [20, 20]\n")
}

/// Code, forces, powers, statuses, message.
type Answer = (i32, Vec<f64>, Vec<f64>, Vec<i32>, String);

/// A case that frees itself.
struct Case(*mut CreepageCase);

impl Case {
    fn new(text: &str, theory: Option<&str>) -> Result<Self, (i32, String)> {
        let (text, theory) =
            (CString::new(text).unwrap(), theory.map(|t| CString::new(t).unwrap()));
        let (mut made, mut message) = (null_mut(), Message::new());
        let theory = theory.as_ref().map_or(null(), |theory| theory.as_ptr());
        // SAFETY: all point to what they should.
        let code = unsafe {
            creepage_case_new(text.as_ptr(), theory, &raw mut made, message.0.as_mut_ptr(), 256)
        };
        if code == CREEPAGE_OK { Ok(Self(made)) } else { Err((code, message.text())) }
    }

    fn force(&self, quantities: &str, values: &[f64]) -> Answer {
        self.force_by(null(), quantities, values)
    }

    fn force_by(&self, table: *const CreepageTable, quantities: &str, values: &[f64]) -> Answer {
        let width = quantities.split(',').count();
        let count = values.len() / width;
        let quantities = CString::new(quantities).unwrap();
        let (mut forces, mut powers) = (vec![9.0; 3 * count], vec![9.0; 2 * count]);
        let (mut statuses, mut message) = (vec![99; count], Message::new());
        // SAFETY: all point to what they should, or to nothing where that is allowed.
        let code = unsafe {
            creepage_case_force(
                self.0,
                table,
                quantities.as_ptr(),
                count,
                values.as_ptr(),
                forces.as_mut_ptr(),
                null_mut(),
                null_mut(),
                powers.as_mut_ptr(),
                statuses.as_mut_ptr(),
                message.0.as_mut_ptr(),
                256,
            )
        };
        (code, forces, powers, statuses, message.text())
    }
}

impl Drop for Case {
    fn drop(&mut self) {
        // SAFETY: made by the library, and not used again.
        unsafe { creepage_case_free(self.0) }
    }
}

#[test]
fn a_history_is_the_case_row_by_row() {
    let case = Case::new(&rolling(), None).unwrap();
    let loads = [80e3, 60e3, f64::NAN, 4e234];
    let (code, forces, powers, statuses, message) = case.force("normal_force", &loads);
    assert_eq!(code, CREEPAGE_OK);
    let expected = [CREEPAGE_SOLVED, CREEPAGE_SOLVED, CREEPAGE_NO_CASE, CREEPAGE_CHECK_UNITS];
    assert_eq!(statuses, expected);
    assert!(message.starts_with("case 2: [contact] normal_force = NaN"), "{message}");
    assert!(forces[6..9].iter().all(|force| force.is_nan()) && powers[4].is_nan());
    for (row, load) in ["80e3", "60e3"].into_iter().enumerate() {
        let one = CaseFile::read(&rolling().replace("80e3", load)).unwrap().case().unwrap();
        let solved = solve(&one, None).unwrap();
        let right = solved.scaling().si_force(solved.solution().force);
        let right = [right.longitudinal, right.lateral, right.moment];
        assert_eq!(forces[3 * row..3 * row + 3], right);
        assert_eq!(powers[2 * row], solved.power_per_metre());
        assert!(powers[2 * row + 1].is_nan());
    }
    let (_, _, powers, ..) = case.force("speed,longitudinal", &[10.0, 1e-3, 20.0, 1e-3]);
    assert_eq!([powers[1], powers[3]], [10.0 * powers[0], 20.0 * powers[0]]);
}

/// A thousand rows, each with a load of its own.
fn history() -> Vec<f64> {
    let part = |k: usize, times: f64| (k as f64 * times).fract();
    let row = |k| [4e-3 * part(k, 0.618) - 2e-3, 2e-3 * part(k, 0.414), 5e4 + 4e4 * part(k, 0.732)];
    (0..1000).flat_map(row).collect()
}

#[test]
fn a_history_is_that_of_the_library_to_the_last_bit() {
    let (values, place) = (history(), tempfile::tempdir().unwrap());
    let varied = vec![Varied::Longitudinal, Varied::Lateral, Varied::NormalForce];
    let bulk = BulkCase::new(&CaseFile::read(&rolling()).unwrap(), varied).unwrap();
    let spec = creepage::table::Spec {
        a_over_b: creepage::table::Axis { low: 0.8, high: 2.0, nodes: 3 },
        poisson: creepage::table::Axis::fixed(0.28),
        intervals: creepage::table::Intervals { theta: 4, phi: 4, t: 6 },
        places: 20,
        provenance: creepage::table::Provenance::default(),
    };
    let prepare = |contact: &creepage::Contact| bulk.theory().prepare(contact);
    let table = creepage::table::build(&spec, prepare, &|| {}).unwrap();
    let path = place.path().join("t.nc");
    std::fs::write(&path, table.to_bytes().unwrap()).unwrap();
    let path = CString::new(path.to_str().unwrap()).unwrap();
    let mut read = null_mut();
    // SAFETY: all point to what they should.
    let code = unsafe { creepage_table_read(path.as_ptr(), &raw mut read, null_mut(), 0) };
    assert_eq!(code, CREEPAGE_OK);
    let by_theory = (null(), Solver::new(bulk.theory().clone()));
    for (table, solver) in [by_theory, (read.cast_const(), Solver::of_table(table.into()))] {
        let case = Case::new(&rolling(), None).unwrap();
        let (code, forces, powers, statuses, _) =
            case.force_by(table, "longitudinal,lateral,normal_force", &values);
        assert_eq!((code, statuses), (CREEPAGE_OK, vec![CREEPAGE_SOLVED; 1000]));
        for (k, row) in values.chunks(3).enumerate() {
            let right = bulk.solve_one(&solver, row).unwrap();
            let force = right.force();
            let force = [force.longitudinal, force.lateral, force.moment];
            assert_eq!(forces[3 * k..3 * k + 3], force, "row {k}");
            assert_eq!(powers[2 * k], right.power_per_metre());
        }
    }
    // SAFETY: made by the library, and not used again.
    unsafe { creepage_table_free(read) };
}

#[test]
fn wrong_questions_get_their_codes() {
    let case = Case::new(&rolling(), Some("polach")).unwrap();
    for (quantities, values, code, part) in [
        ("load", &[1.0][..], CREEPAGE_TEXT, "`load` is not a quantity"),
        ("spin,spin", &[1.0, 1.0], CREEPAGE_TEXT, "spin (twice)"),
        ("semi_axis_rolling", &[1.0], CREEPAGE_INVALID, "semi_axis_lateral is missing"),
    ] {
        let (found, forces, .., message) = case.force(quantities, values);
        assert!(found == code && message.contains(part), "{found} {message}");
        assert_eq!(forces, [9.0; 3]);
    }
    let none = Case::new("[upper]\n", None).map(|_| ()).unwrap_err();
    assert!(none.0 == CREEPAGE_FILE && none.1.contains("section [lower] is missing"), "{none:?}");
    let none = Case::new("no.toml", None).map(|_| ()).unwrap_err();
    assert!(none.0 == CREEPAGE_FILE && none.1.starts_with("cannot read no.toml"), "{none:?}");
    assert_eq!(Case::new(&rolling(), Some("polech")).map(|_| ()).unwrap_err().0, CREEPAGE_TEXT);
    let one = [1.0];
    // SAFETY: pointers are right, NULL, or seen to be of no use before they are read.
    unsafe {
        let name = c"spin".as_ptr();
        let ask = |case, count, values, forces: *mut f64| {
            let none = null_mut();
            let (errors, statuses) = (null_mut(), null_mut());
            let powers = null_mut();
            creepage_case_force(
                case,
                null(),
                name,
                count,
                values,
                forces,
                none,
                errors,
                powers,
                statuses,
                null_mut(),
                0,
            )
        };
        let mut out = [0.0; 3];
        assert_eq!(ask(null(), 1, one.as_ptr(), out.as_mut_ptr()), CREEPAGE_NULL);
        assert_eq!(ask(case.0, 1, null(), out.as_mut_ptr()), CREEPAGE_NULL);
        assert_eq!(ask(case.0, 1, one.as_ptr(), null_mut()), CREEPAGE_NULL);
        assert_eq!(ask(case.0, usize::MAX / 4, one.as_ptr(), out.as_mut_ptr()), CREEPAGE_COUNT);
        creepage_case_free(null_mut());
    }
}

/// Cells along a side of the box around the ellipse.
const CELLS: usize = 60;

#[test]
fn hertz_and_the_field_carry_the_load() {
    let (wheel, rail) = ([82e9, 0.28, 0.46, f64::INFINITY], [82e9, 0.28, f64::INFINITY, 0.3]);
    let hertz = |wheel: &[f64; 4], load| {
        let (mut contact, mut status, mut message) = ([9.0; 9], 9, Message::new());
        // SAFETY: all point to what they should.
        let code = unsafe {
            creepage_hertz(
                wheel.as_ptr(),
                rail.as_ptr(),
                0.0,
                load,
                contact.as_mut_ptr(),
                &raw mut status,
                message.0.as_mut_ptr(),
                256,
            )
        };
        (code, contact, status, message.text())
    };
    let (code, contact, status, _) = hertz(&wheel, 80e3);
    assert_eq!((code, status), (CREEPAGE_OK, CREEPAGE_SOLVED));
    let right = CaseFile::read(&rolling()).unwrap().hertz().unwrap();
    assert_eq!(contact[..3], [right.ellipse().a(), right.ellipse().b(), right.peak_pressure()]);
    let (code, .., message) = hertz(&wheel, -1.0);
    assert!(code == CREEPAGE_INVALID && message.starts_with("normal_force = -1"), "{message}");
    assert_eq!(hertz(&[82e3, 0.28, 0.46, f64::INFINITY], 80e3).2, CREEPAGE_CHECK_UNITS);
    let (code, .., message) = hertz(&[82e9, 0.28, -0.46, f64::INFINITY], 80e3);
    assert!(code == CREEPAGE_INVALID && message.contains("cannot touch"), "{message}");

    let case = Case::new(&rolling(), None).unwrap();
    let [a, b] = [contact[0], contact[1]];
    let middle = |k: usize, half: f64| half * ((2 * k + 1) as f64 / CELLS as f64 - 1.0);
    let places: Vec<_> =
        (0..CELLS * CELLS).flat_map(|k| [middle(k % CELLS, a), middle(k / CELLS, b)]).collect();
    let count = CELLS * CELLS;
    let (mut pressures, mut tractions) = (vec![9.0; count], vec![9.0; 2 * count]);
    let mut regions = vec![9; count];
    // SAFETY: all point to what they should, or to nothing where that is allowed.
    let code = unsafe {
        creepage_case_field(
            case.0,
            count,
            places.as_ptr(),
            pressures.as_mut_ptr(),
            tractions.as_mut_ptr(),
            null_mut(),
            regions.as_mut_ptr(),
            null_mut(),
            0,
        )
    };
    assert_eq!(code, CREEPAGE_OK);
    let cell = 4.0 * a * b / count as f64;
    // Cells of a box; the pressure falls to zero like a root at the edge.
    assert!((pressures.iter().sum::<f64>() * cell / 80e3 - 1.0).abs() < 5e-3);
    let force = tractions.iter().step_by(2).sum::<f64>() * cell;
    let right = case.force("normal_force", &[80e3]).1[0];
    // FASTSIM's traction on 20 x 20 cells, summed over others.
    assert!((force / right - 1.0).abs() < 0.03, "{force} {right}");
    assert!(
        [CREEPAGE_ADHESION, CREEPAGE_SLIP, CREEPAGE_OUTSIDE].iter().all(|r| regions.contains(r))
    );
}

#[test]
fn a_table_is_built_written_and_asked_in_si_units() {
    let place = tempfile::tempdir().unwrap();
    let path = CString::new(place.path().join("t.nc").to_str().unwrap()).unwrap();
    let (mut built, mut read, mut message) = (null_mut(), null_mut(), Message::new());
    let words_of = message.0.as_mut_ptr();
    let (ratios, poisson, intervals) = ([0.8, 2.0], [0.28, 0.28], [4_usize, 4, 6]);
    // SAFETY: all point to what they should, or to nothing where that is allowed.
    unsafe {
        let build = |name: &CStr, shapes, table| {
            creepage_table_build(
                name.as_ptr(),
                null(),
                ratios.as_ptr(),
                shapes,
                poisson.as_ptr(),
                1,
                intervals.as_ptr(),
                20,
                table,
                words_of,
                256,
            )
        };
        assert_eq!(build(c"linear", 3, &raw mut built), CREEPAGE_INVALID);
        assert_eq!(build(c"polach", 1, &raw mut built), CREEPAGE_INVALID);
        assert!(built.is_null());
        assert_eq!(build(c"polach", 3, &raw mut built), CREEPAGE_OK);
        assert_eq!(creepage_table_write(built, path.as_ptr(), words_of, 256), CREEPAGE_OK);
        assert_eq!(creepage_table_read(path.as_ptr(), &raw mut read, words_of, 256), CREEPAGE_OK);
        let case = Case::new(&rolling(), None).unwrap();
        let ask = |table, errors| {
            let (mut forces, load, none) = ([9.0; 3], [80e3], null_mut());
            let statuses = null_mut();
            let powers = null_mut();
            let code = creepage_case_force(
                case.0,
                table,
                c"normal_force".as_ptr(),
                1,
                load.as_ptr(),
                forces.as_mut_ptr(),
                none,
                errors,
                powers,
                statuses,
                words_of,
                256,
            );
            (code, forces)
        };
        assert_eq!(ask(built, null_mut()), ask(read, null_mut()));
        let polach =
            Case::new(&rolling(), Some("polach")).unwrap().force("normal_force", &[80e3]).1;
        // A coarse table, whose own measure says so.
        assert!((ask(built, null_mut()).1[0] / polach[0] - 1.0).abs() < 0.1);
        let mut errors = [0.0; 3];
        assert_eq!(ask(built, errors.as_mut_ptr()).0, CREEPAGE_UNSUPPORTED);
        creepage_table_free(built);
        creepage_table_free(read);
    }
}

#[test]
fn the_header_has_the_version() {
    let header = [CREEPAGE_VERSION_MAJOR, CREEPAGE_VERSION_MINOR, CREEPAGE_VERSION_PATCH];
    assert_eq!(header.map(|part| part.to_string()).join("."), env!("CARGO_PKG_VERSION"));
}
