#include "shading/microfacets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shading/blinn.h"
#include "tests/shading/hemisphere.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr FacetDistribution every_distribution[] = {
    FacetDistribution::beckmann, FacetDistribution::gauss, FacetDistribution::cosine};

template <class Real>
void expect_angle_squared(double bound) {
    Random random(1);
    for (int i = 0; i < 200000; ++i) {
        const auto c = static_cast<Real>(1 - std::exp2(random.between(-50, 0)));
        const long double angle = std::acos(static_cast<long double>(c));
        const auto exact = static_cast<double>(angle * angle);
        ASSERT_NEAR(static_cast<double>(squared_angle(c)), exact, bound * exact) << c;
    }
}

TEST(SquaredAngle, KeepsItsErrorBound) {
    expect_angle_squared<double>(5e-16);
    expect_angle_squared<float>(3e-7);
}

TEST(SquaredAngle, OfOneAndMoreIsNothing) {
    for (const float c : {1.0f, 1.0000001f, 2.0f})
        EXPECT_EQ(squared_angle(c), 0.0f);
}

template <class Real>
void expect_exp(double bound) {
    Random random(2);
    for (int i = 0; i < 200000; ++i) {
        const auto y = static_cast<Real>(random.between(0, 69));
        const double exact = std::exp(-static_cast<double>(y));
        ASSERT_NEAR(static_cast<double>(exp_of_minus(y)), exact, bound * exact) << y;
    }
}

TEST(ExpOfMinus, KeepsItsErrorBound) {
    expect_exp<double>(1e-14);
    expect_exp<float>(8e-6);
}

TEST(ExpOfMinus, FadesToNothing) {
    in_both_precisions([]<class Real>() {
        EXPECT_EQ(exp_of_minus(Real(0)), Real(1));
        EXPECT_EQ(exp_of_minus(Real(70)), Real(0));
        EXPECT_EQ(exp_of_minus(std::numeric_limits<Real>::infinity()), Real(0));
        EXPECT_EQ(exp_of_minus(std::numeric_limits<Real>::quiet_NaN()), Real(0));
    });
}

/// Seen from above, the facets cover the surface they are, neither more nor less.
TEST(FacetDensity, NormalisedCoversTheSurface) {
    for (const auto distribution : every_distribution) {
        for (const double m : {0.05, 0.1, 0.2, 0.3, 0.6, 1.0})
            EXPECT_NEAR(projected_area(FacetSlopes(distribution, m)), 1, 2e-5) << m;
    }
}

/// For Beckmann's that is exact: the mean of tan^2 over the facets, as seen from above.
TEST(FacetDensity, OfBeckmannHasTheSlopesItIsMadeWith) {
    for (const double m : {0.1, 0.3, 0.6}) {
        const FacetSlopes slopes(FacetDistribution::beckmann, m);
        const double mean = over_hemisphere(20000, 1, [&](const Vec3<double>& H) {
            const double tan2 = (1 - H.z * H.z) / (H.z * H.z);
            return facet_density(H.z, slopes) * H.z * tan2;
        });
        EXPECT_NEAR(std::sqrt(mean), m, 1e-4);
    }
}

TEST(FacetDensity, FallsAsTheFacetsLean) {
    for (const auto distribution : every_distribution) {
        for (const double m : {0.05, 0.3, 0.7}) {
            const FacetSlopes slopes(distribution, m);
            double before = std::numeric_limits<double>::infinity();
            for (int degrees = 0; degrees <= 90; ++degrees) {
                const double D = facet_density(cos_deg<double>(degrees), slopes);
                ASSERT_LE(D, before) << degrees;
                before = D;
            }
        }
    }
}

/// Of little roughness all three are about one bell.
TEST(FacetDensity, DistributionsAgreeWhereTheyAreNarrow) {
    const double m = 0.05;
    for (const double degrees : {0.0, 1.0, 2.0, 3.0}) {
        const auto at = [&](FacetDistribution distribution) {
            return facet_density(cos_deg<double>(degrees), FacetSlopes(distribution, m));
        };
        const double beckmann = at(FacetDistribution::beckmann);
        EXPECT_NEAR(at(FacetDistribution::gauss), beckmann, 0.01 * beckmann);
        EXPECT_NEAR(at(FacetDistribution::cosine), beckmann, 0.01 * beckmann);
    }
}

TEST(FacetDensity, IsANumberForAnyCosine) {
    in_both_precisions([]<class Real>() {
        for (const auto distribution : every_distribution) {
            for (const double m : {FacetSlopes::least, 0.3, FacetSlopes::most}) {
                const FacetSlopes slopes(distribution, m);
                for (const Real c : {Real(-1), Real(0), std::numeric_limits<Real>::denorm_min(),
                                     Real(1e-20), Real(0.1), Real(1), Real(1.0000002)}) {
                    const Real D = facet_density(c, slopes);
                    ASSERT_TRUE(D >= 0 && D <= slopes.constant() * 1e4 * 1.001) << c << ' ' << m;
                    ASSERT_TRUE(c > 0 || D == 0) << c << ' ' << m;
                }
            }
        }
    });
}

TEST(FacetSlopes, TakeWhatACarelessMaterialSays) {
    const auto m = [](double given) { return FacetSlopes(FacetDistribution::gauss, given).m(); };
    EXPECT_EQ(m(0), FacetSlopes::least);
    EXPECT_EQ(m(-3), FacetSlopes::least);
    EXPECT_EQ(m(std::nan("")), FacetSlopes::least);
    EXPECT_EQ(m(7), FacetSlopes::most);
    EXPECT_EQ(m(0.3), 0.3);
}

TEST(FacetSlopes, OfNoneHaveNoSlope) {
    EXPECT_EQ(rms_slope({}), 0);
}

TEST(FacetsOpen, LiesAboveZeroUpToOneAndIsTheSameBothWays) {
    Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> L = random.above(N);
        const Vec3<double> V = random.above(N);
        const Vec3<double> H = half_vector(L, V);
        const auto open = [&](const Vec3<double>& a, const Vec3<double>& b) {
            return facets_open(dot(N, H), dot(N, a), dot(N, b), dot(b, H));
        };
        ASSERT_GT(open(L, V), 0);
        ASSERT_LE(open(L, V), 1);
        ASSERT_NEAR(open(L, V), open(V, L), 1e-12);
        const double least = std::min(groove_share(dot(N, H), dot(N, L), dot(V, H)),
                                      groove_share(dot(N, H), dot(N, V), dot(V, H)));
        ASSERT_EQ(open(L, V), std::min(1.0, least));
        const double NV = dot(N, V);
        ASSERT_NEAR(NV * facets_open_by_view(dot(N, H), dot(N, L), NV, dot(V, H)), open(L, V),
                    1e-12);
    }
}

TEST(FacetsOpen, HaveNothingInTheWayAtTheMirrorDirection) {
    for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
        const double c = cos_deg<double>(degrees);
        EXPECT_EQ(facets_open(1.0, c, c, c), 1.0);
    }
}

}  // namespace
}  // namespace scanlight::shading
