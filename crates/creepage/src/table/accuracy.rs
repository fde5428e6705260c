//! Accuracy of a table against its theory.

/// Distribution of an error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    /// Half of the random places err by less.
    pub median: f64,
    /// 95 of 100 random places err by less.
    pub p95: f64,
    /// 99 of 100 random places err by less.
    pub p99: f64,
    /// Largest of all, random and hard.
    pub worst: f64,
}

/// The error of a table against its theory, none of it at a node: at places spread at random and
/// evenly over the table's coordinates, and at hard ones, the middles of the cells where the
/// force bends most, half-way between shapes and Poisson's ratios.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Accuracy {
    /// Number of random places.
    pub places: usize,
    /// Number of hard places.
    pub hard_places: usize,
    /// Length of the difference of `(f_x, f_y)`, in parts of `mu N`.
    pub force: Spread,
    /// Size of the difference of `m_z`, in parts of `mu N c`.
    pub moment: Spread,
}

impl Spread {
    pub(crate) fn new(mut random: Vec<f64>, hard: &[f64]) -> Self {
        random.sort_unstable_by(f64::total_cmp);
        let at = |hundredths: usize| {
            random.get(random.len() * hundredths / 100).copied().unwrap_or_default()
        };
        let worst = random.iter().chain(hard).copied().fold(0.0, f64::max);
        Self { median: at(50), p95: at(95), p99: at(99), worst }
    }
}
