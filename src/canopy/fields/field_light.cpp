// SPDX-License-Identifier: Apache-2.0
#include "field_light.hpp"

#include <algorithm>
#include <utility>

#include "ideotype/canopy/exact_assimilation.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/device.hpp"
#include "randomisations.hpp"

namespace ideotype {

namespace {

//! Number of points that gives a sunlit fraction to some 0.2 %.
constexpr int most_sunlit_points = 2048;

//! The work on one field of an evaluation.
class FieldPass {
  public:
    explicit FieldPass(SharedByFields& shared) : shared_(shared) {}

    //! Draws the field, from which its surfaces follow.
    Field draw(int number) {
        randomness_ = plan_.of_light(number);
        Field field =
            draw_field(scene_, plan_.of_plants(number), lines_.meshes);
        if (lines_.are_cut) {
            pieces_ = pieces_of_field(lines_.pieces, field);
            field.mesh = std::move(pieces_.mesh);
        }
        measure_areas(field.mesh);
        return field;
    }

    void follow_light(const RayScene& surfaces, const Mesh& mesh) {
        if (!(shared_.layers.thickness > 0))
            shared_.layers.thickness =
                surfaces.top() / static_cast<double>(shared_.layers.count);
        Accuracy accuracy = plan_.accuracy;
        // Each source needs a path of its own.
        accuracy.paths =
            std::max(accuracy.paths,
                     static_cast<int>(scene_.light().light.sources.size()));
        Simulation simulation = simulate(surfaces, mesh, accuracy);
        if (scene_.assimilates()) {
            if (lines_.are_cut)
                assimilate(surfaces, mesh, simulation.tallies);
            else if (scene_.water)
                throw Error(
                    "exact assimilation has no leaves that exchange heat and "
                    "water; evaluate them without details.exact");
            else
                assimilate_exactly(surfaces, mesh, accuracy);
            note_leaf_area();
        }
        accuracy.paths = simulation.paths;
        found_.paths = accuracy.all_paths();
        found_.is_capped |= simulation.is_capped;
        simulation.tallies.resize(scene_.bands.size());
        take_light(std::move(simulation.tallies), mesh.groups);
        if (!request_.details.sunlit) return;
        accuracy.paths = std::min(accuracy.paths, most_sunlit_points);
        found_.sunlit = sunlit_fractions(surfaces, mesh, scene_.light().light,
                                         accuracy, randomness_);
    }

    FieldLight result() && {
        found_.fields = 1;
        return std::move(found_);
    }

    Timing& seconds() { return found_.seconds; }

  private:
    //! Adds areas per ground area, and areas of groups if groups are faces.
    void measure_areas(const Mesh& mesh) {
        const double ground = scene_.cell.ground_area;
        const std::vector<double> of_faces = face_areas(mesh);
        std::vector<PlantArea> areas(scene_.components.size());
        for (std::size_t f = 0; f < of_faces.size(); ++f) {
            const SurfaceId& id = mesh.groups[mesh.face_group[f]].id;
            if (id.is_leaf())
                areas[id.component].leaves += of_faces[f];
            else if (!id.is_object())
                areas[id.component].other_organs += of_faces[f] / 2;
        }
        for (const PlantArea& each : areas)
            found_.areas.push_back(
                {each.leaves / ground, each.other_organs / ground});
        measure_rows(mesh, of_faces);
        if (!request_.details.faces) return;
        found_.areas_of_groups.resize(lines_.groups.size());
        for (std::size_t f = 0; f < of_faces.size(); ++f) {
            const std::uint32_t group = mesh.face_group[f];
            found_.areas_of_groups[lines_.are_cut ? pieces_.group[group]
                                                  : group] += of_faces[f];
        }
    }

    void measure_rows(const Mesh& mesh, const std::vector<double>& of_faces) {
        if (pieces_.rows == 0) return;
        const std::size_t groups = lines_.groups.size();
        found_.areas_of_rows.resize(pieces_.rows * groups);
        for (std::size_t f = 0; f < of_faces.size(); ++f)
            if (const std::uint32_t group = mesh.face_group[f];
                mesh.groups[group].id.is_leaf())
                found_.areas_of_rows[pieces_.row[group] * groups +
                                     pieces_.group[group]] +=
                    of_faces[f] / scene_.cell.ground_area;
    }

    //! Traces as much light as the tolerance needed in the first field.
    Simulation simulate(const RayScene& surfaces, const Mesh& mesh,
                        const Accuracy& accuracy) {
        const Subject subject{surfaces, mesh.groups, shared_.bands,
                              shared_.layers, pieces_.count};
        if (!shared_.trial) {
            Simulation first =
                simulate_to_tolerance(subject, accuracy, randomness_);
            shared_.trial =
                Simulation{{}, first.paths, first.is_capped, first.work};
            return first;
        }
        Simulation next = *shared_.trial;
        next.tallies =
            next.work.first_hits.empty()
                ? ideotype::simulate(subject, accuracy, randomness_)
                : ideotype::simulate(subject, next.work,
                                     accuracy.randomisations, randomness_);
        return next;
    }

    LitLeaves lit(const RayScene& surfaces, const Mesh& mesh) {
        // All fields have equal groups of leaves.
        if (shared_.leaves.empty())
            shared_.leaves =
                leaf_groups(scene_, lines_.groups, found_.leaf_area_index);
        return {surfaces,       mesh.groups,    scene_.bands.front(),
                scene_.photons, shared_.leaves, shared_.layers};
    }

    LeafArea leaf_area() const {
        LeafArea sum;
        for (std::size_t c = 0; c < found_.areas.size(); ++c) {
            const double lai = found_.areas[c].leaves;
            sum.all += lai;
            if (scene_.components[c].photosynthesis) sum.assimilating += lai;
        }
        return sum;
    }

    void assimilate(const RayScene& surfaces, const Mesh& mesh,
                    const BandTallies& bands) {
        const std::vector<Tally>& tallies = bands.front();
        found_.leaf_area_index.resize(lines_.groups.size());
        for (std::size_t v = 0; v < pieces_.count; ++v)
            if (lines_.groups[pieces_.group[v]].id.is_leaf())
                found_.leaf_area_index[pieces_.group[v]] +=
                    pieces_.area[v] / scene_.cell.ground_area;
        LitLeaves leaves = lit(surfaces, mesh);
        std::optional<LeafAir> air;
        if (scene_.water) {
            air.emplace(water_leaves(bands));
            leaves.air = &*air;
            measure_layers();
        }
        found_.fluxes = ideotype::assimilate(tallies, pieces_, leaves);
        found_.hit_by_sun = sunlit_fractions(
            tallies, surfaces, mesh.groups, leaves.par.optics,
            leaves.par.light.light,
            leaf_area().assimilating * scene_.cell.ground_area);
        if (request_.details.sunlit)
            found_.light_classes = leaf_area_by_light(tallies, pieces_, leaves);
        if (!plan_.is_one_of_many) return;
        for (std::vector<FluxTally>& flux : found_.fluxes)
            flux = {mean_of(flux)};
        found_.hit_by_sun.fractions = {mean_of(found_.hit_by_sun.fractions)};
        if (!found_.light_classes.empty())
            found_.light_classes = {mean_of(found_.light_classes)};
    }

    //! Notes the leaf area of this field, with which leaves lose carbon, if
    //! fields may differ.
    void note_leaf_area() {
        if (plan_.fields == 1) return;
        for (FluxTally& gross : found_.fluxes.front()) {
            gross.leaf_area = found_.leaf_area_index;
            gross.leaf_area_of_rows = found_.areas_of_rows;
        }
    }

    //! Returns the leaves of this field with the light that warms leaves.
    WaterLeaves water_leaves(const BandTallies& tallies) const {
        WaterLeaves leaves{scene_, shared_.leaves, lines_.groups, lines_.height,
                           randomness_};
        if (!scene_.water->has_leaf_temperature) return leaves;
        for (std::size_t b = 1; b < tallies.size(); ++b) {
            const Band& band = shared_.bands[b];
            if (band.name == nir)
                leaves.nir.emplace(OtherLight{band, tallies[b]});
            if (band.name == longwave)
                leaves.longwave.emplace(OtherLight{band, tallies[b]});
        }
        return leaves;
    }

    //! Measures the leaf area of each layer whose leaves assimilate.
    void measure_layers() {
        found_.leaf_area_of_layers.resize(shared_.layers.count);
        for (std::size_t v = 0; v < pieces_.count; ++v)
            if (shared_.leaves[pieces_.group[v]].exchanges_water())
                found_.leaf_area_of_layers[shared_.layers.at(
                    pieces_.height[v])] +=
                    pieces_.area[v] / scene_.cell.ground_area;
    }

    void assimilate_exactly(const RayScene& surfaces, const Mesh& mesh,
                            const Accuracy& accuracy) {
        const std::vector<double> areas = face_areas(mesh);
        found_.leaf_area_index.resize(lines_.groups.size());
        for (std::size_t f = 0; f < areas.size(); ++f)
            if (mesh.groups[mesh.face_group[f]].id.is_leaf())
                found_.leaf_area_index[mesh.face_group[f]] +=
                    areas[f] / scene_.cell.ground_area;
        ExactAssimilation exact = ideotype::assimilate_exactly(
            mesh, lit(surfaces, mesh), accuracy, randomness_);
        found_.fluxes = {std::move(exact.tallies)};
        found_.is_capped |= exact.is_capped;
    }

    //! @param groups groups of the surfaces
    void take_light(BandTallies tallies, const std::vector<Group>& groups) {
        for (std::vector<Tally>& band : tallies) {
            auto& rows =
                found_.rows.emplace_back(light_of_rows(band, pieces_, groups));
            if (lines_.are_cut)
                add_up_pieces(band, pieces_, lines_.groups.size());
            if (!plan_.is_one_of_many) continue;
            band = {mean_of(band)};
            if (!rows.empty()) rows = {mean_of(rows)};
        }
        found_.light = std::move(tallies);
        found_.leaf_area.assign(found_.light.front().size(), leaf_area());
    }

    SharedByFields& shared_;
    const CanopyRequest& request_ = shared_.request;
    const Scene& scene_ = shared_.scene;
    const Plan& plan_ = shared_.plan;
    const Lines& lines_ = shared_.lines;
    Randomness randomness_;
    Pieces pieces_;
    FieldLight found_;
};

}  // namespace

FieldLight light_in_field(int number, SharedByFields& shared,
                          const Device& device, const Clock& clock) {
    double last = clock ? clock() : 0;
    const auto take = [&](double& part) {
        const double now = clock ? clock() : 0;
        part += now - std::exchange(last, now);
    };
    FieldPass pass(shared);
    const Field field = pass.draw(number);
    take(pass.seconds().geometry);
    const RayScene surfaces = build_scene(device, field);
    take(pass.seconds().scene);
    pass.follow_light(surfaces, field.mesh);
    take(pass.seconds().light);
    return std::move(pass).result();
}

}  // namespace ideotype
