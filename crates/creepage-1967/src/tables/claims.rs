//! Claims of the text that no table or figure has.

use std::fmt::Write;

use creepage::Theory;
use creepage::approximate::linear::Linear;
use creepage::approximate::strip::StripTheory;
use creepage::halfspace::{LoadDisplacement, Polynomial};
use creepage::variational::{
    Chain, IntegrandArguments, IntegrandTerms, Method, Procedure, Settings, Start, Variational,
    VariationalError, Weight,
};
use creepage::{Creepage, Ellipse, Force, Solved, Status};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item = Item::new("claims", "What else the text claims", make);

fn make() -> Result<Reproduction, GalleryError> {
    let mut agreement = iterations()?;
    agreement.extend(strip_theory()?);
    agreement.push(no_symmetry_about_y()?);
    agreement.push(root_of_ts()?);
    agreement.push(tractions_of_chapter_2()?);
    agreement.push(least_squares_with_areas()?);
    agreement.push(smallest_value()?);
    agreement.push(hysteresis()?);
    let mut data = Data::new(["claim", "printed", "ours", "verdict"]);
    let mut text = String::from("Claims of the text\n");
    for line in &agreement {
        let Comparison { quantity, printed, ours, verdict, .. } = line;
        data.push([quantity.into(), printed.into(), ours.into(), verdict.words().into()]);
        // Writing to a String cannot fail.
        let _ = write!(text, "\n{quantity}: printed {printed}; ours {ours}");
    }
    let caption = "What the text of the thesis says in passing, of its iteration, of strip theory, of \
        symmetries and of other functionals, each computed.";
    Ok(Reproduction::table(text, caption, data, agreement))
}

/// (5.12): 33 cases of lateral creepage and spin on a circle, each slowly increased in a chain.
fn iterations() -> Result<Vec<Comparison>, GalleryError> {
    const LATERAL: [f64; 17] =
        [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.6, 1.8, 2.0, 2.5];
    const SPIN: [f64; 16] =
        [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 8.0, 10.0];
    let lateral = LATERAL.map(|eta| rolling_at([0.0, eta, 0.0]));
    let spin = SPIN.map(|chi| rolling_at([0.0, 0.0, chi]));
    let mut lines = Vec::new();
    for (degree, cells, printed) in [(2, 10, "3.9"), (3, 10, "4.4"), (4, 11, "4.7")] {
        let settings = Settings { mesh: [cells; 2], ..Settings::of_degree(degree) };
        let theory = Variational::new(&like_bodies(1.0, STEEL)?, settings)?;
        let count = |cases: &[Creepage]| -> usize {
            let mut chain = Chain::new(&theory, Procedure::OF_1967);
            cases.iter().map(|case| chain.solve(*case, None).found.iterations()).sum()
        };
        let mean = (count(&lateral) + count(&spin)) as f64 / (LATERAL.len() + SPIN.len()) as f64;
        let reason =
            "the thesis does not state its 33 creepages; the number of iterations depends on them";
        lines.push(
            Comparison::number(format!("iterations a case, M = {degree}"), printed, mean)
                .within(0.5, reason),
        );
    }
    Ok(lines)
}

/// Chapter 1 of strip theory beside chapter 5: "excellent agreement in the case of pure creepage, but in
/// pure spin there are relative errors of up to 20 %".
fn strip_theory() -> Result<[Comparison; 2], GalleryError> {
    /// The spins of the thesis's catalogue and its Fig. 23 at which strip theory is far from its bound.
    const SPINS: [f64; 7] = [0.25, 0.5, 1.0, 1.5, 2.0, 2.5, 3.5];
    let strip = StripTheory::new(&like_bodies(0.2, STEEL)?);
    let theory = chapter_5(0.2, STEEL, 3, Weight::Elliptic)?;
    let sizes = spaced(0.2, 3.0, 28);
    let mut apart = 0.0_f64;
    for direction in [[1.0, 0.0], [0.0, 1.0]] {
        let [x, y] = direction;
        let creepages: Vec<_> =
            sizes.iter().map(|size| rolling_at([size * x, size * y, 0.0])).collect();
        for (creepage, force) in creepages.iter().zip(chained(&theory, &creepages)) {
            let strip = strip.solve(*creepage).force;
            apart = apart.max((strip.fx - force.fx).hypot(strip.fy - force.fy));
        }
    }
    let pure = Comparison::claim(
        "strip theory from chapter 5, pure creepage, a/b = 0.2",
        "excellent agreement",
        format!("at most {apart:.3} of μN apart"),
        // Half the error of chapter 5 itself.
        apart < 0.05,
    );
    let creepages = SPINS.map(|chi| rolling_at([0.0, 0.0, chi]));
    let numerical = chained(&theory, &creepages);
    let percent = creepages.iter().zip(&numerical);
    let percent =
        percent.map(|(creepage, force)| 100.0 * (strip.solve(*creepage).force.fy / force.fy - 1.0));
    let percent: Vec<f64> = percent.collect();
    let worst = percent.iter().map(|off| off.abs()).fold(0.0, f64::max);
    let course: Vec<_> =
        SPINS.iter().zip(&percent).map(|(chi, off)| format!("{off:+.0} at χ = {chi}")).collect();
    let spin = Comparison::number(
        "largest error of strip theory from chapter 5, pure spin to χ = 3.5, a/b = 0.2 [%]",
        "20",
        worst,
    )
    .within(2.0, "the thesis states neither the ellipse nor the spins that it compared")
    .remark(&format!("{} %; beyond, both forces fall and their ratio grows", course.join(", ")));
    Ok([pure, spin])
}

/// 5.14: "the results of (5.12) compared better with the experiment than those of (5.15)", which the full
/// theory stands for.
fn least_squares_with_areas() -> Result<Comparison, GalleryError> {
    const SPINS: [f64; 4] = [0.0, 0.5, 1.0, 2.0];
    const SIZES: [f64; 8] = [0.3, 0.5, 0.7, 0.9, 1.1, 1.5, 2.0, 2.5];
    const DIRECTIONS: [f64; 6] = [-90.0, -54.0, -18.0, 18.0, 54.0, 90.0];
    /// `W2` in the area of slip and `W3` in that of adhesion: alike first, then apart.
    const WEIGHTS: [[Weight; 2]; 4] = [
        [Weight::Elliptic, Weight::Elliptic],
        [Weight::Elliptic, Weight::Uniform],
        [Weight::Uniform, Weight::Elliptic],
        [Weight::Uniform, Weight::Uniform],
    ];
    let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let least: Result<Vec<_>, VariationalError> = WEIGHTS
        .iter()
        .map(|[weight, adhesion]| {
            let settings = Settings {
                weight: *weight,
                adhesion_weight: Some(*adhesion),
                ..Settings::of_degree(3)
            };
            Variational::new(theory.contact(), settings)
        })
        .collect();
    let least = least?;
    let areas = Procedure { method: Method::Areas, ..Procedure::default() };
    let mut squares = [0.0_f64; 5];
    let mut count = 0.0_f64;
    for chi in SPINS {
        for direction in DIRECTIONS {
            let (sin, cos) = direction.to_radians().sin_cos();
            let creepages = SIZES.map(|size| rolling_at([size * cos, size * sin, chi]));
            let truth = full(1.0, STEEL, &creepages)?;
            let mut chain = Chain::new(&theory, Procedure::default());
            // From the largest creepage to the least, as 1967 ran them.
            for (creepage, truth) in creepages.iter().zip(truth).rev() {
                let one = chain.solve(*creepage, None).found;
                let off =
                    |force: Force| (force.fx - truth.fx).powi(2) + (force.fy - truth.fy).powi(2);
                squares[0] += off(one.solution.force);
                for (sum, least) in squares[1..].iter_mut().zip(&least) {
                    let start = Start::From(&one.tau);
                    *sum += off(least.solve_by(areas, *creepage, &start, None).solution.force);
                }
                count += 1.0;
            }
        }
    }
    let [product, alike, second, third, fourth] = squares.map(|sum| 100.0 * (sum / count).sqrt());
    Ok(Comparison::claim(
        "forces by (5.12) and by (5.15), from the full theory",
        "(5.12) compared better with the experiment",
        format!(
            "{product:.1} and {alike:.1} % of μN (root mean square over {count:.0} cases, a/b = 1)"
        ),
        // With W2 and W3 alike, of which the thesis says nothing.
        product < alike && product < fourth,
    )
    .remark(&format!(
        "the full theory stands for the experiments, whose points are not in the text; (5.15) with W₂ = W₃ = W₁; \
         with W₂ = W₁, W₃ = 1: {second:.1} %, W₂ = 1, W₃ = W₁: {third:.1} %, W₂ = W₃ = 1: {fourth:.1} %"
    )))
}

/// 5.12: "in practically all cases at the stationary value I was indeed the smallest as compared with
/// the series of values of I obtained during the iteration", over the catalogue (5.29).
fn smallest_value() -> Result<Comparison, GalleryError> {
    /// Lower by less than this part of its size is rounding.
    const ROUNDING: f64 = 1e-9;
    const SIZES: [f64; 16] =
        [10.0, 5.0, 3.5, 2.5, 2.0, 1.7, 1.5, 1.3, 1.1, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3];
    let chains: Vec<_> = CATALOGUE
        .iter()
        .flat_map(|(ratio, spins)| spins.iter().map(move |chi| (*ratio, *chi)))
        .flat_map(|(ratio, chi)| (-9..=9).map(move |k| (ratio, chi, 10.0 * f64::from(k))))
        .collect();
    let counts: Result<Vec<[usize; 3]>, GalleryError> = chains
        .par_iter()
        .map(|(ratio, chi, alpha)| {
            let theory = chapter_5(*ratio, STEEL, 3, Weight::Elliptic)?;
            let mut chain = Chain::new(&theory, Procedure::OF_1967);
            let (sin, cos) = alpha.to_radians().sin_cos();
            let mut counts = [0; 3];
            for size in SIZES {
                let mut steps = Vec::new();
                let at = rolling_at([size * cos, size * sin, *chi]);
                let found = chain.solve(at, Some(&mut steps)).found;
                let least =
                    steps.iter().map(|step| step.mean_integrand).fold(f64::INFINITY, f64::min);
                // In full sliding I is nothing but rounding.
                let is_smallest = found.mean_integrand <= (1.0 + ROUNDING) * least + 1e-20;
                let failed = found.solution.status == Status::NotConverged;
                counts[0] += 1;
                counts[1] += usize::from(is_smallest && !failed);
                counts[2] += usize::from(failed);
            }
            Ok(counts)
        })
        .collect();
    let sum =
        |k: usize| counts.as_ref().map_or(0, |all| all.iter().map(|one| one[k]).sum::<usize>());
    let [all, smallest, failed] = [sum(0), sum(1), sum(2)];
    counts?;
    Ok(Comparison::claim(
        "the stationary value is the smallest I of the iteration, catalogue (5.29)",
        "in practically all cases",
        format!("in {smallest} of {all} cases; {failed} did not converge"),
        smallest as f64 > 0.98 * all as f64,
    ))
}

/// 5.31: the moment `M_z` beside that of elastic hysteresis, by the linear theory's slope.
fn hysteresis() -> Result<Comparison, GalleryError> {
    /// Of bearing steel in rolling, by order of magnitude; and the friction of Fig. 14.
    const LOSS: f64 = 0.01;
    const FRICTION: f64 = 0.094;
    let linear = Linear::new(&like_bodies(1.0, STEEL)?)?;
    let slope = linear.solve(rolling_at([0.0, 0.0, 1.0])).force.mz;
    // Both over mu N c.
    let of_hysteresis = creepage::Hertz::HYSTERESIS * LOSS / FRICTION;
    let spin = of_hysteresis / slope;
    Ok(Comparison::claim(
        "moment of elastic hysteresis beside M_z, a/b = 1",
        "of the same, or even larger order of magnitude when creepage and spin are small",
        format!(
            "3/16 α N a = {of_hysteresis:.3} μNc for a loss factor α = {LOSS}, μ = {FRICTION}: larger than M_z below χ = {spin:.3}"
        ),
        spin > 0.0,
    )
    .remark(
        "it acts against rolling, about the lateral axis, and counts in a measured M_z as far as the rig's axis is inclined; \
         the experiments' rig and loss factor are not in the text, so that their M_z cannot be compared",
    ))
}

/// End of 4.2: symmetries about the `y`-axis do not hold.
fn no_symmetry_about_y() -> Result<Comparison, GalleryError> {
    let theory = creepage::coulomb::Exact::new(
        &like_bodies(1.0, STEEL)?,
        creepage::coulomb::Resolution::STANDARD,
    )?;
    let solved = theory.solve_contact(rolling_at([0.5, 0.0, 0.0]));
    let [ahead, behind] = [0.6, -0.6].map(|x| solved.field(&[[x, 0.0]])[0].traction[0]);
    Ok(Comparison::claim(
        "traction at x/a = 0.6 and -0.6, ξ = 0.5",
        "no symmetry about the y-axis",
        format!("{ahead:.2} and {behind:.2} of the largest bound"),
        (ahead - behind).abs() > 0.1,
    ))
}

/// 5.14: with the root of `T S` "the iteration did not converge".
fn root_of_ts() -> Result<Comparison, GalleryError> {
    let contact = like_bodies(1.0, STEEL)?;
    let root = Variational::with_integrand(&contact, Settings::default(), root_terms)?;
    let product = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let cases = [[0.9, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 1.0], [0.5, -0.5, 0.7]];
    let converges = |at: &&[f64; 3]| {
        let start = product.solve_from(rolling_at(**at), &Start::FullSliding).tau;
        let found = root.solve_by(Procedure::OF_1967, rolling_at(**at), &Start::From(&start), None);
        found.solution.status != Status::NotConverged
    };
    let converged = cases.iter().filter(converges).count();
    Ok(Comparison::claim(
        "Newton's method for the root of T S in place of T S",
        "did not converge, in a single case",
        format!("converges in {converged} of {} cases", cases.len()),
        converged == 0,
    ))
}

fn root_terms(IntegrandArguments { t, s, .. }: IntegrandArguments) -> IntegrandTerms {
    let (t, s) = (t.max(f64::MIN_POSITIVE), s.max(f64::MIN_POSITIVE));
    IntegrandTerms {
        f: (t * s).sqrt(),
        t: 0.5 * (s / t).sqrt(),
        s: 0.5 * (t / s).sqrt(),
        tt: -0.25 * (s / t).sqrt() / t,
        ts: 0.25 / (t * s).sqrt(),
        ss: -0.25 * (t / s).sqrt() / s,
    }
}

/// End of 5.23: with the tractions of chapter 2, infinite at the edge, nothing slips and I = 0.
fn tractions_of_chapter_2() -> Result<Comparison, GalleryError> {
    let (circle, theory) = (Ellipse::from_ratio(1.0)?, chapter_5(1.0, STEEL, 3, Weight::Elliptic)?);
    // Creepage and spin in units of mu f00.
    let [xi, eta, chi] = [0.5, -0.5, 0.7].map(|part| part * theory.slip_scale());
    let u = Polynomial::new(vec![0.0, -xi, 0.0, 0.0, chi, 0.0])?;
    let v = Polynomial::new(vec![0.0, -eta, 0.0, -0.5 * chi, 0.0, 0.0])?;
    let forwards = LoadDisplacement::new(circle, STEEL, 2)?;
    let traction = forwards.inverse()?.singular([&u, &v, &Polynomial::zero(2)])?;
    let [u, v, _] = forwards.displacement(&traction)?;
    let (mut integral, mut most, mut beyond) = (0.0, 0.0_f64, 0);
    for [x, y] in theory.mesh() {
        let slope = |p: &Polynomial| {
            p.coefficient(1, 0) + 2.0 * p.coefficient(2, 0) * x + p.coefficient(1, 1) * y
        };
        let slip = [xi - chi * y + slope(&u), eta + chi * x + slope(&v)];
        let ([tx, ty, _], bound) = (traction.at([*x, *y]), (1.0 - x * x - y * y).sqrt());
        let over = tx.hypot(ty) / bound;
        // T is (|(X', Y')| + 1)^2 at most, and W = 1 - x^2 - y^2.
        integral += bound * bound * (over + 1.0).powi(2) * (slip[0].powi(2) + slip[1].powi(2));
        (most, beyond) = (most.max(over), beyond + usize::from(over > 1.0));
    }
    let integral = integral / theory.mesh().len() as f64;
    Ok(Comparison::claim(
        "I of (5.9) with the tractions of chapter 2, ξ = 0.5, η = −0.5, χ = 0.7",
        "vanishes, though |(X, Y)| ≫ μZ near the edge",
        format!(
            "I below {integral:.0e}; the traction is above its bound at {beyond} of {} points, up to {most:.0} \
             times",
            theory.mesh().len()
        ),
        integral < 1e-20 && most > 2.0,
    ))
}
