#pragma once

#include <stdexcept>
#include <string>

namespace scanlight::apps {

/// The person's mistake on the command line. Exit status 2.
class UsageError : public std::runtime_error {
public:
    explicit UsageError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace scanlight::apps
