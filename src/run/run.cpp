// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include <deque>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "evaluator.hpp"
#include "provenance.hpp"
#include "run/job/disk.hpp"
#include "run/job/machines.hpp"
#include "run/job/masters.hpp"
#include "run/job/way_on.hpp"
#include "summary.hpp"
#include "sweep.hpp"

namespace ideotype {

namespace fs = std::filesystem;

namespace {

Cases chosen_cases(const RunOptions& options, const Campaign& campaign) {
    const Cases campaign_cases = cases(campaign);
    return options.case_index
               ? campaign_cases.only(*options.case_index, options.campaign_path)
               : campaign_cases;
}

//! Returns whether the histories of all cases exist and are finished.
bool are_finished(const RunOptions& options, const Campaign& campaign,
                  const Cases& chosen) {
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const std::string path = path_of(options.out, campaign, chosen.name(i));
        if (!history_exists(path) || !History::is_finished(path)) return false;
    }
    return true;
}

//! Returns the instruction set of the histories to resume, or nothing if there
//! are none. With the same instruction set, results stay bit-identical. Refuses
//! to overwrite a history. If all cases are finished, only a change of the
//! campaign is refused: no result can change any more.
std::optional<std::string> isa_of_histories(const RunOptions& options,
                                            const Campaign& campaign,
                                            const Cases& chosen) {
    std::optional<std::string> common;
    const bool has_work = !are_finished(options, campaign, chosen);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const std::string path = path_of(options.out, campaign, chosen.name(i));
        if (!history_exists(path)) continue;
        if (!options.is_resumed)
            throw Error(fmt::format("{}: this history exists already and is "
                                    "not overwritten; add --resume to continue "
                                    "it, or choose another folder with --out",
                                    path),
                        ExitCode::refused);
        const HistoryHeader header = History::header_of(path);
        if (!has_work) {
            require_same_campaign(header, campaign, chosen[i], path);
            continue;
        }
        require_resumable(header, campaign, chosen[i], path);
        const std::string& isa = header.text.at("isa");
        if (options.isa && isa != *options.isa)
            throw Error(
                fmt::format("{}: this history was begun with instruction set "
                            "{}, not {}; leave --isa out",
                            path, isa, *options.isa),
                ExitCode::refused);
        if (common && isa != *common)
            throw Error(
                fmt::format(
                    "{}: this history was begun with instruction set {}, other "
                    "cases with {}; resume them one at a time with --case",
                    path, isa, *common),
                ExitCode::refused);
        common = isa;
    }
    return common;
}

//! Makes all checks that may lead to a refusal of the job, before any work.
Start prepare(const RunOptions& options, const Campaign& campaign,
              const std::vector<Machine>& machines) {
    const Cases chosen = chosen_cases(options, campaign);
    require_names_fit(campaign, chosen, options.out);
    require_same_program(machines);
    const auto begun_with = isa_of_histories(options, campaign, chosen);
    const std::string isa =
        begun_with ? choose_isa(machines, begun_with,
                                "this history was begun with it; resume it "
                                "where all ranks support it")
                   : choose_isa(machines, options.isa,
                                "choose with --isa one that all ranks support");
    return {isa, campaign.resolved};
}

//! The ranks and the cases of one master.
struct Crew {
    const Session& job;
    const Session& own;      //!< session of the master and its workers
    const Session& masters;  //!< session of all masters
    Cases cases;
};

//! Evolves the cases of a master, then dismisses its workers.
ExitCode direct(const RunOptions& options, const Campaign& campaign,
                const std::string& isa, const Evaluators& evaluators,
                const Crew& crew, StopFlag& stop) {
    const auto dispatcher =
        make_dispatcher(crew.own, evaluators, stop, answer_rules(campaign));
    std::optional<Error> failure;
    ExitCode code = ExitCode::ok;
    BoundCount bounds;
    {
        Sweep sweep(options, campaign, crew.cases, isa, crew.job.size(), stop);
        try {
            if (!sweep.evolve(*dispatcher)) code = ExitCode::stopped;
        } catch (const Error& error) {
            failure = error;
            code = error.exit_code();
        }
        bounds = sweep.bounds();
    }
    // A hanging worker would block the end of MPI, but other masters may still
    // be evolving cases. Therefore abort the job only after all masters have
    // finished.
    const bool all_answer = dispatcher->dismiss();
    crew.masters.largest(0);
    const auto counts = crew.masters.gather(to_text(bounds));
    if (!all_answer) {
        if (failure) Log(options.level).write(LogLevel::error, failure->what());
        crew.job.abort(static_cast<int>(code));
    }
    if (failure) throw Error(*failure);
    // Rank 0 prints the notes on all searches and the next command to use.
    if (code == ExitCode::ok && crew.job.rank() == 0 &&
        options.level >= LogLevel::info) {
        const std::string path =
            path_of(options.out, campaign, crew.cases.name(0));
        const std::string folder = fs::path(path).parent_path().string();
        const bool is_study = options.read == read_study;
        BoundCount every;
        for (const std::string& text : counts) every.add(bound_count_of(text));
        if (const std::string words = every.in_words(); !words.empty())
            fmt::print("{}\n", words);
        if (!is_study)
            fmt::print(
                "{}\n",
                campaign.spec.replicates == 1
                    ? one_seed
                    : fmt::format("± is half of a 95 % confidence interval of "
                                  "light noise only; {} adds the differences "
                                  "between searches",
                                  quoted({"ideotype", "summary", folder})));
        fmt::print("next: {}\n", is_study
                                     ? quoted({"ideotype", "indices", path})
                                     : quoted({"ideotype", "report", folder,
                                               "-o", folder + "/report"}));
    }
    return code;
}

Genome best_of_history(const GeneSpace& genes, Genome start,
                       const std::string& path) {
    const History history = History::read(path);
    const HistoryHeader& header = history.header();
    const std::vector<Row> finalists = history.finalists();
    const std::size_t best = best_finalist(history, finalists);
    if (best == 0)
        throw Error(path +
                    ": this history has no re-evaluated plant; let its run "
                    "finish, or start from a plant file");
    const Genome& best_genome = finalists[best].candidate.genome;
    for (std::size_t i = 0; i < genes.size(); ++i)
        for (std::size_t j = 0; j < header.genes.size(); ++j)
            if (header.genes[j].name == genes[i].name)
                start[i] = best_genome[j];
    return start;
}

//! Returns the setting "search.start=[...]" for a plant, from the measures of a
//! crop file or from the genes of a history's best finalist. Missing genes are
//! taken from the baseline.
//! @throws Error if the file cannot be read or contains no finalist.
//! @throws InputError with all problems of a crop file.
std::string start_setting(const Campaign& campaign, const std::string& path) {
    Genome start = baseline_genome(campaign);
    if (std::filesystem::path(path).extension() == ".h5") {
        const GeneSpace genes = gene_space(campaign, cases(campaign).front());
        start = best_of_history(genes, std::move(start), path);
    } else {
        Crop crop = campaign.crop;
        crop.baseline = read_crop(path).baseline;
        if (crop.baseline.leaves.size() != campaign.crop.baseline.leaves.size())
            throw Error(
                fmt::format("{}: this plant has {} leaves (the campaign's "
                            "baseline has {}); start from another plant",
                            path, crop.baseline.leaves.size(),
                            campaign.crop.baseline.leaves.size()));
        std::ranges::copy(baseline_numbers(crop), start.begin());
    }
    return fmt::format("search.start=[{}]", fmt::join(start, ", "));
}

Campaign read_with_start(const RunOptions& options) {
    std::vector<std::string> settings = options.settings;
    const std::string& path = options.campaign_path;
    if (!options.start.empty())
        settings.push_back(
            start_setting(options.read(path, settings), options.start));
    Campaign campaign = options.read(path, settings);
    require_breedable(campaign);
    return campaign;
}

}  // namespace

void print_warnings(const Campaign& campaign, const Log& log) {
    for (const Problem& warning : campaign.warnings)
        log.write(LogLevel::warning, to_string(warning));
}

Start agree(const Session& session, const std::function<Start()>& make) {
    Start start;
    std::exception_ptr failure;
    if (session.rank() == 0) try {
            start = make();
        } catch (...) {
            failure = std::current_exception();
        }
    // Other ranks end if they receive an empty text.
    start.isa = session.broadcast(start.isa);
    if (failure) std::rethrow_exception(failure);
    if (!start.isa.empty()) start.resolved = session.broadcast(start.resolved);
    return start;
}

AnswerRules answer_rules(const Campaign& campaign) {
    return {campaign.spec.parallel.deadline, final_effort(campaign)};
}

ExitCode run(const RunOptions& options, const Session& session, StopFlag& stop,
             const Machine& machine) {
    // Collect the machines of all ranks; agree on the campaign and the
    // instruction set.
    if (options.wall_time) stop.request_after(*options.wall_time);
    const std::vector<Machine> machines = gather_machines(session, machine);
    const int threads = threads_per_rank(session, options.threads);
    std::optional<Campaign> campaign;
    // Only rank 0 reads files.
    const auto [isa, resolved] = agree(session, [&] {
        campaign = read_with_start(options);
        print_warnings(*campaign, Log(options.level));
        return prepare(options, *campaign, machines);
    });
    if (isa.empty()) return ExitCode::ok;
    if (!campaign) campaign = parse_campaign(resolved, options.campaign_path);

    // Divide ranks and cases among masters.
    std::deque<CanopyEvaluator> own_evaluators;
    Evaluators evaluators;
    for (int i = 0; i < threads; ++i)
        evaluators.push_back(&own_evaluators.emplace_back(*campaign, isa));
    const Cases chosen = chosen_cases(options, *campaign);
    const auto count = static_cast<int>(chosen.size());
    const int parts = masters(options.masters, session.size(), count);
    const int part = part_of(session.rank(), session.size(), count, parts);
    const Session crew = session.split(part);
    const bool is_master = crew.rank() == 0;
    const Session peers = session.split(is_master ? 0 : 1);
    if (is_master) {
        const auto [first, size] = dealt(count, part, parts);
        return direct(options, *campaign, isa, evaluators,
                      {session, crew, peers, chosen.part(first, size)}, stop);
    }
    serve(crew, evaluators);
    return ExitCode::ok;
}

}  // namespace ideotype
