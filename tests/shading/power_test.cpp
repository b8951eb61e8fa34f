#include "shading/power.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/shading/precision.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr double exponents[] = {0, 0.25, 0.5, 1, 2, 3, 20, 96.078431, 1000, 2000, 65536};
constexpr long double flushed_below = 0x1p-100L;

template <class Real>
constexpr long double half_ulp = std::numeric_limits<Real>::epsilon() / 2;

long double exact_power(long double x, double n) {
    return std::pow(x, static_cast<long double>(n));
}

/// As `power` states it.
template <class Real>
long double relative_bound(const Exponent& n, long double exact) {
    if (n.is_whole()) return static_cast<long double>(n.value()) * half_ulp<Real>;
    if constexpr (std::is_same_v<Real, float>) return exact < 0.125L ? 3e-5L : 1e-6L;
    return exact < 0.125L ? 5e-14L : 2e-15L;
}

template <class Real>
void expect_power(Real x, double exponent) {
    const Exponent n(exponent);
    const long double exact = exact_power(static_cast<long double>(x), exponent);
    const long double actual = static_cast<long double>(power(x, n));
    if (exact < flushed_below * 1.01L && actual == 0) return;
    ASSERT_GE(exact, flushed_below * 0.99L) << "x = " << x << ", n = " << exponent;
    ASSERT_LE(std::abs(actual - exact), relative_bound<Real>(n, exact) * exact)
        << "x = " << x << ", n = " << exponent << ", got " << actual << " for " << exact;
}

/// A base whose power by n spreads over everything above the flush.
double random_base(Random& random, double n) {
    const double least_log2 = -random.between(0, 101);
    const double power_log2 = least_log2 * random.between(0, 1);
    return std::exp2(n > 0.9 ? power_log2 / n : power_log2);
}

TEST(Power, KeepsItsErrorBoundInFloatAndDouble) {
    in_both_precisions([]<class Real>() {
        Random random(1);
        for (const double n : exponents)
            for (int i = 0; i < 20000; ++i)
                expect_power(static_cast<Real>(random_base(random, n)), n);
    });
}

TEST(Power, KeepsItsErrorBoundForRandomExponents) {
    in_both_precisions([]<class Real>() {
        Random random(2);
        for (int i = 0; i < 100000; ++i) {
            const double n = std::exp2(random.between(-3, 24));
            expect_power(static_cast<Real>(random_base(random, n)), n);
        }
    });
}

TEST(Power, OfZeroIsZeroButOneForExponentZero) {
    in_both_precisions([]<class Real>() {
        EXPECT_EQ(power(Real(0), 0), Real(1));
        EXPECT_EQ(power(Real(0), 0.25), Real(0));
        EXPECT_EQ(power(Real(0), 1), Real(0));
        EXPECT_EQ(power(Real(0), 96.078431), Real(0));
        EXPECT_EQ(power(Real(0), 65536), Real(0));
    });
}

TEST(Power, OfOneIsExactlyOne) {
    in_both_precisions([]<class Real>() {
        for (const double n : exponents)
            EXPECT_EQ(power(Real(1), n), Real(1)) << n;
        EXPECT_EQ(power(Real(1), 1e300), Real(1));
    });
}

TEST(Power, ExponentZeroGivesOneAndExponentOneTheBase) {
    in_both_precisions([]<class Real>() {
        Random random(3);
        for (int i = 0; i < 1000; ++i) {
            const Real x = static_cast<Real>(random.between(0, 1));
            ASSERT_EQ(power(x, 0), Real(1));
            ASSERT_EQ(power(x, 1), x);
            ASSERT_EQ(power(x, 2), x * x);
        }
    });
}

TEST(Power, OfDenormalNumbersIsZero) {
    in_both_precisions([]<class Real>() {
        const Real denormal = std::numeric_limits<Real>::denorm_min();
        EXPECT_EQ(power(denormal, 0), Real(1));
        EXPECT_EQ(power(denormal, 0.25), Real(0));
        EXPECT_EQ(power(denormal, 1), Real(0));
        EXPECT_EQ(power(denormal, 65536), Real(0));
    });
}

TEST(Power, JustBelowOneKeepsItsBound) {
    in_both_precisions([]<class Real>() {
        Real x = 1;
        for (int ulps = 1; ulps <= 1000; ++ulps) {
            x = std::nextafter(x, Real(0));
            for (const double n : exponents)
                expect_power(x, n);
        }
    });
}

TEST(Power, OutsideItsDomainIsStillANumberBetweenZeroAndOne) {
    in_both_precisions([]<class Real>() {
        const Real infinity = std::numeric_limits<Real>::infinity();
        for (const double n : {0.5, 1.0, 20.0, 96.078431}) {
            EXPECT_EQ(power(Real(-0.5), n), Real(0));
            EXPECT_EQ(power(-infinity, n), Real(0));
            EXPECT_EQ(power(std::numeric_limits<Real>::quiet_NaN(), n), Real(0));
            EXPECT_EQ(power(Real(1.0001), n), Real(1));
            EXPECT_EQ(power(infinity, n), Real(1));
        }
    });
}

TEST(Power, OfWholeExponentsNeverDecreasesInTheBase) {
    in_both_precisions([]<class Real>() {
        for (const double n : {1.0, 2.0, 3.0, 20.0, 1000.0, 65536.0}) {
            Real smaller = 0;
            const double flushed = std::exp2(-101 / n);
            for (int i = 0; i <= 20000; ++i) {
                const Real x = static_cast<Real>(flushed + (1 - flushed) * (i / 20000.0));
                const Real larger = power(x, n);
                ASSERT_GE(larger, smaller) << "x = " << x << ", n = " << n;
                smaller = larger;
            }
        }
    });
}

TEST(Power, OfOtherExponentsDecreasesInTheBaseByNoMoreThanItsError) {
    in_both_precisions([]<class Real>() {
        const Exponent n(96.078431);
        Real smaller = 0;
        for (int i = 0; i <= 60000; ++i) {
            const Real x = static_cast<Real>(0.4 + 1e-5 * i);
            const Real larger = power(x, n);
            const auto bound = static_cast<Real>(2 * relative_bound<Real>(n, larger));
            ASSERT_GE(larger, smaller - bound * smaller) << "x = " << x;
            smaller = larger;
        }
    });
}

TEST(Power, LeavesNoDenormalsBehind) {
    Random random(4);
    for (int i = 0; i < 100000; ++i) {
        const double n = std::exp2(random.between(-2, 24));
        const float value = power(static_cast<float>(std::exp2(-random.between(0, 300) / n)), n);
        ASSERT_TRUE(value == 0 || value >= 0x1p-101f) << value << " for n = " << n;
    }
}

TEST(Power, FlushesAtTwoToTheMinusHundred) {
    EXPECT_EQ(power(0x1p-50, 2), 0x1p-100);
    EXPECT_EQ(power(std::nextafter(0x1p-50, 0.0), 2), 0.0);
    EXPECT_EQ(power(0x1p-5, 20), 0x1p-100);
    EXPECT_EQ(power(0x1p-200, 0.25), 0.0);  // below 2^-126 for any exponent
    EXPECT_EQ(power(0x1p-126, 0.5), 0x1p-63);
}

TEST(Power, GoesOverFromSquaringToSeriesWithoutAStep) {
    const double x = 0.99999;
    const double squared = power(x, 65536);
    const double series = power(x, 65537);
    EXPECT_NEAR(series / squared, x, 1e-10);
}

TEST(Exponent, KnowsItsKind) {
    EXPECT_TRUE(Exponent(0).is_whole());
    EXPECT_TRUE(Exponent(65536).is_whole());
    EXPECT_EQ(Exponent(65536).whole(), 65536u);
    EXPECT_FALSE(Exponent(65537).is_whole());
    EXPECT_FALSE(Exponent(0.5).is_whole());
}

TEST(Exponent, TakesWhatACarelessMaterialSays) {
    EXPECT_EQ(Exponent(-5).value(), 0);
    EXPECT_EQ(Exponent(std::numeric_limits<double>::quiet_NaN()).value(), 0);
    EXPECT_EQ(Exponent(std::numeric_limits<double>::infinity()).value(), 0x1p24);
}

TEST(Log2, KeepsItsErrorBound) {
    in_both_precisions([]<class Real>() {
        const long double bound = std::is_same_v<Real, double> ? 5e-16L : 3e-7L;
        Random random(5);
        for (int i = 0; i < 200000; ++i) {
            const double away = std::exp2(-random.between(0, 30));
            const Real x =
                static_cast<Real>(i % 2 == 0 ? 1 - away : std::exp2(random.between(-126, 1)));
            if (!(x > 0)) continue;
            const long double exact = std::log2(static_cast<long double>(x));
            const long double error = std::abs(static_cast<long double>(log2_of(x)) - exact);
            ASSERT_LE(error, bound * std::abs(exact)) << "x = " << x;
        }
    });
}

TEST(Exp2, KeepsItsErrorBound) {
    in_both_precisions([]<class Real>() {
        const long double bound = std::is_same_v<Real, double> ? 4e-16L : 2e-7L;
        Random random(6);
        for (int i = 0; i < 200000; ++i) {
            const Real t = static_cast<Real>(random.between(-126, 126));
            const long double exact = std::exp2(static_cast<long double>(t));
            const long double error = std::abs(static_cast<long double>(exp2_of(t)) - exact);
            ASSERT_LE(error, bound * exact) << "t = " << t;
        }
    });
}

TEST(Log2AndExp2, AreExactForPowersOfTwo) {
    in_both_precisions([]<class Real>() {
        for (int e = -126; e <= 126; ++e) {
            const Real x = std::ldexp(Real(1), e);
            EXPECT_EQ(log2_of(x), static_cast<Real>(e));
            EXPECT_EQ(exp2_of(static_cast<Real>(e)), x);
        }
    });
}

/// Pins the bits themselves: a machine or compiler on which one of these differs would draw other
/// pictures.
TEST(Power, HasTheseBits) {
    EXPECT_EQ(power(0.9f, 20), 0x1.f1fa4cp-4f);
    EXPECT_EQ(power(0.9f, 20.5), 0x1.d86c56p-4f);
    EXPECT_EQ(power(0.999f, 96.078431), 0x1.d11348p-1f);
    EXPECT_EQ(power(0.9, 20.5), 0x1.d86c63459d33ap-4);
    EXPECT_EQ(power(0.999, 96.078431), 0x1.d1132220b1844p-1);
}

}  // namespace
}  // namespace scanlight::shading
