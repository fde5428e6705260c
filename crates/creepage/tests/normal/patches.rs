//! A wheel S1002 on a rail UIC60 (1:40) in poses of the Manchester benchmark, A-2.2, right side:
//! own solutions on squares of 0.1 mm (flange 0.1 x 0.025 mm), good to .03 % of load.
//!
//! The gap is measured along the normal of a plane through the reference point. Poses are
//! printed to 50 nm, so the approach is the recorded penetration from the gap's least value.

use creepage::gap::Gap;
use creepage::normal::{NormalContact, Resolution};

use crate::support::{MM, function, steel};

/// Lateral shift, height, roll and yaw of the wheelset, a point of the plane and its angle;
/// penetration, load and peak pressure found; area of the squares in contact, of twice the size and
/// the finest; the width looked at (lengths in mm, angles in rad, forces in N, pressures in N/mm^2).
#[derive(Clone, Copy)]
struct Pose {
    wheelset: [f64; 4],
    plane: [f64; 4],
    penetration: f64,
    load: f64,
    peak: f64,
    areas: [f64; 2],
    width: [f64; 2],
}

fn horner(coefficients: &[f64], y: f64) -> f64 {
    coefficients.iter().fold(0.0, |sum, c| sum * y + c)
}

/// The wheel's profile by the formulas of UIC 510-2, flange at negative y.
fn wheel_profile(y: f64) -> f64 {
    let arc = |zc: f64, yc: f64, r: f64, sign: f64| zc + sign * (r * r - (y - yc).powi(2)).sqrt();
    if y < -49.662_510_381 {
        arc(16.0, -55.0, 12.0, 1.0)
    } else if y < -39.764_473_993 {
        arc(8.834_924_130, -58.558_326_413, 20.0, 1.0)
    } else if y < -38.426_669_071 {
        -93.576_667_419 - 2.747_477_419 * y
    } else if y < -35.0 {
        arc(16.446, -26.210_665, 13.0, -1.0)
    } else if y < -26.0 {
        const C: [f64; 8] = [
            -2.252_755_540e-7,
            -4.687_195_829e-5,
            -4.169_739_389e-3,
            -2.054_332_446e-1,
            -6.051_367_875,
            -1.065_501_873e2,
            -1.038_384_026e3,
            -4.320_221_063e3,
        ];
        horner(&C, y)
    } else {
        const B: [f64; 9] = [
            2.646_656_573e-13,
            -5.957_839_843e-12,
            5.309_217_349e-15,
            -1.562_379_023e-8,
            5.844_240_864e-8,
            -2.810_427_944e-5,
            1.565_681_624e-3,
            -3.358_537_058e-2,
            0.0,
        ];
        horner(&B, y)
    }
}

/// The rail's head from its arcs 300, 80 and 13, before it is canted.
fn head(y: f64) -> f64 {
    let y = y.abs();
    let root = |x: f64| (1.0 - x * x).sqrt();
    let shoulder = [220.0 * 10.5 / 300.0, 300.0 - 220.0 * root(10.5 / 300.0)];
    let n = (25.988 - shoulder[0]) / 80.0;
    let corner = [shoulder[0] + 67.0 * n, shoulder[1] - 67.0 * root(n)];
    let ([yc, zc], r) = if y < 10.5 {
        ([0.0, 300.0], 300.0)
    } else if y < 25.988 {
        (shoulder, 80.0)
    } else {
        (corner, 13.0)
    };
    zc - r * root(((y - yc) / r).min(1.0))
}

/// A point of the canted rail in the track, its highest point at y = 760.5379, z = 0.
fn rail(parameter: f64) -> [f64; 2] {
    let (sin, cos) = (1.0_f64 / 40.0).atan().sin_cos();
    let canted = |y: f64| [y * cos + head(y) * sin, head(y) * cos - y * sin];
    // The highest point lies where the crown's tangent is level.
    let highest = canted(300.0 * sin);
    let [y, z] = canted(parameter);
    [760.5379 + y - highest[0], z - highest[1]]
}

impl Pose {
    fn in_plane(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.plane[3].sin_cos();
        let (y, z) = (y - self.plane[1], z - self.plane[2]);
        [y * cos + z * sin, z * cos - y * sin]
    }

    fn wheel(&self, v: f64, turn: f64) -> [f64; 3] {
        let [shift, height, roll, yaw] = self.wheelset;
        let radius = 460.0 + wheel_profile(v);
        let (x, y, z) = (radius * turn.sin(), 750.0 + v, radius * turn.cos());
        let (y, z) = (y * roll.cos() - z * roll.sin(), y * roll.sin() + z * roll.cos());
        let (x, y) = (x * yaw.cos() - y * yaw.sin(), x * yaw.sin() + y * yaw.cos());
        [x, shift + y, height - 460.0 + z]
    }

    /// Height of the rail over the plane at s: bisection along the profile.
    fn rail_height(&self, s: f64) -> f64 {
        let (mut low, mut high) = (-35.9, 35.9);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let below = self.in_plane(rail(middle))[0] < s;
            *(if below { &mut low } else { &mut high }) = middle;
        }
        self.in_plane(rail(low))[1]
    }

    /// Height of the wheel over the plane at x and s: Newton on its two parameters.
    fn wheel_height(&self, x: f64, s: f64) -> f64 {
        const STEP: f64 = 1e-5;
        let miss = |v: f64, turn: f64| {
            let [px, y, z] = self.wheel(v, turn);
            [px - self.plane[0] - x, self.in_plane([y, z])[0] - s]
        };
        let mut v = self.plane[1] + s * self.plane[3].cos() - self.wheelset[0] - 750.0;
        let mut turn = (self.plane[0] + x) / 460.0;
        for _ in 0..30 {
            let here = miss(v, turn);
            let (by_v, by_turn) = (miss(v + STEP, turn), miss(v, turn + STEP));
            let [[a, c], [b, d]] =
                [by_v, by_turn].map(|there| [0, 1].map(|i| (there[i] - here[i]) / STEP));
            let determinant = a * d - b * c;
            let change = (d * here[0] - b * here[1]) / determinant;
            v -= change;
            turn -= (a * here[1] - c * here[0]) / determinant;
            if change.abs() < 1e-10 {
                break;
            }
        }
        let [_, y, z] = self.wheel(v, turn);
        self.in_plane([y, z])[1]
    }

    fn height(&self, x: f64, s: f64) -> f64 {
        self.rail_height(s) - self.wheel_height(x, s)
    }

    fn least(&self) -> f64 {
        // The gauge corner's curvature of 1/13 mm between places 20 um apart hides 4 nm.
        const PLACES: i32 = 700;
        let [low, high] = self.width;
        let s = |i: i32| low + (high - low) * f64::from(i) / f64::from(PLACES);
        // A contact turned against the plane is nearest away from x = 0.
        let row = |i: i32| (-10..=10).map(move |k| self.height(0.1 * f64::from(k), s(i)));
        (0..=PLACES).flat_map(row).fold(f64::INFINITY, f64::min)
    }

    fn gap(self) -> Gap {
        function([-12.0, 12.0], self.width, move |x, s| self.height(x, s))
    }
}

const POSES: [Pose; 11] = [
    Pose {
        wheelset: [0.0, 0.1981, 0.0, 0.0],
        plane: [0.0, 751.8726, 0.1252, -0.029],
        penetration: 0.015_965_9,
        load: 10_002.25,
        peak: 338.32,
        areas: [51.56, 51.14],
        width: [-14.0, 14.0],
    },
    Pose {
        wheelset: [5.0, 0.0015, -0.000_355_4, 0.012],
        plane: [-6.9999, 727.0855, 3.0041, -0.2905],
        // From squares of 0.2 and 0.1 mm, whose errors fall with the square of their size: the
        // penetration is that at the deepest middle of a square, 27.1845 and 27.3302 um.
        penetration: 0.027_378_8,
        load: 9_093.6,
        peak: 1_579.5,
        areas: [13.8, 13.44],
        width: [-3.0, 15.0],
    },
    Pose {
        wheelset: [6.0, -0.1961, -0.000_627_2, 0.0144],
        plane: [-7.3822, 725.1371, 3.6882, -0.4176],
        penetration: 0.027_301_2,
        load: 9_628.73,
        peak: 1_146.94,
        areas: [12.98, 12.915],
        width: [-2.5, 5.0],
    },
    Pose {
        wheelset: [1.0, 0.1839, -5.049e-5, 0.0024],
        plane: [-1.7013, 741.9908, 0.5753, -0.0696],
        penetration: 0.024_496_2,
        load: 9_817.12,
        peak: 741.90,
        areas: [24.12, 24.015],
        width: [-11.0, 11.0],
    },
    Pose {
        wheelset: [2.0, 0.1529, -0.000_112_8, 0.0048],
        plane: [-3.3682, 740.9147, 0.6548, -0.0806],
        penetration: 0.024_827_3,
        load: 9_809.10,
        peak: 745.01,
        areas: [20.02, 19.895],
        width: [-11.0, 11.0],
    },
    Pose {
        wheelset: [3.0, 0.1143, -0.000_180_3, 0.0072],
        plane: [-4.999, 739.9698, 0.7367, -0.0923],
        penetration: 0.024_413_0,
        load: 9_782.35,
        peak: 713.72,
        areas: [20.84, 20.71],
        width: [-11.0, 11.0],
    },
    Pose {
        wheelset: [4.0, 0.0676, -0.000_255_7, 0.0096],
        plane: [-6.5746, 738.7381, 0.8604, -0.1078],
        penetration: 0.023_718_9,
        load: 9_741.90,
        peak: 664.79,
        areas: [22.32, 22.235],
        width: [-7.0, 7.0],
    },
    Pose {
        wheelset: [7.0, -4.5809, -0.006_393, 0.0168],
        plane: [2.3584, 719.0445, 9.2525, -1.0634],
        penetration: 0.035_939_3,
        load: 14_131.35,
        peak: 2_599.22,
        areas: [8.41, 8.263],
        width: [-2.0, 2.0],
    },
    Pose {
        wheelset: [8.0, -6.2615, -0.008_606, 0.0192],
        plane: [-0.9036, 719.8316, 8.0092, -0.9501],
        penetration: 0.035_144_1,
        load: 12_800.35,
        peak: 2_600.36,
        areas: [7.56, 7.458],
        width: [-2.0, 2.0],
    },
    Pose {
        wheelset: [9.0, -7.3919, -0.0101, 0.0216],
        plane: [-3.2265, 720.4903, 7.1643, -0.8676],
        penetration: 0.034_539_7,
        load: 11_996.33,
        peak: 2_596.31,
        areas: [7.11, 7.035],
        width: [-2.0, 2.0],
    },
    Pose {
        wheelset: [10.0, -8.2668, -0.011_26, 0.024],
        plane: [-5.2821, 721.088, 6.5066, -0.7992],
        penetration: 0.034_427_7,
        load: 11_611.61,
        peak: 2_605.60,
        areas: [6.87, 6.79],
        width: [-2.0, 2.0],
    },
];

#[test]
fn a_real_wheel_on_a_real_rail() {
    for pose in POSES {
        let approach = (pose.least() + pose.penetration) * MM;
        let contact =
            NormalContact::at_approach(&pose.gap(), steel(), approach, Resolution::STANDARD)
                .unwrap();
        // Squares count as in contact by their middles: the area lacks in proportion to their size.
        let area = 2.0 * pose.areas[1] - pose.areas[0];
        let found = [
            contact.load().value,
            contact.peak_pressure().value / 1e6,
            contact.area().value / (MM * MM),
        ];
        let off = [found[0] / pose.load, found[1] / pose.peak, found[2] / area].map(|r| r - 1.0);
        let shift = pose.wheelset[0];
        println!("{shift:4} mm: load {:+.4} peak {:+.4} area {:+.4}", off[0], off[1], off[2]);
        // The squares give the area to about 1 %.
        assert!(off[0].abs() < 1e-3 && off[1].abs() < 5e-3 && off[2].abs() < 0.01, "{shift} mm");
    }
}
