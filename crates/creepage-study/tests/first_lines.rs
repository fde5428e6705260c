//! The first lines of a Rust user for an ellipse, bodies of any shape and a wheelset, as CONTRIBUTING shows them side by
//! side.

use std::error::Error;

type Tested = Result<(), Box<dyn Error>>;

#[test]
fn an_ellipse() -> Tested {
    // An ellipse
    use creepage::{Hertz, Radii, SiCreepage, Solid, SolidPair, TheorySpec};
    let steel = Solid::new(82e9, 0.28)?;
    let wheel = Radii { rolling: 0.46, lateral: f64::INFINITY };
    let rail = Radii { rolling: f64::INFINITY, lateral: 0.30 };
    let hertz = Hertz::new(SolidPair::new(steel, steel), wheel, rail, 0.0, 80e3)?;
    let contact = hertz.with_friction(0.3)?;
    let theory = TheorySpec::named("exact")?.prepare(&contact)?;
    let slips = SiCreepage { longitudinal: -1.5e-3, ..SiCreepage::default() };
    let solved = theory.solve(contact.scaling().creepage(slips)?);
    let force = contact.scaling().si_force(solved.force); // newtons
    // The end.
    assert!((force.longitudinal + 14.56e3).abs() < 20.0, "{force:?}");
    Ok(())
}

/// The same bodies as a gap: the force of the ellipse within 20 N, some error bars of both.
#[test]
fn any_shape() -> Tested {
    // Any shape
    use creepage::gap::{Gap, Term};
    use creepage::normal::{NormalContact, Resolution};
    use creepage::{Contact, SiCreepage, Solid, SolidPair, TheorySpec};
    let steel = Solid::new(82e9, 0.28)?;
    let along = Term { x: 2, y: 0, coefficient: 0.5 / 0.46 };
    let across = Term { x: 0, y: 2, coefficient: 0.5 / 0.30 };
    let gap = Gap::polynomial(&[along, across])?;
    let pair = SolidPair::new(steel, steel);
    let pressed = NormalContact::under_load(&gap, pair, 80e3, Resolution::STANDARD)?;
    let contact = Contact::of_areas(pressed, 0.3)?;
    let theory = TheorySpec::named("exact")?.prepare(&contact)?;
    let slips = SiCreepage { longitudinal: -1.5e-3, ..SiCreepage::default() };
    let solved = theory.solve(contact.scaling().creepage(slips)?);
    let force = contact.scaling().si_force(solved.force); // newtons
    // The end.
    assert!((force.longitudinal + 14.56e3).abs() < 40.0, "{force:?}");
    Ok(())
}

#[test]
fn a_wheelset() -> Tested {
    // A wheelset
    use creepage::theory::{AreaTheory, ExactOptions};
    use creepage::{Solid, SolidPair};
    use creepage_rail::{Place, Standard, Track, Wheelset};
    use creepage_wheelset::{Load, RailFriction, WheelsetPose, WheelsetSolver, WheelsetVelocity};
    let steel = Solid::new(82e9, 0.28)?;
    let track = Track::new(&Standard::Uic60.profile(), 0.025, Place::gauge(1.435, 0.014))?;
    let running = Wheelset::like(&Standard::S1002.profile(), 0.46, 1.360)?.on(track);
    let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
    let theory = AreaTheory::Exact(ExactOptions::default());
    let solver = WheelsetSolver::new(&running, SolidPair::new(steel, steel), friction, theory)?;
    let load = Some(Load::Axle(100e3));
    let pose = WheelsetPose { side: None, y: 0.003, yaw: 0.0, roll: None, load };
    let velocity = WheelsetVelocity { speed: 30.0, ..WheelsetVelocity::default() };
    let solved = solver.solve(&pose, &velocity)?;
    let [force, _] = solved.wrench(0.46); // of the rails on the wheelset (N), about its centre
    // The end.
    assert!((force[2] + 100e3).abs() < 100.0, "{force:?}");
    Ok(())
}

/// CONTRIBUTING has these lines: between the words that name them and the end.
#[test]
fn contributing_shows_them() {
    let guide = include_str!("../../../CONTRIBUTING.md");
    for name in ["An ellipse", "Any shape", "A wheelset"] {
        let all = include_str!("first_lines.rs").split(&format!("    // {name}\n")).nth(1);
        let own = all.and_then(|rest| rest.split("    // The end.\n").next()).unwrap_or_default();
        let lines = own.lines().map(str::trim_start).collect::<Vec<_>>().join("\n") + "\n";
        assert!(guide.contains(&lines) && !own.is_empty(), "{lines}");
    }
}
