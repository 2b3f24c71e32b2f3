// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "fields/field_light.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

//! The largest relative error of the energy balance in one randomisation that
//! rounding can explain.
constexpr double balance_tolerance = 1e-9;

PlantForm form_of(const Plant& plant, const Tessellation& tessellation) {
    constexpr std::size_t top_leaves = 4;
    PlantForm form;
    for (const auto& vertex : build_plant(plant, tessellation).vertices)
        form.height = std::max(form.height, vertex.z);
    const std::size_t count = std::min(top_leaves, plant.leaves.size());
    for (std::size_t i = 1; i <= count; ++i)
        form.top_leaf_angle +=
            plant.leaves[plant.leaves.size() - i].insertion_angle /
            static_cast<double>(count);
    return form;
}

class Reporter {
  public:
    //! Keeps references to its arguments.
    Reporter(const Evaluation& all, const FirstLook& look,
             const FieldLight& found)
        : all_(all), look_(look), found_(found) {}

    CanopyReport result() && {
        IDEOTYPE_EXPECT(found_.fields > 0);
        IDEOTYPE_EXPECT(found_.light.size() == scene_.bands.size());
        result_.layers = look_.layers;
        result_.days = scene_.light().series.days;
        result_.grows = scene_.light().series.grows;
        result_.has_living_organs = scene_.has_living_organs();
        result_.groups = lines_.groups;
        result_.boundary = scene_.cell.boundary;
        result_.ground_area = scene_.cell.ground_area;
        result_.paths = found_.paths;
        result_.is_capped = found_.is_capped;
        result_.seconds = found_.seconds;
        report_plant();
        report_areas();
        result_.leaf_area_by_randomisation = found_.leaf_area;
        for (std::size_t b = 0; b < scene_.bands.size(); ++b) {
            report_band(scene_.bands[b], found_.light[b]);
            report_rows(result_.bands.back(), found_.light[b], found_.rows[b]);
        }
        if (request_.details.sunlit) report_sunlit();
        if (scene_.assimilates()) report_assimilation();
        report_rows();
        return std::move(result_);
    }

  private:
    //! Reports the form of the first component's plant, which does not depend
    //! on light.
    void report_plant() {
        if (scene_.components.empty() || !scene_.components.front().plant)
            return;
        const Component& first = scene_.components.front();
        const Plant plant = first.full_grown.value_or(*first.plant);
        if (request_.details.form)
            result_.form = form_of(plant, first.tessellation);
        if (const auto& lines = request_.details.lines)
            result_.lines =
                distance(*lines, first.at_reference.value_or(plant));
    }

    void report_areas() {
        const double fields = found_.fields;
        for (std::size_t c = 0; c < found_.areas.size(); ++c) {
            const Component& component = scene_.components[c];
            const double lai = found_.areas[c].leaves / fields;
            const double dead = result_.grows ? dead_area(component.mesh) /
                                                    component.ground_per_plant
                                              : 0;
            // Dead leaves are flat and count with their one-sided area. The
            // area of organs includes them, but only by half.
            const double index =
                lai + found_.areas[c].other_organs / fields + dead / 2;
            result_.components.push_back({component.name, lai, index,
                                          component.photosynthesis.has_value(),
                                          component.ground_per_plant});
            result_.lai += lai;
            result_.plant_area_index += index;
            if (component.photosynthesis) result_.assimilating_lai += lai;
            result_.dead_area_index += dead;
        }
        for (const FixedObject& each : scene_.objects) {
            const std::vector<double> faces = face_areas(each.mesh);
            double area = 0;
            // A moving object contains one group per orientation, all with the
            // same area.
            for (std::size_t f = 0; f < faces.size(); ++f)
                if (each.mesh.groups[each.mesh.face_group[f]].pose <= 1)
                    area += faces[f];
            result_.objects.push_back(
                {each.name, each.is_panel, area / scene_.cell.ground_area});
        }
    }

    void report_band(const Band& band, const std::vector<Tally>& tallies) {
        BandReport& report = result_.bands.emplace_back();
        const bool has_faces = request_.details.faces;
        report.name = band.name;
        report.soil_albedo = band.optics.soil_albedo;
        for (const Tally& tally : tallies) {
            report.budget_by_randomisation.push_back(tally.budget());
            if (has_faces) continue;
            report.groups_by_randomisation.push_back(tally.groups);
            report.layers_by_randomisation.push_back(tally.layers);
        }
        report.light = ideotype::report(tallies, band.light);
        report.objects = light_on_objects(band.optics, report.light.parts);
        report.parts = parts_of(tallies);
        if (has_faces) report.faces = per_area(report.light.groups);
        if (!(report.light.balance_error < balance_tolerance))
            throw Error(
                fmt::format("the light that an evaluation counted differs from "
                            "its sources by a part of {:.3g}, more than "
                            "rounding makes; please report this",
                            report.light.balance_error));
    }

    static void report_rows(BandReport& report,
                            const std::vector<Tally>& tallies,
                            const std::vector<std::vector<double>>& found) {
        report.rows_by_randomisation = found;
        for (std::size_t row = 0; !found.empty() && row < found.front().size();
             ++row) {
            const auto light =
                mapped(found, [&](const auto& each) { return each[row]; });
            report.rows.push_back(absorbed_by_some_leaves(tallies, light));
        }
    }

    //! Reports the leaf area and the carbon losses of each row.
    void report_rows() {
        const Cell& cell = scene_.cell;
        const std::size_t groups = lines_.groups.size();
        for (std::size_t row = 0; row < cell.row_ground.size(); ++row) {
            const double ground = cell.row_ground[row];
            RowReport one{component_of_row(row), cell.rows[row],
                          ground / cell.period_y, ground};
            const std::span areas(&found_.areas_of_rows[row * groups], groups);
            for (std::size_t g = 0; g < groups; ++g) {
                one.lai += areas[g] / found_.fields;
                if (!result_.assimilation) continue;
                const AssimilationReport& all = *result_.assimilation;
                one.assimilation.loss +=
                    loss_of_part(all.losses[g], look_.leaves, g, areas,
                                 found_.leaf_area_index);
            }
            if (result_.assimilation) {
                one.assimilation.loss_by_randomisation = losses_of_row(row);
                const auto of_row = [&](const FluxReport& flux) {
                    return estimate(
                        mapped(flux.tallies, [&](const FluxTally& tally) {
                            return tally.rows[row];
                        }));
                };
                one.assimilation.gross = of_row(result_.assimilation->gross);
                one.assimilation.uptake =
                    of_row(result_.assimilation->before_losses());
            }
            result_.rows.push_back(one);
        }
    }

    //! Returns the losses of a row, by randomisation if each randomisation uses
    //! a separate field.
    std::vector<CarbonLoss> losses_of_row(std::size_t row) const {
        const AssimilationReport& all = *result_.assimilation;
        std::vector<CarbonLoss> losses(all.losses_by_randomisation.size());
        for (std::size_t r = 0; r < losses.size(); ++r) {
            const FluxTally& tally = all.before_losses().tallies[r];
            // Without separate fields, all randomisations use the leaf area of
            // the one field.
            const bool is_own = !tally.leaf_area.empty();
            const std::vector<double>&area =
                      is_own ? tally.leaf_area : found_.leaf_area_index,
                  &areas =
                      is_own ? tally.leaf_area_of_rows : found_.areas_of_rows;
            const std::size_t groups = area.size();
            for (std::size_t g = 0; g < groups; ++g)
                losses[r] += loss_of_part(all.losses_in(r)[g], look_.leaves, g,
                                          {&areas[row * groups], groups}, area);
        }
        return losses;
    }

    //! Returns the component with plants in a row, whether or not they have
    //! leaves.
    std::uint32_t component_of_row(std::size_t row) const {
        for (std::uint32_t c = 0; c < scene_.components.size(); ++c)
            for (const Place& place : scene_.components[c].places)
                if (place.row == row) return c;
        return 0;
    }

    void report_sunlit() {
        const SunlitReport sunlit =
            ideotype::report(found_.sunlit, scene_.light());
        for (std::size_t h = 0; h < sunlit.hours.size(); ++h)
            result_.bands.front().light.steps[h].sunlit = sunlit.hours[h];
    }

    void report_assimilation() {
        std::vector<double> leaf_area_index = found_.leaf_area_index;
        for (double& index : leaf_area_index) index /= found_.fields;
        const bool have_temperature =
            scene_.water && scene_.water->has_leaf_temperature;
        result_.assimilation = ideotype::report(
            found_.fluxes.tallies.front(),
            have_temperature
                ? found_.fluxes
                      .tallies[static_cast<std::size_t>(LeafFlux::respiration)]
                : std::vector<FluxTally>{},
            look_.leaves, leaf_area_index, scene_.light(),
            request_.details.grain);
        if (found_.fluxes.tallies.size() > 1) {
            std::vector<double> layers = found_.leaf_area_of_layers;
            for (double& index : layers) index /= found_.fields;
            result_.water =
                ideotype::report(found_.fluxes.tallies, std::move(layers),
                                 scene_.light().series);
        }
        if (lines_.are_cut)
            result_.hit_by_sun =
                ideotype::report(found_.hit_by_sun, scene_.light());
        if (!found_.light_classes.empty())
            result_.light_classes = ideotype::report(found_.light_classes);
    }

    //! Returns the incident light per area on the sides of objects, computed
    //! from the light that they absorb.
    std::vector<PartLight> light_on_objects(
        const Optics& optics, std::vector<PartLight> absorbed) const {
        absorbed.resize(2 * scene_.objects.size());
        for (std::size_t side = 0; side < absorbed.size(); ++side) {
            const std::uint32_t material =
                scene_.objects[side / 2].mesh.groups.front().material;
            const double kept =
                result_.objects[side / 2].area_index *
                (1 - optics.of(material).face(side % 2 == 0).scattered());
            const double factor = kept > 0 ? 1 / kept : 0;
            PartLight& light = absorbed[side];
            light.day = scaled(light.day, factor);
            for (double& x : light.by_randomisation) x *= factor;
            for (Estimate& x : light.hours) x = scaled(x, factor);
        }
        return absorbed;
    }

    //! Returns the light of each component, then of each object.
    std::vector<PartReport> parts_of(const std::vector<Tally>& tallies) const {
        std::vector<PartReport> parts;
        const std::size_t count =
            scene_.components.size() + scene_.objects.size();
        if (count == 1 || request_.details.faces) return parts;
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

    //! Returns the light per area of each face; each face is a group.
    std::vector<Estimate> per_area(std::vector<Estimate> faces) const {
        for (std::size_t face = 0; face < faces.size(); ++face) {
            const double area = found_.areas_of_groups[face] / found_.fields;
            faces[face] = area > 0
                              ? scaled(faces[face], result_.ground_area / area)
                              : Estimate{};
        }
        return faces;
    }

    const Evaluation& all_;
    const FirstLook& look_;
    const FieldLight& found_;
    const CanopyRequest& request_ = all_.request;
    const Scene& scene_ = all_.scene;
    const Lines& lines_ = all_.lines;
    CanopyReport result_;
};

}  // namespace

CanopyReport report_on(const Evaluation& all, const FirstLook& look,
                       const FieldLight& found) {
    return Reporter(all, look, found).result();
}

}  // namespace ideotype
