#include "apps/scene/model_textures.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/bounds.h"
#include "mesh/mesh_folder.h"
#include "raster/image_limits.h"
#include "raster/load_image.h"
#include "render/material_textures.h"

namespace scanlight::apps {

namespace {

/// How high the white of a bump map is by -bm 1: MTL has no units. A hundredth of the mesh's
/// longest side is a grain that is seen well.
constexpr double bump_share = 0.01;

double bump_unit(const mesh::Mesh& mesh) {
    const glm::dvec3 size = mesh::bounding_box(mesh).size();
    return bump_share * std::max({size.x, size.y, size.z});
}

raster::AnyImage load_picture(const mesh::OpenFile& open, const std::string& path) {
    const auto bytes = open(path);
    if (!bytes) throw std::runtime_error(path + ": there is no such file");
    const auto view = bytes->view();
    return raster::decode_image({path, {view.begin(), view.end()}});
}

bool has_maps(const mesh::Mesh& mesh) {
    return std::ranges::any_of(
        mesh.materials, [](const mesh::Material& material) { return !material.maps.empty(); });
}

/// Surroundings that are mirrored do not lie on the surface.
bool needs_uv(const std::pair<const mesh::MapUse, mesh::TextureMap>& map) {
    return map.first < mesh::MapUse::sphere;
}

std::vector<mesh::Material> without_maps_on_surfaces(std::vector<mesh::Material> materials) {
    for (mesh::Material& material : materials)
        std::erase_if(material.maps, needs_uv);
    return materials;
}

void warn(Model& model, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences)
        model.warnings.push_back(model.name + ": " + sentence);
}

}  // namespace

void load_textures(Model& model, render::Shading shading) {
    if (!has_maps(model.mesh)) return;
    const std::string left_out = "the textures of its materials are left out: ";
    if (shading != render::Shading::phong)
        return warn(model, {left_out + "only Phong shading draws them"});
    std::vector<mesh::Material> materials = model.mesh.materials;
    if (!model.mesh.vertices.has_uvs()) {
        materials = without_maps_on_surfaces(std::move(materials));
        if (materials != model.mesh.materials)
            warn(model, {left_out + "the mesh has no texture coordinates"});
    }
    const auto open = mesh::files_beside(model.name, {"texture", raster::max_file_bytes});
    const auto load = [&](const std::string& path) { return load_picture(open, path); };
    auto [textures, warnings] = render::surface_textures(materials, load, bump_unit(model.mesh));
    model.textures = std::move(textures);
    warn(model, warnings);
}

}  // namespace scanlight::apps
