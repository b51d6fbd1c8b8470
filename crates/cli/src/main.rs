//! The `flexure` binary; everything is in the library so that the Python wheel can offer the same.

fn main() -> std::process::ExitCode {
    flexure_cli::main(std::env::args_os())
}
