#include "apps/scanlight/print_data.h"

#include <cstdio>

#include "raster/save_file.h"

namespace scanlight::apps {

void print_data(const std::string& text, const std::string& picture) {
    if (picture == "-") {
        std::fputs(text.c_str(), stderr);
    } else {
        raster::save_file("-", text);
    }
}

}  // namespace scanlight::apps
