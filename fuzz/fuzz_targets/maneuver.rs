//! `cargo +nightly fuzz run maneuver`: `validation::fuzzing::maneuver` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::maneuver(bytes));
