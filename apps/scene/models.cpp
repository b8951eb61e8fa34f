#include "apps/scene/models.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "apps/scene/model_textures.h"
#include "apps/scene/placement.h"
#include "apps/scene/stated.h"
#include "apps/scene/usage_error.h"
#include "mesh/file_error.h"
#include "mesh/triangulate.h"
#include "render/material_textures.h"

namespace scanlight::apps {

namespace {

/// What two objects share their mesh by.
struct MeshSource {
    std::string input;
    mesh::NormalRule normals;
    Polygons polygons;

    auto key() const { return std::tuple(input, normals.weight, normals.crease_deg, polygons); }
    bool operator<(const MeshSource& other) const { return key() < other.key(); }
};

MeshSource source_of(const ObjectOptions& object, const SceneOptions& options) {
    mesh::NormalRule normals = options.normals;
    normals.weight = object.normals.value_or(normals.weight);
    normals.crease_deg = object.crease_deg.value_or(normals.crease_deg);
    return {object.input, normals, object.polygons.value_or(options.polygons)};
}

Model load(const ObjectOptions& object, const MeshSource& source) {
    const std::string& stated_at = object.stated.at({"mesh", "shape"});
    if (!names_shape(object.input)) expect_file(stated_at, "mesh", object.input);
    try {
        Model model = load_model(source.input, source.normals);
        if (source.polygons == Polygons::triangulated) model.mesh = mesh::triangulated(model.mesh);
        for (const auto& left_out : render::approximations(model.mesh.materials))
            model.warnings.push_back(model.name + ": " + left_out);
        return model;
    } catch (const mesh::FileError& error) {
        throw mesh::FileError(prefix_of(stated_at) + error.what());
    }
}

/// Throws unless floats hold all of it.
void expect_finite(const ObjectOptions& object, const mesh::Box& box) {
    constexpr double most = std::numeric_limits<float>::max();
    const auto fits = [](const glm::dvec3& v) {
        return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
    };
    if (box.empty() || (fits(box.low) && fits(box.high))) return;
    throw UsageError(prefix_of(object.stated.table) +
                     "the object is placed beyond what a float holds");
}

mesh::Box box_around(const Models& models, const SceneOptions& options) {
    mesh::Box all;
    for (std::size_t i = 0; i < options.objects.size(); ++i) {
        const ObjectOptions& object = options.objects[i];
        const mesh::Box box = placed_box(models.of_object[i]->mesh, matrix_of(object.placement));
        expect_finite(object, box);
        if (box.empty()) continue;
        all.include(box.low);
        all.include(box.high);
    }
    return all.empty() ? mesh::Box{glm::dvec3(0.0), glm::dvec3(0.0)} : all;
}

/// Counts the faces of one more object.
void add_faces(std::size_t& faces, const Model& model, const ObjectOptions& object) {
    faces += model.mesh.face_count();
    if (faces <= most_faces_of_many || faces == model.mesh.face_count()) return;
    throw UsageError(prefix_of(object.stated.table) + "more than " +
                     std::to_string(most_faces_of_many) + " faces in all");
}

/// Those of each mesh's materials, as far as an object shows them.
void load_own_textures(Models& models, const SceneOptions& options) {
    std::map<const Model*, render::Shading> shadings;
    for (std::size_t i = 0; i < options.objects.size(); ++i) {
        const auto shading = options.objects[i].own.shading.value_or(options.settings.shading);
        const auto added = shadings.try_emplace(models.of_object[i], shading).first;
        if (shading == render::Shading::phong) added->second = shading;
    }
    for (Model& model : models.all)
        load_textures(model, shadings.at(&model));
}

}  // namespace

ModelTotals totals_of(const Models& models) {
    ModelTotals totals;
    for (const Model& model : models.all) {
        totals.report.faces_in += model.report.faces_in;
        totals.report.drawn += model.report.drawn;
        totals.report.zero_area += model.report.zero_area;
        totals.report.few_corners += model.report.few_corners;
        totals.vertices += model.mesh.vertices.size();
        totals.load_seconds += model.load_seconds;
        totals.build_seconds += model.build_seconds;
    }
    return totals;
}

std::vector<std::string> warnings_of(const Models& models) {
    std::vector<std::string> warnings;
    for (const Model& model : models.all)
        std::ranges::copy(warnings_of(model), std::back_inserter(warnings));
    return warnings;
}

Models load_models(const SceneOptions& options) {
    Models models;
    std::map<MeshSource, const Model*> loaded;
    std::size_t faces = 0;
    for (const ObjectOptions& object : options.objects) {
        const MeshSource source = source_of(object, options);
        const Model*& model = loaded[source];
        if (model == nullptr) model = &models.all.emplace_back(load(object, source));
        models.of_object.push_back(model);
        add_faces(faces, *model, object);
    }
    if (options.own_textures) load_own_textures(models, options);
    models.box = box_around(models, options);
    if (options.floor) models.floor = floor_beneath(models.box);
    return models;
}

bool share_models(const SceneOptions& a, const SceneOptions& b) {
    const auto is_alike = [&](const ObjectOptions& x, const ObjectOptions& y) {
        return source_of(x, a).key() == source_of(y, b).key() &&
               matrix_of(x.placement) == matrix_of(y.placement);
    };
    return a.floor == b.floor && a.own_textures == b.own_textures &&
           std::ranges::equal(a.objects, b.objects, is_alike);
}

}  // namespace scanlight::apps
