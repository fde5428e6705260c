//! x
use super::cases::*;
use creepage::rolling::Theory;
use creepage::rolling::fastrip::{Fastrip, Variant};
#[test]
fn look() {
    for case in approximate() {
        let e = [0, 1, 2].map(|i| case.json["own"]["fastrip_modif_conv"][i].as_f64().unwrap());
        let c = [0, 1, 2].map(|i| case.json["CONTACT"]["fastrip_modif_200"][i].as_f64().unwrap());
        let f = array(
            Fastrip::new(
                case.a_over_b,
                case.poisson,
                &coefficients(case.a_over_b, case.poisson),
                Variant::Modified,
                [300, 300],
            )
            .unwrap()
            .solve(case.creepage)
            .force,
        );
        let x = ["fx", "fy", "mz"].map(|k| case.json["exact"][k].as_f64().unwrap());
        let d = largest_difference(e, f);
        let ex = largest_difference(x, f);
        let ee = largest_difference(x, e);
        if case.creepage.chi != 0.0 {
            println!(
                "{} {:.2} {:?} diff {d:.5} ({:.5}) err mine {ex:.4} ref {ee:.4}  mine {f:.4?} ref {e:.4?} exact {x:.4?}",
                case.id,
                case.a_over_b,
                case.creepage,
                largest_difference(c, f)
            );
        }
    }
    println!(
        "{:?}",
        error_against_full_theory(|case| array(
            Fastrip::new(
                case.a_over_b,
                case.poisson,
                &coefficients(case.a_over_b, case.poisson),
                Variant::Modified,
                [100, 100]
            )
            .unwrap()
            .solve(case.creepage)
            .force
        ))
    );
}
#[test]
fn look_original() {
    for case in approximate() {
        let e = [0, 1, 2].map(|i| case.json["own"]["fastrip_orig_conv"][i].as_f64().unwrap());
        let c = [0, 1, 2].map(|i| case.json["CONTACT"]["fastrip_orig_200"][i].as_f64().unwrap());
        let f = array(Fastrip::new(case.a_over_b, case.poisson, &coefficients(case.a_over_b, case.poisson), Variant::Original, [300, 300]).unwrap().solve(case.creepage).force);
        let d = largest_difference(e, f);
        let d2 = largest_difference(c, f);
        if case.creepage.chi != 0.0 || d > 1e-3 { println!("{} {:.2} {:?} diff {d:.5} {d2:.5} mine {f:.4?} ref {e:.4?}", case.id, case.a_over_b, case.creepage); }
    }
}
