#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/physiology/hyperbola.hpp"
#include "ideotype/physiology/response_table.hpp"

namespace ideotype {
namespace {

ResponseTable table_of(const Hyperbola& f, double tolerance) {
    return {[f](double light) { return f.gross(light); }, f.slope(0), 2500,
            tolerance};
}

TEST(ResponseTable, StaysWithinItsBoundBelowTheResponse) {
    for (const double theta : {0., .7, .95})
        for (const double tolerance : {1., 1e-2, 1e-4}) {
            const Hyperbola f{.06, theta, 50};
            const ResponseTable table = table_of(f, tolerance);
            EXPECT_LE(table.error_bound(), tolerance);
            double largest = 0;
            for (int i = 0; i <= 100000; ++i) {
                const double light = .025 * i;
                const double below = f.gross(light) - table(light);
                EXPECT_GE(below, -1e-12);
                largest = std::max(largest, below);
            }
            EXPECT_LE(largest, table.error_bound() + 1e-12);
            // The bound is no wild guess either.
            EXPECT_GT(largest, table.error_bound() / 8);
        }
}

TEST(ResponseTable, IsConcave) {
    const ResponseTable table = table_of({}, 1e-2);
    double before = 1;
    for (int i = 0; i < 3000; ++i) {
        const double rise = table(i + 1.) - table(i);
        EXPECT_LE(rise, before + 1e-12);
        before = rise;
    }
}

TEST(ResponseTable, KnowsTheResponseBeyondItsEnd) {
    const ResponseTable table = table_of({}, 1e-2);
    EXPECT_EQ(table(4000), Hyperbola{}.gross(4000));
    EXPECT_NEAR(table(2500), Hyperbola{}.gross(2500), 1e-12);
    EXPECT_EQ(table(0), 0);
}

TEST(ResponseTable, ChordsAreThoseOfTheResponse) {
    const Hyperbola f;
    const ResponseTable table = table_of(f, 1e-5);
    for (const double light : {0., 30., 700., 2400.}) {
        EXPECT_NEAR(table.chord(light, 0), f.slope(light), 1e-4);
        EXPECT_NEAR(table.chord(light, 1e-9), f.slope(light), 1e-4);
        for (const double more : {1e-3, 10., 1500.})
            EXPECT_NEAR(table.chord(light, more),
                        (f.gross(light + more) - f.gross(light)) / more, 1e-4);
        EXPECT_LE(table.chord(light, 1e-3), f.phi);
    }
}

TEST(ResponseTable, OfALineIsExact) {
    const ResponseTable table([](double light) { return .06 * light; }, .06,
                              2000, 1e-9);
    EXPECT_LE(table.error_bound(), 1e-9);
    EXPECT_EQ(table.pieces(), 2U);
    EXPECT_NEAR(table(1234.5), .06 * 1234.5, 1e-12);
    EXPECT_NEAR(table.chord(300, 1e-6), .06, 1e-15);
}

TEST(ResponseTable, RefusesWhatIsNotConcave) {
    const auto square = [](double light) { return light * light; };
    EXPECT_THROW(ResponseTable(square, 0, 10, 1e-3), Error);
    const auto falling = [](double light) { return light * (5 - light); };
    EXPECT_THROW(ResponseTable(falling, 5, 10, 1e-3), Error);
    const auto steep = [](double light) { return light; };
    EXPECT_THROW(ResponseTable(steep, .5, 10, 1e-3), Error);
    EXPECT_THROW(ResponseTable(steep, 1, 0, 1e-3), Error);
    EXPECT_THROW(ResponseTable(steep, 1, 10, 0), Error);
}

TEST(ResponseTable, OfAKinkEnds) {
    const auto kink = [](double light) { return std::min(light, 3.7); };
    const ResponseTable table(kink, 1, 10, 1e-4);
    EXPECT_NEAR(table(3.7), 3.7, 1e-4);
    EXPECT_THROW(ResponseTable(kink, 1, 10, 1e-14), Error);
}

}  // namespace
}  // namespace ideotype
