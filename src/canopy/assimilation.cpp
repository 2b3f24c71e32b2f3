#include "ideotype/canopy/assimilation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! Sums of replicates, and what is left of them without one.
//! @param values [replicate][place]
std::vector<std::vector<double>> with_and_without(
    std::vector<std::vector<double>> values) {
    const std::size_t n = values.size();
    std::vector<double> sum(values.front().size());
    for (const std::vector<double>& one : values)
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one[i];
    if (n > 1)
        for (std::vector<double>& one : values)
            for (std::size_t i = 0; i < sum.size(); ++i)
                one[i] = (sum[i] - one[i]) / static_cast<double>(n - 1);
    for (double& x : sum) x /= static_cast<double>(n);
    if (n == 1) return {sum};
    values.insert(values.begin(), std::move(sum));
    return values;
}

//! The beam of one source on the triangles that it meets, in the order of
//! pieces.
struct SunlitLeaves {
    std::vector<std::uint32_t> piece;
    //! Beam on the leaf over that on level ground.
    std::vector<double> cosine;
    //! Mean light of all randomisations, then without each [J m-2].
    std::vector<std::vector<double>> energy;
};

class Assimilation {
  public:
    Assimilation(const std::vector<Tally>& tallies, const Scene& scene,
                 const Pieces& pieces, const Optics& optics,
                 const SeriesIllumination& light,
                 const Photosynthesis& photosynthesis,
                 const std::vector<LeafRates>& rates)
        : tallies_(tallies),
          scene_(scene),
          pieces_(pieces),
          absorptance_(1 - optics.leaf.scattered()),
          light_(light),
          photosynthesis_(photosynthesis),
          rates_(rates),
          diffuse_(light.light.sources.size()) {
        for (const double area : pieces.area)
            index_.push_back(area / scene.ground_area());
        for (std::size_t s = 0; s < diffuse_.size(); ++s)
            diffuse_[s] = with_and_without(diffuse_of(s));
    }

    std::vector<AssimilationTally> result(const Layers& layers) {
        const std::size_t samples =
            tallies_.size() > 1 ? tallies_.size() + 1 : 1;
        all_.assign(samples, {std::vector<double>(rates_.size()),
                              std::vector<double>(layers.count),
                              std::vector<double>(light_.series.steps.size())});
        for (const double height : pieces_.height)
            layer_.push_back(layers.at(height));
        // Steps with the same sun share what it shines on.
        for (std::size_t s = 0; s < diffuse_.size(); ++s) {
            if (!light_.light.sources[s].direction) continue;
            const SunlitLeaves sunlit = sunlit_by(s);
            for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
                if (light_.beam_of[i] == static_cast<int>(s)) add(i, sunlit);
        }
        const SunlitLeaves none{
            {}, {}, std::vector(samples, std::vector<double>())};
        for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
            if (light_.beam_of[i] < 0) add(i, none);
        return pseudo_values();
    }

  private:
    std::vector<std::vector<double>> diffuse_of(std::size_t source) const {
        std::vector<std::vector<double>> values;
        for (const Tally& tally : tallies_) {
            values.push_back(tally.leaf_light[source].diffuse);
            values.back().resize(pieces_.count);
        }
        return values;
    }

    SunlitLeaves sunlit_by(std::size_t source) const {
        const Surfaces& all = scene_.surfaces();
        const glm::dvec3 sun = *light_.light.sources[source].direction;
        // Triangles that any replicate has met, by piece.
        std::vector<std::pair<std::uint32_t, std::uint32_t>> met;
        for (const Tally& tally : tallies_)
            for (const LeafLight::Beam& beam : tally.leaf_light[source].beam)
                met.emplace_back(all.face_group[beam.triangle / 2],
                                 beam.triangle);
        std::sort(met.begin(), met.end());
        met.erase(std::unique(met.begin(), met.end()), met.end());
        SunlitLeaves result;
        std::vector<std::uint32_t> place(all.normals.size());
        for (const auto& [piece, triangle] : met) {
            place[triangle] = static_cast<std::uint32_t>(result.piece.size());
            result.piece.push_back(piece);
            result.cosine.push_back(
                std::abs(glm::dot(all.normals[triangle], sun) / sun.z));
        }
        std::vector<std::vector<double>> energy;
        for (const Tally& tally : tallies_) {
            energy.emplace_back(met.size());
            for (const LeafLight::Beam& beam : tally.leaf_light[source].beam)
                energy.back()[place[beam.triangle]] = beam.energy;
        }
        result.energy = with_and_without(std::move(energy));
        return result;
    }

    //! Adds a step of the day.
    void add(std::size_t i, const SunlitLeaves& sunlit) {
        const TimeStep& step = light_.series.steps[i];
        if (!(step.par.beam + step.par.diffuse > 0)) return;
        const auto scale = [&](int source, double irradiance) {
            if (source < 0) return 0.;
            const auto s = static_cast<std::size_t>(source);
            return irradiance * photosynthesis_.photons /
                   light_.light.sources[s].energy;
        };
        const int beam = light_.beam_of[i], sky = light_.sky_of[i];
        const double of_beam = scale(beam, step.par.beam);
        const double of_sky = scale(sky, step.par.diffuse);
        const double on_leaf =
            absorptance_ * step.par.beam * photosynthesis_.photons;
        for (std::size_t g = 0; g < all_.size(); ++g) {
            light_of_.assign(pieces_.count, 0);
            const auto add_diffuse = [&](int source, double by) {
                if (source < 0) return;
                const auto& values =
                    diffuse_[static_cast<std::size_t>(source)][g];
                for (std::size_t v = 0; v < pieces_.count; ++v)
                    light_of_[v] += by * values[v];
            };
            add_diffuse(beam, of_beam);
            add_diffuse(sky, of_sky);
            for (std::size_t v = 0; v < pieces_.count; ++v)
                light_of_[v] = index_[v] > 0 ? light_of_[v] / index_[v] : 0;
            add(i, step, g, sunlit, of_beam, on_leaf);
        }
    }

    //! One step of one sample, leaf by leaf.
    void add(std::size_t i, const TimeStep& step, std::size_t g,
             const SunlitLeaves& sunlit, double of_beam, double on_leaf) {
        AssimilationTally& tally = all_[g];
        const double amount = step.seconds * mol_per_umol / light_.series.days;
        shaded_.resize(pieces_.count);
        std::size_t k = 0;
        for (std::size_t first = 0, last = 0; first < pieces_.count;
             first = last) {
            const std::uint32_t leaf = pieces_.group[first];
            while (last < pieces_.count && pieces_.group[last] == leaf) ++last;
            const LeafResponse f =
                response(rates_[leaf], air_of(step, photosynthesis_));
            gross(f, {&light_of_[first], last - first}, &shaded_[first]);
            const std::size_t first_hit = k;
            total_.clear();
            for (; k < sunlit.piece.size() && sunlit.piece[k] < last; ++k)
                total_.push_back(light_of_[sunlit.piece[k]] +
                                 on_leaf * sunlit.cosine[k]);
            lit_.resize(total_.size());
            gross(f, total_, lit_.data());
            double sum = 0;
            for (std::size_t v = first; v < last; ++v) {
                const double rate = index_[v] * shaded_[v];
                tally.layers[layer_[v]] += rate * amount;
                sum += rate;
            }
            for (std::size_t h = first_hit; h < k; ++h) {
                const std::uint32_t v = sunlit.piece[h];
                const double b = on_leaf * sunlit.cosine[h];
                // The difference of less would be mostly rounding.
                constexpr double least = 0.01;
                const double per_light =
                    b < least ? slope(f, light_of_[v] + b / 2)
                              : (lit_[h - first_hit] - shaded_[v]) / b;
                const double rate = of_beam * sunlit.energy[g][h] * per_light;
                tally.layers[layer_[v]] += rate * amount;
                sum += rate;
            }
            tally.groups[leaf] += sum * amount;
            tally.steps[i] += sum;
        }
    }

    std::vector<AssimilationTally> pseudo_values() const {
        if (all_.size() == 1) return all_;
        std::vector<AssimilationTally> result(all_.begin() + 1, all_.end());
        const auto n = static_cast<double>(result.size());
        const auto turn = [n](std::vector<double>& without,
                              const std::vector<double>& with) {
            for (std::size_t i = 0; i < with.size(); ++i)
                without[i] = n * with[i] - (n - 1) * without[i];
        };
        for (AssimilationTally& each : result) {
            turn(each.groups, all_.front().groups);
            turn(each.layers, all_.front().layers);
            turn(each.steps, all_.front().steps);
        }
        return result;
    }

    const std::vector<Tally>& tallies_;
    const Scene& scene_;
    const Pieces& pieces_;
    double absorptance_;
    const SeriesIllumination& light_;
    const Photosynthesis& photosynthesis_;
    const std::vector<LeafRates>& rates_;
    //! Of each source: the mean of all randomisations, then without each.
    std::vector<std::vector<std::vector<double>>> diffuse_;
    std::vector<std::size_t> layer_;      //!< of each piece
    std::vector<double> index_;           //!< leaf area index of each piece
    std::vector<AssimilationTally> all_;  //!< of all, then without each

    // Of one step and sample [umol m-2 s-1].
    std::vector<double> light_of_;  //!< D of pieces
    std::vector<double> shaded_;    //!< f(D)
    std::vector<double> total_;     //!< D + b of hits
    std::vector<double> lit_;       //!< f(D + b)
};

//! The number at the end of a leaf's name; 0 if there is none.
std::size_t leaf_number(const std::string& name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    constexpr std::string_view leaf = "leaf";
    constexpr std::size_t most_digits = 4;
    if (digits == name.size() || name.size() - digits > most_digits ||
        digits < leaf.size() ||
        name.compare(digits - leaf.size(), leaf.size(), leaf) != 0)
        return 0;
    return std::stoul(name.substr(digits));
}

}  // namespace

std::vector<LeafRates> rates_of_groups(
    const Photosynthesis& photosynthesis, const std::vector<Group>& groups,
    const std::vector<double>& leaf_area_index) {
    // Groups without a number are all one leaf.
    std::vector<std::size_t> leaf(groups.size());
    std::size_t leaves = 1;
    bool is_numbered = true;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (groups[g].tissue != Tissue::leaf) continue;
        const std::size_t number = leaf_number(groups[g].name);
        is_numbered = is_numbered && number > 0;
        leaf[g] = std::max<std::size_t>(number, 1) - 1;
        leaves = std::max(leaves, leaf[g] + 1);
    }
    if (!is_numbered) {
        if (photosynthesis.rates.size() > 1)
            throw Error(
                "photosynthesis has rates by leaf, but groups of leaves have "
                "no numbers (as in leaf01, the lowest); name them so");
        leaf.assign(groups.size(), 0);
        leaves = 1;
    }
    std::vector<double> index(leaves);
    for (std::size_t g = 0; g < groups.size(); ++g)
        index[leaf[g]] += leaf_area_index[g];
    const std::vector<LeafRates> rates = rates_of_leaves(photosynthesis, index);
    std::vector<LeafRates> result;
    for (std::size_t g = 0; g < groups.size(); ++g)
        result.push_back(rates[leaf[g]]);
    return result;
}

Air air_of(const TimeStep& step, const Photosynthesis& photosynthesis) {
    Air air;
    if (!photosynthesis.follows_weather) return air;
    air.temperature = step.temperature.value_or(air.temperature);
    air.humidity = step.humidity.value_or(air.humidity);
    return air;
}

Respiration AssimilationReport::all_respiration() const {
    Respiration sum;
    for (const Respiration& each : respiration) {
        sum.in_light += each.in_light;
        sum.at_night += each.at_night;
    }
    return sum;
}

double AssimilationReport::carbon_loss() const {
    const Respiration all = all_respiration();
    return all.in_light + all.at_night + building;
}

double AssimilationTally::gross() const {
    return std::accumulate(groups.begin(), groups.end(), 0.);
}

namespace {

//! Steps and what each counts.
using Part = std::vector<std::pair<std::size_t, double>>;

std::vector<Part> parts_of_hours(const LightSeries& series) {
    const std::vector<double> hours = series.hours();
    std::vector<Part> parts(hours.size());
    for (std::size_t i = 0; i < series.steps.size(); ++i) {
        const auto found =
            std::lower_bound(hours.begin(), hours.end(), series.steps[i].hour);
        if (found != hours.end() && *found == series.steps[i].hour)
            parts[static_cast<std::size_t>(found - hours.begin())].emplace_back(
                i, 1. / series.days);
    }
    return parts;
}

std::vector<Part> parts_of_dates(const LightSeries& series) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < series.steps.size(); ++i) {
        if (i == 0 || series.steps[i].date != series.steps[i - 1].date)
            parts.emplace_back();
        parts.back().emplace_back(i, mol_per_umol * series.steps[i].seconds);
    }
    return parts;
}

//! Of leaves in the dark, over a mean day.
Respiration respiration(const LeafRates& rates, double leaf_area_index,
                        const LightSeries& series,
                        const Photosynthesis& photosynthesis) {
    const double scale =
        mol_per_umol * leaf_area_index / static_cast<double>(series.days);
    Respiration result;
    double known = 0;
    for (const TimeStep& step : series.steps) {
        const double amount =
            scale * step.seconds *
            dark_respiration(rates, air_of(step, photosynthesis).temperature);
        if (step.par.beam + step.par.diffuse > 0)
            result.in_light += amount;
        else
            result.at_night += amount;
        known += step.seconds;
    }
    // Nights that are left out have no weather.
    constexpr double day = 86400;
    result.at_night += scale * std::max(0., series.days * day - known) *
                       dark_respiration(rates, Air{}.temperature);
    return result;
}

}  // namespace

AssimilationReport report(std::vector<AssimilationTally> tallies,
                          const std::vector<LeafRates>& rates,
                          const std::vector<double>& leaf_area_index,
                          const SeriesIllumination& light,
                          const Photosynthesis& photosynthesis) {
    AssimilationReport result;
    const auto over = [&](const auto& figure) {
        std::vector<double> replicates;
        for (const AssimilationTally& tally : tallies)
            replicates.push_back(figure(tally));
        return estimate(replicates);
    };
    const auto each = [&](std::vector<double> AssimilationTally::*part) {
        std::vector<Estimate> all;
        for (std::size_t i = 0; i < (tallies.front().*part).size(); ++i)
            all.push_back(
                over([&](const AssimilationTally& t) { return (t.*part)[i]; }));
        return all;
    };
    result.gross = over([](const AssimilationTally& t) { return t.gross(); });
    result.groups = each(&AssimilationTally::groups);
    result.layers = each(&AssimilationTally::layers);
    const LightSeries& series = light.series;
    const auto of_steps = [&](const std::vector<Part>& parts) {
        std::vector<Estimate> all;
        for (const Part& part : parts)
            all.push_back(over([&](const AssimilationTally& t) {
                double sum = 0;
                for (const auto& [step, weight] : part)
                    sum += weight * t.steps[step];
                return sum;
            }));
        return all;
    };
    result.hours = of_steps(parts_of_hours(series));
    if (series.days > 1) result.dates = of_steps(parts_of_dates(series));
    for (std::size_t g = 0; g < rates.size(); ++g)
        result.respiration.push_back(respiration(rates[g], leaf_area_index[g],
                                                 light.series, photosynthesis));
    for (const double index : leaf_area_index)
        result.building +=
            photosynthesis.building_cost * index / photosynthesis.building_days;
    result.tallies = std::move(tallies);
    return result;
}

std::vector<AssimilationTally> assimilate(
    const std::vector<Tally>& tallies, const Scene& scene, const Pieces& pieces,
    const Optics& optics, const SeriesIllumination& light,
    const Photosynthesis& photosynthesis, const std::vector<LeafRates>& rates,
    const Layers& layers) {
    return Assimilation(tallies, scene, pieces, optics, light, photosynthesis,
                        rates)
        .result(layers);
}

}  // namespace ideotype
