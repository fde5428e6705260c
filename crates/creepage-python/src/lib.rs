//! The Python package's compiled part: thin bindings, every formula stays in the library.
//!
//! `python/creepage` holds the rest: dataclasses, pictures, type stubs.

mod batch;
mod bearing;
mod bulk;
mod case;
mod closed_forms;
mod command;
mod errors;
mod exact;
mod gap;
mod half_space;
mod map;
mod mesh;
mod number;
mod options;
mod pool;
mod results;
mod rolling;
mod signals;
mod statics;
mod sweep;
mod table;
mod table_build;
mod theories;
mod theory;
mod wear;
mod wheelset;

/// Rolling contact of two elastic bodies with dry friction.
#[pyo3::pymodule]
mod _creepage {
    #[pymodule_export]
    use crate::bearing::SolvedBearing;
    #[pymodule_export]
    use crate::bulk::{case_forces, row_forces};
    #[pymodule_export]
    use crate::case::{CaseData, SolvedCase, hertz};
    #[pymodule_export]
    use crate::closed_forms::{
        carter, carter_field, coefficients, line_contact, viscoelastic_cylinders,
    };
    #[pymodule_export]
    use crate::command::command;
    #[pymodule_export]
    use crate::exact::Exact;
    #[pymodule_export]
    use crate::gap::{GapData, SolvedGapData, solve_gaps};
    #[pymodule_export]
    use crate::half_space::HalfSpaceData;
    #[pymodule_export]
    use crate::map::ContactMapData;
    #[pymodule_export]
    use crate::rolling::{RollingData, roll};
    #[pymodule_export]
    use crate::statics::SolvedStatics;
    #[pymodule_export]
    use crate::sweep::SweepData;
    #[pymodule_export]
    use crate::table::Table;
    #[pymodule_export]
    use crate::theories::{
        Automatic, Fastrip, Fastsim, Linear, Polach, Saturated, ShenHedrickElkins, Strip,
        Variational, VermeulenJohnson,
    };
    #[pymodule_export]
    use crate::theory::{DifferentiableTheory, Theory};
    #[pymodule_export]
    use crate::wear::WearData;
    #[pymodule_export]
    use crate::wheelset::{SolvedWheelset, WheelsetData};

    #[pymodule_export]
    #[allow(non_upper_case_globals)] // Python's name for it
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
