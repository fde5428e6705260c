//! Plain-language messages of the TOML reader, for people who do not know its types.

/// Its types, the longer names first, and what they are.
const TYPES: [(&str, &str); 9] = [
    ("usize", "a whole number that is not negative"),
    ("u64", "a whole number that is not negative"),
    ("u32", "a whole number that is not negative"),
    ("i64", "a whole number"),
    ("i32", "a whole number"),
    ("f64", "a number"),
    ("f32", "a number"),
    ("a boolean", "true or false"),
    ("a string", "a word"),
];

/// A message of the reader of TOML in plain words.
#[must_use]
pub fn plain_words(message: &str) -> String {
    let mut words = message.to_owned();
    for (name, plain) in TYPES {
        words = words.replace(&format!("expected {name}"), &format!("expected {plain}"));
    }
    words.replace("floating point `", "number `").replace("integer `", "number `")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_of_the_program_become_kinds_of_numbers() {
        let message = "invalid type: floating point `7.5`, expected usize";
        let plain = "invalid type: number `7.5`, expected a whole number that is not negative";
        assert_eq!(plain_words(message), plain);
    }
}
