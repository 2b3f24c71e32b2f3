// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/obj_reader.hpp"

namespace ideotype {
namespace {

constexpr const char* square =
    "v 0 0 1\n"
    "v 1 0 1\n"
    "v 1 1 1\n"
    "v 0 1 1\n";

ObjMesh parse(const std::string& text) {
    return parse_obj(text, "a.obj");
}

double area(const ObjMesh& obj) {
    const auto areas = face_areas(obj.mesh);
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

std::string parse_error(const std::string& text) {
    try {
        parse(text);
    } catch (const InputError& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::invalid_campaign);
        return error.what();
    }
    return "no error";
}

TEST(ObjReader, TrianglesQuadsAndLargerPolygonsKeepTheirArea) {
    const std::string vertices = square;
    EXPECT_DOUBLE_EQ(area(parse(vertices + "f 1 2 3\n")), 0.5);
    const ObjMesh quad = parse(vertices + "f 1 2 3 4\n");
    EXPECT_EQ(quad.mesh.faces.size(), 1u);
    EXPECT_DOUBLE_EQ(area(quad), 1);
    const ObjMesh hexagon =
        parse(vertices + "v .5 2 1\nv .2 1.2 1\nf 1 2 3 5 6 4\n");
    EXPECT_EQ(hexagon.mesh.faces.size(), 4u);
    EXPECT_NEAR(area(hexagon), 1.45, 1e-12);
    EXPECT_TRUE(hexagon.warnings.empty());
}

TEST(ObjReader, ConcavePolygonsKeepTheirArea) {
    // An arrowhead: the polygon is concave at the corner (1, 1).
    const std::string arrow = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\n";
    for (const char* face : {"f 1 2 3 4\n", "f 2 3 4 1\n", "f 3 4 1 2\n",
                             "f 4 1 2 3\n", "f 4 3 2 1\n"})
        EXPECT_NEAR(area(parse(arrow + face)), 1, 1e-12) << face;
    // A comb with ten upright teeth, which cannot be triangulated as a single
    // fan.
    std::string comb, face = "f";
    for (int i = 0; i < 10; ++i)
        comb += "v " + std::to_string(i) + " 0 5\nv " + std::to_string(i) +
                ".5 0 1\n";
    comb += "v 10 0 5\nv 10 0 0\nv 0 0 0\n";
    for (int i = 1; i <= 23; ++i) face += ' ' + std::to_string(i);
    const ObjMesh obj = parse(comb + face + '\n');
    EXPECT_EQ(obj.mesh.faces.size(), 21u);
    EXPECT_NEAR(area(obj), 10 * 3, 1e-12);
    EXPECT_TRUE(obj.warnings.empty());
}

TEST(ObjReader, CrossingPolygonsAreCounted) {
    const ObjMesh bow_tie = parse(std::string(square) + "f 1 3 2 4\n");
    ASSERT_EQ(bow_tie.warnings.size(), 1u);
    EXPECT_NE(bow_tie.warnings[0].find("1 polygons cross"), std::string::npos);
    EXPECT_GT(area(bow_tie), 0.4);
}

TEST(ObjReader, GroupsNamedAsExportedStalksAreStalks) {
    struct Named {
        const char* name;
        std::uint32_t material, rank;
    };
    const Named groups[] = {
        {"stalk", 1, 0},           {"stalk_2", 1, 0},
        {"plant004_stalk", 1, 0},  {"plant12_stalk01", 1, 0},
        {"sheath", 2, 0},          {"leaf07", 0, 7},
        {"plant004_leaf07", 0, 7}, {"plant_stalk", 0, 0},
        {"plant004", 0, 0},        {"beanstalk", 0, 0},
        {"plant4stalk", 0, 0},     {"leaf12345", 0, 0}};
    for (const auto& [name, material, rank] : groups) {
        const ObjMesh obj =
            parse(square + std::string("g ") + name + "\nf 1 2 3 4\n");
        ASSERT_EQ(obj.mesh.groups.size(), 1u);
        const Group& group = obj.mesh.groups[0];
        EXPECT_EQ(group.material, material) << name;
        EXPECT_EQ(group.id.is_leaf(), material == 0) << name;
        EXPECT_EQ(group.id.rank, rank) << name;
    }
}

TEST(ObjReader, MillionFacesTakeLittleMemory) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer takes memory for each allocation";
#endif
    constexpr std::size_t faces = 1'000'000;
    std::string text = square;
    for (std::size_t i = 0; i < faces; ++i) text += "f 1 2 3\n";
    const auto most_kb = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return static_cast<double>(usage.ru_maxrss);
    };
    const double before = most_kb();
    EXPECT_EQ(parse_obj(std::move(text), "a.obj").mesh.faces.size(), faces);
    EXPECT_LT((most_kb() - before) * 1024 / faces, 100);
}

TEST(ObjReader, GroupAndObjectNamesGatherTheirFaces) {
    const ObjMesh obj = parse(std::string(square) +
                              "f 1 2 3\n"
                              "g leaf 1\nf 1 2 3\n"
                              "o stem\nf 2 3 4\nf 1 2 4\n"
                              "g leaf 1\nf 1 3 4\n"
                              "g no_face\ng\nf 1 2 3\n");
    ASSERT_EQ(obj.mesh.groups.size(), 3u);
    EXPECT_EQ(obj.mesh.groups[0].name, "unnamed");
    EXPECT_EQ(obj.mesh.groups[1].name, "leaf 1");
    EXPECT_EQ(obj.mesh.groups[2].name, "stem");
    EXPECT_EQ(obj.mesh.face_group,
              (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 0}));
}

TEST(ObjReader, UnusualButValidSyntaxIsAccepted) {
    // The text contains a byte order mark, CR LF, continued lines, forward,
    // backward and compound indices, colours, signs and exponents.
    const ObjMesh obj = parse(
        "\xEF\xBB\xBF# comment\r\n\r\nf 1/1/1 2//2 \\\r\n 3/3\r\n"
        "  v +0 0.0 1e0 .1 .2 .3\r\n\tv 1. 0 1\r\nv 1 1 1\r\nvn 0 0 1\r\n"
        "vt 0 0\r\nusemtl green\r\nmtllib none.mtl\r\ns off\r\n"
        "f -3 -2 -1");
    EXPECT_EQ(obj.mesh.vertices.size(), 3u);
    EXPECT_EQ(obj.mesh.faces.size(), 2u);
    EXPECT_DOUBLE_EQ(area(obj), 1);
    EXPECT_TRUE(obj.warnings.empty());
}

TEST(ObjReader, CoordinatesHaveDoublePrecision) {
    const ObjMesh obj =
        parse("v 10000.0000001 0 0\nv 10000.1 0 0\nv 10000 1 0\nf 1 2 3\n");
    EXPECT_NEAR(obj.mesh.vertices[0].x - 10000, 1e-7, 1e-11);
}

TEST(ObjReader, FacesWithoutAreaAreCountedAndLeftOut) {
    const ObjMesh obj = parse(std::string(square) +
                              "f 1 2 3\nf 1 1 2\nv .5 0 1\nf 1 2 5\n"
                              "f 2 2 2 2 2\n");
    EXPECT_EQ(obj.mesh.faces.size(), 1u);
    ASSERT_EQ(obj.warnings.size(), 1u);
    EXPECT_EQ(obj.warnings[0],
              "3 faces without area are left out (the first in line 6)");
}

TEST(ObjReader, UnknownStatementsAreCountedAndSkipped) {
    const ObjMesh obj =
        parse(std::string(square) + "f 1 2 3\nhello there\nfaces 3\n");
    ASSERT_EQ(obj.warnings.size(), 1u);
    EXPECT_EQ(obj.warnings[0],
              "2 lines are not understood and left out (the first in line 6)");
}

TEST(ObjReader, BrokenFilesAreErrorsWithTheirLocation) {
    const std::string v = square;
    EXPECT_EQ(parse_error(""),
              "a.obj: there are no faces (lines that begin with f); add some");
    EXPECT_EQ(parse_error(v),
              "a.obj: there are no faces (lines that begin with f); add some");
    EXPECT_EQ(parse_error(v + "f 1 1 1\n"),
              "a.obj: no face has an area (the corners of each are on a line); "
              "export the mesh again");
    EXPECT_EQ(parse_error("v 0 nan 0\n"),
              "a.obj:1:5: 'nan' is not a finite coordinate; correct it");
    EXPECT_EQ(parse_error("v 0 0 -inf\n"),
              "a.obj:1:7: '-inf' is not a finite coordinate; correct it");
    EXPECT_EQ(parse_error("v 1e999 0 0\n"),
              "a.obj:1:3: '1e999' is not a finite coordinate; correct it");
    EXPECT_EQ(parse_error("v 0 0 0\nv 1,5 0 0\n"),
              "a.obj:2:3: '1,5' is not a number; write coordinates with a "
              "decimal point");
    EXPECT_EQ(parse_error("v 0 +-1 0\n"),
              "a.obj:1:5: '+-1' is not a number; write coordinates with a "
              "decimal point");
    EXPECT_EQ(parse_error("v 0 0\n"),
              "a.obj:1:1: a vertex has fewer than three coordinates; give x, y "
              "and z");
    EXPECT_EQ(
        parse_error(v + "f 1 2\n"),
        "a.obj:5:1: a face has fewer than three corners; give three or more");
    EXPECT_EQ(
        parse_error(v + "f 1 2 a\n"),
        "a.obj:5:7: 'a' is not the number of a vertex; write a whole number");
    EXPECT_EQ(parse_error(v + "f 1 2 99999999999\n"),
              "a.obj:5:7: '99999999999' is not the number of a vertex; write a "
              "whole number");
    EXPECT_EQ(parse_error(v + "f 1 2 0\n"),
              "a.obj:5:1: a corner is vertex 0 (vertices are counted from 1); "
              "correct it");
    EXPECT_EQ(
        parse_error(v + "\nf 1 2 5\n"),
        "a.obj:6:1: a corner is vertex 5, but there are only 4; correct it");
    EXPECT_EQ(parse_error(v + "f 1 2 -5\n"),
              "a.obj:5:1: a corner lies before the first vertex; correct it");
    EXPECT_EQ(parse_error("v 2e6 0 0\n"),
              "a.obj:1:1: the coordinate 2e+06 is not within 1e+06 m of the "
              "origin (the unit is the metre); scale the mesh");
}

TEST(ObjReader, UnreadableFileIsAnError) {
    EXPECT_THROW(read_obj("/no/such/file.obj"), Error);
    try {
        read_obj("/");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "cannot read / (a folder, no regular file); name an OBJ "
                     "file");
    }
    EXPECT_THROW(read_obj("/dev/zero"), Error);
}

TEST(ObjReader, PolygonsOfManyCornersAreSplitOrRefusedQuickly) {
    // A star and a disc.
    const auto polygon = [](int corners, double inner) {
        std::string text, face = "f";
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * M_PI * i / corners;
            const double radius = i % 2 == 0 ? inner : 1;
            text += "v " + std::to_string(radius * std::cos(angle)) + ' ' +
                    std::to_string(radius * std::sin(angle)) + " 1\n";
            face += ' ' + std::to_string(i + 1);
        }
        return text + face + "\n";
    };
    EXPECT_EQ(parse_error(polygon(100'000, .9)),
              "a.obj:100001:1: a polygon of 100000 corners is too intricate "
              "to be split; give it as triangles");
    EXPECT_EQ(parse_obj(polygon(10'000, 1), "a.obj").mesh.faces.size(), 9998u);
}

}  // namespace
}  // namespace ideotype
