#include "ideotype/campaign/campaign.hpp"

#include <utility>

#include "checks.hpp"
#include "draft.hpp"
#include "ideotype/core/hash.hpp"
#include "reader.hpp"
#include "report.hpp"
#include "resolve.hpp"

namespace ideotype {

namespace {

//! The leaves of a draft.
KnownPlant known_plant(const Draft& draft) {
    KnownPlant plant{draft.campaign.plant, {}};
    for (const LeafEntry& leaf : draft.leaves) {
        plant.traits.push_back(leaf.traits);
        plant.form.leaves.push_back(leaf.form);
    }
    return plant;
}

Campaign complete(Draft& draft, const std::string& source,
                  const Report& report) {
    Campaign campaign = draft.campaign;
    KnownPlant plant = known_plant(draft);
    campaign.plant = std::move(plant.form);
    campaign.baseline = std::move(plant.traits);
    for (const LeafTraits& traits : campaign.baseline)
        campaign.bounds.push_back(leaf_bounds(draft.bounds, traits));
    campaign.source = source;
    campaign.warnings = report.warnings();
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
    return complete(draft, text, report);
}

}  // namespace

Campaign read_campaign(const std::string& path) {
    const std::optional<std::string> text = read_text(path);
    if (!text) throw Error("cannot read " + path);
    return parse(*text, path, PlantSource::file_or_table);
}

KnownPlant read_plant(const std::string& path) {
    const std::optional<std::string> text = read_text(path);
    if (!text) throw Error("cannot read " + path);
    Draft draft;
    Report report;
    if (!read_plant_draft(*text, path, draft, report)) {
        const Campaign campaign =
            parse(*text, path, PlantSource::file_or_table);
        return {campaign.plant, campaign.baseline};
    }
    check_plant(draft, report);
    report.throw_if_any();
    return known_plant(draft);
}

std::string plant_text(const KnownPlant& plant) {
    Draft draft;
    draft.campaign.plant = plant.form;
    for (std::size_t i = 0; i < plant.traits.size(); ++i)
        draft.leaves.push_back({plant.traits[i], plant.form.leaves.at(i)});
    return resolved_plant_text(draft);
}

Campaign parse_campaign(const std::string& text, const std::string& file) {
    return parse(text, file, PlantSource::table);
}

}  // namespace ideotype
