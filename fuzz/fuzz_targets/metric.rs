#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| regge_verify::input::trial::metric(bytes));
