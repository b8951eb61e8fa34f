#include "apps/demo/window/painter.h"

#include <gtest/gtest.h>

#include "apps/scanlight/scene_options.h"
#include "apps/scene/scene_setup.h"
#include "apps/scene/usage_error.h"
#include "mesh/file_error.h"

namespace scanlight::apps::window {
namespace {

const std::string small = " --size 64x48";

Pixels drawn_by(const SceneOptions& options) {
    const Models models = load_models(options);
    Picture picture = draw_picture(scene_of(models, options), options, {}, {});
    return std::get<Picture::Bytes>(picture.color);
}

TEST(Painter, WhateverWasDrawnBeforeThePictureIsTheProgramsOwn) {
    ModelShelf shelf;
    Painter painter(shelf);
    for (const std::string arguments :
         {"teapot", "teapot --shading flat", "teapot --floor --shadows zfail",
          "teapot --floor --shadows zfail --light world:1,2,3", "torus --shadows zfail --floor",
          "torus --texture diffuse=wood", "torus --normals area --eye 3,2,4", "torus --floor",
          "teapot --material kd=0.2 --background #102030", "teapot --samples 4"}) {
        const SceneOptions options = parse_scene(arguments + small);
        EXPECT_TRUE(painter.paint(options) == drawn_by(options)) << arguments;
    }
}

TEST(Painter, KeepsItsPictureWhereTheNextCannotBeDrawn) {
    ModelShelf shelf;
    Painter painter(shelf);
    const SceneOptions options = parse_scene("teapot" + small);
    const Pixels before = painter.paint(options);
    SceneOptions missing = options;
    missing.objects.at(0).input = "no-such-file.obj";
    EXPECT_THROW(painter.paint(missing), std::runtime_error);
    SceneOptions refused = options;
    refused.show = Show::fresnel;
    EXPECT_THROW(painter.paint(refused), UsageError);
    EXPECT_TRUE(painter.pixels() == before);
    EXPECT_TRUE(painter.paint(options) == before);
}

TEST(ModelShelf, LoadsAMeshAnewOnlyWhereItIsAnother) {
    ModelShelf shelf;
    const auto models_of = [&](const std::string& arguments) {
        return shelf.models_for(parse_scene(arguments));
    };
    const auto teapot = models_of("teapot");
    EXPECT_EQ(models_of("teapot --shading flat --view 10,20 --light 1,1,1"), teapot);
    EXPECT_NE(models_of("teapot --normals area"), teapot);
    EXPECT_NE(models_of("teapot --floor"), teapot);
    EXPECT_EQ(models_of("teapot"), teapot) << "two views take turns";
}

}  // namespace
}  // namespace scanlight::apps::window
