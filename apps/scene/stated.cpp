#include "apps/scene/stated.h"

#include <filesystem>

#include "apps/scene/usage_error.h"

namespace scanlight::apps {

const std::string& Stated::at(std::initializer_list<std::string> keys) const {
    for (const std::string& key : keys) {
        const auto value = values.find(key);
        if (value != values.end()) return value->second;
    }
    return table;
}

std::string prefix_of(const std::string& stated_at) {
    return stated_at.empty() ? "" : stated_at + ": ";
}

void expect_file(const std::string& stated_at, const std::string& what, const std::string& path) {
    std::error_code ignored;
    if (stated_at.empty() || std::filesystem::is_regular_file(path, ignored)) return;
    throw UsageError(prefix_of(stated_at) + what + " '" + path + "': no such file");
}

}  // namespace scanlight::apps
