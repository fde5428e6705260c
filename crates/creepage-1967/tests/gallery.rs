//! Every item is made once; its verdicts and its files are examined.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::Path;
use std::sync::OnceLock;
use std::{env, fs};

use creepage_1967::{Made, Verdict, files, gallery, registry, reproduce};
use creepage_plot::Boxes;

fn made() -> &'static [Made] {
    static MADE: OnceLock<Vec<Made>> = OnceLock::new();
    MADE.get_or_init(|| {
        let made = reproduce(&registry().iter().collect::<Vec<_>>(), |_| ()).unwrap();
        if let Some(directory) = env::var_os("CREEPAGE_GALLERY") {
            keep(&made, Path::new(&directory));
        }
        made
    })
}

/// For the guide, which then need not make it again.
fn keep(made: &[Made], directory: &Path) {
    fs::create_dir_all(directory).unwrap();
    for file in files(made).unwrap().into_iter().chain(gallery(made).unwrap()) {
        fs::write(directory.join(file.name), file.contents).unwrap();
    }
}

/// Lines that agree, are close, are misprints of 1967, are not reproduced, have no data.
const VERDICTS: &[(&str, [usize; 5])] = &[
    ("table1", [1, 0, 0, 0, 0]),
    ("table2", [0, 0, 16, 0, 0]),
    // The misprints are six; that degree 5 is within 1 % of degree 7 holds for a few a/b only.
    ("table3", [7, 2, 7, 1, 0]),
    ("table4", [0, 4, 0, 0, 0]),
    ("table5", [3, 7, 0, 0, 0]),
    ("fig2", [3, 0, 0, 0, 0]),
    ("fig3", [4, 0, 0, 0, 0]),
    ("fig4", [3, 0, 0, 0, 0]),
    ("fig5", [3, 0, 0, 0, 0]),
    ("fig3a", [4, 2, 0, 0, 0]),
    ("fig3b", [1, 1, 0, 0, 0]),
    ("fig7", [1, 0, 4, 0, 0]),
    ("edge-energy", [1, 0, 0, 0, 0]),
    ("fig9", [2, 0, 0, 0, 0]),
    ("fig10", [2, 0, 0, 0, 0]),
    ("fig11", [2, 0, 0, 0, 0]),
    // 223 of 228 numbers, and five slips of the print.
    ("fig12", [0, 0, 6, 0, 0]),
    ("fig13", [1, 0, 0, 0, 0]),
    // Johnson's points are not in the text.
    ("fig14", [2, 0, 0, 0, 1]),
    ("fig15", [0, 0, 0, 1, 0]),
    // 56.7 is probably 57.6 with two digits exchanged.
    ("angles", [1, 2, 2, 1, 0]),
    ("fig16", [3, 0, 0, 0, 0]),
    ("fig17", [3, 0, 0, 0, 0]),
    ("fig18", [4, 0, 0, 0, 0]),
    ("fig19", [8, 0, 0, 0, 0]),
    // One small part of the print's two doubtful ones, of aberrations only.
    ("fig20", [5, 0, 0, 1, 0]),
    // At χ = 1.24 the point without traction is still about to enter.
    ("fig21", [2, 0, 0, 1, 0]),
    ("fig22", [2, 2, 0, 0, 0]),
    // "About half" is 0.63 by the thesis's own method.
    ("fig23", [4, 0, 0, 1, 0]),
    ("wide", [2, 0, 0, 0, 0]),
    ("tubes", [2, 0, 0, 1, 0]),
    ("tubes-3d", [4, 0, 0, 0, 0]),
    ("fig24a", [2, 0, 0, 0, 0]),
    ("fig24b", [3, 0, 0, 0, 0]),
    ("fig24c", [3, 0, 0, 0, 0]),
    ("claims", [8, 3, 0, 0, 0]),
    // (5.9) alone, without the bound, does not roll from rest.
    ("unsteady-chapter-5", [2, 0, 0, 1, 0]),
    ("i-histories", [4, 0, 0, 0, 0]),
    ("ii-negative-order", [2, 0, 0, 0, 0]),
    ("sliding-with-kappa", [3, 0, 0, 0, 0]),
    // Beyond the thesis: pictures without a line of it.
    ("free-rolling", [0; 5]),
    ("iv-1-border", [1, 0, 0, 0, 0]),
    ("iv-2-split", [2, 0, 0, 0, 0]),
    ("iv-3-transients", [5, 0, 0, 0, 0]),
    ("v-pure-spin", [2, 0, 0, 0, 0]),
    ("chapter-5", [0; 5]),
    ("islands", [4, 0, 0, 0, 0]),
    ("convergence", [0; 5]),
];

#[test]
fn verdicts_are_as_known() {
    let kinds = [
        Verdict::Agrees,
        Verdict::Close,
        Verdict::Misprint,
        Verdict::NotReproduced,
        Verdict::NoData,
    ];
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
        let beyond_the_thesis = ["chapter-5", "convergence", "free-rolling"].contains(&name);
        assert_eq!(reproduction.agreement.is_empty(), beyond_the_thesis, "{name}");
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
    let mut ids: Vec<_> =
        page.split(" id=\"").skip(1).filter_map(|id| id.split('"').next()).collect();
    ids.sort_unstable();
    assert!(ids.windows(2).all(|pair| pair[0] != pair[1]), "{ids:?}");
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
        let boxes = Boxes::of(svg).unwrap();
        assert_eq!((boxes.off_the_sheet(), boxes.touching()), (None, None), "{}", made.item.name);
    }
}

/// The rows of an item's table whose first cell starts so, as numbers from the second cell on.
fn numbers(item: &str, curve: &str) -> Vec<Vec<f64>> {
    let made = made().iter().find(|made| made.item.name == item).unwrap();
    let rows = made.reproduction.data.rows().iter().filter(|row| row[0].starts_with(curve));
    let rows = rows.map(|row| row[1..].iter().map(|cell| cell.parse().unwrap()).collect());
    let rows: Vec<_> = rows.collect();
    assert!(!rows.is_empty(), "{item}, {curve}");
    rows
}

/// Peaks of Fig. 23 computed by an independent program for the thesis's settings.
#[test]
fn the_peaks_of_pure_spin_are_those_of_an_independent_program() {
    let peaks = [("2", 1.2, 0.7436), ("1", 2.5, 0.605), ("0.5", 3.0, 0.412), ("0.2", 1.25, 0.178)];
    for (ratio, chi, fy) in peaks {
        let curve = numbers("fig23", &format!("a/b = {ratio}, M = 3"));
        let peak = curve.iter().max_by(|p, q| p[1].total_cmp(&q[1])).unwrap();
        // Points are up to 0.12 apart, near which the curve is flat.
        assert!((peak[0] - chi).abs() < 0.13 && (peak[1] - fy).abs() < 2e-3, "{ratio}: {peak:?}");
    }
}

/// The same program's ring of Fig. 24a: force at creepage 0.9 without spin.
#[test]
fn a_ring_of_fig_24a_is_that_of_an_independent_program() {
    let ring = numbers("fig24a", "upsilon = 0.9, M = 3");
    let (first, last) = (&ring[0], ring.last().unwrap());
    // Printed there with four digits, for 316 mesh points instead of 80: within 0.009.
    assert!((first[2] - 0.7397).abs() < 0.009 && first[3].abs() < 1e-6, "{first:?}");
    assert!((last[3] - 0.6884).abs() < 0.009 && last[2].abs() < 1e-6, "{last:?}");
}

#[test]
fn the_full_theory_converges_within_its_error_bars() {
    for case in ["longitudinal", "that of Fig. 12", "pure spin", "spin pole inside"] {
        let of = |what: &str| numbers("convergence", &format!("{case}, {what}"));
        let (one, both, bars) = (of("one grid"), of("extrapolated"), of("error bar"));
        for (error, bar) in both.iter().zip(&bars) {
            assert!(error[1] <= bar[1], "{case}: {error:?} {bar:?}");
        }
        let (coarse, fine) = (&one[0], one.last().unwrap());
        let order = (coarse[1] / fine[1]).ln() / (coarse[0] / fine[0]).ln();
        // 2 by design, 1 where the traction turns round within an element.
        assert!(order > 0.9, "{case}: {order}");
        assert!(both.last().unwrap()[1] < 5e-4 + both[0][1] / 4.0, "{case}");
    }
}

/// Measured over 896 cases: what the README says of chapter 5 over another set is of this size.
#[test]
fn chapter_5_errs_by_so_much() {
    let cases = numbers("chapter-5", "");
    let rms = |column: usize| {
        let squares = cases.iter().map(|case| case[column] * case[column]).sum::<f64>();
        (squares / cases.len() as f64).sqrt()
    };
    assert_eq!(cases.len(), 896);
    assert!((0.05..0.065).contains(&rms(3)) && (0.017..0.023).contains(&rms(4)));
}

/// An island that strips of twice the width see as well; it is two strips wide at most, 0.104 with
/// the wider ones.
#[test]
fn the_island_of_adhesion_is_there() {
    let islands = numbers("islands", "length and width of the island");
    assert_eq!(islands.len(), 6);
    for island in islands {
        let (length, width) = (island[1], island[2]);
        assert!((0.03..0.3).contains(&length) && (0.03..0.11).contains(&width), "{island:?}");
    }
}
