// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "contracts.hpp"
#include "ideotype/core/clock.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/core/hash.hpp"
#include "ideotype/core/mesh.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/core/routine.hpp"
#include "ideotype/core/sobol.hpp"
#include "ideotype/core/stop_flag.hpp"
#include "ideotype/core/text.hpp"

namespace ideotype {

namespace {

Mesh one_face() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            {{0, 1, 2, 3}},
            {0},
            {{"leaf"}}};
}

Routine<int> answer() {
    co_return 42;
}

void add_after_the_end() {
    Sha256 sum;
    sum.finish();
    sum.add("more");
}

void finish_twice() {
    Sha256 sum;
    sum.finish();
    sum.finish();
}

void start_what_has_ended() {
    Routine<int> routine = answer();
    routine.start();
    routine.start();
}

void ask_what_has_moved() {
    Routine<int> routine = answer();
    const Routine<int> other = std::move(routine);
    routine.has_ended();  // NOLINT(bugprone-use-after-move)
}

}  // namespace

TEST(Contracts, OfTimesAndErrorsAreNoticed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_noticed({
        {"std::isfinite(utc_offset)", [=] { clock_name(nan); }},
        {"hour >= -24 && hour < 48", [] { clock_time(48); }},
        {"hour >= -24 && hour < 48", [=] { clock_time(nan); }},
        {"!problems_.empty()", [] { throw InputError({}); }},
        {"where.line >= 0 && where.column >= 0",
         [] {
             to_string(Problem{{"file", 1, -1}, "wrong"});
         }},
    });
}

TEST(Contracts, OfNumbersAreNoticed) {
    expect_noticed({
        {"!(incident < 0)",
         [] {
             fraction_of(Estimate{1, 0}, -2);
         }},
        {"lower <= upper",
         [] { RandomStream(1, Purpose::mutation).uniform(2, 1); }},
        {"n > 0", [] { RandomStream(1, Purpose::mutation).below(0); }},
        {"dimension < sobol_dimensions", [] { sobol(1, sobol_dimensions); }},
    });
}

TEST(Contracts, OfMeshesAreNoticed) {
    expect_noticed({
        {"std::ranges::max(face) < mesh.vertices.size()",
         [] {
             Mesh mesh = one_face();
             mesh.faces[0][2] = 4;
             face_areas(mesh);
         }},
        {"mesh.face_group.size() == mesh.faces.size()",
         [] {
             Mesh mesh = one_face();
             mesh.face_group.clear();
             plant_area(mesh);
         }},
        {"mesh.face_group[f] < mesh.groups.size()",
         [] {
             Mesh mesh = one_face();
             mesh.face_group[0] = 1;
             plant_area(mesh);
         }},
    });
}

TEST(Contracts, OfUseOnceAreNoticed) {
    expect_noticed({
        {"context_ != nullptr", add_after_the_end},
        {"context_ != nullptr", finish_twice},
        {"handle_ && !handle_.done()", start_what_has_ended},
        {"handle_", ask_what_has_moved},
        {"handle_ && handle_.done()", [] { answer().result(); }},
        {"!is_owned",
         [] {
             const StopFlag one;
             const StopFlag another;
         }},
        {"seconds >= 0", [] { StopFlag().request_after(-1); }},
    });
}

TEST(Contracts, OfScannersAreNoticed) {
    expect_noticed({
        {"least <= most", [] { Scanner("12").digits(2, 1); }},
        {"most <= 9", [] { Scanner("12").number(1, 10); }},
    });
}

}  // namespace ideotype
