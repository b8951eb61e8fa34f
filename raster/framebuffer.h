#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec4.hpp>

#include "raster/fixed.h"
#include "raster/project.h"
#include "raster/streams.h"

namespace scanlight::raster {

/// One value for each pixel, rows from top to bottom.
template <class T>
class Plane {
public:
    Plane() = default;
    Plane(Viewport size, T value)
        : size_(size),
          values_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                  value) {
        assert(size.width > 0 && size.width <= max_size);
        assert(size.height > 0 && size.height <= max_size);
    }

    int width() const { return size_.width; }
    int height() const { return size_.height; }

    std::span<T> row(int y) { return std::span(values_).subspan(start(y), row_length()); }
    std::span<const T> row(int y) const {
        return std::span(values_).subspan(start(y), row_length());
    }
    T& at(int x, int y) { return row(y)[static_cast<std::size_t>(x)]; }
    const T& at(int x, int y) const { return row(y)[static_cast<std::size_t>(x)]; }

    /// All values, row by row. Not of a temporary: the span would outlive them.
    std::span<const T> values() const& { return values_; }
    std::span<const T> values() const&& = delete;

    friend bool operator==(const Plane& a, const Plane& b) {
        return a.width() == b.width() && a.height() == b.height() && a.values_ == b.values_;
    }

private:
    std::size_t row_length() const { return static_cast<std::size_t>(size_.width); }
    std::size_t start(int y) const { return static_cast<std::size_t>(y) * row_length(); }

    Viewport size_;
    LineVector<T> values_;
};

/// Linear light, unclamped; alpha is 1 where something was drawn, and less where that covers a
/// pixel in part or lets light through. The colour is never multiplied by it.
using Rgba = glm::vec4;

/// What polygons are drawn into.
struct Framebuffer {
    Framebuffer(Viewport size, Rgba background)
        : color(size, background), depth(size, depth_clear) {}

    Viewport size() const { return {color.width(), color.height()}; }

    Plane<Rgba> color;
    Plane<Depth> depth;
};

}  // namespace scanlight::raster
