#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "ideotype/app/canopy.hpp"
#include "ideotype/app/provenance.hpp"
#include "ideotype/app/verbs.hpp"
#include "ideotype/light/device.hpp"
#include "sweep.hpp"

namespace ideotype {

namespace {

std::vector<Case> chosen_cases(const RunOptions& options,
                               const Campaign& campaign) {
    std::vector<Case> all = cases(campaign);
    if (!options.case_index) return all;
    const int index = *options.case_index;
    if (index < 0 || index >= static_cast<int>(all.size()))
        throw Error(fmt::format("there is no case {}; {} has cases 0 to {} "
                                "(see ideotype plan)",
                                index, options.campaign_path, all.size() - 1),
                    ExitCode::usage);
    return {all[static_cast<std::size_t>(index)]};
}

//! What rank 0 tells the others before the work begins.
struct Start {
    std::string isa;
    std::string resolved;
};

//! Finds the instruction set of the histories to be resumed, so that results
//! go on bit for bit, and refuses what would overwrite one.
Start prepare(const RunOptions& options, const Campaign& campaign) {
    Start start{Device::supported_isas().back(), campaign.resolved};
    bool is_pinned = false;
    for (const Case& chosen : chosen_cases(options, campaign)) {
        const std::string path = path_of(options.out, campaign, chosen);
        if (!history_exists(path)) continue;
        if (!options.is_resumed)
            throw Error(fmt::format("{}: exists already and a run never "
                                    "overwrites; add --resume to go on with "
                                    "it, or choose another folder with --out",
                                    path),
                        ExitCode::refused);
        const HistoryHeader header = History::read(path).header();
        require_same_campaign(header, campaign, chosen, path);
        const std::string& isa = header.text.at("isa");
        if (is_pinned && isa != start.isa)
            throw Error(fmt::format("{}: was begun with instruction set {}, "
                                    "other cases with {}; resume them one by "
                                    "one with --case",
                                    path, isa, start.isa),
                        ExitCode::refused);
        start.isa = isa;
        is_pinned = true;
    }
    return start;
}

//! Rank 0: evolves the cases, then lets the workers go.
void direct(const RunOptions& options, const Campaign& campaign,
            const std::string& isa, CanopyEvaluator& evaluator,
            const Session& session, StopFlag& stop) {
    const std::vector<Case> chosen = chosen_cases(options, campaign);
    const auto dispatcher = make_dispatcher(
        session, evaluator, stop,
        {campaign.answer_limits.deadline, campaign.answer_limits.attempts,
         final_effort(campaign)});
    std::optional<Error> failure;
    {
        Sweep sweep(options, campaign, chosen, isa, session.size(), stop);
        try {
            sweep.evolve(*dispatcher);
        } catch (const Error& error) {
            failure = error;
        }
    }
    // All histories are closed. A worker that hangs would keep MPI from ending.
    if (!dispatcher->dismiss()) {
        if (failure) fmt::print(stderr, "ideotype: {}\n", failure->what());
        session.abort(
            static_cast<int>(failure ? failure->exit_code() : ExitCode::ok));
    }
    if (failure) throw Error(*failure);
}

}  // namespace

ExitCode run(const RunOptions& options, const Session& session,
             StopFlag& stop) {
    if (options.wall_time) stop.request_after(*options.wall_time);
    std::optional<Campaign> campaign;
    Start start;
    // Rank 0 alone looks at files. An empty text tells the others to leave.
    std::exception_ptr failure;
    if (session.rank() == 0) try {
            campaign = read_campaign(options.campaign_path);
            start = prepare(options, *campaign);
        } catch (...) {
            failure = std::current_exception();
        }
    const std::string isa = session.broadcast(failure ? "" : start.isa);
    if (failure) std::rethrow_exception(failure);
    if (isa.empty()) return ExitCode::ok;
    const std::string resolved = session.broadcast(start.resolved);
    if (!campaign) campaign = parse_campaign(resolved, options.campaign_path);

    const auto supported = Device::supported_isas();
    const bool lacks_isa =
        std::find(supported.begin(), supported.end(), isa) == supported.end();
    if (session.largest(lacks_isa) != 0) {
        if (session.rank() == 0)
            throw Error(
                fmt::format("a processor of this job lacks instruction set "
                            "{}, which this history was begun with; resume it "
                            "where it is available",
                            isa),
                ExitCode::refused);
        return ExitCode::ok;
    }

    CanopyEvaluator evaluator(*campaign, isa);
    if (session.rank() != 0) {
        serve(session, evaluator);
        return ExitCode::ok;
    }
    direct(options, *campaign, isa, evaluator, session, stop);
    return ExitCode::ok;
}

}  // namespace ideotype
