#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "mesh/texture_map.h"

namespace scanlight::mesh {

// The words of MTL for what `TextureMap` holds; reader and writer share them. Where there are two
// for one thing, the first is written.

inline constexpr std::pair<std::string_view, MapUse> map_statements[] = {
    {"map_Ka", MapUse::ambient},  {"map_Kd", MapUse::diffuse},  {"map_Ks", MapUse::specular},
    {"map_Ke", MapUse::emission}, {"map_Ns", MapUse::exponent}, {"map_d", MapUse::opacity},
    {"bump", MapUse::bump},       {"map_bump", MapUse::bump},   {"norm", MapUse::normal}};

/// Of refl -type.
inline constexpr std::pair<std::string_view, MapUse> reflection_types[] = {
    {"sphere", MapUse::sphere},           {"cube_top", MapUse::cube_top},
    {"cube_bottom", MapUse::cube_bottom}, {"cube_front", MapUse::cube_front},
    {"cube_back", MapUse::cube_back},     {"cube_left", MapUse::cube_left},
    {"cube_right", MapUse::cube_right}};

/// Of -imfchan.
inline constexpr std::pair<std::string_view, MapChannel> channel_letters[] = {
    {"r", MapChannel::red},   {"g", MapChannel::green},     {"b", MapChannel::blue},
    {"m", MapChannel::matte}, {"l", MapChannel::luminance}, {"z", MapChannel::depth}};

/// The first word for `value`; empty if there is none.
template <class Value, std::size_t n>
constexpr std::string_view word_for(const std::pair<std::string_view, Value> (&words)[n],
                                    Value value) {
    for (const auto& [word, meaning] : words) {
        if (meaning == value) return word;
    }
    return {};
}

/// "map_Kd", "bump", "refl -type sphere": the statement that names a map of this use.
std::string statement_for(MapUse use);

}  // namespace scanlight::mesh
