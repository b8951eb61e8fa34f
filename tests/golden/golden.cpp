#include "tests/golden/golden.h"

#include <cstdlib>
#include <iostream>

#include "raster/compare.h"
#include "raster/image_error.h"
#include "raster/load_image.h"
#include "raster/save_image.h"

namespace scanlight::golden {

namespace fs = std::filesystem;

namespace {

fs::path golden_path(const std::string& name) {
    return folder() / (name + ".png");
}

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

bool is_accepted(const std::string& name) {
    return accepted_name() == "all" || accepted_name() == name;
}

std::string how_to_accept(const std::string& name) {
    return "If the new picture is right, accept it: ./dev golden " + name;
}

void save_failure(const std::string& name, const std::string& what, const raster::AnyImage& image) {
    const fs::path path = failure_path(name, what);
    fs::create_directories(path.parent_path());
    raster::save_image(path.string(), image);
}

std::string told(const raster::Difference& difference) {
    const auto& worst = *difference.worst;
    return std::to_string(difference.different_pixels) + " of " +
           std::to_string(difference.pixels) + " pixels differ; the worst is (" +
           std::to_string(worst.x) + ", " + std::to_string(worst.y) + "), channel " +
           std::to_string(worst.channel) + ": " + std::to_string(worst.first) + " expected, " +
           std::to_string(worst.second) + " drawn";
}

testing::AssertionResult accepted(const std::string& name, const raster::Image8& actual) {
    if (!environment("CI").empty()) {
        return testing::AssertionFailure() << "goldens are accepted by people, not by CI";
    }
    fs::create_directories(golden_path(name).parent_path());
    raster::save_image(golden_path(name).string(), actual);
    std::cout << "accepted: " << golden_path(name).string() << '\n';
    return testing::AssertionSuccess();
}

testing::AssertionResult incomparable(const std::string& name, const raster::Image8& actual,
                                      const std::string& reason) {
    save_failure(name, "actual", actual);
    return testing::AssertionFailure()
           << reason << "; the picture drawn is " << failure_path(name, "actual").string() << '\n'
           << how_to_accept(name);
}

}  // namespace

fs::path folder() {
    return fs::path(SCANLIGHT_TESTS_DIR) / "goldens";
}

std::string accepted_name() {
    return environment("SCANLIGHT_ACCEPT");
}

fs::path failure_path(const std::string& name, const std::string& what) {
    return fs::path(SCANLIGHT_BUILD_DIR) / "golden-failures" / (name + "-" + what + ".png");
}

testing::AssertionResult same_pixels(const std::string& name, const raster::AnyImage& expected,
                                     const raster::Image8& actual, const std::string& report) {
    const raster::Difference difference = raster::compare(expected, actual);
    if (difference.different_pixels == 0) return testing::AssertionSuccess();
    save_failure(report, "expected", expected);
    save_failure(report, "actual", actual);
    save_failure(report, "difference", raster::difference_image(expected, actual));
    return testing::AssertionFailure()
           << told(difference) << "\nLook at " << failure_path(report, "expected").string()
           << "\n        " << failure_path(report, "actual").string() << "\n        "
           << failure_path(report, "difference").string() << '\n'
           << how_to_accept(name);
}

testing::AssertionResult matches(const std::string& name, const raster::Image8& actual) {
    if (is_accepted(name)) return accepted(name, actual);
    if (!fs::exists(golden_path(name))) {
        return incomparable(name, actual, golden_path(name).string() + " is missing");
    }
    try {
        return same_pixels(name, raster::load_image(golden_path(name).string()), actual, name);
    } catch (const raster::ImageError& error) {  // damaged, or of another size
        return incomparable(name, actual, error.what());
    }
}

}  // namespace scanlight::golden
