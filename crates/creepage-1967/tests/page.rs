//! The page of Fig. 12. Its numbers are compared with the print in `gallery.rs`.
#![allow(clippy::unwrap_used)]

use creepage::variational::{Chain, Procedure, Settings, Variational};
use creepage::{Contact, Creepage, Ellipse};
use creepage_1967::{Page, PageStyle};

/// The page after the chain of creepages 2.5, 2.0, 1.7.
fn figure_12(style: PageStyle) -> String {
    let contact = Contact::new(Ellipse::from_ratio(0.5).unwrap(), 0.28).unwrap();
    let theory = Variational::new(&contact, Settings::default()).unwrap();
    let mut chain = Chain::new(&theory, Procedure::OF_1967);
    let (sin, cos) = (-30.0_f64).to_radians().sin_cos();
    let mut text = String::new();
    for size in [2.5, 2.0, 1.7] {
        let creepage = Creepage::new(size * cos, size * sin, 2.0).unwrap();
        let mut steps = Vec::new();
        let found = chain.solve(creepage, Some(&mut steps)).found;
        let page = Page {
            theory: &theory,
            loops: [2.0, size, -30.0],
            creepage,
            steps: &steps,
            found: &found,
            mesh: [10, 10],
            lines: &[-0.5, 0.5],
        };
        text = page.text(style);
    }
    text
}

#[test]
fn the_lines_come_in_the_order_of_the_print() {
    let text = figure_12(PageStyle::Of1967);
    let words = [
        "SPIN,",
        "UPSX,",
        "TOEG",
        "TOEG",
        "TOEG",
        "TOEG",
        "CONVER",
        "FX FY",
        "TAU",
        "UVX",
        "AFWIJKINGEN:",
        "T,S,Y,X",
        "G,H,A,OPP:",
        "CONTACTVLAK:",
        "T,S,INT",
        "Y:",
        "Y:",
    ];
    let headed: Vec<_> =
        text.lines().filter(|line| line.starts_with(char::is_alphabetic)).collect();
    assert_eq!(headed.len(), words.len());
    assert!(headed.iter().zip(words).all(|(line, word)| line.starts_with(word)), "{headed:?}");
    // The picture: ten lines, 22 of its 80 points adhere, one of them an aberration.
    let picture: Vec<&str> = text
        .lines()
        .skip_while(|line| !line.starts_with("CONTACTVLAK:"))
        .skip(1)
        .take(10)
        .collect();
    let count =
        |symbol| picture.iter().flat_map(|line| line.chars()).filter(|c| *c == symbol).count();
    assert_eq!([count('.'), count('H'), count('A')], [58, 21, 1]);
}

#[test]
fn the_english_page_has_the_same_lines() {
    let [dutch, english] = [PageStyle::Of1967, PageStyle::English].map(figure_12);
    assert_eq!(dutch.lines().count(), english.lines().count());
    assert!(english.contains("\nconverged\n"));
    assert!(english.contains("fx, fy, mz:    0.6249   -0.1220    0.3437\n"));
}
