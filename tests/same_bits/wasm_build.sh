#!/usr/bin/env bash
# Within the folder of `wasm.sh`: OpenMesh from /openmesh, then the program from /scanlight, by Emscripten.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
readonly here=$PWD prefix=/prefix flags=(-O2 -msimd128 -pthread -fwasm-exceptions)  # others go by way of JavaScript, which knows no vectors

# Not /usr/include itself: it has another C library.
gather_headers() {
    mkdir -p $prefix/include $prefix/lib/cmake/OpenMesh $prefix/share
    (cd /usr/include && cp -rs "$PWD"/{hwy,glm,stb,gtest,polyclipping,png*.h,gif*.h,j*.h,z*.h,libdeflate.h} $prefix/include)
    cp /usr/include/*-linux-gnu/jconfig.h $prefix/include
    cp -r /usr/share/cmake $prefix/share
}

build_openmesh() {
    local core=/openmesh/src/OpenMesh/Core
    mkdir -p /objects
    (cd /objects && em++ "${flags[@]}" -I/openmesh/src -c $core/{Mesh,System,Utils}/*.cc &&
        emar rcs $prefix/lib/libOpenMeshCore.a ./*.o)
    cp "$here/wasm_openmesh.cmake" $prefix/lib/cmake/OpenMesh/OpenMeshConfig.cmake
}

build_clipper() {
    em++ "${flags[@]}" -I$prefix/include/polyclipping -c /clipper/clipper.cpp -o /objects/clipper.o
    emar rcs $prefix/lib/libpolyclipping.a /objects/clipper.o
}

# The program reads and writes no meshes and no pictures: libraries for those may be empty.
configure() {
    local library empty=()
    emar rcs $prefix/lib/libempty.a
    for library in PNG JPEG GIF ZLIB LIBDEFLATE GTEST GTEST_MAIN; do
        empty+=("-D${library}_LIBRARY=$prefix/lib/libempty.a")
    done
    # Readers of 32-bit machines get warnings: files may be larger than memory.
    emcmake cmake -S /scanlight -B /build -G Ninja --compile-no-warning-as-error -DCMAKE_BUILD_TYPE=None \
        -DSCANLIGHT_APPS=OFF -DCMAKE_FIND_ROOT_PATH=$prefix -DCMAKE_PREFIX_PATH=/ "${empty[@]}" \
        -DCMAKE_CXX_FLAGS="${flags[*]} -include $here/wasm_from_chars.h" \
        -DCMAKE_EXE_LINKER_FLAGS="-sNODERAWFS -sPROXY_TO_PTHREAD -sEXIT_RUNTIME -sALLOW_MEMORY_GROWTH"
}

if [[ ! -d $prefix/lib/cmake/OpenMesh ]]; then
    gather_headers
    build_openmesh
    build_clipper
fi
configure
cmake --build /build --target scanlight-same-bits
