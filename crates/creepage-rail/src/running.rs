//! Wheelset on its track: rest position, rolling radii, contacts.

use crate::meeting::{Meeting, Overlap, WheelRailPair};
use crate::varying_contact;
use crate::wheel::Posed;
use crate::{Contact, GeometryError, Position, Profile, Side, Track, Wheelset};

/// Overlaps nearer than this on the wheel's profile make one contact (m),
pub(crate) const ONE_CONTACT_WITHIN: f64 = 0.010;
/// unless the rail turns by more from one to the other (rad): no plane is that of both.
pub(crate) const TURN: f64 = 0.35;

/// A wheelset on its track.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelsetOnTrack {
    wheelset: Wheelset,
    track: Track,
    /// Place along the track (m) and how far the wheels have rolled on (rad).
    place: [f64; 2],
}

/// Contact of a wheel and its rail without load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Height of the wheelset (m, down) at which it touches.
    pub z: f64,
    /// Radius of the wheel where it touches (m).
    pub radius: f64,
    /// The place in track axes (m).
    pub place: [f64; 3],
    /// `y` in the rail's and in the wheel's profile (m), to the field side.
    pub y_rail: f64,
    /// See [`Touch::y_rail`].
    pub y_wheel: f64,
    /// Rotation about `x` from the track's `z` to the normal into the rail (rad).
    pub angle: f64,
}

impl Wheelset {
    /// The wheelset on a track.
    #[must_use]
    pub fn on(self, track: Track) -> WheelsetOnTrack {
        WheelsetOnTrack { wheelset: self, track, place: [0.0; 2] }
    }
}

impl WheelsetOnTrack {
    /// The wheelset.
    #[must_use]
    pub fn wheelset(&self) -> &Wheelset {
        &self.wheelset
    }

    /// The track.
    #[must_use]
    pub fn track(&self) -> &Track {
        &self.track
    }

    /// The same at a place `s` along the track (m), its wheels turned by `pitch` (rad), positive where they have
    /// rolled forward. Of wheels and rails that do not vary that tells nothing new.
    ///
    /// # Errors
    /// [`GeometryError::Value`] unless both are finite.
    pub fn at(self, s: f64, pitch: f64) -> Result<Self, GeometryError> {
        for (name, value) in [("s", s), ("pitch", pitch)] {
            if !value.is_finite() {
                return Err(GeometryError::Value { name, value, range: "finite" });
            }
        }
        Ok(Self { place: [s, pitch], ..self })
    }

    /// Its place along the track (m) and how far its wheels have rolled on (rad).
    #[must_use]
    pub fn place(&self) -> [f64; 2] {
        self.place
    }

    /// Whether a wheel or a rail of a side varies along rolling.
    #[must_use]
    pub fn varies_on(&self, side: Side) -> bool {
        self.wheelset.wheel(side).varies() || self.track.rail(side).varies()
    }

    /// Whether any wheel or rail varies along rolling.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.varies_on(Side::Left) || self.varies_on(Side::Right)
    }

    /// Whether its mirror image fore and aft is itself: nothing varies but for rollers, which are round.
    #[must_use]
    pub fn is_alike_backwards(&self) -> bool {
        [Side::Left, Side::Right].into_iter().all(|side| {
            !self.wheelset.wheel(side).varies() && self.track.rail(side).variation().is_none()
        })
    }

    /// Whether a side has a roller in place of its rail.
    #[must_use]
    pub fn has_rollers(&self) -> bool {
        [Side::Left, Side::Right].into_iter().any(|side| self.track.rail(side).roller().is_some())
    }

    /// The profiles of the wheel and of the rail of a side.
    #[must_use]
    pub fn profiles(&self, side: Side) -> [&Profile; 2] {
        let (wheel, rail) = match side {
            Side::Left => (&self.wheelset.left, &self.track.left),
            Side::Right => (&self.wheelset.right, &self.track.right),
        };
        [wheel.profile(), rail.profile()]
    }

    /// The same with the profiles of the left and the right wheel, and of the left and the right rail, where
    /// they are given: rails stay where they lie.
    ///
    /// # Errors
    /// [`GeometryError`] as by [`Wheel::with_profile`](crate::Wheel::with_profile),
    /// [`Wheelset::new`] and [`Rail::with_profile`](crate::Rail::with_profile).
    pub fn with_profiles(
        &self,
        wheels: [Option<&Profile>; 2],
        rails: [Option<&Profile>; 2],
    ) -> Result<Self, GeometryError> {
        let Wheelset { left, right, back_to_back } = &self.wheelset;
        let [left, right] = [(left, wheels[0]), (right, wheels[1])]
            .map(|(wheel, worn)| worn.map_or(Ok(wheel.clone()), |worn| wheel.with_profile(worn)));
        let wheelset = Wheelset::new(left?, right?, *back_to_back)?;
        let Track { left, right } = &self.track;
        let [left, right] = [(left, rails[0]), (right, rails[1])]
            .map(|(rail, worn)| worn.map_or(Ok(rail.clone()), |worn| rail.with_profile(worn)));
        Ok(Self { place: self.place, ..wheelset.on(Track { left: left?, right: right? }) })
    }

    /// The same wheelset in the same place of another track.
    #[must_use]
    pub fn on_track(&self, track: Track) -> Self {
        Self { track, ..self.clone() }
    }

    /// One side as a right-hand one.
    pub(crate) fn pair(&self, side: Side, position: Position) -> WheelRailPair<'_> {
        let (wheel, rail, position) = match side {
            Side::Right => (&self.wheelset.right, &self.track.right, position),
            Side::Left => (&self.wheelset.left, &self.track.left, position.mirrored()),
        };
        let [s, pitch] = self.place;
        // Under a wheel on a roller its top is always the same place.
        let s = if rail.roller().is_some() { 0.0 } else { s };
        let posed = Posed::new(wheel, &self.wheelset, position, pitch);
        WheelRailPair { posed, rail, s, is_guard: false }
    }

    /// The same with the guard rail, where there is one.
    fn guard_pair(&self, side: Side, position: Position) -> Option<WheelRailPair<'_>> {
        let rail = self.track.rail(side).guard()?;
        Some(WheelRailPair { rail, is_guard: true, ..self.pair(side, position) })
    }

    /// Height (m, down) at which a wheel first touches its rail or its guard rail as it comes down at `y` (m),
    /// `roll` and `yaw` (rad).
    ///
    /// # Errors
    /// As by [`WheelsetOnTrack::touch`].
    pub fn first_touch(
        &self,
        side: Side,
        y: f64,
        roll: f64,
        yaw: f64,
    ) -> Result<f64, GeometryError> {
        let z = self.touch(side, y, roll, yaw)?.z;
        let position = Position { y, z: 0.0, roll, yaw };
        let Some(pair) = self.guard_pair(side, position) else { return Ok(z) };
        // Mostly the flange stands beside the guard rail, and over none of it.
        Ok(pair.lowest().map_or(z, |lowest| z.min(lowest.gap())))
    }

    /// The least distance (m) in the track's cross-section between a wheel and its guard rail; zero where they
    /// overlap, `None` where there is no guard rail.
    ///
    /// # Errors
    /// [`GeometryError`] as by [`WheelsetOnTrack::contacts`].
    pub fn guard_clearance(
        &self,
        side: Side,
        position: &Position,
    ) -> Result<Option<f64>, GeometryError> {
        let position = position.check()?;
        let Some(pair) = self.guard_pair(side, position) else { return Ok(None) };
        if pair.overlaps().iter().any(|overlap| overlap.to > overlap.from) {
            return Ok(Some(0.0));
        }
        let rail: Vec<[f64; 2]> = pair.rail.outline();
        let wheel: Vec<[f64; 2]> = pair.seen_outline();
        let near = |points: &[[f64; 2]], lines: &[[f64; 2]]| {
            let to_line = |point: &[f64; 2]| {
                let all = lines.windows(2).map(|ends| distance_to(*point, [ends[0], ends[1]]));
                all.fold(f64::INFINITY, f64::min)
            };
            points.iter().map(to_line).fold(f64::INFINITY, f64::min)
        };
        Ok(Some(near(&wheel, &rail).min(near(&rail, &wheel))))
    }

    /// Where one wheel touches when the wheelset comes down at `y` (m), `roll` and `yaw` (rad).
    ///
    /// # Errors
    /// [`GeometryError::Apart`] where the profiles do not meet, [`GeometryError::End`] where they
    /// would meet at the end of one, [`GeometryError::Value`].
    pub fn touch(&self, side: Side, y: f64, roll: f64, yaw: f64) -> Result<Touch, GeometryError> {
        let position = Position { y, z: 0.0, roll, yaw }.check()?;
        let pair = self.pair(side, position);
        if pair.varies() {
            return varying_touch(side, &pair, y);
        }
        let lowest = pair.lowest().map_err(|end| match end {
            Some(end) => GeometryError::End { side, y: side.sense() * end },
            None => GeometryError::Apart { side, y },
        })?;
        Ok(touch(side, &pair, &lowest))
    }

    /// The position in which the wheelset rests on the track without load.
    ///
    /// With `roll` (rad) given it rests on one wheel or, by chance, on both; with `None` it rolls
    /// until both touch.
    ///
    /// # Errors
    /// [`GeometryError`] where the profiles do not meet.
    pub fn resting(&self, y: f64, yaw: f64, roll: Option<f64>) -> Result<Position, GeometryError> {
        let roll = match roll {
            Some(roll) => roll,
            None => self.free_roll(y, yaw)?,
        };
        let height = |side| self.touch(side, y, roll, yaw).map(|touch| touch.z);
        let z = height(Side::Left)?.min(height(Side::Right)?);
        Ok(Position { y, z, roll, yaw })
    }

    /// The roll at which both wheels touch at one height: chords, kept in a bracket.
    fn free_roll(&self, y: f64, yaw: f64) -> Result<f64, GeometryError> {
        let tilt = |roll: f64| -> Result<f64, GeometryError> {
            let height = |side| self.touch(side, y, roll, yaw).map(|touch| touch.z);
            Ok(height(Side::Right)? - height(Side::Left)?)
        };
        // The first chord: both wheels on level rails.
        let mut fall = -self.wheelset.tape_distance();
        let (mut roll, mut bracket) = (0.0, [-0.05f64, 0.05]);
        let mut excess = tilt(roll)?;
        for _ in 0..60 {
            bracket[usize::from(excess < 0.0)] = roll;
            let chord = roll - excess / fall;
            let inside = chord > bracket[0] && chord < bracket[1];
            let next = if inside { chord } else { bracket[0].midpoint(bracket[1]) };
            let step = next - roll;
            if step.abs() < 1e-12 {
                break;
            }
            let before = excess;
            (roll, excess) = (next, tilt(next)?);
            fall = (excess - before) / step;
        }
        Ok(roll)
    }

    /// Rolling radius of the right wheel less that of the left (m) at `y` (m), without yaw.
    ///
    /// EN 15302 leaves roll out (`Some(0.0)`); `None` lets the wheelset roll until both touch.
    ///
    /// # Errors
    /// [`GeometryError`] where the profiles do not meet.
    pub fn radius_difference(&self, y: f64, roll: Option<f64>) -> Result<f64, GeometryError> {
        let roll = match roll {
            Some(roll) => roll,
            None => self.free_roll(y, 0.0)?,
        };
        let radius = |side| self.touch(side, y, roll, 0.0).map(|touch| touch.radius);
        Ok(radius(Side::Right)? - radius(Side::Left)?)
    }

    /// All contacts of both wheels: the stretches on which the undeformed bodies overlap, the
    /// left wheel's first, each side's from the field side to the flange and then those on its guard rail. Overlaps less than
    /// 10 mm apart on the wheel, and inclined to each other by less than .35 rad, make one contact
    /// of several areas.
    ///
    /// # Errors
    /// [`GeometryError::End`] where an overlap reaches the end of a profile, and
    /// [`GeometryError::Value`].
    pub fn contacts(&self, position: &Position) -> Result<Vec<Contact<'_>>, GeometryError> {
        let mut contacts = self.contacts_of(Side::Left, position)?;
        contacts.extend(self.contacts_of(Side::Right, position)?);
        Ok(contacts)
    }

    /// What is seen along the track: the wheel's outline and the rail's profile as points `(y, z)`
    /// in track axes (m), at most `spacing` (m) apart.
    ///
    /// # Errors
    /// [`GeometryError::Value`].
    pub fn outlines(
        &self,
        side: Side,
        position: &Position,
        spacing: f64,
    ) -> Result<[Vec<[f64; 2]>; 2], GeometryError> {
        let WheelRailPair { posed, rail, .. } = self.pair(side, position.check()?);
        let track = |y: f64, z: f64| [side.sense() * y, z];
        let wheel = posed.wheel.profile().curve();
        let wheel = wheel.stations(spacing).into_iter().map(|s| {
            if let Some(outline) = posed.outline(s) {
                return track(outline.y, outline.z);
            }
            let [_, y, z] = posed.surface(wheel.at(s), 0.0);
            track(y, z)
        });
        let stations = rail.profile().curve().stations(spacing).into_iter();
        let rail = stations.map(|s| rail.at(s)).map(|point| track(point.y, point.z));
        Ok([wheel.collect(), rail.collect()])
    }

    /// The guard rail's profile as points `(y, z)` in track axes (m), at most `spacing` (m) apart; none where there is
    /// no guard rail.
    #[must_use]
    pub fn guard_outline(&self, side: Side, spacing: f64) -> Vec<[f64; 2]> {
        let Some(guard) = self.track.rail(side).guard() else { return Vec::new() };
        let points = guard.profile().curve().stations(spacing).into_iter().map(|s| guard.at(s));
        points.map(|point| [side.sense() * point.y, point.z]).collect()
    }

    /// The contacts of one wheel.
    ///
    /// # Errors
    /// As by [`WheelsetOnTrack::contacts`].
    pub fn contacts_of(
        &self,
        side: Side,
        position: &Position,
    ) -> Result<Vec<Contact<'_>>, GeometryError> {
        let position = position.check()?;
        let mut contacts = contacts_of_pair(side, self.pair(side, position))?;
        if let Some(guard) = self.guard_pair(side, position) {
            contacts.extend(contacts_of_pair(side, guard)?);
        }
        Ok(contacts)
    }
}

fn contacts_of_pair(
    side: Side,
    pair: WheelRailPair<'_>,
) -> Result<Vec<Contact<'_>>, GeometryError> {
    if pair.varies() {
        return varying_contact::contacts(side, pair);
    }
    let overlaps = merged(&pair, pair.overlaps()).into_iter();
    overlaps.filter_map(|overlap| Contact::of(side, pair, overlap).transpose()).collect()
}

/// Distance of a point from a line between two others.
fn distance_to([y, z]: [f64; 2], [[y0, z0], [y1, z1]]: [[f64; 2]; 2]) -> f64 {
    let (along, from) = ([y1 - y0, z1 - z0], [y - y0, z - z0]);
    let square = along[0] * along[0] + along[1] * along[1];
    let part = if square > 0.0 { (from[0] * along[0] + from[1] * along[1]) / square } else { 0.0 };
    let part = part.clamp(0.0, 1.0);
    (from[0] - part * along[0]).hypot(from[1] - part * along[1])
}

/// Neighbours joined.
fn merged(pair: &WheelRailPair<'_>, overlaps: Vec<Overlap>) -> Vec<Overlap> {
    let slope = |overlap: &Overlap| {
        let middle = pair.meeting(overlap.from.midpoint(overlap.to))?;
        Some(middle.rail.tangent[1].atan2(middle.rail.tangent[0]))
    };
    let mut merged: Vec<Overlap> = Vec::new();
    let mut before = None;
    for overlap in overlaps {
        let here = slope(&overlap);
        let turn = here.zip(before).map_or(0.0, |(here, before): (f64, f64)| (here - before).abs());
        before = here;
        match merged.last_mut() {
            Some(last) if overlap.from - last.to < ONE_CONTACT_WITHIN && turn < TURN => {
                (last.to, last.end) = (overlap.to, last.end.or(overlap.end));
            }
            _ => merged.push(overlap),
        }
    }
    merged
}

fn touch(side: Side, pair: &WheelRailPair, lowest: &Meeting) -> Touch {
    let Meeting { outline, rail_s, rail } = lowest;
    let sense = side.sense();
    let wheel = pair.posed.wheel.profile().curve().at(outline.s);
    Touch {
        z: lowest.gap(),
        radius: pair.posed.wheel.radius() + wheel.z,
        place: [outline.x, sense * rail.y, rail.z],
        y_rail: pair.rail.profile().curve().at(*rail_s).y,
        y_wheel: wheel.y,
        angle: sense * rail.tangent[1].atan2(rail.tangent[0]),
    }
}

/// The same of a pair that varies along rolling.
fn varying_touch(side: Side, pair: &WheelRailPair<'_>, y: f64) -> Result<Touch, GeometryError> {
    let lows = pair.lows(0.0);
    let lowest = lows.iter().min_by(|a, b| a.gap.total_cmp(&b.gap));
    let Some(low) = lowest else { return Err(GeometryError::Apart { side, y }) };
    if let Some(end) = pair.end_at(low) {
        return Err(GeometryError::End { side, y: side.sense() * end });
    }
    let sense = side.sense();
    let [x, at_y, _] = low.place;
    let on_rail = pair.rail.varying(low.rail.v, pair.s + x);
    let on_rail = on_rail.ok_or(GeometryError::Apart { side, y })?;
    let radius = pair.posed.distance_from_axle(low.place);
    Ok(Touch {
        z: low.gap,
        radius,
        place: [x, sense * at_y, low.rail.z],
        y_rail: on_rail.y,
        y_wheel: low.y_wheel,
        angle: sense * low.rail.slope[1].atan(),
    })
}
