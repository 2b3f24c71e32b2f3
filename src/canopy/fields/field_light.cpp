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

//! Number of points that determines a sunlit fraction to about 0.2 %.
constexpr int most_sunlit_points = 2048;

//! A random field before light is traced.
struct DrawnField {
    Field field;
    Pieces pieces;          //!< empty if leaves are not cut
    Randomness randomness;  //!< random numbers of the light
    FieldLight measured{};  //!< result of the field, with areas only

    const Mesh& mesh() const { return field.mesh; }
};

void measure_rows(const Evaluation& all, const std::vector<double>& of_faces,
                  DrawnField& drawn) {
    const Mesh& mesh = drawn.mesh();
    const Pieces& pieces = drawn.pieces;
    if (pieces.rows == 0) return;
    const std::size_t groups = all.lines.groups.size();
    std::vector<double>& rows = drawn.measured.areas_of_rows;
    rows.resize(pieces.rows * groups);
    for (std::size_t f = 0; f < of_faces.size(); ++f)
        if (const std::uint32_t group = mesh.face_group[f];
            mesh.groups[group].id.is_leaf())
            rows[pieces.row[group] * groups + pieces.group[group]] +=
                of_faces[f] / all.scene.cell.ground_area;
}

//! Computes the leaf area index of each group of the lines.
void measure_groups(const Evaluation& all, const std::vector<double>& of_faces,
                    DrawnField& drawn) {
    const Mesh& mesh = drawn.mesh();
    const Pieces& pieces = drawn.pieces;
    const double ground = all.scene.cell.ground_area;
    std::vector<double>& index = drawn.measured.leaf_area_index;
    index.resize(all.lines.groups.size());
    if (all.lines.are_cut) {
        for (std::size_t v = 0; v < pieces.count; ++v)
            if (all.lines.groups[pieces.group[v]].id.is_leaf())
                index[pieces.group[v]] += pieces.area[v] / ground;
        return;
    }
    for (std::size_t f = 0; f < of_faces.size(); ++f)
        if (mesh.groups[mesh.face_group[f]].id.is_leaf())
            index[mesh.face_group[f]] += of_faces[f] / ground;
}

//! Computes areas per ground area, and areas of groups if groups are faces.
void measure(const Evaluation& all, DrawnField& drawn) {
    const Mesh& mesh = drawn.mesh();
    const double ground = all.scene.cell.ground_area;
    const std::vector<double> of_faces = face_areas(mesh);
    std::vector<PlantArea> areas(all.scene.components.size());
    for (std::size_t f = 0; f < of_faces.size(); ++f) {
        const SurfaceId& id = mesh.groups[mesh.face_group[f]].id;
        if (id.is_leaf())
            areas[id.component].leaves += of_faces[f];
        else if (!id.is_object())
            areas[id.component].other_organs += of_faces[f] / 2;
    }
    FieldLight& measured = drawn.measured;
    for (const PlantArea& each : areas)
        measured.areas.push_back(
            {each.leaves / ground, each.other_organs / ground});
    measure_rows(all, of_faces, drawn);
    if (all.scene.assimilates()) measure_groups(all, of_faces, drawn);
    if (!all.request.details.faces) return;
    measured.areas_of_groups.resize(all.lines.groups.size());
    for (std::size_t f = 0; f < of_faces.size(); ++f) {
        const std::uint32_t group = mesh.face_group[f];
        measured.areas_of_groups[all.lines.are_cut ? drawn.pieces.group[group]
                                                   : group] += of_faces[f];
    }
}

DrawnField draw(const Evaluation& all, int number) {
    DrawnField drawn{
        draw_field(all.scene, all.plan.of_plants(number), all.lines.meshes),
        {},
        all.plan.of_light(number)};
    if (all.lines.are_cut) {
        drawn.pieces = pieces_of_field(all.lines.pieces, drawn.field);
        drawn.field.mesh = std::move(drawn.pieces.mesh);
    }
    measure(all, drawn);
    return drawn;
}

LeafArea leaf_area_of(const Evaluation& all,
                      const std::vector<PlantArea>& areas) {
    LeafArea sum;
    for (std::size_t c = 0; c < areas.size(); ++c) {
        sum.all += areas[c].leaves;
        if (all.scene.components[c].photosynthesis)
            sum.assimilating += areas[c].leaves;
    }
    return sum;
}

//! Computes light and assimilation in a field and collects the results.
class FieldPass {
  public:
    FieldPass(const Evaluation& all, const FirstLook& look,
              const DrawnField& drawn, const RayScene& surfaces)
        : all_(all),
          look_(look),
          drawn_(drawn),
          surfaces_(surfaces),
          found_(drawn.measured) {}

    FieldLight follow(Simulation simulation) && {
        if (scene_.assimilates()) {
            if (lines_.are_cut)
                assimilate(simulation.tallies);
            else if (scene_.water)
                throw Error(
                    "exact assimilation has no leaves that exchange heat and "
                    "water; evaluate them without details.exact");
            else
                assimilate_exactly();
            note_leaf_area();
        }
        Accuracy accuracy = plan_.accuracy;
        accuracy.paths = simulation.paths;
        found_.paths = accuracy.all_paths();
        found_.is_capped |= simulation.is_capped;
        simulation.tallies.resize(scene_.bands.size());
        take_light(std::move(simulation.tallies));
        if (all_.request.details.sunlit) {
            accuracy.paths = std::min(accuracy.paths, most_sunlit_points);
            found_.sunlit =
                sunlit_fractions(surfaces_, mesh_, scene_.light().light,
                                 accuracy, drawn_.randomness);
        }
        found_.fields = 1;
        return std::move(found_);
    }

  private:
    LitLeaves lit() const {
        return {surfaces_,      mesh_.groups, scene_.bands.front(),
                scene_.photons, look_.leaves, look_.layers};
    }

    void assimilate(const BandTallies& bands) {
        const std::vector<Tally>& tallies = bands.front();
        LitLeaves leaves = lit();
        std::optional<LeafAir> air;
        if (scene_.water) {
            air.emplace(water_leaves(bands));
            leaves.air = &*air;
            measure_layers();
        }
        found_.fluxes = ideotype::assimilate(tallies, pieces_, leaves);
        found_.hit_by_sun =
            sunlit_fractions(tallies, surfaces_, mesh_.groups,
                             leaves.par.optics, leaves.par.light.light,
                             leaf_area_of(all_, found_.areas).assimilating *
                                 scene_.cell.ground_area);
        if (all_.request.details.sunlit)
            found_.light_classes = leaf_area_by_light(tallies, pieces_, leaves);
        if (!plan_.is_one_of_many) return;
        for (std::vector<FluxTally>& flux : found_.fluxes.tallies)
            flux = {mean_of(flux)};
        found_.hit_by_sun.fractions = {mean_of(found_.hit_by_sun.fractions)};
        if (!found_.light_classes.empty())
            found_.light_classes = {mean_of(found_.light_classes)};
    }

    //! Stores the leaf area of this field, from which carbon losses are
    //! computed, if fields may differ.
    void note_leaf_area() {
        if (plan_.fields == 1) return;
        for (FluxTally& gross : found_.fluxes.tallies.front()) {
            gross.leaf_area = found_.leaf_area_index;
            gross.leaf_area_of_rows = found_.areas_of_rows;
        }
    }

    //! Returns the leaves of this field with the light that heats them.
    WaterLeaves water_leaves(const BandTallies& tallies) const {
        WaterLeaves leaves{scene_, look_.leaves, lines_.groups, lines_.height,
                           drawn_.randomness};
        if (!scene_.water->has_leaf_temperature) return leaves;
        for (std::size_t b = 1; b < tallies.size(); ++b) {
            const Band& band = all_.bands[b];
            if (band.name == nir)
                leaves.nir.emplace(OtherLight{band, tallies[b]});
            if (band.name == longwave)
                leaves.longwave.emplace(OtherLight{band, tallies[b]});
        }
        return leaves;
    }

    //! Computes the assimilating leaf area of each layer.
    void measure_layers() {
        found_.leaf_area_of_layers.resize(look_.layers.count);
        for (std::size_t v = 0; v < pieces_.count; ++v)
            if (look_.leaves[pieces_.group[v]].exchanges_water())
                found_
                    .leaf_area_of_layers[look_.layers.at(pieces_.height[v])] +=
                    pieces_.area[v] / scene_.cell.ground_area;
    }

    void assimilate_exactly() {
        ExactAssimilation exact = ideotype::assimilate_exactly(
            mesh_, lit(), plan_.accuracy, drawn_.randomness);
        found_.fluxes.tallies = {std::move(exact.tallies)};
        found_.is_capped |= exact.is_capped;
    }

    void take_light(BandTallies tallies) {
        for (std::vector<Tally>& band : tallies) {
            auto& rows = found_.rows.emplace_back(
                light_of_rows(band, pieces_, mesh_.groups));
            if (lines_.are_cut)
                add_up_pieces(band, pieces_, lines_.groups.size());
            if (!plan_.is_one_of_many) continue;
            band = {mean_of(band)};
            if (!rows.empty()) rows = {mean_of(rows)};
        }
        found_.light = std::move(tallies);
        found_.leaf_area.assign(found_.light.front().size(),
                                leaf_area_of(all_, found_.areas));
    }

    const Evaluation& all_;
    const FirstLook& look_;
    const DrawnField& drawn_;
    const RayScene& surfaces_;
    const Scene& scene_ = all_.scene;
    const Plan& plan_ = all_.plan;
    const Lines& lines_ = all_.lines;
    const Mesh& mesh_ = drawn_.field.mesh;
    const Pieces& pieces_ = drawn_.pieces;
    FieldLight found_;
};

Subject subject_of(const Evaluation& all, const Layers& layers,
                   const DrawnField& drawn, const RayScene& surfaces) {
    return {surfaces, drawn.mesh().groups, all.bands, layers,
            drawn.pieces.count};
}

//! Returns the leaves of each group, which are the same in all fields.
std::vector<LeafGroup> leaves_of(const Evaluation& all,
                                 const DrawnField& drawn) {
    if (!all.scene.assimilates()) return {};
    return leaf_groups(all.scene, all.lines.groups,
                       all.scene.varies() ? all.lines.leaf_area_index
                                          : drawn.measured.leaf_area_index);
}

Layers layers_of(const CanopyRequest& request, const RayScene& surfaces) {
    Layers layers = request.layers;
    if (!(layers.thickness > 0))
        layers.thickness = surfaces.top() / static_cast<double>(layers.count);
    return layers;
}

LightWork try_out(const Evaluation& all, const Layers& layers,
                  const DrawnField& drawn, const RayScene& surfaces) {
    Demand demand = find_demand(subject_of(all, layers, drawn, surfaces),
                                all.plan.accuracy, drawn.randomness);
    const BoxTree tree = quickest_tree(demand.rays, surfaces.faces());
    return {std::move(demand), tree};
}

//! Simulates the first field with the work of the request or, if there is none,
//! with that found by trials. Other fields repeat this work.
//! @param surfaces get the tree of boxes that suits the work, if there are
//! further fields
//! @param simulation receives the light in this field
FirstLook look_at(const Evaluation& all, const DrawnField& drawn,
                  const Device& device, RayScene& surfaces,
                  Simulation& simulation) {
    FirstLook look{layers_of(all.request, surfaces)};
    look.leaves = leaves_of(all, drawn);
    const Subject subject = subject_of(all, look.layers, drawn, surfaces);
    const Accuracy& accuracy = all.plan.accuracy;
    const std::optional<LightWork>& known = all.request.work;
    LightWork work =
        known ? *known : try_out(all, look.layers, drawn, surfaces);
    look.tree = work.tree;
    if (all.plan.fields > 1 && !known) surfaces.set_tree(device, look.tree);
    simulation =
        simulate(subject, std::move(work.demand), accuracy, drawn.randomness);
    look.trial = {{}, simulation.paths, simulation.is_capped, simulation.work};
    return look;
}

//! Traces as much light as the tolerance required in the first field.
Simulation repeat(const Evaluation& all, const FirstLook& look,
                  const DrawnField& drawn, const RayScene& surfaces) {
    const Subject subject = subject_of(all, look.layers, drawn, surfaces);
    const Accuracy& accuracy = all.plan.accuracy;
    Simulation next = look.trial;
    next.tallies = next.work.first_hits.empty()
                       ? simulate(subject, accuracy, drawn.randomness)
                       : simulate(subject, next.work, accuracy.randomisations,
                                  drawn.randomness);
    return next;
}

//! Generates a random field and computes its light and assimilation, by
//! evaluation.
//! @param tree tree of boxes with which the surfaces are built
//! @param trace returns the simulation of the field and the results that the
//! first field fixes for all fields
std::vector<FieldLight> light_in(const Evaluations& all, int number,
                                 const Device& device, const Clock& clock,
                                 BoxTree tree, const auto& trace) {
    double last = clock ? clock() : 0;
    Timing seconds;
    const auto take = [&](double& part) {
        const double now = clock ? clock() : 0;
        part += now - std::exchange(last, now);
    };
    const DrawnField drawn = draw(*all.front(), number);
    take(seconds.geometry);
    RayScene surfaces = build_scene(device, drawn.field, tree);
    take(seconds.scene);
    auto [simulation, looks] = trace(drawn, surfaces);
    std::vector<FieldLight> lights;
    // All evaluations but the last need a copy of the simulation.
    const auto follow = [&, &looks = looks](Simulation one) {
        const std::size_t i = lights.size();
        lights.push_back(FieldPass(*all[i], looks[i], drawn, surfaces)
                             .follow(std::move(one)));
    };
    for (std::size_t i = 1; i < all.size(); ++i) follow(simulation);
    follow(std::move(simulation));
    take(seconds.light);
    lights.front().seconds = seconds;
    return lights;
}

//! Returns the tree of the first field. A single field without known work is
//! traced by trials and by the result, so that its faces meet many rays.
BoxTree first_tree(const CanopyRequest& request, const Plan& plan) {
    if (request.work) return request.work->tree;
    return plan.fields > 1 && plan.accuracy.tolerance > 0 ? BoxTree::by_order
                                                          : BoxTree::by_area;
}

}  // namespace

LightWork work_in_first_field(const Evaluation& all, const Device& device) {
    const DrawnField drawn = draw(all, 0);
    const RayScene surfaces =
        build_scene(device, drawn.field, first_tree(all.request, all.plan));
    return try_out(all, layers_of(all.request, surfaces), drawn, surfaces);
}

FirstField first_field(const Evaluations& all, const Device& device,
                       const Clock& clock) {
    using Traced = std::pair<Simulation, const std::vector<FirstLook>&>;
    FirstField first;
    first.lights = light_in(
        all, 0, device, clock,
        first_tree(all.front()->request, all.front()->plan),
        [&](const DrawnField& drawn, RayScene& surfaces) {
            Simulation simulation;
            first.looks.assign(all.size(), look_at(*all.front(), drawn, device,
                                                   surfaces, simulation));
            for (std::size_t i = 1; i < all.size(); ++i)
                first.looks[i].leaves = leaves_of(*all[i], drawn);
            return Traced(std::move(simulation), first.looks);
        });
    return first;
}

std::vector<FieldLight> light_in_field(const Evaluations& all,
                                       const std::vector<FirstLook>& looks,
                                       int number, const Device& device,
                                       const Clock& clock) {
    using Traced = std::pair<Simulation, const std::vector<FirstLook>&>;
    return light_in(
        all, number, device, clock, looks.front().tree,
        [&](const DrawnField& drawn, const RayScene& surfaces) {
            return Traced(repeat(*all.front(), looks.front(), drawn, surfaces),
                          looks);
        });
}

}  // namespace ideotype
