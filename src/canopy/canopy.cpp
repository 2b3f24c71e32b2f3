// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/canopy.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/exact_assimilation.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/tolerance.hpp"

namespace ideotype {

namespace {

//! The part of a randomised day that a relative error of rounding may reach.
constexpr double balance_tolerance = 1e-9;

//! Enough points to know a sunlit fraction to some 0.2 %.
constexpr int most_sunlit_points = 2048;

//! The same surfaces, with the light of each face counted for itself.
Mesh with_a_group_per_face(Mesh mesh) {
    std::vector<Group> groups;
    groups.reserve(mesh.faces.size());
    for (const std::uint32_t group : mesh.face_group)
        groups.push_back(mesh.groups[group]);
    mesh.groups = std::move(groups);
    std::iota(mesh.face_group.begin(), mesh.face_group.end(), 0u);
    return mesh;
}

//! Makes the light of pieces that of the groups that they are of.
void add_up_pieces(std::vector<Tally>& tallies,
                   const std::vector<std::uint32_t>& group_of_piece,
                   std::size_t groups) {
    if (tallies.empty()) return;
    const auto add_up = [&](const auto& pieces, auto groups_of, auto add) {
        groups_of.resize(groups);
        for (std::size_t v = 0; v < pieces.size(); ++v)
            add(groups_of, group_of_piece[v], pieces[v]);
        return groups_of;
    };
    Resolution resolution = *tallies.front().resolution;
    resolution.groups = add_up(resolution.groups, std::vector<double>(),
                               [](auto& all, std::size_t g, double part) {
                                   all[g] = std::max(all[g], part);
                               });
    const auto shared = std::make_shared<const Resolution>(resolution);
    for (Tally& tally : tallies) {
        tally.groups = add_up(
            tally.groups, std::vector<double>(),
            [](auto& all, std::size_t g, double light) { all[g] += light; });
        tally.leaf_light.clear();
        tally.resolution = shared;
    }
}

//! Randomisations in one field that assimilation needs.
constexpr int fewest_in_field = 4;

//! Adds numbers of the same places, or makes them so many times as large.
void add(std::vector<double>& all, const std::vector<double>& more) {
    for (std::size_t i = 0; i < all.size(); ++i) all[i] += more[i];
}
void scale(std::vector<double>& all, double by) {
    for (double& x : all) x *= by;
}

//! Of these parts.
template <class Item, class... Parts>
Item mean_of(const std::vector<Item>& all, Parts... parts) {
    Item mean = all.front();
    const auto take = [&](auto part) {
        for (std::size_t i = 1; i < all.size(); ++i)
            add(mean.*part, all[i].*part);
        scale(mean.*part, 1. / static_cast<double>(all.size()));
    };
    (take(parts), ...);
    return mean;
}

std::vector<double> mean_of(const std::vector<std::vector<double>>& all) {
    std::vector<double> mean = all.front();
    for (std::size_t i = 1; i < all.size(); ++i) add(mean, all[i]);
    scale(mean, 1. / static_cast<double>(all.size()));
    return mean;
}

Tally mean_of(const std::vector<Tally>& tallies) {
    const auto n = static_cast<double>(tallies.size());
    Tally mean = tallies.front();
    for (std::size_t i = 1; i < tallies.size(); ++i) {
        const Tally& more = tallies[i];
        for (std::size_t s = 0; s < mean.sources.size(); ++s)
            mean.sources[s] += more.sources[s];
        add(mean.groups, more.groups);
        add(mean.layers, more.layers);
        mean.adaxial += more.adaxial;
        mean.abaxial += more.abaxial;
        mean.rays += more.rays;
        mean.next_rays += more.next_rays;
    }
    for (Budget& budget : mean.sources) budget *= 1 / n;
    scale(mean.groups, 1 / n);
    scale(mean.layers, 1 / n);
    mean.adaxial /= n;
    mean.abaxial /= n;
    Resolution resolution = *mean.resolution;
    scale(resolution.path_energy, 1 / n);
    mean.resolution = std::make_shared<const Resolution>(resolution);
    return mean;
}

template <class All>
void append(All& all, All more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

void append(SunlitFractions& all, SunlitFractions more) {
    append(all.fractions, std::move(more.fractions));
    all.steps = std::move(more.steps);
}

//! One request on its way to its report.
class Evaluation {
  public:
    Evaluation(const CanopyRequest& request, const Device& device,
               const Clock& clock)
        : request_(request), device_(device), clock_(clock), last_(time()) {
        result_.layers = request.layers;
        result_.days = request.scenario.light.series.days;
    }

    //! Fields of plants that are drawn at random, each with its part of the
    //! randomisations.
    void trace(const Plant& plant) {
        if (request_.details.lines)
            result_.lines = distance(*request_.details.lines, plant);
        const Mesh mesh = split(build_plant(plant, request_.tessellation));
        std::optional<Pieces> pieces;
        if (needs_pieces())
            pieces = cut_leaves(mesh, {}, request_.details.pieces);
        Accuracy accuracy = request_.accuracy;
        Randomness randomness = request_.randomness;
        if (varies()) set_rates(mesh);
        const bool is_each = randomness.fields == Randomness::Fields::each;
        const int fields = is_each ? accuracy.randomisations : 1;
        accuracy.randomisations /= fields;
        // Assimilation in a field needs several, see assimilate().
        if (pieces && accuracy.randomisations < fewest_in_field) {
            accuracy.paths /= fewest_in_field;
            accuracy.randomisations = fewest_in_field;
        }
        is_one_of_many_ = fields > 1 && accuracy.randomisations > 1;
        Randomness of_light = randomness;
        for (int f = 0; f < fields; ++f, ++randomness.first_randomisation) {
            of_light.first_randomisation =
                randomness.first_randomisation *
                static_cast<std::uint32_t>(
                    is_one_of_many_ ? accuracy.randomisations : 1);
            Field field =
                draw_field(plant, pieces ? pieces->mesh : mesh,
                           request_.tessellation, request_.scenario.field,
                           randomness.fields == Randomness::Fields::common
                               ? Randomness{randomness.seed}
                               : randomness);
            std::optional<Pieces> of_field;
            if (pieces)
                of_field = pieces_of_field(*pieces, std::move(field.mesh),
                                           field.face_plant);
            trace(field, mesh.groups, std::move(of_field), accuracy, of_light);
        }
    }

    void trace(const Field& field) {
        Field copy = field;
        copy.mesh = split(std::move(copy.mesh));
        const std::vector<Group> groups = copy.mesh.groups;
        std::optional<Pieces> pieces;
        if (needs_pieces())
            pieces =
                cut_leaves(copy.mesh, copy.face_plant, request_.details.pieces);
        trace(copy, groups, std::move(pieces), request_.accuracy,
              request_.randomness);
    }

    CanopyReport report() {
        const SeriesIllumination& light = request_.scenario.light;
        if (varies()) {
            result_.lai = area_of_fields_.leaves / fields_;
            result_.plant_area_index =
                result_.lai + area_of_fields_.other_organs / fields_;
        }
        for (const Tally& tally : tallies_) {
            result_.budget_by_randomisation.push_back(tally.budget());
            if (request_.details.faces) continue;
            result_.groups_by_randomisation.push_back(tally.groups);
            result_.layers_by_randomisation.push_back(tally.layers);
        }
        result_.light = ideotype::report(tallies_, light);
        if (request_.details.sunlit) {
            const SunlitReport sunlit = ideotype::report(sunlit_, light);
            for (std::size_t h = 0; h < sunlit.hours.size(); ++h)
                result_.light.steps[h].sunlit = sunlit.hours[h];
        }
        if (request_.details.faces) result_.faces = per_area();
        if (request_.details.photosynthesis) {
            for (double& area : leaf_area_index_) area /= fields_;
            result_.assimilation = ideotype::report(
                std::move(assimilation_), rates_, leaf_area_index_, light,
                *request_.details.photosynthesis);
            if (needs_pieces())
                result_.hit_by_sun = ideotype::report(hit_by_sun_, light);
            if (!light_classes_.empty())
                result_.light_classes = ideotype::report(light_classes_);
        }
        if (!(result_.light.balance_error < balance_tolerance))
            throw Error(fmt::format("the energy balance is off by {:.3g}",
                                    result_.light.balance_error));
        return std::move(result_);
    }

  private:
    bool varies() const { return request_.scenario.field.variation.is_any(); }

    //! Those of leaves of plants that do not deviate from their line.
    void set_rates(const Mesh& plant) {
        if (!request_.details.photosynthesis) return;
        const Spacing& spacing = request_.scenario.field.spacing;
        std::vector<double> areas(plant.groups.size());
        const std::vector<double> of_faces = face_areas(plant);
        for (std::size_t f = 0; f < of_faces.size(); ++f)
            if (plant.groups[plant.face_group[f]].tissue == Tissue::leaf)
                areas[plant.face_group[f]] +=
                    of_faces[f] / (spacing.row * spacing.plant);
        rates_ = rates_of_groups(*request_.details.photosynthesis, plant.groups,
                                 areas);
    }

    bool needs_pieces() const {
        return request_.details.photosynthesis && !request_.details.exact;
    }

    Mesh split(Mesh mesh) const {
        if (!request_.details.faces) return mesh;
        return with_a_group_per_face(std::move(mesh));
    }

    //! @param groups of the mesh before it was cut into pieces
    void trace(Field& field, const std::vector<Group>& groups,
               std::optional<Pieces> pieces, Accuracy accuracy,
               const Randomness& randomness) {
        if (pieces) std::swap(field.mesh, pieces->mesh);
        const Mesh& mesh = field.mesh;
        const Illumination& light = request_.scenario.light.light;
        result_.groups = groups;
        result_.boundary = field.boundary;
        result_.ground_area = field.ground_area;
        const PlantArea area = plant_area(mesh);
        result_.lai = area.leaves / field.ground_area;
        result_.plant_area_index =
            result_.lai + area.other_organs / field.ground_area;
        area_of_fields_.leaves += area.leaves / field.ground_area;
        area_of_fields_.other_organs += area.other_organs / field.ground_area;
        if (request_.details.faces) add_areas(mesh);
        ++fields_;
        take(result_.seconds.geometry);

        // Each source has a path of its own.
        accuracy.paths =
            std::max(accuracy.paths, static_cast<int>(light.sources.size()));
        const Scene scene = build_scene(device_, field);
        Layers& layers = result_.layers;
        if (!(layers.thickness > 0))
            layers.thickness = scene.top() / static_cast<double>(layers.count);
        take(result_.seconds.scene);

        Simulation found = simulate_to_tolerance(
            scene, mesh.groups, request_.scenario.optics, light, accuracy,
            randomness, layers, pieces ? Detail::leaf_light : Detail::sums);
        if (pieces)
            assimilate_in(scene, *pieces, groups, found.tallies);
        else if (request_.details.photosynthesis)
            assimilate_exactly_in(scene, mesh, accuracy, randomness);
        accuracy.paths = found.paths;
        result_.paths += accuracy.all_paths();
        if (is_one_of_many_) found.tallies = {mean_of(found.tallies)};
        append(tallies_, std::move(found.tallies));
        result_.is_capped |= found.is_capped;
        if (request_.details.sunlit) {
            accuracy.paths = std::min(accuracy.paths, most_sunlit_points);
            append(sunlit_,
                   sunlit_fractions(scene, mesh, light, accuracy, randomness));
        }
        take(result_.seconds.light);
    }

    //! Assimilation in one field; afterwards its tallies are those of the mesh
    //! that was cut.
    void assimilate_in(const Scene& scene, const Pieces& pieces,
                       const std::vector<Group>& groups,
                       std::vector<Tally>& tallies) {
        for (std::size_t v = 0; v < pieces.count; ++v)
            add_leaf_area(groups.size(), pieces.group[v], pieces.area[v]);
        const SeriesIllumination& light = request_.scenario.light;
        const Optics& optics = request_.scenario.optics;
        const double absorptance = 1 - optics.leaf.scattered();
        std::vector<AssimilationTally> found = assimilate(
            tallies, scene, pieces, optics, light,
            *request_.details.photosynthesis, rates(groups), result_.layers);
        SunlitFractions sunlit =
            sunlit_fractions(tallies, scene, light.light, absorptance,
                             result_.lai * result_.ground_area);
        std::vector<LightClasses> classes;
        if (request_.details.sunlit && absorptance > 0)
            classes =
                leaf_area_by_light(tallies, scene, pieces, light, absorptance,
                                   request_.details.photosynthesis->photons);
        if (is_one_of_many_) {
            found = {mean_of(found, &AssimilationTally::groups,
                             &AssimilationTally::layers,
                             &AssimilationTally::steps)};
            sunlit.fractions = {mean_of(sunlit.fractions)};
            if (!classes.empty())
                classes = {mean_of(classes, &LightClasses::sunlit,
                                   &LightClasses::shaded)};
        }
        append(assimilation_, std::move(found));
        append(hit_by_sun_, std::move(sunlit));
        append(light_classes_, std::move(classes));
        add_up_pieces(tallies, pieces.group, groups.size());
    }

    void assimilate_exactly_in(const Scene& scene, const Mesh& mesh,
                               const Accuracy& accuracy,
                               const Randomness& randomness) {
        const std::vector<double> areas = face_areas(mesh);
        for (std::size_t f = 0; f < areas.size(); ++f)
            if (mesh.groups[mesh.face_group[f]].tissue == Tissue::leaf)
                add_leaf_area(mesh.groups.size(), mesh.face_group[f], areas[f]);
        ExactAssimilation found = assimilate_exactly(
            scene, mesh, request_.scenario.optics, request_.scenario.light,
            *request_.details.photosynthesis, rates(mesh.groups),
            result_.layers, accuracy, randomness);
        append(assimilation_, std::move(found.tallies));
        result_.is_capped |= found.is_capped;
    }

    void add_leaf_area(std::size_t groups, std::uint32_t group, double area) {
        leaf_area_index_.resize(groups);
        leaf_area_index_[group] += area / result_.ground_area;
    }

    //! The same in all fields.
    const std::vector<LeafRates>& rates(const std::vector<Group>& groups) {
        if (rates_.empty())
            rates_ = rates_of_groups(*request_.details.photosynthesis, groups,
                                     leaf_area_index_);
        return rates_;
    }

    void add_areas(const Mesh& mesh) {
        const std::vector<double> areas = face_areas(mesh);
        areas_.resize(mesh.groups.size());
        for (std::size_t f = 0; f < areas.size(); ++f)
            areas_[mesh.face_group[f]] += areas[f];
    }

    std::vector<Estimate> per_area() const {
        std::vector<Estimate> faces = result_.light.groups;
        for (std::size_t face = 0; face < faces.size(); ++face) {
            const double area = areas_[face] / fields_;
            faces[face] = area > 0
                              ? scaled(faces[face], result_.ground_area / area)
                              : Estimate{};
        }
        return faces;
    }

    double time() const { return clock_ ? clock_() : 0; }

    void take(double& part) {
        const double now = time();
        part += now - std::exchange(last_, now);
    }

    const CanopyRequest& request_;
    const Device& device_;
    const Clock& clock_;
    double last_;
    //! Each field is one of many randomisations, with several of its own.
    bool is_one_of_many_ = false;
    CanopyReport result_;
    std::vector<Tally> tallies_;
    SunlitFractions sunlit_;      //!< by points of leaves
    SunlitFractions hit_by_sun_;  //!< by first hits
    std::vector<LightClasses> light_classes_;
    std::vector<AssimilationTally> assimilation_;
    std::vector<LeafRates> rates_;         //!< of each group
    std::vector<double> leaf_area_index_;  //!< of each group, of all fields
    std::vector<double> areas_;            //!< of all copies of each face [m2]
    PlantArea area_of_fields_;             //!< sum, per ground area
    int fields_ = 0;
};

}  // namespace

CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock) {
    Evaluation evaluation(request, device, clock);
    std::visit([&](const auto& stand) { evaluation.trace(stand); },
               request.stand);
    return evaluation.report();
}

Scene build_scene(const Device& device, const Field& field) {
    return field.boundary == Boundary::isolated
               ? Scene::isolated(device, field.mesh, field.ground_area)
               : Scene(device, field.mesh, field.period_x, field.period_y);
}

Accuracy face_accuracy(const Accuracy& accuracy, std::size_t faces) {
    constexpr int paths_per_face = 1600;
    constexpr double most_paths = 8e6;
    const double enough =
        std::min(paths_per_face * static_cast<double>(faces), most_paths) /
        accuracy.randomisations;
    // Powers of two are where Sobol' nets are most even.
    const int paths = 1 << static_cast<int>(std::ceil(std::log2(enough)));
    return {std::max(accuracy.paths, paths), accuracy.randomisations};
}

}  // namespace ideotype
