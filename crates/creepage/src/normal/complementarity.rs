//! The complementarity problem of normal contact by conjugate gradients with an active set (Polonsky and Keer
//! 1999): `A p >= d`, `p >= 0`, `p (A p - d) = 0`.
//!
//! Conjugate gradients on the pressed cells; after every step negative pressures are cut off
//! and cells that penetrate are taken in (Polonsky & Keer, Wear 231, 1999). A step that raises
//! the energy `p A p / 2 - d p` is replaced by a projected gradient step, which cannot.

use super::product::{Product, dot};

/// Pressures on cells, and how well they solve the problem.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PressureState {
    pub(super) pressures: Vec<f64>,
    /// Distances of the deformed bodies.
    pub(super) distance: Vec<f64>,
    /// Largest distance of a pressed cell from touching and largest penetration of another.
    pub(super) residual: f64,
}

/// Solves for depths `d` from starting pressures until the residual is below `tolerance`.
pub(super) fn solve(
    product: &mut Product,
    depths: &[f64],
    start: Vec<f64>,
    tolerance: f64,
) -> PressureState {
    Iteration::new(product, depths, start).run(tolerance)
}

struct Iteration<'a> {
    product: &'a mut Product,
    depths: &'a [f64],
    pressures: Vec<f64>,
    /// Displacement less depth: the distance of the deformed bodies.
    distance: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    products: usize,
}

impl<'a> Iteration<'a> {
    fn new(product: &'a mut Product, depths: &'a [f64], start: Vec<f64>) -> Self {
        let zeros = vec![0.0; depths.len()];
        let mut iteration = Self {
            product,
            depths,
            pressures: start,
            distance: zeros.clone(),
            direction: zeros.clone(),
            image: zeros,
            products: 0,
        };
        iteration.scale_start();
        iteration
    }

    /// The multiple of the starting pressures that has the least energy.
    fn scale_start(&mut self) {
        self.product.apply(&self.pressures, &mut self.image);
        self.products += 1;
        let (work, energy) = (dot(&self.pressures, self.depths), dot(&self.pressures, &self.image));
        let factor = if energy > 0.0 && work > 0.0 { work / energy } else { 0.0 };
        for i in 0..self.pressures.len() {
            self.pressures[i] *= factor;
            self.distance[i] = self.image[i] * factor - self.depths[i];
        }
    }

    fn run(mut self, tolerance: f64) -> PressureState {
        const MAX_STEPS: usize = 600;
        let mut keep = 0.0;
        let mut last_square = 1.0;
        let mut energy = self.energy();
        while self.products < MAX_STEPS && self.residual() > tolerance {
            let square = self.square();
            self.turn(keep * square / last_square);
            last_square = square;
            let before = (self.pressures.clone(), self.distance.clone());
            keep = f64::from(self.step());
            let now = self.energy();
            if now > energy + 1e-14 * energy.abs() {
                (self.pressures, self.distance) = before;
                self.project();
                keep = 0.0;
            }
            energy = self.energy();
        }
        let residual = self.residual();
        PressureState { pressures: self.pressures, distance: self.distance, residual }
    }

    fn energy(&self) -> f64 {
        let half = self
            .pressures
            .iter()
            .zip(&self.distance)
            .zip(self.depths)
            .map(|((p, g), d)| p * (g - d));
        0.5 * half.sum::<f64>()
    }

    fn residual(&self) -> f64 {
        self.pressures
            .iter()
            .zip(&self.distance)
            .map(|(&p, &g)| if p > 0.0 { g.abs() } else { -g })
            .fold(0.0, f64::max)
    }

    fn square(&self) -> f64 {
        let pressed = self.pressures.iter().zip(&self.distance).filter(|(p, _)| **p > 0.0);
        pressed.map(|(_, g)| g * g).sum()
    }

    /// The next direction: the distance on pressed cells, and a share of the last direction.
    fn turn(&mut self, share: f64) {
        for ((t, &g), &p) in self.direction.iter_mut().zip(&self.distance).zip(&self.pressures) {
            *t = if p > 0.0 { g + share * *t } else { 0.0 };
        }
    }

    /// One step along the direction; false when the set of pressed cells grew.
    fn step(&mut self) -> bool {
        self.product.apply(&self.direction, &mut self.image);
        self.products += 1;
        let curvature = dot(&self.direction, &self.image);
        let length =
            if curvature > 0.0 { dot(&self.distance, &self.direction) / curvature } else { 0.0 };
        let (mut cut, mut grown) = (false, false);
        for i in 0..self.pressures.len() {
            if self.pressures[i] > 0.0 {
                self.pressures[i] -= length * self.direction[i];
                if self.pressures[i] < 0.0 {
                    self.pressures[i] = 0.0;
                    cut = true;
                }
            } else if self.distance[i] < 0.0 {
                self.pressures[i] = -length.abs() * self.distance[i];
                grown |= length != 0.0;
            }
        }
        if cut || grown || length == 0.0 {
            self.measure();
        } else {
            for (g, q) in self.distance.iter_mut().zip(&self.image) {
                *g -= length * q;
            }
        }
        !grown && length != 0.0
    }

    fn measure(&mut self) {
        self.product.apply(&self.pressures, &mut self.distance);
        self.products += 1;
        for (g, d) in self.distance.iter_mut().zip(self.depths) {
            *g -= d;
        }
    }

    /// A step down the gradient, cut off at zero, halved until the energy falls.
    fn project(&mut self) {
        const HALVINGS: usize = 30;
        let energy = self.energy();
        let (pressures, distance) = (self.pressures.clone(), self.distance.clone());
        self.product.apply(&distance, &mut self.image);
        self.products += 1;
        let curvature = dot(&distance, &self.image);
        let mut length = if curvature > 0.0 { dot(&distance, &distance) / curvature } else { 1.0 };
        for _ in 0..HALVINGS {
            for ((new, &p), &g) in self.pressures.iter_mut().zip(&pressures).zip(&distance) {
                *new = (p - length * g).max(0.0);
            }
            self.measure();
            if self.energy() <= energy {
                return;
            }
            length *= 0.5;
        }
        (self.pressures, self.distance) = (pressures, distance);
    }
}
