#pragma once

#include <cstddef>

namespace scanlight::apps {

/// The most memory that this process has held so far, in bytes, as the system counts it: program,
/// libraries, mesh, picture.
std::size_t peak_memory();

}  // namespace scanlight::apps
