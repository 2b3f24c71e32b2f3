// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/light_classes.hpp"

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "ideotype/light/sunlit.hpp"
#include "leaf_places.hpp"

namespace ideotype {

namespace {

//! Adds an area spread evenly over 20 umol m-2 s-1 around its light. Classes
//! then change smoothly with light that contains noise.
void add(std::vector<double>& classes, double ppfd, double area) {
    constexpr double reach = 10;
    const std::size_t upper = class_of(ppfd + reach);
    const std::size_t lower = class_of(ppfd - reach);
    const double above =
        upper == lower ? 1 : (ppfd + reach - class_begin(upper)) / (2 * reach);
    classes[upper] += above * area;
    classes[lower] += (1 - above) * area;
}

//! A triangle hit by a beam, with the beam's light on it.
struct Hit {
    std::uint32_t place;
    double cosine;
    double absorptance;
    //! Area from all randomisations, then without each [m2 m-2].
    std::vector<double> area;
};

//! Returns the mean over all randomisations, followed by the means without each
//! one.
std::vector<double> all_and_without(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0;
    for (const double x : values) sum += x;
    std::vector<double> means{sum / n};
    for (const double x : values)
        means.push_back(n > 1 ? (sum - x) / (n - 1) : sum);
    return means;
}

class Classification {
  public:
    Classification(const std::vector<Tally>& tallies, const Pieces& pieces,
                   const LitLeaves& lit)
        : tallies_(tallies),
          lit_leaves_(lit),
          light_(lit.par.light),
          places_(pieces, lit, tallies),
          classes_(tallies.size() + 1, LightClasses(ppfd_classes)) {
        for (std::size_t s = 0; s < light_.light.sources.size(); ++s)
            diffuse_.push_back(diffuse_of(static_cast<int>(s)));
    }

    std::vector<LightClasses> result() {
        const LightSeries& series = light_.series;
        const double lit = series.lit_seconds();
        for (int beam = -1;
             beam < static_cast<int>(light_.light.sources.size()); ++beam) {
            const std::vector<Hit> hits = hits_of(beam);
            for (std::size_t i = 0; i < series.steps.size(); ++i)
                if (light_.beam_of[i] == beam && series.steps[i].is_lit())
                    add_step(i, series.steps[i].seconds / lit, hits);
        }
        return values();
    }

  private:
    //! Returns the diffuse light per leaf area by place [J m-2]: from all
    //! randomisations, then without each one.
    std::vector<std::vector<double>> diffuse_of(int source) const {
        DiffuseLight all(tallies_, source, places_.pieces());
        std::vector<std::vector<double>> result{places_.expected(all)};
        const auto n = static_cast<double>(tallies_.size());
        const double scale = n > 1 ? n / (n - 1) : 1;
        for (const auto& parts : all.parts) {
            DiffuseLight without = all;
            if (n > 1)
                for (const auto& [v, energy] : parts) without.sum[v] -= energy;
            for (double& sum : without.sum) sum *= scale;
            result.push_back(places_.expected(without));
        }
        return result;
    }

    bool is_leaf(std::size_t place) const {
        return !lit_leaves_.leaves[places_.group[place]].organ;
    }

    std::vector<Hit> hits_of(int beam) const {
        std::vector<Hit> hits;
        if (beam < 0) return hits;
        const auto s = static_cast<std::size_t>(beam);
        const Source& source = light_.light.sources[s];
        if (!source.direction) return hits;
        const RayScene& scene = lit_leaves_.scene;
        std::vector<std::size_t> number(scene.surfaces().normals.size());
        for (std::size_t r = 0; r < tallies_.size(); ++r)
            for (const auto& [t, energy] : tallies_[r].leaf_light[s].beam) {
                const std::uint32_t place =
                    places_.of[scene.surfaces().face_group[t / 2]];
                if (!is_leaf(place)) continue;
                const double cosine = beam_cosine(scene, t, *source.direction);
                if (!(cosine > 0)) continue;
                if (number[t] == 0) {
                    hits.push_back({place, cosine,
                                    beam_absorptance(scene, lit_leaves_.groups,
                                                     lit_leaves_.par.optics, t,
                                                     *source.direction),
                                    std::vector<double>(tallies_.size())});
                    number[t] = hits.size();
                }
                Hit& hit = hits[number[t] - 1];
                hit.area[r] +=
                    energy / (source.energy * hit.absorptance * cosine);
            }
        for (Hit& hit : hits) hit.area = all_and_without(hit.area);
        return hits;
    }

    void add_step(std::size_t i, double weight, const std::vector<Hit>& hits) {
        const Irradiance& par = light_.series.steps[i].par;
        for (std::size_t r = 0; r < classes_.size(); ++r) {
            std::vector<double> shaded(places_.count());
            const auto add_source = [&](int source, double irradiance) {
                if (source < 0) return;
                const auto s = static_cast<std::size_t>(source);
                const double scale = irradiance * lit_leaves_.photons /
                                     light_.light.sources[s].energy;
                for (std::size_t p = 0; p < shaded.size(); ++p)
                    shaded[p] += scale * diffuse_[s][r][p];
            };
            add_source(light_.beam_of[i], par.beam);
            add_source(light_.sky_of[i], par.diffuse);
            LightClasses& classes = classes_[r];
            for (std::size_t p = 0; p < shaded.size(); ++p)
                if (is_leaf(p))
                    add(classes.shaded, shaded[p], weight * places_.index[p]);
            for (const Hit& hit : hits) {
                const double area = weight * hit.area[r];
                add(classes.shaded, shaded[hit.place], -area);
                add(classes.sunlit,
                    shaded[hit.place] + hit.absorptance * par.beam *
                                            lit_leaves_.photons * hit.cosine,
                    area);
            }
        }
    }

    //! Returns classes by randomisation. Their mean is the estimate from all
    //! randomisations; their scatter is that of jackknife pseudo-values.
    std::vector<LightClasses> values() const {
        const auto n = static_cast<double>(tallies_.size());
        std::vector<LightClasses> result(tallies_.size(),
                                         LightClasses(ppfd_classes));
        for (auto part : {&LightClasses::sunlit, &LightClasses::shaded})
            for (std::size_t c = 0; c < ppfd_classes; ++c) {
                double without = 0;
                for (std::size_t r = 1; r < classes_.size(); ++r)
                    without += (classes_[r].*part)[c] / n;
                for (std::size_t r = 0; r < result.size(); ++r)
                    (result[r].*part)[c] =
                        (classes_[0].*part)[c] +
                        (n - 1) * (without - (classes_[r + 1].*part)[c]);
            }
        return result;
    }

    const std::vector<Tally>& tallies_;
    const LitLeaves& lit_leaves_;
    const SeriesIllumination& light_;
    LeafPlaces places_;
    //! Diffuse light [source][all, then without each][place].
    std::vector<std::vector<std::vector<double>>> diffuse_;
    //! Areas from all randomisations, then without each.
    std::vector<LightClasses> classes_;
};

}  // namespace

std::vector<LightClasses> leaf_area_by_light(const std::vector<Tally>& tallies,
                                             const Pieces& pieces,
                                             const LitLeaves& lit) {
    IDEOTYPE_EXPECT(!tallies.empty() && lit.photons > 0);
    return Classification(tallies, pieces, lit).result();
}

LightClassReport report(const std::vector<LightClasses>& randomisations) {
    IDEOTYPE_EXPECT(!randomisations.empty());
    LightClassReport result;
    const auto take = [&](std::vector<double> LightClasses::*part,
                          std::vector<Estimate>& to) {
        for (std::size_t c = 0; c < ppfd_classes; ++c)
            to.push_back(
                estimate(mapped(randomisations, [&](const LightClasses& each) {
                    return (each.*part)[c];
                })));
    };
    take(&LightClasses::sunlit, result.sunlit);
    take(&LightClasses::shaded, result.shaded);
    return result;
}

}  // namespace ideotype
