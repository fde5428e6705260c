//! The picture of the stresses in the section through the contact's middle.

use creepage_plot::format::{Scale, quantity, significant};
use creepage_plot::{Axis, Bands, Label, Mark, Panel, Pen, Shape, Sheet};

use crate::stresses::{SECTION_STEPS, StressPoint, Stresses};

/// The contact, seen from the side.
const CONTACT: Pen = Pen { colour: "#c62828", dashes: "", width: 5.0 };
const LARGEST: Mark = Mark { size: 6.0, ..Mark::open(Shape::Target, "#c62828") };

impl Stresses {
    /// Equivalent stress by von Mises in the section, in shades, and stresses by depth at the place of
    /// `beneath`, as SVG.
    #[must_use]
    pub fn svg(&self, section: &[StressPoint], beneath: &[StressPoint]) -> String {
        let values: Vec<f64> = section.iter().map(|at| at.stress.von_mises()).collect();
        let [[x0, _], [a, _]] =
            self.solved.box_around().map(|pair| pair.map(|metres| 1e3 * metres));
        let range = [x0 - 2.0 * a, x0 + 2.0 * a];
        let bands = Bands::over([[range[0], 0.0], [range[1], 2.0 * a]], |[x, z]| {
            between(&values, [((x - x0) / a + 2.0) / 4.0, 0.5 * z / a])
        });
        let panel = bands.draw(Panel::new(
            Axis::new(range, Label::default().symbol("x").plain(", mm")),
            Axis::new([2.0 * a, 0.0], Label::default().symbol("z").plain(", mm")),
        ));
        let panel = panel.to_scale().curve(vec![[x0 - a, 0.0], [x0 + a, 0.0]], CONTACT);
        let largest = section
            .iter()
            .max_by(|one, two| one.stress.von_mises().total_cmp(&two.stress.von_mises()));
        let mark = largest.map(|at| [1e3 * at.point[0], 1e3 * at.point[2]]);
        let sheet = Sheet::new(&format!("Stresses in the {} body", self.body()))
            .note(self.setting())
            .panel(panel.marks(mark.into_iter().collect(), LARGEST))
            .panel(Self::by_depth(beneath))
            .key(CONTACT, Label::new("contact"))
            .key(Pen::of(0), Label::new("von Mises"))
            .key(Pen::of(1), Label::new("Tresca"));
        let sheet = match largest {
            Some(at) => {
                let value = quantity(at.stress.von_mises(), "Pa", 3);
                sheet.key(LARGEST, Label::new("largest here: ").number(&value))
            }
            None => sheet,
        };
        bands.key_below(sheet, "Pa").svg()
    }

    /// Equivalent stresses over the depth.
    fn by_depth(beneath: &[StressPoint]) -> Panel {
        let largest = beneath.iter().map(|at| at.stress.tresca()).fold(f64::MIN_POSITIVE, f64::max);
        let scale = Scale::of(largest, "Pa", 3);
        let curve = |of: fn(&StressPoint) -> f64| {
            beneath.iter().map(|at| [1e3 * at.point[2], of(at) / scale.factor]).collect()
        };
        let deepest = beneath.last().map_or(1.0, |at| 1e3 * at.point[2]);
        let place = beneath.first().map_or([0.0; 2], |at| [at.point[0], at.point[1]]);
        let [x, y] = place.map(|at| format!("{} mm", significant(1e3 * at, 3)));
        let stress =
            Label::new(&format!("below the largest, x = {x}, y = {y}: stress, {}", scale.unit));
        let panel = Panel::new(
            Axis::new([0.0, deepest], Label::default().symbol("z").plain(", mm")),
            Axis::new([0.0, 1.05 * largest / scale.factor], stress),
        );
        let panel = panel.height(260.0).curve(curve(|at| at.stress.von_mises()), Pen::of(0));
        panel.curve(curve(|at| at.stress.tresca()), Pen::of(1))
    }

    fn setting(&self) -> Label {
        let [[_, y], _] = self.solved.box_around();
        let plane = if y == 0.0 { "0".to_owned() } else { quantity(y, "m", 3) };
        Label::new("equivalent stress by von Mises in the plane ")
            .symbol("y")
            .plain(" = ")
            .plain(&plane)
            .plain("\u{2003}theory ")
            .plain(self.solved.theory.name)
            .plain("\u{2003}")
            .symbol("μ")
            .plain(" = ")
            .number(&significant(self.solved.case.friction(), 4))
            .plain("\u{2003}")
            .indexed("p", "0")
            .plain(" = ")
            .number(&quantity(self.solved.peak_pressure().value, "Pa", 4))
    }
}

/// The value at shares of the section's sides, interpolated between its points.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few dozen steps
fn between(values: &[f64], shares: [f64; 2]) -> f64 {
    let cell = |i: usize| {
        let place =
            (shares[i] * f64::from(SECTION_STEPS[i])).clamp(0.0, f64::from(SECTION_STEPS[i]));
        let low = place.floor().min(f64::from(SECTION_STEPS[i] - 1));
        (low as usize, place - low)
    };
    let ((i, right), (j, down)) = (cell(0), cell(1));
    let value = |i: usize, j: usize| {
        values.get(j * (SECTION_STEPS[0] as usize + 1) + i).copied().unwrap_or(f64::NAN)
    };
    let row = |j: usize| (1.0 - right) * value(i, j) + right * value(i + 1, j);
    (1.0 - down) * row(j) + down * row(j + 1)
}
