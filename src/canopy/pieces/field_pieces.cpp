// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <utility>

#include "ideotype/canopy/pieces.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! The indices of a component's groups among the pieces of the field.
struct Share {
    std::uint32_t groups;    //!< first group in the uncut field
    std::uint32_t cut_from;  //!< first group among the meshes that were cut
    std::uint32_t pieces;    //!< first piece
    std::uint32_t first_plant;
    std::uint32_t others = 0;  //!< first uncut group, row by row
};

//! Returns the number of plants of each component, counted up to the last plant
//! that is not cut away.
std::vector<std::uint32_t> plants_of(const Field& field, std::size_t lines) {
    std::vector<std::uint32_t> plants(lines);
    for (std::size_t f = 0, c = 0; f < field.face_plant.size(); ++f) {
        while (c < lines && field.face_plant[f] >= field.first_plant[c + 1])
            ++c;
        if (c == lines) break;
        plants[c] = field.face_plant[f] - field.first_plant[c] + 1;
    }
    return plants;
}

//! Makes the groups of a field of pieces: first the pieces of leaves, plant by
//! plant, then the uncut surfaces, then fixed objects.
class FieldGroups {
  public:
    //! @param groups groups of the field
    FieldGroups(std::span<const Pieces> lines, const Field& field,
                const std::vector<Group>& groups, Pieces& result)
        : lines_(lines), field_(field), groups_(groups), result_(result) {
        result.rows = field.cell.row_ground.size();
        const std::vector<std::uint32_t> plants =
            plants_of(field, lines.size());
        std::size_t all = groups.size();
        for (std::size_t c = 0; c < lines.size(); ++c)
            all += plants[c] * lines[c].count;
        result.mesh.groups.reserve(all);
        result.group.reserve(all);
        result.like.reserve(all);
        for (std::size_t c = 0; c < lines.size(); ++c) add_pieces(c, plants[c]);
        result.count = result.mesh.groups.size();
        for (std::size_t c = 0; c < lines.size(); ++c) add_others(c);
        all_ = next();
        for (std::size_t g = first_; g < groups.size(); ++g)
            add(groups[g], cut_from_++, 0);
    }

    //! Returns the new group of a face, possibly a piece.
    //! @param group old group of the face
    std::uint32_t group_of(std::uint32_t group, std::uint32_t plant) const {
        if (group >= first_) return group + all_ - first_;
        const std::size_t c = component_of(group);
        const auto count = static_cast<std::uint32_t>(lines_[c].count);
        const std::uint32_t of_line = group - shares_[c].groups;
        if (of_line < count)
            return shares_[c].pieces + of_line +
                   count * (plant - shares_[c].first_plant);
        const auto others =
            static_cast<std::uint32_t>(lines_[c].group.size()) - count;
        const std::uint32_t row = row_of(plant);
        return shares_[c].others + row * others + of_line - count;
    }

    //! Returns the height of the piece to which a face belongs.
    double height_of(std::uint32_t group) const {
        const std::size_t c = component_of(group);
        return lines_[c].height[group - shares_[c].groups];
    }

  private:
    std::uint32_t next() const {
        return static_cast<std::uint32_t>(result_.mesh.groups.size());
    }

    std::uint32_t row_of(std::size_t plant) const {
        return result_.rows > 0 ? field_.plant_row[plant] : 0;
    }

    std::size_t component_of(std::uint32_t group) const {
        std::size_t c = shares_.size() - 1;
        while (group < shares_[c].groups) --c;
        return c;
    }

    void add(const Group& group, std::uint32_t cut_from, std::uint32_t row) {
        result_.mesh.groups.push_back(group);
        result_.group.push_back(cut_from);
        if (result_.rows > 0) result_.row.push_back(row);
    }

    void add_pieces(std::size_t c, std::uint32_t plants) {
        const Pieces& line = lines_[c];
        shares_.push_back({first_, cut_from_, next(), field_.first_plant[c]});
        std::uint32_t like = next();
        for (std::uint32_t p = 0; p < plants; ++p) {
            const std::size_t plant = field_.first_plant[c] + p;
            const std::uint32_t row = row_of(plant);
            if (result_.rows > 0 && p > 0 && row != row_of(plant - 1))
                like = next();
            for (std::uint32_t v = 0; v < line.count; ++v) {
                add(groups_[first_ + v], cut_from_ + line.group[v], row);
                result_.like.push_back(like + v);
                if (!line.width.empty()) result_.width.push_back(line.width[v]);
            }
        }
        first_ += static_cast<std::uint32_t>(line.group.size());
        cut_from_ += static_cast<std::uint32_t>(line.uncut_groups);
    }

    //! Adds the uncut groups of a component, once per row of the field if rows
    //! are distinguished.
    void add_others(std::size_t c) {
        const Pieces& line = lines_[c];
        shares_[c].others = next();
        for (std::uint32_t row = 0; row == 0 || row < result_.rows; ++row)
            for (std::size_t g = line.count; g < line.group.size(); ++g)
                add(groups_[shares_[c].groups + g],
                    shares_[c].cut_from + line.group[g], row);
    }

    std::span<const Pieces> lines_;
    const Field& field_;
    const std::vector<Group>& groups_;
    Pieces& result_;
    std::vector<Share> shares_;
    std::uint32_t first_ = 0;  //!< first group after all components so far
    std::uint32_t cut_from_ = 0;
    std::uint32_t all_ = 0;  //!< number of groups except objects
};

}  // namespace

Pieces pieces_of_field(std::span<const Pieces> lines, Field& field) {
    IDEOTYPE_EXPECT(field.first_plant.size() == lines.size() + 1);
    IDEOTYPE_EXPECT(field.face_plant.size() == field.mesh.faces.size());
    const std::vector<double> areas = face_areas(field.mesh);
    const std::vector<Group> groups = std::move(field.mesh.groups);
    Pieces result;
    result.mesh = std::move(field.mesh);
    result.mesh.groups.clear();
    const FieldGroups all(lines, field, groups, result);
    result.area.resize(result.count);
    result.height.resize(result.count);
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        std::uint32_t& group = result.mesh.face_group[f];
        const std::uint32_t was = group;
        group = all.group_of(was, field.face_plant[f]);
        IDEOTYPE_ENSURE(group < result.mesh.groups.size());
        if (group >= result.count) continue;
        result.height[group] = all.height_of(was);
        result.area[group] += areas[f];
    }
    return result;
}

}  // namespace ideotype
