#pragma once

#include <cstdint>
#include <string_view>

#include "raster/image.h"

namespace scanlight::raster {

/// How much of a picture is right. Background that is right does not count, so that nothing is won
/// by an empty picture: pixels of the reference's most frequent colour are judged only where the
/// candidate is wrong there.
struct Marks {
    std::int64_t judged = 0;
    std::int64_t right = 0;

    /// 0 to 1.
    double share() const {
        return judged == 0 ? 1.0 : static_cast<double>(right) / static_cast<double>(judged);
    }
};

/// A pixel is right where no channel is further from the reference's than `tolerance`, in parts of
/// the peak: 1/255 is one level of 8 bits. Throws as `compare` does.
Marks marks_of(const AnyImage& candidate, const AnyImage& reference, double tolerance);

/// What is probably wrong with a picture, as a person would say it: with this undone, at least 19
/// of 20 judged pixels are right, and more than before. Empty where nothing helps.
std::string_view likely_mistake(const AnyImage& candidate, const AnyImage& reference,
                                double tolerance);

}  // namespace scanlight::raster
