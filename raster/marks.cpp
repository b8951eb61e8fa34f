#include "raster/marks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "raster/compare.h"
#include "raster/framebuffer.h"
#include "raster/srgb.h"

namespace scanlight::raster {

namespace {

template <class Sample>
using Pixel = std::array<Sample, 4>;

template <class Sample>
Pixel<Sample> pixel_at(const Image<Sample>& image, int x, int y) {
    Pixel<Sample> pixel{};
    std::ranges::copy(image.pixel(x, y), pixel.begin());
    return pixel;
}

template <class Sample>
std::vector<Pixel<Sample>> pixels_of(const Image<Sample>& image) {
    std::vector<Pixel<Sample>> pixels;
    pixels.reserve(static_cast<std::size_t>(image.width()) *
                   static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            pixels.push_back(pixel_at(image, x, y));
    }
    return pixels;
}

/// NaN, which is not less than anything, has a place too.
template <class Sample>
bool comes_before(const Pixel<Sample>& a, const Pixel<Sample>& b) {
    const auto key = [](Sample sample) {
        if constexpr (std::is_same_v<Sample, float>)
            return std::bit_cast<std::uint32_t>(sample);
        else
            return sample;
    };
    return std::ranges::lexicographical_compare(a, b, {}, key, key);
}

/// Of several, the least.
template <class Sample>
Pixel<Sample> most_frequent(std::vector<Pixel<Sample>> pixels) {
    std::sort(pixels.begin(), pixels.end(), comes_before<Sample>);
    Pixel<Sample> found{};
    std::ptrdiff_t most = 0;
    for (auto run = pixels.begin(); run != pixels.end();) {
        const auto end = std::upper_bound(run, pixels.end(), *run, comes_before<Sample>);
        if (end - run > most) {
            most = end - run;
            found = *run;
        }
        run = end;
    }
    return found;
}

/// Whether each pixel has the most frequent colour.
template <class Sample>
Plane<char> background_of(const Image<Sample>& image) {
    const Pixel<Sample> background = most_frequent(pixels_of(image));
    Plane<char> is_background({image.width(), image.height()}, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            is_background.at(x, y) = pixel_at(image, x, y) == background ? 1 : 0;
    }
    return is_background;
}

Marks marks_before(const Plane<char>& background, const Plane<double>& differences,
                   double tolerance) {
    Marks marks;
    for (int y = 0; y < background.height(); ++y) {
        for (int x = 0; x < background.width(); ++x) {
            const bool is_right = differences.at(x, y) <= tolerance;
            if (is_right && background.at(x, y) != 0) continue;
            ++marks.judged;
            marks.right += is_right ? 1 : 0;
        }
    }
    return marks;
}

// ---- what goes wrong, undone

/// Each pixel from another place, or its own where that is beyond the picture.
template <class Sample, class Place>
Image<Sample> rearranged(const Image<Sample>& image, Place&& place) {
    Image<Sample> result(image.width(), image.height(), image.channels());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto [i, j] = place(x, y);
            const bool is_inside = i >= 0 && j >= 0 && i < image.width() && j < image.height();
            std::ranges::copy(is_inside ? image.pixel(i, j) : image.pixel(x, y),
                              result.pixel(x, y).begin());
        }
    }
    return result;
}

AnyImage upside_down(const AnyImage& any) {
    return std::visit(
        [](const auto& image) -> AnyImage {
            return rearranged(image,
                              [&](int x, int y) { return std::pair(x, image.height() - 1 - y); });
        },
        any);
}

AnyImage mirrored(const AnyImage& any) {
    return std::visit(
        [](const auto& image) -> AnyImage {
            return rearranged(image,
                              [&](int x, int y) { return std::pair(image.width() - 1 - x, y); });
        },
        any);
}

AnyImage moved(const AnyImage& any, int right, int down) {
    return std::visit(
        [=](const auto& image) -> AnyImage {
            return rearranged(image, [=](int x, int y) { return std::pair(x - right, y - down); });
        },
        any);
}

AnyImage exchanged(AnyImage any) {
    std::visit(
        [](auto& image) {
            if (image.channels() < 3) return;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x)
                    std::swap(image.pixel(x, y)[0], image.pixel(x, y)[2]);
            }
        },
        any);
    return any;
}

/// The colours of 8 bits by `convert`; the rest as it is.
AnyImage converted(AnyImage any, const std::function<std::uint8_t(std::uint8_t)>& convert) {
    auto* const image = std::get_if<Image8>(&any);
    if (image == nullptr) return any;
    const int colors = image->channels() - (image->channels() % 2 == 0 ? 1 : 0);
    for (int y = 0; y < image->height(); ++y) {
        for (int x = 0; x < image->width(); ++x) {
            for (auto& sample : image->pixel(x, y).first(static_cast<std::size_t>(colors)))
                sample = convert(sample);
        }
    }
    return any;
}

AnyImage encoded(const AnyImage& any) {
    return converted(any, [](std::uint8_t sample) {
        return srgb_from_linear(static_cast<float>(sample) / 255.0f);
    });
}

AnyImage decoded(const AnyImage& any) {
    return converted(any, [](std::uint8_t sample) {
        return static_cast<std::uint8_t>(linear_from_srgb(sample) * 255.0f + 0.5f);
    });
}

struct Mistake {
    std::string_view name;
    AnyImage (*undo)(const AnyImage&);
};

template <int right, int down>
AnyImage moved_back(const AnyImage& any) {
    return moved(any, -right, -down);
}

constexpr Mistake mistakes[] = {
    {"it is upside down", upside_down},
    {"left and right are exchanged", mirrored},
    {"red and blue are exchanged", [](const AnyImage& any) { return exchanged(any); }},
    {"all of it lies one pixel too far right", moved_back<1, 0>},
    {"all of it lies one pixel too far left", moved_back<-1, 0>},
    {"all of it lies one pixel too low", moved_back<0, 1>},
    {"all of it lies one pixel too high", moved_back<0, -1>},
    {"all of it lies one pixel too low and too far right", moved_back<1, 1>},
    {"all of it lies one pixel too high and too far left", moved_back<-1, -1>},
    {"linear light is not encoded as sRGB", encoded},
    {"sRGB is encoded twice", decoded},
};

/// 8 bits of linear light do not come back exactly.
constexpr double loss_of_encoding = 8.0 / 255.0;

}  // namespace

Marks marks_of(const AnyImage& candidate, const AnyImage& reference, double tolerance) {
    const auto differences = pixel_differences(reference, candidate);
    const auto background =
        std::visit([](const auto& image) { return background_of(image); }, reference);
    return marks_before(background, differences, tolerance);
}

std::string_view likely_mistake(const AnyImage& candidate, const AnyImage& reference,
                                double tolerance) {
    const double before = marks_of(candidate, reference, tolerance).share();
    for (const Mistake& mistake : mistakes) {
        const bool is_of_encoding = mistake.undo == encoded || mistake.undo == decoded;
        const double allowed = is_of_encoding ? std::max(tolerance, loss_of_encoding) : tolerance;
        const double share = marks_of(mistake.undo(candidate), reference, allowed).share();
        if (share >= 0.95 && share > before) return mistake.name;
    }
    return {};
}

}  // namespace scanlight::raster
