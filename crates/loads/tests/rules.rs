//! Numbers of the rules beside `rules.json`.

use crate::close::close;
use crate::common::{number, reference};
use crate::plan::{design, mass};
use loads::design::{GustSpeeds, Rules, Speed};
use loads::rules::discrete::{alleviation, design_gust};
use loads::rules::factors::positive_limit;
use loads::rules::pratt::Pratt;
use loads::{Air, Airframe, Design, Mark};

fn cs25() -> Design {
    Design { rules: Rules::Cs25, factors: None, ..design() }
}

#[test]
fn the_standard_atmosphere_is_that_of_the_reference() {
    for row in reference("rules.json")["isa"].as_array().unwrap() {
        let air = Air::at(number(&row["h_m"]));
        close(air.temperature_k, &row["T_K"], 1e-9, "temperature");
        close(air.pressure_pa, &row["p_Pa"], 1e-6, "pressure");
        close(air.rho_kg_m3, &row["rho_kg_m3"], 1e-6, "density");
        close(air.sound_m_s, &row["a_m_s"], 1e-6, "speed of sound");
    }
}

#[test]
fn reference_gusts_and_intensities_of_cs_25_are_those_of_the_reference_and_half_at_vd() {
    let (all, design) = (reference("rules.json"), cs25());
    for row in all["uref"].as_array().unwrap() {
        let h = number(&row["h_m"]);
        close(design.reference_gust(h, 37.0).unwrap().value, &row["U_ref_EAS_m_s"], 1e-9, "U_ref at VC");
        close(design.reference_gust(h, 46.0).unwrap().value, &row["at_VD"], 1e-9, "U_ref at VD");
    }
    let half_way = design.reference_gust(0.0, 41.5).unwrap().value;
    assert!((half_way - 0.75 * 17.07).abs() < 1e-12, "linear between VC and VD: {half_way}");
    let design = Design { gust_speeds: GustSpeeds { f_g: Some(1.0), ..GustSpeeds::default() }, ..design };
    for row in all["usigma_ref"].as_array().unwrap() {
        let ours = design.turbulence_intensity(number(&row["h_m"]), 37.0).unwrap();
        close(ours[0].value, &row["U_sigma_ref_TAS_m_s"], 1e-9, "U_sigma_ref");
    }
}

#[test]
fn the_flight_profile_alleviates_gusts_as_in_the_reference() {
    for row in reference("rules.json")["fg"].as_array().unwrap() {
        let of = |name: &str| number(&row[name]);
        let masses = [of("MLW_kg"), of("MZFW_kg"), of("MTOW_kg")];
        let (h, z_mo) = (of("h_m"), of("Z_mo_m"));
        close(alleviation(h, z_mo, masses[0], masses[1], masses[2]), &row["Fg"], 1e-9, "F_g");
        let design = Design {
            masses: vec![mass("take-off", masses[2])],
            gust_speeds: GustSpeeds {
                z_mo_m: Some(z_mo),
                mlw_kg: Some(masses[0]),
                mzfw_kg: Some(masses[1]),
                ..GustSpeeds::default()
            },
            ..cs25()
        };
        let reference = design.reference_gust(h, 37.0).unwrap().value;
        let factor = design.profile_alleviation(h).unwrap().value;
        for (gradient, value) in row["U_ds_EAS_m_s"].as_object().unwrap() {
            let gradient = gradient.parse().unwrap();
            close(design_gust(reference, factor, gradient), value, 1e-9, "U_ds");
        }
        let true_speed = design_gust(reference, factor, 107.0) * Air::at(h).true_over_equivalent();
        close(true_speed, &row["U_ds_TAS_m_s_H107"], 1e-9, "U_ds, TAS");
        let limit = &design.turbulence_intensity(h, 37.0).unwrap()[1];
        close(limit.value, &row["U_sigma_TAS_m_s"], 1e-9, "U_sigma");
    }
}

#[test]
fn pratts_formula_and_derived_gusts_are_those_of_the_reference() {
    for row in reference("rules.json")["pratt"].as_array().unwrap() {
        let of = |name: &str| number(&row[name]);
        let frame = Airframe {
            area_m2: of("area_m2"),
            mean_chord_m: of("mean_chord_m"),
            lift_slope_per_rad: of("slope_per_rad"),
        };
        let air = Air::at(of("h_m"));
        let ours = Pratt::of(&frame, of("mass_kg"), &air, of("V_EAS_m_s"), of("U_de_EAS_m_s"));
        close(ours.mu_g, &row["mu_g"], 1e-9, "mu_g");
        close(ours.k_g, &row["Kg"], 1e-9, "K_g");
        close(ours.delta_n, &row["delta_n"], 1e-9, "Delta n");
    }
    let plan = |rules| Design { rules, ..design() };
    let u_de = |rules, speed, h| plan(rules).derived_gust(speed, h).map(|quantity| quantity.value);
    // 50 ft/s to 20 000 ft, 25 ft/s at 50 000 ft (14 CFR 23.333(c)); no lessening in CS-VLA.
    assert_eq!(u_de(Rules::Cs23Normal, Speed::VC, 6096.0).unwrap(), 15.24);
    assert!((u_de(Rules::Cs23Normal, Speed::VC, 9144.0).unwrap() - 12.7).abs() < 1e-12);
    assert!((u_de(Rules::Cs23Normal, Speed::VD, 15_240.0).unwrap() - 3.81).abs() < 1e-12);
    assert!((u_de(Rules::Cs23Normal, Speed::VB, 0.0).unwrap() - 20.1168).abs() < 1e-12);
    assert_eq!(u_de(Rules::Vla, Speed::VD, 9144.0).unwrap(), 7.62);
}

#[test]
fn limit_load_factors_follow_the_mass_as_in_the_reference() {
    for row in reference("rules.json")["n_limits"].as_array().unwrap() {
        let kg = number(&row["MTOW_kg"]);
        close(positive_limit(kg), &row["n1_cs23_normal"], 1e-9, "n1");
        let design = |rules| Design { rules, factors: None, masses: vec![mass("only", kg)], ..design() };
        let (cs25, _) = design(Rules::Cs25).load_factors().unwrap();
        close(cs25.n1, &row["n1_cs25"], 1e-9, "n1 of CS-25");
        assert_eq!((cs25.n2, cs25.n2_at_vd), (-1.0, 0.0));
        let (cs23, _) = design(Rules::Cs23Normal).load_factors().unwrap();
        close(cs23.n2, &row["n2_cs23_normal"], 1e-9, "n2 of CS-23");
    }
}

#[test]
fn a_number_that_the_rules_do_not_give_is_asked_for_by_name_and_an_own_number_is_called_so() {
    let plan = Design { rules: Rules::Stanag4671, factors: None, ..design() };
    let error = plan.load_factors().unwrap_err();
    assert!(error.message.contains("limit_load_factors") && error.message.contains("STANAG"), "{error}");
    let error = plan.derived_gust(Speed::VC, 0.0).unwrap_err();
    assert!(error.message.contains("U_de_VC_m_s"), "{error}");
    // What was not read of 23.333(c)(1)(iii) is not made up: rough air above 20 000 ft.
    let high = Design { rules: Rules::Cs23Normal, ..design() }.derived_gust(Speed::VB, 7000.0);
    assert!(high.unwrap_err().message.contains("U_de_VB_m_s"));
    let error = cs25().profile_alleviation(0.0).unwrap_err();
    assert!(error.message.contains("Z_mo_m"), "{error}");
    let own = GustSpeeds { u_de_vc_m_s: Some(9.0), ..GustSpeeds::default() };
    let own = Design { gust_speeds: own, factors: None, ..design() };
    let quantity = own.derived_gust(Speed::VC, 0.0).unwrap();
    assert_eq!((quantity.value, quantity.mark), (9.0, Mark::Own));
    assert_eq!(own.rules_in_use(), Rules::Own);
    assert_eq!(Design { factors: None, ..design() }.rules_in_use(), Rules::Vla);
}
