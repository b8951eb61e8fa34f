#!/usr/bin/env bash
# The same bits by the vectors of WebAssembly: compiled by Emscripten, and run by Node. `./dev matrix wasm` calls it as
# root: Debian 12's Highway has no doubles there, so all happens in a Debian 13 in a folder. Nothing else changes.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
readonly folder=$PWD/build/matrix/wasm root=$PWD/build/matrix/wasm/root

fail() { echo "wasm: $*" >&2; exit 1; }

within() { # FOLDER COMMAND...: nothing of this machine's environment goes along
    chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "${@:2}"
}

install_debian_13() {
    local packages=emscripten,cmake,ninja-build,libhwy-dev,libglm-dev,libstb-dev,libpng-dev,libjpeg-dev,libgif-dev,libdeflate-dev
    packages+=,libpolyclipping-dev,libgtest-dev,bzip2
    rm -rf --one-file-system "$root.part"  # something may be mounted there
    # Of OpenMesh and Clipper there must be the source; of the others headers will do.
    mmdebstrap --quiet --variant=apt --include="$packages" trixie "$root.part" \
        "deb http://deb.debian.org/debian trixie main" "deb-src http://deb.debian.org/debian trixie main" &&
        within "$root.part" bash -euc 'mkdir -p /openmesh; cd /openmesh
            apt-get update; apt-get source --tar-only openmesh; tar -xf *.orig.tar.* --strip-components=1
            mkdir -p /clipper; cd /clipper
            apt-get source --tar-only libpolyclipping; tar -xf *.orig.tar.*
            find . -path "*/cpp/clipper.cpp" -exec cp {} . \;' &&
        mv "$root.part" "$root"
}

copy_sources() {
    rm -rf "$root/scanlight"
    mkdir "$root/scanlight"
    cp -r --preserve=timestamps CMakeLists.txt mesh shading raster render tests "$root/scanlight"
}

((EUID == 0)) || fail "as root, please: it works in a folder by chroot"
command -v mmdebstrap >/dev/null || fail "mmdebstrap is missing; ./dev matrix wasm installs it on Debian 12"
mkdir -p "$folder"
[[ -d $root ]] || echo "Installing Debian 13 with Emscripten in $root: 2.5 GB" >&2
[[ -d $root ]] || install_debian_13 >"$folder/log" 2>&1 ||
    { tail -n 20 "$folder/log" >&2; fail "Debian 13 can't be had from the archive: is there a network?"; }
copy_sources
within "$root" bash /scanlight/tests/same_bits/wasm_build.sh >"$folder/log" 2>&1 ||
    { tail -n 50 "$folder/log" >&2; fail "can't be built"; }
printf '%-26s %s\n' "compiler, machine" "ways to draw | threads | scenes | result"
printf '%-26s ' "Emscripten -O2, Node"
within "$root" node /build/bin/scanlight-same-bits.js --check /scanlight/tests/same_bits/hashes.txt
