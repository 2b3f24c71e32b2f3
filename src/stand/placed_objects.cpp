// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "campaign/meshes.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! Returns the mesh of panel rows in each orientation, or in their fixed
//! position.
//! @param angles angle of each orientation [deg]
Mesh mesh_of(const PanelRows& rows, const Cell& cell, double row_direction,
             const std::vector<double>& angles) {
    if (!rows.tracks) return panel_mesh(rows, cell, row_direction, rows.tilt);
    Mesh posed;
    for (const double angle : angles) {
        const Mesh one = panel_mesh(rows, cell, row_direction, angle);
        const auto first = static_cast<std::uint32_t>(posed.vertices.size());
        const auto pose = static_cast<std::uint32_t>(posed.groups.size() + 1);
        posed.groups.push_back(one.groups.front());
        posed.groups.back().pose = pose;
        posed.groups.back().name += fmt::format("_pose{:02}", pose);
        posed.vertices.insert(posed.vertices.end(), one.vertices.begin(),
                              one.vertices.end());
        for (auto face : one.faces) {
            for (std::uint32_t& vertex : face) vertex += first;
            posed.faces.push_back(face);
            posed.face_group.push_back(pose - 1);
        }
    }
    return posed;
}

//! Assigns each source an orientation index of tracking rows for its sun
//! position.
//! @return angles of each tracking row [deg], by orientation
std::vector<std::vector<double>> set_poses(
    Scene& scene, const std::vector<PanelRows>& panels) {
    std::vector<std::vector<double>> poses;
    std::vector<std::uint32_t> pose_of;
    for (const std::size_t i : scene.light().instant_of) {
        std::vector<double> angles;
        const SunPosition& sun = scene.light().series.steps[i].sun;
        for (const PanelRows& rows : panels)
            angles.push_back(rows.tracks ? tracker_angle(rows, sun)
                                         : rows.tilt);
        const auto pose = std::find(poses.begin(), poses.end(), angles);
        pose_of.push_back(static_cast<std::uint32_t>(pose - poses.begin() + 1));
        if (pose == poses.end()) poses.push_back(angles);
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
    std::vector<PanelRows> panels;
    for (const PanelEntry& each : campaign.spec.panels)
        panels.push_back(in_cell(each.rows, scene.cell, spacing.row_direction));
    std::vector<std::vector<double>> poses;
    if (has_trackers(campaign)) poses = set_poses(scene, panels);
    for (std::size_t p = 0; p < panels.size(); ++p) {
        std::vector<double> angles;
        for (const std::vector<double>& pose : poses) angles.push_back(pose[p]);
        Mesh mesh =
            mesh_of(panels[p], scene.cell, spacing.row_direction, angles);
        add_surfaces(campaign.spec.panels[p].optics, mesh, scene.bands);
        scene.objects.push_back({panels[p].name, std::move(mesh), true});
    }
    for (const ObjectEntry& object : campaign.spec.objects) {
        Mesh mesh = mesh_of(object);
        add_surfaces(object.optics, mesh, scene.bands);
        scene.objects.push_back({object.name, std::move(mesh)});
    }
}

}  // namespace ideotype
