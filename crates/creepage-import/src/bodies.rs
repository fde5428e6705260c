//! Reader of module 3 of CONTACT: two bodies with a given shape. What is read of each case.

use crate::ImportError;
use crate::lines::Lines;
use crate::read::{Control, FrictionRead, Heat, Materials, read_heat, read_points_below};

/// A case of module 3, in mm, N, rad, s.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Bodies {
    pub(crate) control: Control,
    /// Approach or load, then longitudinal, lateral, spin: creepages, shifts or forces.
    pub(crate) kinematics: [f64; 4],
    pub(crate) friction: Option<FrictionRead>,
    /// Rolling direction (rad), step (mm), speed (mm/s).
    pub(crate) rolling: Option<[f64; 3]>,
    pub(crate) materials: Option<Materials>,
    pub(crate) heat: Option<Heat>,
    pub(crate) grid: Option<Grid>,
    pub(crate) shape: Option<Shape>,
    pub(crate) planform: usize,
    /// Rigid slip that is added element by element, along and across, where it is not zero everywhere.
    pub(crate) added_slip: Option<Vec<[f64; 2]>>,
    /// Where the middle of the shape stood before it was put at the origin (mm).
    pub(crate) middle: [f64; 2],
}

/// The elements, or the semi-axes or curvatures of an ellipse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Grid {
    /// IPOTCN.
    pub(crate) kind: i32,
    pub(crate) elements: [usize; 2],
    /// Below zero: A1, B1 or A1, a/b or a, b. Else the place of the first corner.
    pub(crate) first: [f64; 2],
    /// Below zero: how much larger than the ellipse. Else the elements' sizes.
    pub(crate) size: [f64; 2],
}

/// The undeformed distance.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Shape {
    Quadratic([f64; 6]),
    /// A circle along x about a place, points across: radius, place, first y, step, distances.
    Circular {
        radius: f64,
        middle: f64,
        first: f64,
        step: f64,
        points: Vec<f64>,
    },
    WithSines,
    Points(Vec<f64>),
}

impl Bodies {
    /// Reads the next case; what it keeps is that of the case before, `self`.
    pub(crate) fn next(&self, lines: &mut Lines) -> Result<Self, ImportError> {
        let control = Control::read(lines, self.control)?;
        let mut case = Self { control, ..self.clone() };
        case.kinematics = lines.array(match (control.has_load(), control.force()) {
            (false, 0) => "PEN, CKSI, CETA, CPHI",
            (true, 0) => "FN, CKSI, CETA, CPHI",
            (false, 1) => "PEN, FX, CETA, CPHI",
            (true, 1) => "FN, FX, CETA, CPHI",
            (false, _) => "PEN, FX, FY, CPHI",
            (true, _) => "FN, FX, FY, CPHI",
        })?;
        case.friction = FrictionRead::read(lines, control, self.friction.as_ref())?;
        if control.influence() >= 2 && control.tangential() >= 2 {
            case.rolling = Some(lines.array("CHI, DQ, VELOC")?);
        }
        case.materials = Materials::read(lines, control, self.materials.as_ref())?;
        case.heat = read_heat(lines, control, self.heat)?;
        if control.discretisation() >= 2 {
            case.grid = Some(Grid::read(lines)?);
        }
        let Some(grid) = case.grid else {
            return Err(lines.expected("a grid (D = 2) in the first case"));
        };
        if control.shape() >= 1 && grid.kind > 0 {
            (case.shape, case.planform) = read_shape(lines, grid)?;
        } else if grid.kind < 0 {
            (case.shape, case.planform) = (None, 1);
        }
        if control.varies() == 3 && control.law() != 1 {
            let rows = grid.elements[1];
            case.friction = Some(FrictionRead::by_row(lines, control.law(), rows)?);
        }
        match control.last_of_second() {
            0 => case.added_slip = None,
            9 => {
                let count = 2 * grid.elements[0] * grid.elements[1];
                let slips = lines.numbers(count, "slip at each element")?;
                let is_any = slips.iter().any(|slip| *slip != 0.0);
                case.added_slip = is_any.then(|| slips.as_chunks().0.to_vec());
            }
            _ => {}
        }
        read_points_below(lines, control)?;
        Ok(case)
    }
}

impl Grid {
    fn read(lines: &mut Lines) -> Result<Self, ImportError> {
        let [kind] = lines.array("IPOTCN")?;
        let kind = kind as i32;
        let what = match kind {
            1 => "MX, MY, XL, YL, DX, DY",
            2 => "MX, MY, XL, YL, XH, YH",
            3 => "MX, MY, XC1, YC1, DX, DY",
            4 => "MX, MY, XC1, YC1, XCM, YCM",
            -1 => "MX, MY, A1, B1, SCALE",
            -2 => "MX, MY, A1, AOB, SCALE",
            -3 => "MX, MY, AA, BB, SCALE",
            -4 | -5 => "MX, MY, three numbers of the shape, SCALE",
            _ => return Err(lines.expected("IPOTCN from -5 to 4, not 0, on the line before")),
        };
        let error = lines.expected("MX and MY from 1 to 10000, and finite sizes");
        let count = if (-3..=0).contains(&kind) { 5 } else { 6 };
        let values = lines.numbers(count, what)?;
        if values[..2].iter().any(|n| n.fract() != 0.0 || !(1.0..=1e4).contains(n)) {
            return Err(error);
        }
        let elements = [values[0] as usize, values[1] as usize];
        let (mut first, mut size) =
            ([values[2], values[3]], [values[4], values.get(5).copied().unwrap_or(1.0)]);
        if kind < 0 {
            return Ok(Self { kind, elements, first, size });
        }
        for axis in 0..2 {
            let count = elements[axis] as f64;
            size[axis] = match kind {
                2 => (size[axis] - first[axis]) / count,
                4 if elements[axis] > 1 => (size[axis] - first[axis]) / (count - 1.0),
                _ => size[axis],
            };
            if kind >= 3 {
                first[axis] -= 0.5 * size[axis];
            }
        }
        let valid = size.iter().all(|size| *size > 0.0 && size.is_finite());
        if valid { Ok(Self { kind, elements, first, size }) } else { Err(error) }
    }

    /// The middle of an element along an axis (mm).
    pub(crate) fn middle(&self, axis: usize, index: usize) -> f64 {
        self.first[axis] + (index as f64 + 0.5) * self.size[axis]
    }
}

fn read_shape(lines: &mut Lines, grid: Grid) -> Result<(Option<Shape>, usize), ImportError> {
    let [base, planform] = lines.array("IBASE, IPLAN")?;
    let planform = planform as usize;
    let shape = match base as i32 {
        1 => Shape::Quadratic(lines.array("B(I), I = 1, 6")?),
        2 => {
            let error = lines.expected("NN points, from 2 to 10000");
            let [count, middle, radius, first, step] = lines.array("NN, XM, RX1, Y1, DY1")?;
            if !(2.0..=1e4).contains(&count) {
                return Err(error);
            }
            let points = lines.numbers(count as usize, "NN distances")?;
            Shape::Circular { radius, middle, first, step, points }
        }
        3 => {
            lines.numbers(8, "B(I), I = 1, 8")?;
            Shape::WithSines
        }
        9 => {
            let count = grid.elements[0] * grid.elements[1];
            Shape::Points(lines.numbers(count, "the distance at each element")?)
        }
        _ => return Err(lines.expected("IBASE = 1, 2, 3 or 9 on the line before")),
    };
    match planform {
        2 => drop(lines.numbers(6, "the planform's six numbers")?),
        3 => drop(lines.numbers(8, "the planform's eight numbers")?),
        4 => drop(lines.numbers(grid.elements[0] * grid.elements[1], "the planform's elements")?),
        _ => {}
    }
    Ok((Some(shape), planform))
}
