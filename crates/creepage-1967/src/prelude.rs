//! Common imports of every table and figure.

pub(crate) use creepage_plot::{
    Anchor, Axis, Fill, Label, Mark, Panel, Pen, Sample, Shape, Sheet, closed,
};

pub(crate) use crate::axes::{
    self, BAND, FULL, FULL_MARK, OF_1967, PRINTED, RING, SECOND, TANGENT, THIRD,
};
pub(crate) use crate::comparison::{Comparison, Verdict};
pub(crate) use crate::contact::{self, Field, Polygon};
pub(crate) use crate::data::Data;
pub(crate) use crate::error::GalleryError;
pub(crate) use crate::item::{EXPERIMENTS, Item, Reproduction};
pub(crate) use crate::theories::{
    CATALOGUE, Curve, STEEL, band, chained, chapter_5, farthest, full, full_solutions, like_bodies,
    points, rolling_at, spaced,
};
