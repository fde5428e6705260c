//! Loads an FMU by the crate `fmi`, sets its inputs, and prints its outputs: `fmu-importer FILE KIND INPUTS OUTPUTS`, with
//! `me` or `cs` as kind, inputs as `reference=value,...` and outputs as `reference,...`.

use std::error::Error;

use fmi::fmi2::import::Fmi2Import;
use fmi::fmi2::instance::{CoSimulation as _, Common as _};
use fmi::fmi3::import::Fmi3Import;
use fmi::fmi3::{CoSimulation as _, Fmi3Model as _, GetSet as _};
use fmi::schema::MajorVersion;
use fmi::schema::traits::FmiModelDescription as _;
use fmi::traits::{FmiInstance, FmiModelExchange};
use fmi::{EventFlags, import};

type Answer<T> = Result<T, Box<dyn Error>>;

/// From nothing to where inputs may be set.
fn initialized<I: FmiInstance>(mut instance: I) -> Answer<I>
where
    <I::Status as fmi::traits::FmiStatus>::Err: 'static + Error,
{
    instance.enter_initialization_mode(None, 0.0, None)?;
    instance.exit_initialization_mode()?;
    Ok(instance)
}

/// On to continuous time, as an integrator would have it.
fn continuous<I: FmiModelExchange>(instance: &mut I) -> Answer<()>
where
    <I::Status as fmi::traits::FmiStatus>::Err: 'static + Error,
{
    instance.update_discrete_states(&mut EventFlags::default())?;
    instance.enter_continuous_time_mode()?;
    instance.set_time(0.01)?;
    Ok(())
}

fn main() -> Answer<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [file, kind, inputs, outputs] = &words[..] else {
        return Err("fmu-importer FILE me|cs REFERENCE=VALUE,... REFERENCE,...".into());
    };
    let (mut of, mut values) = (Vec::new(), Vec::new());
    for input in inputs.split(',') {
        let (reference, value) = input.split_once('=').ok_or("an input is REFERENCE=VALUE")?;
        of.push(reference.parse::<u32>()?);
        values.push(value.parse::<f64>()?);
    }
    let wanted = outputs.split(',').map(str::parse).collect::<Result<Vec<u32>, _>>()?;
    let mut found = vec![0.0; wanted.len()];
    match (import::peek_descr_path(file)?.major_version()?, kind.as_str()) {
        (MajorVersion::FMI2, "me") => {
            let import: Fmi2Import = import::from_path(file)?;
            let mut one = initialized(import.instantiate_me("one", false, false)?)?;
            continuous(&mut one)?;
            one.set_real(&of, &values)?;
            one.get_real(&wanted, &mut found)?;
        }
        (MajorVersion::FMI2, _) => {
            let import: Fmi2Import = import::from_path(file)?;
            let mut one = initialized(import.instantiate_cs("one", false, false)?)?;
            one.set_real(&of, &values)?;
            one.do_step(0.0, 0.01, false)?;
            one.get_real(&wanted, &mut found)?;
        }
        (MajorVersion::FMI3, "me") => {
            let import: Fmi3Import = import::from_path(file)?;
            let mut one = initialized(import.instantiate_me("one", false, false)?)?;
            continuous(&mut one)?;
            one.set_float64(&of, &values)?;
            one.get_float64(&wanted, &mut found)?;
        }
        (MajorVersion::FMI3, _) => {
            let import: Fmi3Import = import::from_path(file)?;
            let instance = import.instantiate_cs("one", false, false, false, false, &[])?;
            let mut one = initialized(instance)?;
            one.set_float64(&of, &values)?;
            let (mut event, mut stop, mut early, mut last) = (false, false, false, 0.0);
            one.do_step(0.0, 0.01, true, &mut event, &mut stop, &mut early, &mut last)?;
            one.get_float64(&wanted, &mut found)?;
        }
        (version, _) => return Err(format!("FMI {version:?} is none of ours").into()),
    }
    for value in found {
        println!("{value:?}");
    }
    Ok(())
}
