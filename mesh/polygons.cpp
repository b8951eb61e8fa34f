#include "mesh/polygons.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/newell.h"

namespace scanlight::mesh {
namespace {

/// Takes one face after another. The vectors besides `polygons` live from face to face only to keep
/// their memory.
class Collector {
public:
    explicit Collector(const PolygonSoup& soup) : soup_(soup) {
        polygons_.point.reserve(soup.corners.size());
        polygons_.face_of.reserve(soup.corners.size());
        polygons_.alone.reserve(soup.corners.size());
        polygons_.begin.reserve(soup.face_count() + 1);
        polygons_.soup_face.reserve(soup.face_count());
        polygons_.normals.reserve(soup.face_count());
    }

    void take(std::uint32_t face) {
        gather_corners(face);
        if (mark_repeated_points() < 3) {
            ++polygons_.few_corners;
            return;
        }
        const glm::dvec3 normal = unit_or_zero(area_vector(shape()));
        if (normal == glm::dvec3(0.0)) {
            ++polygons_.zero_area;
            return;
        }
        append(face, normal);
    }

    Polygons finish() && { return std::move(polygons_); }

private:
    std::uint32_t point(std::uint32_t corner) const { return soup_.corners[corner].position; }

    /// The corners of the face without those that repeat their neighbour's point.
    void gather_corners(std::uint32_t face) {
        corners_.clear();
        for (std::uint32_t c = soup_.face_begin[face]; c < soup_.face_begin[face + 1]; ++c) {
            if (corners_.empty() || point(corners_.back()) != point(c)) corners_.push_back(c);
        }
        while (corners_.size() > 1 && point(corners_.back()) == point(corners_.front())) {
            corners_.pop_back();
        }
    }

    /// Marks every corner whose point an earlier corner has, and counts the distinct points.
    std::size_t mark_repeated_points() {
        repeats_.assign(corners_.size(), false);
        if (corners_.size() <= 3) return corners_.size();  // neighbours all
        order_.resize(corners_.size());
        std::iota(order_.begin(), order_.end(), 0u);
        std::ranges::sort(order_, {},
                          [this](std::uint32_t i) { return std::pair(point(corners_[i]), i); });
        std::size_t distinct = 1;
        for (std::size_t i = 1; i < order_.size(); ++i) {
            const bool repeats = point(corners_[order_[i]]) == point(corners_[order_[i - 1]]);
            repeats_[order_[i]] = repeats;
            distinct += repeats ? 0 : 1;
        }
        return distinct;
    }

    std::span<const glm::vec3> shape() {
        shape_.clear();
        for (const std::uint32_t corner : corners_) {
            shape_.push_back(soup_.positions[point(corner)]);
        }
        return shape_;
    }

    void append(std::uint32_t face, const glm::dvec3& normal) {
        const auto drawn_face = static_cast<std::uint32_t>(polygons_.face_count());
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            note_soup_corner(corners_[i]);
            polygons_.point.push_back(point(corners_[i]));
            polygons_.face_of.push_back(drawn_face);
            polygons_.alone.push_back(repeats_[i]);
        }
        polygons_.begin.push_back(static_cast<std::uint32_t>(polygons_.point.size()));
        polygons_.soup_face.push_back(face);
        polygons_.normals.push_back(normal);
    }

    /// As long as none is left out, corners have the numbers that they had.
    void note_soup_corner(std::uint32_t soup_corner) {
        std::vector<std::uint32_t>& list = polygons_.soup_corners;
        const std::size_t corner = polygons_.corner_count();
        if (list.empty() && soup_corner == corner) return;
        if (list.empty()) {
            list.reserve(soup_.corners.size());
            list.resize(corner);
            std::iota(list.begin(), list.end(), 0u);
        }
        list.push_back(soup_corner);
    }

    const PolygonSoup& soup_;
    Polygons polygons_;
    std::vector<std::uint32_t> corners_;
    std::vector<bool> repeats_;
    std::vector<std::uint32_t> order_;
    std::vector<glm::vec3> shape_;
};

}  // namespace

Polygons drawable_polygons(const PolygonSoup& soup) {
    Collector collector(soup);
    for (std::uint32_t face = 0; face < soup.face_count(); ++face) {
        collector.take(face);
    }
    return std::move(collector).finish();
}

}  // namespace scanlight::mesh
