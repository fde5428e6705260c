//! Readers common to both modules: control digits, friction, materials, heat, points below the surface.

use crate::ImportError;
use crate::lines::{Digits, Lines};

/// The control digits of a case. Named by their letters in the format.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Control {
    /// C-P-B-T-N-F-S.
    first: Digits,
    /// V-L-D-C-M-Z-E.
    second: Digits,
    /// X-H-G-I-A-O-W-R.
    third: Digits,
    /// MAXOUT.
    outer_rounds: f64,
}

/// A digit's letter, its place from the right, and its largest value.
type Largest = (char, u32, u8);

/// Digits that say what follows or what is solved; a larger one says neither to us.
const FIRST: [Largest; 6] =
    [('C', 6, 9), ('P', 5, 3), ('B', 4, 6), ('T', 3, 3), ('N', 2, 1), ('F', 1, 3)];
const SECOND: [Largest; 4] = [('V', 6, 3), ('L', 5, 6), ('D', 4, 5), ('M', 2, 5)];
const THIRD: [Largest; 1] = [('H', 6, 3)];
/// Values of the digit C of the second line: the influence numbers.
const INFLUENCE: [u8; 6] = [0, 1, 2, 3, 4, 9];

/// Control digits whose values are known here.
fn known(lines: &mut Lines, what: &str, largest: &[Largest]) -> Result<Digits, ImportError> {
    let refused = |lines: &Lines, letter: char, allowed: &str| {
        lines.expected(&format!("{letter} {allowed} in the control digits {what}"))
    };
    let errors: Vec<_> = largest
        .iter()
        .map(|(letter, place, most)| {
            (*place, *most, refused(lines, *letter, &format!("from 0 to {most}")))
        })
        .collect();
    let of_influence = refused(lines, 'C', "from 0 to 4, or 9,");
    let digits = lines.digits(what)?;
    for (place, most, error) in errors {
        if digits.at(place) > most {
            return Err(error);
        }
    }
    if what.starts_with('V') && !INFLUENCE.contains(&digits.at(3)) {
        return Err(of_influence);
    }
    Ok(digits)
}

impl Control {
    /// Reads them; `before` are those of the case before.
    pub(crate) fn read(lines: &mut Lines, before: Self) -> Result<Self, ImportError> {
        let mut control = Self {
            first: known(lines, "C-P-B-T-N-F-S", &FIRST)?,
            second: known(lines, "V-L-D-C-M-Z-E", &SECOND)?,
            third: known(lines, "X-H-G-I-A-O-W-R", &THIRD)?,
            outer_rounds: before.outer_rounds,
        };
        // Digits for the program's own debugging say nothing of the case.
        if control.third.at(7) >= 1 {
            lines.digits("P-S-F-L-R-I-N")?;
        }
        control.settings_of_solver(lines)?;
        Ok(control)
    }

    /// Numbers of the program's iterations: nothing of the case.
    fn settings_of_solver(&mut self, lines: &mut Lines) -> Result<(), ImportError> {
        let gauss_seidel = self.third.at(5);
        if gauss_seidel != 1 {
            let settings = lines.numbers(5, "MAXGS, MAXIN, MAXNR, MAXOUT, EPS")?;
            self.outer_rounds = settings[3];
        }
        match gauss_seidel {
            2 | 3 => lines.numbers(4, "OMEGAH, OMEGAS, INISLP, OMGSLP").map(drop),
            4 => lines.numbers(2, "INISLP, OMGSLP").map(drop),
            5 => lines.numbers(5, "FDECAY, BETATH and distances of the decay").map(drop),
            _ => Ok(()),
        }
    }

    /// How often pressure and traction are solved in turn, between unlike bodies.
    pub(crate) fn outer_rounds(self) -> f64 {
        self.outer_rounds
    }
    pub(crate) fn config(self) -> u8 {
        self.first.at(6)
    }
    pub(crate) fn history(self) -> u8 {
        self.first.at(5)
    }
    pub(crate) fn bound(self) -> u8 {
        self.first.at(4)
    }
    pub(crate) fn tangential(self) -> u8 {
        self.first.at(3)
    }
    /// Whether forces press the bodies, rather than a given approach or height.
    pub(crate) fn has_load(self) -> bool {
        self.first.at(2) == 1
    }
    pub(crate) fn force(self) -> u8 {
        self.first.at(1)
    }
    pub(crate) fn stress(self) -> u8 {
        self.first.at(0)
    }
    pub(crate) fn varies(self) -> u8 {
        self.second.at(6)
    }
    pub(crate) fn law(self) -> u8 {
        self.second.at(5)
    }
    pub(crate) fn discretisation(self) -> u8 {
        self.second.at(4)
    }
    pub(crate) fn influence(self) -> u8 {
        self.second.at(3)
    }
    pub(crate) fn material(self) -> u8 {
        self.second.at(2)
    }
    pub(crate) fn shape(self) -> u8 {
        self.second.at(1)
    }
    pub(crate) fn last_of_second(self) -> u8 {
        self.second.at(0)
    }
    pub(crate) fn heat(self) -> u8 {
        self.third.at(6)
    }
    /// Whether the next case follows without a line that names its module.
    pub(crate) fn goes_on(self) -> bool {
        self.third.at(0).is_multiple_of(2)
    }
    /// Whether the case only sets numbers for the next.
    pub(crate) fn is_skipped(self) -> bool {
        self.third.at(0) >= 2
    }
}

/// One law of friction.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Law {
    Coulomb {
        at_rest: f64,
        kinetic: f64,
    },
    /// Terms of drop and speed (mm/s).
    Falling {
        name: &'static str,
        kinetic: f64,
        terms: [[f64; 2]; 2],
    },
    /// At the reference temperature, that, the change of friction and of temperature.
    OfTemperature([f64; 4]),
}

/// Friction, and what else goes with it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Friction {
    One(Law),
    /// By the inclination of the rail (rad).
    ByAngle(Vec<(f64, Law)>),
    /// By the place along the track (mm).
    Along(Vec<(f64, Law)>),
    /// Row by row of elements.
    ByRow(Vec<Law>),
}

/// Friction with its memory: distance (mm), speed (mm/s).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FrictionRead {
    pub(crate) friction: Friction,
    pub(crate) memory: Option<[f64; 2]>,
    kind: u8,
}

impl FrictionRead {
    /// Reads it where the digits V and L say so; `before` is the case before.
    pub(crate) fn read(
        lines: &mut Lines,
        control: Control,
        before: Option<&Self>,
    ) -> Result<Option<Self>, ImportError> {
        if control.law() == 1 {
            return Ok(before.cloned());
        }
        let kind = control.law();
        let friction = match control.varies() {
            0 => Friction::One(law(lines, kind, false)?.1),
            1 => Friction::ByAngle(table(lines, kind)?),
            2 => Friction::Along(table(lines, kind)?),
            _ => return Ok(None),
        };
        let memory = memory(lines, kind)?;
        Ok(Some(Self { friction, memory, kind }))
    }

    /// Whether it depends on the temperature.
    pub(crate) fn needs_heat(&self) -> bool {
        matches!(self.friction, Friction::One(Law::OfTemperature(_)))
    }

    /// One law for each row of elements.
    pub(crate) fn by_row(lines: &mut Lines, kind: u8, rows: usize) -> Result<Self, ImportError> {
        let laws = (0..rows).map(|_| Ok(law(lines, kind, false)?.1)).collect::<Result<_, _>>()?;
        Ok(Self { friction: Friction::ByRow(laws), memory: memory(lines, kind)?, kind })
    }
}

fn table(lines: &mut Lines, kind: u8) -> Result<Vec<(f64, Law)>, ImportError> {
    let count = lines.count("NVF, the number of places of the friction")?;
    (0..count).map(|_| law(lines, kind, true)).collect()
}

fn law(lines: &mut Lines, kind: u8, with_place: bool) -> Result<(f64, Law), ImportError> {
    let name = match kind {
        0 => {
            let values = lines.numbers(2 + usize::from(with_place), "FSTAT, FKIN")?;
            let (place, rest) = split(&values, with_place);
            return Ok((place, Law::Coulomb { at_rest: rest[0], kinetic: rest[1] }));
        }
        2 => "linear",
        3 => "rational",
        4 => "exponential",
        6 => {
            let values =
                lines.numbers(4 + usize::from(with_place), "FREF, TREF, DFHEAT, DTHEAT")?;
            let (place, rest) = split(&values, with_place);
            return Ok((place, Law::OfTemperature([rest[0], rest[1], rest[2], rest[3]])));
        }
        _ => {
            return Err(lines.expected("a law of friction L = 0, 1, 2, 3, 4 or 6 in V-L-D-C-M-Z-E"));
        }
    };
    let values =
        lines.numbers(5 + usize::from(with_place), "FKIN, two drops, each with its speed")?;
    let (place, rest) = split(&values, with_place);
    let terms = [[rest[1], rest[2]], [rest[3], rest[4]]];
    Ok((place, Law::Falling { name, kinetic: rest[0], terms }))
}

fn split(values: &[f64], with_place: bool) -> (f64, &[f64]) {
    if with_place { (values[0], &values[1..]) } else { (0.0, values) }
}

fn memory(lines: &mut Lines, kind: u8) -> Result<Option<[f64; 2]>, ImportError> {
    if kind < 2 {
        return Ok(None);
    }
    let memory = lines.array("MEMDST, MEM_S0")?;
    Ok((memory[0] > 0.0).then_some(memory))
}

/// Both bodies' material, and what lies between them. In N and mm.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Materials {
    pub(crate) poisson: [f64; 2],
    pub(crate) shear_modulus: [f64; 2],
    pub(crate) extra: Extra,
}

/// What digit M adds.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Extra {
    None,
    /// Relaxation: ratios of stiffness, times (s).
    Viscoelastic {
        ratios: [f64; 2],
        times: [f64; 2],
    },
    /// Simplified theory with one flexibility (mm3/N).
    OneFlexibility,
    /// Simplified theory with three, changed by K0, ALFA, BETA.
    ThreeFlexibilities {
        changes: [f64; 3],
    },
    Fastrip {
        changes: [f64; 3],
    },
    /// Shear modulus, thickness, yield stress, slope.
    Layer([f64; 4]),
}

impl Materials {
    /// Reads them where digit C says so.
    pub(crate) fn read(
        lines: &mut Lines,
        control: Control,
        before: Option<&Self>,
    ) -> Result<Option<Self>, ImportError> {
        if control.influence() < 2 {
            return Ok(before.cloned());
        }
        if control.influence() == 9 {
            lines.file("influence numbers, CFNAME")?;
        }
        if control.influence() == 4 {
            lines.numbers(2, "IF_METH, IF_VAR of the influence numbers")?;
        }
        let error = lines.expected("POISS 1, 2 from 0 to 0.5, GG 1, 2 above zero");
        let [first, second, third, fourth] = lines.array("POISS 1, 2, GG 1, 2")?;
        let is_solid = |poisson: f64, modulus: f64| (0.0..=0.5).contains(&poisson) && modulus > 0.0;
        if !(is_solid(first, third) && is_solid(second, fourth)) {
            return Err(error);
        }
        let extra = match control.material() {
            1 => {
                let [one, other, first, second] = lines.array("FG 1, 2, TC 1, 2")?;
                Extra::Viscoelastic { ratios: [one, other], times: [first, second] }
            }
            2 => {
                lines.numbers(1, "FLX, the flexibility")?;
                Extra::OneFlexibility
            }
            3 => Extra::ThreeFlexibilities { changes: lines.array("K0_MF, ALFAMF, BETAMF")? },
            4 => Extra::Layer(lines.array("GG3, LAYTHK, TAU_C0, K_TAU")?),
            5 => Extra::Fastrip { changes: lines.array("K0_MF, ALFAMF, BETAMF")? },
            _ => Extra::None,
        };
        // A thin sheet in place of the half-space.
        if control.bound() == 1 {
            lines.numbers(1, "FLX_Z, the flexibility of the sheet")?;
        }
        Ok(Some(Self { poisson: [first, second], shear_modulus: [third, fourth], extra }))
    }
}

/// How both bodies conduct heat: BKTEMP, HEATCP (J/(kg K)), LAMBDA (W/(mm K)), DENS (kg/mm3) of each.
pub(crate) type Heat = [[f64; 4]; 2];

/// Reads the numbers of the temperature where digit H says so; `before` are those of the case before.
pub(crate) fn read_heat(
    lines: &mut Lines,
    control: Control,
    before: Option<Heat>,
) -> Result<Option<Heat>, ImportError> {
    if control.heat() < 2 {
        return Ok(before);
    }
    let first = lines.array("BKTEMP, HEATCP, LAMBDA, DENS of body 1")?;
    Ok(Some([first, lines.array("BKTEMP, HEATCP, LAMBDA, DENS of body 2")?]))
}

/// Points below the surface: they are read over.
pub(crate) fn read_points_below(lines: &mut Lines, control: Control) -> Result<(), ImportError> {
    if control.stress() < 2 {
        return Ok(());
    }
    lines.numbers(2, "MATFIL, OUTPUT of the points below the surface")?;
    // At S = 2 the points are those of before.
    if control.stress() == 2 {
        return Ok(());
    }
    loop {
        let kind = lines.count("ISUBS, a kind of points below the surface, or 0")?;
        match kind {
            0 => return Ok(()),
            1 | 5 => {}
            2 | 6 => {
                lines.numbers(3, "IXL, INC, IXH")?;
                lines.numbers(3, "IYL, INC, IYH")?;
            }
            3 | 7 | 9 => {
                let [x, y, z] = lines.array("NX, NY, NZ")?;
                if [x, y, z].iter().any(|n| !(0.0..1e5).contains(n)) {
                    return Err(lines.expected("numbers of points up to 100000"));
                }
                let counts = [x, y, z].map(|n| n as usize);
                lines.numbers(counts[0], "places along x")?;
                lines.numbers(counts[1], "places along y")?;
                if kind == 3 {
                    lines.numbers(2, "ZL, DZ")?;
                } else {
                    lines.numbers(counts[2], "depths")?;
                }
                continue;
            }
            _ => return Err(lines.expected("ISUBS = 0, 1, 2, 3, 5, 6, 7 or 9 on the line before")),
        }
        if kind <= 2 {
            lines.numbers(3, "NZ, ZL, DZ")?;
        } else {
            let count = lines.count("NZ, the number of depths")?;
            lines.numbers(count, "depths")?;
        }
    }
}
