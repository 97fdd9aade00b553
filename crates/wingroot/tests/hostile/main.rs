//! The hostile list: bad inputs as users give them, each answered by one sentence that says where, with exit status 2 or 3,
//! in little time and memory, and nothing written.
//!
//! A row is a command and one change of a small example. Rows are written by hand (the tables `texts.txt`, `files.txt` and
//! `options.txt`, read by [`lists`]) or come from families over every number and key of a file ([`families`]). [`bench`] runs
//! them.

mod bench;
mod families;
mod lists;
mod row;

use bench::run;
use row::Row;

#[test]
fn every_bad_input_gets_one_good_sentence() {
    let rows: Vec<Row> = lists::rows().into_iter().chain(families::rows()).collect();
    assert!(rows.len() >= 300, "the list has shrunk to {} rows", rows.len());
    let mut names: Vec<String> = rows.iter().map(Row::to_string).collect();
    names.sort();
    let twin = names.windows(2).find(|pair| pair[0] == pair[1]);
    assert_eq!(twin, None, "a row stands twice");
    let bad = run(&rows);
    assert!(bad.is_empty(), "{} of {} rows:\n{}", bad.len(), rows.len(), bad.join("\n"));
}
