#!/usr/bin/env bash
# Engine B: the core as WebAssembly, and the page with it as a folder of static files.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../tools/lib.sh"

# build.sh FOLDER: into FOLDER; objects are kept in build/wasm.
folder=$1
here="$root/page/wasm"
build="$root/build/wasm"
toolchain=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake
[ -r "$toolchain" ] || stop 2 "the page with engine B needs Debian's package emscripten"

debian_source yaml-cpp "$build/sources"
debian_source nlopt "$build/sources"

# Where Debian packages scripts for node; a node of others does not look there.
export NODE_PATH="/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}"
say "building engine B in $build"
log=$(cmake -S "$root" -B "$build/cmake" -G Ninja -Wno-dev -DCMAKE_TOOLCHAIN_FILE="$toolchain" \
  -DEMSCRIPTEN_SYSTEM_PROCESSOR=wasm32 -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" \
  -DORBEARING_BUILD_TESTS=OFF -DORBEARING_BUILD_PYTHON=OFF -DORBEARING_WARNINGS_AS_ERRORS=OFF \
  -DCMAKE_PROJECT_Orbearing_INCLUDE="$here/engine.cmake" -DORBEARING_SOURCES_OF_PACKAGES="$build/sources" 2>&1) || {
  printf '%s\n' "$log"
  exit 1
}
cmake --build "$build/cmake" --parallel "$(parallel_jobs)" --target engine
/usr/bin/python3 "$here/assemble.py" "$build/cmake" "$folder"
say "$folder: the page with engine B, for any file server"
