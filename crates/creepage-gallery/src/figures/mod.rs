//! A file a figure.

pub(crate) mod fig13;
