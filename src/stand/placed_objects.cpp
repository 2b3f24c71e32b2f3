// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "campaign/meshes.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! Returns the rows of panels in each pose, or in their only position.
//! @param angles angle of each pose [deg]
Mesh mesh_of(const PanelRows& rows, const Cell& cell, double row_direction,
             const std::vector<double>& angles) {
    if (!rows.tracks) return panel_mesh(rows, cell, row_direction, rows.tilt);
    Mesh all;
    for (const double angle : angles) {
        const Mesh one = panel_mesh(rows, cell, row_direction, angle);
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        const auto pose = static_cast<std::uint32_t>(all.groups.size() + 1);
        all.groups.push_back(one.groups.front());
        all.groups.back().pose = pose;
        all.groups.back().name += fmt::format("_pose{:02}", pose);
        all.vertices.insert(all.vertices.end(), one.vertices.begin(),
                            one.vertices.end());
        for (auto face : one.faces) {
            for (std::uint32_t& vertex : face) vertex += first;
            all.faces.push_back(face);
            all.face_group.push_back(pose - 1);
        }
    }
    return all;
}

//! Sets the pose that all tracking rows have for the sun of each source.
//! @return angles of each tracking row [deg], by pose
std::vector<std::vector<double>> set_poses(Scene& scene,
                                           const std::vector<PanelRows>& all) {
    std::vector<std::vector<double>> poses;
    std::vector<std::uint32_t> pose_of;
    for (const std::size_t i : scene.light().instant_of) {
        std::vector<double> angles;
        const SunPosition& sun = scene.light().series.steps[i].sun;
        for (const PanelRows& rows : all)
            angles.push_back(rows.tracks ? tracker_angle(rows, sun)
                                         : rows.tilt);
        const auto found = std::find(poses.begin(), poses.end(), angles);
        pose_of.push_back(
            static_cast<std::uint32_t>(found - poses.begin() + 1));
        if (found == poses.end()) poses.push_back(angles);
    }
    for (Band& band : scene.bands)
        for (std::size_t s = 0; s < pose_of.size(); ++s)
            band.light.light.sources[s].pose = pose_of[s];
    return poses;
}

}  // namespace

bool has_trackers(const Campaign& campaign) {
    return std::ranges::any_of(campaign.spec.panels, &PanelRows::tracks,
                               &PanelEntry::rows);
}

void add_objects(Scene& scene, const Campaign& campaign,
                 const Spacing& spacing) {
    std::vector<PanelRows> all;
    for (const PanelEntry& each : campaign.spec.panels)
        all.push_back(in_cell(each.rows, scene.cell, spacing.row_direction));
    std::vector<std::vector<double>> poses;
    if (has_trackers(campaign)) poses = set_poses(scene, all);
    for (std::size_t p = 0; p < all.size(); ++p) {
        std::vector<double> angles;
        for (const std::vector<double>& pose : poses) angles.push_back(pose[p]);
        Mesh mesh = mesh_of(all[p], scene.cell, spacing.row_direction, angles);
        add_surfaces(campaign.spec.panels[p].optics, mesh, scene.bands);
        scene.objects.push_back({all[p].name, std::move(mesh), true});
    }
    for (const ObjectEntry& each : campaign.spec.objects) {
        Mesh mesh = mesh_of(each);
        add_surfaces(each.optics, mesh, scene.bands);
        scene.objects.push_back({each.name, std::move(mesh)});
    }
}

}  // namespace ideotype
