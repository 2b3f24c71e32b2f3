#include "ideotype/light/transport.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/light/sampler.hpp"
#include "ideotype/sky/sky_sampler.hpp"

namespace ideotype {

namespace {

//! A bundle of light on its way.
struct Bundle {
    Vec3 position;
    Vec3 direction;
    double energy = 0;
};

enum class Met { face, soil, sky };

//! Straight on through the stand, re-entering the cell on its other side
//! whenever it leaves, until the bundle meets something.
Met travel(const Scene& scene, Bundle& bundle, Hit& hit) {
    constexpr double never = std::numeric_limits<double>::infinity();
    // Rounding may hide a face at the very end of a segment or, as its image,
    // at the very start of the next one. Both look a little over the seam.
    const double seam = scene.clearance() / 2;
    double before = 0;
    Vec3& p = bundle.position;
    const Vec3& d = bundle.direction;
    const auto to_side = [](double x, double dx, double period) {
        return dx > 0 ? (period - x) / dx : dx < 0 ? -x / dx : never;
    };
    for (;;) {
        const double to_x = to_side(p.x, d.x, scene.period_x());
        const double to_y = to_side(p.y, d.y, scene.period_y());
        const double to_z =
            std::max(0.0, d.z < 0 ? -p.z / d.z : (scene.top() - p.z) / d.z);
        const double distance = std::max(0.0, std::min({to_x, to_y, to_z}));
        const Vec3 from{p.x - before * d.x, p.y - before * d.y,
                        p.z - before * d.z};
        if (scene.intersect(from, d, before + distance + seam, hit))
            return Met::face;
        before = seam;
        if (to_z <= to_x && to_z <= to_y) {
            p = {p.x + to_z * d.x, p.y + to_z * d.y, d.z < 0 ? 0 : scene.top()};
            return d.z < 0 ? Met::soil : Met::sky;
        }
        p = {p.x + distance * d.x, p.y + distance * d.y, p.z + distance * d.z};
        if (to_x < to_y)
            p.x = d.x > 0 ? 0 : scene.period_x();
        else
            p.y = d.y > 0 ? 0 : scene.period_y();
    }
}

//! Keeps a direction from being so level that it would cross the stand
//! almost for ever; a shift far below any measurable angle.
Vec3 not_level(Vec3 d) {
    constexpr double least = 1e-7;
    if (std::abs(d.z) < least) d.z = std::copysign(least, d.z);
    return d;
}

//! A direction around a unit normal with density cos / pi: Lambert's law.
//! Frame after Duff et al. 2017 (jcgt.org/published/0006/01/01).
Vec3 lambertian(const Vec3& n, double u, double v) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1 / (sign + n.z);
    const double b = n.x * n.y * a;
    const Vec3 s{1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    const Vec3 t{b, sign + n.y * n.y * a, -n.y};
    const double r = std::sqrt(u);
    const double phi = 2 * std::numbers::pi * v;
    const double x = r * std::cos(phi);
    const double y = r * std::sin(phi);
    const double z = std::sqrt(1 - u);
    return not_level({x * s.x + y * t.x + z * n.x, x * s.y + y * t.y + z * n.y,
                      x * s.z + y * t.z + z * n.z});
}

double wrapped(double x, double period) {
    const double w = x - period * std::floor(x / period);
    return w < period ? w : 0;
}

//! Where the light of a source comes from: one direction of travel or a sky.
using Origin = std::variant<Vec3, SkySampler>;

std::vector<Origin> origins_of(const std::vector<Source>& sources) {
    std::vector<Origin> origins;
    for (const Source& source : sources) {
        if (source.direction)
            origins.emplace_back(*source.direction);
        else
            origins.emplace_back(SkySampler(source.sky));
    }
    return origins;
}

//! Traces the paths of one randomisation into one tally.
class Tracer {
  public:
    Tracer(const Scene& scene, const std::vector<Group>& groups,
           const Optics& optics, PathSampler sampler)
        : scene_(scene),
          groups_(groups),
          optics_(optics),
          sampler_(std::move(sampler)) {}

    void trace(std::uint32_t path, const Origin& origin, double energy,
               Budget& budget, std::vector<double>& absorbed) {
        sampler_.begin(path);
        Bundle bundle = launch(origin, energy);
        Hit hit;
        while (bundle.energy > 0) {
            const Met met = travel(scene_, bundle, hit);
            if (met == Met::sky) {
                budget.reflected += bundle.energy;
                return;
            }
            if (met == Met::soil) {
                budget.soil += meet_soil(bundle, energy);
                continue;
            }
            const Tissue tissue = groups_[hit.group].tissue;
            const double share = meet_face(bundle, hit, energy, tissue);
            (tissue == Tissue::leaf ? budget.leaves : budget.stalks) += share;
            absorbed[hit.group] += share;
        }
    }

  private:
    Bundle launch(const Origin& origin, double energy) {
        const double x = sampler_.next() * scene_.period_x();
        const double y = sampler_.next() * scene_.period_y();
        const auto* beam = std::get_if<Vec3>(&origin);
        if (beam) return {{x, y, scene_.top()}, not_level(*beam), energy};
        const double u = sampler_.next();
        const double v = sampler_.next();
        const Vec3 direction = std::get<SkySampler>(origin).sample(u, v);
        return {{x, y, scene_.top()}, not_level(direction), energy};
    }

    //! What a surface keeps of a bundle; the bundle goes on with the rest.
    //! While the scattered part is a large share of what the path started
    //! with, the surface keeps exactly its absorptance. A small scattered
    //! part is not worth following: instead all or nothing is scattered, with
    //! the right odds. Both rules are unbiased and lose no energy. `choice`
    //! is uniform in [0, 1) and is so again afterwards, for the next choice.
    double deposit(Bundle& bundle, double started, double scattered,
                   double& choice) const {
        constexpr double worth_following = 0.25;
        if (bundle.energy * scattered > worth_following * started) {
            const double kept = bundle.energy * (1 - scattered);
            bundle.energy -= kept;
            return kept;
        }
        if (choice < scattered) {
            choice /= scattered;
            return 0;
        }
        return std::exchange(bundle.energy, 0.0);
    }

    double meet_soil(Bundle& bundle, double started) {
        if (optics_.soil_albedo == 0) return std::exchange(bundle.energy, 0.0);
        double choice = sampler_.next();
        const double kept =
            deposit(bundle, started, optics_.soil_albedo, choice);
        if (bundle.energy > 0) {
            const double u = sampler_.next();
            const double v = sampler_.next();
            bundle.position.x = wrapped(bundle.position.x, scene_.period_x());
            bundle.position.y = wrapped(bundle.position.y, scene_.period_y());
            bundle.direction = lambertian({0, 0, 1}, u, v);
        }
        return kept;
    }

    double meet_face(Bundle& bundle, const Hit& hit, double started,
                     Tissue tissue) {
        const Lambertian& surface =
            tissue == Tissue::leaf ? optics_.leaf : optics_.stalk;
        const double scattered = surface.reflectance + surface.transmittance;
        if (scattered == 0) return std::exchange(bundle.energy, 0.0);
        double choice = sampler_.next();
        const double kept = deposit(bundle, started, scattered, choice);
        if (bundle.energy > 0) {
            const double u = sampler_.next();
            const double v = sampler_.next();
            const bool is_reflected = choice * scattered < surface.reflectance;
            scatter(bundle, hit, is_reflected, u, v);
        }
        return kept;
    }

    void scatter(Bundle& bundle, const Hit& hit, bool is_reflected, double u,
                 double v) const {
        const Vec3& d = bundle.direction;
        Vec3 n = hit.normal;
        const bool is_along = d.x * n.x + d.y * n.y + d.z * n.z > 0;
        if (is_along == is_reflected) n = {-n.x, -n.y, -n.z};
        const double clear = scene_.clearance();
        bundle.position = {
            wrapped(hit.position.x + clear * n.x, scene_.period_x()),
            wrapped(hit.position.y + clear * n.y, scene_.period_y()),
            std::clamp(hit.position.z + clear * n.z, 0.0, scene_.top())};
        bundle.direction = lambertian(n, u, v);
    }

    const Scene& scene_;
    const std::vector<Group>& groups_;
    const Optics& optics_;
    PathSampler sampler_;
};

//! Splits paths among sources in proportion to energy, at least one each, by
//! largest remainders; returns where each source's paths begin and the end.
std::vector<std::uint32_t> share_paths(const Illumination& illumination,
                                       std::uint32_t paths) {
    const std::vector<Source>& sources = illumination.sources;
    const double total = illumination.energy();
    std::vector<std::uint32_t> counts;
    std::vector<double> remainders;
    std::uint32_t given = 0;
    for (const Source& source : sources) {
        const double exact =
            source.energy / total * static_cast<double>(paths - sources.size());
        counts.push_back(1 + static_cast<std::uint32_t>(exact));
        remainders.push_back(exact - std::floor(exact));
        given += counts.back();
    }
    std::vector<std::size_t> order(sources.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) {
                         return remainders[a] > remainders[b];
                     });
    for (std::size_t i = 0; given < paths; ++i, ++given)
        ++counts[order[i % order.size()]];
    std::vector<std::uint32_t> begins{0};
    for (const std::uint32_t count : counts)
        begins.push_back(begins.back() + count);
    return begins;
}

}  // namespace

std::vector<Tally> simulate(const Scene& scene,
                            const std::vector<Group>& groups,
                            const Optics& optics,
                            const Illumination& illumination,
                            const Sampling& sampling,
                            const Randomness& randomness) {
    const std::vector<Source>& sources = illumination.sources;
    const auto paths = static_cast<std::uint32_t>(sampling.paths);
    if (sampling.paths < 1 || !std::has_single_bit(paths))
        throw Error(
            fmt::format("{} paths are not a power of two", sampling.paths));
    if (paths < sources.size())
        throw Error(fmt::format(
            "{} paths are too few for {} sources of light (a sun at each time "
            "step and the sky, a clear one at each); take more paths or a "
            "longer step",
            paths, sources.size()));
    std::vector<Tally> tallies(
        static_cast<std::size_t>(sampling.randomisations),
        {std::vector<Budget>(sources.size()),
         std::vector<double>(groups.size())});
    if (sources.empty()) return tallies;

    const std::vector<Origin> origins = origins_of(sources);
    const std::vector<std::uint32_t> begins = share_paths(illumination, paths);
    auto randomisation = randomness.first_randomisation;
    for (Tally& tally : tallies) {
        Tracer tracer(scene, groups, optics,
                      PathSampler(randomness.seed, randomness.generation,
                                  randomisation++, paths));
        for (std::size_t s = 0; s < sources.size(); ++s) {
            const double energy =
                sources[s].energy / (begins[s + 1] - begins[s]);
            for (std::uint32_t p = begins[s]; p < begins[s + 1]; ++p)
                tracer.trace(p, origins[s], energy, tally.sources[s],
                             tally.groups);
        }
    }
    return tallies;
}

}  // namespace ideotype
