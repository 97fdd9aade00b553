//! explore
use aero::{Corrections, Flow};
use calibrate::{Campaign, Settings, calibrate};
use coupling::planform::Planform;
use coupling::wing_file::Source;
use coupling::{ElasticWing, Mount, SteadyCase, SteadyModel, WingFile};
use validation::{data, list, number, published};
#[test]
fn explore() {
    let (file, wing) = ElasticWing::read(&data("pazy/wing.ron")).unwrap();
    println!(
        "V_D at rho 1.225: {:?}",
        wing.divergence_speed(1.225, &Corrections::neutral(wing.correctable().len()))
    );
    let (system, _) = wing.structure.as_ref().unwrap();
    let modes = structure::normal_modes(system, 6).unwrap();
    println!("modes {:?}", modes.omega_rad_s.iter().map(|w| w / std::f64::consts::TAU).collect::<Vec<_>>());
    for name in ["tip_3deg", "tip_5deg", "tip_5deg_by_airspeed"] {
        let campaign = Campaign::read(&data(&format!("pazy/{name}"))).unwrap();
        let start = std::time::Instant::now();
        let result = calibrate(&wing, &campaign, &Settings::of_wing(&file.correction)).unwrap();
        let c = result.common.unwrap();
        println!(
            "{name} rows {} F {:?} hist {:?} rmse {:?} curve {:?} floor {} sigma {:?} weights {:?} ending {:?} lift {:?} mean {} {:?} det {:?} {:?}",
            c.rows,
            c.fit.objective,
            c.fit.history,
            c.fit.rmse.map(|r| r[3]),
            c.curve_rmse[3],
            c.curve_floor,
            c.point_sigma[3],
            c.weights[3],
            c.fit.ending,
            c.lift,
            c.mean_force_factor,
            c.identifiability.as_ref().map(|i| i.mean_force_sigma),
            c.identifiability.as_ref().map(|i| i.determined_directions),
            c.identifiability.as_ref().map(|i| i.singular_values[..4].to_vec())
        );
        println!("{:?}", start.elapsed());
    }
    // the GFEM's own stiffness
    let mut f = file.clone();
    std::fs::write("/tmp/pz/gfem.csv", "y_m,EI_flap_Nm2,EI_lag_Nm2,GJ_Nm2,mass_per_span_kg_m,Itheta_kgm,xcg_over_c,xea_over_c\n0.0,4.5618,959.5,6.4539,0.5696,0.000897,0.44085,0.44085\n0.55,4.5618,959.5,6.4539,0.5696,0.000897,0.44085,0.44085\n").unwrap();
    if let Source::Parametric(Planform { structure: Some(s), .. }) = &mut f.source {
        s.distribution = "/tmp/pz/gfem.csv".into();
    }
    let bulk = f.bulk(Mount::Tunnel).unwrap();
    for gap in [0.0, 0.00215] {
        f.root_plane = Some(coupling::RootPlane::Symmetric(-gap));
        let mut g = ElasticWing::from_bulk(&f, &bulk).unwrap();
        g.gravity_m_s2 = 0.0;
        let case = published("pazy__pazy_static_aeroelastic_aoa5");
        let neutral = Corrections::neutral(g.correctable().len());
        println!("V_D {:?}", g.divergence_speed(1.225, &neutral));
        for row in list(&case["expected"]["gfem_sol144_linear_disp"]).iter().skip(2).step_by(3) {
            let v = number(&row[0]);
            let flow = Flow { v_m_s: v, rho_kg_m3: 1.225 };
            let s = &g.at(flow, &neutral).unwrap().solve(&[SteadyCase::new(flow, 5.0_f64.to_radians())])[0];
            let tip = 100.0 * s.tip_z_m / 0.55;
            println!("{v}: {tip} gfem {} ratio {}", row[1], tip / number(&row[1]));
        }
    }
    let case = published("pazy__pazy_static_aeroelastic_aoa5");
    let neutral = Corrections::neutral(wing.correctable().len());
    for row in list(&case["expected"]["tip_twist_deg_vs_U"]).iter().skip(7).step_by(5) {
        let v = number(&row[0]);
        let flow = Flow { v_m_s: v, rho_kg_m3: 1.136 };
        let s = &wing.at(flow, &neutral).unwrap().solve(&[SteadyCase::new(flow, 5.0_f64.to_radians())])[0];
        let st = wing.supported.as_ref().unwrap();
        println!(
            "{v}: tip {} twist {} measured {}",
            s.tip_z_m / 0.55 * 100.0,
            s.displacement[st.tip_z + 2].to_degrees(),
            row[1]
        );
    }
}
