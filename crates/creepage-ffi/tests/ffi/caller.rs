//! What callers from C write around the functions.

use std::ffi::{CStr, CString, c_char};
use std::ptr::null_mut;

use creepage::{Contact, Creepage, Ellipse};
use creepage_ffi::*;

/// Room for a message, and what was written to it.
pub(crate) struct Message(pub(crate) [c_char; 256]);

impl Message {
    pub(crate) fn new() -> Self {
        Self([0x55; 256])
    }

    pub(crate) fn text(&self) -> String {
        assert!(self.0.contains(&0));
        // SAFETY: there is a zero.
        unsafe { CStr::from_ptr(self.0.as_ptr()) }.to_str().unwrap().into()
    }
}

/// The contact of most tests.
pub(crate) fn contact() -> Contact {
    Contact::new(Ellipse::from_ratio(1.5).unwrap(), 0.28).unwrap()
}

/// The creepages of an array.
pub(crate) fn creepages(cases: &[f64]) -> impl Iterator<Item = Creepage> {
    cases.as_chunks().0.iter().map(|&[xi, eta, chi]| Creepage::new(xi, eta, chi).unwrap())
}

pub(crate) fn new(name: &str, options: &str, a_over_b: f64) -> (i32, *mut CreepageTheory, String) {
    between(name, options, a_over_b, 0.0)
}

pub(crate) fn between(
    name: &str,
    options: &str,
    a_over_b: f64,
    kappa_over_mu: f64,
) -> (i32, *mut CreepageTheory, String) {
    let (name, options) = (CString::new(name).unwrap(), CString::new(options).unwrap());
    let (mut theory, mut message) = (null_mut(), Message::new());
    // SAFETY: all point to what they should.
    let code = unsafe {
        let (name, options) = (name.as_ptr(), options.as_ptr());
        creepage_theory_new(
            name,
            options,
            a_over_b,
            0.28,
            kappa_over_mu,
            &raw mut theory,
            message.0.as_mut_ptr(),
            256,
        )
    };
    (code, theory, message.text())
}

/// A theory that frees itself.
pub(crate) struct Owned(pub(crate) *mut CreepageTheory);

// SAFETY: the interface says that a handle may be used by many threads.
unsafe impl Sync for Owned {}

impl Owned {
    pub(crate) fn new(name: &str, options: &str) -> Self {
        Self::between(name, options, 0.0)
    }

    pub(crate) fn between(name: &str, options: &str, kappa_over_mu: f64) -> Self {
        let (code, theory, message) = between(name, options, 1.5, kappa_over_mu);
        assert_eq!((code, &message[..]), (CREEPAGE_OK, ""));
        assert!(!theory.is_null());
        Self(theory)
    }

    pub(crate) fn force(&self, creepages: &[f64]) -> (i32, Vec<f64>, Vec<i32>, String) {
        let count = creepages.len() / 3;
        let (mut forces, mut statuses) = (vec![9.0; 3 * count], vec![9; count]);
        let mut message = Message::new();
        // SAFETY: all point to what they should.
        let code = unsafe {
            creepage_theory_force(
                self.0,
                count,
                creepages.as_ptr(),
                forces.as_mut_ptr(),
                null_mut(),
                null_mut(),
                statuses.as_mut_ptr(),
                message.0.as_mut_ptr(),
                256,
            )
        };
        (code, forces, statuses, message.text())
    }
}

impl Drop for Owned {
    fn drop(&mut self) {
        // SAFETY: made by the library, and not used again.
        unsafe { creepage_theory_free(self.0) }
    }
}

/// Three creepages: some slip, much slip, none.
pub(crate) const CASES: [f64; 9] = [0.5, 0.2, 0.1, -3.0, 1.0, 4.0, 0.0, 0.0, 0.0];

/// A wheel on a rail, without creepage.
pub(crate) const WHEEL: &str = r#"
[upper]
shear_modulus = 82e9
poisson = 0.28
radius_rolling = 0.46
radius_lateral = "flat"
[lower]
shear_modulus = 82e9
poisson = 0.28
radius_rolling = "flat"
radius_lateral = 0.3
[contact]
normal_force = 80e3
friction = 0.3
"#;
