#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace scanlight::demo {

/// RFC 4648, with padding: how a page holds bytes.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace scanlight::demo
