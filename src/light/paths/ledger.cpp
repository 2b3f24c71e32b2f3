// SPDX-License-Identifier: Apache-2.0
#include "ledger.hpp"

#include <algorithm>
#include <utility>

#include "ideotype/core/contract.hpp"

namespace ideotype {

void SparseSums::drain(std::vector<LeafLight::Part>& parts) {
    parts.reserve(parts.size() + places_.size());
    for (const std::uint32_t place : places_)
        parts.push_back({place, std::exchange(sums_[place], 0.)});
    places_.clear();
}

PartNumbers::PartNumbers(const std::vector<Group>& groups) {
    std::uint32_t all = 0;
    for (const Group& group : groups) {
        const SurfaceId& id = group.id;
        all = std::max(all, id.component + 1);
        if (!id.is_object())
            components = std::max(components, id.component + 1);
    }
    objects = all - components;
}

Ledger::Ledger(const Counted& counted, std::uint32_t source, bool is_beam,
               Tally& tally, LeafSums& leaf_sums)
    : counted_(counted), tally_(tally), budget_(tally.sources[source]) {
    IDEOTYPE_EXPECT(tally.groups.size() == counted.groups.size());
    IDEOTYPE_EXPECT(counted.pieces <= counted.groups.size());
    if (counted.parts.count() > 0) parts_ = &tally.parts[source];
    if (tally.leaf_light.empty()) return;
    leaf_light_ = &tally.leaf_light[source];
    leaf_sums.diffuse.resize(tally.sources.size());
    diffuse_ = &leaf_sums.diffuse[source];
    diffuse_->resize(counted.pieces);
    if (!is_beam) return;
    beam_ = &leaf_sums.beam;
    beam_->resize(counted.scene.surfaces().normals.size());
}

void Ledger::arrive(const FirstHit& hit, double energy, double sent_on) {
    IDEOTYPE_EXPECT(sent_on >= 0 && sent_on <= energy * (1 + 1e-12));
    Budget& part = next();
    part.incident += energy;
    part.sent_on += sent_on;
    keep(hit.group, hit.height, hit.is_adaxial, energy - sent_on,
         hit.is_direct ? &hit : nullptr);
}

void Ledger::keep(const Hit& hit, bool is_adaxial, double energy) {
    next();
    keep(hit.group, hit.position.z, is_adaxial, energy, nullptr);
}

const Budget& Ledger::close() {
    budget_ += part_;
    part_ = {};
    if (leaf_light_) diffuse_->drain(leaf_light_->diffuse);
    if (beam_) beam_->drain(leaf_light_->beam);
    return budget_;
}

void Ledger::keep(std::uint32_t group, double height, bool is_adaxial,
                  double energy, const FirstHit* direct) {
    if (group == Hit::sky) {
        part_.reflected += energy;
        return;
    }
    if (group == Hit::soil) {
        part_.soil += energy;
        return;
    }
    IDEOTYPE_EXPECT(group < counted_.groups.size());
    tally_.groups[group] += energy;
    const SurfaceId& id = counted_.groups[group].id;
    if (!id.is_leaf()) {
        if (!id.is_object()) {
            part_.organs += energy;
            keep_of_piece(group, energy, direct);
            return;
        }
        part_.objects += energy;
        (*parts_)[counted_.parts.side(id, is_adaxial)] += energy;
        return;
    }
    part_.leaves += energy;
    if (counted_.parts.components > 1)
        (*parts_)[counted_.parts.leaves(id)] += energy;
    if (direct) part_.unscattered += energy;
    tally_.layers[counted_.layers.at(height)] += energy;
    (is_adaxial ? tally_.adaxial : tally_.abaxial) += energy;
    keep_of_piece(group, energy, direct);
}

void Ledger::keep_of_piece(std::uint32_t group, double energy,
                           const FirstHit* direct) {
    if (!leaf_light_ || group >= counted_.pieces) return;
    if (direct && beam_)
        beam_->add(direct->triangle, energy);
    else
        diffuse_->add(group, energy);
}

Budget& Ledger::next() {
    constexpr int step = 256;
    if (++count_ % step == 0) {
        budget_ += part_;
        part_ = {};
    }
    return part_;
}

}  // namespace ideotype
