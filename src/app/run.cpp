#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "ideotype/app/canopy.hpp"
#include "ideotype/app/evolve_case.hpp"
#include "ideotype/app/progress.hpp"
#include "ideotype/app/provenance.hpp"
#include "ideotype/app/summary.hpp"
#include "ideotype/app/verbs.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

std::string path_of(const RunOptions& options, const Campaign& campaign,
                    const Case& chosen) {
    return (fs::path(options.out) / campaign.name / (chosen.name + ".h5"))
        .string();
}

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
        const std::string path = path_of(options, campaign, chosen);
        if (!fs::exists(path)) continue;
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

//! Asks for a stop when this start has used up its time.
class Deadline : public ProgressLine {
  public:
    Deadline(const Campaign& campaign, const Case& chosen, StopFlag& stop,
             double end)
        : ProgressLine(campaign, chosen), stop_(stop), end_(end) {}

    void on_evaluation(std::uint32_t generation) override {
        ProgressLine::on_evaluation(generation);
        if (now() > end_) stop_.request();
    }

  private:
    StopFlag& stop_;
    double end_;
};

History open_history(const RunOptions& options, const Campaign& campaign,
                     const Case& chosen, const std::string& isa) {
    const std::string path = path_of(options, campaign, chosen);
    if (fs::exists(path)) return History::resume(path);
    const fs::path folder = fs::path(path).parent_path();
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure)
        throw Error(
            fmt::format("{}: cannot create this folder: {}; choose "
                        "another with --out",
                        folder.string(), failure.message()));
    return History::create(path, header_of(campaign, chosen, isa));
}

//! Rank 0: evolves the chosen cases one after the other.
void evolve_cases(const RunOptions& options, const Campaign& campaign,
                  const std::string& isa, Dispatcher& dispatcher,
                  const Session& session, StopFlag& stop) {
    const double started = now();
    const double end = options.wall_time
                           ? started + *options.wall_time
                           : std::numeric_limits<double>::infinity();
    for (const Case& chosen : chosen_cases(options, campaign)) {
        const std::string path = path_of(options, campaign, chosen);
        History history = open_history(options, campaign, chosen, isa);
        if (!history.finished()) {
            history.begin_session(
                session_record(options.command, session.size()));
            Deadline watcher(campaign, chosen, stop, end);
            const double began = now();
            const Evolution evolution{
                campaign, chosen,  dispatcher,
                stop,     watcher, [began] { return now() - began; }};
            if (evolve_case(evolution, history) == Ending::drained) {
                fmt::print("{}\nstopped before the end; go on with\n  {}{}\n",
                           path, options.command,
                           options.is_resumed ? "" : " --resume");
                return;
            }
        }
        fmt::print("{}", final_summary(history, campaign));
        fmt::print("history: {}\n", path);
    }
}

}  // namespace

ExitCode run(const RunOptions& options, const Session& session,
             StopFlag& stop) {
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
    const auto dispatcher = make_dispatcher(session, evaluator, stop);
    evolve_cases(options, *campaign, isa, *dispatcher, session, stop);
    return ExitCode::ok;
}

}  // namespace ideotype
