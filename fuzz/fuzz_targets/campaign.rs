//! `cargo +nightly fuzz run campaign`: `validation::fuzzing::campaign` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::campaign(bytes));
