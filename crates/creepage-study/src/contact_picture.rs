//! The picture of one contact, seen from above: what goes where on the sheet.

use creepage::rolling::Status;

use crate::caption;
use crate::contact_view::View;
use crate::legend;
use crate::report::Report;
use crate::scene::{Point, Scene};
use crate::sheet::{Area, MARGIN, WIDTH};

/// Contacts longer than this, along over across, have the legend below instead of beside.
const WIDE: f64 = 1.7;
/// Ratio of axes up to which the ellipse is drawn to scale; beyond, its short axis is widened
/// so that areas and arrows stay readable, and the picture says so.
const LARGEST_RATIO: f64 = 6.0;
/// Room around the ellipse for axes, rolling direction and scale.
const ROOM: f64 = 66.0;

impl Report<'_> {
    /// The contact seen from above, as SVG.
    #[must_use]
    pub fn contact_svg(&self) -> String {
        let layout = Layout::of(self);
        let view = View::new(self, layout.centre, layout.semi_axes);
        let mut scene = Scene::new();
        caption::title(&mut scene, self);
        view.draw(&mut scene, self, layout.plot);
        legend::key(&mut scene, layout.key, self, &view);
        legend::orientation(&mut scene, layout.orientation, view.plane());
        caption::table(&mut scene, layout.table, self);
        let description = format!("Rolling contact, theory {}", self.answer.theory_name);
        scene.finish([WIDTH, layout.table + caption::TABLE_HEIGHT], &description)
    }
}

/// What goes where on a sheet with one ellipse, a legend, and a table at the foot.
pub(crate) struct Layout {
    pub(crate) centre: Point,
    pub(crate) semi_axes: [f64; 2],
    pub(crate) plot: Area,
    pub(crate) key: Point,
    pub(crate) orientation: Point,
    pub(crate) table: f64,
}

impl Layout {
    fn of(report: &Report) -> Self {
        let solved = report.answer.solution.status == Status::Solved;
        let top = if solved { caption::TITLE_HEIGHT } else { caption::BANNER_BOTTOM };
        Self::new(report.contact.ellipse().ratio(), top, legend::key_height(report))
    }

    /// For an ellipse of ratio `a_over_b`, below `top`, with a key of that height.
    pub(crate) fn new(a_over_b: f64, top: f64, key_height: f64) -> Self {
        let ratio = a_over_b.clamp(1.0 / LARGEST_RATIO, LARGEST_RATIO);
        if ratio > WIDE {
            Self::wide(ratio, top, key_height)
        } else {
            Self::beside(ratio, top, key_height)
        }
    }

    /// Ellipse on the left, legend on the right.
    fn beside(ratio: f64, top: f64, key_height: f64) -> Self {
        let tallest = 210.0 + 60.0 * (1.0 - ratio).max(0.0);
        let semi_x = f64::min(250.0, tallest * ratio);
        let legend_height = key_height + legend::GAP + legend::ORIENTATION_HEIGHT;
        let height = (2.0 * (semi_x / ratio + ROOM)).max(legend_height);
        let plot = Area { from: [MARGIN, top], to: [700.0, top + height] };
        let legend = plot.to[0] + 20.0;
        let middle = f64::midpoint(plot.from[1], plot.to[1]);
        let key = middle - 0.5 * legend_height;
        Self {
            centre: [f64::midpoint(plot.from[0], plot.to[0]), middle],
            semi_axes: [semi_x, semi_x / ratio],
            plot,
            key: [legend, key],
            orientation: [legend, key + key_height + legend::GAP],
            table: plot.to[1] + 8.0,
        }
    }

    /// Ellipse on top, legend below.
    fn wide(ratio: f64, top: f64, key_height: f64) -> Self {
        let semi_x = f64::min(370.0, 190.0 * ratio);
        let height = 2.0 * (semi_x / ratio + ROOM);
        let plot = Area { from: [MARGIN, top], to: [WIDTH - MARGIN, top + height] };
        let legend = plot.to[1] + legend::GAP;
        Self {
            centre: [f64::midpoint(plot.from[0], plot.to[0]), top + 0.5 * height],
            semi_axes: [semi_x, semi_x / ratio],
            plot,
            key: [MARGIN + 60.0, legend],
            orientation: [0.5 * WIDTH + 60.0, legend],
            table: legend + key_height.max(legend::ORIENTATION_HEIGHT) + 8.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use creepage::rolling::Creepage;
    use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

    use super::*;
    use crate::raster;
    use crate::sheet::RED;
    use crate::testing::{CURVE, Free, Sliding, check_sheet, contact, report, sliding, sticking};

    const RATIOS: [f64; 9] = [1e-4, 0.05, 0.3, 1.0, 1.5, 1.9, 6.0, 20.0, 1e4];

    fn check(report: &Report) {
        check_sheet(&report.contact_svg(), &Layout::of(report));
    }

    #[test]
    fn nothing_is_clipped_or_covered_at_any_ratio() {
        for a_over_b in RATIOS {
            let contact = contact(a_over_b);
            check(&report(&contact, &sticking(a_over_b), CURVE));
            check(&report(&contact, &sliding(a_over_b), CURVE));
        }
    }

    #[test]
    fn long_numbers_and_every_banner_fit() {
        let contact = contact(1.0);
        for status in [Status::NotConverged, Status::CreepageTooSmall, Status::SpinTooLarge] {
            let theory = Sliding { status, ..sliding(1.0) };
            for size in [-1.2345e-12, -1.2345e-3, -1234.5, -1.2345e9] {
                let creepage = Creepage { xi: size, eta: size, chi: size };
                check(&report(&contact, &theory, creepage));
            }
        }
    }

    #[test]
    fn the_spin_pole_is_drawn_where_rigid_bodies_do_not_slip() {
        let (contact, theory) = (contact(1.0), sliding(1.0));
        let red = |creepage| {
            let svg = report(&contact, &theory, creepage).contact_svg();
            svg.matches(&format!("stroke=\"{RED}\" stroke-width=\"2.2\"")).count()
        };
        assert_eq!(red(CURVE), 2); // in the contact and in the key
        assert_eq!(red(Creepage { xi: 2.0, ..CURVE }), 0);
        let svg = report(&contact, &theory, CURVE).contact_svg();
        let Layout { centre, semi_axes, .. } = Layout::of(&report(&contact, &theory, CURVE));
        // (-eta, xi)/chi, y downwards.
        let [x, y] = [0, 1].map(|i| centre[i] + semi_axes[i] * 0.1 / 1.5);
        let number = |value: f64| crate::format::significant((value * 100.0).round() / 100.0, 9);
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
        let (contact, theory) = (contact(1.5), sticking(1.5));
        let report = report(&contact, &theory, CURVE);
        let pixels = Pixmap::decode_png(&raster::png(&report.contact_svg()).unwrap()).unwrap();
        assert_eq!(pixels.width(), 2000);
        let Layout { centre, semi_axes, .. } = Layout::of(&report);
        let at = |disc: Point| [0, 1].map(|i| centre[i] + semi_axes[i] * disc[i]);
        let slip = tone(&pixels, at([-0.57, 0.48]));
        let adhesion = tone(&pixels, at([0.53, 0.23]));
        // Print tells a tenth of the tones apart.
        assert!(slip > adhesion + 30, "{slip} {adhesion}");
    }

    #[test]
    fn a_contact_without_traction_says_so() {
        let contact = contact(1.0);
        let svg = report(&contact, &Free, Creepage::default()).contact_svg();
        assert!(svg.contains("no traction") && !svg.contains("traction on"));
    }
}
