//! A file a table.

pub(crate) mod entries;
pub(crate) mod table1;
pub(crate) mod table2;
