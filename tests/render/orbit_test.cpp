#include "render/orbit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "render/framing.h"
#include "tests/raster/cases.h"

namespace scanlight::render {
namespace {

TEST(Orbit, GoesRoundCounterClockwiseSeenFromAbove) {
    Camera camera;
    camera.eye = {1.0, 2.0, 8.0};
    camera.target = {1.0, 0.0, 3.0};
    const Camera quarter = orbited(camera, 90.0);
    EXPECT_NEAR(glm::distance(quarter.eye, glm::dvec3(6.0, 2.0, 3.0)), 0.0, 1e-12);
    EXPECT_EQ(quarter.target, camera.target);
    EXPECT_NEAR(glm::distance(orbited(camera, 360.0).eye, camera.eye), 0.0, 1e-12);
}

/// How much of the way from the picture's middle to its border the points of a ring come.
double reach(const Camera& camera, const Ring& ring, double elevation_deg, double distance,
             double aspect) {
    Camera placed = camera;
    double most = 0.0;
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
        placed.target = glm::dvec3(0.0);
        placed.eye = distance * direction_of({static_cast<double>(azimuth), elevation_deg});
        if (camera.projection == Projection::orthographic)
            placed.magnification = camera.magnification / distance;
        const glm::dvec4 p = clip_from_eye(placed, aspect) * eye_from_world(placed) *
                             glm::dvec4(ring.radius, ring.height, 0.0, 1.0);
        EXPECT_GT(p.w, 0.0);
        most = std::max({most, std::abs(p.x / p.w), std::abs(p.y / p.w)});
    }
    return most;
}

/// Up to the margin of 6 percent.
TEST(Orbit, WhatIsSeenJustFillsThePicture) {
    raster::laws::Random random(3);
    for (int i = 0; i < 60; ++i) {
        Camera camera;
        camera.magnification = magnification_from_fov(random.real(10.0f, 100.0f));
        if (random.one_in(2)) camera.projection = Projection::orthographic;
        const Ring ring{random.real(0.1f, 2.0f), random.real(-2.0f, 2.0f)};
        const double elevation = random.real(-80.0f, 80.0f);
        const double aspect = random.real(0.5f, 2.0f);
        const double distance = distance_for_orbit(camera, {&ring, 1}, elevation, aspect);
        EXPECT_NEAR(reach(camera, ring, elevation, distance, aspect), 1.0 / 1.06, 2e-3);
    }
}

TEST(Smoothly, GoesThroughTheValuesAndStandsStillOutside) {
    const std::vector<double> times{0.1, 0.3, 0.8};
    const std::vector<double> values{2.0, -1.0, 5.0};
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_DOUBLE_EQ(smoothly(times, values, times[i]), values[i]);
    EXPECT_EQ(smoothly(times, values, 0.0), 2.0);
    EXPECT_EQ(smoothly(times, values, 1.0), 5.0);
    EXPECT_EQ(smoothly(std::vector{0.5}, std::vector{7.0}, 0.2), 7.0);
}

TEST(Smoothly, HasNoCorners) {
    const std::vector<double> times{0.0, 0.3, 0.8, 1.0};
    const std::vector<double> values{2.0, -1.0, 5.0, 4.0};
    constexpr double h = 1e-6;
    for (const double t : {0.3, 0.8}) {
        const double at = smoothly(times, values, t);
        const double before = (at - smoothly(times, values, t - h)) / h;
        const double after = (smoothly(times, values, t + h) - at) / h;
        EXPECT_NEAR(before, after, 1e-3);
    }
}

/// Straight lines stay straight, whatever the times.
TEST(Smoothly, KeepsAnEvenPace) {
    const std::vector<double> times{0.0, 0.1, 0.7, 1.0};
    const std::vector<double> values{1.0, 1.2, 2.4, 3.0};
    for (double t = 0.0; t < 1.0; t += 0.01)
        EXPECT_NEAR(smoothly(times, values, t), 1.0 + 2.0 * t, 1e-12);
}

}  // namespace
}  // namespace scanlight::render
