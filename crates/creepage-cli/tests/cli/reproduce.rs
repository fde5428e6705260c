//! `creepage reproduce`.

use crate::place::Place;

#[test]
fn table_1_is_right_in_all_its_entries() {
    let text = Place::new().run(&["reproduce", "table1"]).done();
    assert!(text.contains("table1: 22 of 22 printed entries are right.\n"), "{text}");
    assert!(!text.contains("wrong by") && !text.contains("Table 2"));
}

#[test]
fn the_wrong_entries_of_table_2_are_marked_and_listed() {
    let text = Place::new().run(&["reproduce", "table2"]).done();
    assert!(text.contains("table2: 25 of 40 printed entries are right"), "{text}");
    let row = text.lines().find(|line| line.starts_with("  |e| ")).unwrap_or_default();
    let cells: Vec<_> = row.split_whitespace().collect();
    let printed =
        ["0.00", "0.61", "0.73*", "0.83*", "0.93", "0.96", "0.98", "0.99", "0.999", "1.00"];
    assert_eq!(cells[1..], printed);
    assert_eq!(text.matches("wrong by").count(), 15);
}

#[test]
fn each_item_is_made_once_with_its_files() {
    let place = Place::new();
    let text = place.run(&["reproduce", "table2", "fig3", "table2", "--out", "out"]).done();
    assert_eq!(text.matches("table2: 25 of 40").count(), 1);
    assert_eq!(place.read("out/table2.csv").lines().count(), 41);
    let table = place.read("out/table2.csv");
    assert!(table.starts_with("quantity,tau_deg,printed,ours,verdict\n"), "{table}");
    assert!(table.contains("\nK,20,3.71,3.620,wrong by +9 in the last digit\n"), "{table}");
    assert!(place.read("out/fig3.svg").starts_with("<svg"));
    assert!(text.contains("Fig. 3. Force by Carter's theory\n"), "{text}");
    // The page is for all of them.
    let files = ["fig3.csv", "fig3.png", "fig3.svg", "table2.csv", "table2.txt"];
    assert_eq!(place.files_in("out"), files);
}

#[test]
fn what_cannot_be_reproduced_is_refused() {
    let place = Place::new();
    for arguments in [&["reproduce"][..], &["reproduce", "table9"]] {
        let ran = place.run(arguments);
        assert_eq!((ran.code, &ran.stdout[..]), (Some(2), ""));
    }
    place.write("file", "in the way");
    place.run(&["reproduce", "table1", "--out", "file"]).refused(&["cannot write file"]);
    assert_eq!(place.files(), ["file"]);
}

/// A historian lays the points that he has read off the printed picture over ours.
#[test]
fn points_of_ones_own_lie_over_a_picture() {
    let place = Place::new();
    place.write("read.csv", "x,y\n0.5,0.21\n1.5,0.44\n80,0.2\n");
    let plain = place.run(&["reproduce", "fig3", "--out", "plain"]);
    plain.done();
    let ran = place.run(&["reproduce", "fig3", "--out", "own", "--points", "read.csv"]);
    ran.done();
    let [plain, own] = ["plain", "own"].map(|out| place.read(&format!("{out}/fig3.svg")));
    assert!(own.contains("your points") && !plain.contains("your points"));
    for (words, table) in [
        ("column y is missing", "x\n0.5\n"),
        ("row 2, column y: `much` is no number", "x,y\n0.5,0.1\n1,much\n"),
        ("row 1: the picture has no panel 9", "x,y,panel\n0.5,0.1,9\n"),
        ("unknown column `z`", "x,y,z\n1,1,1\n"),
        ("no rows", "x,y\n"),
    ] {
        place.write("bad.csv", table);
        let arguments = ["reproduce", "fig3", "--out", "own", "--points", "bad.csv"];
        place.run(&arguments).refused(&["bad.csv", words]);
    }
    let two = ["reproduce", "fig3", "fig4", "--out", "own", "--points", "read.csv"];
    place.run(&two).refused(&["--points goes with one picture"]);
    let table = ["reproduce", "table1", "--out", "own", "--points", "read.csv"];
    place.run(&table).refused(&["table1 is a table"]);
}
