#!/usr/bin/env bash
# The same bits by NEON: cross-compiled for arm64, and run by QEMU. `./dev matrix neon` installs the tools first.
# The arm64 libraries are unpacked into a folder: the packages of this machine stay as they are.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
readonly folder=$PWD/build/matrix/neon
export SCANLIGHT_SYSROOT=$folder/root

fail() { echo "neon: $*" >&2; exit 1; }

unpack_libraries() {
    local packages=libopenmesh-dev,libhwy-dev,libglm-dev,libstb-dev,libpng-dev,libjpeg-dev,libgif-dev,libdeflate-dev,libpolyclipping-dev,libgtest-dev
    local part=$SCANLIGHT_SYSROOT.part
    rm -rf "$part"
    mkdir -p "$part"
    echo "Unpacking libraries of Debian 12 for arm64 in $SCANLIGHT_SYSROOT: 550 MB" >&2
    mmdebstrap --quiet --variant=extract --arch=arm64 --include="$packages" bookworm - |
        tar -x -C "$part" --no-same-owner --exclude=./dev &&
        mv "$part" "$SCANLIGHT_SYSROOT"
}

build() {
    cmake -S . -B "$folder" -G Ninja --toolchain tests/same_bits/neon.cmake -DCMAKE_BUILD_TYPE=None \
        -DCMAKE_CXX_FLAGS=-O2 -DSCANLIGHT_APPS=OFF &&
        cmake --build "$folder" --target scanlight-same-bits
}

for tool in mmdebstrap aarch64-linux-gnu-g++ qemu-aarch64 cmake ninja; do
    command -v "$tool" >/dev/null || fail "$tool is missing; ./dev matrix neon installs it on Debian 12"
done
[[ -d $SCANLIGHT_SYSROOT ]] || unpack_libraries ||
    fail "arm64 libraries can't be had from Debian's archive: is there a network?"
build >"$folder/log" 2>&1 || { tail -n 50 "$folder/log" >&2; fail "can't be built"; }
printf '%-26s %s\n' "compiler, machine" "ways to draw | threads | scenes | result"
printf '%-26s ' "g++ -O2, arm64 by QEMU"
qemu-aarch64 -L "$SCANLIGHT_SYSROOT" "$folder/bin/scanlight-same-bits" --check tests/same_bits/hashes.txt
