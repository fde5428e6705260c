//! Numbers and case files as text.

use std::fmt::Write as _;

/// A number, to twelve digits: what a change of units adds behind them is rounding.
pub(crate) fn number(value: f64) -> String {
    let rounded = format!("{value:.11e}").parse().unwrap_or(value);
    format!("{:?}", if rounded == 0.0 { 0.0 } else { rounded })
}

/// A list of numbers.
pub(crate) fn list(values: impl IntoIterator<Item = f64>) -> String {
    let values: Vec<_> = values.into_iter().map(number).collect();
    format!("[{}]", values.join(", "))
}

/// A text in quotes.
pub(crate) fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// A section of a case file: nothing where it has no keys.
pub(crate) fn section(name: &str, keys: &[(&str, String)]) -> String {
    if keys.is_empty() {
        return String::new();
    }
    let lines: Vec<_> = keys.iter().map(|(key, value)| format!("{key} = {value}")).collect();
    format!("\n[{name}]\n{}\n", lines.join("\n"))
}

/// `[heat]` of bodies whose temperature, specific heat (J/(kg K)), conductivity (W/(mm K)) and density (kg/mm3)
/// are given, the upper one first.
pub(crate) fn heat_section([upper, lower]: [[f64; 4]; 2]) -> String {
    let body = |[bulk, specific_heat, conductivity, density]: [f64; 4]| {
        format!(
            "{{ conductivity = {}, density = {}, specific_heat = {}, bulk_temperature = {} }}",
            number(conductivity * 1e3),
            number(density * 1e9),
            number(specific_heat),
            number(bulk)
        )
    };
    section("heat", &[("upper", body(upper)), ("lower", body(lower))])
}

/// Comments, a line each.
pub(crate) fn comments(lines: &[String]) -> String {
    let lines: Vec<_> = lines.iter().map(|line| line.replace(['\n', '\r'], " ")).collect();
    format!("# {}\n", lines.join("\n# "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_no_rounding_at_their_end() {
        assert_eq!(number(0.1 + 0.2), "0.3");
        assert_eq!(number(-0.0), "0.0");
        assert_eq!(number(82000.0 * 1e6), "82000000000.0");
    }
}
