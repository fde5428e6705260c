//! Builder of the contact map of a wheelset: heights, then rolling nodes by bisection, then the error on states drawn
//! afresh.

mod heights;
mod image;
mod journal;
mod measure;
mod node;
mod refine;

use creepage_wheelset::{
    Drive, Load, PitchRate, RailFriction, RigidSlip, WheelsetError, WheelsetSolver,
};
use std::path::Path;
use std::sync::Arc;

use creepage::coulomb::Resolution;
use creepage::normal;
use creepage::table::Table;
use creepage_map::{
    CellError, ContactMap, HEIGHTS, Head, HeightOrLoad, Heights, MapAccuracy, MapError,
    RollingNode, State, WheelMap,
};
use creepage_rail::{RailMotion, Side};
use rayon::prelude::*;

use self::heights::Stood;
use self::image::Image;
use self::journal::Journal;
use self::node::Place;
use super::case::WheelsetCase;
use super::error::{WheelsetFileError, section};
use crate::case::CaseError;

/// Plan of a map: its ranges, resolutions and motions.
#[derive(Debug, Clone, PartialEq)]
pub struct MapPlan {
    /// Lateral positions of the wheelset from the track centre (m) that the map is to cover, to both sides; it
    /// ends before where profiles end or the flange has climbed.
    pub y: f64,
    /// Largest yaw (rad).
    pub yaw: f64,
    /// Vertical loads of a wheel (N) between which it is interpolated, rising, at least two.
    pub loads: Vec<f64>,
    /// Least and largest coefficient of friction.
    pub friction: [f64; 2],
    /// Part of `mu N` by which forces in the middle of a cell may differ before it is halved.
    pub tolerance: f64,
    /// Widest and narrowest cells (m).
    pub widths: [f64; 2],
    /// Spacing of places with heights (m).
    pub spacing: f64,
    /// States drawn afresh in each cell.
    pub states: usize,
    /// Elements of rolling and of pressing.
    pub resolution: MapResolution,
}

/// Resolution of the contacts of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapResolution {
    /// For a first look.
    Fast,
    /// The full theory's usual one.
    Standard,
    /// The finer one, for contacts of several lobes.
    Fine,
}

impl MapResolution {
    fn rolling(self) -> Resolution {
        match self {
            Self::Fast => Resolution::FAST,
            Self::Standard => Resolution::STANDARD,
            Self::Fine => Resolution::FINE,
        }
    }

    fn solids(self) -> normal::Resolution {
        match self {
            Self::Fast => normal::Resolution::FAST,
            Self::Standard => normal::Resolution::STANDARD,
            Self::Fine => normal::Resolution::FINE,
        }
    }
}

impl MapPlan {
    /// Largest roll (rad) beyond that of a wheelset that rolls freely.
    const ROLL: f64 = 1e-3;
    /// Lightest and heaviest load of the nodes, over the usual load of a wheel.
    const LOADS: [f64; 2] = [0.12, 2.4];
    /// Number of loads, in even steps of their logarithm, along which forces are blended.
    const LOAD_COUNT: i32 = 6;

    /// The usual plan for wheels that carry `load` (N) each.
    #[must_use]
    pub fn usual(load: f64) -> Self {
        let [light, heavy] = Self::LOADS;
        let step = (heavy / light).powf(1.0 / f64::from(Self::LOAD_COUNT - 1));
        Self {
            // On the flange shifts by roll and yaw no longer tell the load: its error says how far.
            y: 6.2e-3,
            yaw: 0.01,
            loads: (0..Self::LOAD_COUNT).map(|k| load * light * step.powi(k)).collect(),
            friction: [0.05, 0.6],
            tolerance: 0.01,
            widths: [0.4e-3, 0.05e-3],
            spacing: 0.05e-3,
            states: 2,
            resolution: MapResolution::Standard,
        }
    }

    /// The usual plan for a wheelset's own load.
    ///
    /// # Errors
    /// [`WheelsetError::NoLoad`] where its file has a height or nothing.
    pub fn of(case: &WheelsetCase) -> Result<Self, WheelsetFileError> {
        match case.stance.load {
            Some(Load::Axle(load)) => Ok(Self::usual(0.5 * load)),
            Some(Load::Wheel(load)) => Ok(Self::usual(load)),
            _ => Err(WheelsetError::NoLoad.into()),
        }
    }

    /// Loads of the heights: zero, then in even steps of the depth.
    fn height_loads(&self) -> [f64; HEIGHTS] {
        let most = 1.02 * self.loads.last().copied().unwrap_or(0.0);
        std::array::from_fn(|k| most * (k as f64 / (HEIGHTS - 1) as f64).powf(1.5))
    }

    /// Checks its numbers.
    ///
    /// # Errors
    /// [`MapBuildError::Plan`] with the first of them that no map can have.
    pub fn check(&self) -> Result<(), MapBuildError> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let [wide, narrow] = self.widths;
        let rises = |values: &[f64]| values.windows(2).all(|pair| pair[0] < pair[1]);
        let checks = [
            ("y", self.y, positive(self.y) && self.y <= 0.05, "above 0 m, at most 0.05 m"),
            ("yaw", self.yaw, self.yaw >= 0.0 && self.yaw <= 0.05, "0 to 0.05 rad"),
            ("tolerance", self.tolerance, positive(self.tolerance), "positive and finite"),
            ("widest", wide, positive(wide) && wide <= 2e-3, "above 0 m, at most 0.002 m"),
            (
                "narrowest",
                narrow,
                narrow >= 5e-6 && narrow <= wide,
                "5e-6 m to the width of the widest cells",
            ),
            (
                "spacing",
                self.spacing,
                self.spacing >= 5e-6 && self.spacing <= 1e-3,
                "5e-6 to 1e-3 m",
            ),
            ("friction", self.friction[0], self.friction[0] >= 0.01, "0.01 and above"),
            (
                "friction",
                self.friction[1],
                self.friction[1] <= 2.0 && rises(&self.friction),
                "at most 2",
            ),
        ];
        if let Some((quantity, value, _, valid)) = checks.into_iter().find(|check| !check.2) {
            return Err(MapBuildError::Plan { quantity, value, valid });
        }
        let wrong = |value, valid| MapBuildError::Plan { quantity: "loads", value, valid };
        if self.loads.len() < 2 {
            return Err(wrong(self.loads.len() as f64, "two or more in number"));
        }
        if let Some(load) = self.loads.iter().find(|load| !positive(**load)) {
            return Err(wrong(*load, "positive and finite"));
        }
        if let Some(pair) = self.loads.windows(2).find(|pair| pair[0] >= pair[1]) {
            return Err(wrong(pair[1], "rising, each above the one before"));
        }
        Ok(())
    }
}

/// Error of a map's build.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MapBuildError {
    /// A number of the plan.
    #[error("{quantity} must be {valid}, got {value}")]
    Plan {
        /// The quantity.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// What it must be.
        valid: &'static str,
    },
    /// The wheelset cannot be pressed or solved.
    #[error(transparent)]
    Wheelset(#[from] WheelsetFileError),
    /// The wheelset cannot be pressed or solved in a position.
    #[error(transparent)]
    Position(#[from] WheelsetError),
    /// The map does not take what was found.
    #[error(transparent)]
    Map(#[from] MapError),
    /// Rigid slip by place is not in a map.
    #[error("[contact] slip = \"curved\" is not in a contact map: leave it out, or solve directly")]
    Curved,
    /// Something that a map does not know.
    #[error("{what}: not in a contact map; solve the wheelset directly, or leave it out")]
    NotInMap {
        /// The keys.
        what: &'static str,
    },
    /// One wheel alone.
    #[error("[wheelset] side: a contact map has both wheels, leave it out")]
    OneWheel,
    /// The table of ellipses is one of another theory.
    #[error("the table of ellipses is of {theory}; a contact map needs one of exact")]
    EllipsesOf {
        /// That theory.
        theory: String,
    },
    /// The table of ellipses is too narrow.
    #[error(
        "the table of ellipses has {quantity} from {} to {}; this contact map needs {} to {}",
        given[0], given[1], needed[0], needed[1]
    )]
    EllipsesRange {
        /// `a_over_b` or `poisson`.
        quantity: &'static str,
        /// From where to where it has them.
        given: [f64; 2],
        /// From where to where they are needed.
        needed: [f64; 2],
    },
    /// Nothing was pressed at a place.
    #[error("at y = {y} m no height was found at which the wheel carries {load} N")]
    NotPressed {
        /// The place (m).
        y: f64,
        /// The load (N).
        load: f64,
    },
    /// Wheel and rail do not meet over enough of the range.
    #[error("wheel and rail meet over too little of the range: {places} places")]
    Short {
        /// How many places were left.
        places: usize,
    },
    /// The journal.
    #[error("cannot keep what is built in {}: {source}", path.display())]
    Journal {
        /// Its file.
        path: std::path::PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Another run builds the same.
    #[error("{} is being written by another run", path.display())]
    Busy {
        /// The journal's file.
        path: std::path::PathBuf,
    },
    /// It was told to stop.
    #[error("stopped before it was built")]
    Stopped,
}

impl MapBuildError {
    fn from_case(error: CaseError) -> Self {
        Self::Wheelset(error.into())
    }
}

/// Stage of a map's build.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MapStage {
    /// Heights: places done, places in all.
    Heights(usize, usize),
    /// Rolling: nodes done; cells that are settled, in parts of the range.
    Nodes(usize, f64),
    /// Fresh states: done, in all.
    States(usize, usize),
}

/// Callback of a map's progress; false stops the build.
pub type MapProgress<'a> = &'a (dyn Fn(MapStage) -> bool + Sync);

/// What all parts of the builder know.
struct Builder<'a> {
    case: &'a WheelsetCase,
    solver: WheelsetSolver<'a>,
    plan: &'a MapPlan,
    table: Arc<Table>,
    head: Head,
    journal: Journal,
    progress: MapProgress<'a>,
}

/// The heights and the rolling nodes of a wheel, with the lateral position of each place.
struct Wheel {
    heights: Heights,
    nodes: Vec<RollingNode>,
    /// Of each rolling node, `y` on the image (m).
    y: Vec<f64>,
}

/// Builds the map of a wheelset, on all cores. What is finished is kept in the file `journal`, from which a
/// run of the same wheelset and plan goes on; it may be removed when the map is on the disk.
///
/// # Errors
/// [`MapBuildError`].
pub fn build_map(
    case: &WheelsetCase,
    plan: &MapPlan,
    table: Arc<Table>,
    source: String,
    journal: Option<&Path>,
    progress: MapProgress<'_>,
) -> Result<ContactMap, MapBuildError> {
    plan.check()?;
    if case.slip == RigidSlip::Curved {
        return Err(MapBuildError::Curved);
    }
    if case.stance.side.is_some() {
        return Err(MapBuildError::OneWheel);
    }
    let travel = case.travel.unwrap_or_default();
    let is_plain = matches!(travel.pitch, PitchRate::Rigid(_)) && travel.drive == Drive::default();
    for (is_in, what) in [
        (
            !case.running.varies(),
            "[wheel] slices, flat, waviness, [rail] slices, corrugation, roller_radius",
        ),
        (!case.is_guarded(), "[rail] guard"),
        (travel.curvature == 0.0, "[track] curve_radius"),
        (travel.rails == [RailMotion::default(); 2], "[rail] dy_rate, dz_rate, droll_rate"),
        (is_plain, "[motion] torque, longitudinal_force, independent wheels"),
        (travel.speed >= 0.0, "[motion] speed below zero"),
    ] {
        if !is_in {
            return Err(MapBuildError::NotInMap { what });
        }
    }
    let friction = friction(case)?;
    let both = [RailFriction::Constant(friction), RailFriction::Constant(friction)];
    let case = &WheelsetCase { friction: Some(both), ..case.clone() };
    let pair = case.solids.ok_or_else(|| section("materials", "shear_modulus, poisson"));
    let pair = pair.map_err(MapBuildError::from_case)?;
    let track = case.running.track();
    let head = Head {
        radius: case.running.wheelset().radius(),
        half_distance: 0.5 * case.running.wheelset().tape_distance(),
        rail_origins: [track.left.origin(), track.right.origin()],
        poisson: pair.poisson(),
        friction: plan.friction,
        yaw: plan.yaw,
        roll: MapPlan::ROLL,
        own: own(case, friction)?,
    };
    check_ellipses(&table, pair.poisson())?;
    // Fits belong to their table.
    let of = (table.provenance(), table.a_over_b(), table.intervals(), table.accuracy());
    let journal = Journal::open(journal, &format!("{source}\n{plan:?} {head:?} {of:?}"))?;
    let solver = case.solver()?;
    let builder = Builder { case, solver, plan, table, head, journal, progress };
    let right = builder.wheel(Side::Right)?;
    let is_mirrored = builder.is_mirrored();
    let left = if is_mirrored { None } else { Some(builder.wheel(Side::Left)?) };
    builder.finish([left, Some(right)], source)
}

/// Whether a map can be fitted by this table: it is of `exact` where it names its theory, and has the ratios of axes that
/// contacts of wheels come near, for this Poisson's ratio.
fn check_ellipses(table: &Table, poisson: f64) -> Result<(), MapBuildError> {
    const RATIOS: [f64; 2] = [0.2, 20.0];
    let theory = &table.provenance().theory;
    if !matches!(theory.as_str(), "" | "exact") {
        return Err(MapBuildError::EllipsesOf { theory: theory.clone() });
    }
    for (quantity, axis, needed) in
        [("a_over_b", table.a_over_b(), RATIOS), ("poisson", table.poisson(), [poisson; 2])]
    {
        let given = [axis.low, axis.high];
        // As wide as is needed, but for rounding.
        let is_wide = given[0] <= needed[0] + 1e-9 && given[1] >= needed[1] - 1e-9;
        if !is_wide {
            return Err(MapBuildError::EllipsesRange { quantity, given, needed });
        }
    }
    Ok(())
}

impl Builder<'_> {
    /// Whether both sides are mirror images.
    fn is_mirrored(&self) -> bool {
        let running = &self.case.running;
        let track = running.track();
        running.wheelset().is_mirrored() && track.left == track.right
    }

    fn goes_on(&self, stage: MapStage) -> Result<(), MapBuildError> {
        if (self.progress)(stage) { Ok(()) } else { Err(MapBuildError::Stopped) }
    }

    fn image(&self, side: Side) -> Image<'_> {
        Image::new(&self.case.running, side)
    }

    fn place(&self, side: Side, y: f64) -> Result<Place<'_>, MapBuildError> {
        let image = self.image(side);
        let MapPlan { resolution, .. } = self.plan;
        Ok(Place {
            image,
            y,
            roll: image.free_roll(y)?,
            solids: resolution.solids(),
            rolling: resolution.rolling(),
        })
    }

    fn wheel(&self, side: Side) -> Result<Wheel, MapBuildError> {
        let (y, heights) = self.heights(side)?;
        let (y, nodes) = self.rolling(side, y, &heights)?;
        Ok(Wheel { heights, nodes, y })
    }

    /// Heights from the track centre outwards on both sides, as far as wheel and rail meet and places rise;
    /// with `y` of the first and the last of them.
    fn heights(&self, side: Side) -> Result<([f64; 2], Heights), MapBuildError> {
        let spacing = self.plan.spacing;
        #[allow(clippy::cast_possible_truncation)] // a few thousand at most
        let count = (self.plan.y / spacing).round().max(2.0) as i32;
        let loads = self.plan.height_loads();
        let all = usize::try_from(2 * count + 1).unwrap_or(0);
        let done = std::sync::atomic::AtomicUsize::new(0);
        let one = |k: i32| -> Result<Option<Stood>, MapBuildError> {
            let found = self.journal.heights((side, k), || Ok(self.height((side, k), &loads)))?;
            let done = done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
            self.goes_on(MapStage::Heights(done, all))?;
            Ok(found)
        };
        let found = (-count..=count).into_par_iter().map(one).collect::<Result<Vec<_>, _>>()?;
        let middle = usize::try_from(count).unwrap_or(0);
        let mut first = middle;
        while first > 0 && rises(&found, first - 1, spacing) {
            first -= 1;
        }
        let mut last = middle;
        while last + 1 < found.len() && rises(&found, last, spacing) {
            last += 1;
        }
        let stood: Vec<Stood> =
            found.get(first..=last).unwrap_or_default().iter().flatten().copied().collect();
        if stood.len() < 5 {
            return Err(MapBuildError::Short { places: stood.len() });
        }
        let nodes = heights::nodes(&stood);
        let y = [first, last].map(|k| (k as f64 - f64::from(count)) * spacing);
        Ok((y, Heights::new(nodes, loads)?))
    }

    fn height(&self, (side, k): (Side, i32), loads: &[f64; HEIGHTS]) -> Option<Stood> {
        let image = self.image(side);
        let y = f64::from(k) * self.plan.spacing;
        let of = (image, self.head.half_distance);
        let most = [self.head.roll, self.head.yaw];
        let stood = || heights::stood(&self.solver, of, [y, image.free_roll(y)?], most, loads);
        // Where profiles end, the map ends.
        stood().ok().filter(Stood::is_finite)
    }

    fn finish(
        &self,
        [left, right]: [Option<Wheel>; 2],
        source: String,
    ) -> Result<ContactMap, MapBuildError> {
        let wheel = |wheel: &Wheel, errors: Vec<CellError>| {
            let Wheel { heights, nodes, .. } = wheel;
            let of = (&*self.table, self.head.poisson);
            WheelMap::new(heights.clone(), nodes, &self.plan.loads, errors, of).map(Arc::new)
        };
        let none = |wheel: &Wheel| vec![CellError::default(); wheel.nodes.len() - 1];
        let right = right.ok_or(MapBuildError::Short { places: 0 })?;
        let assembled =
            |errors: [Option<Vec<CellError>>; 2]| -> Result<[Arc<WheelMap>; 2], MapError> {
                let [of_left, of_right] = errors;
                let right_map = wheel(&right, of_right.unwrap_or_else(|| none(&right)))?;
                let left_map = match &left {
                    Some(left) => wheel(left, of_left.unwrap_or_else(|| none(left)))?,
                    None => Arc::clone(&right_map),
                };
                Ok([left_map, right_map])
            };
        let map = ContactMap::new(
            self.head,
            Arc::clone(&self.table),
            assembled([None, None])?,
            MapAccuracy::default(),
            source.clone(),
        );
        let mut all = Vec::new();
        let of_right = self.measure(&map, (Side::Right, &right), &mut all)?;
        let of_left = match &left {
            Some(left) => Some(self.measure(&map, (Side::Left, left), &mut all)?),
            None => None,
        };
        let accuracy = measure::accuracy(&all);
        let wheels = assembled([of_left, Some(of_right)])?;
        Ok(ContactMap::new(self.head, Arc::clone(&self.table), wheels, accuracy, source))
    }
}

/// The one coefficient of friction of both rails; .3 where there is none, for a map has all.
fn friction(case: &WheelsetCase) -> Result<f64, MapBuildError> {
    match &case.friction {
        None => Ok(0.3),
        Some([RailFriction::Constant(left), RailFriction::Constant(right)])
            if left.to_bits() == right.to_bits() =>
        {
            Ok(*left)
        }
        Some(_) => {
            let what = "[contact] friction by place or speed of slip, and different rails'";
            Err(MapBuildError::NotInMap { what })
        }
    }
}

/// The state that the wheelset's file has.
fn own(case: &WheelsetCase, friction: f64) -> Result<State, MapBuildError> {
    let (stance, travel) = (case.stance, case.travel.unwrap_or_default());
    let pressed = match stance.load {
        Some(Load::Axle(load)) => HeightOrLoad::AxleLoad(load),
        Some(Load::Wheel(load)) => HeightOrLoad::AxleLoad(2.0 * load),
        Some(Load::Height(z)) => HeightOrLoad::Height(z),
        Some(Load::Wheels(_) | Load::Loaded { .. }) => {
            let what = "[wheelset] roll_moment, wheel_load_left, mass";
            return Err(MapBuildError::NotInMap { what });
        }
        None => return Err(WheelsetError::NoLoad.into()),
    };
    Ok(State {
        y: stance.y,
        yaw: stance.yaw,
        roll: stance.roll,
        pressed,
        speed: travel.speed,
        pitch_rate: match travel.pitch {
            PitchRate::Rigid(rate) => rate,
            PitchRate::Independent(_) => None,
        },
        lateral_velocity: travel.lateral_velocity,
        vertical_velocity: travel.vertical_velocity,
        roll_rate: travel.roll_rate,
        yaw_rate: travel.yaw_rate,
        friction,
    })
}

/// Whether the place rises enough from a node to the next one.
fn rises(nodes: &[Option<Stood>], from: usize, spacing: f64) -> bool {
    /// Part of the step of `y` by which a place must go on.
    const MIN_RISE: f64 = 0.05;
    let pair = nodes.get(from).zip(nodes.get(from + 1));
    let pair = pair.and_then(|(from, to)| from.as_ref().zip(to.as_ref()));
    pair.is_some_and(|(from, to)| to.place - from.place > MIN_RISE * spacing)
}
