//! Measured points laid over creep-force curves.

use creepage::Creepage;

use super::points::{CREEPAGE, MeasuredError, MeasuredPoints};
use crate::{Component, Curves};

/// Creepages and loads that differ by less than this part count as one: what instruments resolve.
const SAME: f64 = 0.02;

/// A measured point in the units of the curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Overlaid {
    /// Its row of the table.
    pub(crate) row: usize,
    pub(crate) creepage: Creepage,
    /// `f_x`, `f_y` over its own `mu N`, where they were measured.
    pub(crate) force: [Option<f64>; 2],
    /// Whether the creepages that the curves hold, or its load, are other ones.
    pub(crate) is_apart: bool,
}

impl Curves {
    /// Lays measured points over the curves, in the units of the case's contact and friction. Gives what
    /// is to be said of it, a line each: what of the table was left out, and which points were measured
    /// at other creepages or another load than the curves hold; these are drawn open.
    ///
    /// # Errors
    /// [`MeasuredError::NotVaried`] where the points have no value of what the curves vary.
    pub fn lay_over(&mut self, measured: &MeasuredPoints) -> Result<Vec<String>, MeasuredError> {
        let vary = Component::ALL.iter().position(|one| *one == self.vary).unwrap_or(0);
        if measured.points.iter().any(|point| point.creepage[vary].is_none()) {
            return Err(MeasuredError::NotVaried { column: CREEPAGE[vary] });
        }
        let scaling = self.contact.scaling();
        let units = [scaling.slip, scaling.slip, scaling.slip / scaling.length];
        let friction = self.contact.friction().unwrap_or(1.0);
        let normal = scaling.force / friction;
        let held = self.creepage.components();
        let (mut points, mut notes) = (Vec::new(), measured.left_out());
        for point in &measured.points {
            let mut own = held;
            for k in 0..3 {
                own[k] = point.creepage[k].map_or(held[k], |value| value / units[k]);
            }
            let [xi, eta, chi] = own;
            let Ok(creepage) = Creepage::new(xi, eta, chi) else {
                notes.push(format!("row {}: its creepage is out of range; left out", point.row));
                continue;
            };
            let load = point.normal_force.unwrap_or(normal);
            let force = measured.newtons(point, normal).map(|f| Some(f? / (friction * load)));
            let is_other = |k: usize| {
                k != vary && (own[k] - held[k]).abs() > SAME * (1.0_f64).max(held[k].abs())
            };
            let is_apart = (0..3).any(is_other) || (load / normal - 1.0).abs() > SAME;
            points.push(Overlaid { row: point.row, creepage, force, is_apart });
        }
        let apart: Vec<_> = points.iter().filter(|point| point.is_apart).collect();
        if !apart.is_empty() {
            let rows: Vec<_> = apart.iter().map(|point| point.row.to_string()).collect();
            notes.push(format!(
                "rows {}: measured at another creepage or load than the curves hold; drawn open",
                rows.join(", ")
            ));
        }
        self.measured = points;
        Ok(notes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{CURVE, case};

    #[test]
    fn points_are_in_the_units_of_the_curves() {
        let case = case(1.0, CURVE);
        let scaling = case.contact.scaling();
        let mut curves = Curves::new(&case, Component::Lateral, vec![0.0, 1.0]).unwrap();
        let table = format!(
            "lateral,lateral_force,longitudinal\n{:e},{:e},{:e}\n{:e},{:e},1\n",
            0.5 * scaling.slip,
            0.25 * scaling.force,
            CURVE[0] * scaling.slip,
            scaling.slip,
            scaling.force
        );
        let notes = curves.lay_over(&MeasuredPoints::read(&table).unwrap()).unwrap();
        assert_eq!(notes.len(), 1, "{notes:?}");
        let [one, two] = curves.measured[..] else { panic!("two points") };
        assert!((one.creepage.eta() - 0.5).abs() < 1e-12 && !one.is_apart && two.is_apart);
        assert!((one.force[1].unwrap() - 0.25).abs() < 1e-12 && one.force[0].is_none());
        let text = String::from_utf8(curves.csv().unwrap()).unwrap();
        assert_eq!(text.matches("measured").count(), 2);
        assert!(curves.svg().contains("measured"));
    }

    #[test]
    fn points_without_what_varies_are_refused() {
        let mut curves = Curves::new(&case(1.0, CURVE), Component::Spin, vec![0.0, 1.0]).unwrap();
        let measured = MeasuredPoints::read("lateral,lateral_force\n1,2\n").unwrap();
        assert!(curves.lay_over(&measured).unwrap_err().to_string().starts_with("column spin"));
    }
}
