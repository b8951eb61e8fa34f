#include "apps/bench/spans.h"

#include <array>
#include <cstddef>
#include <iostream>

#include "apps/bench/agreement.h"
#include "apps/bench/medians.h"
#include "apps/bench/methods.h"
#include "apps/bench/shades.h"
#include "apps/bench/stopwatch.h"
#include "apps/bench/table.h"

namespace scanlight::bench {

namespace {

constexpr std::array span_lengths{4, 8, 16, 64, 256, 1024};

/// So many pixels that setting up the one triangle does not show, and so few that depth and
/// colour stay in the cache.
constexpr int pixels_a_triangle = 16384;

/// Twice as wide as its mean span, which grows from nothing at the top to all of it below. Every
/// corner lies off the pixels' centres, and no side is upright.
template <class Shade>
std::array<raster::ScreenVertex<Shade::attribute_count>, 3> triangle(int span_length) {
    const int width = 2 * span_length * raster::subpixels;
    const int height = pixels_a_triangle / span_length * raster::subpixels;
    std::array<raster::ScreenVertex<Shade::attribute_count>, 3> corners{
        {{width / 3, 0, raster::depth_far / 4, {}},
         {0, height, raster::depth_far / 2, {}},
         {width, height, raster::depth_far / 3, {}}}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t k = 0; k < Shade::attribute_count; ++k) {
            corners[i].attributes[k] = raster::attribute_from_float(Shade::corners[i][k]);
        }
    }
    return corners;
}

template <template <int> class Method, class Shade>
class TriangleJob {
public:
    explicit TriangleJob(int span_length)
        : corners_(triangle<Shade>(span_length)),
          target_({2 * span_length, pixels_a_triangle / span_length}) {}

    void clear() { target_.clear(); }
    void draw() { method_.draw(Corners<N>(corners_), target_, shade_); }
    int pixels() const { return pixels_a_triangle; }
    const raster::Plane<raster::Rgba>& picture() const { return target_.color; }

private:
    static constexpr int N = Shade::attribute_count;

    std::array<raster::ScreenVertex<N>, 3> corners_;
    Method<N> method_;
    Target<typename Method<N>::Z> target_;
    Shade shade_;
};

template <template <int> class Method, class Shade>
raster::Plane<raster::Rgba> picture(int span_length) {
    TriangleJob<Method, Shade> job(span_length);
    job.draw();
    return job.picture();
}

/// One row of the table: a method, at each length.
template <template <int> class Method, class Shade>
Row add_row(const std::string& group, const std::string& label) {
    Row row{group, label, {}};
    for (const int length : span_lengths) {
        row.keys.push_back(group + "/" + label + "/" + std::to_string(length));
        require_same_picture(row.keys.back(), picture<IncrementalEdges, Shade>(length),
                             picture<Method, Shade>(length), 0);
        measure(row.keys.back(), [length] { return TriangleJob<Method, Shade>(length); });
    }
    return row;
}

template <class Shade>
void add_methods(const std::string& group, Table& table) {
    table.rows.push_back(add_row<IncrementalEdges, Shade>(group, "incremental, edges and spans"));
    table.rows.push_back(add_row<IncrementalPlane, Shade>(group, "incremental, plane"));
    table.rows.push_back(add_row<DirectBilinear, Shade>(group, "bilinear formula a pixel"));
    table.rows.push_back(add_row<Barycentric, Shade>(group, "barycentric weights a pixel"));
}

}  // namespace

void compare_interpolations(int repetitions, const std::string& json_path) {
    Table table{"nanoseconds a pixel", {}, {}};
    for (const int length : span_lengths)
        table.columns.push_back(std::to_string(length));
    table.rows.push_back(add_row<BareLoop, Flat>("nothing interpolated", "bare loop"));
    add_methods<Flat>("flat: depth", table);
    add_methods<Gouraud>("Gouraud: depth and colour", table);
    add_methods<Phong>("Phong: depth and normal", table);
    const Medians medians = run_all(repetitions, json_path);
    std::cout << "Columns: mean length of the spans, in pixels. Medians of " << repetitions
              << " runs.\n";
    print(std::cout, table,
          [&](const std::string& key) { return medians[key].nanoseconds / medians[key].pixels; });
}

}  // namespace scanlight::bench
