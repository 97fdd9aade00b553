//! `cargo +nightly fuzz run dmi`: `validation::fuzzing::dmi` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::dmi(bytes));
