//! Loads at stations and at all nodes by what they come from: laws of sums and balance in trims and in flight, and the moment in
//! a beam by its curvature.

use crate::common::{air, path, whole};
use coupling::wing_file::StationAt;
use fullaircraft::flight::loads::LoadedTrim;
use fullaircraft::{
    Aircraft, AircraftFile, Component, FlightLoads, FlightPoint, Gust, GustAxis, NodalLoads, Station, Steady,
    TrimTools,
};
use nalgebra::{Matrix3, Vector3};
use structure::Flexibility;

const V_M_S: f64 = 30.0;
const OUTER: &str = "outer";

fn points() -> Vec<StationAt> {
    let at = |name: &str, y_m| StationAt { name: name.to_owned(), x_m: Some(0.26), y_m, z_m: Some(0.01) };
    vec![at("quarter", 0.45), at("half", 0.9)]
}

fn stations(aircraft: &Aircraft) -> Vec<Station> {
    let mut all = aircraft.wing_stations(&points()).expect("they are on the wing");
    all.extend(aircraft.body_stations());
    all
}

fn maneuvers() -> Vec<Steady> {
    let control = || OUTER.to_owned();
    vec![
        Steady::Level,
        Steady::Pull { load_factor: 3.0 },
        Steady::Pull { load_factor: -1.0 },
        Steady::Roll { load_factor: 1.0, rate_deg_s: 40.0, control: control() },
        Steady::Turn { load_factor: 2.0, left: false, control: control() },
        Steady::Sideslip { load_factor: 1.0, beta_deg: 5.0, control: control() },
        Steady::Trim {
            name: "powered".to_owned(),
            given: [].into(),
            free: ["alpha_deg", "elevator_deg", "thrust_N"].map(str::to_owned).to_vec(),
            targets: [("n_z", 1.5), ("pitch_acceleration_deg_s2", 0.0), ("n_x", 0.2)]
                .map(|(name, value)| (name.to_owned(), value))
                .into(),
        },
    ]
}

/// Sums of sizes of nodal forces and of their moments about a station's point.
fn sizes(aircraft: &Aircraft, station: &Station, loads: &NodalLoads) -> [f64; 2] {
    let points = aircraft.free.points();
    let mut sizes = [0.0, 0.0];
    for f_g in [&loads.air, &loads.inertia, &loads.thrust] {
        for &node in &station.nodes {
            let part = |from: usize| Vector3::from_fn(|axis, _| f_g[6 * node + from + axis]);
            sizes[0] += part(0).norm();
            sizes[1] += part(3).norm() + (points[node] - station.point).norm() * part(0).norm();
        }
    }
    sizes
}

fn assert_no_load(what: &str, loads: &[f64; 6], sizes: &[f64; 2]) {
    for (row, load) in loads.iter().enumerate() {
        assert!(load.abs() < 1e-9 * sizes[row / 3], "{what}, row {row}: {load} of {}", sizes[row / 3]);
    }
}

fn difference(one: &[f64; 6], other: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|row| one[row] - other[row])
}

/// Loads of a station about another point.
fn about(loads: &[f64; 6], from: &Station, to: &Station) -> [f64; 6] {
    let [fx, fy, fz, mx, my, mz] = *loads;
    let moment = Vector3::new(mx, my, mz) + (from.point - to.point).cross(&Vector3::new(fx, fy, fz));
    [fx, fy, fz, moment.x, moment.y, moment.z]
}

#[test]
fn components_add_up_to_the_net_cuts_nest_and_a_trimmed_aircraft_is_in_balance() {
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &points()).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).unwrap();
    let (nodes, stations) = (aircraft.free.points(), stations(aircraft));
    for steady in maneuvers() {
        let found = at.solve(&steady.case(&aircraft.file, V_M_S)).unwrap();
        let loads = at.nodal_loads(&found);
        for (place, station) in stations.iter().enumerate() {
            let what = format!("{}, {}", steady.kind(), station.name);
            let net = station.sums(nodes, &loads.of(Component::Net));
            let mut rest = net;
            for component in [Component::Air, Component::Inertia, Component::Thrust] {
                rest = difference(&rest, &station.sums(nodes, &loads.of(component)));
            }
            let sizes = sizes(aircraft, station, &loads);
            assert_no_load(&what, &rest, &sizes);
            // the trim's own sums, by unit solutions
            if let Some([fz, mx, my]) = at.station_loads(&found).get(place) {
                assert_no_load(&what, &difference(&net, &[net[0], net[1], *fz, *mx, *my, net[5]]), &sizes);
            }
            if station.name == "whole" {
                assert_no_load(&what, &net, &sizes);
            }
        }
        // root = what is between root and quarter + quarter, about the root
        let net = loads.of(Component::Net);
        for side in [0, 1] {
            let (root, quarter) = (&stations[side], &stations[2 + side]);
            let between = Station {
                nodes: root.nodes.iter().copied().filter(|node| !quarter.nodes.contains(node)).collect(),
                ..root.clone()
            };
            assert!(!between.nodes.is_empty() && between.nodes.len() < root.nodes.len());
            let outer = about(&quarter.sums(nodes, &net), quarter, root);
            let rest = difference(&root.sums(nodes, &net), &between.sums(nodes, &net));
            assert_no_load("between cuts", &difference(&rest, &outer), &sizes(aircraft, root, &loads));
        }
        // wings, tail, fuselage and the centre are all there is
        let of = |name: &str| stations.iter().find(|station| station.name == name).unwrap();
        let parts = ["right root", "left root", "fuselage ahead", "fuselage behind"].map(of);
        let count: usize = parts.iter().map(|part| part.nodes.len()).sum();
        assert_eq!(count + 1, aircraft.free.node_count(), "every node but the centre is in one part");
    }
}

/// What a beam's ends say: bending moment from the difference of slopes and torque from that of twist, about the middle.
fn moment_by_curvature(aircraft: &Aircraft, u_g: &[f64], ends: [usize; 2]) -> (Matrix3<f64>, Vector3<f64>) {
    let points = aircraft.free.points();
    let ids = aircraft.free.node_ids();
    let bulk = &aircraft.bulk;
    let bar = bulk.beams.values().find(|bar| bar.grids == [ids[ends[0]], ids[ends[1]]]).expect("a beam");
    let section = &bulk.beam_properties[&bar.property];
    let material = &bulk.materials[&section.material];
    let along = points[ends[1]] - points[ends[0]];
    let length_m = along.norm();
    let x = along / length_m;
    let nastran::Orientation::Vector(v) = bar.orientation else { panic!("beams have a vector") };
    let z = x.cross(&v).normalize();
    let turn = |node: usize| Vector3::from_fn(|axis, _| u_g[6 * node + 3 + axis]);
    let change = (turn(ends[1]) - turn(ends[0])) / length_m;
    let (e, g) = (material.e, material.g);
    let [inner, outer] = [&section.stations[0], section.stations.last().expect("two")];
    assert_eq!([inner.i1, inner.i2, inner.j], [outer.i1, outer.i2, outer.j], "one section a beam");
    let [i1, i2, j] = [inner.i1, inner.i2, inner.j];
    let y = z.cross(&x);
    let axes = Matrix3::from_columns(&[x, y, z]);
    (axes, Vector3::new(g * j * change.dot(&x), e * i2 * change.dot(&y), e * i1 * change.dot(&z)))
}

#[test]
fn the_net_moment_at_a_cut_is_that_in_the_beam() {
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &points()).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).unwrap();
    let flexibility = Flexibility::new(&aircraft.free.clamped_at(aircraft.centre)).unwrap();
    let held = aircraft.free.clamped_at(aircraft.centre);
    let nodes = aircraft.free.points();
    for steady in maneuvers() {
        let found = at.solve(&steady.case(&aircraft.file, V_M_S)).unwrap();
        let net = at.nodal_loads(&found).of(Component::Net);
        let f_g = faer::Mat::from_fn(net.len(), 1, |dof, _| net[dof]);
        let u = held.expand(flexibility.displacements(held.reduce(f_g.as_ref()).as_ref()).as_ref());
        let u = u.col_as_slice(0);
        for (wing, side) in [(&aircraft.right, 0), (&aircraft.left, 1)] {
            // loads on the structure bend it as the trim says
            let tip = u[6 * wing.tip + 2];
            let known = at.tip_deflection_m(&found)[side];
            assert!((tip - known).abs() < 1e-9 * known.abs(), "{}: {tip} {known}", steady.kind());
            let y = |node: &usize| nodes[*node].y.abs();
            let mut axis: Vec<usize> = wing.nodes.clone();
            axis.retain(|node| {
                aircraft.bulk.beams.values().any(|b| b.grids.contains(&aircraft.free.node_ids()[*node]))
            });
            axis.sort_by(|a, b| y(a).total_cmp(&y(b)));
            for at_y in [0.45, 0.9, 1.4] {
                let outer = axis.iter().position(|node| y(node) > at_y).unwrap();
                let ends = [axis[outer - 1], axis[outer]];
                let middle = nodes[ends[0]] + 0.5 * (nodes[ends[1]] - nodes[ends[0]]);
                let cut = Station {
                    name: "cut".to_owned(),
                    channel: "cut".to_owned(),
                    point: middle,
                    nodes: wing.nodes.iter().copied().filter(|node| y(node) > at_y).collect(),
                    axes: nalgebra::Matrix3::identity(),
                };
                let sums = cut.sums(nodes, &net);
                let (axes, by_curvature) = moment_by_curvature(aircraft, u, ends);
                let moment = axes.transpose() * Vector3::new(sums[3], sums[4], sums[5]);
                let size = moment.norm();
                for axis in 0..3 {
                    let (sum, beam) = (moment[axis], by_curvature[axis]);
                    assert!(
                        (sum - beam).abs() < 1e-9 * size,
                        "{}, y {at_y}, axis {axis}: {sum} N m by sums, {beam} in the beam",
                        steady.kind()
                    );
                }
            }
        }
    }
}

#[test]
fn in_gusts_and_with_ailerons_nodal_loads_add_up_to_the_stations_and_are_in_balance() {
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &points()).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).unwrap();
    let found = at.solve(&Steady::Level.case(&aircraft.file, V_M_S)).unwrap();
    let point = FlightPoint { v_m_s: V_M_S, load_factor: 1.0, pitch_rate_deg_s: 0.0 };
    let trimmed = at.trimmed(&found, &point);
    let drives = vec![aircraft.drive(OUTER).unwrap()];
    let trim = LoadedTrim {
        model: &model,
        air: air(),
        trimmed: &trimmed,
        steady: at.nodal_loads(&found),
        drives,
        axis: GustAxis::Vertical,
    };
    let flight = FlightLoads::new(trim, stations(aircraft), 0.002).unwrap();
    let gust = Gust { velocity_m_s: 3.0, length_m: 4.0, start_s: 0.0 };
    let step = vec![vec![0.1; 150]];
    let flown = [flight.fly(Some(gust), &[], 150), flight.fly(None, &step, 150)];
    let nodes = aircraft.free.points();
    for (kind, flown) in flown.iter().enumerate() {
        let mut most = 0.0_f64;
        for sample in [0, 40, 77, 149] {
            let loads = flown.nodal_loads(sample);
            for (at, station) in flight.stations().iter().enumerate() {
                let sizes = sizes(aircraft, station, &loads);
                for component in Component::ALL {
                    let what =
                        format!("flight {kind}, sample {sample}, {} {}", station.name, component.name());
                    let (sum, rows) =
                        (station.sums(nodes, &loads.of(component)), flown.at_station(at, component, sample));
                    assert_no_load(&what, &difference(&sum, &rows), &sizes);
                }
                let net = station.sums(nodes, &loads.of(Component::Net));
                if station.name == "whole" {
                    assert_no_load("whole", &net, &sizes);
                }
                let start = flown.at_station(at, Component::Net, 0);
                most = most.max((net[3] - start[3]).abs());
            }
        }
        assert!(most > 1.0, "loads change in flight {kind}: {most} N m");
    }
}

#[test]
fn loads_in_flight_change_as_the_instruments_say() {
    let mut wing = coupling::WingFile::read(&crate::common::beam_wing()).expect("shipped files are right");
    wing.stations = points();
    let aircraft = Aircraft::new(AircraftFile::read(&path()).expect("a file"), wing).expect("an aircraft");
    let tools = TrimTools::new(&aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).unwrap();
    let found = at.solve(&Steady::Level.case(&aircraft.file, V_M_S)).unwrap();
    let point = FlightPoint { v_m_s: V_M_S, load_factor: 1.0, pitch_rate_deg_s: 0.0 };
    let trimmed = at.trimmed(&found, &point);
    let drives = || vec![aircraft.drive(OUTER).unwrap()];
    let steady = at.nodal_loads(&found);
    let trim = LoadedTrim {
        model: &model,
        air: air(),
        trimmed: &trimmed,
        steady,
        drives: drives(),
        axis: GustAxis::Vertical,
    };
    let stations = aircraft.wing_stations(&[]).unwrap();
    let flight = FlightLoads::new(trim, stations, 0.001).unwrap();
    let command = vec![0.05; 200];
    let flown = flight.fly(None, std::slice::from_ref(&command), 200);
    let free = fullaircraft::FreeFlight::new(&model, air(), &trimmed, OUTER).unwrap();
    let history = free.fly(&command);
    for (at, station) in flight.stations().iter().enumerate() {
        let known = match station.channel.as_str() {
            "right" => &history.root_right,
            "left" => &history.root_left,
            name => &history.stations.iter().find(|s| s.name == name).unwrap().loads,
        };
        for (row, load) in [2, 3, 4].into_iter().enumerate() {
            let change = |sample: usize| known[row][sample] - known[row][0];
            let size = (0..200).map(|sample| change(sample).abs()).fold(0.0, f64::max);
            for sample in [1, 50, 120, 199] {
                let of = |component, sample| flown.at_station(at, component, sample)[load];
                // an instrument does not feel the damping inside the structure
                let undamped = |sample| of(Component::Net, sample) - of(Component::Damping, sample);
                let found = undamped(sample) - undamped(0);
                assert!(
                    (found - change(sample)).abs() < 1e-6 * size,
                    "{}: {found} {}",
                    station.name,
                    change(sample)
                );
            }
        }
    }
}
