#include "ideotype/search/duplicates.hpp"

namespace ideotype {

std::map<std::uint32_t, std::uint32_t> duplicates(
    const std::vector<Candidate>& candidates) {
    std::map<Genome, std::uint32_t> first;
    std::map<std::uint32_t, std::uint32_t> earlier;
    for (std::uint32_t slot = 0; slot < candidates.size(); ++slot) {
        const auto [it, is_new] =
            first.try_emplace(candidates[slot].genome, slot);
        if (!is_new) earlier.emplace(slot, it->second);
    }
    return earlier;
}

}  // namespace ideotype
