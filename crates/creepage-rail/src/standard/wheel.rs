//! Standard wheel profiles. Lengths in mm, as the standards print them.

use super::zones::Zone::{Down, Line, Polynomial, Up};
use super::zones::{Zone, profile};
use crate::{Profile, Role};

/// S1002: zones C and B, the throat and the tread.
const THROAT: [f64; 8] = [
    -4.320_221_063e3,
    -1.038_384_026e3,
    -1.065_501_873e2,
    -6.051_367_875,
    -2.054_332_446e-1,
    -4.169_739_389e-3,
    -4.687_195_829e-5,
    -2.252_755_540e-7,
];
const TREAD: [f64; 9] = [
    0.0,
    -3.358_537_058e-2,
    1.565_681_624e-3,
    -2.810_427_944e-5,
    5.844_240_864e-8,
    -1.562_379_023e-8,
    5.309_217_349e-15,
    -5.957_839_843e-12,
    2.646_656_573e-13,
];

/// The flange of S1002, zones H, G, F, and its face at 70 degrees.
const FLANGE: [Zone; 4] = [
    Down(-49.5, 9.519_259_302, 20.5),
    Down(-55.0, 16.0, 12.0),
    Down(-58.558_326_413, 8.834_924_130, 20.0),
    Line(-93.576_667_419, -2.747_477_419),
];
const FLANGE_BREAKS: [f64; 4] = [-70.0, -62.764_705_882, -49.662_510_381, -39.764_473_993];

pub(super) fn s1002() -> Profile {
    let breaks = [&FLANGE_BREAKS[..], &[-38.426_669_071, -35.0, -26.0, 32.157_96, 60.0]].concat();
    let zones = [
        &FLANGE[..],
        &[
            Up(-26.210_665, 16.446, 13.0),
            Polynomial(&THROAT, -30.0),
            Polynomial(&TREAD, 0.0),
            Line(1.364_323_640, -0.066_666_667),
        ],
    ]
    .concat();
    profile(Role::Wheel, &breaks, &zones)
}

/// A cone `z = -slope y` with the flange of S1002, joined by a fillet tangent to both.
pub(super) fn cone(slope: f64) -> Profile {
    const FILLET: f64 = 13.0;
    let (face, tread) = (FLANGE[3], Line(0.0, -slope));
    let [(z_face, m_face), (z_tread, m_tread)] = [face, tread].map(|line| match line {
        Line(z, m) => (z, m),
        _ => (0.0, 0.0),
    });
    let (g_face, g_tread) = (m_face.hypot(1.0), m_tread.hypot(1.0));
    // The centre lies the fillet's radius below both lines.
    let y = (z_tread - z_face + FILLET * (g_tread - g_face)) / (m_face - m_tread);
    let z = z_tread + m_tread * y + FILLET * g_tread;
    let [foot_face, foot_tread] = [m_face / g_face, m_tread / g_tread].map(|sin| y + FILLET * sin);
    let breaks = [&FLANGE_BREAKS[..], &[foot_face, foot_tread, 60.0]].concat();
    let zones = [&FLANGE[..], &[Up(y, z, FILLET), tread]].concat();
    profile(Role::Wheel, &breaks, &zones)
}

pub(super) fn en15302_a() -> Profile {
    let breaks = [
        -70.0, -62.7647, -49.6625, -39.7645, -38.7372, -29.4591, -10.8749, 18.4173, 30.0, 60.0,
        65.0,
    ];
    let zones = [
        Down(-49.5, 9.519_26, 20.5),
        Down(-55.0, 16.000_65, 12.0),
        Down(-58.5583, 8.835_56, 20.0),
        Line(-93.576_85, -2.7475),
        Up(-25.5816, 17.642_15, 14.0),
        Up(-2.6594, 97.164_93, 96.760_55),
        Up(18.4173, 344.508_06, 345.0),
        Line(-0.491_94, 0.0),
        Line(1.508_04, -0.066_666),
        Line(57.508_08, -1.0),
    ];
    profile(Role::Wheel, &breaks, &zones)
}

pub(super) fn en15302_b() -> Profile {
    let breaks =
        [-70.0, -62.7647, -49.6625, -39.764, -38.7879, -29.3505, -0.4787, 30.0, 60.0, 65.0];
    let zones = [
        Down(-49.5, 9.5193, 20.5),
        Down(-55.0, 16.0, 12.0),
        Down(-58.5583, 8.8349, 20.0),
        Line(-93.5767, -2.7475),
        Up(-25.6322, 17.7814, 14.0),
        Up(2.5204, 119.9745, 120.0),
        Line(0.0, -0.025),
        Line(0.75, -0.05),
        Line(57.75, -1.0),
    ];
    profile(Role::Wheel, &breaks, &zones)
}

pub(super) fn en15302_c() -> Profile {
    let breaks =
        [-70.0, -69.4027, -59.5, -43.8048, -41.0534, -32.3621, -17.587, 19.0, 29.0, 59.0, 65.0];
    let zones = [
        Line(515.217_477_191_6, 7.115_37),
        Down(-59.5, 20.000_06, 10.0),
        Down(-60.4941, 12.027_53, 18.0),
        Line(-89.650_195_736_921_49, -2.475_086_85),
        Up(-29.0, 16.830_365, 13.0),
        Up(-6.5, 100.870_534, 100.0),
        Up(19.0, 329.452_58, 330.0),
        Line(-0.547_423_74, 0.0),
        Line(2.352_576_26, -0.1),
        Line(55.452_576_26, -1.0),
    ];
    profile(Role::Wheel, &breaks, &zones)
}

pub(super) fn en15302_h() -> Profile {
    let breaks =
        [-70.0, -62.7647, -49.6625, -39.7645, -38.722, -28.3119, -10.2297, 30.0, 60.0, 65.0];
    let zones = [
        Down(-49.5, 9.5193, 20.5),
        Down(-55.0, 16.0, 12.0),
        Down(-58.5583, 8.8349, 20.0),
        Line(-93.5767, -2.7475),
        Up(-25.5663, 17.6003, 14.0),
        Line(-1.7902, -0.2),
        Line(0.0, -0.025),
        Line(1.251, -0.0667),
        Line(57.249, -1.0),
    ];
    profile(Role::Wheel, &breaks, &zones)
}

pub(super) fn en15302_i() -> Profile {
    let breaks = [-70.0, -62.7647, -49.6625, -39.764, -39.0486, -29.9231, 5.0, 30.0, 60.0, 65.0];
    let zones = [
        Down(-49.5, 9.519_29, 20.5),
        Down(-55.0, 16.000_54, 12.0),
        Down(-58.5583, 8.835_45, 20.0),
        Line(-93.5767, -2.7475),
        Up(-25.8929, 18.497_33, 14.0),
        Up(5.0, 119.895_788_082_818_09, 120.0),
        Line(-0.104_211_917_182_013_28, 0.0),
        Line(1.896_79, -0.0667),
        Line(57.894_79, -1.0),
    ];
    profile(Role::Wheel, &breaks, &zones)
}
