#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "apps/scene/model.h"
#include "apps/scene/scene_options.h"

namespace scanlight::apps {

/// The meshes of a scene's objects, each loaded once however often it is placed.
struct Models {
    std::deque<Model> all;
    std::vector<const Model*> of_object;  // one for each object
    mesh::Box box;                        // around them all; the origin alone without any
    std::optional<mesh::Mesh> floor;      // beneath them

    Models() = default;
    Models(Models&&) = default;
    Models& operator=(Models&&) = default;
};

/// Sums over the meshes.
struct ModelTotals {
    mesh::BuildReport report;  // the counts of faces only
    std::size_t vertices = 0;
    double load_seconds = 0.0;
    double build_seconds = 0.0;
};
ModelTotals totals_of(const Models& models);

/// For a person: those of all meshes.
std::vector<std::string> warnings_of(const Models& models);

/// Together the objects of a scene file have no more faces than this. A file of few bytes could
/// else name more than any memory holds.
inline constexpr std::size_t most_faces_of_many = std::size_t{1} << 24;

/// The meshes of the options' objects, cut into triangles where they ask for it, and their floor.
/// Throws UsageError or FileError, which name the place in the scene file where there is one.
Models load_models(const SceneOptions& options);

/// Whether pictures of both can be drawn of the same models.
bool share_models(const SceneOptions& a, const SceneOptions& b);

}  // namespace scanlight::apps
