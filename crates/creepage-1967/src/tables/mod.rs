//! Tables of the thesis, one module each.

pub(crate) mod claims;
pub(crate) mod coefficients;
mod entries;
mod printed;
pub(crate) mod table1;
pub(crate) mod table2;
pub(crate) mod table3;
pub(crate) mod table4;
pub(crate) mod table5;
mod weights;
