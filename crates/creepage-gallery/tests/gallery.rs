//! Every item is made once; its verdicts and its files are examined.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::sync::OnceLock;

use creepage_gallery::{Made, Verdict, files, gallery, registry, reproduce};
use resvg::usvg::{self, Rect};

fn made() -> &'static [Made] {
    static MADE: OnceLock<Vec<Made>> = OnceLock::new();
    MADE.get_or_init(|| reproduce(&registry().iter().collect::<Vec<_>>(), |_| ()).unwrap())
}

/// Lines that agree, are close, are misprints of 1967, and are not reproduced.
const VERDICTS: &[(&str, [usize; 4])] = &[
    ("table1", [1, 0, 0, 0]),
    ("table2", [0, 0, 16, 0]),
    // The misprints are six; that degree 5 is within 1 % of degree 7 holds for a few a/b only.
    ("table3", [1, 2, 7, 1]),
    ("table4", [0, 4, 0, 0]),
    ("table5", [2, 6, 0, 2]),
    ("fig2", [3, 0, 0, 0]),
    ("fig3", [4, 0, 0, 0]),
    ("fig4", [3, 0, 0, 0]),
    ("fig5", [3, 0, 0, 0]),
    ("fig3a", [4, 2, 0, 0]),
    ("fig3b", [1, 1, 0, 0]),
    ("fig10", [2, 0, 0, 0]),
    ("fig11", [2, 0, 0, 0]),
    // 223 of 228 numbers, and five slips of the print.
    ("fig12", [0, 0, 6, 0]),
    ("fig13", [1, 0, 0, 0]),
    // Johnson's points are not in the text.
    ("fig14", [2, 0, 0, 1]),
    ("fig15", [0, 0, 0, 1]),
    ("angles", [1, 1, 2, 2]),
];

#[test]
fn verdicts_are_as_known() {
    let kinds = [Verdict::Agrees, Verdict::Close, Verdict::Misprint, Verdict::NotReproduced];
    for made in made() {
        let lines = &made.reproduction.agreement;
        let counts = kinds.map(|kind| lines.iter().filter(|line| line.verdict == kind).count());
        let known = VERDICTS.iter().find(|(name, _)| *name == made.item.name);
        assert_eq!(Some(counts), known.map(|known| known.1), "{}: {lines:#?}", made.item.name);
        for line in lines.iter().filter(|line| line.verdict != Verdict::Agrees) {
            assert!(!line.note.is_empty(), "{} says nothing: {line:?}", made.item.name);
        }
    }
    assert_eq!(made().len(), VERDICTS.len());
}

#[test]
fn every_item_has_numbers_and_words() {
    for made in made() {
        let (name, reproduction) = (made.item.name, &made.reproduction);
        assert!(reproduction.svg.is_some() || reproduction.text.is_some(), "{name}");
        assert!(reproduction.caption.len() > 40, "{name}");
        assert!(reproduction.data.rows().len() > 3 && reproduction.data.csv().is_ok(), "{name}");
        assert!(!reproduction.agreement.is_empty(), "{name}");
        for cell in reproduction.data.rows().iter().flatten() {
            assert!(cell != "NaN" && cell != "-inf", "{name}");
            // Table 2 has the limit of K.
            assert!(cell != "inf" || name == "table2", "{name}");
        }
    }
}

#[test]
fn a_second_run_is_the_same_byte_for_byte() {
    // A quick one of each kind; the others are made the same way.
    let quick: Vec<_> = registry().iter().filter(|item| QUICK.contains(&item.name)).collect();
    let run = || files(&reproduce(&quick, |_| ()).unwrap()).unwrap();
    let (one, two) = (run(), run());
    assert!(one == two && one.len() > 3);
    // Made among all others, by as many threads as there are, it is the same as well.
    let all = files(made()).unwrap();
    for file in &one {
        assert!(all.contains(file), "{}", file.name);
    }
}

/// Made in less than a second.
const QUICK: &[&str] = &["table2", "table4", "fig3", "fig10", "fig12"];

#[test]
fn the_page_needs_nothing_beside_it() {
    let (files, gallery) = (files(made()).unwrap(), gallery(made()).unwrap());
    let page = &gallery.iter().find(|file| file.name == "index.html").unwrap().contents;
    let page = std::str::from_utf8(page).unwrap();
    for outside in ["http:", "https:", "src=", "@import", "url(//", "<link", "<script"] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(page.contains("prefers-color-scheme"));
    for made in made() {
        let name = made.item.name;
        assert!(page.contains(&format!("<section id=\"{name}\">")));
        assert!(page.contains(&format!("href=\"#{name}\"")));
        for ending in [Some("csv"), made.reproduction.svg.as_ref().map(|_| "png")] {
            let Some(ending) = ending else { continue };
            assert!(files.iter().any(|file| file.name == format!("{name}.{ending}")));
        }
    }
}

/// Nothing leaves the sheet, and no two texts touch.
#[test]
fn pictures_are_whole_and_legible() {
    for made in made() {
        let Some(svg) = &made.reproduction.svg else { continue };
        let (name, tree) = (made.item.name, creepage_report::picture(svg).unwrap());
        let (mut texts, mut shapes) = (Vec::new(), Vec::new());
        boxes(tree.root(), &mut texts, &mut shapes);
        let size = tree.size();
        for b in texts.iter().chain(&shapes) {
            assert!(b.left() >= 0.0 && b.right() <= size.width(), "{name}: {b:?}");
            assert!(b.top() >= 0.0 && b.bottom() <= size.height(), "{name}: {b:?}");
        }
        for (k, b) in texts.iter().enumerate() {
            let touching = texts[k + 1..].iter().find(|c| touch(b, c));
            assert!(touching.is_none(), "{name}: {b:?} {touching:?}");
        }
    }
}

fn touch(b: &Rect, c: &Rect) -> bool {
    // Ascenders and descenders may share a pixel row.
    b.left() < c.right()
        && c.left() < b.right()
        && b.top() + 2.0 < c.bottom()
        && c.top() + 2.0 < b.bottom()
}

fn boxes(group: &usvg::Group, texts: &mut Vec<Rect>, shapes: &mut Vec<Rect>) {
    for node in group.children() {
        match node {
            usvg::Node::Group(group) => boxes(group, texts, shapes),
            usvg::Node::Text(text) => texts.push(text.abs_bounding_box()),
            other => shapes.push(other.abs_stroke_bounding_box()),
        }
    }
}
