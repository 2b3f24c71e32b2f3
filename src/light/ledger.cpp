#include "ledger.hpp"

namespace ideotype {

Ledger::Ledger(const Counted& counted, std::uint32_t source, bool is_beam,
               Tally& tally)
    : counted_(counted), tally_(tally), budget_(tally.sources[source]) {
    if (tally.leaf_light.empty()) return;
    leaf_light_ = &tally.leaf_light[source];
    leaf_light_->diffuse.resize(counted.groups.size());
    if (is_beam) beam_.resize(counted.scene.surfaces().normals.size());
}

void Ledger::arrive(const FirstHit& hit, double sent_on) {
    Budget& part = next();
    part.incident += hit.energy;
    part.sent_on += sent_on;
    keep(hit.group, hit.height, hit.is_adaxial, hit.energy - sent_on,
         hit.is_direct ? &hit : nullptr);
}

void Ledger::keep(const Hit& hit, bool is_adaxial, double energy) {
    next();
    keep(hit.group, hit.position.z, is_adaxial, energy, nullptr);
}

const Budget& Ledger::close() {
    budget_ += part_;
    part_ = {};
    for (std::uint32_t t = 0; t < beam_.size(); ++t)
        if (beam_[t] > 0) leaf_light_->beam.push_back({t, beam_[t]});
    beam_.clear();
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
    tally_.groups[group] += energy;
    if (counted_.groups[group].tissue != Tissue::leaf) {
        part_.stalks += energy;
        return;
    }
    part_.leaves += energy;
    if (direct) part_.unscattered += energy;
    tally_.layers[counted_.layers.at(height)] += energy;
    (is_adaxial ? tally_.adaxial : tally_.abaxial) += energy;
    if (!leaf_light_) return;
    if (direct && !beam_.empty())
        beam_[direct->triangle] += energy;
    else
        leaf_light_->diffuse[group] += energy;
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
