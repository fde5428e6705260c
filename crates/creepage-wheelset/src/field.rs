//! Element field of a contact: kept, or computed when it is asked for.

use std::borrow::Cow;
use std::sync::Arc;

use creepage::approximate::non_hertzian::NonHertzianSimplified;
use creepage::coulomb::{ElementField, TangentialWarmStart};

use super::curving::RigidMotion;

/// Tractions and slip of a contact that is solved.
#[derive(Debug, Clone)]
pub(crate) enum Field {
    Exact(Vec<ElementField>, Arc<TangentialWarmStart>),
    /// A simplified theory marches through its cells again, which costs less than to keep them.
    Simplified(Box<March>),
}

/// Simplified theory, and the motion that it was solved for.
#[derive(Debug, Clone)]
pub(crate) struct March {
    pub(crate) theory: Arc<NonHertzianSimplified>,
    pub(crate) motion: RigidMotion,
}

impl Field {
    /// From which a position close by may start.
    pub(crate) fn tractions(&self) -> Option<&Arc<TangentialWarmStart>> {
        match self {
            Self::Exact(_, tractions) => Some(tractions),
            Self::Simplified(_) => None,
        }
    }

    pub(crate) fn elements(&self) -> Cow<'_, [ElementField]> {
        match self {
            Self::Exact(elements, _) => Cow::Borrowed(elements),
            Self::Simplified(march) => {
                let March { theory, motion } = &**march;
                let solved = theory.solve_curved(motion.creepage, |y| motion.more([0.0, y]));
                Cow::Owned(solved.elements())
            }
        }
    }
}
