//! Coordinate systems against hand-made rotations.

use nalgebra::{Point3, Vector3};
use nastran::{Frames, Span, parse_deck};
use proptest::prelude::*;

fn error(text: &str) -> String {
    let deck = parse_deck("t.bdf", text).unwrap_or_else(|error| panic!("{error}"));
    let error = Frames::resolve(&deck).expect_err("must be refused");
    format!("{}: {}", error.span.as_ref().expect("errors of decks have a place"), error.message)
}

#[test]
fn systems_may_stand_in_others_in_any_order() {
    // System 1 is turned by 90 degrees about z at (1, 0, 0); system 2 the same again, inside system 1.
    let deck = parse_deck(
        "t.bdf",
        concat!(
            "CORD2R,1,2,1.,0.,0.,1.,0.,1.\n,1.,1.,0.\n",
            "CORD2R,2,,1.,0.,0.,1.,0.,1.\n,1.,1.,0.\n",
            "GRID,1,1,1.,2.,3.\n"
        ),
    )
    .expect("a good deck");
    let frames = Frames::resolve(&deck).expect("good systems");
    // Origin of 1: (1,0,0) + turned (1,0,0) = (1,1,0); axes turned by 180 degrees.
    let point = frames.grid_point(&deck.grids[&1]).expect("system 1 exists");
    assert!((point - Point3::new(0.0, -1.0, 3.0)).norm() < 1e-15, "{point}");
    assert!(
        (frames.axes(1).expect("system 1 exists").column(0) - Vector3::new(-1.0, 0.0, 0.0)).norm() < 1e-15
    );
    assert_eq!(frames.axes(0).expect("the basic system"), nalgebra::Matrix3::identity());
}

#[test]
fn grids_may_define_a_system() {
    let deck = parse_deck(
        "t.bdf",
        "CORD1R,9,1,2,3\nGRID,1,,0.,0.,5.\nGRID,2,,0.,1.,5.\nGRID,3,,1.,0.,5.\nGRID,4,9,0.,0.,1.\n",
    )
    .expect("a good deck");
    let frames = Frames::resolve(&deck).expect("good systems");
    let point = frames.grid_point(&deck.grids[&4]).expect("system 9 exists");
    assert_eq!(point, Point3::new(0.0, 1.0, 5.0), "its z is the basic y");
}

#[test]
fn systems_that_cannot_be_resolved_are_refused() {
    assert_eq!(
        error("CORD2R,1,2,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nCORD2R,2,1,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"),
        "t.bdf:3:1: coordinate system 2 refers to itself by way of system 1"
    );
    assert_eq!(
        error("CORD2R,1,7,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"),
        "t.bdf:1:1: coordinate system 7 is not defined"
    );
    assert_eq!(error("CORD1R,1,2,3,4\n"), "t.bdf:1:1: grid 2 of coordinate system 1 does not exist");
    for points in [
        "0.,0.,0.,0.,0.,0.\n,1.,0.,0.",
        "0.,0.,0.,0.,0.,1.\n,0.,0.,2.",
        "0.,0.,0.,1.+300,0.,1.+300\n,1.,1.,1.+300",
    ] {
        assert_eq!(
            error(&format!("CORD2R,1,,{points}\n")),
            "t.bdf:1:1: the three points of coordinate system 1 do not span a plane"
        );
    }
    let deck = parse_deck("t.bdf", "").expect("an empty deck is a deck");
    let frames = Frames::resolve(&deck).expect("no systems");
    let missing = frames.origin(4, &Span::generated("here")).unwrap_err();
    assert_eq!(
        missing.to_string(),
        "here: coordinate system 4 is not defined (hint: add a CORD2R 4 or correct the number)"
    );
}

#[test]
fn a_long_chain_of_systems_is_resolved() {
    use std::fmt::Write as _;
    let count = 20_000;
    let mut text = String::new();
    for id in 1..=count {
        let reference = if id == count { 0 } else { id + 1 };
        writeln!(text, "CORD2R,{id},{reference},0.,0.,1.,0.,0.,2.\n,1.,0.,1.").expect("text grows");
    }
    let frames = Frames::resolve(&parse_deck("t.bdf", &text).expect("a good deck")).expect("good systems");
    let origin = frames.origin(1, &Span::generated("here")).expect("system 1 exists");
    assert_eq!(origin, Point3::new(0.0, 0.0, f64::from(count)));
}

#[test]
fn cylindrical_and_spherical_points_and_axes() {
    let deck = parse_deck(
        "t.bdf",
        concat!(
            "CORD2C,1,,1.,0.,0.,1.,0.,1.\n,2.,0.,0.\nCORD2S,2,,1.,0.,0.,1.,0.,1.\n,2.,0.,0.\n",
            "CORD2R,3,1,2.,90.,0.,2.,90.,1.\n,3.,90.,0.\nGRID,1,1,2.,90.,3.,1\nGRID,2,2,2.,90.,90.,2\nGRID,3,3,1.\n"
        ),
    )
    .expect("a good deck");
    let frames = Frames::resolve(&deck).expect("good systems");
    let place = |id: u32| frames.grid_point(&deck.grids[&id]).expect("systems exist");
    assert!((place(1) - Point3::new(1.0, 2.0, 3.0)).norm() < 1e-15, "{}", place(1));
    assert!((place(2) - Point3::new(1.0, 2.0, 0.0)).norm() < 1e-15, "{}", place(2));
    // The rectangular system stands at r = 2, theta = 90 degrees of the first, its x axis outwards.
    assert!((place(3) - Point3::new(1.0, 3.0, 0.0)).norm() < 1e-15, "{}", place(3));
    let span = Span::generated("test");
    let axes = |cid: u32| frames.axes_at_point(cid, &place(1), &span).expect("systems exist");
    let turned = nalgebra::Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    assert!((axes(1) - turned).norm() < 1e-15);
    assert_eq!(axes(3), frames.axes_at(3, &span).expect("rectangular"));
    // On the axis theta counts as zero.
    let on_axis = frames.axes_at_point(1, &Point3::new(1.0, 0.0, 7.0), &span).expect("a system");
    assert_eq!(on_axis, nalgebra::Matrix3::identity());
    let error = frames.axes_at(1, &span).expect_err("differs from point to point");
    assert_eq!(error.message, "coordinate system 1 is not rectangular, which is needed here");
}

proptest! {
    #[test]
    fn axes_at_a_point_are_where_its_coordinates_grow(
        first in 0.5..3.0_f64, second in 10.0..170.0_f64, third in 10.0..80.0_f64,
        a in prop::array::uniform3(-1.0..1.0_f64), is_spherical in any::<bool>(),
    ) {
        let letter = if is_spherical { 'S' } else { 'C' };
        let [x, y, z] = a.map(|value| nastran::real::format(value, 8));
        let text = format!("CORD2{letter},1,,{x},{y},{z},3.,3.,1.\n,-2.,2.,5.\n");
        let frames = Frames::resolve(&parse_deck("t.bdf", &text).expect("a good deck")).expect("a good system");
        let span = Span::generated("test");
        let at = |q: [f64; 3]| frames.point(1, q.into(), &span).expect("a system");
        let here = [first, second, third];
        let axes = frames.axes_at_point(1, &at(here), &span).expect("a system");
        for i in 0..3 {
            let (mut ahead, mut behind) = (here, here);
            (ahead[i], behind[i]) = (here[i] + 1e-4, here[i] - 1e-4);
            let direction = (at(ahead) - at(behind)).normalize();
            prop_assert!((direction - axes.column(i)).norm() < 1e-7, "{} {}", direction, axes);
        }
    }

    #[test]
    fn axes_are_orthonormal_and_right_handed(a in prop::array::uniform3(-5.0..5.0), b in prop::array::uniform3(-5.0..5.0), c in prop::array::uniform3(-5.0..5.0)) {
        let number = |value: f64| nastran::real::format(value, 16);
        let [a, b, c] = [a, b, c].map(|point: [f64; 3]| point.map(number).join(","));
        let deck = parse_deck("t.bdf", &format!("CORD2R,1,,{a},{b}\n,{c}\n")).expect("a good deck");
        if let Ok(frames) = Frames::resolve(&deck) {
            let axes = frames.axes(1).expect("system 1 exists");
            prop_assert!((axes.transpose() * axes - nalgebra::Matrix3::identity()).norm() < 1e-14);
            prop_assert!((axes.determinant() - 1.0).abs() < 1e-14);
        }
    }
}
