//! A case of the blind benchmark as `discover` has it: read, calibrated, ready to be searched.

use std::path::Path;

use calibrate::{Campaign, Schedule, Settings, calibrate};
use discover::analysis::{Prepared, Rigs};

use crate::corrections::schedule;
use crate::failure::Failure;

/// See the module.
#[derive(Debug)]
pub struct BlindCase {
    /// Ready to be searched.
    pub prepared: Prepared,
    /// As measured.
    pub campaign: Campaign,
    /// Corrections it is searched with.
    pub schedule: Schedule,
}

/// Reads a case's folder: `measured`, and `reference` for the corrections unless they are found with the case's own static
/// points (track B). An effect may be left out of the library.
///
/// # Errors
/// Bad data, or a wing that cannot be flown.
pub fn read(
    rigs: &Rigs<'_>,
    folder: &Path,
    own_static_points: bool,
    left_out: Option<&str>,
) -> Result<BlindCase, Failure> {
    let campaign = Campaign::read(&folder.join("measured"))?;
    let statics =
        if own_static_points { campaign.clone() } else { Campaign::read(&folder.join("reference"))? };
    let (file, wing) = (rigs.own.file(), rigs.own.wing());
    let settings = Settings::for_corrections(&file.correction);
    let schedule = schedule(file, &calibrate(wing, &statics, &settings)?);
    let mut prepared = Prepared::new(rigs, &schedule, &campaign, own_static_points)?;
    prepared.library.retain(|effect| Some(effect.spec().name) != left_out);
    Ok(BlindCase { prepared, campaign, schedule })
}
