// SPDX-License-Identifier: Apache-2.0
// Tests components of campaigns that are given as a mesh instead of a crop.
#include <fstream>

#include <fmt/format.h>

#include "campaign/meshes.hpp"
#include "mixtures.hpp"
#include "temporary_folder.hpp"

namespace ideotype {
namespace {

//! Formats a mesh with all digits of its coordinates.
std::string written(const Mesh& mesh) {
    const std::string path = temporary_file("weed.obj");
    std::ofstream file(path);
    for (const glm::dvec3& v : mesh.vertices)
        file << fmt::format("v {} {} {}\n", v.x, v.y, v.z);
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        file << "g " << mesh.groups[g].name << '\n';
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            if (mesh.face_group[f] == g) {
                file << 'f';
                for (const std::uint32_t v : mesh.faces[f])
                    file << ' ' << v + 1;
                file << '\n';
            }
    }
    return path;
}

//! Returns a square sheet at a height of 1 m, a single leaf.
std::string sheet() {
    const std::string path = temporary_file("sheet.obj");
    std::ofstream(path) << "v 0 0 1\nv .1 0 1\nv .1 .1 1\nv 0 .1 1\n"
                           "g leaf01\nf 1 2 3 4\n";
    return path;
}

class ComponentMeshes : public Mixtures {
  protected:
    static Campaign read(const std::vector<std::string>& settings) {
        return read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml", settings);
    }

    //! Returns all problems of a component with the given keys.
    static std::string problems_of(const std::string& keys,
                                   std::vector<std::string> settings = {}) {
        settings.push_back("component=[{name=\"tree\", rows=[2], " + keys +
                           "}]");
        try {
            read(settings);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
};

//! Returns the gross assimilation of the leaves of a component.
double gross_of_leaves(const CanopyReport& report, std::uint32_t component) {
    double sum = 0;
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (const SurfaceId& id = report.groups[g].id;
            id.component == component && id.is_leaf())
            sum += report.assimilation->gross.groups[g].mean;
    return sum;
}

TEST_F(ComponentMeshes, OfAPlantAbsorbAsThePlantDoes) {
    const std::vector<std::string> plain{"field.variation={}"};
    std::vector<std::string> settings = plain;
    settings.push_back(weed);
    const Campaign campaign = read(settings);
    const ComponentEntry& crop = campaign.components.front();
    const Mesh mesh =
        build_plant(crop.crop.baseline, campaign.spec.plant.tessellation);
    const CanopyReport plants = evaluated(settings);
    settings = plain;
    const auto optics = [](const Lambertian& surface) {
        return fmt::format("[{}, {}]", surface.reflectance,
                           surface.transmittance);
    };
    const PlantOptics& par = crop.optics[par_band];
    settings.push_back(fmt::format(
        "component=[{{name=\"weed\", mesh=\"{}\", rows=[2, 4], material=[{{"
        "groups=\"leaf\", par={}}}, {{groups=\"sheath\", par={}}}, {{"
        "groups=\"\", par={}}}], photosynthesis={{rate_2000=52, "
        "profile=\"exponential\"}}}}]",
        written(mesh), optics(par.leaf), optics(par.sheath),
        optics(par.stalk)));
    const CanopyReport meshes = evaluated(settings);
    EXPECT_NEAR(meshes.lai, plants.lai, 1e-9);
    for (std::size_t c = 0; c < 2; ++c) {
        expect_equal(meshes.par().part(c).leaves, plants.par().part(c).leaves,
                     "leaves");
        expect_equal(meshes.par().part(c).all, plants.par().part(c).all, "all");
        EXPECT_NEAR(gross_of_leaves(meshes, static_cast<std::uint32_t>(c)) /
                        gross_of_leaves(plants, static_cast<std::uint32_t>(c)),
                    1, 2e-2);
    }
}

TEST_F(ComponentMeshes, AreContainedInResolvedTexts) {
    const Campaign campaign =
        read({"component=[{name=\"tree\", rows=[2], mesh=\"" + sheet() +
                  "\", material=[{groups=\"leaf\", par=[0.1, 0.2, 0.3]}], "
                  "photosynthesis={amax=40}}]",
              "objective.maximise=net_assimilation"});
    const Campaign again = parse_campaign(campaign.resolved, "a file");
    EXPECT_EQ(again.resolved, campaign.resolved);
    const ComponentEntry& tree = again.components.front();
    ASSERT_TRUE(tree.mesh);
    EXPECT_EQ(tree.mesh->faces, campaign.components.front().mesh->faces);
    EXPECT_TRUE(tree.mesh->groups.front().id.is_leaf());
    EXPECT_EQ(tree.materials.size(), 1u);
    ASSERT_TRUE(tree.photosynthesis);
    EXPECT_EQ(tree.photosynthesis->profile, CapacityProfile::none);
}

TEST_F(ComponentMeshes, WithoutPhotosynthesisDoNotAssimilate) {
    const CanopyReport report =
        evaluated({"component=[{name=\"tree\", rows=[2], mesh=\"" + sheet() +
                   "\", material=[{groups=\"leaf\", par=[0, 0]}]}]"});
    EXPECT_GT(report.par().part(1).leaves.mean, 0);
    EXPECT_EQ(gross_of_leaves(report, 1), 0);
    EXPECT_GT(gross_of_leaves(report, 0), 0);
}

TEST_F(ComponentMeshes, WithoutMatchingMaterialsAreReported) {
    const std::string mesh = "mesh=\"" + sheet() + '"';
    const std::string leaf = ", material=[{groups=\"leaf\", par=[0, 0]}]";
    EXPECT_EQ(problems_of(mesh + leaf), "");
    for (const auto& [keys, part] :
         {std::pair(mesh, "fits no [[component.material]]"),
          {mesh + leaf + ", crop=\"crops/maize.toml\"",
           "component.mesh excludes component.crop"},
          {mesh + leaf + ", later=3", "component.mesh excludes"},
          {mesh + ", material=[{groups=\"leaf\", par=[0.6, 0.5]}]",
           "(more than 1)"},
          {mesh + ", material=[{groups=\"leaf\", par=[0.6]}]", "has 1 values"},
          {mesh + ", material=[{groups=\"leaf\"}]", "has no par"},
          {mesh + ", material=[{groups=\"leaf\", par=[0, 0], red=[0, 0]}]",
           "component.material.red is not a waveband of campaigns"},
          {mesh + leaf + ", photosynthesis={vmax=3}",
           "is not a parameter of the"},
          {std::string("mesh=\"none.obj\"") + leaf, "relative to this file"}}) {
        const std::string all = problems_of(keys);
        EXPECT_NE(all.find(part), std::string::npos) << keys << '\n' << all;
    }
    EXPECT_NE(problems_of(mesh + leaf, {nir}).find("has no nir"),
              std::string::npos);
}

}  // namespace
}  // namespace ideotype
