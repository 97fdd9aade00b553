//! `cargo +nightly fuzz run corrections`: `validation::fuzzing::corrections` with bytes that libFuzzer makes up.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| validation::fuzzing::corrections(bytes));
