#include "ideotype/light/sunlit.hpp"

#include "ideotype/light/backward.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/sampler.hpp"

namespace ideotype {

SunlitFractions sunlit_fractions(const Scene& scene, const Mesh& mesh,
                                 const Illumination& illumination,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness) {
    const std::vector<Source>& sources = illumination.sources;
    const LeafPoints leaves(mesh);
    const auto points = static_cast<std::uint32_t>(accuracy.paths);
    SunlitFractions result;
    result.fractions.assign(static_cast<std::size_t>(accuracy.randomisations),
                            std::vector<double>(sources.size()));
    if (!(leaves.area() > 0)) return result;
    result.step = 1. / points;
    auto randomisation = randomness.first_randomisation;
    for (std::vector<double>& fractions : result.fractions) {
        PathSampler sampler(randomness.seed, randomness.generation,
                            randomisation++, 0);
        for (std::uint32_t i = 0; i < points; ++i) {
            sampler.begin(i);
            const double share = sampler.next();
            const double s = sampler.next();
            const LeafPoint point = leaves.at(share, s, sampler.next());
            const double part = own_part(scene, point);
            for (std::size_t k = 0; k < sources.size(); ++k) {
                const auto& beam = sources[k].direction;
                if (beam && part > 0 && is_lit(scene, point, *beam))
                    fractions[k] += part * result.step;
            }
        }
    }
    return result;
}

}  // namespace ideotype
