#pragma once

#include <cstdint>
#include <random>

namespace scanlight::raster::laws {

// Under sanitizers, without optimisation and where lines are counted, a case costs thirty times as
// much.
#if defined(SCANLIGHT_FEW_CASES) || defined(__SANITIZE_ADDRESS__) || \
    defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
inline constexpr bool thorough = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
inline constexpr bool thorough = false;
#else
inline constexpr bool thorough = true;
#endif
#else
inline constexpr bool thorough = true;
#endif

/// How many of `count` random cases this build tries.
constexpr int cases(int count) {
    return thorough ? count : count / 50 + 1;
}

inline constexpr int million = cases(1'000'000);

/// Random numbers that are the same on every machine.
class Random {
public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}

    /// A whole number, both ends included.
    int between(int low, int high) {
        const std::uint64_t range = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
        const std::uint64_t scaled = (std::uint64_t{bits_()} * range) >> 32;
        return static_cast<int>(low + static_cast<std::int64_t>(scaled));
    }

    bool one_in(int n) { return between(1, n) == 1; }

    /// A multiple of 2^-24.
    float real(float low, float high) {
        return low + (high - low) * static_cast<float>(bits_() >> 8) * 0x1p-24f;
    }

private:
    std::mt19937 bits_;
};

}  // namespace scanlight::raster::laws
