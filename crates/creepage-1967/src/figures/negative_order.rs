//! Proposition II: Legendre functions of negative order in oblate spheroidal coordinates.

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("ii-negative-order", "Proposition II. Why negative order is better", || Ok(make()));

/// Degrees and orders `n = m` of which the sizes are shown.
const MAX_DEGREE: u32 = 20;
/// The oblate spheroids `eta` on which the potential is taken.
const ETAS: [f64; 3] = [0.3, 0.6, 1.5];

/// Oblate spheroidal coordinates (proposition II, `a = 1`) on the half-plane `psi = 0`.
fn place(omega: f64, eta: f64) -> [f64; 2] {
    [((1.0 - omega * omega) * (1.0 + eta * eta)).sqrt(), omega * eta]
}

/// `dF/dx` of `F`, the integral of `X log(R + z)` over the circle with the traction of a shift,
/// `X = (1 - r^2)^(-1/2)`: what displacements under a tangential traction are made of, see (2.12).
fn by_quadrature([x, z]: [f64; 2]) -> f64 {
    // r = sin t takes the singularity away; trapezoids are exact round the circle but for e^-N.
    const RADII: u32 = 400;
    const ANGLES: u32 = 400;
    let mut sum = 0.0;
    for i in 0..=RADII {
        let t = std::f64::consts::FRAC_PI_2 * f64::from(i) / f64::from(RADII);
        let simpson = match (i, i % 2) {
            (0 | RADII, _) => 1.0,
            (_, 1) => 4.0,
            _ => 2.0,
        };
        let weight = simpson * t.sin();
        for k in 0..ANGLES {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(ANGLES);
            let [dx, dy] = [x - t.sin() * angle.cos(), t.sin() * angle.sin()];
            let distance = (dx * dx + dy * dy + z * z).sqrt();
            sum += weight * dx / (distance * (distance + z));
        }
    }
    sum * std::f64::consts::FRAC_PI_2 / f64::from(RADII) / 3.0 * std::f64::consts::TAU
        / f64::from(ANGLES)
}

/// `P_0^-1(omega) Q_0^1(i eta)`: `((1 - omega)/(1 + omega))^(1/2) (1 + eta^2)^(-1/2)`. With positive
/// order `P_0^1 = 0`.
fn negative(omega: f64, eta: f64) -> f64 {
    ((1.0 - omega) / (1.0 + omega)).sqrt() / (1.0 + eta * eta).sqrt()
}

/// Largest `|P_n^m Q_n^m|` and `|P_n^-m Q_n^m|` on the half-space's surface for `n = m`, as powers of ten:
/// `P_n^n(0) = (2n-1)!!`, `P_n^-n(0) = 1/(2n)!!`, and `|Q_n^n(i eta)|` at `eta = 0`.
fn sizes() -> Vec<[f64; 3]> {
    (1..=MAX_DEGREE)
        .map(|n| {
            let n = f64::from(n);
            // |Q_n^n(0i)| = sqrt(pi) 2^(n-1) Gamma((2n+1)/2)/Gamma(1) = pi/2 (2n-1)!!.
            let odd = double_factorial(2.0 * n - 1.0);
            let even = double_factorial(2.0 * n);
            let q = std::f64::consts::FRAC_PI_2.log10() + odd;
            [n, odd + q, q - even]
        })
        .collect()
}

/// `log10 k!!`.
fn double_factorial(k: f64) -> f64 {
    let (mut sum, mut factor) = (0.0, k);
    while factor > 1.0 {
        sum += factor.log10();
        factor -= 2.0;
    }
    sum
}

fn make() -> Reproduction {
    // Nearer to the surface the quadrature would need more points.
    let omegas = spaced(0.35, 0.95, 12);
    let mut data = Data::new(["curve", "eta_or_n", "omega", "value"]);
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    let mut curves = Vec::new();
    for eta in ETAS {
        let found: Curve =
            omegas.iter().map(|omega| [*omega, by_quadrature(place(*omega, eta))]).collect();
        for [omega, value] in &found {
            let formula = std::f64::consts::TAU * negative(*omega, eta);
            worst = worst.max((value - formula).abs());
            largest = largest.max(formula);
        }
        data.points("by quadrature", &[eta], &found);
        let line: Curve = spaced(0.0, 1.0, 80)
            .into_iter()
            .map(|omega| [omega, std::f64::consts::TAU * negative(omega, eta)])
            .collect();
        data.points("negative order", &[eta], &line);
        curves.push((eta, found, line));
    }
    let sizes = sizes();
    for [n, positive, negative] in &sizes {
        data.push([
            "largest product, positive order".into(),
            (*n).into(),
            0.0.into(),
            (*positive).into(),
        ]);
        data.push([
            "largest product, negative order".into(),
            (*n).into(),
            0.0.into(),
            (*negative).into(),
        ]);
    }
    let last = sizes[sizes.len() - 1];
    let agreement = vec![
        Comparison::claim(
            "dF/dx of the traction of a shift, order 1 of degree 0",
            "functions of negative order have an advantage",
            format!(
                "2π P₀⁻¹ Q₀¹ within {:.0e} of its largest value inside the half-space; P₀¹ = 0",
                worst / largest
            ),
            worst < 1e-6 * largest,
        ),
        Comparison::claim(
            "largest product on the surface, n = m = 20",
            "functions of negative order have an advantage",
            format!(
                "10^{:.0} with positive order, {:.2} with negative",
                last[1],
                10f64.powf(last[2])
            ),
            last[1] > 40.0 && last[2].abs() < 2.0,
        ),
    ];
    let caption = "Two reasons for the functions of negative order in oblate spheroidal coordinates, a = 1. Above: displacements \
        under tangential tractions need ∫X dz (2.12), whose gradient for the traction of a shift, (1 - r²)^(-1/2), has order \
        1 and degree 0. There P₀¹ vanishes; P₀⁻¹ = ((1 - ω)/(1 + ω))^(1/2) does not, and is finite in the half-space ω ≥ 0, for its \
        pole ω = -1 lies outside. It is that potential (lines), by quadrature over the traction (points). So \
        differentiation and integration never leave the family. Below: the largest product K_n^m Q_n^m on the surface for n = m, as a power of \
        ten. With positive order it grows as (2n - 1)!!², with negative order it stays of order one. The library's harmonics are \
        normalized to the same end. The thesis has the statement alone.";
    Reproduction::figure(&sheet(&curves, &sizes), caption, data, agreement)
}

fn sheet(curves: &[(f64, Curve, Curve)], sizes: &[[f64; 3]]) -> Sheet {
    let x = Axis::new([0.0, 1.0], Label::default().symbol("ω"));
    let y = Axis::new([0.0, 6.5], Label::new("d").symbol("F").plain("/d").symbol("x"));
    let mut potential = Panel::new(x, y).height(300.0);
    let mut sheet = Sheet::new(ITEM.title);
    for (k, (eta, found, line)) in curves.iter().enumerate() {
        let pen = Pen::of(k);
        potential = potential
            .curve(line.clone(), pen)
            .marks(found.clone(), Mark::open(Shape::Circle, pen.colour));
        sheet = sheet.key(
            pen,
            Label::new("2π")
                .indexed("P", "0")
                .plain("⁻¹")
                .indexed("Q", "0")
                .plain("¹, ")
                .symbol("η")
                .plain(" = ")
                .number(&eta.to_string()),
        );
    }
    potential = potential.curve(vec![[0.0, 0.0], [1.0, 0.0]], TANGENT.wide(2.6));
    let x = Axis::new([0.0, 20.0], Label::default().symbol("n").plain(" = ").symbol("m"));
    let y = Axis::new([-5.0, 50.0], Label::new("power of ten"));
    let column = |k: usize| sizes.iter().map(|row| [row[0], row[k]]).collect::<Curve>();
    let growth =
        Panel::new(x, y).height(220.0).marks(column(1), FULL_MARK).marks(column(2), PRINTED);
    sheet
        .panel(potential)
        .panel(growth)
        .key(TANGENT.wide(2.6), Label::new("positive order: ").indexed("P", "0").plain("¹ = 0"))
        .key(FULL_MARK, Label::new("largest product, positive order"))
        .key(PRINTED, Label::new("largest product, negative order"))
}
