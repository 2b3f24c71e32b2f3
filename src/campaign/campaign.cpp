#include "ideotype/campaign/campaign.hpp"

#include "checks.hpp"
#include "draft.hpp"
#include "ideotype/core/hash.hpp"
#include "reader.hpp"
#include "report.hpp"
#include "resolve.hpp"

namespace ideotype {

namespace {

Campaign complete(Draft& draft, const std::string& source) {
    Campaign campaign = draft.campaign;
    for (const LeafEntry& leaf : draft.leaves) {
        campaign.baseline.push_back(leaf.traits);
        campaign.plant.leaves.push_back(leaf.form);
        campaign.bounds.push_back(leaf_bounds(draft.bounds, leaf.traits));
    }
    campaign.source = source;
    campaign.resolved = resolved_text(draft);
    campaign.sha256 = sha256(campaign.resolved);
    return campaign;
}

Campaign parse(const std::string& text, const std::string& file,
               PlantSource source) {
    Draft draft;
    Report report;
    read_draft(text, file, source, draft, report);
    check_draft(draft, report);
    report.throw_if_any();
    return complete(draft, text);
}

}  // namespace

Campaign read_campaign(const std::string& path) {
    const std::optional<std::string> text = read_text(path);
    if (!text) throw Error("cannot read " + path);
    return parse(*text, path, PlantSource::file_or_table);
}

Campaign parse_campaign(const std::string& text, const std::string& file) {
    return parse(text, file, PlantSource::table);
}

}  // namespace ideotype
