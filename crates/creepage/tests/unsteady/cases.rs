//! Numbers of the full theory by an independent program on square grids, extrapolated, with their
//! uncertainty: CONTACT (Vollebregt, open source, v25.2), grids of 24 to 96 elements, the step tied to
//! the grid.

#![allow(clippy::unreadable_literal)] // as the program printed them

/// Distances rolled, over the semi-axis.
pub(crate) const STATIONS: [f64; 12] =
    [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 3.5, 4.0];

/// A quantity at the stations, and its uncertainty.
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) values: [f64; 12],
    pub(crate) uncertainty: [f64; 12],
}

/// One history, from zero traction or from a shift by a longitudinal force.
pub(crate) struct Case {
    pub(crate) id: &'static str,
    pub(crate) a_over_b: f64,
    pub(crate) shift: f64,
    pub(crate) creepage: [f64; 3],
    /// Held in place of the longitudinal creepage where it is not zero.
    pub(crate) force: f64,
    pub(crate) rows: &'static [Row],
}

/// Poisson's ratio of all.
pub(crate) const POISSON: f64 = 0.28;

pub(crate) const CASES: &[Case] = &[
    Case {
        id: "T1_zero_0.5_0_0",
        a_over_b: 1.0,
        shift: 0.000,
        creepage: [0.5, 0.0, 0.0],
        force: 0.000,
        rows: &[Row {
            name: "fx",
            values: [
                0.07500, 0.14276, 0.20325, 0.25621, 0.30159, 0.33913, 0.36863, 0.39092, 0.42245,
                0.44242, 0.45500, 0.46291,
            ],
            uncertainty: [
                0.0003, 0.0003, 0.0003, 0.0003, 0.0004, 0.0005, 0.0006, 0.0007, 0.0008, 0.0009,
                0.0010, 0.0010,
            ],
        }],
    },
    Case {
        id: "T1_zero_0_0.5_0",
        a_over_b: 1.0,
        shift: 0.000,
        creepage: [0.0, 0.5, 0.0],
        force: 0.000,
        rows: &[
            Row {
                name: "fy",
                values: [
                    0.07467, 0.14144, 0.20031, 0.25102, 0.29349, 0.32748, 0.35281, 0.37056,
                    0.39404, 0.40773, 0.41563, 0.42012,
                ],
                uncertainty: [
                    0.0003, 0.0003, 0.0003, 0.0004, 0.0005, 0.0006, 0.0007, 0.0008, 0.0009, 0.0010,
                    0.0010, 0.0011,
                ],
            },
            Row {
                name: "mz",
                values: [
                    -0.00395, -0.01443, -0.02958, -0.04712, -0.06499, -0.08086, -0.09241, -0.09911,
                    -0.10748, -0.11238, -0.11521, -0.11680,
                ],
                uncertainty: [
                    0.0003, 0.0003, 0.0003, 0.0003, 0.0004, 0.0004, 0.0003, 0.0003, 0.0003, 0.0003,
                    0.0003, 0.0003,
                ],
            },
        ],
    },
    Case {
        id: "T1_shift0.6_0.5_0_0",
        a_over_b: 1.0,
        shift: 0.600,
        creepage: [0.5, 0.0, 0.0],
        force: 0.000,
        rows: &[Row {
            name: "fx",
            values: [
                0.61181, 0.61423, 0.60712, 0.58936, 0.56259, 0.54351, 0.52974, 0.51908, 0.50357,
                0.49352, 0.48719, 0.48321,
            ],
            uncertainty: [
                0.0004, 0.0003, 0.0003, 0.0005, 0.0006, 0.0007, 0.0008, 0.0009, 0.0010, 0.0011,
                0.0011, 0.0011,
            ],
        }],
    },
    Case {
        id: "T0.5_zero_0.9_0_0",
        a_over_b: 0.5,
        shift: 0.000,
        creepage: [0.9, 0.0, 0.0],
        force: 0.000,
        rows: &[Row {
            name: "fx",
            values: [
                0.11029, 0.21034, 0.29977, 0.37840, 0.44581, 0.50160, 0.54549, 0.58014, 0.63067,
                0.66343, 0.68448, 0.69803,
            ],
            uncertainty: [
                0.0003, 0.0003, 0.0003, 0.0004, 0.0005, 0.0007, 0.0008, 0.0009, 0.0010, 0.0011,
                0.0012, 0.0012,
            ],
        }],
    },
    Case {
        id: "T0.5_zero_0_0_1",
        a_over_b: 0.5,
        shift: 0.000,
        creepage: [0.0, 0.0, 1.0],
        force: 0.000,
        rows: &[
            Row {
                name: "fy",
                values: [
                    0.00664, 0.02368, 0.04748, 0.07480, 0.10287, 0.12940, 0.15251, 0.17088,
                    0.19683, 0.21439, 0.22632, 0.23426,
                ],
                uncertainty: [
                    0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0004, 0.0005, 0.0006, 0.0007,
                    0.0008, 0.0009,
                ],
            },
            Row {
                name: "mz",
                values: [
                    0.14533, 0.24550, 0.31011, 0.34816, 0.36738, 0.37448, 0.37535, 0.37462,
                    0.37243, 0.36917, 0.36609, 0.36373,
                ],
                uncertainty: [
                    0.0005, 0.0005, 0.0006, 0.0008, 0.0008, 0.0009, 0.0009, 0.0010, 0.0011, 0.0011,
                    0.0011, 0.0011,
                ],
            },
        ],
    },
    Case {
        id: "T1_shift0.6_0_0_0",
        a_over_b: 1.0,
        shift: 0.600,
        creepage: [0.0, 0.0, 0.0],
        force: 0.000,
        rows: &[Row {
            name: "fx",
            values: [
                0.54747, 0.49311, 0.43726, 0.37988, 0.32014, 0.26222, 0.21619, 0.17933, 0.12413,
                0.08566, 0.05885, 0.04043,
            ],
            uncertainty: [
                0.0005, 0.0004, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003,
                0.0003, 0.0003,
            ],
        }],
    },
    Case {
        id: "T1_shift-0.6_0.5_0_0",
        a_over_b: 1.0,
        shift: -0.600,
        creepage: [0.5, 0.0, 0.0],
        force: 0.000,
        rows: &[Row {
            name: "fx",
            values: [
                -0.48088, -0.36510, -0.25307, -0.14537, -0.04220, 0.05675, 0.14673, 0.22005,
                0.31712, 0.37576, 0.41318, 0.43662,
            ],
            uncertainty: [
                0.0004, 0.0003, 0.0003, 0.0003, 0.0003, 0.0004, 0.0004, 0.0005, 0.0007, 0.0008,
                0.0009, 0.0009,
            ],
        }],
    },
    Case {
        id: "T0.5_shift0.657_F0.657",
        a_over_b: 0.5,
        shift: 0.657,
        creepage: [0.0, 0.0, 0.0],
        force: 0.657,
        rows: &[Row {
            name: "xi",
            values: [
                0.53058, 0.60838, 0.70430, 0.85780, 0.79813, 0.77665, 0.77504, 0.78014, 0.78352,
                0.78234, 0.78275, 0.78268,
            ],
            uncertainty: [
                0.0036, 0.0064, 0.0034, 0.0114, 0.0060, 0.0019, 0.0023, 0.0024, 0.0022, 0.0023,
                0.0023, 0.0023,
            ],
        }],
    },
];

/// A shift without rolling: `a/b`, Poisson's ratio, force, shift over `a` and its uncertainty.
pub(crate) struct Shift {
    pub(crate) a_over_b: f64,
    pub(crate) poisson: f64,
    pub(crate) force: [f64; 2],
    pub(crate) moved: [f64; 2],
    pub(crate) uncertainty: [f64; 2],
    pub(crate) adhesion: [f64; 2],
}

pub(crate) const SHIFTS: &[Shift] = &[
    Shift {
        a_over_b: 1.0,
        poisson: 0.28,
        force: [0.3000000, 0.0000000],
        moved: [1.0725e-03, 0.0000e+00],
        uncertainty: [7.3e-07, 0.0e+00],
        adhesion: [0.7884, 0.0042],
    },
    Shift {
        a_over_b: 1.0,
        poisson: 0.28,
        force: [0.9000000, 0.0000000],
        moved: [3.9723e-03, 0.0000e+00],
        uncertainty: [1.5e-06, 0.0e+00],
        adhesion: [0.2165, 0.0035],
    },
    Shift {
        a_over_b: 1.0,
        poisson: 0.28,
        force: [0.4242641, 0.4242641],
        moved: [1.6368e-03, 1.6368e-03],
        uncertainty: [7.2e-07, 7.2e-07],
        adhesion: [0.5441, 0.0068],
    },
    Shift {
        a_over_b: 0.5,
        poisson: 0.28,
        force: [0.3000000, 0.0000000],
        moved: [1.4319e-03, 0.0000e+00],
        uncertainty: [1.0e-06, 0.0e+00],
        adhesion: [0.7886, 0.0040],
    },
    Shift {
        a_over_b: 0.5,
        poisson: 0.28,
        force: [0.9000000, 0.0000000],
        moved: [5.3039e-03, 0.0000e+00],
        uncertainty: [2.0e-06, 0.0e+00],
        adhesion: [0.2120, 0.0044],
    },
    Shift {
        a_over_b: 0.5,
        poisson: 0.28,
        force: [0.4242641, 0.4242641],
        moved: [2.1883e-03, 2.3059e-03],
        uncertainty: [8.2e-07, 1.0e-06],
        adhesion: [0.5448, 0.0055],
    },
    Shift {
        a_over_b: 2.0,
        poisson: 0.28,
        force: [0.3000000, 0.0000000],
        moved: [7.5647e-04, 0.0000e+00],
        uncertainty: [5.2e-07, 0.0e+00],
        adhesion: [0.7884, 0.0042],
    },
    Shift {
        a_over_b: 2.0,
        poisson: 0.28,
        force: [0.9000000, 0.0000000],
        moved: [2.8022e-03, 0.0000e+00],
        uncertainty: [1.1e-06, 0.0e+00],
        adhesion: [0.2162, 0.0034],
    },
    Shift {
        a_over_b: 2.0,
        poisson: 0.28,
        force: [0.4242641, 0.4242641],
        moved: [1.1530e-03, 1.0942e-03],
        uncertainty: [5.1e-07, 4.1e-07],
        adhesion: [0.5448, 0.0055],
    },
    Shift {
        a_over_b: 1.0,
        poisson: 0.00,
        force: [0.3000000, 0.0000000],
        moved: [1.2473e-03, 0.0000e+00],
        uncertainty: [8.5e-07, 0.0e+00],
        adhesion: [0.7865, 0.0056],
    },
    Shift {
        a_over_b: 1.0,
        poisson: 0.00,
        force: [0.9000000, 0.0000000],
        moved: [4.6222e-03, 0.0000e+00],
        uncertainty: [1.7e-06, 0.0e+00],
        adhesion: [0.2156, 0.0030],
    },
    Shift {
        a_over_b: 0.5,
        poisson: 0.00,
        force: [0.6000000, 0.0000000],
        moved: [3.6967e-03, 0.0000e+00],
        uncertainty: [1.4e-06, 0.0e+00],
        adhesion: [0.5449, 0.0062],
    },
];

/// Line contacts: creepage `upsilon R/(mu a)` with `1/R` the sum of curvatures, or force.
pub(crate) const LINE_F_04_L100: Row = Row {
    name: "v",
    values: [
        0.22214, 0.25350, 0.31153, 0.47062, 0.41576, 0.39327, 0.38867, 0.39697, 0.40154, 0.39912,
        0.40023, 0.39996,
    ],
    uncertainty: [
        0.00081, 0.00082, 0.00080, 0.00059, 0.00108, 0.00052, 0.00031, 0.00057, 0.00029, 0.00031,
        0.00031, 0.00031,
    ],
};
pub(crate) const LINE_C_04_L1000: Row = Row {
    name: "fx",
    values: [
        0.02482, 0.04921, 0.07313, 0.09656, 0.11943, 0.14171, 0.16329, 0.18394, 0.22258, 0.25834,
        0.29143, 0.32194,
    ],
    uncertainty: [
        0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015,
        0.00015, 0.00015,
    ],
};
pub(crate) const LINE_S_04_L100: Row = Row {
    name: "fx",
    values: [
        0.65571, 0.66854, 0.67691, 0.67066, 0.66621, 0.66432, 0.66317, 0.66182, 0.65856, 0.65603,
        0.65382, 0.65192,
    ],
    uncertainty: [
        0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00015, 0.00018, 0.00021,
        0.00023, 0.00025,
    ],
};
