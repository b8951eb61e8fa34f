#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "apps/scanlight/picture.h"
#include "apps/scene/models.h"
#include "apps/scene/scene_options.h"
#include "mesh/silhouette.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace scanlight::apps::window {

using Pixels = raster::Plane<raster::PackedPixel>;

/// The models of the last few scenes, so that two views load theirs once.
class ModelShelf {
public:
    /// Throws UsageError or FileError.
    std::shared_ptr<const Models> models_for(const SceneOptions& options);

private:
    struct Entry {
        SceneOptions options;
        std::shared_ptr<const Models> models;
    };
    std::deque<Entry> entries_;
};

/// Draws one view again and again, and each time only what has changed: meshes are loaded once,
/// surfaces and surroundings made once, pictures drawn once. Two pictures are the same where their
/// scene files are.
class Painter {
public:
    Painter(ModelShelf& shelf, const render::Execution& execution = {});

    /// The picture that the program draws of the same options, to the bit. Throws UsageError or
    /// FileError, and keeps the last picture.
    const Pixels& paint(const SceneOptions& options);

    // Of the last picture:
    const Pixels& pixels() const { return pixels_; }
    const render::Scene& scene() const { return scene_; }
    const Models& models() const { return *models_; }
    /// Its scene file; empty before the first.
    const std::string& drawn() const { return drawn_; }

private:
    void prepare(const SceneOptions& options);
    void draw(const SceneOptions& options);

    ModelShelf& shelf_;
    render::Renderer renderer_;
    Means means_;
    std::shared_ptr<const Models> models_;
    std::string unseen_key_;
    render::Scene unseen_;
    std::map<const mesh::Mesh*, mesh::SilhouetteFinder> silhouettes_;
    render::Scene scene_;
    Pixels pixels_;
    std::string drawn_;
};

/// As an image file takes them.
raster::Image8 image_of(const Pixels& pixels, raster::Alpha alpha);

}  // namespace scanlight::apps::window
