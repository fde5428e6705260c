//! Names the shared library after the version whose programs it serves: before 1.0, the minor one.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let of = |name| std::env::var(name).unwrap_or_default();
    let abi = format!("{}.{}", of("CARGO_PKG_VERSION_MAJOR"), of("CARGO_PKG_VERSION_MINOR"));
    let name = match &of("CARGO_CFG_TARGET_OS")[..] {
        "linux" | "freebsd" => format!("-Wl,-soname,libcreepage_ffi.so.{abi}"),
        "macos" => format!("-Wl,-install_name,@rpath/libcreepage_ffi.{abi}.dylib"),
        _ => return,
    };
    println!("cargo::rustc-cdylib-link-arg={name}");
}
