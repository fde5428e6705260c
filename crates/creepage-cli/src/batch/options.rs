//! The theory's options on the command line of `batch`.

use creepage_study::{CaseError, ChoiceError, Entry, Solve, TheoryError, choose};

/// Why the options are not those of the theory.
#[derive(Debug, thiserror::Error)]
pub(crate) enum OptionError {
    #[error(transparent)]
    Form(#[from] CaseError),
    #[error("`theory` is given by --theory")]
    Theory,
    #[error(transparent)]
    Foreign(#[from] ChoiceError),
    #[error(transparent)]
    Value(#[from] TheoryError),
}

/// The options, known to the theory and of values that it takes.
pub(super) fn read(theory: &Entry, options: &[String]) -> Result<Solve, OptionError> {
    let given = Solve::read(options)?;
    if given.theory.is_some() {
        return Err(OptionError::Theory);
    }
    let solve = Solve { theory: Some(theory.name.into()), ..given };
    choose(&[], &solve)?;
    if !options.is_empty() {
        // No row could be answered if the theory took them not even for a circle.
        theory.prepare(1.0, 0.25, &solve)?;
    }
    Ok(solve)
}
