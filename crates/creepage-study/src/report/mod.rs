//! One report: a list of quantities, of any contact. Text, JSON, Python, C and the guide's table of keys are made from it;
//! a new quantity is one entry, in `of_contact.rs` or `of_case.rs`.

mod of_case;
mod of_contact;
mod part;
mod quantity;
mod unit;

#[cfg(test)]
mod tests;

pub use of_contact::{hertz_report, pressed_report};
pub use quantity::{Quantity, Report};
pub use unit::{PerUnit, Unit};

pub(crate) use of_contact::{method, words};
pub(crate) use part::ReportPart;
pub(crate) use quantity::{Section, Shown};
pub(crate) use unit::Written;
