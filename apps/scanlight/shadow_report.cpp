#include "apps/scanlight/shadow_report.h"

#include <algorithm>

#include "apps/scanlight/text_table.h"
#include "apps/scene/json.h"

namespace scanlight::apps {

namespace {

using render::ShadowCrossing;
using render::VolumePart;

bool is_before(const ShadowCrossing& crossing, const PixelShadow& shadow) {
    return crossing.depth < shadow.depth;
}

int zpass_of(const PixelShadow& shadow) {
    int sum = 0;
    for (const auto& crossing : shadow.crossings)
        sum += is_before(crossing, shadow) ? crossing.entered : 0;
    return sum;
}

std::string part_word(VolumePart part) {
    switch (part) {
        case VolumePart::cap:
            return "cap";
        case VolumePart::side:
            return "side";
        case VolumePart::end:
            return "end";
        case VolumePart::near_cut:
            return "near plane";
    }
    return "";
}

std::string place_of(const ShadowCrossing& crossing) {
    if (crossing.part == VolumePart::near_cut) return "";
    if (crossing.part == VolumePart::side)
        return "v" + std::to_string(crossing.edge.from) + "-v" + std::to_string(crossing.edge.to);
    return "polygon " + std::to_string(crossing.face + 1);
}

std::string depth_word(raster::Depth depth) {
    if (depth == raster::depth_beyond) return "infinity";
    return fixed(std::max(0.0f, raster::ndc_from_depth(depth)), 6);
}

std::string signed_number(int number) {
    return (number > 0 ? "+" : "") + std::to_string(number);
}

std::vector<std::string> row_of(const ShadowCrossing& crossing, const std::string& zpass,
                                const std::string& zfail) {
    return {part_word(crossing.part),
            std::to_string(crossing.object + 1),
            place_of(crossing),
            depth_word(crossing.depth),
            signed_number(crossing.entered),
            zpass,
            zfail};
}

/// z-pass runs down the table to the surface; z-fail, from the last row, up to it.
std::string crossings_text(const PixelShadow& shadow) {
    TextTable table({"face", "object", "of", "depth", "enters", "z-pass", "z-fail"});
    int zpass = 0;
    int zfail = zfail_of(shadow);
    bool behind = false;
    const auto add_surface = [&] {
        table.add_row({"surface", "", "", depth_word(shadow.depth), "", std::to_string(zpass),
                       std::to_string(zfail)});
        behind = true;
    };
    for (const auto& crossing : shadow.crossings) {
        if (!behind && !is_before(crossing, shadow)) add_surface();
        if (behind) {
            table.add_row(row_of(crossing, "", std::to_string(zfail)));
            zfail += crossing.entered;
        } else {
            zpass += crossing.entered;
            table.add_row(row_of(crossing, std::to_string(zpass), ""));
        }
    }
    if (!behind) add_surface();
    return table.text("  ");
}

Json crossing_json(const ShadowCrossing& crossing, const PixelShadow& shadow) {
    Json json{{"face", part_word(crossing.part)},
              {"object", crossing.object + 1},
              {"enters", crossing.entered},
              {"before_surface", is_before(crossing, shadow)}};
    if (crossing.part == VolumePart::side) {
        json["from_vertex"] = crossing.edge.from;
        json["to_vertex"] = crossing.edge.to;
    } else if (crossing.part != VolumePart::near_cut) {
        json["polygon"] = crossing.face + 1;
    }
    if (crossing.depth != raster::depth_beyond)
        json["depth"] = json_number(std::max(0.0f, raster::ndc_from_depth(crossing.depth)));
    return json;
}

Json shadow_json(const PixelShadow& shadow) {
    Json crossings = Json::array();
    for (const auto& crossing : shadow.crossings)
        crossings.push_back(crossing_json(crossing, shadow));
    return {{"light", shadow.light + 1},
            {"x", shadow.x},
            {"y", shadow.y},
            {"depth", json_number(raster::ndc_from_depth(shadow.depth))},
            {"crossings", crossings},
            {"zpass", zpass_of(shadow)},
            {"zfail", zfail_of(shadow)},
            {"in_shadow", zfail_of(shadow) != 0}};
}

}  // namespace

int zfail_of(const PixelShadow& shadow) {
    int sum = 0;
    for (const auto& crossing : shadow.crossings)
        sum -= is_before(crossing, shadow) ? 0 : crossing.entered;
    return sum;
}

std::string shadow_text(const PixelShadow& shadow) {
    return "Pixel " + std::to_string(shadow.x) + "," + std::to_string(shadow.y) + ", light " +
           std::to_string(shadow.light + 1) + ": " + (zfail_of(shadow) != 0 ? "in shadow" : "lit") +
           "\n\n" + crossings_text(shadow);
}

std::string shadows_json(const std::vector<PixelShadow>& shadows) {
    Json json = Json::array();
    for (const PixelShadow& shadow : shadows)
        json.push_back(shadow_json(shadow));
    return json_text(json);
}

}  // namespace scanlight::apps
