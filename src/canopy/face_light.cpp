#include "ideotype/canopy/face_light.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ideotype {

namespace {

constexpr int paths_per_face = 1600;
constexpr double most_paths = 8e6;

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

//! Sums up what was found in fields whose mesh has a group per face.
class Sum {
  public:
    Sum(const CanopyModel& model, const Device& device, std::size_t faces)
        : model_(model), device_(device), area_(faces) {}

    void add(const Field& field, const Accuracy& sampling,
             const Randomness& randomness) {
        for (Tally& tally :
             simulate(build_scene(device_, field), field.mesh.groups,
                      model_.optics, model_.light.light, sampling, randomness))
            tallies_.push_back(std::move(tally));
        const std::vector<double> areas = face_areas(field.mesh);
        for (std::size_t f = 0; f < areas.size(); ++f)
            area_[field.mesh.face_group[f]] += areas[f];
        ground_area_ = field.ground_area;
        ++fields_;
    }

    std::vector<Estimate> per_area() const {
        std::vector<Estimate> result = absorbed_by_group(tallies_);
        for (std::size_t face = 0; face < area_.size(); ++face) {
            const double area = area_[face] / fields_;
            result[face] = area > 0 ? scaled(result[face], ground_area_ / area)
                                    : Estimate{};
        }
        return result;
    }

  private:
    const CanopyModel& model_;
    const Device& device_;
    std::vector<Tally> tallies_;
    std::vector<double> area_;  //!< of all copies [m2]
    double ground_area_ = 0;
    int fields_ = 0;
};

}  // namespace

FaceLight light_on_plant(const CanopyModel& model, const Device& device,
                         const Mesh& plant, const Draws& draws) {
    Sum sum(model, device, plant.faces.size());
    for_each_field(model, with_a_group_per_face(plant), draws,
                   [&](const auto&... field) { sum.add(field...); });
    const Spacing& spacing = model.field.spacing;
    return {sum.per_area(), spacing.row * spacing.plant};
}

FaceLight light_on_field(const CanopyModel& model, const Device& device,
                         const Field& field, const Draws& draws) {
    Sum sum(model, device, field.mesh.faces.size());
    Field split = field;
    split.mesh = with_a_group_per_face(std::move(split.mesh));
    sum.add(split, draws.sampling, {draws.seed, draws.generation, 0});
    return {sum.per_area(), field.ground_area};
}

Accuracy face_sampling(const Accuracy& sampling, std::size_t faces) {
    const double enough =
        std::min(paths_per_face * static_cast<double>(faces), most_paths) /
        sampling.randomisations;
    // Powers of two are where Sobol' nets are most even.
    const int paths = 1 << static_cast<int>(std::ceil(std::log2(enough)));
    Accuracy result = sampling;
    result.paths = std::max(sampling.paths, paths);
    return result;
}

}  // namespace ideotype
