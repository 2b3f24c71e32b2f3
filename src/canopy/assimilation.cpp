#include "ideotype/canopy/assimilation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace ideotype {

namespace {

//! Numbers of places in the mean of all randomisations, and how much more they
//! are in the mean without each.
struct Jackknifed {
    std::vector<double> mean;
    std::vector<double> without;  //!< [place][randomisation]

    //! @param values [randomisation][place]
    explicit Jackknifed(const std::vector<std::vector<double>>& values)
        : mean(values.front().size()), without(mean.size() * values.size()) {
        const std::size_t n = values.size();
        for (const std::vector<double>& one : values)
            for (std::size_t i = 0; i < mean.size(); ++i)
                mean[i] += one[i] / static_cast<double>(n);
        if (n == 1) return;
        for (std::size_t r = 0; r < n; ++r)
            for (std::size_t i = 0; i < mean.size(); ++i)
                without[i * n + r] =
                    (mean[i] - values[r][i]) / static_cast<double>(n - 1);
    }
};

//! Light of one source that is no beam.
struct Diffuse {
    std::vector<double> pooled;  //!< of each pool, per area of leaf [J m-2]
    Jackknifed parts;            //!< of each part [J m-2 of ground]
};

//! The beam of one source on the triangles that it meets, in the order of
//! pieces.
struct SunlitLeaves {
    std::vector<std::uint32_t> piece;
    //! Beam on the leaf over that on level ground.
    std::vector<double> cosine;
    Jackknifed energy;  //!< [J m-2]
};

//! f at some places, with its derivatives.
struct Responses {
    std::vector<double> light, value, slope, curvature;

    void resize(std::size_t places) {
        for (auto* part : {&light, &value, &slope, &curvature})
            part->resize(places);
    }

    //! Moves the point of a place by second order.
    void move(std::size_t i, double by) {
        value[i] += by * (slope[i] + by / 2 * curvature[i]);
        slope[i] += by * curvature[i];
    }

    void respond(const LeafResponse& response, std::size_t first,
                 std::size_t last) {
        expand(response, {&light[first], last - first}, &value[first],
               &slope[first], &curvature[first]);
    }
};

class Assimilation {
  public:
    Assimilation(const std::vector<Tally>& tallies, const Scene& scene,
                 const Pieces& pieces, const Optics& optics,
                 const SeriesIllumination& light,
                 const Photosynthesis& photosynthesis,
                 const std::vector<LeafRates>& rates, const Layers& layers)
        : tallies_(tallies),
          scene_(scene),
          pieces_(pieces),
          absorptance_(1 - optics.leaf.scattered()),
          light_(light),
          photosynthesis_(photosynthesis),
          rates_(rates),
          layers_(layers.count),
          without_(rates.size() * layers.count * tallies.size()),
          all_(tallies.size(),
               {std::vector<double>(rates.size()),
                std::vector<double>(layers.count),
                std::vector<double>(light.series.steps.size())}) {
        for (const double area : pieces.area)
            index_.push_back(area / scene.ground_area());
        for (std::size_t v = 0; v < pieces.count; ++v)
            cell_.push_back(pieces.group[v] * layers.count +
                            layers.at(pieces.height[v]));
        // Relative variances, chosen by the bias that tests/benchmark tells.
        constexpr double well_known = 0.1, known_at_all = 0.7;
        const bool is_single = tallies.size() == 1;
        all_diffuse_ = all_diffuse();
        pool_ = is_single ? joined(1, false) : known(well_known, true);
        part_ = known(known_at_all, false);
        diffuse_.reserve(light.light.sources.size());
        for (std::size_t s = 0; s < light.light.sources.size(); ++s)
            diffuse_.emplace_back(diffuse_of(s));
        shaded_.resize(pieces.count);
    }

    std::vector<AssimilationTally> result() {
        // Steps with the same sun share what it shines on.
        for (std::size_t s = 0; s < diffuse_.size(); ++s) {
            if (!light_.light.sources[s].direction) continue;
            const SunlitLeaves sunlit = sunlit_by(s);
            for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
                if (light_.beam_of[i] == static_cast<int>(s)) add(i, sunlit);
        }
        const SunlitLeaves none{
            {}, {}, Jackknifed(std::vector<std::vector<double>>(1))};
        for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
            if (light_.beam_of[i] < 0 && light_.sky_of[i] >= 0) add(i, none);
        return std::move(all_);
    }

  private:
    //! Pieces joined to so many neighbours of their blade, of each plant for
    //! itself or of all that are alike.
    std::vector<std::size_t> joined(std::size_t size, bool all_alike) const {
        std::vector<std::size_t> place(pieces_.count);
        std::size_t places = 0, start = 0;
        for (std::size_t v = 0; v < pieces_.count; ++v) {
            if (all_alike && pieces_.like[v] != v) {
                place[v] = place[pieces_.like[v]];
                continue;
            }
            if (v == 0 || pieces_.group[v] != pieces_.group[v - 1]) start = v;
            places += (v - start) % size == 0;
            place[v] = places - 1;
        }
        return place;
    }

    //! Joins pieces until the relative variance of their light, over the day,
    //! is low enough on average.
    std::vector<std::size_t> known(double enough, bool all_alike) const {
        constexpr std::size_t most = 64;
        for (std::size_t size = 1;; size *= 2) {
            std::vector<std::size_t> place = joined(size, all_alike);
            if (size == most || relative_variance(place) <= enough)
                return place;
        }
    }

    double relative_variance(const std::vector<std::size_t>& place) const {
        const std::size_t n = tallies_.size();
        if (n == 1) return 0;
        std::vector<double> light(pieces_.count * n), index(pieces_.count);
        for (std::size_t v = 0; v < pieces_.count; ++v) {
            index[place[v]] += index_[v];
            for (std::size_t r = 0; r < n; ++r)
                light[place[v] * n + r] += all_diffuse_[v * n + r];
        }
        double sum = 0, all = 0;
        for (std::size_t p = 0; p < index.size(); ++p) {
            const Estimate mean = estimate({&light[p * n], n});
            all += index[p];
            // One that a single replicate has met has a variance of 1.
            sum += index[p] *
                   (mean.mean > 0 ? std::pow(mean.standard_error / mean.mean, 2)
                                  : 1);
        }
        return all > 0 ? sum / all : 0;
    }

    //! All sources, by piece and randomisation.
    std::vector<double> all_diffuse() const {
        const std::size_t n = tallies_.size();
        std::vector<double> all(pieces_.count * n);
        for (std::size_t r = 0; r < n; ++r)
            for (const LeafLight& source : tallies_[r].leaf_light)
                for (std::size_t v = 0;
                     v < std::min(pieces_.count, source.diffuse.size()); ++v)
                    all[v * n + r] += source.diffuse[v];
        return all;
    }

    Diffuse diffuse_of(std::size_t source) const {
        std::vector<std::vector<double>> values;
        std::vector<double> pooled(pieces_.count), index(pieces_.count);
        for (const Tally& tally : tallies_) {
            values.emplace_back(pieces_.count ? part_.back() + 1 : 0);
            const std::vector<double>& light = tally.leaf_light[source].diffuse;
            for (std::size_t v = 0; v < std::min(pieces_.count, light.size());
                 ++v) {
                values.back()[part_[v]] += light[v];
                pooled[pool_[v]] +=
                    light[v] / static_cast<double>(tallies_.size());
            }
        }
        for (std::size_t v = 0; v < pieces_.count; ++v)
            index[pool_[v]] += index_[v];
        for (std::size_t p = 0; p < pooled.size(); ++p)
            pooled[p] = index[p] > 0 ? pooled[p] / index[p] : 0;
        return {std::move(pooled), Jackknifed(values)};
    }

    SunlitLeaves sunlit_by(std::size_t source) const {
        const Surfaces& all = scene_.surfaces();
        const glm::dvec3 sun = *light_.light.sources[source].direction;
        // Triangles that any replicate has met, by piece.
        constexpr std::uint32_t none = ~std::uint32_t{0};
        std::vector<std::uint32_t> place(all.normals.size(), none);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> met;
        for (const Tally& tally : tallies_)
            for (const LeafLight::Beam& beam : tally.leaf_light[source].beam)
                if (std::exchange(place[beam.triangle], 0) == none)
                    met.emplace_back(all.face_group[beam.triangle / 2],
                                     beam.triangle);
        std::sort(met.begin(), met.end());
        std::vector<std::uint32_t> piece;
        std::vector<double> cosine;
        for (const auto& [group, triangle] : met) {
            place[triangle] = static_cast<std::uint32_t>(piece.size());
            piece.push_back(group);
            cosine.push_back(
                std::abs(glm::dot(all.normals[triangle], sun) / sun.z));
        }
        std::vector<std::vector<double>> energy;
        for (const Tally& tally : tallies_) {
            energy.emplace_back(met.size());
            for (const LeafLight::Beam& beam : tally.leaf_light[source].beam)
                energy.back()[place[beam.triangle]] = beam.energy;
        }
        return {std::move(piece), std::move(cosine), Jackknifed(energy)};
    }

    //! Adds a step of the day.
    void add(std::size_t i, const SunlitLeaves& sunlit) {
        const TimeStep& step = light_.series.steps[i];
        if (!(step.par.beam + step.par.diffuse > 0)) return;
        const auto scale = [&](int source, double irradiance) {
            return irradiance * photosynthesis_.photons /
                   light_.light.sources[static_cast<std::size_t>(source)]
                       .energy;
        };
        const int beam = light_.beam_of[i], sky = light_.sky_of[i];
        const double of_beam = beam < 0 ? 0 : scale(beam, step.par.beam);
        const double of_sky = sky < 0 ? 0 : scale(sky, step.par.diffuse);
        // One without light has no part in it.
        const auto diffuse = [&](int source, int other) -> const Diffuse& {
            return diffuse_[static_cast<std::size_t>(source < 0 ? other
                                                                : source)];
        };
        const Diffuse& of_sun = diffuse(beam, sky);
        const Diffuse& of_clouds = diffuse(sky, beam);
        off_.assign(of_sun.parts.mean.size(), 0);
        for (std::size_t v = 0; v < pieces_.count; ++v) {
            shaded_.light[v] = of_beam * of_sun.pooled[pool_[v]] +
                               of_sky * of_clouds.pooled[pool_[v]];
            off_[part_[v]] += index_[v] * shaded_.light[v];
        }
        per_light_.resize(off_.size());
        for (std::size_t p = 0; p < off_.size(); ++p) {
            per_light_[p] = off_[p] > 0 ? 1 / off_[p] : 0;
            off_[p] = (of_beam * of_sun.parts.mean[p] +
                       of_sky * of_clouds.parts.mean[p] - off_[p]) *
                      per_light_[p];
        }
        const std::size_t hits = sunlit.piece.size();
        lit_.resize(hits);
        const double on_leaf =
            absorptance_ * step.par.beam * photosynthesis_.photons;
        for (std::size_t h = 0; h < hits; ++h)
            lit_.light[h] =
                shaded_.light[sunlit.piece[h]] + on_leaf * sunlit.cosine[h];
        respond(step, sunlit);
        for (std::size_t v = 0; v < pieces_.count; ++v)
            shaded_.move(v, off_[part_[v]] * shaded_.light[v]);
        for (std::size_t h = 0; h < hits; ++h)
            lit_.move(h, off_[part_[sunlit.piece[h]]] *
                             shaded_.light[sunlit.piece[h]]);
        add_up(sunlit, of_beam, on_leaf, of_sun.parts, of_clouds.parts, of_sky);
        take(i, step);
    }

    //! Leaf by leaf.
    void respond(const TimeStep& step, const SunlitLeaves& sunlit) {
        std::vector<LeafResponse> responses;
        for (const LeafRates& rates : rates_)
            responses.push_back(response(rates, air_of(step, photosynthesis_)));
        for (std::size_t first = 0, last = 0, k = 0; first < pieces_.count;
             first = last) {
            const std::uint32_t leaf = pieces_.group[first];
            while (last < pieces_.count && pieces_.group[last] == leaf) ++last;
            shaded_.respond(responses[leaf], first, last);
            const std::size_t first_hit = k;
            while (k < sunlit.piece.size() && sunlit.piece[k] < last) ++k;
            if (k > first_hit) lit_.respond(responses[leaf], first_hit, k);
        }
    }

    //! Sums of one step in cells: of the mean light, and how much more they are
    //! without each randomisation, to second order. Light is what differs, of
    //! beams on triangles by e and diffuse light in pieces by d:
    //! f(D + d) = f + f' d + f'' d^2 / 2, and the same for what the beam adds.
    void add_up(const SunlitLeaves& sunlit, double of_beam, double on_leaf,
                const Jackknifed& of_sun, const Jackknifed& of_clouds,
                double of_sky) {
        const std::size_t n = tallies_.size();
        mean_.assign(rates_.size() * layers_, 0);
        std::fill(without_.begin(), without_.end(), 0);
        more_.resize(n);
        std::size_t h = 0;
        for (std::size_t v = 0; v < pieces_.count; ++v) {
            double* const without = &without_[cell_[v] * n];
            double& mean = mean_[cell_[v]];
            const double* const sun = &of_sun.without[part_[v] * n];
            const double* const clouds = &of_clouds.without[part_[v] * n];
            const double share = per_light_[part_[v]] * shaded_.light[v];
            for (std::size_t r = 0; r < n; ++r)
                more_[r] = share * (of_beam * sun[r] + of_sky * clouds[r]);
            mean += index_[v] * shaded_.value[v];
            double first = index_[v] * shaded_.slope[v];
            double second = index_[v] * shaded_.curvature[v] / 2;
            for (; h < sunlit.piece.size() && sunlit.piece[h] == v; ++h) {
                const double b = on_leaf * sunlit.cosine[h];
                // The difference of less would be mostly rounding.
                constexpr double least = 0.01;
                const auto change = [&](std::vector<double> Responses::*of,
                                        double limit) {
                    return b < least ? limit
                                     : ((lit_.*of)[h] - (shaded_.*of)[v]) / b;
                };
                const double value =
                    b < least ? shaded_.slope[v] + b / 2 * shaded_.curvature[v]
                              : (lit_.value[h] - shaded_.value[v]) / b;
                const double slope =
                    change(&Responses::slope, shaded_.curvature[v]);
                const double curvature = change(&Responses::curvature, 0.);
                const double energy = of_beam * sunlit.energy.mean[h];
                mean += energy * value;
                first += energy * slope;
                second += energy * curvature / 2;
                const double* const others = &sunlit.energy.without[h * n];
                for (std::size_t r = 0; r < n; ++r)
                    without[r] +=
                        of_beam * others[r] * (value + slope * more_[r]);
            }
            for (std::size_t r = 0; r < n; ++r)
                without[r] += more_[r] * (first + second * more_[r]);
        }
    }

    //! Adds the pseudo-values of a step.
    void take(std::size_t i, const TimeStep& step) {
        const double amount = step.seconds * mol_per_umol / light_.series.days;
        const std::size_t n = tallies_.size();
        for (std::size_t cell = 0; cell < mean_.size(); ++cell)
            for (std::size_t r = 0; r < n; ++r) {
                const double rate = mean_[cell] - static_cast<double>(n - 1) *
                                                      without_[cell * n + r];
                all_[r].groups[cell / layers_] += rate * amount;
                all_[r].layers[cell % layers_] += rate * amount;
                all_[r].steps[i] += rate;
            }
    }

    const std::vector<Tally>& tallies_;
    const Scene& scene_;
    const Pieces& pieces_;
    double absorptance_;
    const SeriesIllumination& light_;
    const Photosynthesis& photosynthesis_;
    const std::vector<LeafRates>& rates_;
    std::size_t layers_;
    std::vector<double> index_;      //!< leaf area index of each piece
    std::vector<std::size_t> cell_;  //!< of each piece: leaf and layer
    std::vector<double> all_diffuse_;
    //! Of each piece: where the mean light is well known, of plants alike; and
    //! the part of a plant of which it is known how it differs from that.
    std::vector<std::size_t> pool_, part_;
    std::vector<Diffuse> diffuse_;  //!< of each source

    // Of one step [umol m-2 s-1].
    std::vector<double> off_;        //!< D of parts over that of pools, less 1
    std::vector<double> per_light_;  //!< 1 / D of pools, summed over a part
    Responses shaded_;               //!< of pieces: D, f(D)
    Responses lit_;                  //!< of hits: D + b, f(D + b)
    std::vector<double> more_;       //!< light of a piece without each
    std::vector<double> mean_;       //!< by cell
    std::vector<double> without_;    //!< [cell][randomisation]

    std::vector<AssimilationTally> all_;  //!< pseudo-values
};

}  // namespace

std::vector<AssimilationTally> assimilate(
    const std::vector<Tally>& tallies, const Scene& scene, const Pieces& pieces,
    const Optics& optics, const SeriesIllumination& light,
    const Photosynthesis& photosynthesis, const std::vector<LeafRates>& rates,
    const Layers& layers) {
    return Assimilation(tallies, scene, pieces, optics, light, photosynthesis,
                        rates, layers)
        .result();
}

}  // namespace ideotype
