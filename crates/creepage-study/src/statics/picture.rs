//! The picture of a problem without rolling, seen from above.

use super::arrows::Arrows;
use super::field::Field;
use super::{StaticsReport, bands, caption, key};
use crate::contact_picture::Layout;
use crate::contact_view::pole_mark;
use crate::legend;
use crate::plane::Plane;
use crate::scene::{Ink, Scene};
use crate::sheet::{DARK, WIDTH};

impl StaticsReport<'_> {
    /// The contact seen from above, as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let levels = self.levels();
        let height = key::height(self, levels.len());
        let layout = Layout::new(self.ellipse.ratio(), caption::TITLE_HEIGHT, height);
        let plane = Plane::new(layout.centre, layout.semi_axes, self.ellipse);
        let arrows = Arrows::new(self, &plane);
        let mut scene = Scene::new();
        caption::title(&mut scene, self);
        bands::draw(&mut scene, self, &plane, &levels);
        plane.axes(&mut scene);
        self.marks(&mut scene, &plane);
        arrows.draw(&mut scene, &plane);
        plane.scale_bars(&mut scene, [layout.plot.from[0] + 6.0, layout.plot.to[1] - 14.0]);
        key::draw(&mut scene, layout.key, self, &levels, &arrows);
        legend::orientation(&mut scene, layout.orientation, &plane);
        caption::table(&mut scene, layout.table, self);
        scene.finish([WIDTH, layout.table + caption::table_height(self)], self.title)
    }

    /// The lift-off limit and the load of a die, or the adhesion ellipse.
    fn marks(&self, scene: &mut Scene, plane: &Plane) {
        let scaled = |factor: f64| plane.semi_axes.map(|axis| factor * axis);
        match self.field {
            Field::Die { offset, .. } => {
                scene.ellipse(plane.centre, scaled(1.0 / 3.0), key::LIMIT);
                let place = [offset[0] / self.ellipse.a(), offset[1] / self.ellipse.b()];
                pole_mark(scene, plane.at(place));
            }
            Field::Bonded(_) => {}
            Field::PartialSlip(partial) => {
                let factor = partial.adhesion().a() / self.ellipse.a();
                scene.ellipse(plane.centre, scaled(factor), Ink::line(DARK, 2.6));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use creepage::rolling::SiForce;
    use creepage::statics::{Bonded, Die, PartialSlip};
    use creepage::{Ellipse, Hertz, Solid, SolidPair};

    use super::*;
    use crate::testing::{check_sheet, contact};

    const RATIOS: [f64; 7] = [1e-3, 0.05, 0.6, 1.0, 1.6, 6.0, 1e3];

    fn check(report: &StaticsReport) {
        let height = key::height(report, report.levels().len());
        let layout = Layout::new(report.ellipse.ratio(), caption::TITLE_HEIGHT, height);
        check_sheet(&report.svg(), &layout);
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
            let contact: Hertz = contact(ratio);
            for share in [1e-6, 0.5, 0.999_999] {
                let force = [-0.6 * share * 24e3, 0.8 * share * 24e3];
                let partial = PartialSlip::new(&contact, 0.3, force).unwrap();
                check(&StaticsReport::partial_slip(&contact, 0.3, force, &partial).unwrap());
            }
        }
    }

    fn steel_on_rubber() -> SolidPair {
        SolidPair::new(Solid::new(82e9, 0.28).unwrap(), rubber())
    }
}
