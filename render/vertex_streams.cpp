#include "render/vertex_streams.h"

#include <glm/matrix.hpp>

namespace scanlight::render {

Placing placing_of(const glm::dmat4& world_from_object, const Frame& frame) {
    const glm::dmat3 linear(world_from_object);
    return {frame.clip_from_world * world_from_object, world_from_object,
            glm::mat3(glm::transpose(glm::inverse(linear))), glm::determinant(linear) < 0.0};
}

}  // namespace scanlight::render
