#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/shadow_report.h"
#include "apps/scanlight/text_table.h"
#include "raster/compare.h"
#include "render/draw.h"
#include "render/frame.h"
#include "render/shadows.h"
#include "render/volume_lines.h"

namespace scanlight::demo {

namespace {

// The eye's way into the shadow of a cube, along its view.
constexpr glm::dvec3 outside{3.6, 0.6, -3.4};
constexpr glm::dvec3 inside{1.0, -0.4, -3.0};

constexpr double floor_height = -1.0;

const std::string light = " --light point:-1,3,2.5";

glm::dvec3 eye_of(const Settings& settings) {
    return outside + (inside - outside) * settings.at("eye");
}

std::string arguments(const Settings& settings, const std::string& shadows) {
    const glm::dvec3 eye = eye_of(settings);
    return "cube --floor --eye " + apps::fixed(eye.x, 3) + "," + apps::fixed(eye.y, 3) + "," +
           apps::fixed(eye.z, 3) + " --target 1.4,-0.8,0.5 --fov 70" + light + " --shadows " +
           shadows;
}

apps::PixelShadow shadow_at(const Stage& stage, const Pixel& pixel) {
    const auto& settings = stage.options().settings;
    const auto size = stage.options().size;
    const auto depth = render::draw_depth(stage.scene(), settings, size).framebuffer.depth;
    return {pixel.x, pixel.y, 0, depth.at(pixel.x, pixel.y),
            render::shadow_crossings(stage.scene(), settings, 0, size, pixel.x, pixel.y)};
}

std::string depth_text(raster::Depth depth) {
    if (depth >= raster::depth_clear) return "∞";
    return apps::fixed(std::max(0.0f, raster::ndc_from_depth(depth)), 5);
}

std::string part_key(render::VolumePart part) {
    switch (part) {
        case render::VolumePart::cap:
            return "{{cap}}";
        case render::VolumePart::side:
            return "{{side}}";
        case render::VolumePart::end:
            return "{{end}}";
        case render::VolumePart::near_cut:
            break;
    }
    return "{{near-cut}}";
}

std::string signed_text(std::int32_t number) {
    return (number > 0 ? "+" : "") + std::to_string(number);
}

/// The faces that the ray goes through, with the surface among them.
Table crossings_table(const apps::PixelShadow& shadow) {
    Table table{"crossings", {"{{face}}", "{{depth}}", "{{enters}}", "{{sum}}"}, {}};
    std::int32_t sum = 0;
    bool behind = false;
    for (const auto& crossing : shadow.crossings) {
        if (!behind && crossing.depth >= shadow.depth) {
            table.rows.push_back(
                {"{{surface}}", depth_text(shadow.depth), "", std::to_string(sum)});
            behind = true;
        }
        sum += crossing.entered;
        table.rows.push_back({part_key(crossing.part), depth_text(crossing.depth),
                              signed_text(crossing.entered), std::to_string(sum)});
    }
    if (!behind)
        table.rows.push_back({"{{surface}}", depth_text(shadow.depth), "", std::to_string(sum)});
    return table;
}

/// From the eye to the surface, as if the eye were in no volume.
std::int32_t zpass_from_zero(const apps::PixelShadow& shadow) {
    std::int32_t sum = 0;
    for (const auto& crossing : shadow.crossings)
        sum += crossing.part != render::VolumePart::near_cut && crossing.depth < shadow.depth
                   ? crossing.entered
                   : 0;
    return sum;
}

/// Where a point of the world is in a picture, in pixels.
glm::dvec2 pixel_of(const Stage& stage, const glm::dvec3& point) {
    const auto size = stage.options().size;
    const auto frame = render::frame_of(stage.scene(), stage.options().settings.distances, size);
    const glm::dvec4 clip = frame.clip_from_world * glm::dvec4(point, 1.0);
    return {0.5 * size.width * (1.0 + clip.x / clip.w),
            0.5 * size.height * (1.0 - clip.y / clip.w)};
}

/// The scene from above, with the outlines of what is lit; over it the ghost of the cube's volume,
/// and the eye.
Panel overview(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const Stage stage("cube --floor --eye 9,6.5,-7 --target 1,-0.6,-1.2 --fov 42" + light +
                          " --shadows polygons --show details",
                      size);
    Panel panel = stage.panel("details", means);
    const auto ghost =
        render::volume_lines(stage.scene(), stage.options().settings, 0, 0, stage.options().size);
    for (const render::PictureLine& line : ghost)
        panel.marks.push_back({line.from, line.to});
    const glm::dvec3 eye = eye_of(settings);
    const glm::dvec2 seen = pixel_of(stage, eye);
    panel.marks.push_back({seen, seen});
    panel.marks.push_back({seen, pixel_of(stage, {eye.x, floor_height, eye.z})});
    return panel;
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const Pixel pixel{static_cast<int>(settings.at("x") * size.width),
                      static_cast<int>(settings.at("y") * size.height)};
    const Stage by_zfail(arguments(settings, "zfail"), size);
    const Panel wrong =
        panel_of("zpass-from-zero", arguments(settings, "zpass-from-zero"), size, means);
    const Panel right = by_zfail.panel("zfail", means);
    const apps::PixelShadow shadow = shadow_at(by_zfail, pixel);
    const auto differing = raster::compare(wrong.picture, right.picture).different_pixels;
    Screen screen{{wrong, right,
                   panel_of("stencil", arguments(settings, "zfail --show stencil"), size, means),
                   overview(settings, size, means)},
                  {{"count-zpass", static_cast<double>(zpass_from_zero(shadow))},
                   {"count-zfail", static_cast<double>(apps::zfail_of(shadow))},
                   {"wrong-pixels", static_cast<double>(differing)}},
                  {},
                  {crossings_table(shadow)}};
    for (std::size_t i = 0; i < 3; ++i)
        screen.panels[i].marks = {mark_at(pixel)};
    return screen;
}

}  // namespace

Lesson shadow_volumes_lesson() {
    return {"shadow-volumes",
            {{"eye", "", Slider{0, 1, 6, 0, 2}},
             {"x", "x", Slider{0.1, 0.9, 9, 0.3, 3}, Moved::by_pictures, Pointed::column},
             // At first the row lies on lit floor and dark floor.
             {"y", "y", Slider{0.01, 0.99, 99, 0.51, 3}, Moved::by_pointing, Pointed::row}},
            {{"render/shadow_volume.h", "ShadowVolume"},
             {"mesh/silhouette.h", "SilhouetteFinder::from"},
             {"render/shadows.h", "count_shadows"},
             {"render/volume_lines.h", "volume_lines"},
             {"render/shadow_polygons.h", "detail_polygons"}},
            draw};
}

}  // namespace scanlight::demo
