#include "apps/demo/window/saving.h"

#include <filesystem>

#include "apps/scene/write_scene.h"
#include "raster/save_file.h"
#include "raster/save_image.h"

namespace scanlight::apps::window {

namespace {

std::string free_path_of(const std::string& stem, const std::string& ending) {
    std::string path = stem + ending;
    for (int i = 2; std::filesystem::exists(path); ++i)
        path = stem + "-" + std::to_string(i) + ending;
    return path;
}

}  // namespace

std::string stem_of(std::string input) {
    for (const std::string prefix : {"shape:", "scene:"}) {
        if (input.starts_with(prefix)) input = input.substr(prefix.size());
    }
    const std::string stem = std::filesystem::path(input).stem().string();
    const std::string name = stem.substr(0, stem.find(':'));
    return name.empty() || name == "-" ? "picture" : name;
}

std::string free_path(const SceneOptions& options, const std::string& ending) {
    return free_path_of(stem_of(options.input), ending);
}

std::string save_lesson(const demo::Screen& screen, const LessonState& state) {
    const std::string path = free_path_of(state.lesson().name, ".png");
    raster::save_image(path, demo::picture_of(screen));
    return "saved " + path;
}

std::string save_picture(const Pixels& pixels, const SceneOptions& options) {
    const std::string path = free_path(options, ".png");
    const auto alpha = options.background ? raster::Alpha::dropped : raster::Alpha::kept;
    raster::save_image(path, image_of(pixels, alpha));
    return "saved " + path;
}

std::string save_scene(const SceneOptions& options) {
    const std::string path = free_path(options, ".toml");
    raster::save_file(path, scene_text(options, ""));
    return "saved " + path;
}

}  // namespace scanlight::apps::window
