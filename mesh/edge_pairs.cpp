#include "mesh/edge_pairs.h"

#include <algorithm>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scanlight::mesh {
namespace {

using Corner = std::uint32_t;

/// A half-edge among others on one edge, by where its face lies around the edge.
struct Page {
    Corner half_edge;
    bool forward;        // from the lower point to the higher
    std::int64_t angle;  // about the edge, in units of a quarter turn / 2^20, roughly
};

/// Ascends with the angle of (x, y) from the x axis, counter-clockwise: 0 to 4 in a full turn.
double turn(double y, double x) {
    const double sum = (x < 0.0 ? -x : x) + (y < 0.0 ? -y : y);
    if (sum == 0.0) return 0.0;
    const double part = x / sum;  // 1, 0, -1, 0 at the quarters
    return y >= 0.0 ? 1.0 - part : 3.0 + part;
}

/// Two directions across an edge, the second a quarter turn about it from the first. They depend on
/// the edge alone.
struct EdgeFrame {
    glm::dvec3 first, second;

    explicit EdgeFrame(const glm::dvec3& edge) {
        const glm::dvec3 size = glm::abs(edge);
        const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                                : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                     : glm::dvec3(0, 0, 1);
        first = glm::cross(edge, axis);
        second = glm::cross(edge, first) / glm::max(glm::length(edge), 0x1p-500);
    }

    /// Rounded, so that faces in one place have one angle whatever corner they begin with.
    std::int64_t angle_of(const glm::dvec3& direction) const {
        const double quarters = turn(glm::dot(direction, second), glm::dot(direction, first));
        return static_cast<std::int64_t>(quarters * 0x1p20 + 0.5) % (4 << 20);
    }
};

class Pairing {
public:
    Pairing(const PolygonSoup& soup, const Polygons& polygons)
        : soup_(soup), polygons_(polygons), low_(polygons.corner_count()) {
        pairs_.partner.assign(polygons.corner_count(), EdgePairs::none);
        pairs_.left_over.assign(polygons.face_count(), false);
        pairs_.crowded.begin.push_back(0);
    }

    EdgePairs run() && {
        for (Corner c = 0; c < low_.size(); ++c) {
            low_[c] = std::min(origin(c), target(c));
        }
        Groups by_low = group_by(low_, soup_.positions.size());
        for (std::size_t point = 0; point < by_low.size(); ++point) {
            pair_at(by_low[point]);
        }
        return std::move(pairs_);
    }

private:
    std::uint32_t origin(Corner c) const { return polygons_.point[c]; }
    std::uint32_t target(Corner c) const { return polygons_.point[polygons_.next(c)]; }
    bool forward(Corner c) const { return origin(c) == low_[c]; }
    bool same_face(Corner a, Corner b) const {
        return polygons_.face_of[a] == polygons_.face_of[b];
    }
    bool stands_alone(Corner c) const {
        return polygons_.alone[c] || polygons_.alone[polygons_.next(c)];
    }

    /// The half-edges of all edges whose lower point is the same.
    void pair_at(std::span<const Corner> half_edges) {
        keyed_.clear();
        for (const Corner c : half_edges) {
            if (stands_alone(c)) continue;
            const std::uint64_t high = origin(c) ^ target(c) ^ low_[c];
            keyed_.push_back(high << 32 | c);
        }
        std::ranges::sort(keyed_);
        for (std::size_t begin = 0, end = 0; begin < keyed_.size(); begin = end) {
            while (end < keyed_.size() && keyed_[end] >> 32 == keyed_[begin] >> 32)
                ++end;
            pair_edge(begin, end);
        }
    }

    /// keyed_[begin, end) are the half-edges of one edge.
    void pair_edge(std::size_t begin, std::size_t end) {
        if (end - begin == 1) return;
        const auto a = static_cast<Corner>(keyed_[begin]);
        const auto b = static_cast<Corner>(keyed_[begin + 1]);
        if (end - begin == 2 && forward(a) != forward(b)) {
            if (!same_face(a, b)) join(a, b);
            return;
        }
        std::vector<Corner> half_edges;
        for (std::size_t i = begin; i < end; ++i) {
            half_edges.push_back(static_cast<Corner>(keyed_[i]));
        }
        pair_crowded(half_edges);
    }

    void pair_crowded(std::span<const Corner> half_edges) {
        std::vector<Page> pages = pages_around(half_edges);
        match_wedges(pages);
        note_left_over(half_edges);
        Groups& crowded = pairs_.crowded;
        crowded.items.insert(crowded.items.end(), half_edges.begin(), half_edges.end());
        crowded.begin.push_back(static_cast<std::uint32_t>(crowded.items.size()));
    }

    /// In the order in which a turn to the back of the forward faces meets them. At one angle the
    /// backward ones come first (a wedge between faces in one place is a full turn), and the
    /// earliest face stands where it will be matched.
    std::vector<Page> pages_around(std::span<const Corner> half_edges) const {
        const Corner any = half_edges[0];
        const glm::dvec3 low = soup_.positions[low_[any]];
        const glm::dvec3 high = soup_.positions[origin(any) ^ target(any) ^ low_[any]];
        const EdgeFrame frame(high - low);
        std::vector<Page> pages;
        for (const Corner c : half_edges) {
            const glm::dvec3 along = forward(c) ? high - low : low - high;
            const glm::dvec3 inward = glm::cross(polygons_.normals[polygons_.face_of[c]], along);
            pages.push_back({c, forward(c), frame.angle_of(inward)});
        }
        std::ranges::sort(pages, {}, [](const Page& page) {
            const std::int64_t half_edge = page.half_edge;
            return std::tuple(-page.angle, page.forward, page.forward ? -half_edge : half_edge);
        });
        return pages;
    }

    /// Like brackets in a circle: a forward face opens a wedge, a backward one closes the last.
    void match_wedges(std::span<const Page> pages) {
        std::vector<Corner> open;
        for (const bool second_lap : {false, true}) {
            for (const Page& page : pages) {
                if (page.forward) {
                    if (!second_lap) open.push_back(page.half_edge);
                } else if (!open.empty() && pairs_.partner[page.half_edge] == EdgePairs::none &&
                           !same_face(open.back(), page.half_edge)) {
                    join(open.back(), page.half_edge);
                    open.pop_back();
                }
            }
        }
    }

    /// The first face of an edge is never the one too many.
    void note_left_over(std::span<const Corner> half_edges) {
        const auto lonely = [this](Corner c) { return pairs_.partner[c] == EdgePairs::none; };
        const bool all_lonely = std::ranges::all_of(half_edges, lonely);
        for (const Corner c : half_edges.subspan(all_lonely ? 1 : 0)) {
            if (lonely(c)) pairs_.left_over[polygons_.face_of[c]] = true;
        }
    }

    void join(Corner a, Corner b) {
        pairs_.partner[a] = b;
        pairs_.partner[b] = a;
    }

    const PolygonSoup& soup_;
    const Polygons& polygons_;
    std::vector<std::uint32_t> low_;    // one a half-edge: the lower of its points
    std::vector<std::uint64_t> keyed_;  // higher point, then half-edge
    EdgePairs pairs_;
};

}  // namespace

void EdgePairs::part(std::uint32_t half_edge) {
    const std::uint32_t other = partner[half_edge];
    if (other == none) return;
    partner[half_edge] = none;
    partner[other] = none;
}

EdgePairs pair_edges(const PolygonSoup& soup, const Polygons& polygons) {
    return Pairing(soup, polygons).run();
}

}  // namespace scanlight::mesh
