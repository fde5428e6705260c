#!/usr/bin/env bash
# Builds the C interface and installs library, header and the file for pkg-config:
#   crates/creepage-ffi/install.sh [--debug] PREFIX
set -euo pipefail

profile=release
if [ "${1:-}" = --debug ]; then
  profile=debug
  shift
fi
prefix=${1:?usage: install.sh [--debug] PREFIX}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
mkdir -p "$prefix/lib/pkgconfig" "$prefix/include"
prefix=$(cd "$prefix" && pwd)

flags=(--manifest-path "$root/Cargo.toml" --locked -p creepage-ffi)
[ $profile = debug ] || flags+=(--release)
"${CARGO:-cargo}" build "${flags[@]}"

built=${CARGO_TARGET_DIR:-$root/target}/$profile
found=0
for library in libcreepage_ffi.so libcreepage_ffi.dylib libcreepage_ffi.a; do
  if [ -e "$built/$library" ]; then
    cp "$built/$library" "$prefix/lib/"
    found=1
  fi
done
[ $found = 1 ] || { echo "no library in $built" >&2; exit 1; }
cp "$here/include/creepage.h" "$prefix/include/"

version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' "$root/Cargo.toml")
cat > "$prefix/lib/pkgconfig/creepage.pc" <<PC
prefix=$prefix
libdir=\${prefix}/lib
includedir=\${prefix}/include

Name: creepage
Description: Rolling contact of two elastic bodies with dry friction
Version: $version
Libs: -L\${libdir} -Wl,-rpath,\${libdir} -lcreepage_ffi
Libs.private: -lm -lpthread -ldl
Cflags: -I\${includedir}
PC
echo "installed into $prefix"
