//! The picture of a problem without rolling, seen from above.

use creepage_plot::format::quantity;
use creepage_plot::theme::DARK;
use creepage_plot::{Arrows, Bands, Cell, Label, Panel, Pen, Sample, Table, TopView, ellipse};

use super::StaticsReport;
use super::field::Field;
use crate::Quantity;
use crate::contact_picture::TARGET;

/// The line of a die's lift-off limit.
const LIMIT: Pen = Pen { colour: DARK, dashes: "6 4", width: 1.8 };
/// The edge of the adhesion area.
const ADHESION: Pen = Pen { colour: DARK, dashes: "", width: 2.6 };
const ROW: f64 = 25.0;
/// Significant digits of its numbers.
const DIGITS: usize = 4;

impl StaticsReport<'_> {
    /// The contact seen from above, as SVG; of a rectangle force over shift.
    #[must_use]
    pub fn svg(&self) -> String {
        if matches!(self.field, Field::Rectangle(_)) {
            return self.path_svg();
        }
        self.top_view().svg(self.title)
    }

    fn top_view(&self) -> TopView {
        let axes = [self.ellipse.a(), self.ellipse.b()];
        let at = |disc: [f64; 2]| [0, 1].map(|i| axes[i] * disc[i]);
        let view = TopView::new(self.title, axes).aside(self.source()).note(self.setting());
        let bands = Bands::new(|disc| self.field.intensity(at(disc)), self.field.is_singular());
        let tractions =
            view.lattice().into_iter().map(|disc| (disc, self.field.traction(at(disc))));
        let arrows = view.arrows(tractions.collect());
        let figure = arrows.draw(self.marks(TopView::panel()));
        let view = view.ground(bands.draw(TopView::panel())).figure(figure).table(self.table());
        self.key(view, &bands, &arrows)
    }

    fn source(&self) -> &'static str {
        match self.field {
            Field::Die { .. } => "Kalker 1967, section 3.211",
            Field::Bonded(_) => "Cattaneo, Mindlin; Kalker 1967, section 3.212",
            Field::PartialSlip(_) => "Cattaneo, Mindlin; Kalker 1967, section 3.222",
            Field::ShiftPath(..) => "Mindlin, Deresiewicz 1953",
            Field::Compression(_) => "Spence 1975; Kalker 1967, equations 2.11 and 2.15",
            Field::Rectangle(_) => "Cerruti; Hou, Kalousek, Magel 1997",
        }
    }

    /// What is given, below the title.
    fn setting(&self) -> Label {
        let equations = self.numbers.of_section("given").filter_map(equation);
        let line = equations.reduce(|line, next| line.plain("\u{2003}").joined(&next));
        line.unwrap_or_default()
    }

    /// The lift-off limit and the load of a die, or the edge of the adhesion area.
    fn marks(&self, panel: Panel) -> Panel {
        match self.field {
            Field::Die { offset, .. } => {
                let place = [offset[0] / self.ellipse.a(), offset[1] / self.ellipse.b()];
                panel.curve(ellipse([1.0 / 3.0; 2]), LIMIT).marks(vec![place], TARGET)
            }
            Field::Bonded(_) | Field::Rectangle(_) => panel,
            Field::PartialSlip(partial) => {
                panel.curve(ellipse([partial.adhesion().a() / self.ellipse.a(); 2]), ADHESION)
            }
            Field::ShiftPath(path, _) => panel.curve(ellipse([path.adhesion(); 2]), ADHESION),
            Field::Compression(compression) => {
                let adhesion = compression.stick_radius() / self.ellipse.a();
                panel.curve(ellipse([adhesion; 2]), ADHESION)
            }
        }
    }

    fn key(&self, view: TopView, bands: &Bands, arrows: &Arrows) -> TopView {
        let name = match self.field {
            Field::Die { .. } => "pressure",
            _ => "traction on the lower body",
        };
        let mut view = bands.key(view.key(Sample::Blank, Label::new(name)), "Pa");
        if self.field.is_singular() {
            view = view.key(Sample::Blank, Label::new("without bound at the edge"));
        }
        if let Some((sample, traction)) = arrows.sample(1.0) {
            view = view.key(sample, Label::default().number(&quantity(traction, "Pa", 3)));
        }
        match self.field {
            Field::Die { .. } => {
                view.key(TARGET, Label::new("the load")).key(LIMIT, Label::new("limit of lift-off"))
            }
            Field::Bonded(_) | Field::Rectangle(_) => view,
            Field::PartialSlip(_) | Field::ShiftPath(..) | Field::Compression(_) => {
                view.key(ADHESION, Label::new("edge of the adhesion area"))
            }
        }
    }

    /// What was found, in two columns.
    fn table(&self) -> Table {
        let found: Vec<_> = self.numbers.of_section("found").collect();
        let (left, right) = found.split_at(found.len().div_ceil(2));
        let cells = |quantity: &&Quantity| {
            let name = Label::new(&quantity.label.replace("mu N", "μN"));
            let number = Label::default().number(&written(quantity));
            [Cell::Name(name), Cell::Number(number)]
        };
        let table = Table::new(&[0.0, 242.0, 486.0, 728.0]);
        left.iter().enumerate().fold(table, |table, (row, quantity)| {
            let both =
                cells(quantity).into_iter().chain(right.get(row).into_iter().flat_map(cells));
            table.row(ROW, both.collect())
        })
    }
}

/// The number and its unit, as there is room for.
fn written(quantity: &Quantity) -> String {
    quantity.text_to(DIGITS).unwrap_or_default()
}

/// `symbol = number unit`, of what has a symbol.
fn equation(quantity: &Quantity) -> Option<Label> {
    let [letter, index] = match quantity.name {
        "normal_force" => ["N", ""],
        "friction" => ["μ", ""],
        "offset_x" => ["x", "N"],
        "offset_y" => ["y", "N"],
        "moment" => ["M", "z"],
        "force_x" => ["F", "x"],
        "force_y" => ["F", "y"],
        "radius" => ["R", ""],
        "semi_axis_rolling" => ["a", ""],
        "semi_axis_lateral" => ["b", ""],
        "shear_modulus" => ["G", ""],
        "poisson" => ["σ", ""],
        _ => return None,
    };
    let label = Label::default();
    let label = if index.is_empty() { label.symbol(letter) } else { label.indexed(letter, index) };
    Some(label.plain(" = ").number(&written(quantity)))
}

#[cfg(test)]
mod tests {
    use creepage::SiForce;
    use creepage::statics::{Bonded, Compression, Die, PartialSlip, ShiftAxis, ShiftPath};
    use creepage::{Ellipse, Hertz, Solid, SolidPair};

    use super::*;
    use crate::testing::{CURVE, case, check_view};

    const RATIOS: [f64; 7] = [1e-3, 0.05, 0.6, 1.0, 1.6, 6.0, 1e3];

    fn check(report: &StaticsReport) {
        check_view(&report.svg(), report.top_view().on_the_sheet());
    }

    fn rubber() -> Solid {
        Solid::new(1.2345e6, 0.49).unwrap()
    }

    #[test]
    fn the_die_is_drawn_at_every_ratio_and_up_to_lift_off() {
        for ratio in RATIOS {
            let base = Ellipse::new(7e-3 * ratio, 7e-3).unwrap();
            for share in [0.0, 0.6, 1.0] {
                let offset = [share * base.a() / 3.0, 0.0];
                let die = Die::new(rubber(), base, 123.4, offset).unwrap();
                check(&StaticsReport::die(rubber(), base, 123.4, offset, &die).unwrap());
            }
        }
    }

    #[test]
    fn shift_and_twist_are_drawn_at_every_ratio() {
        for ratio in RATIOS {
            let (pair, ellipse) = (steel_on_rubber(), Ellipse::new(7e-3 * ratio, 7e-3).unwrap());
            let load = SiForce { longitudinal: -3.0, lateral: 0.1, moment: 0.0 };
            let bonded = Bonded::new(pair, ellipse, load).unwrap();
            check(&StaticsReport::shift(pair, ellipse, [-3.0, 0.1], &bonded).unwrap());
            let load = SiForce { moment: -1.234e-5, ..SiForce::default() };
            let bonded = Bonded::new(pair, ellipse, load).unwrap();
            check(&StaticsReport::twist(pair, ellipse, -1.234e-5, &bonded).unwrap());
        }
    }

    #[test]
    fn partial_slip_is_drawn_from_hardly_any_slip_to_hardly_any_adhesion() {
        for ratio in RATIOS {
            let contact: Hertz = case(ratio, CURVE).hertz;
            for share in [1e-6, 0.5, 0.999_999] {
                let force = [-0.6 * share * 24e3, 0.8 * share * 24e3];
                let partial = PartialSlip::new(&contact, 0.3, force).unwrap();
                check(&StaticsReport::partial_slip(&contact, 0.3, force, &partial).unwrap());
            }
        }
    }

    /// Each step from where the one before ended: the last one closes the loop, and its picture has all stops.
    #[test]
    fn a_path_is_drawn_and_told_step_by_step() {
        for ratio in RATIOS {
            let contact: Hertz = case(ratio, CURVE).hertz;
            let mut path = ShiftPath::new(&contact, 0.3, ShiftAxis::Y).unwrap();
            let steps = [0.9, -0.9, 0.9].map(|share| {
                path.to_force(share * 24e3).unwrap();
                path.clone()
            });
            let report = StaticsReport::shift_path(&contact, 0.3, ShiftAxis::Y, &steps).unwrap();
            check(&report);
            let json = report.json();
            let shift = |k: usize| json["steps"][k]["shift_m"].as_f64().unwrap();
            // A closed loop ends where it began, but for rounding.
            assert!((shift(2) / shift(0) - 1.0).abs() < 1e-12 && shift(1) < 0.0);
            assert!(report.text().contains("heat so far"));
            let files = report.path_files().unwrap();
            let names: Vec<_> = files.iter().map(|(name, _)| *name).collect();
            assert_eq!(names, ["path.csv", "path.svg", "path.png"]);
        }
    }

    #[test]
    fn a_compression_is_drawn_with_and_without_slip() {
        let load = 3.0;
        let contact =
            Hertz::from_ellipse(steel_on_rubber(), Ellipse::new(5e-3, 5e-3).unwrap(), load);
        let contact = contact.unwrap();
        let radius = 0.5 / contact.relative_curvatures()[0];
        for friction in [0.01, 0.3, 1e3] {
            let pair = contact.pair();
            let ball = Compression::under_load(pair, radius, friction, load, 20).unwrap();
            let report = StaticsReport::compression(&contact, &ball).unwrap();
            check(&report);
            let found = report.json()["found"].clone();
            let number = |key: &str| found[key].as_f64().unwrap();
            assert!(number("approach_m") > 0.0 && number("peak_pressure_pa") > 0.0);
            // Friction stiffens by no more than a few per cent; rings leave one.
            let stiffer = number("approach_without_friction_m") / number("approach_m");
            assert!((0.98..1.15).contains(&stiffer), "{friction} {stiffer}");
            // Half of the radius at half of what makes the bodies unlike; then no slip at all.
            let share = number("adhesion_percent");
            let expected = if friction < 0.1 { 10.0..40.0 } else { 99.0..101.0 };
            assert!(expected.contains(&share), "{friction} {share}");
        }
    }

    fn steel_on_rubber() -> SolidPair {
        SolidPair::new(Solid::new(82e9, 0.28).unwrap(), rubber())
    }
}
