#include "render/polygon_clipping.h"

#include <algorithm>
#include <iterator>

#include <polyclipping/clipper.hpp>

namespace scanlight::render {

namespace {

namespace clipper = ClipperLib;

clipper::Path path_of(const GridOutline& outline) {
    clipper::Path path;
    path.reserve(outline.size());
    for (const GridPoint& point : outline)
        path.emplace_back(point.x, point.y);
    return path;
}

/// All the same way round: by the winding rule, outlines of two ways cancel.
clipper::Path counter_clockwise(clipper::Path path) {
    if (!clipper::Orientation(path)) std::ranges::reverse(path);
    return path;
}

GridOutline outline_of(const clipper::Path& path) {
    GridOutline outline;
    outline.reserve(path.size());
    for (const clipper::IntPoint& point : path)
        outline.push_back({point.X, point.Y});
    return outline;
}

GridRegion clipped(const GridOutline& polygon, const std::vector<GridOutline>& others,
                   clipper::ClipType how) {
    clipper::Clipper clip;
    clip.AddPath(path_of(polygon), clipper::ptSubject, true);
    for (const GridOutline& other : others)
        clip.AddPath(counter_clockwise(path_of(other)), clipper::ptClip, true);
    clipper::Paths result;
    clip.Execute(how, result, clipper::pftNonZero, clipper::pftNonZero);
    GridRegion region;
    std::ranges::transform(result, std::back_inserter(region), outline_of);
    return region;
}

}  // namespace

GridRegion uncovered(const GridOutline& polygon, const std::vector<GridOutline>& others) {
    return clipped(polygon, others, clipper::ctDifference);
}

GridRegion covered(const GridOutline& polygon, const std::vector<GridOutline>& others) {
    return clipped(polygon, others, clipper::ctIntersection);
}

double signed_area(const GridOutline& outline) {
    return clipper::Area(path_of(outline));
}

}  // namespace scanlight::render
