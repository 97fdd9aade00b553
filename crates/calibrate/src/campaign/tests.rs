//! What a campaign's files may say, and what a row of them means.

use super::*;
use crate::sensors::{DeadWeight, Reading, Zero};
use crate::tests::point;

/// Writes a campaign's folder and reads it.
fn read(name: &str, file: &str, table: &str) -> Result<Campaign, InputError> {
    let folder = std::env::temp_dir().join(format!("wingroot_campaign_{}_{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    let file = format!("(name: \"x\", static_cases: \"static.csv\", {file})");
    std::fs::write(folder.join("campaign.ron"), file).expect("a file");
    std::fs::write(folder.join("static.csv"), table).expect("a file");
    let read = Campaign::read(&folder);
    std::fs::remove_dir_all(&folder).expect("a folder of our own");
    read
}

const TABLE: &str = "V_m_s,alpha_deg,Fz_N\n20,0,1\n20,2,3\n20,4,5\n";

#[track_caller]
fn refused(name: &str, file: &str, table: &str, words: &str) {
    let error = read(name, file, table).expect_err(file);
    let said = format!("{error} {error:?}");
    assert!(said.contains(words), "{file}: {said}");
}

#[test]
fn noise_that_is_zero_is_none_and_the_order_is_that_of_the_channels() {
    let noise = ChannelNoise::from_array([0.5, 0.0, 0.25, 1e-3]);
    assert_eq!(noise, ChannelNoise { fz_n: Some(0.5), mx_nm: None, my_nm: Some(0.25), tip_z_m: Some(1e-3) });
    assert_eq!(noise.to_array(), [0.5, 0.0, 0.25, 1e-3]);
}

#[test]
fn a_density_is_that_of_a_gas() {
    for (rho, good) in [("1.2", true), ("99.0", true), ("0.0", false), ("-1.0", false), ("100.0", false)] {
        let file = format!("rho_kg_m3: {rho}");
        assert_eq!(read("rho", &file, TABLE).is_ok(), good, "{rho}");
    }
    refused("rho_words", "rho_kg_m3: 100.0", TABLE, "below 100");
}

#[test]
fn airspeeds_and_angles_are_within_their_limits() {
    let with = |cells: &str| read("limits", "rho_kg_m3: 1.2", &format!("{TABLE}{cells},1\n"));
    for good in ["0,0", "0.1,0", "340,0", "20,90", "20,-90"] {
        assert!(with(good).is_ok(), "{good}");
    }
    for bad in ["0.05,0", "341,0", "-20,0", "20,90.5", "20,-91"] {
        assert!(with(bad).is_err(), "{bad}");
    }
    refused("none", "rho_kg_m3: 1.2", "V_m_s,alpha_deg,Fz_N\n", "no static cases below the header");
    refused("other", "rho_kg_m3: 1.2", "V_m_s,alpha_deg,Fz_N,speed\n1,1,1,1\n", "speed");
}

#[test]
fn other_names_stand_for_columns_that_there_are_and_for_one_each() {
    let file = |columns: &str| format!("rho_kg_m3: 1.2, columns: {{{columns}}}");
    let renamed = TABLE.replace("V_m_s", "speed");
    let good = [
        "\"V_m_s\": \"speed\"",
        "\"V_m_s\": \"speed\", \"t_s\": \"time\"",
        "\"V_m_s\": \"speed\", \"az_3_m_s2\": \"acc\"",
        "\"V_m_s\": \"speed\", \"block\": \"day\"",
        "\"V_m_s\": \"speed\", \"delta_flap_deg\": \"flap\"",
    ];
    for columns in good {
        let campaign = read("named", &file(columns), &renamed).expect(columns);
        assert_eq!(campaign.points.iter().map(|point| point.v_m_s).collect::<Vec<_>>(), [20.0; 3]);
    }
    let bad = [
        ("\"speed\": \"V_m_s\"", "no column of static cases"),
        ("\"az_3\": \"acc\"", "no column of static cases"),
        ("\"x_m_s2\": \"acc\"", "no column of static cases"),
        ("\"V_m_s\": \"\"", "is no name of a column"),
        ("\"V_m_s\": \" speed\"", "is no name of a column"),
        ("\"V_m_s\": \"speed\", \"alpha_deg\": \"speed\"", "stands for two columns"),
    ];
    for (columns, words) in bad {
        refused("misnamed", &file(columns), &renamed, words);
    }
}

#[test]
fn noise_is_positive_and_given_for_what_is_fitted() {
    let file = |sample: &str, point: &str| {
        format!("rho_kg_m3: 1.2, noise: Some((sample: ({sample}), static_point: ({point})))")
    };
    assert!(read("noise", &file("", "fz_N: 0.1"), TABLE).is_ok());
    for (sample, point) in [("", "fz_N: 0.0"), ("", "fz_N: -0.1"), ("my_Nm: 0.0", "fz_N: 0.1")] {
        refused("noiseless", &file(sample, point), TABLE, "positive standard deviations");
    }
    refused("other_noise", &file("", "mx_Nm: 0.1"), TABLE, "not given for Fz_N");
    let two = "V_m_s,alpha_deg,Fz_N,Mx_Nm\n20,0,1,1\n";
    refused("less_noise", &file("", "fz_N: 0.1"), two, "not given for Mx_Nm");
}

#[test]
fn a_row_has_what_its_cells_say() {
    let table =
        "V_m_s,alpha_deg,My_Nm,block,tip_z_m,delta_a_deg\n0,180e-1,1,d1,0.5,0\n20,-90,2,d2,-0.25,90\n";
    let campaign = read("row", "rho_kg_m3: 1.2", table).expect("a campaign");
    assert_eq!(campaign.channels, [false, false, true]);
    assert_eq!((campaign.tip, campaign.fitted()), (TipReading::Unused, [false, false, true, false]));
    let [a, b] = &campaign.points[..] else { panic!("two rows") };
    assert_eq!(b.alpha_rad, -std::f64::consts::FRAC_PI_2);
    assert_eq!(b.loads, [None, None, Some(2.0)]);
    assert_eq!([0, 1, 2, 3].map(|channel| b.reading(channel)), [0.0, 0.0, 2.0, -0.25]);
    assert_eq!((a.block.as_deref(), b.block.as_deref()), (Some("d1"), Some("d2")));
    assert_eq!((a.controls_rad.len(), b.controls_rad.len()), (0, 1));
    assert_eq!([a.span.line, b.span.line], [2, 3]);
    let tip = read("tip", "rho_kg_m3: 1.2, tip: Zeroed", table).expect("a campaign");
    assert_eq!(tip.fitted(), [false, false, true, true]);
}

#[test]
fn what_a_row_is_for_follows_from_wind_controls_and_weights() {
    let sensor = |column: &str, under: Option<DeadWeight>| Sensor {
        column: column.into(),
        reads: Reading::Height { y_over_span: 0.5, x_over_c: 0.5 },
        sigma: 1.0,
        zero: Zero::WindOff,
        scale: 0.0,
        under,
    };
    let weight = DeadWeight { mass_kg: 1.0, y_over_span: 0.5, x_over_c: 0.5 };
    let sensors = [sensor("free", None), sensor("hung", Some(weight))];
    let of = |v_m_s: f64, cells: [Option<f64>; 2], deflected: bool| {
        let mut row = point(2, v_m_s, 0.0, [1.0; 4]);
        row.sensors = cells.to_vec();
        if deflected {
            row.controls_rad = vec![("flap".into(), 0.1)];
        }
        (row.says_more(&sensors), row.is_hung(&sensors), row.is_tare(&sensors))
    };
    let one = Some(1.0);
    // says more, is hung, is a tare
    assert_eq!(of(20.0, [None, None], false), (false, false, false));
    assert_eq!(of(20.0, [one, None], false), (true, false, false));
    assert_eq!(of(20.0, [None, None], true), (true, false, false));
    assert_eq!(of(0.0, [None, None], true), (false, false, true));
    assert_eq!(of(0.0, [one, None], false), (false, false, true));
    assert_eq!(of(0.0, [None, one], false), (true, true, false));
}
