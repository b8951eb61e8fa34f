#include "raster/compare.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>

#include "raster/image_error.h"

namespace scanlight::raster {

namespace {

template <class Sample>
constexpr double peak_of = std::numeric_limits<Sample>::max();
template <>
constexpr double peak_of<float> = 1;

bool has_alpha(int channels) {
    return channels % 2 == 0;
}

// A picture seen with as many channels, and on as wide a scale, as the pair has in common.
template <class Sample>
struct View {
    const Image<Sample>* image;
    bool in_colour;
    bool with_alpha;
    double peak;

    int channels() const { return (in_colour ? 3 : 1) + (with_alpha ? 1 : 0); }

    double at(int x, int y, int channel) const {
        const auto pixel = image->pixel(x, y);
        if (with_alpha && channel == channels() - 1) {
            return has_alpha(image->channels()) ? scaled(pixel.back()) : peak;
        }
        return scaled(image->channels() < 3 ? pixel[0] : pixel[static_cast<std::size_t>(channel)]);
    }

    // 65535 is 257 · 255: whole numbers stay whole.
    double scaled(Sample sample) const { return sample * (peak / peak_of<Sample>); }
};

template <class First, class Second>
struct Pair {
    View<First> first;
    View<Second> second;

    int width() const { return first.image->width(); }
    int height() const { return first.image->height(); }
    int channels() const { return first.channels(); }
    double peak() const { return first.peak; }
};

template <class First, class Second>
Pair<First, Second> pair_of(const Image<First>& first, const Image<Second>& second) {
    const bool in_colour = std::max(first.channels(), second.channels()) >= 3;
    const bool with_alpha = has_alpha(first.channels()) || has_alpha(second.channels());
    const double peak = std::max(peak_of<First>, peak_of<Second>);
    return {{&first, in_colour, with_alpha, peak}, {&second, in_colour, with_alpha, peak}};
}

template <class Sample>
std::string size_of(const Image<Sample>& image) {
    return std::to_string(image.width()) + " x " + std::to_string(image.height());
}

template <class First, class Second>
void require_comparable(const Image<First>& first, const Image<Second>& second) {
    if (first.width() != second.width() || first.height() != second.height()) {
        throw ImageError("the sizes differ: " + size_of(first) + " and " + size_of(second));
    }
    if (std::is_same_v<First, float> != std::is_same_v<Second, float>) {
        throw ImageError("one picture has floats, the other whole numbers");
    }
}

// Calls `use` with what the two have in common.
template <class Use>
auto with_pair(const AnyImage& first, const AnyImage& second, const Use& use) {
    return std::visit(
        [&](const auto& a, const auto& b) {
            require_comparable(a, b);
            return use(pair_of(a, b));
        },
        first, second);
}

double distance(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double apart = std::abs(a - b);
    return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

// Sums on their way through the picture.
class Tally {
public:
    // True when the sample differs.
    bool add(const WorstSample& sample) {
        const double apart = distance(sample.first, sample.second);
        sum_ += apart;
        sum_of_squares_ += apart * apart;
        if (apart > furthest_) {
            furthest_ = apart;
            worst_ = sample;
        }
        return apart > 0;
    }

    Difference over(std::int64_t samples) const {
        Difference difference;
        difference.worst = worst_;
        if (samples == 0) return difference;
        difference.mean_absolute = sum_ / static_cast<double>(samples);
        difference.root_mean_square = std::sqrt(sum_of_squares_ / static_cast<double>(samples));
        return difference;
    }

private:
    double sum_ = 0;
    double sum_of_squares_ = 0;
    double furthest_ = 0;
    std::optional<WorstSample> worst_;
};

template <class Pair>
bool add_pixel(Tally& tally, const Pair& pair, int x, int y) {
    bool differs = false;
    for (int c = 0; c < pair.channels(); ++c) {
        differs |= tally.add({x, y, c, pair.first.at(x, y, c), pair.second.at(x, y, c)});
    }
    return differs;
}

template <class Pair>
Difference difference_of(const Pair& pair) {
    Tally tally;
    std::int64_t different = 0;
    for (int y = 0; y < pair.height(); ++y) {
        for (int x = 0; x < pair.width(); ++x)
            different += add_pixel(tally, pair, x, y) ? 1 : 0;
    }
    const std::int64_t pixels = std::int64_t{pair.width()} * pair.height();
    Difference difference = tally.over(pixels * pair.channels());
    difference.pixels = pixels;
    difference.different_pixels = different;
    difference.peak = pair.peak();
    return difference;
}

using Rgb = std::array<std::uint8_t, 3>;

// `share`, limited to [0, 1], of `levels`, rounded to nearest; NaN is 0.
std::uint8_t level(double share, double levels) {
    return static_cast<std::uint8_t>(share > 0 ? std::min(share, 1.0) * levels + 0.5 : 0);
}

template <class Pair>
Rgb dimmed(const Pair& pair, int x, int y) {
    const auto share = [&](int c) {
        return std::clamp(pair.first.at(x, y, c) / pair.peak(), 0.0, 1.0);
    };
    const double grey =
        pair.first.in_colour ? (2 * share(0) + 5 * share(1) + share(2)) / 8 : share(0);
    const std::uint8_t dim = level(grey, 80);
    return {dim, dim, dim};
}

// `share` of the peak, above 0; the ramp's step is the number of binary digits of its 8-bit level.
Rgb heat(double share) {
    static constexpr std::array<Rgb, 8> ramp = {{{150, 0, 0},
                                                 {190, 0, 0},
                                                 {230, 20, 0},
                                                 {255, 70, 0},
                                                 {255, 120, 0},
                                                 {255, 170, 0},
                                                 {255, 220, 60},
                                                 {255, 255, 255}}};
    const unsigned whole = std::max<unsigned>(level(share, 255), 1);
    return ramp[static_cast<std::size_t>(std::bit_width(whole) - 1)];
}

template <class Pair>
double furthest(const Pair& pair, int x, int y) {
    double apart = 0;
    for (int c = 0; c < pair.channels(); ++c) {
        apart = std::max(apart, distance(pair.first.at(x, y, c), pair.second.at(x, y, c)));
    }
    return apart;
}

template <class Pair>
Plane<double> differences_of(const Pair& pair) {
    Plane<double> differences({pair.width(), pair.height()}, 0.0);
    for (int y = 0; y < pair.height(); ++y) {
        for (int x = 0; x < pair.width(); ++x)
            differences.at(x, y) = furthest(pair, x, y) / pair.peak();
    }
    return differences;
}

template <class Pair>
Image8 picture_of(const Pair& pair) {
    Image8 picture(pair.width(), pair.height(), 3);
    for (int y = 0; y < pair.height(); ++y) {
        for (int x = 0; x < pair.width(); ++x) {
            const double apart = furthest(pair, x, y);
            const Rgb colour = apart > 0 ? heat(apart / pair.peak()) : dimmed(pair, x, y);
            std::ranges::copy(colour, picture.pixel(x, y).begin());
        }
    }
    return picture;
}

}  // namespace

Difference compare(const AnyImage& first, const AnyImage& second) {
    return with_pair(first, second, [](const auto& pair) { return difference_of(pair); });
}

Plane<double> pixel_differences(const AnyImage& first, const AnyImage& second) {
    return with_pair(first, second, [](const auto& pair) { return differences_of(pair); });
}

double psnr_db(const Difference& difference) {
    if (difference.root_mean_square == 0) return std::numeric_limits<double>::infinity();
    return 20 * std::log10(difference.peak / difference.root_mean_square);
}

Image8 difference_image(const AnyImage& first, const AnyImage& second) {
    return with_pair(first, second, [](const auto& pair) { return picture_of(pair); });
}

}  // namespace scanlight::raster
