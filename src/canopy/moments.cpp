// SPDX-License-Identifier: Apache-2.0
#include "moments.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/core/wide_vectors.hpp"

namespace ideotype {

namespace {

//! The terms of MomentArrays, for loops in which arrays do not overlap.
template <class Number>
struct Terms {
    template <class Arrays>
    explicit Terms(Arrays& of)
        : one(of.one.data()),
          sun(of.sun.data()),
          sky(of.sky.data()),
          sun2(of.sun2.data()),
          sun_sky(of.sun_sky.data()),
          sky2(of.sky2.data()) {}

    Number *one, *sun, *sky, *sun2, *sun_sky, *sky2;
};

}  // namespace

IDEOTYPE_FOR_WIDE_VECTORS void add_light(const Scales& scales,
                                         const std::vector<double>& of_sun,
                                         const std::vector<double>& of_sky,
                                         std::vector<double>& light) {
    const std::size_t count = light.size();
    const double sun = scales.of_sun, sky = scales.of_sky;
    const double *const from_sun = of_sun.data(), *const from_sky =
                                                      of_sky.data();
    double* const __restrict all = light.data();
    for (std::size_t p = 0; p < count; ++p)
        all[p] = sun * from_sun[p] + sky * from_sky[p];
}

IDEOTYPE_FOR_WIDE_VECTORS void add_beams(
    double beam, const std::vector<double>& per_beam,
    const std::vector<std::uint32_t>& place, const Responses& shaded,
    std::vector<double>& beams, std::vector<double>& light) {
    const std::size_t count = place.size();
    const double* const per = per_beam.data();
    const std::uint32_t* const at = place.data();
    const double* const diffuse = shaded.light.data();
    double* const __restrict own = beams.data();
    double* const __restrict all = light.data();
    for (std::size_t b = 0; b < count; ++b) {
        const double more = beam * per[b];
        own[b] = more;
        all[b] = diffuse[at[b]] + more;
    }
}

IDEOTYPE_FOR_WIDE_VECTORS void find_gains(
    const Responses& shaded, const Responses& lit,
    const std::vector<std::uint32_t>& place, const std::vector<double>& beams,
    Responses& gains) {
    const std::size_t count = place.size();
    const std::uint32_t* const at = place.data();
    const double *const v0 = shaded.value.data(),
                        *const s0 = shaded.slope.data(),
                        *const c0 = shaded.curvature.data();
    const double *const v1 = lit.value.data(), *const s1 = lit.slope.data(),
                        *const c1 = lit.curvature.data();
    const double* const beam = beams.data();
    double* const __restrict value = gains.value.data();
    double* const __restrict slope = gains.slope.data();
    double* const __restrict curvature = gains.curvature.data();
    for (std::size_t b = 0; b < count; ++b) {
        const std::uint32_t p = at[b];
        const Expansion of =
            gain({v0[p], s0[p], c0[p]}, {v1[b], s1[b], c1[b]}, beam[b]);
        value[b] = of.value;
        slope[b] = of.slope;
        curvature[b] = of.curvature;
    }
}

IDEOTYPE_FOR_WIDE_VECTORS void bound_curvatures(const Scales& scales,
                                                const MomentArrays& moments,
                                                Responses& responses) {
    const std::size_t count = moments.size();
    const Scales by = scales;
    const Terms<const double> of(moments);
    const double* const value = responses.value.data();
    double* const __restrict curvature = responses.curvature.data();
    // Avoids division by 0.
    constexpr double least = 1e-300;
    for (std::size_t i = 0; i < count; ++i) {
        const double second =
            by.second({0, 0, curvature[i]},
                      {0, 0, 0, of.sun2[i], of.sun_sky[i], of.sky2[i]});
        const double most = std::abs(value[i] * of.one[i]);
        curvature[i] *= std::min(1., most / std::max(std::abs(second), least));
    }
}

namespace {

//! The loop of weigh(). Sums of weights are read and written once.
template <bool is_kept>
[[gnu::always_inline]] inline void weigh_all(
    const Scales scales, std::size_t count, const double* __restrict value,
    const double* __restrict slope, const double* __restrict curvature,
    double times, const Terms<const double>& moments, const Terms<double>& sums,
    const Terms<double>& own, double* __restrict amounts) {
    for (std::size_t i = 0; i < count; ++i) {
        const Moments w =
            scales.weigh({value[i], slope[i], curvature[i]}, times);
        amounts[i] =
            w.dot({moments.one[i], moments.sun[i], moments.sky[i],
                   moments.sun2[i], moments.sun_sky[i], moments.sky2[i]});
    }
    const auto keep = [&](double* __restrict all, double* __restrict kept,
                          const auto& term) {
        for (std::size_t i = 0; i < count; ++i) {
            const double w =
                term(scales.weigh({value[i], slope[i], curvature[i]}, times));
            if constexpr (is_kept) kept[i] = w;
            all[i] += w;
        }
    };
    keep(sums.one, own.one, [](const Moments& w) { return w.one; });
    keep(sums.sun, own.sun, [](const Moments& w) { return w.sun; });
    keep(sums.sky, own.sky, [](const Moments& w) { return w.sky; });
    keep(sums.sun2, own.sun2, [](const Moments& w) { return w.sun2; });
    keep(sums.sun_sky, own.sun_sky, [](const Moments& w) { return w.sun_sky; });
    keep(sums.sky2, own.sky2, [](const Moments& w) { return w.sky2; });
}

}  // namespace

IDEOTYPE_FOR_WIDE_VECTORS void weigh(const Scales& scales,
                                     const Responses& responses, double times,
                                     const MomentArrays& moments,
                                     MomentArrays& all, MomentArrays* own,
                                     std::vector<double>& amounts) {
    const std::size_t count = moments.size();
    amounts.resize(count);
    const Terms<const double> of(moments);
    const Terms<double> sums(all);
    if (own)
        weigh_all<true>(scales, count, responses.value.data(),
                        responses.slope.data(), responses.curvature.data(),
                        times, of, sums, Terms<double>(*own), amounts.data());
    else
        weigh_all<false>(scales, count, responses.value.data(),
                         responses.slope.data(), responses.curvature.data(),
                         times, of, sums, sums, amounts.data());
}

IDEOTYPE_FOR_WIDE_VECTORS void add_weights(const MomentArrays& more,
                                           const std::vector<double>& factors,
                                           MomentArrays& all) {
    const std::size_t count = factors.size();
    const double* const factor = factors.data();
    const auto add = [&](const std::vector<double>& from,
                         std::vector<double>& into) {
        const double* const __restrict x = from.data();
        double* const __restrict sum = into.data();
        for (std::size_t i = 0; i < count; ++i) sum[i] += factor[i] * x[i];
    };
    add(more.one, all.one);
    add(more.sun, all.sun);
    add(more.sky, all.sky);
    add(more.sun2, all.sun2);
    add(more.sun_sky, all.sun_sky);
    add(more.sky2, all.sky2);
}

}  // namespace ideotype
