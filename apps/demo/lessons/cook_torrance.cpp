#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/picked_point.h"
#include "apps/demo/settings.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/text_table.h"
#include "apps/scene/parse.h"
#include "mesh/trigonometry.h"
#include "shading/cook_torrance.h"
#include "shading/phong.h"
#include "shading/reflection.h"

namespace scanlight::demo {

namespace {

using shading::FacetDistribution;
using shading::FacetSlopes;
using shading::Vec3;

const std::vector<std::string> metals{"copper", "gold", "silver"};
constexpr double degree = mesh::pi / 180.0;
const std::string lights = " --ambient 0.05 --light -0.7,0.7,1,#999 --light 1,0.2,0.4,#555";

/// By Phong, of the colour that the metal mirrors straight back.
std::string plastic_arguments(const std::string& metal) {
    const std::string color = metal == "copper" ? "#b4573a"
                              : metal == "gold" ? "#c89a3c"
                                                : "#a8a8a4";
    return "teapot:6 --illumination phong --material \"kd=" + color + " ks=0.5 n=30\"" + lights;
}

std::string metal_arguments(const std::string& metal, double m) {
    return "teapot:6 --illumination cook-torrance --metal " + metal + " --roughness " +
           apps::fixed(m, 2) + lights;
}

shading::Reflectance reflectance_of(const std::string& metal) {
    const shading::Metal& measured = apps::parse_metal(metal);
    return shading::metal(measured.n, measured.k);
}

template <class Value>
Curve curve(const std::string& key, double low_deg, double high_deg, Value&& value) {
    Curve result{key, {}};
    const double step = (high_deg - low_deg) / 60.0;
    for (int i = 0; i <= 60; ++i) {
        const double angle = low_deg + step * i;
        result.points.emplace_back(angle, value(mesh::cosine(angle * degree)));
    }
    return result;
}

Plot facets_plot(double m) {
    double most = 0.0;
    const auto density = [&](const std::string& key, FacetDistribution distribution) {
        const FacetSlopes slopes(distribution, m);
        most = std::max(most, shading::facet_density(1.0, slopes));
        return curve(key, 0, 90, [&](double c) { return shading::facet_density(c, slopes); });
    };
    const std::vector<Curve> curves{density("beckmann", FacetDistribution::beckmann),
                                    density("gauss", FacetDistribution::gauss),
                                    density("cosine", FacetDistribution::cosine)};
    return {"d-plot", {"alpha-axis", 0, 90}, {"d-axis", 0, 1.1 * most}, curves};
}

/// Where light and eye are at one angle, on either side of N, and 30° before the eye's.
Plot open_plot() {
    const auto share = [](double between_deg) {
        return [between_deg](double c) {
            const double half = mesh::cosine(0.5 * between_deg * degree);
            const double lean =
                mesh::cosine(std::acos(std::min(1.0, c)) - 0.5 * between_deg * degree);
            const double light = mesh::cosine(std::acos(std::min(1.0, c)) - between_deg * degree);
            return shading::facets_open(lean, std::max(0.0, light), std::max(c, 1e-4), half);
        };
    };
    return {"g-plot",
            {"view-axis", 0, 90},
            {"g-axis", 0, 1.05},
            {curve("between-0", 0, 90, share(0.0)), curve("between-60", 0, 90, share(60.0)),
             curve("between-120", 30, 90, share(120.0))}};
}

Plot fresnel_plot(const std::string& metal) {
    const shading::Reflectance reflectance = reflectance_of(metal);
    const shading::Reflectance plastic = shading::dielectric(1.5);
    const auto channel = [&](const std::string& key, int k) {
        return curve(key, 0, 90, [&reflectance, k](double c) {
            return shading::reflectance_at(std::max(0.0, c), reflectance)[k];
        });
    };
    return {"f-plot",
            {"theta-axis", 0, 90},
            {"f-axis", 0, 1.05},
            {channel("red", 0), channel("green", 1), channel("blue", 2),
             curve("plastic", 0, 90, [&plastic](double c) {
                 return shading::reflectance_at(std::max(0.0, c), plastic).x;
             })}};
}

/// In the plane of N and L, a direction at this angle from N.
Vec3<double> at_angle(double angle_deg) {
    return {mesh::sine(angle_deg * degree), mesh::cosine(angle_deg * degree), 0.0};
}

/// What leaves the surface towards each side, as far from the middle as it is bright. The light
/// comes from the left; the brightest is 1.
template <class Bright>
Curve lobe(const std::string& key, Bright&& bright) {
    Curve result{key, {}};
    double most = 0.0;
    for (int angle = -89; angle <= 89; ++angle)
        most = std::max(most, bright(at_angle(angle)));
    for (int angle = -89; angle <= 89; ++angle) {
        const double r = most > 0.0 ? bright(at_angle(angle)) / most : 0.0;
        result.points.push_back(r * glm::dvec2(at_angle(angle)));
    }
    return result;
}

/// From the middle to the rim.
Curve direction(const std::string& key, const Vec3<double>& towards) {
    return {key, {{0.0, 0.0}, glm::dvec2(towards)}};
}

Plot lobe_plot(const std::string& metal, double m, double light_deg) {
    const Vec3<double> N(0.0, 1.0, 0.0);
    const Vec3<double> L = at_angle(-light_deg);
    const FacetSlopes slopes(FacetDistribution::beckmann, m);
    const shading::Reflectance reflectance = reflectance_of(metal);
    return {"lobe-plot",
            {"lobe-axis", -1.37, 1.37},  // so that a plot's angles are true
            {"lobe-up", 0, 1.1},
            {lobe("metal",
                  [&](const Vec3<double>& V) {
                      return shading::cook_torrance(N, L, V, slopes, reflectance).x;
                  }),
             lobe("plastic",
                  [&](const Vec3<double>& V) {
                      return shading::phong(N, L, V, shading::Exponent(30));
                  }),
             direction("to-light", L), direction("normal", N),
             direction("mirrored", shading::reflected(L, N))}};
}

/// A number for each channel.
void add_channels(std::vector<Number>& numbers, const std::string& key, const Vec3<double>& value) {
    numbers.push_back({key + "-red", value.x, 3});
    numbers.push_back({key + "-green", value.y, 3});
    numbers.push_back({key + "-blue", value.z, 3});
}

/// All that R_s can be worked out from, and R_s.
std::vector<Number> numbers_of(const Directions& at, const std::string& metal, double m) {
    const auto& [N, L, V, H, R] = at;
    const FacetSlopes slopes(FacetDistribution::beckmann, m);
    const shading::Reflectance reflectance = reflectance_of(metal);
    const double NL = shading::dot(N, L);
    const double NV = shading::dot(N, V);
    const double NH = shading::dot(N, H);
    const double VH = shading::dot(V, H);
    std::vector<Number> numbers{{"n-l", NL, 3},
                                {"n-v", NV, 3},
                                {"n-h", NH, 3},
                                {"v-h", VH, 3},
                                {"d", shading::facet_density(NH, slopes), 3},
                                {"g", shading::facets_open(NH, NL, NV, VH), 3}};
    add_channels(numbers, "f", shading::reflectance_at(VH, reflectance));
    add_channels(numbers, "r", shading::cook_torrance(N, L, V, slopes, reflectance) / NL);
    return numbers;
}

Pixel pixel_of(const Settings& settings, raster::Viewport size) {
    return {std::min(static_cast<int>(settings.at("x") * size.width), size.width - 1),
            std::min(static_cast<int>(settings.at("y") * size.height), size.height - 1)};
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const std::string& metal = word_of(metals, settings, "metal");
    const double m = settings.at("m");
    const Stage stage(metal_arguments(metal, m), size);
    const auto [pixel, at] = picked_point(stage, pixel_of(settings, size));
    const double light_deg =
        std::acos(std::clamp(shading::dot(at.N, at.L), -1.0, 1.0)) * 180.0 / mesh::pi;
    Screen screen{
        {panel_of("plastic", plastic_arguments(metal), size, means), stage.panel("metal", means)},
        numbers_of(at, metal, m),
        {facets_plot(m), open_plot(), fresnel_plot(metal), lobe_plot(metal, m, light_deg)}};
    screen.panels.back().marks = {mark_at(pixel)};
    return screen;
}

}  // namespace

Lesson cook_torrance_lesson() {
    return {"cook-torrance",
            {{"m", "m", Slider{0.1, 0.6, 6, 0.3, 2}},
             {"metal", "", Choice{metals, 1}},
             // In the highlight at first.
             {"x", "x", Slider{0.0, 1.0, 101, 0.28, 3}, Moved::by_pointing, Pointed::column},
             {"y", "y", Slider{0.0, 1.0, 101, 0.45, 3}, Moved::by_pointing, Pointed::row}},
            {{"shading/cook_torrance.h", "cook_torrance"},
             {"shading/microfacets.h", "beckmann_facets"},
             {"shading/microfacets.h", "facets_open"},
             {"shading/fresnel.h", "metal_share"}},
            draw};
}

}  // namespace scanlight::demo
