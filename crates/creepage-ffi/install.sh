#!/usr/bin/env bash
# Builds the C interface and installs libraries, header, Fortran module, and what pkg-config and
# CMake look for:
#   crates/creepage-ffi/install.sh PREFIX
# With --built DIR, the shared library that was built there is installed and nothing is built.
set -euo pipefail

built=
if [ "${1:-}" = --built ]; then
  built=${2:?--built needs a directory}
  shift 2
fi
prefix=${1:?usage: install.sh [--built DIR] PREFIX}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
lib=$prefix/lib
mkdir -p "$lib/pkgconfig" "$lib/cmake/creepage" "$prefix/include"
version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' "$root/Cargo.toml")
abi=${version%.*}

if [ -z "$built" ]; then
  flags=(--manifest-path "$root/Cargo.toml" --locked --release -p creepage-ffi --lib)
  "${CARGO:-cargo}" rustc "${flags[@]}" --crate-type cdylib,staticlib
  built=${CARGO_TARGET_DIR:-$root/target}/release
  strip=strip
else
  strip=: # as it is, for the tests
fi

# All but our own names go out of sight, so that two static libraries in Rust can be linked.
static() {
  local work
  work=$(mktemp -d)
  ld -r --whole-archive "$1" -o "$work/all.o"
  objcopy --strip-debug --wildcard --keep-global-symbol='creepage_*' \
    --remove-section=.llvmbc --remove-section=.llvmcmd "$work/all.o"
  rm -f "$2"
  ar crs "$2" "$work/all.o"
  rm -r "$work"
}

found=
if [ -e "$built/libcreepage_ffi.so" ]; then
  found=libcreepage_ffi.so.$version
  cp "$built/libcreepage_ffi.so" "$lib/$found"
  $strip --strip-unneeded "$lib/$found"
  ln -sf "$found" "$lib/libcreepage_ffi.so.$abi"
  ln -sf "libcreepage_ffi.so.$abi" "$lib/libcreepage_ffi.so"
elif [ -e "$built/libcreepage_ffi.dylib" ]; then
  found=libcreepage_ffi.$abi.dylib
  cp "$built/libcreepage_ffi.dylib" "$lib/$found"
  $strip -x "$lib/$found"
  ln -sf "$found" "$lib/libcreepage_ffi.dylib"
fi
[ -n "$found" ] || { echo "no library in $built" >&2; exit 1; }
if [ "$strip" = strip ] && [ -e "$built/libcreepage_ffi.a" ]; then
  case $found in
    *.so.*) static "$built/libcreepage_ffi.a" "$lib/libcreepage_ffi.a" ;;
    *) cp "$built/libcreepage_ffi.a" "$lib/" ;;
  esac
fi
cp "$here/include/creepage.h" "$here/include/creepage.f90" "$prefix/include/"

# Both find the rest from where they are, so that the whole may be moved.
cat > "$lib/pkgconfig/creepage.pc" <<PC
prefix=\${pcfiledir}/../..
libdir=\${prefix}/lib
includedir=\${prefix}/include

Name: creepage
Description: Rolling contact of two elastic bodies with dry friction
Version: $version
Libs: -L\${libdir} -Wl,-rpath,\${libdir} -lcreepage_ffi
Libs.private: -lm -lpthread -ldl
Cflags: -I\${includedir}
PC
cat > "$lib/cmake/creepage/creepage-config.cmake" <<CMAKE
get_filename_component(_creepage_prefix "\${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET creepage::creepage)
  add_library(creepage::creepage SHARED IMPORTED)
  set_target_properties(creepage::creepage PROPERTIES
    IMPORTED_LOCATION "\${_creepage_prefix}/lib/$found"
    INTERFACE_INCLUDE_DIRECTORIES "\${_creepage_prefix}/include")
endif()
CMAKE
cat > "$lib/cmake/creepage/creepage-config-version.cmake" <<CMAKE
set(PACKAGE_VERSION "$version")
if("\${PACKAGE_FIND_VERSION_MAJOR}.\${PACKAGE_FIND_VERSION_MINOR}" STREQUAL "$abi")
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
if(PACKAGE_FIND_VERSION STREQUAL PACKAGE_VERSION)
  set(PACKAGE_VERSION_EXACT TRUE)
endif()
CMAKE
echo "installed into $prefix"
