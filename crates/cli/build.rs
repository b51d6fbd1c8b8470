//! How the binary is linked.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // The tables of commands and classes hold some 25 000 pointers. In a position independent
    // executable the loader has to write each of them before `main`, which is a third of what a
    // process needs until it reads its first file; at a fixed address they are right as they stand.
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        println!("cargo::rustc-link-arg-bins=-no-pie");
    }
}
