//! A file a figure.

pub(crate) mod angles;
mod coefficients;
pub(crate) mod convergence;
pub(crate) mod fig10;
pub(crate) mod fig11;
pub(crate) mod fig13;
pub(crate) mod fig14;
pub(crate) mod fig15;
pub(crate) mod fig16;
pub(crate) mod fig17;
pub(crate) mod fig18;
pub(crate) mod fig19;
pub(crate) mod fig2;
pub(crate) mod fig20;
pub(crate) mod fig21;
pub(crate) mod fig22;
pub(crate) mod fig23;
pub(crate) mod fig24;
pub(crate) mod fig3;
pub(crate) mod fig3a;
pub(crate) mod fig3b;
pub(crate) mod islands;
pub(crate) mod judgement;
mod saturation;
mod slender;
mod tractions;
