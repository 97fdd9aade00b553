//! `cargo +nightly fuzz run deck`: `validation::fuzzing::deck` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::deck(bytes));
