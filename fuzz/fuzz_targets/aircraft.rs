//! `cargo +nightly fuzz run aircraft`: `validation::fuzzing::aircraft` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::aircraft(bytes));
