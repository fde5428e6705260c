//! The picture of one contact, seen from above: areas, tractions and spin pole.

use creepage::Hertz;
use creepage::Status;
use creepage::normal::NormalContact;
use creepage_plot::format::{Scale, fixed, quantity, significant};
use creepage_plot::theme::RED;
use creepage_plot::{
    Arrows, Cell, Fill, Label, Mark, Panel, Pen, Point, Sample, Shape, Table, TopView, ellipse,
};

use crate::SolvedCase;
use crate::gap::OnAreas;
use crate::text::status_words;

/// Tractions below this share of their bound are rounding errors, and not drawn.
const NOISE: f64 = 1e-9;
/// Where rigid bodies do not slip; where a load acts.
pub(crate) const TARGET: Mark = Mark { size: 7.0, ..Mark::open(Shape::Target, RED) };

impl SolvedCase {
    /// The contact seen from above, as SVG.
    #[must_use]
    pub fn contact_svg(&self) -> String {
        if let Some(on_areas) = OnAreas::of(self) {
            return on_areas.contact_svg();
        }
        self.top_view().svg(&format!("Rolling contact, theory {}", self.theory.name))
    }

    fn top_view(&self) -> TopView {
        let ellipse = self.case.hertz().map_or(self.contact.ellipse(), Hertz::ellipse);
        let title = "Adhesion, slip and traction in rolling contact";
        let mut view = TopView::new(title, [ellipse.a(), ellipse.b()])
            .aside(&format!("theory: {}", self.theory.name))
            .rolling();
        if let Some(hertz) = self.case.hertz() {
            view = view.note(setting(hertz, self.case.friction()));
        }
        let status = self.solution().status;
        if status != Status::Solved {
            view = view.banner(status_words(status));
        }
        let arrows = view.arrows(self.tractions(&view.lattice()));
        let mut figure = arrows.draw(TopView::panel());
        if let Some(pole) = self.spin_pole() {
            figure = figure.marks(vec![pole], TARGET);
        }
        let view = self.key(view.ground(self.areas_panel()).figure(figure), &arrows);
        view.table(self.table())
    }

    fn areas_panel(&self) -> Panel {
        let (edge, adhesion) = ([ellipse([1.0, 1.0])], &self.adhesion().polygons);
        let mut panel = TopView::panel().area(edge.to_vec(), Fill::SLIP);
        if !adhesion.is_empty() {
            panel = panel.area(adhesion.clone(), Fill::ADHESION);
        }
        panel.outlines(adhesion, Pen::OUTLINE.wide(1.2)).outlines(&edge, Pen::OUTLINE.wide(2.0))
    }

    /// The tractions at places `(x/a, y/b)`; nothing where there is no traction.
    fn tractions(&self, places: &[Point]) -> Vec<(Point, [f64; 2])> {
        let field = self.field(&self.positions(places));
        let mut tractions: Vec<_> =
            places.iter().copied().zip(field.iter().map(|point| point.traction)).collect();
        tractions.retain(|(_, traction)| traction.iter().all(|component| component.is_finite()));
        if tractions.iter().all(|(_, [x, y])| x.hypot(*y) < NOISE) {
            tractions.clear();
        }
        tractions
    }

    /// The zero of the rigid slip, `(-eta, xi)/chi` in units of `c`, as `(x/a, y/b)`; none where it
    /// lies outside the contact.
    fn spin_pole(&self) -> Option<Point> {
        let ([xi, eta, chi], [a, b]) = (self.creepage().components(), self.semi_axes());
        let pole = [-eta / chi / a, xi / chi / b];
        (pole[0].hypot(pole[1]) < 1.0).then_some(pole)
    }

    fn key(&self, view: TopView, arrows: &Arrows) -> TopView {
        let share = self.adhesion_share();
        let area = |name: &str, share: f64| {
            Label::new(&format!("{name}, {} % of area", fixed(100.0 * share, 1)))
        };
        let view = view
            .key(Fill::ADHESION, area("adhesion", share))
            .key(Fill::SLIP, area("slip", 1.0 - share));
        let view = match arrows.sample(self.scaling().traction) {
            Some((sample, traction)) => view
                .key(sample, Label::default().number(&quantity(traction, "Pa", 3)))
                .key(Sample::Blank, Label::new("traction on the lower body")),
            None => view.key(Sample::Blank, Label::new("no traction")),
        };
        match self.spin_pole() {
            Some(_) => view.key(TARGET, Label::new("spin pole: no rigid slip")),
            None => view,
        }
    }

    /// Creepages and forces, in SI units and dimensionless.
    fn table(&self) -> Table {
        let row = |name: Label, cells: [Label; 3]| {
            [Cell::Name(name)].into_iter().chain(cells.map(Cell::Number)).collect()
        };
        let heads = ["", "longitudinal", "lateral", "spin"];
        let [creepage, xi] = self.creepages();
        let [force, shares] = self.forces();
        let units = Label::new("in units of ").symbol("μN").plain(", ").symbol("μNc");
        Table::new(&[0.0, 182.0, 424.0, 670.0])
            .row(14.0, heads.map(|head| Cell::Name(Label::new(head))).to_vec())
            .row(30.0, row(Label::new("creepage"), creepage))
            .row(24.0, row(Label::new("dimensionless"), xi))
            .row(34.0, row(Label::new("force on the lower body"), force))
            .row(24.0, row(units, shares))
    }

    /// The SI row and the dimensionless row.
    fn creepages(&self) -> [[Label; 3]; 2] {
        let creepage = self.creepage();
        let si = self.scaling().si_creepage(creepage);
        let is = |label: Label, value: f64| label.plain(" = ").number(&significant(value, 4));
        let symbol = |symbol: &str| Label::default().symbol(symbol);
        let indexed = |index: &str| Label::default().indexed("υ", index);
        [
            [
                is(indexed("x"), si.longitudinal),
                is(indexed("y"), si.lateral),
                is(symbol("φ"), si.spin).plain(" rad/m"),
            ],
            [
                is(symbol("ξ"), creepage.xi()),
                is(symbol("η"), creepage.eta()),
                is(symbol("χ"), creepage.chi()),
            ],
        ]
    }

    /// The SI row and the dimensionless row.
    fn forces(&self) -> [[Label; 3]; 2] {
        let (force, scaling) = (self.solution().force, self.scaling());
        let si = scaling.si_force(force);
        let newton = Scale::of(scaling.force, "N", 4);
        let newton_metre = Scale::of(scaling.force * scaling.length, "N m", 4);
        let is = |symbol: &str, index: &str, value: String| {
            Label::default().indexed(symbol, index).plain(" = ").number(&value)
        };
        [
            [
                is("F", "x", newton.write(si.longitudinal)),
                is("F", "y", newton.write(si.lateral)),
                is("M", "z", newton_metre.write(si.moment)),
            ],
            [
                is("f", "x", fixed(force.fx, 4)),
                is("f", "y", fixed(force.fy, 4)),
                is("m", "z", fixed(force.mz, 4)),
            ],
        ]
    }
}

/// Load, friction, semi-axes and pressure, below a title.
pub(crate) fn setting(contact: &Hertz, friction: f64) -> Label {
    let ellipse = contact.ellipse();
    let gap = "\u{2003}";
    let is = |label: Label, value: &str| label.plain(" = ").number(value);
    let label = is(Label::default().symbol("N"), &quantity(contact.normal_force(), "N", 4));
    let label = is(label.plain(gap).symbol("μ"), &significant(friction, 4));
    let label = is(label.plain(gap).symbol("a"), &quantity(ellipse.a(), "m", 4));
    let label = is(label.plain(gap).symbol("b"), &quantity(ellipse.b(), "m", 4));
    let label = label.plain(gap).plain("peak pressure ");
    label.number(&quantity(contact.peak_pressure(), "Pa", 4))
}

/// Load, friction, area and pressure of areas of any shape, below a title.
pub(crate) fn setting_of_areas(areas: &NormalContact, friction: f64) -> Label {
    let gap = "\u{2003}";
    let is = |label: Label, value: &str| label.plain(" = ").number(value);
    let label = is(Label::default().symbol("N"), &quantity(areas.load().value, "N", 4));
    let label = is(label.plain(gap).symbol("μ"), &significant(friction, 4));
    let square = format!("{} mm²", significant(1e6 * areas.area().value, 4));
    let label = label.plain(gap).plain("area ").number(&square);
    let label = label.plain(gap).plain("peak pressure ");
    label.number(&quantity(areas.peak_pressure().value, "Pa", 4))
}

#[cfg(test)]
mod tests {
    use creepage_plot::png;
    use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

    use super::*;
    use crate::testing::{CURVE, SLIDING, Trial, check_view, report};

    const RATIOS: [f64; 9] = [1e-4, 0.05, 0.3, 1.0, 1.5, 1.9, 6.0, 20.0, 1e4];

    fn check(report: &SolvedCase) {
        check_view(&report.contact_svg(), report.top_view().on_the_sheet());
    }

    #[test]
    fn nothing_is_clipped_or_covered_at_any_ratio() {
        for a_over_b in RATIOS {
            check(&report(a_over_b, Trial::Sticking, CURVE));
            check(&report(a_over_b, SLIDING, CURVE));
        }
    }

    #[test]
    fn long_numbers_and_every_banner_fit() {
        for status in [Status::NotConverged, Status::CreepageTooSmall, Status::SpinTooLarge] {
            for size in [-1.2345e-12, -1.2345e-3, -1234.5, -1.2345e9] {
                check(&report(1.0, Trial::Sliding(status), [size; 3]));
            }
        }
    }

    #[test]
    fn the_spin_pole_is_drawn_where_rigid_bodies_do_not_slip() {
        let red = |creepage| {
            let svg = report(1.0, SLIDING, creepage).contact_svg();
            svg.matches(&format!("stroke=\"{RED}\" stroke-width=\"2.2\"")).count()
        };
        assert_eq!(red(CURVE), 2); // in the contact and in the key
        assert_eq!(red([2.0, CURVE[1], CURVE[2]]), 0);
        let report = report(1.0, SLIDING, CURVE);
        let (svg, [centre, semi_axes]) = (report.contact_svg(), report.top_view().on_the_sheet());
        // (-eta, xi)/chi, y downwards.
        let [x, y] = [0, 1].map(|i| centre[i] + semi_axes[i] * 0.1 / 1.5);
        let number = |value: f64| significant((value * 100.0).round() / 100.0, 9);
        let mark = format!("<ellipse cx=\"{}\" cy=\"{}\" rx=\"7\"", number(x), number(y));
        assert!(svg.contains(&mark), "{mark}");
    }

    /// Tone of 255 about a place, the median of a patch: neither hatching nor an arrow's end.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a place on the sheet
    fn tone(pixels: &Pixmap, place: Point) -> u32 {
        let [x, y] = place.map(|units| (2.0 * units) as u32);
        let patch = (0..30).flat_map(|i| (0..30).map(move |j| (x + i - 15, y + j - 15)));
        let luma = |p: PremultipliedColorU8| {
            (30 * u32::from(p.red()) + 59 * u32::from(p.green()) + 11 * u32::from(p.blue())) / 100
        };
        let mut tones: Vec<_> = patch.filter_map(|(x, y)| pixels.pixel(x, y)).map(luma).collect();
        tones.sort_unstable();
        tones[tones.len() / 2]
    }

    #[test]
    fn the_pixels_show_both_areas_apart_in_grey() {
        let report = report(1.5, Trial::Sticking, CURVE);
        let pixels = Pixmap::decode_png(&png(&report.contact_svg()).unwrap()).unwrap();
        assert_eq!(pixels.width(), 2000);
        let [centre, semi_axes] = report.top_view().on_the_sheet();
        let at = |disc: Point| [0, 1].map(|i| centre[i] + semi_axes[i] * disc[i]);
        let slip = tone(&pixels, at([-0.57, 0.48]));
        let adhesion = tone(&pixels, at([0.53, 0.23]));
        // Print tells a tenth of the tones apart.
        assert!(slip > adhesion + 30, "{slip} {adhesion}");
    }

    #[test]
    fn a_contact_without_traction_says_so() {
        let svg = report(1.0, Trial::Free, [0.0; 3]).contact_svg();
        assert!(svg.contains("no traction") && !svg.contains("traction on"));
    }
}
