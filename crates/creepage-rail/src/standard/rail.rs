//! Standard rail profiles.

use super::RailHead;
use super::zones::Zone::Up;
use super::zones::profile;
use crate::{Profile, Role};

/// A head of arcs 300, 80 and 13 mm with sides 1:20, by the half chords of the first two (m).
pub(super) fn arcs_300_80_13(crown: f64, shoulder: f64) -> Profile {
    RailHead {
        arcs: vec![(0.300, crown), (0.080, shoulder)],
        corner: 0.013,
        side_slope: 0.05,
        depth: 0.030,
    }
    .built()
}

/// In mm, as the standard prints it.
pub(super) fn en15302_a() -> Profile {
    let breaks = [-32.634, -23.2401, -7.8749, 13.0989, 28.6709, 39.2705];
    let arcs = [
        Up(-19.639_49, 15.899_044, 13.0),
        Up(-1.0825, 80.277_908, 80.0),
        Up(17.5966, 299.483_49, 300.0),
        Up(14.298_29, 79.508_225, 80.0),
        Up(26.335_35, 13.598_369, 13.0),
    ];
    profile(Role::Rail, &breaks, &arcs)
}
