#include "apps/scene/json.h"

#include <array>
#include <charconv>
#include <cmath>

namespace scanlight::apps {

Json json_number(float value) {
    if (!std::isfinite(value)) return nullptr;
    std::array<char, 32> text{};
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
    double decimal = 0.0;
    std::from_chars(text.data(), written.ptr, decimal);
    return decimal;
}

std::string json_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scanlight::apps
