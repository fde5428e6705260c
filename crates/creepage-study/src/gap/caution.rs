//! What is to be held against a solution.

use std::fmt;

use creepage::gap::Gap;
use creepage::normal::{self, NormalContact, Patch};
use creepage::{SiCreepage, Status};
use creepage_plot::format::{quantity, significant};
use creepage_rail::Role;

use crate::Caution;

/// What is to be held against the solution of a contact of any shape; in words by
/// [`Display`](fmt::Display).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum GapCaution {
    /// What may be held against any contact: the equations of rolling were not solved, or a number
    /// looks like one in another unit.
    Common(Caution),
    /// The equations of the pressure were solved only up to a residual.
    Pressure {
        /// Largest distance of a pressed point from touching, over the greatest depth.
        residual: f64,
    },
    /// Few points of the given gap lie in a contact area.
    CoarseGap {
        /// The fewest points across an area.
        points: usize,
        /// `x` or `y`.
        along: &'static str,
    },
    /// The slip that the pressure causes between unlike bodies is left out.
    Dissimilar {
        /// How unlike the bodies are.
        kappa_over_mu: f64,
    },
    /// A measured profile has short waves where it touches.
    Rough {
        /// The wheel or the rail.
        body: Role,
        /// Mean length of the waves (m).
        length: f64,
        /// How far the profile turns from one side of a wave to the other (rad).
        swing: f64,
        /// Pressure on their crests that presses them flat (Pa).
        pressure: f64,
    },
}

impl GapCaution {
    /// With fewer points across an area, it depends on how one interpolates.
    const POINTS: usize = 10;

    pub(crate) fn all(
        contact: &NormalContact,
        friction: f64,
        creepage: SiCreepage,
        status: Status,
    ) -> Vec<Self> {
        let rolling = (status != Status::Solved).then_some(Caution::Status(status));
        let (peak, shear_modulus) = (contact.peak_pressure().value, contact.pair().shear_modulus());
        let common = rolling.into_iter().chain(Caution::high_pressure(peak, shear_modulus));
        let common = common.chain(Caution::large_creepage(creepage)).map(Self::Common);
        let pressure = match contact.status() {
            normal::Status::Converged => None,
            normal::Status::NotConverged { residual } => Some(Self::Pressure { residual }),
        };
        let kappa_over_mu = contact.pair().kappa() / friction;
        let unlike = (kappa_over_mu.abs() >= Caution::DISSIMILAR)
            .then_some(Self::Dissimilar { kappa_over_mu });
        let coarse = ["x", "y"].into_iter().zip(contact.gap_points()).filter_map(|(along, n)| {
            n.filter(|n| *n < Self::POINTS).map(|points| Self::CoarseGap { points, along })
        });
        common.chain(pressure).chain(unlike).chain(coarse).collect()
    }

    /// Whether it says what another does: the numbers of a rough profile matter once.
    pub(crate) fn says(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Rough { body, .. }, Self::Rough { body: of, .. }) => body == of,
            _ => self == other,
        }
    }

    /// Contact areas that are large beside the radius of the gap in them.
    pub(super) fn large_areas(gap: &Gap, contact: &NormalContact) -> Option<Self> {
        let widths = contact.patches().iter().flat_map(|patch| half_widths(gap, patch));
        let mut large = widths.filter_map(|(width, radius)| Caution::large_contact(width, radius));
        large.next().map(Self::Common)
    }
}

/// Along and across, half the width of an area and the radius of the gap in it: that of the parabola
/// through the middle and both ends.
fn half_widths(gap: &Gap, patch: &Patch) -> [(f64, f64); 2] {
    let extent = patch.extent();
    let [x, y] = [extent.x, extent.y].map(|[low, high]| f64::midpoint(low, high));
    let middle = gap.at(x, y);
    let [along, across] =
        [extent.x.map(|end| gap.at(end, y) - middle), extent.y.map(|end| gap.at(x, end) - middle)];
    [(extent.size()[0], along), (extent.size()[1], across)].map(|(size, [one, other])| {
        let half = 0.5 * size;
        // A gap that is hollow there has none.
        (half, half * half / (one + other).max(0.0))
    })
}

impl fmt::Display for GapCaution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Common(caution) => caution.fmt(f),
            Self::Pressure { residual } => write!(
                f,
                "the pressure did not converge: pressed points are up to {residual:.1e} of the \
                 depth from touching"
            ),
            Self::CoarseGap { points, along } => write!(
                f,
                "[gap] has only {points} points along {along} across a contact area: with fewer \
                 than {} the area depends on the interpolation",
                Self::POINTS
            ),
            Self::Dissimilar { kappa_over_mu } => write!(
                f,
                "with [gap] the bodies are taken for like ones (kappa/mu = {kappa_over_mu:.3}): \
                 the slip by the pressure is left out, and for that the force may be off by some \
                 {:.0} % of mu N",
                100.0 * kappa_over_mu.abs().min(1.0)
            ),
            Self::Rough { body, length, swing, pressure } => write!(
                f,
                "the {body}'s profile is rough: in the contact it turns to and fro by {} mrad in waves \
                 of {} mm, which only {} would press flat, and its crests carry the load; unless it \
                 is so, smooth it ([{body}] reading = {{ smooth = ... }}, 5 to 10 times that length)",
                significant(1e3 * swing, 2),
                significant(1e3 * length, 2),
                quantity(pressure, "Pa", 2)
            ),
        }
    }
}
