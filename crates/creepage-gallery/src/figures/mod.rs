//! A file a figure.

pub(crate) mod angles;
pub(crate) mod fig13;
pub(crate) mod fig14;
pub(crate) mod fig15;
