// SPDX-License-Identifier: Apache-2.0
#include "provenance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"
#include "ideotype/core/version.hpp"
#include "ideotype/light/device.hpp"
#include "parallel/session.hpp"
#include "progress.hpp"
#include "run/job/machines.hpp"
#include "spec/reader.hpp"
#include "stand/stand.hpp"

namespace ideotype {

HistoryHeader header_of(const Campaign& campaign, const Case& chosen,
                        const std::string& isa) {
    const BuildInfo& build = build_info();
    HistoryHeader header;
    header.text = {
        {"program", "ideotype"},
        {"git_sha", build.git_sha},
        {"git_dirty", build.git_dirty},
        {"build_type", build.build_type},
        {"hdf5_version", History::library_version()},
        {"mpi_version", Session::library_version()},
        {"isa", isa},
        {"campaign", campaign.spec.name},
        {"campaign_sha256", campaign.sha256},
        {"case", chosen.name},
        {"site", chosen.site_name},
        {"day", chosen.day_name},
        {"spacing", chosen.spacing_name},
        {"trait_set", chosen.trait_set_name},
        {"created", utc_now()},
    };
    header.text.merge(program_facts());
    header.numbers = {
        {"latitude", chosen.site.latitude},
        {"longitude", chosen.site.longitude},
        {"row_spacing", chosen.spacing.row},
        {"plant_spacing", chosen.spacing.plant},
        {"replicate", chosen.replicate},
    };
    header.campaign_source = campaign.source;
    header.campaign_resolved = campaign.resolved;
    header.genes = search_genes(campaign, chosen);
    header.schema = search_schema(campaign, chosen, campaign.sampling);
    header.final_randomisations =
        static_cast<std::size_t>(campaign.final_rule.sampling.randomisations);
    header.seed = chosen.seed;
    header.population = campaign.search.population;
    header.generations = campaign.stop.generations;
    header.finalists = campaign.final_rule.candidates + 1;
    return header;
}

void require_same_campaign(const HistoryHeader& header,
                           const Campaign& campaign, const Case& chosen,
                           const std::string& path) {
    const auto changed = differences(read_resolved(header.campaign_resolved),
                                     campaign.spec, chosen);
    if (!changed.empty())
        throw Error(
            fmt::format(
                "{}: the campaign has changed since this history was begun:\n  "
                "{}\nUndo the changes, or write to another folder with --out",
                path, fmt::join(changed, "\n  ")),
            ExitCode::refused);
    if (header.text.at("case") != chosen.name || header.seed != chosen.seed)
        throw Error(fmt::format("{}: this is the history of case {}, not {}",
                                path, header.text.at("case"), chosen.name),
                    ExitCode::refused);
}

namespace {

// Refuses a history that another program wrote. Properties that an older
// history does not contain are not compared.
void require_same_program(const HistoryHeader& header,
                          const std::string& path) {
    std::vector<std::string> changed;
    for (const auto& [name, value] : program_facts()) {
        const auto was = header.text.find(name);
        if (was != header.text.end() && was->second != value)
            changed.push_back(
                fmt::format("{} was {}, is {}", name, was->second, value));
    }
    if (!changed.empty())
        throw Error(
            fmt::format(
                "{}: this program would not continue this history with the "
                "same bits as the one that began it:\n  {}\nResume it with the "
                "original program, or write to another folder with --out",
                path, fmt::join(changed, "\n  ")),
            ExitCode::refused);
}

}  // namespace

void require_resumable(const HistoryHeader& header, const Campaign& campaign,
                       const Case& chosen, const std::string& path) {
    require_same_campaign(header, campaign, chosen, path);
    require_same_program(header, path);
}

SessionRecord session_record(const std::string& command, int ranks) {
    const BuildInfo& build = build_info();
    return {
        utc_now(),
        host_name(),
        command,
        ranks,
        fmt::format("ideotype {}", build.version),
        build.compiler,
        fmt::format("{}; {}; {}", Device::library_version(),
                    History::library_version(), Session::library_version())};
}

std::string version_text() {
    const BuildInfo& build = build_info();
    return fmt::format(
        "ideotype {}\n"
        "commit   {} (changed: {})\n"
        "compiler {} ({})\n"
        "{}\n{}\n{}\n"
        "maths    {} (of the C library, see docs/contract.md)\n"
        "instruction sets of this processor: {}",
        build.version, build.git_sha, build.git_dirty, build.compiler,
        build.build_type, Device::library_version(), History::library_version(),
        Session::library_version(), maths_fingerprint(),
        fmt::join(Device::supported_isas(), ", "));
}

}  // namespace ideotype
