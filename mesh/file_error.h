#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace scanlight::mesh {

/// A file that can't be taken as it is. `what()` reads "name:line: reason"; binary files give
/// "name: byte N: reason".
class FileError : public std::runtime_error {
public:
    explicit FileError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace scanlight::mesh
