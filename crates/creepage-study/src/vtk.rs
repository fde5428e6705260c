//! `contact.vtk`: the field on a grid that fits the ellipse, in SI units, for `ParaView` and others
//! that read VTK's legacy format.

use std::f64::consts::PI;
use std::fmt::Write;

use creepage::{FieldPoint, Region};

use crate::SolvedCase;
use crate::gap::OnAreas;

/// Points along and across.
const GRID_POINTS: u32 = 49;
/// The outermost points lie this share of the way to the edge: on it the traction has a bound of
/// zero, and linear theory's none at all.
const OUTERMOST: f64 = 0.999;

impl SolvedCase {
    /// The grid with pressure, tractions, slip, areas and frictional power. What the theory does
    /// not give everywhere is left out.
    pub(crate) fn vtk(&self) -> String {
        if let Some(on_areas) = OnAreas::of(self) {
            return on_areas.field().vtk();
        }
        let positions = self.positions(&grid().collect::<Vec<_>>());
        let field = self.field(&positions);
        let mut vtk = Vtk(self.head(positions.len()));
        let length = self.scaling().length;
        vtk.rows(positions.iter().map(|[x, y]| [x * length, y * length, 0.0]));
        vtk.line(&format!("POINT_DATA {}", positions.len()));
        let pressure = self.peak_pressure().value;
        vtk.scalars("pressure_pa", field.iter().map(|p| pressure * self.bound(p.position)));
        let traction = self.scaling().traction;
        vtk.vectors("traction_pa", field.iter().map(|p| p.traction.map(|t| t * traction)));
        let sticks = |p: &FieldPoint| f64::from(u8::from(p.region == Region::Adhesion));
        vtk.scalars("adhesion", field.iter().map(sticks));
        if field.iter().all(|p| p.slip.iter().all(|slip| slip.is_finite())) {
            vtk.vectors("slip", field.iter().map(|p| p.slip.map(|s| s * self.scaling().slip)));
            let power = |p| self.power_density(p);
            vtk.scalars("frictional_power_per_metre_j_per_m3", field.iter().map(power));
            if let Some(speed) = self.case.speed() {
                let watts = field.iter().map(|p| speed * self.power_density(p));
                vtk.scalars("frictional_power_w_per_m2", watts);
            }
        }
        vtk.0
    }

    fn head(&self, points: usize) -> String {
        let name = self.theory.name;
        format!(
            "# vtk DataFile Version 3.0\n\
             creepage {}: theory {name}; SI units, on the lower body, x along rolling\n\
             ASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS {GRID_POINTS} {GRID_POINTS} 1\n\
             GRID_POINTS {points} float\n",
            env!("CARGO_PKG_VERSION")
        )
    }
}

/// Points `(x/a, y/b)`: lines along the rolling direction, each over its own length, closer to one
/// another towards the edge.
fn grid() -> impl Iterator<Item = [f64; 2]> {
    let place = |k: u32| {
        let angle = PI * (f64::from(k) / f64::from(GRID_POINTS - 1) - 0.5);
        (OUTERMOST * angle.sin(), OUTERMOST * angle.cos())
    };
    (0..GRID_POINTS).flat_map(move |j| {
        let (y, half) = place(j);
        (0..GRID_POINTS).map(move |i| [half * place(i).0 / OUTERMOST, y])
    })
}

/// A file of VTK's legacy format.
pub(crate) struct Vtk(pub(crate) String);

impl Vtk {
    pub(crate) fn line(&mut self, line: &str) {
        self.0.push_str(line);
        self.0.push('\n');
    }

    pub(crate) fn scalars(&mut self, name: &str, values: impl Iterator<Item = f64>) {
        self.line(&format!("SCALARS {name} float 1\nLOOKUP_TABLE default"));
        self.rows(values.map(|value| [value]));
    }

    pub(crate) fn vectors(&mut self, name: &str, values: impl Iterator<Item = [f64; 2]>) {
        self.line(&format!("VECTORS {name} float"));
        self.rows(values.map(|[x, y]| [x, y, 0.0]));
    }

    pub(crate) fn rows<const N: usize>(&mut self, rows: impl Iterator<Item = [f64; N]>) {
        for row in rows {
            for (k, value) in row.into_iter().enumerate() {
                let gap = if k == 0 { "" } else { " " };
                // Writing to a String cannot fail.
                let _ = write!(self.0, "{gap}{value:.6e}");
            }
            self.0.push('\n');
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::Case;
    use crate::testing::{CURVE, SLIDING, Trial, case, report, solved};

    use super::*;

    /// The numbers of a data array, by its name.
    fn array(vtk: &str, name: &str) -> Vec<f64> {
        let lines = vtk.lines().skip_while(|line| line.split(' ').nth(1) != Some(name)).skip(1);
        let numbers = lines.skip_while(|line| line.starts_with("LOOKUP")).take_while(|line| {
            line.starts_with(|first: char| first == '-' || first.is_ascii_digit())
        });
        numbers.flat_map(|line| line.split(' ')).map(|cell| cell.parse().unwrap()).collect()
    }

    const COUNT: usize = (GRID_POINTS * GRID_POINTS) as usize;

    #[test]
    fn every_array_is_as_long_as_the_grid() {
        let vtk = solved(&Case { speed: Some(20.0), ..case(2.25, CURVE) }, SLIDING).vtk();
        assert!(vtk.starts_with("# vtk DataFile Version 3.0\ncreepage "));
        assert_eq!(array(&vtk, &COUNT.to_string()).len(), 3 * COUNT);
        for (name, components) in [
            ("pressure_pa", 1),
            ("traction_pa", 3),
            ("adhesion", 1),
            ("slip", 3),
            ("frictional_power_per_metre_j_per_m3", 1),
            ("frictional_power_w_per_m2", 1),
        ] {
            assert_eq!(array(&vtk, name).len(), components * COUNT, "{name}");
        }
    }

    #[test]
    fn power_is_traction_times_slip_and_traction_is_at_its_bound() {
        let vtk = report(0.5, SLIDING, CURVE).vtk();
        let [power, pressure] =
            ["frictional_power_per_metre_j_per_m3", "pressure_pa"].map(|name| array(&vtk, name));
        let [traction, slip] = ["traction_pa", "slip"].map(|name| array(&vtk, name));
        for k in 0..COUNT {
            let [t, s] = [&traction, &slip].map(|v| [v[3 * k], v[3 * k + 1]]);
            // Written to seven digits; of the product each factor is.
            assert!((t[0].hypot(t[1]) / (0.3 * pressure[k]) - 1.0).abs() < 2e-6);
            assert!((power[k] - (t[0] * s[0] + t[1] * s[1])).abs() <= 2e-6 * power[k].abs());
            assert!(power[k] > 0.0);
        }
        assert!(array(&vtk, "adhesion").iter().all(|sticks| *sticks < 0.5));
    }

    #[test]
    fn slip_that_a_theory_does_not_give_is_left_out() {
        let vtk = report(1.0, Trial::Sticking, CURVE).vtk();
        assert!(!vtk.contains("slip") && !vtk.contains("power"));
        let sticking = array(&vtk, "adhesion");
        assert!(sticking.iter().any(|s| *s > 0.5) && sticking.iter().any(|s| *s < 0.5));
    }
}
