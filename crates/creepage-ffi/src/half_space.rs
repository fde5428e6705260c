//! C functions of the load-displacement equations of chapters 2 and 3, both ways, and of problems without rolling.

use std::ffi::c_char;
use std::fs;
use std::path::Path;

use creepage::Ellipse;
use creepage::halfspace::{Edge, LoadDisplacement, Polynomial, ResponseError, Traction};
use creepage_study::{StaticsError, StaticsFile, StaticsReport};

use crate::failure::{Failure, guard};
use crate::input::{array, array_mut, optional, text};

/// The traction vanishes at the edge, as (1 - x^2/a^2 - y^2/b^2)^(1/2) times polynomials.
pub const CREEPAGE_VANISHING: i32 = 0;
/// The traction is singular at the edge, as (1 - x^2/a^2 - y^2/b^2)^(-1/2) times polynomials.
pub const CREEPAGE_SINGULAR: i32 = 1;

/// Displacement differences of two like bodies by a traction on an ellipse: (2.47), (3.5) of the thesis.
///
/// A polynomial in x and y is its coefficients in the order 1, x, y, x^2, xy, y^2, x^3 and so on, a whole
/// number of degrees: 1, 3, 6, 10, ... of them.
///
/// semi_axes: 2 numbers, a and b (m).
/// poisson: the combined Poisson's ratio (1).
/// edge: CREEPAGE_VANISHING or CREEPAGE_SINGULAR.
/// count: coefficients of each polynomial of the traction.
/// traction: 3 count numbers, those of X, then of Y, then of Z, over the combined shear modulus.
/// room: coefficients of each polynomial of the displacements that there is room for: count where the
///   traction is singular, those of two degrees more where it vanishes.
/// displacement: room for 3 room numbers, those of u, then of v, then of w (m over m^(p+q)).
///
/// # Safety
/// Arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_half_space_displacement(
    semi_axes: *const f64,
    poisson: f64,
    edge: i32,
    count: usize,
    traction: *const f64,
    room: usize,
    displacement: *mut f64,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let ellipse = unsafe { ellipse(semi_axes) }?;
        // SAFETY: as before.
        let given = unsafe { array("traction", traction, count, 3) }?;
        // SAFETY: as before.
        let out = unsafe { array_mut::<f64, 3>("displacement", displacement, room) }?;
        let [x, y, z] = polynomials(given, count)?;
        let traction =
            Traction::new(ellipse, self::edge(edge)?, [&x, &y, &z]).map_err(ResponseError::from)?;
        let response = LoadDisplacement::new(ellipse, poisson, traction.singular_degree())?;
        put(out.as_flattened_mut(), room, &response.displacement(&traction)?)
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// The traction on an ellipse that causes displacement differences inside it: the inverse of
/// creepage_half_space_displacement, with its conventions.
///
/// edge: CREEPAGE_SINGULAR, which always exists; CREEPAGE_VANISHING, which exists for special
///   displacements, else CREEPAGE_NOT_REACHABLE.
/// count: coefficients of each polynomial of the displacements.
/// displacement: 3 count numbers, those of u, then of v, then of w.
/// traction: room for 3 count numbers, those of X, then of Y, then of Z, over the combined shear modulus;
///   zero beyond their degree.
///
/// # Safety
/// Arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_half_space_traction(
    semi_axes: *const f64,
    poisson: f64,
    edge: i32,
    count: usize,
    displacement: *const f64,
    traction: *mut f64,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let ellipse = unsafe { ellipse(semi_axes) }?;
        // SAFETY: as before.
        let given = unsafe { array("displacement", displacement, count, 3) }?;
        // SAFETY: as before.
        let out = unsafe { array_mut::<f64, 3>("traction", traction, count) }?;
        let [u, v, w] = polynomials(given, count)?;
        let inverse = LoadDisplacement::new(ellipse, poisson, u.degree())?.inverse()?;
        let found = match self::edge(edge)? {
            Edge::Singular => inverse.singular([&u, &v, &w])?,
            Edge::Vanishing => inverse.vanishing([&u, &v, &w])?,
        };
        put(out.as_flattened_mut(), count, &found.polynomials().map_err(ResponseError::from)?)
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Solves a problem without rolling: a die, a shift, a twist, a shift with partial slip.
///
/// path: a statics file, in TOML, as `creepage statics` takes it; with a line break in it, the text
///   itself.
/// report: room for size bytes, the report as JSON with a zero byte at its end; or NULL to ask for needed
///   only.
/// needed: becomes the number of bytes of the report, the zero byte with them. If size is smaller,
///   nothing is written to report and CREEPAGE_ROOM is returned.
///
/// # Safety
/// path ends with a zero byte; report, needed and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_statics(
    path: *const c_char,
    report: *mut c_char,
    size: usize,
    needed: *mut usize,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let path = unsafe { text("path", path) }?;
        // SAFETY: as before.
        let needed = unsafe { array_mut::<usize, 1>("needed", needed, 1) }?;
        let json = statics(path)?;
        needed.copy_from_slice(&[[json.len() + 1]]);
        // SAFETY: as before; bytes and C's characters have one size.
        let report: Option<&mut [[u8; 1]]> = unsafe { optional(report.cast::<u8>(), size) }?;
        let Some(report) = report else { return Ok(()) };
        let room = Failure::Room { size, needed: json.len() + 1 };
        let report = report.as_flattened_mut().get_mut(..=json.len()).ok_or(room)?;
        let (words, end) = report.split_at_mut(json.len());
        words.copy_from_slice(json.as_bytes());
        end.fill(0);
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

fn statics(path: &str) -> Result<String, Failure> {
    let text = if path.contains('\n') {
        path.to_owned()
    } else {
        let place = Path::new(path);
        fs::read_to_string(place).map_err(|source| Failure::Read { path: place.into(), source })?
    };
    let wrong = |error: StaticsError| Failure::Statics(Box::new(error));
    let solve = || StaticsFile::read(&text).map_err(StaticsError::from)?.solve();
    let case = solve().map_err(wrong)?;
    Ok(StaticsReport::new(&case).map_err(wrong)?.json().to_string())
}

/// # Safety
/// As of [`array`].
unsafe fn ellipse(semi_axes: *const f64) -> Result<Ellipse, Failure> {
    // SAFETY: the caller's promise is ours.
    let numbers = unsafe { array("semi_axes", semi_axes, 1, 2) }?;
    let &[a, b] = numbers else { return Err(Failure::Null("semi_axes")) };
    Ok(Ellipse::new(a, b)?)
}

fn edge(edge: i32) -> Result<Edge, Failure> {
    match edge {
        CREEPAGE_VANISHING => Ok(Edge::Vanishing),
        CREEPAGE_SINGULAR => Ok(Edge::Singular),
        other => Err(Failure::Invalid(creepage::InvalidValue {
            quantity: "edge",
            value: f64::from(other),
            valid: "CREEPAGE_VANISHING or CREEPAGE_SINGULAR",
        })),
    }
}

fn polynomials(given: &[f64], count: usize) -> Result<[Polynomial; 3], Failure> {
    let of = |k: usize| {
        let part = given.get(k * count..(k + 1) * count).unwrap_or_default();
        Polynomial::new(part.to_vec()).map_err(|error| Failure::from(ResponseError::from(error)))
    };
    Ok([of(0)?, of(1)?, of(2)?])
}

/// Three polynomials one behind the other, zero beyond their degree.
fn put(out: &mut [f64], room: usize, found: &[Polynomial; 3]) -> Result<(), Failure> {
    let needed = found.iter().map(|one| one.coefficients().len()).max().unwrap_or(0);
    if needed > room {
        return Err(Failure::Coefficients { room, needed });
    }
    out.fill(0.0);
    for (part, polynomial) in out.chunks_mut(room.max(1)).zip(found) {
        part[..polynomial.coefficients().len()].copy_from_slice(polynomial.coefficients());
    }
    Ok(())
}
