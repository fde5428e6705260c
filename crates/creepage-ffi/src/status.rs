//! Status codes of forces in C.

use creepage::Status;
use creepage_study::Caution;

/// The theory's equations are solved.
pub const CREEPAGE_SOLVED: i32 = 0;
/// The iteration ended before its tolerance was met.
pub const CREEPAGE_NOT_CONVERGED: i32 = 1;
/// Solved, but creepage is too small for the theory's resolution.
pub const CREEPAGE_CREEPAGE_TOO_SMALL: i32 = 2;
/// Solved, but spin is beyond the bound up to which the theory holds.
pub const CREEPAGE_SPIN_TOO_LARGE: i32 = 3;
/// A status that this version of the interface does not know.
pub const CREEPAGE_DOUBTFUL: i32 = 4;
/// Solved, but as if the bodies were alike: their difference matters, and only "exact" counts it.
pub const CREEPAGE_UNLIKE_BODIES: i32 = 5;
/// Solved, but the error bars of the force are larger than the accuracy that was asked for.
pub const CREEPAGE_ACCURACY_NOT_REACHED: i32 = 6;

/// Solved, but a number looks like one in another unit: the contact is too large for its bodies, the
/// pressure above the shear modulus, or a creepage above 0.3.
pub const CREEPAGE_CHECK_UNITS: i32 = 7;
/// The values are no case, such as NaN; their numbers are NaN.
pub const CREEPAGE_NO_CASE: i32 = 8;
/// No load presses the bodies together: no contact, and no force.
pub const CREEPAGE_NO_CONTACT: i32 = 9;
/// Solved from friction at rest, but friction falls so steeply that another solution exists.
pub const CREEPAGE_SEVERAL_SOLUTIONS: i32 = 10;

/// The first caution about a solution; there is one number for each case.
pub(crate) fn status(cautions: &[Caution]) -> i32 {
    match cautions.first() {
        None => CREEPAGE_SOLVED,
        Some(Caution::Status(Status::NotConverged)) => CREEPAGE_NOT_CONVERGED,
        Some(Caution::Status(Status::CreepageTooSmall)) => CREEPAGE_CREEPAGE_TOO_SMALL,
        Some(Caution::Status(Status::SpinTooLarge)) => CREEPAGE_SPIN_TOO_LARGE,
        Some(Caution::Status(Status::NoContact)) => CREEPAGE_NO_CONTACT,
        Some(Caution::Status(Status::SeveralSolutions)) => CREEPAGE_SEVERAL_SOLUTIONS,
        Some(Caution::Dissimilar { .. } | Caution::OneWay { .. }) => CREEPAGE_UNLIKE_BODIES,
        Some(Caution::Accuracy { .. }) => CREEPAGE_ACCURACY_NOT_REACHED,
        Some(caution) if caution.is_of_units() => CREEPAGE_CHECK_UNITS,
        Some(_) => CREEPAGE_DOUBTFUL,
    }
}
