//! User-defined integrand, `f(x, y, a, b, T, S)` of 5.22, in place of `T S`.

use std::fmt;
use std::sync::Arc;

use super::VariationalError;
use super::integrand::{self, Integrand, IntegrandTerms, State};

/// Arguments that an integrand may depend on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegrandArguments {
    /// `(x, y)` in units of `c = sqrt(a b)`.
    pub position: [f64; 2],
    /// `(a, b)` in units of `c`.
    pub semi_axes: [f64; 2],
    /// Distance squared of the traction over its bound from the slip's direction (5.6).
    pub t: f64,
    /// Slip squared, in units of `(mu f00)^2` (5.6).
    pub s: f64,
}

type Part = fn(&IntegrandTerms) -> f64;
type Function = dyn Fn(IntegrandArguments) -> IntegrandTerms + Send + Sync;

/// The user's function.
#[derive(Clone)]
pub(super) struct OwnIntegrand {
    function: Arc<Function>,
    semi_axes: [f64; 2],
}

impl fmt::Debug for OwnIntegrand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OwnIntegrand").field("semi_axes", &self.semi_axes).finish_non_exhaustive()
    }
}

impl OwnIntegrand {
    /// Takes `function` once its derivatives agree with differences at `positions`.
    pub(super) fn new(
        function: Arc<Function>,
        semi_axes: [f64; 2],
        positions: &[[f64; 2]],
    ) -> Result<Self, VariationalError> {
        let own = Self { function, semi_axes };
        for &position in positions {
            own.check_at(position)?;
        }
        Ok(own)
    }

    /// `f` at the place of a traction and slip, with its derivatives by these.
    pub(super) fn with_derivatives(&self, position: [f64; 2], state: State) -> Integrand {
        let [t, s] = integrand::t_and_s(state);
        integrand::of_terms(state, &self.terms(position, t, s))
    }

    pub(super) fn value(&self, position: [f64; 2], t: f64, s: f64) -> f64 {
        self.terms(position, t, s).f
    }

    fn terms(&self, position: [f64; 2], t: f64, s: f64) -> IntegrandTerms {
        (self.function)(IntegrandArguments { position, semi_axes: self.semi_axes, t, s })
    }

    fn check_at(&self, position: [f64; 2]) -> Result<(), VariationalError> {
        for t in [0.02, 0.3, 1.1] {
            for s in [0.03, 0.4, 1.7] {
                self.check_terms(position, t, s)?;
            }
        }
        Ok(())
    }

    /// Holds each derivative against the central difference of what it derives from.
    fn check_terms(&self, position: [f64; 2], t: f64, s: f64) -> Result<(), VariationalError> {
        /// Steps relative to `T` and `S`: difference quotients are then good to about 1e-10 of
        /// the quotient for anything like a power.
        const DIFFERENCE_STEP: f64 = 1e-5;
        const TOLERANCE: f64 = 1e-6;
        let terms = |t, s| self.terms(position, t, s);
        let here = terms(t, s);
        let by_t = [terms(t * (1.0 - DIFFERENCE_STEP), s), terms(t * (1.0 + DIFFERENCE_STEP), s)];
        let by_s = [terms(t, s * (1.0 - DIFFERENCE_STEP)), terms(t, s * (1.0 + DIFFERENCE_STEP))];
        let f: Part = |terms| terms.f;
        let f_t: Part = |terms| terms.t;
        let f_s: Part = |terms| terms.s;
        for (name, given, part, [low, high], at) in [
            ("f*", here.t, f, by_t, t),
            ("f.", here.s, f, by_s, s),
            ("f**", here.tt, f_t, by_t, t),
            ("f*.", here.ts, f_t, by_s, s),
            ("f..", here.ss, f_s, by_s, s),
        ] {
            let difference = (part(&high) - part(&low)) / (2.0 * DIFFERENCE_STEP * at);
            let size = part(&here).abs() / at + given.abs();
            let agrees = (given - difference).abs() <= TOLERANCE * size;
            if !(agrees && here.f.is_finite() && given.is_finite()) {
                return Err(VariationalError::Derivative { name, given, difference, t, s });
            }
        }
        Ok(())
    }
}
