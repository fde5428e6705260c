//! Answer of a bulk row: its force and other numbers in SI units.

use creepage::SiForce;
use rayon::prelude::*;

use super::case::{BulkCase, BulkRow};
use super::solver::{Reply, RowError, Solver};
use crate::damage::DamageInput;
use crate::{Damage, DamageWanted};

/// Answer of a row, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct BulkAnswer {
    /// What was asked.
    pub row: BulkRow,
    /// The dimensionless answer, with all its cautions.
    pub reply: Reply,
}

/// Column of a row's answer besides the dimensionless force.
#[derive(Debug, Clone, Copy)]
pub struct BulkColumn {
    /// The name of its column.
    pub name: &'static str,
    /// The path of the quantity in the report of the row's case.
    pub path: &'static str,
    /// The number; `None` without a rolling velocity that it needs.
    value: fn(&BulkAnswer) -> Option<f64>,
}

impl BulkColumn {
    const fn new(
        name: &'static str,
        path: &'static str,
        value: fn(&BulkAnswer) -> Option<f64>,
    ) -> Self {
        Self { name, path, value }
    }

    /// All of them; the last one needs a rolling velocity.
    pub const ALL: [Self; 5] = [
        Self::new("longitudinal_n", "lower_body.longitudinal_n", |one| {
            Some(one.force().longitudinal)
        }),
        Self::new("lateral_n", "lower_body.lateral_n", |one| Some(one.force().lateral)),
        Self::new("moment_n_m", "lower_body.moment_n_m", |one| Some(one.force().moment)),
        Self::new(
            "frictional_power_per_metre_j_per_m",
            "frictional_power_per_metre_j_per_m",
            |one| Some(one.power_per_metre()),
        ),
        Self::new("frictional_power_w", "frictional_power_w", BulkAnswer::power),
    ];
}

impl BulkAnswer {
    /// The answer to a row, with the row's own cautions.
    #[must_use]
    pub fn new(row: BulkRow, mut reply: Reply) -> Self {
        reply.cautions.extend(row.cautions());
        Self { row, reply }
    }

    /// Force of the upper body on the lower.
    #[must_use]
    pub fn force(&self) -> SiForce {
        self.row.contact.scaling().si_force(self.reply.solution.force)
    }

    /// Energy turned to heat per metre rolled (J/m), from force and creepage.
    #[must_use]
    pub fn power_per_metre(&self) -> f64 {
        let scaling = self.row.contact.scaling();
        scaling.force * scaling.slip * self.reply.power
    }

    /// Wear and fatigue numbers by the laws that are wanted, of forces and creepage alone.
    #[must_use]
    pub fn damage(&self, wanted: &DamageWanted) -> Damage {
        let (hertz, scaling) = (&self.row.hertz, self.row.contact.scaling());
        let input = DamageInput {
            force: self.force(),
            creepage: scaling.si_creepage(self.row.creepage),
            normal: hertz.normal_force(),
            area: hertz.ellipse().area(),
            peak: hertz.peak_pressure(),
            speed: self.row.speed,
            rows: None,
        };
        Damage::new(wanted, &input, None)
    }

    /// The numbers of [`BulkCase::columns`], with those of `damage` if these are wanted.
    pub fn numbers(&self, damage: Option<&DamageWanted>) -> impl Iterator<Item = f64> {
        let own = BulkColumn::ALL.iter().filter_map(|column| (column.value)(self));
        own.chain(damage.map(|wanted| self.damage(wanted).of_rows()).into_iter().flatten())
    }

    /// Frictional power (W), where the rolling velocity is known.
    #[must_use]
    pub fn power(&self) -> Option<f64> {
        self.row.speed.map(|speed| speed * self.power_per_metre())
    }
}

impl BulkCase {
    /// Names of the numbers that a row has besides its dimensionless answer: force and heat, wear and fatigue if they are
    /// wanted.
    #[must_use]
    pub fn columns(&self) -> Vec<&'static str> {
        let known =
            if self.has_speed() { BulkColumn::ALL.len() } else { BulkColumn::ALL.len() - 1 };
        let own = BulkColumn::ALL[..known].iter().map(|column| column.name);
        own.chain(self.damage().into_iter().flat_map(|_| Damage::OF_ROWS)).collect()
    }

    /// The answer to one row of values.
    ///
    /// # Errors
    /// [`RowError`] for values that are no case.
    pub fn solve_one(&self, solver: &Solver, values: &[f64]) -> Result<BulkAnswer, RowError> {
        let row = self.row(values)?;
        let reply = solver.solve_one(&row.query())?;
        Ok(BulkAnswer::new(row, reply))
    }

    /// The answers to rows of values, in their order; the same on any number of cores.
    #[must_use]
    pub fn solve(&self, solver: &Solver, rows: &[&[f64]]) -> Vec<Result<BulkAnswer, RowError>> {
        let row = |values: &&[f64]| self.row(values).map_err(RowError::from);
        let rows: Vec<_> = rows.par_iter().map(row).collect();
        let query = |row: &Result<BulkRow, RowError>| {
            row.as_ref().map(BulkRow::query).map_err(Clone::clone)
        };
        let replies = solver.solve(rows.iter().map(query).collect());
        let together = |(row, reply): (_, _)| Ok(BulkAnswer::new(row?, reply?));
        rows.into_par_iter().zip(replies).map(together).collect()
    }
}
