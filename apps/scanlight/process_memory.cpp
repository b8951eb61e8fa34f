#include "apps/scanlight/process_memory.h"

#include <sys/resource.h>

namespace scanlight::apps {

std::size_t peak_memory() {
#ifdef __APPLE__
    constexpr std::size_t unit = 1;
#else
    constexpr std::size_t unit = 1024;
#endif
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * unit;
}

}  // namespace scanlight::apps
