//! Null campaigns of `discover` in parts, put together: the thresholds of one process, to the last digit.

use crate::own_wing::OwnWing;
use crate::result_files::files;

#[test]
fn null_campaigns_in_parts_give_the_null_distribution_of_one_process() {
    if !crate::slow::runs("makes two null distributions") {
        return;
    }
    let own = OwnWing::new("discover-parts");
    own.finishes(&["prepare", "discover", "--out", "parts"]);
    own.finishes(&["discover", "--out", "parts", "--part", "3/3"]);
    let early = own.run(&["merge", "discover", "--out", "parts"]);
    let said = String::from_utf8_lossy(&early.stderr);
    assert!(
        early.status.code() == Some(2) && said.contains("discover --out parts --quiet --part 1/3"),
        "{said}"
    );
    let of_two = own
        .command(&["discover", "--out", "parts"])
        .envs([("JOB_COMPLETION_INDEX", "0"), ("WINGROOT_PARTS", "2")])
        .output()
        .expect("it starts");
    assert!(of_two.status.success(), "{}", String::from_utf8_lossy(&of_two.stderr));
    own.finishes(&["discover", "--out", "parts", "--part", "2/2"]);
    let status = own.run(&["status", "discover", "--out", "parts", "--json"]);
    let status: serde_json::Value = serde_json::from_slice(&status.stdout).expect("JSON");
    assert!(status["cases"] == 20 && status["finished"] == 20, "{status}");
    own.finishes(&["merge", "discover", "--out", "parts"]);
    // an array of the user's own, a campaign a task, does not tell how many parts there are
    let alone = own.command(&["discover", "--out", "whole"]).env("SLURM_ARRAY_TASK_ID", "1").output();
    assert!(alone.is_ok_and(|output| output.status.success()));

    let differing = || {
        let [parts, whole] = ["parts", "whole"].map(|out| files(&own.path(out)));
        let of_the_day = |name: &String| name == "result.json" || name == "wingroot.files";
        let names = whole.keys().chain(parts.keys()).filter(|name| !of_the_day(name)).cloned();
        names.filter(|name| parts.get(name) != whole.get(name)).collect::<Vec<String>>()
    };
    assert_eq!(differing(), Vec::<String>::new());
    let [parts, whole] = ["parts/result.json", "whole/result.json"].map(|path| {
        let mut value: serde_json::Value = serde_json::from_str(&own.read(path)).expect("JSON");
        value.as_object_mut().expect("an object").remove("seconds");
        value
    });
    assert_eq!(parts, whole);
}
