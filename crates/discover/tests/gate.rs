//! The gate names every defect that is put into the shipped campaign, and nothing where only the model is wrong.

mod common;

use common::shipped;
use discover::data::Dataset;
use discover::gate::{DefectKind, defects, rough_noise};

#[test]
fn the_shipped_campaign_passes() {
    let flight = shipped();
    let found = defects(&flight.data, &flight.flown, &rough_noise(&flight.data));
    assert!(found.is_empty(), "{found:#?}");
}
