//! `cargo +nightly fuzz run wing`: `validation::fuzzing::wing` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::wing(bytes));
