#include "shading/environment.h"

#include <cstddef>
#include <vector>

namespace scanlight::shading {

namespace {

/// A direction that light comes from, and how much of the sphere it stands for.
struct Ray {
    Vec3<double> direction;
    Vec3<double> light;
    double solid_angle;
};

/// Latitude v from 0 (down) to 1 (up), longitude u.
Vec3<double> direction_at(double u, double v) {
    const double cosine = -cosine_of_turns(0.5 * v);  // of the angle from the z axis
    const double sine = sine_of_turns(0.5 * v);
    return {sine * cosine_of_turns(u), sine * sine_of_turns(u), cosine};
}

/// Bands of equal height have equal areas: the sphere's area is that of its cylinder.
std::vector<Ray> rays_of(const Environment& environment, int samples) {
    Environment upright = environment;
    upright.environment_from_world = glm::mat3(1.0f);
    std::vector<Ray> rays;
    const int columns = 2 * samples;
    for (int j = 0; j < samples; ++j) {
        const double z = (2.0 * j + 1.0) / samples - 1.0;
        const double radius = square_root(1.0 - z * z);
        for (int i = 0; i < columns; ++i) {
            const double u = (i + 0.5) / columns;
            const Vec3<double> d(radius * cosine_of_turns(u), radius * sine_of_turns(u), z);
            rays.push_back({d, light_from(upright, d), 4 * pi / (samples * columns)});
        }
    }
    return rays;
}

Vec3<double> irradiance(const std::vector<Ray>& rays, const Vec3<double>& normal) {
    Vec3<double> sum(0.0);
    for (const Ray& ray : rays)
        sum = sum + ray.light * (positive_part(dot(normal, ray.direction)) * ray.solid_angle);
    return sum;
}

}  // namespace

std::shared_ptr<const TexelImage> diffuse_environment(const Environment& environment, int height,
                                                      int samples) {
    const std::vector<Ray> rays = rays_of(environment, samples);
    const int width = 2 * height;
    std::vector<float> rgba;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const auto normal = direction_at((i + 0.5) / width, (j + 0.5) / height);
            const Vec3<double> light = irradiance(rays, normal) * (1 / pi);
            for (int c = 0; c < 3; ++c)
                rgba.push_back(static_cast<float>(light[c]));
            rgba.push_back(1.0f);
        }
    }
    return std::make_shared<const TexelImage>(width, height, rgba);
}

}  // namespace scanlight::shading
