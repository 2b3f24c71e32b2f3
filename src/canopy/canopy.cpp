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
#include "replicates.hpp"

namespace ideotype {

namespace {

//! The part of a randomised day that a relative error of rounding may reach.
constexpr double balance_tolerance = 1e-9;

//! Enough points to know a sunlit fraction to some 0.2 %.
constexpr int most_sunlit_points = 2048;

//! Randomisations in one field that assimilation needs.
constexpr int fewest_in_field = 4;

//! Returns a scene of which the light of each face is counted for itself.
Scene with_a_group_per_face(Scene scene) {
    const auto split = [](Mesh& mesh) {
        std::vector<Group> groups;
        groups.reserve(mesh.faces.size());
        for (const std::uint32_t group : mesh.face_group)
            groups.push_back(mesh.groups[group]);
        mesh.groups = std::move(groups);
        std::iota(mesh.face_group.begin(), mesh.face_group.end(), 0u);
    };
    for (Component& each : scene.components) split(each.mesh);
    for (FixedObject& each : scene.objects) split(each.mesh);
    return scene;
}

//! The fields of an evaluation, and how light is traced in each.
struct Plan {
    explicit Plan(const CanopyRequest& request)
        : accuracy(request.accuracy), randomness(request.randomness) {
        const bool is_each = randomness.fields == Randomness::Fields::each &&
                             are_drawn(request.scene);
        fields = is_each ? accuracy.randomisations : 1;
        accuracy.randomisations /= fields;
        // Assimilation in a field needs several, see assimilate().
        if (request.scene.assimilates() && !request.details.exact &&
            accuracy.randomisations < fewest_in_field) {
            accuracy.paths /= fewest_in_field;
            accuracy.randomisations = fewest_in_field;
        }
        is_one_of_many = fields > 1 && accuracy.randomisations > 1;
    }

    //! The random numbers of the plants of a field.
    Randomness of_plants(int field) const {
        return randomness.fields == Randomness::Fields::common
                   ? Randomness{randomness.seed}
                   : of_field(field, 1);
    }

    //! The random numbers of the light in a field.
    Randomness of_light(int field) const {
        return of_field(field, is_one_of_many ? accuracy.randomisations : 1);
    }

    Accuracy accuracy;  //!< in each field
    int fields = 1;
    //! Each field is one of many randomisations, with several of its own.
    bool is_one_of_many = false;

  private:
    //! Whether fields may differ from each other.
    static bool are_drawn(const Scene& scene) {
        return std::any_of(scene.components.begin(), scene.components.end(),
                           [](const Component& each) {
                               return each.plant || each.jitter > 0;
                           });
    }

    Randomness of_field(int field, int times) const {
        Randomness numbers = randomness;
        numbers.first_randomisation =
            (numbers.first_randomisation + static_cast<std::uint32_t>(field)) *
            static_cast<std::uint32_t>(times);
        return numbers;
    }

    Randomness randomness;
};

//! One plant of each component, as fields are made of them.
struct Lines {
    Lines(const Scene& scene, const CanopyRequest& request)
        : groups(groups_of(scene)) {
        const Details& details = request.details;
        if (!scene.assimilates() || details.exact) return;
        for (const Component& each : scene.components) {
            if (!each.photosynthesis)
                pieces.push_back(uncut(each.mesh));
            else if (each.plant)
                pieces.push_back(cut_leaves(each.mesh, details.pieces));
            else
                pieces.push_back(cut_coarse_leaves(
                    each.mesh, each.places.size(), request.accuracy.tolerance,
                    details.pieces));
            meshes.push_back(std::move(pieces.back().mesh));
        }
        are_cut = true;
    }

    bool are_cut = false;        //!< so that there are:
    std::vector<Pieces> pieces;  //!< without their meshes
    std::vector<Mesh> meshes;    //!< of the pieces
    std::vector<Group> groups;   //!< of the scene before leaves were cut
};

//! Leaf area index of each group of a scene, of plants that do not deviate from
//! their line.
std::vector<double> leaf_area_of_lines(const Scene& scene, std::size_t groups) {
    std::vector<double> index;
    index.reserve(groups);
    for (const Component& each : scene.components) {
        const std::vector<double> of_faces = face_areas(each.mesh);
        const std::size_t first = index.size();
        index.resize(first + each.mesh.groups.size());
        for (std::size_t f = 0; f < of_faces.size(); ++f)
            if (each.mesh.groups[each.mesh.face_group[f]].id.is_leaf())
                index[first + each.mesh.face_group[f]] +=
                    of_faces[f] / each.ground_per_plant;
    }
    index.resize(groups);
    return index;
}

//! One request on its way to its report, field by field.
class Evaluation {
  public:
    //! @param scene of the request, or with other groups
    Evaluation(const CanopyRequest& request, const Scene& scene,
               const Device& device, const Clock& clock)
        : scene_(scene),
          details_(request.details),
          device_(device),
          clock_(clock),
          last_(time()),
          plan_(request),
          lines_(scene, request),
          tallies_(scene.bands.size()),
          leaf_area_index_(lines_.groups.size()),
          areas_(scene.components.size()) {
        result_.layers = request.layers;
        result_.days = scene.light().series.days;
        result_.groups = lines_.groups;
        result_.boundary = scene.cell.boundary;
        result_.ground_area = scene.cell.ground_area;
        if (details_.lines && !scene.components.empty() &&
            scene.components.front().plant)
            result_.lines =
                distance(*details_.lines, *scene.components.front().plant);
        if (scene.varies())
            leaves_ =
                leaf_groups(scene, lines_.groups,
                            leaf_area_of_lines(scene, lines_.groups.size()));
    }

    CanopyReport result() {
        for (int field = 0; field < plan_.fields; ++field) add_field(field);
        report_areas();
        report_light();
        if (scene_.assimilates()) report_assimilation();
        return std::move(result_);
    }

  private:
    //! Draws a field, and follows light and assimilation in it.
    void add_field(int number) {
        Field field =
            draw_field(scene_, plan_.of_plants(number), lines_.meshes);
        Pieces pieces;
        if (lines_.are_cut) {
            pieces = pieces_of_field(lines_.pieces, field);
            field.mesh = std::move(pieces.mesh);
        }
        const Mesh& mesh = field.mesh;
        add_areas(mesh, pieces);
        take(result_.seconds.geometry);

        const RayScene scene = build_scene(device_, field);
        Layers& layers = result_.layers;
        if (!(layers.thickness > 0))
            layers.thickness = scene.top() / static_cast<double>(layers.count);
        take(result_.seconds.scene);

        const Illumination& light = scene_.light().light;
        Accuracy accuracy = plan_.accuracy;
        // Each source has a path of its own.
        accuracy.paths =
            std::max(accuracy.paths, static_cast<int>(light.sources.size()));
        const Randomness randomness = plan_.of_light(number);
        Simulation found = simulate_to_tolerance(
            {scene, mesh.groups, scene_.bands, layers, pieces.count}, accuracy,
            randomness);
        if (lines_.are_cut)
            assimilate(scene, mesh, pieces, found.tallies.front());
        else if (scene_.assimilates())
            assimilate_exactly(scene, mesh, accuracy, randomness);
        accuracy.paths = found.paths;
        result_.paths += accuracy.all_paths();
        result_.is_capped |= found.is_capped;
        add_light(std::move(found.tallies), pieces);
        if (details_.sunlit) {
            accuracy.paths = std::min(accuracy.paths, most_sunlit_points);
            append(sunlit_,
                   sunlit_fractions(scene, mesh, light, accuracy, randomness));
        }
        take(result_.seconds.light);
    }

    //! Adds the areas of a field per ground area, and those of groups if they
    //! are faces.
    void add_areas(const Mesh& mesh, const Pieces& pieces) {
        const std::vector<double> of_faces = face_areas(mesh);
        std::vector<PlantArea> areas(areas_.size());
        for (std::size_t f = 0; f < of_faces.size(); ++f) {
            const SurfaceId& id = mesh.groups[mesh.face_group[f]].id;
            if (id.is_leaf())
                areas[id.component].leaves += of_faces[f];
            else if (!id.is_object())
                areas[id.component].other_organs += of_faces[f] / 2;
        }
        for (std::size_t c = 0; c < areas.size(); ++c) {
            const PlantArea per_ground{
                areas[c].leaves / result_.ground_area,
                areas[c].other_organs / result_.ground_area};
            if (scene_.varies())
                areas_[c] += per_ground;
            else
                areas_[c] = per_ground;
        }
        // Until all fields are known, those of this one.
        result_.assimilating_lai = 0;
        for (std::size_t c = 0; c < areas.size(); ++c)
            if (scene_.components[c].photosynthesis)
                result_.assimilating_lai +=
                    areas[c].leaves / result_.ground_area;
        if (!details_.faces) return;
        areas_of_groups_.resize(lines_.groups.size());
        for (std::size_t f = 0; f < of_faces.size(); ++f) {
            const std::uint32_t group = mesh.face_group[f];
            areas_of_groups_[lines_.are_cut ? pieces.group[group] : group] +=
                of_faces[f];
        }
    }

    //! Adds the light of a field.
    void add_light(BandTallies found, const Pieces& pieces) {
        for (std::size_t b = 0; b < found.size(); ++b) {
            if (lines_.are_cut)
                add_up_pieces(found[b], pieces, lines_.groups.size());
            if (plan_.is_one_of_many) found[b] = {mean_of(found[b])};
            append(tallies_[b], std::move(found[b]));
        }
    }

    LitLeaves lit(const RayScene& scene, const Mesh& mesh) {
        // They are the same in all fields.
        if (leaves_.empty())
            leaves_ = leaf_groups(scene_, lines_.groups, leaf_area_index_);
        return {scene,          mesh.groups, scene_.bands.front(),
                scene_.photons, leaves_,     result_.layers};
    }

    void assimilate(const RayScene& scene, const Mesh& mesh,
                    const Pieces& pieces, const std::vector<Tally>& tallies) {
        for (std::size_t v = 0; v < pieces.count; ++v)
            leaf_area_index_[pieces.group[v]] +=
                pieces.area[v] / result_.ground_area;
        const LitLeaves leaves = lit(scene, mesh);
        std::vector<AssimilationTally> found =
            ideotype::assimilate(tallies, pieces, leaves);
        SunlitFractions sunlit =
            sunlit_fractions(tallies, scene, mesh.groups, leaves.par.optics,
                             leaves.par.light.light,
                             result_.assimilating_lai * result_.ground_area);
        std::vector<LightClasses> classes;
        if (details_.sunlit)
            classes = leaf_area_by_light(tallies, pieces, leaves);
        if (plan_.is_one_of_many) {
            found = {mean_of(found)};
            sunlit.fractions = {mean_of(sunlit.fractions)};
            if (!classes.empty()) classes = {mean_of(classes)};
        }
        append(assimilation_, std::move(found));
        append(hit_by_sun_, std::move(sunlit));
        append(light_classes_, std::move(classes));
    }

    void assimilate_exactly(const RayScene& scene, const Mesh& mesh,
                            const Accuracy& accuracy,
                            const Randomness& randomness) {
        const std::vector<double> areas = face_areas(mesh);
        for (std::size_t f = 0; f < areas.size(); ++f)
            if (mesh.groups[mesh.face_group[f]].id.is_leaf())
                leaf_area_index_[mesh.face_group[f]] +=
                    areas[f] / result_.ground_area;
        ExactAssimilation found = ideotype::assimilate_exactly(
            mesh, lit(scene, mesh), accuracy, randomness);
        append(assimilation_, std::move(found.tallies));
        result_.is_capped |= found.is_capped;
    }

    void report_areas() {
        const double fields = scene_.varies() ? plan_.fields : 1;
        result_.assimilating_lai = 0;
        for (std::size_t c = 0; c < areas_.size(); ++c) {
            const double lai = areas_[c].leaves / fields;
            const double index = lai + areas_[c].other_organs / fields;
            const Component& component = scene_.components[c];
            result_.components.push_back(
                {component.name, lai, index,
                 component.photosynthesis.has_value()});
            result_.lai += lai;
            result_.plant_area_index += index;
            if (component.photosynthesis) result_.assimilating_lai += lai;
        }
        for (const FixedObject& each : scene_.objects)
            result_.objects.push_back(each.name);
    }

    void report_light() {
        for (std::size_t b = 0; b < scene_.bands.size(); ++b) {
            const Band& band = scene_.bands[b];
            BandReport& report = result_.bands.emplace_back();
            report.name = band.name;
            for (const Tally& tally : tallies_[b]) {
                report.budget_by_randomisation.push_back(tally.budget());
                if (details_.faces) continue;
                report.groups_by_randomisation.push_back(tally.groups);
                report.layers_by_randomisation.push_back(tally.layers);
            }
            report.light = ideotype::report(tallies_[b], band.light);
            report.parts = parts_of(tallies_[b]);
            if (details_.faces) report.faces = per_area(report.light.groups);
            if (!(report.light.balance_error < balance_tolerance))
                throw Error(fmt::format("the energy balance is off by {:.3g}",
                                        report.light.balance_error));
        }
        if (!details_.sunlit) return;
        const SunlitReport sunlit = ideotype::report(sunlit_, scene_.light());
        for (std::size_t h = 0; h < sunlit.hours.size(); ++h)
            result_.bands.front().light.steps[h].sunlit = sunlit.hours[h];
    }

    void report_assimilation() {
        for (double& index : leaf_area_index_) index /= plan_.fields;
        result_.assimilation =
            ideotype::report(std::move(assimilation_), leaves_,
                             leaf_area_index_, scene_.light());
        if (lines_.are_cut)
            result_.hit_by_sun = ideotype::report(hit_by_sun_, scene_.light());
        if (!light_classes_.empty())
            result_.light_classes = ideotype::report(light_classes_);
    }

    //! Returns the light of each component and then of each object.
    std::vector<PartReport> parts_of(const std::vector<Tally>& tallies) const {
        std::vector<PartReport> parts;
        const std::size_t count =
            scene_.components.size() + scene_.objects.size();
        if (count == 1 || details_.faces) return parts;
        for (std::uint32_t c = 0; c < count; ++c) {
            std::vector<std::size_t> leaves, all;
            for (std::size_t g = 0; g < lines_.groups.size(); ++g) {
                const SurfaceId& id = lines_.groups[g].id;
                if (id.component != c) continue;
                all.push_back(g);
                if (id.is_leaf()) leaves.push_back(g);
            }
            parts.push_back({absorbed_by_groups(tallies, leaves),
                             absorbed_by_groups(tallies, all)});
        }
        return parts;
    }

    //! Returns the light of groups that are faces, per area of the face.
    std::vector<Estimate> per_area(std::vector<Estimate> faces) const {
        for (std::size_t face = 0; face < faces.size(); ++face) {
            const double area = areas_of_groups_[face] / plan_.fields;
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

    const Scene& scene_;
    const Details& details_;
    const Device& device_;
    const Clock& clock_;
    double last_;
    const Plan plan_;
    const Lines lines_;
    CanopyReport result_;
    BandTallies tallies_;
    SunlitFractions sunlit_;      //!< by points of leaves
    SunlitFractions hit_by_sun_;  //!< by first hits
    std::vector<LightClasses> light_classes_;
    std::vector<AssimilationTally> assimilation_;
    std::vector<LeafGroup> leaves_;        //!< of each group
    std::vector<double> leaf_area_index_;  //!< of each group, of all fields
    std::vector<PlantArea> areas_;  //!< of components, of all fields [m2 m-2]
    std::vector<double> areas_of_groups_;  //!< of all copies of faces [m2]
};

}  // namespace

CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock) {
    if (!request.details.faces)
        return Evaluation(request, request.scene, device, clock).result();
    const Scene scene = with_a_group_per_face(request.scene);
    return Evaluation(request, scene, device, clock).result();
}

RayScene build_scene(const Device& device, const Field& field) {
    const Cell& cell = field.cell;
    return cell.boundary == Boundary::isolated
               ? RayScene::isolated(device, field.mesh, cell.ground_area)
               : RayScene(device, field.mesh, cell.period_x, cell.period_y);
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
