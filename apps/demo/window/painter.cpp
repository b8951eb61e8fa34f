#include "apps/demo/window/painter.h"

#include <algorithm>
#include <utility>

#include "apps/scanlight/facet_options.h"
#include "apps/scene/keys.h"
#include "apps/scene/scene_setup.h"
#include "apps/scene/write_scene.h"

namespace scanlight::apps::window {

namespace {

constexpr std::size_t most_entries = 3;

/// What an unseen scene hangs on, beside its models.
std::string unseen_key_of(const SceneOptions& options) {
    std::string key;
    for (const Section& section : sections()) {
        const bool is_seen = section.name.starts_with("camera") || section.name == "render" ||
                             section.name == "light";
        if (is_seen) continue;
        for (const std::string& lines : section.write(options, {}))
            key += section.name + "\n" + lines;
    }
    const auto background = options.background.value_or(glm::vec3(-1.0f));
    for (int k = 0; k < 3; ++k)
        key += std::to_string(background[k]) + " ";
    return key;
}

/// Whether the fast path draws straight into the window's bytes.
bool is_plain(const SceneOptions& options) {
    return options.show == Show::light && wireframe_of(options) == Wireframe::none;
}

/// Throws UsageError for what the command line refuses too.
void check(const SceneOptions& options) {
    check_shadows(options);
    check_size(options);
    if (options.show == Show::fresnel)
        require_model("show fresnel", models_in(options), {shading::Illumination::cook_torrance});
}

Pixels packed(const raster::Plane<raster::Rgba>& colors) {
    Pixels pixels({colors.width(), colors.height()}, 0);
    for (int y = 0; y < colors.height(); ++y) {
        std::ranges::transform(colors.row(y), pixels.row(y).begin(), [](const raster::Rgba& c) {
            return raster::packed_pixel(c, raster::Encoding::srgb);
        });
    }
    return pixels;
}

Pixels pixels_of(Picture picture) {
    if (auto* bytes = std::get_if<Picture::Bytes>(&picture.color)) return std::move(*bytes);
    return packed(std::get<Picture::Floats>(picture.color));
}

}  // namespace

std::shared_ptr<const Models> ModelShelf::models_for(const SceneOptions& options) {
    const auto serves = [&](const Entry& entry) { return share_models(entry.options, options); };
    const auto found = std::ranges::find_if(entries_, serves);
    if (found != entries_.end()) return found->models;
    entries_.push_front({options, std::make_shared<const Models>(load_models(options))});
    if (entries_.size() > most_entries) entries_.pop_back();
    return entries_.front().models;
}

Painter::Painter(ModelShelf& shelf, const render::Execution& execution)
    : shelf_(shelf), renderer_(execution), means_{DrawPath::fast, execution} {}

const Pixels& Painter::paint(const SceneOptions& options) {
    std::string wanted = scene_text(options, "");
    if (wanted == drawn_) return pixels_;
    check(options);
    prepare(options);
    draw(options);
    drawn_ = std::move(wanted);
    return pixels_;
}

void Painter::prepare(const SceneOptions& options) {
    const auto models = shelf_.models_for(options);
    std::string key = unseen_key_of(options);
    if (models == models_ && key == unseen_key_) return;
    unseen_ = unseen_scene_of(*models, options);
    if (models != models_) silhouettes_.clear();
    models_ = models;
    unseen_key_ = std::move(key);
}

void Painter::draw(const SceneOptions& options) {
    if (render::counts_volumes(options.settings.shadows)) {
        for (render::Object& object : unseen_.objects) {
            const auto found = silhouettes_.try_emplace(object.mesh, *object.mesh).first;
            object.silhouettes = &found->second;
        }
    }
    scene_ = seen(unseen_, *models_, options);
    if (!is_plain(options)) {
        pixels_ = pixels_of(draw_picture(scene_, options, means_, {Samples::bytes, false}));
        return;
    }
    const bool fits =
        pixels_.width() == options.size.width && pixels_.height() == options.size.height;
    if (!fits) pixels_ = Pixels(options.size, 0);
    renderer_.draw(scene_, options.settings, pixels_, raster::Encoding::srgb);
}

raster::Image8 image_of(const Pixels& pixels, raster::Alpha alpha) {
    Picture picture;
    picture.color = pixels;
    return byte_image(picture, alpha);
}

}  // namespace scanlight::apps::window
