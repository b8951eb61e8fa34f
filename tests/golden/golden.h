#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "raster/image.h"

namespace scanlight::golden {

/// Where the pictures lie that people once looked at and accepted.
std::filesystem::path folder();

/// The name of the picture that is to be accepted as it is drawn now, or `all`; empty: none.
std::string accepted_name();

/// Where a failing picture is left: what is `expected`, `actual` or `difference`.
std::filesystem::path failure_path(const std::string& name, const std::string& what);

/// Pixel for pixel. A difference leaves three pictures to look at, under the name of `report`, and
/// says where, and how to accept the new one as `name`.
testing::AssertionResult same_pixels(const std::string& name, const raster::AnyImage& expected,
                                     const raster::Image8& actual, const std::string& report);

/// The same with the picture on record.
testing::AssertionResult matches(const std::string& name, const raster::Image8& actual);

}  // namespace scanlight::golden
