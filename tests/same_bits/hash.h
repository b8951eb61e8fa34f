#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "render/draw.h"
#include "render/shadow_band.h"

namespace scanlight::same_bits {

/// FNV-1a with 64 bits: Fowler, Noll & Vo 1991.
class Hash {
public:
    void add(std::uint32_t word) {  // lowest byte first
        for (int shift = 0; shift < 32; shift += 8)
            value_ = (value_ ^ (word >> shift & 0xff)) * 0x100000001b3;
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Of the bits of all counts, a light after the other.
inline std::uint64_t hash_of(std::span<const render::Stencil> stencils) {
    Hash hash;
    for (const render::Stencil& stencil : stencils) {
        for (const std::int32_t count : stencil.values())
            hash.add(static_cast<std::uint32_t>(count));
    }
    return hash.value();
}

/// Of the bits of all colours, then of all depths.
inline std::uint64_t hash_of(const raster::Framebuffer& picture) {
    Hash hash;
    for (const raster::Rgba& color : picture.color.values()) {
        for (const float channel : {color.r, color.g, color.b, color.a})
            hash.add(std::bit_cast<std::uint32_t>(channel));
    }
    for (const raster::Depth depth : picture.depth.values())
        hash.add(static_cast<std::uint32_t>(depth));
    return hash.value();
}

}  // namespace scanlight::same_bits
