//! HTML gallery: one page that needs nothing beside it, light or dark as the reader has it.

use std::fmt::Write;

use super::agreement::{SKETCHES, difference, summary};
use crate::comparison::Comparison;
use crate::item::Made;
use crate::rows::{rows, states};

const STYLE: &str = include_str!("gallery.css");
const TITLE: &str = "Kalker 1967, computed again";

/// The page.
pub(super) fn html(made: &[Made]) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{TITLE}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n\
         <h1>{TITLE}</h1>\n<p>The tables and figures of J. J. Kalker's thesis <cite>On the \
         rolling contact of two elastic bodies in the presence of dry friction</cite> (Delft, \
         1967), each beside what was printed, and beside the full theory of today.</p>\n\
         <p>{}</p>\n<nav>\n",
        summary(made)
    );
    for made in made {
        // Writing to a String cannot fail.
        let _ = writeln!(page, "<a href=\"#{0}\">{0}</a>", made.item.name);
    }
    page.push_str("</nav>\n</header>\n<main>\n");
    all_rows(&mut page);
    for made in made {
        section(&mut page, made);
    }
    // Writing to a String cannot fail.
    let _ = write!(
        page,
        "</main>\n<footer>Made by <code>creepage reproduce</code>. Agrees: ours, rounded as the \
         print is, is the print, or what is claimed holds. Close: within a tolerance that the \
         note gives a reason for. Misprint: the print is wrong, for a reason found elsewhere. Not \
         reproduced: the note says why. No data: the experiment's numbers are not in the text. \
         {SKETCHES}</footer>\n</body>\n</html>\n"
    );
    page
}

/// What a reader wants to do with the thesis, row by row.
fn all_rows(page: &mut String) {
    let [works, answered] = states();
    // Writing to a String cannot fail.
    let _ = writeln!(
        page,
        "<section id=\"rows\">\n<h2>The thesis, row by row</h2>\n<p class=\"caption\">{} things that a \
         reader wants to do with it, in its order: {works} work; {answered} have an answer in place of what cannot be had.</p>\n\
         <details><summary>all of them</summary><div class=\"wide\"><table>\n\
         <tr><th><th>what<th>where<th>how<th>test<th>state</tr>",
        works + answered
    );
    for row in rows() {
        let cells = row.map(|cell| format!("<td>{}", coded(&escape(cell))));
        let _ = writeln!(page, "<tr>{}</tr>", cells.concat());
    }
    page.push_str("</table></div></details>\n</section>\n");
}

/// Words between back quotes as code.
fn coded(words: &str) -> String {
    let parts = words.split('`').enumerate();
    let part = |(k, part): (usize, &str)| {
        if k % 2 == 1 { format!("<code>{part}</code>") } else { part.to_owned() }
    };
    parts.map(part).collect()
}

fn section(page: &mut String, made: &Made) {
    let (item, reproduction) = (made.item, &made.reproduction);
    let _ = writeln!(page, "<section id=\"{}\">\n<h2>{}</h2>", item.name, escape(item.title));
    if let Some(svg) = &reproduction.svg {
        let _ = writeln!(page, "<div class=\"picture\">\n{}</div>", inlined(svg, item.name));
    }
    let _ = writeln!(page, "<p class=\"caption\">{}</p>", escape(&reproduction.caption));
    if let Some(text) = &reproduction.text {
        let _ = writeln!(
            page,
            "<details{}><summary>in words</summary><pre>{}</pre></details>",
            if reproduction.svg.is_none() { " open" } else { "" },
            escape(text)
        );
    }
    if !reproduction.agreement.is_empty() {
        table(page, &reproduction.agreement);
    }
    page.push_str("</section>\n");
}

fn table(page: &mut String, lines: &[Comparison]) {
    page.push_str(
        "<div class=\"wide\"><table>\n<tr><th>quantity<th>printed<th>ours<th>difference\
         <th>verdict<th>note</tr>\n",
    );
    for line in lines {
        let words = line.verdict.words();
        let _ = writeln!(
            page,
            "<tr><td>{}<td data-head=\"printed: \">{}<td data-head=\"ours: \">{}\
             <td class=\"number\" data-head=\"difference: \">{}\
             <td class=\"verdict {}\">{words}<td>{}</tr>",
            escape(&line.quantity),
            escape(&line.printed),
            escape(&line.ours),
            difference(line).replace('-', "\u{2212}"),
            words.replace(' ', "-"),
            escape(&line.note)
        );
    }
    page.push_str("</table></div>\n");
}

/// An SVG as part of a page: its name space is then known, and its hatching needs a name of its own.
fn inlined(svg: &str, name: &str) -> String {
    svg.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", " role=\"img\"", 1)
        .replace("id=\"hatching\"", &format!("id=\"hatching-{name}\""))
        .replace("url(#hatching)", &format!("url(#hatching-{name})"))
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
