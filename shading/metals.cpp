#include "shading/metals.h"

namespace scanlight::shading {

std::span<const Metal> metals() noexcept {
    static constexpr Metal all[] = {
        {"aluminium", {1.3660, 0.87340, 0.60790}, {7.4052, 6.2418, 5.3676}},
        {"chromium", {3.17, 2.94, 2.33}, {3.30, 3.33, 3.14}},
        {"copper", {0.30, 1.18, 1.24}, {3.205, 2.608, 2.397}},
        {"gold", {0.21, 0.62, 1.38}, {3.272, 2.081, 1.914}},
        {"iron", {2.88, 2.86, 2.59}, {3.05, 2.91, 2.77}},
        {"silver", {0.06, 0.05, 0.04}, {4.152, 3.324, 2.657}},
        {"titanium", {2.67, 2.44, 2.27}, {3.72, 3.30, 3.04}},
    };
    return all;
}

}  // namespace scanlight::shading
