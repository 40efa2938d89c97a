#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| regge_readers::trial::mesh_called("mesh.ply", bytes));
