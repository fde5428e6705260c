//! Path of tangential shifts to and fro (Mindlin and Deresiewicz): what the bodies did before decides where they slip.

use super::partial_slip::{power_deficit, radius};
use super::{PartialSlipError, shift_compliances};
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
use crate::hertz::Hertz;

/// An axis of the contact ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShiftAxis {
    /// Along `x`.
    X,
    /// Along `y`.
    Y,
}

/// End of a step of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShiftEnd {
    /// At a tangential force of the upper body on the lower (N).
    Force(f64),
    /// At a shift of the upper body against the lower, far from the contact (m).
    Shift(f64),
}

/// A Hertz contact whose tangential force along one axis goes to and fro below the limit of friction, under a load that
/// stays or changes (Mindlin and Deresiewicz).
///
/// After each turn the reversed slip begins at the edge again, by the same law with twice the friction. A loop that
/// closes is forgotten, and the path goes on as if there had been none. As in
/// [`PartialSlip`](super::PartialSlip) traction has the direction of the force; slip has it too only for `sigma = 0`.
///
/// The traction is a sum of Hertz's tractions of all loads `n` below the present one, each with a share `t(n)` of
/// friction between -1 and 1, so that the force is `mu` times the integral of `t` over the load, and the shift that over
/// Hertz's approach. Slip turns the outermost shares to 1 or -1. A load that grows adds its own: without slip where the
/// force grows by less than `mu` times as much. A load that falls takes the outermost away.
///
/// ```
/// use creepage::statics::{ShiftAxis, ShiftEnd, ShiftPath};
/// use creepage::{Ellipse, Hertz, Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let ellipse = Ellipse::new(4e-3, 4e-3)?;
/// let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3)?;
/// let mut path = ShiftPath::new(&contact, 0.3, ShiftAxis::X)?;
/// path.to_force(12e3)?;
/// path.to_force(0.0)?; // the shift does not go back to zero
/// assert!((path.shift() / 0.9912e-6 - 1.0).abs() < 1e-3);
/// let before = path.dissipated();
/// path.to(120e3, ShiftEnd::Force(6e3))?; // load and force grow together: nothing slips
/// assert_eq!(path.dissipated(), before);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Sources: C. Cattaneo, Rend. Accad. Lincei 27 (1938); R.D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20 (1953) 327-344;
/// J. Jäger, Arch. Appl. Mech. 65 (1995) 478-487.
#[derive(Debug, Clone)]
pub struct ShiftPath {
    contact: Ellipse,
    /// Of the nominal load: that (N), `mu N` (N), the shift at which the bodies would slide (m), `mu` times the peak
    /// pressure (Pa).
    nominal: f64,
    limit: f64,
    unit: f64,
    bound: f64,
    /// From the inside out, together the load.
    layers: Vec<Layer>,
    /// Force and shift over their units.
    at: [f64; 2],
    /// Over `mu N` times the unit of shift.
    dissipated: f64,
    /// How the last step was given.
    end: Option<ShiftEnd>,
}

/// Loads one after the other that have one share of friction.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Layer {
    /// How much of the load it is, over the nominal one.
    width: f64,
    /// Of friction, from -1 to 1.
    share: f64,
}

/// Loads nearer to each other than this part are one: over so small a change the share of a step is known to 1e-7 no longer.
const SAME_LOAD: f64 = 1e-9;
/// Of force and shift that are summed over layers.
const ROUNDING: f64 = 1e-12;

/// Over which variable a step is straight: the load, or Hertz's approach, whose power of the load that is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Over {
    Load,
    Approach,
}

impl Over {
    fn power(self) -> f64 {
        match self {
            Self::Load => 1.0,
            Self::Approach => 2.0 / 3.0,
        }
    }

    /// Of a load over the nominal one.
    fn of(self, load: f64) -> f64 {
        match self {
            Self::Load => load,
            Self::Approach => load.cbrt().powi(2),
        }
    }

    /// Of that load less what it is `width` below, exact for thin layers too.
    fn step(self, load: f64, width: f64) -> f64 {
        if width >= load {
            return self.of(load);
        }
        match self {
            Self::Load => width,
            Self::Approach => self.of(load) * power_deficit(width / load, self.power()),
        }
    }

    /// How far below that load the variable is less by `step`.
    fn width(self, load: f64, step: f64) -> f64 {
        let whole = self.of(load);
        if step >= whole { load } else { load * power_deficit(step / whole, self.power().recip()) }
    }
}

impl ShiftPath {
    /// The Hertz contact `contact` with coefficient of friction `friction`, pressed, and not shifted yet.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn new(contact: &Hertz, friction: f64, axis: ShiftAxis) -> Result<Self, InvalidValue> {
        let friction = check::positive("friction", friction)?;
        let (pair, ellipse) = (contact.pair(), contact.ellipse());
        let bound = friction * contact.peak_pressure();
        let compliance = shift_compliances(ellipse, pair.poisson())[axis as usize];
        Ok(Self {
            contact: ellipse,
            nominal: contact.normal_force(),
            limit: friction * contact.normal_force(),
            unit: bound / pair.shear_modulus() * ellipse.minor() * compliance,
            bound,
            layers: vec![Layer { width: 1.0, share: 0.0 }],
            at: [0.0; 2],
            dissipated: 0.0,
            end: None,
        })
    }

    /// The same contact under its nominal load, not shifted yet.
    #[must_use]
    pub fn fresh(&self) -> Self {
        let layers = vec![Layer { width: 1.0, share: 0.0 }];
        Self { layers, at: [0.0; 2], dissipated: 0.0, end: None, ..*self }
    }

    /// Goes on under the same load until the tangential force of the upper body on the lower is `force` (N).
    ///
    /// # Errors
    /// As [`ShiftPath::to`].
    pub fn to_force(&mut self, force: f64) -> Result<(), PartialSlipError> {
        self.to_end(ShiftEnd::Force(force))
    }

    /// Goes on under the same load until the upper body is shifted by `shift` (m) against the lower, far from the
    /// contact.
    ///
    /// # Errors
    /// As [`ShiftPath::to`]: at [`ShiftPath::sliding_shift`] the bodies slide.
    pub fn to_shift(&mut self, shift: f64) -> Result<(), PartialSlipError> {
        self.to_end(ShiftEnd::Shift(shift))
    }

    /// Goes on under the same load to an end.
    ///
    /// # Errors
    /// As [`ShiftPath::to`].
    pub fn to_end(&mut self, end: ShiftEnd) -> Result<(), PartialSlipError> {
        self.apply_step(self.load(), end)
    }

    /// Goes on until the load is `normal_force` (N) and `end` is reached, both in proportion: the force with the load, a
    /// shift with Hertz's approach.
    ///
    /// # Errors
    /// [`PartialSlipError::Sliding`] when the force reaches the limit of friction under that load,
    /// [`PartialSlipError::Invalid`] unless all is finite and the load from a millionth to a million of the nominal one; the
    /// path stays where it was.
    pub fn to(&mut self, normal_force: f64, end: ShiftEnd) -> Result<(), PartialSlipError> {
        let load = normal_force / self.nominal;
        if !(1e-6..=1e6).contains(&load) {
            let valid = "from a millionth to a million times that of the contact";
            let (quantity, value) = ("normal_force", normal_force);
            return Err(InvalidValue { quantity, value, valid }.into());
        }
        self.apply_step(load, end)
    }

    /// Load (N).
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.nominal * self.load()
    }

    /// Tangential force of the upper body on the lower (N).
    #[must_use]
    pub fn force(&self) -> f64 {
        self.limit * self.at[0]
    }

    /// Shift of the upper body relative to the lower (m).
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.unit * self.at[1]
    }

    /// The shift at which the bodies slide under the present load (m).
    #[must_use]
    pub fn sliding_shift(&self) -> f64 {
        self.unit * Over::Approach.of(self.load())
    }

    /// The same under another load (N).
    #[must_use]
    pub fn sliding_shift_under(&self, normal_force: f64) -> f64 {
        self.unit * Over::Approach.of(normal_force / self.nominal)
    }

    /// Energy turned to heat since the bodies were pressed (J).
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        self.limit * self.unit * self.dissipated
    }

    /// How the last step was given; `None` before the first.
    #[must_use]
    pub fn last_end(&self) -> Option<ShiftEnd> {
        self.end
    }

    /// Semi-axes of the area that adheres, over those of the contact.
    #[must_use]
    pub fn adhesion(&self) -> f64 {
        let slips = self.layers.last().filter(|layer| layer.share.abs() >= 1.0);
        let width = slips.map_or(0.0, |layer| layer.width / self.load());
        1.0 - power_deficit(width.min(1.0), 1.0 / 3.0)
    }

    /// Traction on the lower body along the axis at `[x, y]` (Pa), zero outside the contact.
    #[must_use]
    pub fn traction(&self, point: [f64; 2]) -> f64 {
        let r = radius(self.contact, point);
        // Over the bound of the nominal load.
        let pressure = |load: f64| {
            let own = load.cbrt();
            ((own - r) * (own + r)).max(0.0).sqrt()
        };
        let (mut sum, mut inside) = (0.0, 0.0);
        for layer in &self.layers {
            let outside = inside + layer.width;
            sum += layer.share * (pressure(outside) - pressure(inside));
            inside = outside;
        }
        self.bound * sum
    }

    /// Over the nominal one.
    fn load(&self) -> f64 {
        match &self.layers[..] {
            [one] => one.width,
            layers => layers.iter().map(|layer| layer.width).sum(),
        }
    }

    fn apply_step(&mut self, load: f64, end: ShiftEnd) -> Result<(), PartialSlipError> {
        let (over, target) = match end {
            ShiftEnd::Force(force) => (Over::Load, check::finite("force", force)? / self.limit),
            ShiftEnd::Shift(shift) => (Over::Approach, check::finite("shift", shift)? / self.unit),
        };
        if target.abs() >= over.of(load) {
            let limit = self.limit * load;
            let force = if over == Over::Load { self.limit * target.abs() } else { limit };
            return Err(PartialSlipError::Sliding { force, limit });
        }
        let before = self.load();
        let own = usize::from(over == Over::Approach);
        if (load - before).abs() <= SAME_LOAD * before {
            // Where it is already, rounding would turn it back.
            if (target - self.at[own]).abs() > ROUNDING * over.of(before) {
                self.slip(over, target);
            }
        } else if load < before || !self.grow_without_slip(load, before, over, target) {
            self.change_load(load, before, over, target);
        }
        self.at = [Over::Load, Over::Approach].map(|over| self.sum(over));
        self.at[own] = target;
        self.end = Some(end);
        Ok(())
    }

    /// A load that grows brings its own share of the step, unless that is beyond friction.
    fn grow_without_slip(&mut self, load: f64, before: f64, over: Over, target: f64) -> bool {
        let width = load - before;
        let share = (target - self.sum(over)) / over.step(load, width);
        let holds = share.abs() <= 1.0;
        if holds {
            self.push(Layer { width, share });
        }
        holds
    }

    /// Slip from the outside in under the present load, until force or shift is `target`.
    fn slip(&mut self, over: Over, target: f64) {
        let mut way = target - self.sum(over);
        let (load, sign) = (self.load(), way.signum());
        let mut edge = load;
        while way * sign > 0.0
            && let Some(layer) = self.layers.pop()
        {
            let (turn, from) = (sign - layer.share, self.outside_of(layer, edge));
            let whole = over.step(from, layer.width);
            let part = if turn == 0.0 { whole } else { (way / turn).min(whole) };
            let width = if part < whole { over.width(from, part) } else { layer.width };
            self.dissipated += turn.abs() * heat([from, from - width], [load; 2], over);
            self.keep(layer, width);
            way -= turn * part;
            edge = from - width;
        }
        self.fill(load, sign);
    }

    /// A load that goes to `load`. Where it falls it takes the outermost shares away, and surfaces slip from the outside
    /// in where what goes with them is not what the step asks for. Where it grows all of what it adds slips.
    #[allow(clippy::float_cmp)] // shares that slip has set have the same bits
    fn change_load(&mut self, load: f64, before: f64, over: Over, target: f64) {
        let mut now = before;
        // The share that would come or go with the load alone.
        let asked = (self.sum(over) - target) / (over.of(now) - over.of(load));
        let grows = load > before;
        'on: while now != load
            && let Some(outermost) = self.layers.last().copied()
        {
            if !grows && outermost.share == asked {
                let left = (now - load).min(outermost.width);
                self.layers.pop();
                self.keep(outermost, left);
                now -= left;
                continue;
            }
            let sign = if grows { asked } else { outermost.share - asked }.signum();
            let mut edge = now;
            while let Some(layer) = self.layers.pop() {
                let (turn, from) = (sign - layer.share, self.outside_of(layer, edge));
                if turn == 0.0 {
                    edge = from - layer.width;
                    continue;
                }
                // The variable of the load falls by `rate` times that of the edge of adhesion, which it may meet.
                // Where the load grows that is below zero.
                let rate = turn / (sign - asked);
                let whole = over.step(from, layer.width);
                let left = (over.of(now) - over.of(load)) / rate;
                let apart = (over.of(now) - over.of(from)).max(0.0);
                let meeting = if rate > 1.0 { apart / (rate - 1.0) } else { f64::INFINITY };
                let part = whole.min(left).min(meeting);
                let width = if part < whole { over.width(from, part) } else { layer.width };
                let after = if part == left {
                    load
                } else if part == meeting {
                    from - width
                } else {
                    now - over.width(now, rate * part)
                };
                self.dissipated += turn.abs() * heat([from, from - width], [now, after], over);
                self.keep(layer, width);
                (now, edge) = (after, from - width);
                if part == left {
                    self.fill(load, sign);
                    return;
                }
                if part == meeting {
                    continue 'on;
                }
            }
            // All of it slips, but for rounding.
            self.fill(load, sign);
            return;
        }
    }

    /// Where a layer that was the outermost ends: the innermost one at its width, but for rounding.
    fn outside_of(&self, layer: Layer, edge: f64) -> f64 {
        if self.layers.is_empty() { layer.width } else { edge }
    }

    /// Puts back what is left of a layer without its outer part.
    fn keep(&mut self, layer: Layer, without: f64) {
        if without < layer.width {
            self.layers.push(Layer { width: layer.width - without, ..layer });
        }
    }

    /// What slips, up to the load.
    fn fill(&mut self, load: f64, share: f64) {
        let inside: f64 = self.layers.iter().map(|layer| layer.width).sum();
        self.push(Layer { width: load - inside, share });
    }

    #[allow(clippy::float_cmp)] // shares that slip has set have the same bits
    fn push(&mut self, layer: Layer) {
        match self.layers.last_mut() {
            _ if layer.width <= 0.0 => {}
            Some(last) if last.share == layer.share => last.width += layer.width,
            _ => self.layers.push(layer),
        }
    }

    /// Force or shift of all layers, over its unit.
    fn sum(&self, over: Over) -> f64 {
        let (mut outside, mut sum) = (self.load(), 0.0);
        for (index, layer) in self.layers.iter().enumerate().rev() {
            // The innermost begins at no load, but for rounding.
            let width = if index == 0 { outside } else { layer.width };
            sum += layer.share * over.step(outside, width);
            outside = if index == 1 { self.layers[0].width } else { outside - layer.width };
        }
        sum
    }
}

/// Energy turned to heat while the edge of adhesion goes inwards from one load to another, where slip turns the share of
/// friction by one, and the load falls in proportion with it; all over nominal values.
#[allow(clippy::float_cmp)] // a load that stays has the same bits
fn heat([from, to]: [f64; 2], [before, after]: [f64; 2], over: Over) -> f64 {
    let five_thirds = |load: f64| load.max(0.0).cbrt().powi(5);
    if before == after {
        let part = |edge: f64| dissipation(((before - edge) / before).clamp(0.0, 1.0));
        return five_thirds(before) * (part(to) - part(from)).max(0.0);
    }
    // The integral of e'(N) (n - N) - e(n) + e(N) over the edge N, with e the approach, in closed form.
    let approach = |load: f64| Over::Approach.of(load.max(0.0));
    let (edges, way) = (five_thirds(from) - five_thirds(to), from - to);
    let [first, last] = [before, after].map(approach);
    let mixed = if over == Over::Load {
        let fall = before - after;
        let mean = 0.6 * five_thirds(before) * power_deficit(fall / before, 5.0 / 3.0) / fall;
        approach(from) * before - approach(to) * after - 0.6 * fall / way * edges - mean * way
    } else {
        let (fall, approached) = (first - last, approach(from) - approach(to));
        let mean = 0.4 * first.powf(2.5) * power_deficit(fall / first, 2.5) / fall;
        mean * approached - first * from + last * to + 0.4 * fall / approached * edges
    };
    // Two large numbers cancel for a short step.
    if way > 0.0 { (mixed + 0.2 * edges).max(0.0) } else { 0.0 }
}

/// Energy turned to heat on the way from zero to a force of so many `mu N`, over `mu N` and the unit of shift.
fn dissipation(share: f64) -> f64 {
    let gap = power_deficit(share, 1.0 / 3.0);
    let ratio = 1.0 - gap;
    gap.powi(3) * (1.0 + 3.0 * ratio + ratio * ratio) / 5.0
}
