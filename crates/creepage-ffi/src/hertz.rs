//! C functions of Hertz contact: the contact ellipse of two bodies, and the field in it.

use std::ffi::c_char;

use creepage::subsurface::Body;
use creepage::{Hertz, HertzError, InvalidValue, Radii, Region, Solid, SolidPair};
use creepage_study::{Caution, Stresses};

use crate::bulk::CreepageCase;
use crate::failure::{Failure, guard};
use crate::input::{array, array_mut, handle, optional};
use crate::status::status;

/// The contact ellipse of two bodies and its pressure, by Hertz.
///
/// upper, lower: 4 numbers each: shear modulus (Pa), Poisson's ratio (1), radii of curvature along and
///   across the rolling direction (m), positive where convex, negative where hollow, infinite where
///   flat.
/// angle: from the upper body's rolling section to the lower's (degrees).
/// normal_force: N (N).
/// contact: room for 9 numbers: semi-axes along and across (m), peak pressure (Pa), approach (m),
///   curvature length rho (m), angle from the upper body's rolling direction to the first semi-axis
///   (degrees), combined shear modulus (Pa), combined Poisson's ratio (1), kappa (1).
/// status: room for one number, CREEPAGE_SOLVED, or CREEPAGE_CHECK_UNITS where a number looks like one
///   in another unit; or NULL.
///
/// # Safety
/// Arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_hertz(
    upper: *const f64,
    lower: *const f64,
    angle: f64,
    normal_force: f64,
    contact: *mut f64,
    status: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let (upper, lower) = unsafe { (body("upper", upper)?, body("lower", lower)?) };
        // SAFETY: as before.
        let out = unsafe { array_mut::<_, 9>("contact", contact, 1) }?;
        // SAFETY: as before.
        let status = unsafe { optional::<_, 1>(status, 1) }?;
        let pair = SolidPair::new(upper.0, lower.0);
        let hertz = Hertz::new(pair, upper.1, lower.1, angle.to_radians(), normal_force)?;
        let ellipse = hertz.ellipse();
        out[0] = [
            ellipse.a(),
            ellipse.b(),
            hertz.peak_pressure(),
            hertz.approach(),
            hertz.rho(),
            hertz.angle().to_degrees(),
            pair.shear_modulus(),
            pair.poisson(),
            pair.kappa(),
        ];
        if let Some(status) = status {
            let radii =
                [upper.1, lower.1].map(|radii| radii.rolling.abs().min(radii.lateral.abs()));
            let smallest = Some(radii[0].min(radii[1])).filter(|radius| radius.is_finite());
            let creepage = creepage::SiCreepage::default();
            status[0] = [self::status(&Caution::units(&hertz, smallest, creepage))];
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// A body of four numbers.
///
/// # Safety
/// As of [`array`].
unsafe fn body(name: &'static str, numbers: *const f64) -> Result<(Solid, Radii), Failure> {
    // SAFETY: the caller's promise is ours.
    let numbers = unsafe { array(name, numbers, 1, 4) }?;
    let &[shear_modulus, poisson, rolling, lateral] = numbers else {
        return Err(Failure::Null(name));
    };
    Ok((Solid::new(shear_modulus, poisson)?, Radii { rolling, lateral }))
}

impl From<HertzError> for Failure {
    fn from(error: HertzError) -> Self {
        match error {
            HertzError::Invalid(invalid) => Self::Invalid(invalid),
            other => Self::Hertz(other),
        }
    }
}

/// Pressure, traction and slip in the contact of a case, in SI units.
///
/// count: number of positions.
/// positions: 2 count numbers, x and y of each from the middle of the contact (m).
/// pressures: room for count numbers (Pa); or NULL.
/// tractions: room for 2 count numbers, along and across, of the upper body on the lower (Pa); or
///   NULL.
/// slips: room for 2 count numbers, velocity of the upper body relative to the lower over the rolling
///   velocity (1), NaN where the theory does not give it; or NULL.
/// regions: room for count numbers, CREEPAGE_ADHESION, CREEPAGE_SLIP, CREEPAGE_OUTSIDE; or NULL.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_case_field(
    made: *const CreepageCase,
    count: usize,
    positions: *const f64,
    pressures: *mut f64,
    tractions: *mut f64,
    slips: *mut f64,
    regions: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let case = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let positions = unsafe { array("positions", positions, count, 2) }?;
        // SAFETY: as before.
        let mut pressures = unsafe { optional::<_, 1>(pressures, count) }?;
        // SAFETY: as before.
        let mut tractions = unsafe { optional::<_, 2>(tractions, count) }?;
        // SAFETY: as before.
        let mut slips = unsafe { optional::<_, 2>(slips, count) }?;
        // SAFETY: as before.
        let mut regions = unsafe { optional::<_, 1>(regions, count) }?;
        let solved = case.solve()?;
        let scaling = solved.scaling();
        for (k, place) in positions.as_chunks::<2>().0.iter().enumerate() {
            let position = place.map(|x| x / scaling.length);
            let found = solved.field(&[position]);
            let Some(point) = found.first() else { continue };
            put(&mut pressures, k, [solved.pressure(position)]);
            put(&mut tractions, k, point.traction.map(|part| part * scaling.traction));
            put(&mut slips, k, point.slip.map(|part| part * scaling.slip));
            put(&mut regions, k, [region(point.region)]);
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// The lower body, such as a rail.
pub const CREEPAGE_LOWER: i32 = 0;
/// The upper body, such as a wheel.
pub const CREEPAGE_UPPER: i32 = 1;

/// Stress and displacement inside one body of a case.
///
/// body: CREEPAGE_LOWER or CREEPAGE_UPPER.
/// count: number of points.
/// points: 3 count numbers, x, y and z of each from the middle of the contact (m), z into that body.
/// stresses: room for 6 count numbers, xx, yy, zz, xy, yz, xz (Pa), positive in tension; or NULL.
/// displacements: room for 3 count numbers, u, v, w (m), w into the body; they vanish far away; or NULL.
/// settled: room for one number, the depth (m) less than which stresses depend on the elements of the
///   theory; or NULL.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_case_below(
    made: *const CreepageCase,
    body: i32,
    count: usize,
    points: *const f64,
    stresses: *mut f64,
    displacements: *mut f64,
    settled: *mut f64,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let case = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let points = unsafe { array("points", points, count, 3) }?;
        // SAFETY: as before.
        let mut stresses = unsafe { optional::<_, 6>(stresses, count) }?;
        // SAFETY: as before.
        let mut displacements = unsafe { optional::<_, 3>(displacements, count) }?;
        // SAFETY: as before.
        let mut settled = unsafe { optional::<_, 1>(settled, 1) }?;
        let solved = case.solve()?;
        let [upper, lower] = solved.case.solids();
        let (solid, body) = match body {
            CREEPAGE_LOWER => (lower, Body::Lower),
            CREEPAGE_UPPER => (upper, Body::Upper),
            other => {
                let (value, valid) = (f64::from(other), "CREEPAGE_LOWER or CREEPAGE_UPPER");
                return Err(InvalidValue { quantity: "body", value, valid }.into());
            }
        };
        let (interior, depth) = Stresses::interior(&solved, solid, body)?;
        put(&mut settled, 0, [depth]);
        for (k, point) in points.as_chunks::<3>().0.iter().enumerate() {
            let inside = interior.at(*point)?;
            put(&mut stresses, k, inside.stress.components());
            put(&mut displacements, k, inside.displacement);
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

fn put<T, const W: usize>(array: &mut Option<&mut [[T; W]]>, place: usize, value: [T; W]) {
    if let Some(array) = array {
        array[place] = value;
    }
}

/// The surfaces stick.
pub const CREEPAGE_ADHESION: i32 = 0;
/// The surfaces slip.
pub const CREEPAGE_SLIP: i32 = 1;
/// Outside the contact.
pub const CREEPAGE_OUTSIDE: i32 = 2;

fn region(region: Region) -> i32 {
    match region {
        Region::Adhesion => CREEPAGE_ADHESION,
        Region::Slip => CREEPAGE_SLIP,
        Region::Outside => CREEPAGE_OUTSIDE,
    }
}
