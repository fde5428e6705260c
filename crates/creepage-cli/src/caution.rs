//! What to say beside a solution that is less than solved.

use creepage::rolling::Status;

/// Words of caution, if the status asks for any.
pub(crate) fn caution(status: Status) -> Option<&'static str> {
    match status {
        Status::Solved => None,
        Status::NotConverged => Some("did not converge: the force is that of the last iterate"),
        Status::CreepageTooSmall => Some("the creepage is too small for the theory's resolution"),
        Status::SpinTooLarge => Some("the spin is beyond the bound up to which the theory holds"),
        other => Some(other.name()),
    }
}
