#pragma once

#include <cstdint>
#include <optional>

#include "raster/framebuffer.h"
#include "raster/image.h"

namespace scanlight::raster {

/// The sample in which two pictures differ most.
struct WorstSample {
    int x;
    int y;
    int channel;
    double first;  // in the first picture, 0 to Difference::peak
    double second;
};

/// How two pictures of one size differ, sample by sample.
struct Difference {
    std::int64_t pixels = 0;
    std::int64_t different_pixels = 0;  // in any channel
    double mean_absolute = 0;           // of all samples, in their units
    double root_mean_square = 0;
    double peak = 1;                   // the largest value of a sample: 255, 65535, or 1 for floats
    std::optional<WorstSample> worst;  // nothing when equal; the first in rows, then channels
};

/// Compares decoded pixels, exactly. Where the pictures are of different kinds they meet in the
/// wider one: 8 bits become 16 (255 becomes 65535), grey becomes RGB, a missing alpha channel is
/// opaque. NaN equals NaN and is infinitely far from numbers. The sums are taken row by row in
/// double: exact for 8 bits, the same on every machine for all. Throws ImageError when the sizes
/// differ, or one has floats and the other has not.
Difference compare(const AnyImage& first, const AnyImage& second);

/// How far apart the channels of each pixel are at most, in parts of the peak. Throws as compare
/// does.
Plane<double> pixel_differences(const AnyImage& first, const AnyImage& second);

/// Peak signal-to-noise ratio, 20 log10(peak / rms), in decibels; infinite for equal pictures.
double psnr_db(const Difference& difference);

/// The first picture, grey and dim, and over it each pixel that differs, from dark red to white;
/// each of the eight steps of this ramp is twice the difference of the one before, and one level in
/// 255 or less is the first. Throws as compare does.
Image8 difference_image(const AnyImage& first, const AnyImage& second);

}  // namespace scanlight::raster
