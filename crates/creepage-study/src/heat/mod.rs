//! Temperatures of a solved contact, by the moving source of heat.

mod files;
mod rows;
mod section;
mod text;

use creepage::temperature::{HeatRow, HeatedPair};
use serde::Serialize;

use crate::{Caution, SolvedCase};
pub(crate) use files::PLACE_HEADER;
pub(crate) use rows::of_elements;
pub(crate) use section::HeatSection;
pub use section::HeatWanted;

/// Temperatures of both surfaces in steady rolling. Key names carry their units; temperatures are in the
/// scale of the case's bulk temperatures, which are zero unless given.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Heat {
    /// The highest temperature in the contact, of both surfaces (degrees Celsius).
    pub contact_temperature_max_c: f64,
    /// Where: along and across (m); `null` where nothing is rubbed.
    pub place_m: Option<[f64; 2]>,
    /// The largest rise by friction, above the temperature of unrubbed surfaces in contact (K).
    pub flash_max_k: f64,
    /// The temperature of both surfaces in contact where nothing is rubbed (degrees Celsius).
    pub contact_temperature_unrubbed_c: f64,
    /// The upper body's share of the heat of friction.
    pub share_upper: f64,
    /// Heat of friction (W), from traction and slip over the contact.
    pub friction_w: f64,
    /// Heat that enters the upper body (W): its share, and what flows from a hotter lower body.
    pub into_upper_w: f64,
    /// Heat that enters the lower body (W).
    pub into_lower_w: f64,
    /// Peclet number `V a/(2 kappa)` of the upper body, `a` half of the longest row.
    pub peclet_upper: f64,
    /// Peclet number of the lower body.
    pub peclet_lower: f64,
    /// Depth of the upper body that is heated while the contact passes (m).
    pub depth_upper_m: f64,
    /// Depth of the lower body that is heated (m).
    pub depth_lower_m: f64,
    /// The rows, not in `report.json` but in `temperature.csv`.
    #[serde(skip)]
    pub rows: Vec<HeatedRow>,
    /// The bodies that rub.
    #[serde(skip)]
    pub pair: HeatedPair,
}

/// One row of a contact along the rolling direction.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatedRow {
    /// Its middle across (m).
    pub y: f64,
    /// Its width (m).
    pub width: f64,
    /// What is rubbed.
    pub heat: HeatRow,
}

impl HeatedRow {
    fn reaches(&self, y: f64) -> bool {
        (y - self.y).abs() < 0.5 * self.width
    }
}

impl Heat {
    /// Temperatures by rows of a contact that rolls at `speed` (m/s), with the cautions about them.
    /// The cautions alone, where there are none: no slip is known, or a surface runs back.
    pub(crate) fn of(
        wanted: &HeatWanted,
        speed: f64,
        longitudinal: f64,
        rows: Option<Vec<HeatedRow>>,
        theory: &'static str,
    ) -> (Option<Self>, Vec<Caution>) {
        let Some(rows) = rows else { return (None, vec![Caution::NoHeat { theory }]) };
        let Ok(pair) = HeatedPair::rolling(wanted.solids, speed, longitudinal, wanted.bulk) else {
            return (None, vec![Caution::RunsBack { longitudinal }]);
        };
        let heat = Self::new(pair, rows);
        let least = heat.peclet_upper.min(heat.peclet_lower);
        let slow = (least < Caution::PECLET).then_some(Caution::SlowHeat { peclet: least });
        let temperature = heat.contact_temperature_max_c;
        let hot = (temperature > Caution::HOT).then_some(Caution::Hot { temperature });
        let cautions = slow.into_iter().chain(hot).collect();
        (Some(heat), cautions)
    }

    fn new(pair: HeatedPair, rows: Vec<HeatedRow>) -> Self {
        let length = |row: &HeatedRow| row.heat.ends().map_or(0.0, |[from, to]| to - from);
        let longest = rows.iter().map(length).fold(0.0, f64::max);
        let friction: f64 = rows.iter().map(|row| row.width * row.heat.power()).sum();
        let conducted: f64 = rows.iter().map(|row| pair.conducted(length(row), row.width)).sum();
        let (share, touching) = (pair.share(), pair.touching());
        let ([peclet_upper, peclet_lower], [depth_upper, depth_lower]) =
            (pair.peclet(0.5 * longest), pair.depths(0.5 * longest));
        let mut heat = Self {
            contact_temperature_max_c: touching,
            place_m: None,
            flash_max_k: 0.0,
            contact_temperature_unrubbed_c: touching,
            share_upper: share,
            friction_w: friction,
            into_upper_w: share * friction + conducted,
            into_lower_w: (1.0 - share) * friction - conducted,
            peclet_upper,
            peclet_lower,
            depth_upper_m: depth_upper,
            depth_lower_m: depth_lower,
            rows,
            pair,
        };
        if let Some([flash, x, y]) = heat.hottest().filter(|[flash, ..]| *flash > 0.0) {
            heat.flash_max_k = flash;
            heat.place_m = Some([x, y]);
            heat.contact_temperature_max_c = touching + flash;
        }
        heat
    }

    /// The largest rise of all rows and its place `x`, `y`: across, of the parabola through the hottest row
    /// and those beside it.
    fn hottest(&self) -> Option<[f64; 3]> {
        let of_row = |k: usize| {
            let row = self.rows.get(k)?;
            let others = |x: f64| self.rise_by_others(k, x);
            row.heat.hottest(&self.pair, others).map(|[rise, x]| [rise, x, row.y])
        };
        let all: Vec<_> = (0..self.rows.len()).map(of_row).collect();
        let rise = |k: usize| all.get(k).copied().flatten();
        let k = (0..all.len()).filter(|k| rise(*k).is_some()).max_by(|i, j| {
            rise(*i)
                .map(|r| r[0])
                .partial_cmp(&rise(*j).map(|r| r[0]))
                .unwrap_or(std::cmp::Ordering::Equal)
        })?;
        let highest = rise(k)?;
        let beside = |k: Option<usize>| {
            let (row, [rise, _, y]) = (self.rows.get(k?)?, rise(k?)?);
            let adjoins = (y - highest[2]).abs() < 0.6 * (row.width + self.rows[k?].width) * 2.0;
            adjoins.then_some([y, rise])
        };
        let (Some(before), Some(after)) = (beside(k.checked_sub(1)), beside(Some(k + 1))) else {
            return Some(highest);
        };
        let [y, summit] = summit(before, [highest[2], highest[0]], after);
        // The middle of a symmetric contact is the middle, not a rounding away.
        let y = if y.abs() < 1e-6 * self.rows[k].width { 0.0 } else { y };
        Some([summit, highest[1], y])
    }

    /// The rise by friction in other rows that reach over the middle of row `k`: another area ahead of it.
    fn rise_by_others(&self, k: usize, x: f64) -> f64 {
        let y = self.rows[k].y;
        let others = self.rows.iter().enumerate().filter(|(i, row)| *i != k && row.reaches(y));
        others.map(|(_, row)| row.heat.integral(x) / self.pair.weight()).sum()
    }

    /// Temperatures of the upper and the lower surface at `x` (m) in row `k`, in, ahead of or behind the
    /// contact.
    #[must_use]
    pub fn temperatures(&self, k: usize, x: f64) -> [f64; 2] {
        let Some([from, to]) = self.rows.get(k).and_then(|row| row.heat.ends()) else {
            return self.pair.bulk();
        };
        let rise = self.rows[k].heat.integral(x) / self.pair.weight() + self.rise_by_others(k, x);
        self.pair.unrubbed(to - x, to - from).map(|temperature| temperature + rise)
    }

    /// The row with the largest rise.
    fn hottest_row(&self) -> Option<usize> {
        let [_, y] = self.place_m?;
        let away = |k: &usize| (self.rows[*k].y - y).abs();
        (0..self.rows.len()).min_by(|i, j| away(i).total_cmp(&away(j)))
    }

    /// The same fore and aft the other way.
    pub(crate) fn reversed(mut self) -> Self {
        self.place_m = self.place_m.map(|[x, y]| [-x, y]);
        self
    }
}

/// Place and height of the summit of a parabola through three points, the middle one the highest.
fn summit([x0, y0]: [f64; 2], [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> [f64; 2] {
    let [before, after] = [(y1 - y0) / (x1 - x0), (y2 - y1) / (x2 - x1)];
    let bend = (after - before) / (x2 - x0);
    let slope = before + bend * (x1 - x0);
    let step = -0.5 * slope / bend;
    let inside =
        bend.is_finite() && bend != 0.0 && step.is_finite() && step.abs() <= (x2 - x0).abs();
    if inside { [x1 + step, y1 + 0.5 * slope * step] } else { [x1, y1] }
}

impl SolvedCase {
    /// Adds temperatures where the case's `[heat]` asks for them, and the cautions about them.
    pub(crate) fn with_heat(mut self) -> Self {
        let (Some(wanted), Some(speed)) = (self.case.heat().copied(), self.case.speed()) else {
            return self;
        };
        let creepage = self.scaling().si_creepage(self.creepage());
        let rows = self.heated_rows(speed).filter(|rows| {
            // A theory of the whole force alone has a field without slip.
            let by_slip: f64 = rows.iter().map(|row| row.width * row.heat.power()).sum();
            by_slip >= 0.5 * speed * self.power_per_metre()
        });
        let (heat, cautions) =
            Heat::of(&wanted, speed, creepage.longitudinal, rows, self.theory.name);
        self.heat = heat;
        self.cautions.extend(cautions);
        self
    }

    /// Temperatures, where the case asks for them and the theory gives the slip.
    #[must_use]
    pub fn heat(&self) -> Option<&Heat> {
        self.heat.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use crate::{AnyCaseFile, SolvedCase};

    const BODIES: &str = "[upper]\nshear_modulus = 82e9\npoisson = 0.28\n\
        [lower]\nshear_modulus = 82e9\npoisson = 0.28\n";
    const ELLIPSE: &str = "[contact]\nnormal_force = 100e3\nfriction = 0.3\n\
        semi_axis_rolling = 5.878886e-3\nsemi_axis_lateral = 10.540448e-3\n";
    const AREAS: &str = "[gap]\npolynomial = [[2, 0, 1.015], [0, 2, 0.4215]]\n\
        [contact]\nnormal_force = 100e3\nfriction = 0.3\n";
    const HEAT: &str = "[heat]\nupper = { material = \"steel\" }\n\
        lower = { material = \"steel\", bulk_temperature = 0.0 }\n";

    fn solved(contact: &str, creepage: &str, heat: &str, theory: &str) -> SolvedCase {
        let text = format!(
            "{BODIES}{contact}[creepage]\n{creepage}\n{heat}[solve]\ntheory = \"{theory}\"\n"
        );
        AnyCaseFile::read(&text).unwrap().case(".".as_ref()).unwrap().solve(None).unwrap()
    }

    const SLIDING: &str = "longitudinal = 0.03333\nspeed = 30.0";

    /// Ertz and Knothe's sliding wheel: 152.687 K to 1e-3 by a march in closed form with the elastic slip of
    /// Hertz's traction, which exact has. fastsim's springs make another slip: some per cent.
    #[test]
    fn the_flash_of_a_sliding_wheel() {
        for (contact, theory, tolerance) in [
            (ELLIPSE, "exact", 2e-3),
            (AREAS, "exact", 2e-3),
            (ELLIPSE, "fastsim", 0.02),
            (AREAS, "fastsim", 0.03),
        ] {
            let solved = solved(contact, SLIDING, HEAT, theory);
            let heat = solved.heat().unwrap();
            assert!((heat.flash_max_k / 152.687 - 1.0).abs() < tolerance, "{theory}");
            let [x, y] = heat.place_m.unwrap();
            assert!((x / 5.878_886e-3 + 0.69).abs() < 0.03 && y.abs() < 1e-3, "{theory} {x} {y}");
            // All heat of friction is there, as the slip has it.
            let friction =
                30.0 * solved.dissipation_per_metre().unwrap_or(solved.power_per_metre());
            assert!((heat.friction_w / friction - 1.0).abs() < 0.01, "{theory}");
            let into = heat.into_upper_w + heat.into_lower_w;
            assert!((into / heat.friction_w - 1.0).abs() < 1e-12);
            assert!(solved.cautions.is_empty(), "{:?}", solved.cautions);
        }
    }

    /// Ertz's other cases: bodies of 0 and 150 degrees. Unrubbed 75 exactly; the flash on top: 227.687.
    /// Without slip the chill is 82.05 W/K (sheet A2): elements have the ellipse's area to 1 %.
    #[test]
    fn bodies_of_different_temperature() {
        let warm = HEAT.replace("bulk_temperature = 0.0", "bulk_temperature = 150.0");
        let hot = solved(ELLIPSE, SLIDING, &warm, "exact");
        let heat = hot.heat().unwrap();
        // The surfaces' speeds differ by the creepage, which the sheet leaves out: by a fourth of that in the shares.
        assert!((heat.contact_temperature_max_c - 227.687).abs() < 0.9);
        assert!((heat.contact_temperature_unrubbed_c - 75.0).abs() < 0.7);
        let rolling = solved(ELLIPSE, "longitudinal = 0.0\nspeed = 30.0", &warm, "exact");
        let heat = rolling.heat().unwrap();
        assert!((heat.contact_temperature_unrubbed_c - 75.0).abs() < 1e-12);
        assert!((heat.into_upper_w / (150.0 * 82.05) - 1.0).abs() < 0.01, "{}", heat.into_upper_w);
        assert!((heat.into_upper_w + heat.into_lower_w).abs() < 1e-6 * heat.into_upper_w);
        assert_eq!(heat.place_m, None);
    }

    #[test]
    fn cautions_say_what_temperatures_are_worth() {
        let caution = |creepage: &str, theory: &str| {
            let solved = solved(ELLIPSE, creepage, HEAT, theory);
            let cautions = solved.cautions.iter().map(ToString::to_string).collect::<Vec<_>>();
            (solved.heat().is_some(), cautions.join(" "))
        };
        let (has_heat, words) = caution("longitudinal = 0.03\nspeed = 0.01", "fastsim");
        assert!(has_heat && words.contains("Peclet number is 2.0"), "{words}");
        let (has_heat, words) = caution(SLIDING, "polach");
        assert!(!has_heat && words.contains("polach has no slip"), "{words}");
        let (has_heat, words) = caution("longitudinal = 2.5\nspeed = 30.0", "fastsim");
        assert!(!has_heat && words.contains("runs back"), "{words}");
    }

    #[test]
    fn what_is_missing_or_wrong_is_named() {
        let error = |creepage: &str, heat: &str| {
            let text = format!("{BODIES}{ELLIPSE}[creepage]\n{creepage}\n{heat}");
            AnyCaseFile::read(&text)
                .and_then(|file| file.case(".".as_ref()))
                .unwrap_err()
                .to_string()
        };
        assert!(error("longitudinal = 1e-3", HEAT).contains("speed, which [heat] needs"));
        let without = "[heat]\nupper = { conductivity = 50.0 }\nlower = { material = \"steel\" }\n";
        assert!(error(SLIDING, without).contains("upper: density is missing"));
        let twice = HEAT.replace("material = \"steel\" }", "material = \"steel\", density = 1.0 }");
        assert!(error(SLIDING, &twice).contains("exclude each other"));
        for cold in ["inf", "-273.16"] {
            assert!(error(SLIDING, &HEAT.replace("0.0", cold)).contains("not below -273.15"));
        }
        let law = ELLIPSE.replace("0.3", "{ cold = 0.3, hot = 0.1, temperatures = [100, 200] }");
        let text = format!("{BODIES}{law}[creepage]\n{SLIDING}\n");
        let error = AnyCaseFile::read(&text).unwrap().case(".".as_ref()).unwrap_err().to_string();
        assert!(error.contains("needs [heat]"), "{error}");
    }

    /// 200 random contacts: temperatures are finite, none below the colder or unheated body, and the heat balances.
    #[test]
    fn any_contact_has_finite_temperatures_that_balance() {
        let mut seed = 7_u64;
        let mut random = |low: f64, high: f64| {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..200 {
            let contact = format!(
                "[contact]\nnormal_force = {}\nfriction = {}\nsemi_axis_rolling = {}\nsemi_axis_lateral = {}\n",
                random(1e3, 1e5),
                random(0.01, 1.0),
                random(1e-3, 1e-2),
                random(1e-3, 1e-2)
            );
            let creepage = format!(
                "longitudinal = {}\nlateral = {}\nspin = {}\nspeed = {}",
                random(-0.1, 0.1),
                random(-0.1, 0.1),
                random(-10.0, 10.0),
                random(0.01, 100.0)
            );
            let heat = HEAT.replace("= 0.0", &format!("= {}", random(-50.0, 500.0)));
            let solved = solved(&contact, &creepage, &heat, "fastsim");
            let heat = solved.heat().unwrap();
            let bulk = heat.pair.bulk();
            let coldest = bulk[0].min(bulk[1]);
            assert!(
                heat.contact_temperature_max_c >= coldest - 1e-9 && heat.flash_max_k.is_finite()
            );
            assert!(heat.records().flatten().all(f64::is_finite));
            let left = heat.into_upper_w + heat.into_lower_w - heat.friction_w;
            assert!(left.abs() < 1e-9 * (heat.into_upper_w.abs() + heat.friction_w), "{left}");
        }
    }
}
