//! `cargo +nightly fuzz run table`: `validation::fuzzing::table` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::table(bytes));
