#include "mesh/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "mesh/group.h"
#include "mesh/newell.h"

namespace scanlight::mesh {
namespace {

using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;

/// Twice the area of a, b, c; positive when they turn counter-clockwise.
double turning(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon without the coordinate in which its area vector is longest, counter-clockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> polygon) {
    const glm::dvec3 area = area_vector(polygon);
    const glm::dvec3 size = glm::abs(area);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const bool mirrored = area[drop] < 0.0;
    const int across = (drop + (mirrored ? 2 : 1)) % 3;
    const int up = (drop + (mirrored ? 1 : 2)) % 3;
    std::vector<glm::dvec2> flat;
    flat.reserve(polygon.size());
    for (const glm::vec3& p : polygon) {
        flat.emplace_back(p[across], p[up]);
    }
    return flat;
}

/// Points in square-ish cells, about one each, to find those near a triangle.
class PointGrid {
public:
    PointGrid(const std::vector<glm::dvec2>& points, std::vector<Index> members)
        : points_(points), members_(std::move(members)) {
        if (members_.empty()) return;
        side_ = static_cast<Index>(std::sqrt(static_cast<double>(members_.size())));
        measure();
        std::vector<Index> cells;
        for (const Index member : members_) {
            cells.push_back(row(points_[member].y) * side_ + column(points_[member].x));
        }
        cells_ = group_by(cells, std::size_t{side_} * side_);
    }

    /// Whether `test(point)` holds for a member in a cell that the triangle may touch.
    template <class Test>
    bool any_near(const std::array<glm::dvec2, 3>& triangle, Test&& test) const {
        if (members_.empty()) return false;
        const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        for (Index r = row(low); r <= row(high); ++r) {
            const auto [left, right] = reach(triangle, r);
            for (Index c = column(left); c <= column(right); ++c) {
                if (any_in(r * side_ + c, test)) return true;
            }
        }
        return false;
    }

private:
    void measure() {
        low_ = points_[members_[0]];
        glm::dvec2 high = low_;
        for (const Index member : members_) {
            low_ = glm::min(low_, points_[member]);
            high = glm::max(high, points_[member]);
        }
        cell_ = (high - low_) / static_cast<double>(side_);
    }

    Index place(double offset, double cell) const {
        if (!(offset > 0.0)) return 0;
        return offset >= cell * side_ ? side_ - 1
                                      : std::min(static_cast<Index>(offset / cell), side_ - 1);
    }
    Index row(double y) const { return place(y - low_.y, cell_.y); }
    Index column(double x) const { return place(x - low_.x, cell_.x); }

    /// A range of x that holds the triangle's part in a row; a cell more on each side, for
    /// rounding.
    std::array<double, 2> reach(const std::array<glm::dvec2, 3>& triangle, Index r) const {
        const double bottom = r == 0 ? -HUGE_VAL : low_.y + (r - 0.5) * cell_.y;
        const double top = r + 1 == side_ ? HUGE_VAL : low_.y + (r + 1.5) * cell_.y;
        double left = HUGE_VAL;
        double right = -HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2& a = triangle[i];
            const glm::dvec2& b = triangle[(i + 1) % 3];
            const double begin = std::clamp(a.y, bottom, top);
            const double end = std::clamp(b.y, bottom, top);
            if (std::max(a.y, b.y) < bottom || std::min(a.y, b.y) > top) continue;
            for (const double y : {begin, end}) {
                const double x = x_on_edge(a, b, y);
                left = std::min(left, x - cell_.x);
                right = std::max(right, x + cell_.x);
            }
        }
        return {left, right};
    }

    static double x_on_edge(const glm::dvec2& a, const glm::dvec2& b, double y) {
        if (y == a.y) return a.x;
        if (y == b.y) return b.x;
        return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    }

    template <class Test>
    bool any_in(Index cell, Test&& test) const {
        for (Index i = cells_.begin[cell]; i < cells_.begin[cell + 1]; ++i) {
            if (test(members_[cells_.items[i]])) return true;
        }
        return false;
    }

    const std::vector<glm::dvec2>& points_;
    std::vector<Index> members_;
    Index side_ = 0;  // cells a row, and rows
    glm::dvec2 low_{0.0};
    glm::dvec2 cell_{0.0};  // size of a cell
    Groups cells_;          // of places in members_
};

/// The corners not cut yet, as a ring, and the ears known among them.
class Clipper {
public:
    explicit Clipper(std::vector<glm::dvec2> points)
        : points_(std::move(points)),
          next_(points_.size()),
          previous_(points_.size()),
          cut_(points_.size(), false),
          blocker_(points_.size(), false),
          version_(points_.size(), 0),
          left_(static_cast<Index>(points_.size())) {
        for (Index i = 0; i < left_; ++i) {
            next_[i] = i + 1 == left_ ? 0 : i + 1;
            previous_[i] = i == 0 ? left_ - 1 : i - 1;
        }
    }

    std::vector<Triangle> run() && {
        const PointGrid blockers(points_, find_blockers());
        // Beginning behind the first corner cuts a quad by the diagonal from the first.
        Index corner = 0;
        for (Index i = 0; i < points_.size(); ++i) {
            corner = next_[corner];
            queue_ear(corner, blockers);
        }
        while (left_ > 3) {
            cut(next_ear(), blockers);
        }
        const Index last = first_left();
        triangles_.push_back({last, next_[last], previous_[last]});
        return std::move(triangles_);
    }

private:
    struct Ear {
        Index corner;
        Index version;
    };

    double turn_at(Index i) const {
        return turning(points_[previous_[i]], points_[i], points_[next_[i]]);
    }

    /// Corners that don't turn left can lie in the way of an ear; no others need be asked.
    std::vector<Index> find_blockers() {
        std::vector<Index> blockers;
        for (Index i = 0; i < points_.size(); ++i) {
            blocker_[i] = !(turn_at(i) > 0.0);
            if (blocker_[i]) blockers.push_back(i);
        }
        return blockers;
    }

    bool is_ear(Index i, const PointGrid& blockers) const {
        if (!(turn_at(i) > 0.0)) return false;
        const std::array triangle{points_[previous_[i]], points_[i], points_[next_[i]]};
        return !blockers.any_near(triangle, [&](Index p) { return blocks(p, triangle); });
    }

    /// Whether p lies in the triangle or on its rim. A corner in the same place as one of the
    /// triangle's (there, or where the polygon touches itself) does not.
    bool blocks(Index p, const std::array<glm::dvec2, 3>& triangle) const {
        if (!blocker_[p] || cut_[p]) return false;
        const glm::dvec2& point = points_[p];
        const auto& [a, b, c] = triangle;
        if (point == a || point == b || point == c) return false;
        return turning(a, b, point) >= 0.0 && turning(b, c, point) >= 0.0 &&
               turning(c, a, point) >= 0.0;
    }

    void queue_ear(Index i, const PointGrid& blockers) {
        if (is_ear(i, blockers)) ears_.push_back({i, version_[i]});
    }

    /// First come, first cut: that keeps the triangles of a round polygon fat.
    Index next_ear() {
        while (first_ear_ < ears_.size()) {
            const Ear ear = ears_[first_ear_++];
            if (!cut_[ear.corner] && version_[ear.corner] == ear.version) return ear.corner;
        }
        return makeshift_ear();
    }

    /// No ear is left: the polygon crosses itself, or only flat corners remain.
    Index makeshift_ear() {
        for (Index tried = 0; tried < makeshift_tries; ++tried) {
            makeshift_ = remaining_after(makeshift_);
            if (!blocker_[makeshift_]) return makeshift_;
        }
        return makeshift_;
    }

    Index remaining_after(Index i) const {
        do
            i = next_[i];
        while (cut_[i]);
        return i;
    }

    void cut(Index ear, const PointGrid& blockers) {
        const Index before = previous_[ear];
        const Index after = next_[ear];
        triangles_.push_back({before, ear, after});
        cut_[ear] = true;
        --left_;
        next_[before] = after;
        previous_[after] = before;
        for (const Index neighbour : {before, after}) {
            blocker_[neighbour] = blocker_[neighbour] && !(turn_at(neighbour) > 0.0);
            ++version_[neighbour];
            queue_ear(neighbour, blockers);
        }
    }

    Index first_left() const {
        return static_cast<Index>(std::ranges::find(cut_, false) - cut_.begin());
    }

    /// How far to look for a corner to cut when no ear is left: bounds the time for a polygon that
    /// is one big knot.
    static constexpr Index makeshift_tries = 256;

    std::vector<glm::dvec2> points_;
    std::vector<Index> next_, previous_;
    std::vector<bool> cut_;
    std::vector<bool> blocker_;
    std::vector<Index> version_;  // counts the changes of a corner's neighbours
    std::vector<Ear> ears_;       // a queue from first_ear_ on; those of old versions don't count
    Index left_;                  // corners not cut yet
    std::size_t first_ear_ = 0;
    Index makeshift_ = 0;
    std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> cut_ears(std::span<const glm::vec3> polygon) {
    if (polygon.size() < 3) return {};
    if (polygon.size() == 3) return {{0, 1, 2}};
    return Clipper(flattened(polygon)).run();
}

}  // namespace scanlight::mesh
