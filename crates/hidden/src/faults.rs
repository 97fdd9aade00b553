//! Faults of the data, put into records that are right.

use crate::campaign::{Measured, Record};
use crate::plan::Defect;

/// Puts a fault into a campaign.
pub(crate) fn spoil(measured: &mut Measured, defect: &Defect) {
    match defect {
        Defect::SignFlipped { channel } => {
            let loads = measured.records.iter_mut().flat_map(|record| &mut record.loads[*channel]);
            loads.for_each(|load| *load = -*load);
        }
        Defect::Swapped { first, second } => {
            measured.records.iter_mut().for_each(|record| record.loads.swap(*first, *second));
        }
        Defect::WrongAirspeed { record, said_m_s } => {
            if let Some(record) = measured.records.get_mut(*record) {
                let same = record.v_m_s == *said_m_s;
                record.v_m_s = if same { said_m_s + 4.0 } else { *said_m_s };
            }
        }
        Defect::Clipped { channel, share } => {
            let largest =
                |record: &Record| record.loads[*channel].iter().map(|load| load.abs()).fold(0.0, f64::max);
            let most = share * measured.records.iter().map(largest).fold(0.0, f64::max);
            let loads = measured.records.iter_mut().flat_map(|record| &mut record.loads[*channel]);
            loads.for_each(|load| *load = load.clamp(-most, most));
        }
        Defect::NoReplicates => {
            measured.records.retain(|record| record.repeat_of.is_none());
            measured.statics.retain(|point| point.block == 0);
            measured.reference.retain(|point| point.block == 0);
        }
    }
}
