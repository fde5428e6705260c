//! Builder of the contact map of a wheelset: heights, then rolling nodes by bisection, then the error on states drawn
//! afresh.

mod error;
mod head;
mod heights;
mod image;
mod journal;
mod measure;
mod node;
mod plan;
mod refine;

use std::path::Path;
use std::sync::Arc;

use creepage::table::Table;
use creepage_map::{
    CellError, ContactMap, HEIGHTS, Head, Heights, MapAccuracy, MapError, RollingNode, WheelMap,
};
use creepage_rail::Side;
use creepage_wheelset::{RailFriction, WheelsetSolver};
use rayon::prelude::*;

pub use self::error::MapBuildError;
use self::heights::PressedPlace;
use self::image::Image;
use self::journal::Journal;
use self::node::Place;
pub use self::plan::{MapPlan, MapResolution};
use super::case::WheelsetCase;

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
    let head = head::of(case, plan)?;
    head::check_ellipses(&table, head.poisson)?;
    let both = [(); 2].map(|()| RailFriction::Constant(head.own.friction));
    let case = &WheelsetCase { friction: Some(both), ..case.clone() };
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
        let one = |k: i32| -> Result<Option<PressedPlace>, MapBuildError> {
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
        let places: Vec<PressedPlace> =
            found.get(first..=last).unwrap_or_default().iter().flatten().copied().collect();
        if places.len() < 5 {
            return Err(MapBuildError::Short { places: places.len() });
        }
        let nodes = heights::nodes(&places);
        let y = [first, last].map(|k| (k as f64 - f64::from(count)) * spacing);
        Ok((y, Heights::new(nodes, loads)?))
    }

    fn height(&self, (side, k): (Side, i32), loads: &[f64; HEIGHTS]) -> Option<PressedPlace> {
        let image = self.image(side);
        let y = f64::from(k) * self.plan.spacing;
        let of = (image, self.head.half_distance);
        let most = [self.head.roll, self.head.yaw];
        let pressed =
            || heights::press_place(&self.solver, of, [y, image.free_roll(y)?], most, loads);
        // Where profiles end, the map ends.
        pressed().ok().filter(PressedPlace::is_finite)
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

/// Whether the place rises enough from a node to the next one.
fn rises(nodes: &[Option<PressedPlace>], from: usize, spacing: f64) -> bool {
    /// Part of the step of `y` by which a place must go on.
    const MIN_RISE: f64 = 0.05;
    let pair = nodes.get(from).zip(nodes.get(from + 1));
    let pair = pair.and_then(|(from, to)| from.as_ref().zip(to.as_ref()));
    pair.is_some_and(|(from, to)| to.place - from.place > MIN_RISE * spacing)
}
