#include <algorithm>
#include <iterator>

#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

NamedScenes all_scenes() {
    NamedScenes all = mixed_scenes();
    for (NamedScenes more : {special_scenes(), soup_scenes(), shadow_scenes(), texture_scenes(),
                             model_scenes(), glass_scenes(), room_scenes()})
        std::ranges::move(more, std::back_inserter(all));
    return all;
}

}  // namespace scanlight::same_bits
