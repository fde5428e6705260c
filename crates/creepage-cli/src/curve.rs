//! `creepage curve`: creep-force curves of several theories.

use creepage::InvalidValue;
use creepage::rolling::Scaling;
use creepage::rolling::linear::Linear;
use creepage_study::{Case, Component, Curves, kappa_over_mu};

use crate::args::{CurveArgs, Quantity};
use crate::failure::Failure;
use crate::input::{choose, read_case};
use crate::output::{print, say, say_written};

pub(crate) fn run(args: &CurveArgs) -> Result<(), Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let case = read_case(&args.case)?.case().map_err(wrong)?;
    let theories = choose(&args.theory, &case.solve, &args.case)?;
    let (vary, [from, to]) = range(args, &case)?;
    let values = spaced(from, to, args.points);
    let mut curves = Curves::new(&case.contact, case.friction, case.creepage, vary, values)?;
    for theory in theories {
        let prepared = theory
            .for_contact(&case.contact, case.friction, &case.solve)
            .map_err(|source| Failure::Options { path: args.case.clone(), source })?;
        curves.add(theory.name, &prepared);
        if let Some(left_out) = theory.leaves_out(kappa_over_mu(&case.contact, case.friction)) {
            say(&format!("caution: {left_out}"));
        }
    }
    let Some(directory) = &args.out else {
        return print(&String::from_utf8_lossy(&curves.csv()?));
    };
    say_written(&curves.write(directory)?);
    Ok(())
}

/// What to vary, and its first and last value, dimensionless.
fn range(args: &CurveArgs, case: &Case) -> Result<(Component, [f64; 2]), Failure> {
    let vary = args.vary.map_or_else(|| most(case), |quantity| Ok(quantity.component()))?;
    let scaling = Scaling::new(&case.contact, case.friction)?;
    let unit = args.vary.map_or(1.0, |quantity| quantity.unit(&scaling));
    let given = |name, value: Option<f64>| value.map(|value| finite(name, value)).transpose();
    let from = given("from", args.from)?.unwrap_or(0.0) / unit;
    let to = match given("to", args.to)? {
        Some(value) => value / unit,
        None => usual_end(case, vary)?,
    };
    if (to - from).abs() <= f64::EPSILON * from.abs() {
        let valid = "another than that of --from";
        return Err(InvalidValue { quantity: "to", value: to * unit, valid }.into());
    }
    Ok((vary, [from, to]))
}

fn finite(quantity: &'static str, value: f64) -> Result<f64, InvalidValue> {
    let valid = "a finite number";
    if value.is_finite() { Ok(value) } else { Err(InvalidValue { quantity, value, valid }) }
}

const COMPONENTS: [Component; 3] = [Component::Longitudinal, Component::Lateral, Component::Spin];

/// The component that makes the largest force in linear theory.
fn most(case: &Case) -> Result<Component, InvalidValue> {
    let gains = gains(case)?;
    let force = |k: usize| (gains[k] * COMPONENTS[k].of(case.creepage)).abs();
    let largest = (0..3).reduce(|one, two| if force(two) > force(one) { two } else { one });
    Ok(COMPONENTS[largest.unwrap_or(0)])
}

/// Four times the value at which linear theory reaches `mu N`, rounded up, on the side where the
/// case lies; beyond the case itself.
fn usual_end(case: &Case, vary: Component) -> Result<f64, InvalidValue> {
    let gain = gains(case)?[COMPONENTS.iter().position(|one| *one == vary).unwrap_or(0)];
    let value = vary.of(case.creepage);
    let end = f64::max(4.0 / gain, 1.25 * value.abs());
    let power = 10_f64.powf(end.log10().floor());
    Ok(((2.0 * end / power).ceil() * 0.5 * power).copysign(value))
}

/// Linear theory's force by each component alone; of the spin the lateral one.
fn gains(case: &Case) -> Result<[f64; 3], InvalidValue> {
    let (ratio, poisson) = (case.contact.ellipse().ratio(), case.contact.pair().poisson());
    let [along, across, _] = Linear::new(ratio, poisson)?.derivative(case.creepage);
    Ok([along[0], across[1], across[2]])
}

/// `count` values from one to the other, both included.
fn spaced(from: f64, to: f64, count: u16) -> Vec<f64> {
    let last = f64::from(count - 1);
    (0..count).map(|k| from + (to - from) * (f64::from(k) / last)).collect()
}

impl Quantity {
    fn component(self) -> Component {
        match self {
            Self::Longitudinal | Self::Xi => Component::Longitudinal,
            Self::Lateral | Self::Eta => Component::Lateral,
            Self::Spin | Self::Chi => Component::Spin,
        }
    }

    /// The unit in which it is given, over the dimensionless one.
    fn unit(self, scaling: &Scaling) -> f64 {
        match self {
            Self::Longitudinal | Self::Lateral => scaling.slip,
            Self::Spin => scaling.slip / scaling.length,
            Self::Xi | Self::Eta | Self::Chi => 1.0,
        }
    }
}
