#pragma once

#include <vector>

namespace scanlight::exercises {

struct Crossing {
    bool enters;
    bool is_behind_surface;
};

inline bool is_in_shadow(const std::vector<Crossing>& crossings) {
    int volumes = 0;
    for (const Crossing& crossing : crossings) {
        if (crossing.is_behind_surface) volumes += crossing.enters ? -1 : 1;
    }
    return volumes != 0;
}

}  // namespace scanlight::exercises
