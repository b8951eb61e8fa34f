#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "shading/perception.h"

namespace scanlight::demo {

namespace {

/// A row of a picture, as far as it shows the surface.
struct Profile {
    std::string key;
    Stretch stretch;
    std::vector<double> light;
    std::vector<double> change;  // from the pixel before
    std::vector<double> added;   // to it by an eye with lateral inhibition
};

std::string arguments(const std::string& shading, const Settings& settings) {
    const int slices = static_cast<int>(settings.at("slices"));
    return "sphere:" + std::to_string(slices) + "," + std::to_string(slices / 2) +
           " --view 0,10 --illumination lambert --material kd=0.9 --ambient 0.05 --light "
           "-0.35,0.4,1 --shading " +
           shading;
}

std::vector<double> changes(const std::vector<double>& light) {
    std::vector<double> result(light.size(), 0.0);
    for (std::size_t x = 1; x < light.size(); ++x)
        result[x] = light[x] - light[x - 1];
    return result;
}

/// The outer sixths are left out: towards the outline all faces crowd together.
Stretch inner(const Stretch& stretch) {
    const int margin = 1 + (stretch.end - stretch.begin) / 6;
    if (stretch.end - stretch.begin <= 2 * margin) return {};
    return {stretch.begin + margin, stretch.end - margin};
}

Profile profile_of(const std::string& key, const Stage& stage, int y) {
    const raster::Framebuffer picture = stage.framebuffer();
    Profile profile{
        key, inner(surface_of_row(picture.depth, y)), intensities(picture.color, y), {}, {}};
    profile.change = changes(profile.light);
    profile.added = shading::lateral_inhibition(std::span<const double>(profile.light));
    for (std::size_t x = 0; x < profile.added.size(); ++x)
        profile.added[x] -= profile.light[x];
    return profile;
}

/// The largest change of the slope from one pixel to the next.
double sharpest_bend(const Profile& profile) {
    double most = 0.0;
    for (int x = profile.stretch.begin + 1; x < profile.stretch.end; ++x) {
        const auto i = static_cast<std::size_t>(x);
        most = std::max(most, std::abs(profile.change[i] - profile.change[i - 1]));
    }
    return most;
}

/// How much more the eye sees than there is, at most.
double overshoot(const Profile& profile) {
    double most = 0.0;
    for (int x = profile.stretch.begin; x < profile.stretch.end; ++x) {
        const auto i = static_cast<std::size_t>(x);
        most = std::max(most, std::abs(profile.added[i]));
    }
    return most;
}

Plot plot_of(const std::string& key, const Axis& y, int width,
             const std::array<Profile, 3>& profiles, std::vector<double> Profile::*values) {
    Plot plot{key, {"pixel-axis", 0, static_cast<double>(width)}, y, {}};
    for (const Profile& profile : profiles)
        plot.curves.push_back({profile.key, points_of(profile.*values, profile.stretch)});
    return plot;
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const int y = std::min(size.height - 1, static_cast<int>(settings.at("cut") * size.height));
    Screen screen;
    std::array<Profile, 3> profiles;
    const std::array<std::string, 3> shadings{"flat", "gouraud", "phong"};
    for (std::size_t i = 0; i < shadings.size(); ++i) {
        const Stage stage(arguments(shadings[i], settings), size);
        Panel panel = stage.panel(shadings[i], means);
        panel.marks.push_back(mark_along(y, size.width));
        screen.panels.push_back(std::move(panel));
        profiles[i] = profile_of(shadings[i], stage, y);
        screen.numbers.push_back({"bend-" + shadings[i], 1000.0 * sharpest_bend(profiles[i]), 2});
        screen.numbers.push_back({"overshoot-" + shadings[i], 1000.0 * overshoot(profiles[i]), 2});
    }
    screen.plots = {
        plot_of("light-plot", {"light-axis", 0, 1}, size.width, profiles, &Profile::light),
        plot_of("change-plot", {"change-axis", -0.02, 0.02}, size.width, profiles,
                &Profile::change),
        plot_of("added-plot", {"added-axis", -0.002, 0.002}, size.width, profiles,
                &Profile::added)};
    return screen;
}

}  // namespace

Lesson mach_bands_lesson() {
    return {"mach-bands",
            {{"cut", "y", Slider{0.1, 0.9, 9, 0.4, 3}, Moved::by_pictures, Pointed::row},
             {"slices", "", Slider{8, 24, 3, 16}}},
            {{"shading/perception.h", "lateral_inhibition"},
             {"render/flat.h", "FlatTechnique"},
             {"render/gouraud.h", "GouraudTechnique"}},
            draw};
}

}  // namespace scanlight::demo
