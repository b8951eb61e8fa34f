#include "mesh/mtl_text.h"

#include <array>
#include <charconv>

#include "mesh/mtl_words.h"

namespace scanlight::mesh {
namespace {

/// The shortest digits that give the same float.
std::string text(float number) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}

std::string text(const glm::vec3& v) {
    return text(v.x) + " " + text(v.y) + " " + text(v.z);
}

std::string option(const char* word, const std::string& value) {
    return std::string(" ") + word + " " + value;
}

std::string options_of(const TextureMap& map) {
    const TextureMap usual;
    std::string line;
    if (map.scale != usual.scale) line += option("-s", text(map.scale));
    if (map.offset != usual.offset) line += option("-o", text(map.offset));
    if (map.base != usual.base || map.gain != usual.gain)
        line += option("-mm", text(map.base) + " " + text(map.gain));
    if (map.bump != usual.bump) line += option("-bm", text(map.bump));
    if (map.clamped) line += option("-clamp", "on");
    if (!map.blended_u) line += option("-blendu", "off");
    if (!map.blended_v) line += option("-blendv", "off");
    if (map.channel)
        line += option("-imfchan", std::string(word_for(channel_letters, *map.channel)));
    return line;
}

std::string statements_of(const Material& m) {
    std::string lines = "newmtl " + m.name + "\n";
    const auto state = [&](const std::string& statement, const std::string& value) {
        lines += statement + " " + value + "\n";
    };
    state("Ka", text(m.ambient));
    state("Kd", text(m.diffuse));
    state("Ks", text(m.specular));
    state("Ke", text(m.emission));
    state("Tf", text(m.filter));
    state("Ns", text(m.exponent));
    state("Ni", text(m.refraction));
    state("d", text(m.opacity));
    state("illum", std::to_string(m.illumination));
    for (const auto& [use, map] : m.maps)
        lines += statement_for(use) + options_of(map) + " " + map.path + "\n";
    return lines;
}

}  // namespace

std::string mtl_text(std::span<const Material> materials) {
    std::string all;
    for (const Material& material : materials) {
        if (material.name.empty()) continue;
        all += (all.empty() ? "" : "\n") + statements_of(material);
    }
    return all;
}

}  // namespace scanlight::mesh
