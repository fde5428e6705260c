//! The header is what cbindgen makes of the crate as it is.

use std::fs;
use std::path::Path;

/// `CREEPAGE_WRITE_HEADER=1 cargo test -p creepage-ffi --test ffi header` writes it anew.
#[test]
fn the_header_is_fresh() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(here.join("cbindgen.toml")).unwrap();
    let made = cbindgen::Builder::new().with_crate(here).with_config(config).generate().unwrap();
    let mut text = Vec::new();
    made.write(&mut text);
    // What Rust calls so is a promise of the caller.
    let text = String::from_utf8(text).unwrap().replace(" # Safety\n", " You promise:\n");
    let path = here.join("include/creepage.h");
    if std::env::var_os("CREEPAGE_WRITE_HEADER").is_some() {
        fs::write(&path, &text).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap_or_default();
    assert!(kept == text, "include/creepage.h is stale: see the test for how to write it anew");
}

/// MATLAB's `loadlibrary` follows pointers, numbers and opaque structures; no more is used.
#[test]
fn the_header_is_plain() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/creepage.h");
    let text = fs::read_to_string(path).unwrap();
    // What follows the end of a comment, up to the next.
    let code = |part: &str| part.split("*/").nth(1).unwrap_or_default().to_owned();
    let code: String = text.split("/*").map(code).collect();
    assert!(code.contains("creepage_theory_new(") && !code.contains("axis"), "{code}");
    for fancy in ["bool", "enum", "union", "uintptr_t", "[", "(*"] {
        assert!(!code.contains(fancy), "{fancy}");
    }
}
