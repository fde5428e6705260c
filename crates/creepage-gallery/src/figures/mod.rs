//! A file a figure.

pub(crate) mod angles;
mod coefficients;
pub(crate) mod fig10;
pub(crate) mod fig11;
pub(crate) mod fig12;
pub(crate) mod fig13;
pub(crate) mod fig14;
pub(crate) mod fig15;
pub(crate) mod fig2;
pub(crate) mod fig3;
pub(crate) mod fig3a;
pub(crate) mod fig3b;
pub(crate) mod fig4;
pub(crate) mod fig5;
mod printed_page;
mod saturation;
mod slender;
