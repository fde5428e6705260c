//! `creepage curve`: creep-force curves of several theories.

use creepage::theory::NoOptions;
use creepage::{Contact, Creepage, InvalidValue, Scaling, TheorySpec};
use creepage_study::{AnyCase, Caution, Component, Curves, MeasuredPoints, Sources};

use crate::args::{CurveArgs, Quantity};
use crate::failure::Failure;
use crate::input::{read_any_case, read_text, sources_of, theories};
use crate::output::{print, say, say_written};

pub(crate) fn run(args: &CurveArgs) -> Result<(), Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let case = read_any_case(&args.case)?;
    let contact = case
        .lies_in_a_plane("curves")
        .and_then(|()| case.contact())
        .map_err(|source| Failure::Gap { path: args.case.clone(), source: Box::new(source) })?;
    let creepage = case.creepage(&contact).map_err(wrong)?;
    let theories = theories(&args.theory, &case)?;
    let measured = measured(args)?;
    let (vary, [from, to]) = range(args, &contact, creepage, measured.as_ref())?;
    let values = spaced(from, to, args.points);
    let curves = match &case {
        AnyCase::Ellipse(case) => Curves::new(case, vary, values),
        AnyCase::Gap(case) => Curves::on_areas(case, contact.clone(), vary, values),
    };
    let mut curves = curves.map_err(wrong)?;
    let largest = if from.abs() > to.abs() { from } else { to };
    let largest = vary.replaced(creepage, largest)?;
    for caution in case.cautions_of_units(&contact, largest) {
        say(&format!("caution: {caution}"));
    }
    for theory in theories {
        let name = theory.facts().name;
        let prepared = theory
            .prepare(&contact)
            .map_err(|source| Failure::Solve { path: args.case.clone(), source: source.into() })?;
        curves.add(name, &*prepared);
        for caution in Caution::neglected(&theory, &contact) {
            say(&format!("caution: {caution}"));
        }
    }
    if let Some(caution) = Caution::beyond_friction(curves.largest_share()) {
        say(&format!("caution: {caution}"));
    }
    for (theory, largest) in curves.largest() {
        let (force, value) =
            (largest.force.magnitude(), shown(vary, largest.at, &contact.scaling()));
        say(&format!("{theory}: largest force {force:.5} of mu N at {value}"));
    }
    if let (Some(path), Some(measured)) = (&args.data, &measured) {
        let notes = curves
            .lay_over(measured)
            .map_err(|source| Failure::Measured { path: path.clone(), source })?;
        for note in notes {
            say(&format!("caution: {note}"));
        }
    }
    let Some(directory) = &args.out else {
        return print(&String::from_utf8_lossy(&curves.csv()?));
    };
    let sources = sources_of(&args.case).with(&Sources::new(&args.data));
    say_written(&curves.write(directory, &sources)?);
    Ok(())
}

/// The points to lay over the curves.
fn measured(args: &CurveArgs) -> Result<Option<MeasuredPoints>, Failure> {
    let Some(path) = &args.data else { return Ok(None) };
    let wrong = |source| Failure::Measured { path: path.clone(), source };
    MeasuredPoints::read(&read_text(path)?).map(Some).map_err(wrong)
}

/// What to vary, and its first and last value, dimensionless; by default as far as points were measured.
fn range(
    args: &CurveArgs,
    contact: &Contact,
    creepage: Creepage,
    measured: Option<&MeasuredPoints>,
) -> Result<(Component, [f64; 2]), Failure> {
    let gains = gains(args, contact, creepage)?;
    let usual = || measured.map_or_else(|| most(gains, creepage), MeasuredPoints::varies);
    let vary = args.vary.map_or_else(usual, Quantity::component);
    let [first, last] = extent(measured, vary, &contact.scaling());
    let unit = args.vary.map_or(1.0, |quantity| quantity.unit(&contact.scaling()));
    let given = |name, value: Option<f64>| value.map(|value| finite(name, value)).transpose();
    let end = usual_end(gains, vary, creepage);
    // Points on one side of zero, or on both, decide how far.
    let [first, last] = match measured {
        None => [0.0, end],
        Some(_) if last > 0.0 => [first, last.max(end.abs())],
        Some(_) => [first.min(-end.abs()), 0.0],
    };
    let from = given("from", args.from)?.map_or(first, |value| value / unit);
    let to = match given("to", args.to)? {
        Some(value) => value / unit,
        None => last,
    };
    if (to - from).abs() <= f64::EPSILON * from.abs() {
        let valid = "another than that of --from";
        return Err(InvalidValue { quantity: "to", value: to * unit, valid }.into());
    }
    Ok((vary, [from, to]))
}

/// From the least to the largest measured value, with zero; dimensionless.
fn extent(measured: Option<&MeasuredPoints>, vary: Component, scaling: &Scaling) -> [f64; 2] {
    /// Beyond the last point.
    const AIR: f64 = 1.04;
    let k = COMPONENTS.iter().position(|one| *one == vary).unwrap_or(0);
    let unit = [scaling.slip, scaling.slip, scaling.slip / scaling.length][k];
    let points = measured.map_or(&[][..], |measured| &measured.points);
    let values = points.iter().filter_map(|point| Some(AIR * point.creepage[k]? / unit));
    values.fold([0.0, 0.0], |[low, high]: [f64; 2], value| [low.min(value), high.max(value)])
}

fn finite(quantity: &'static str, value: f64) -> Result<f64, InvalidValue> {
    let valid = "a finite number";
    if value.is_finite() { Ok(value) } else { Err(InvalidValue { quantity, value, valid }) }
}

const COMPONENTS: [Component; 3] = Component::ALL;

/// The component that makes the largest force in linear theory.
fn most(gains: [f64; 3], creepage: Creepage) -> Component {
    let force = |k: usize| (gains[k] * COMPONENTS[k].of(creepage)).abs();
    let largest = (0..3).reduce(|one, two| if force(two) > force(one) { two } else { one });
    COMPONENTS[largest.unwrap_or(0)]
}

/// Four times the value at which linear theory reaches `mu N`, rounded up, on the side where the
/// case lies; beyond the case itself.
fn usual_end(gains: [f64; 3], vary: Component, creepage: Creepage) -> f64 {
    let gain = gains[COMPONENTS.iter().position(|one| *one == vary).unwrap_or(0)];
    let value = vary.of(creepage);
    let end = f64::max(4.0 / gain, 1.25 * value.abs());
    let power = 10_f64.powf(end.log10().floor());
    ((2.0 * end / power).ceil() * 0.5 * power).copysign(value)
}

/// Linear theory's force by each component alone; of the spin the lateral one.
fn gains(args: &CurveArgs, contact: &Contact, creepage: Creepage) -> Result<[f64; 3], Failure> {
    let linear = TheorySpec::Linear(NoOptions {})
        .prepare(&contact.without_added_slip())
        .map_err(|source| Failure::Solve { path: args.case.clone(), source: source.into() })?;
    let [along, across, _] = linear.jacobian(creepage).unwrap_or_default();
    Ok([along[0], across[1], across[2]])
}

/// `count` values from one to the other, both included.
fn spaced(from: f64, to: f64, count: u16) -> Vec<f64> {
    let last = f64::from(count - 1);
    (0..count).map(|k| from + (to - from) * (f64::from(k) / last)).collect()
}

/// A value of the component that varies, in both kinds of units.
fn shown(vary: Component, value: f64, scaling: &Scaling) -> String {
    let (name, si) = match vary {
        Component::Longitudinal => ("xi", Quantity::Longitudinal),
        Component::Lateral => ("eta", Quantity::Lateral),
        Component::Spin => ("chi", Quantity::Spin),
    };
    format!("{name} = {value:.5} ({:.5e} in SI units)", value * si.unit(scaling))
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
