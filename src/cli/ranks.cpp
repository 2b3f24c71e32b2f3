// SPDX-License-Identifier: Apache-2.0
#include "ranks.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "ideotype/core/host.hpp"
#include "run/job/way_on.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

int number_in(const char* text, int otherwise) {
    return text != nullptr ? std::atoi(text) : otherwise;
}

//! The environment variables in which launchers state the rank and the number
//! of ranks. PMIx does not state the number; under srun, SLURM does.
struct Variables {
    const char *rank, *size;
};
constexpr std::array<Variables, 3> variables{{
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
    {"PMI_RANK", "PMI_SIZE"},
    {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"},
}};

//! Refuses a job in which MPI connects fewer ranks than were started. This
//! happens under the launcher of another MPI library, where each rank would do
//! all the work.
void require_all_ranks(int connected, int started) {
    if (connected >= started) return;
    throw wrong_usage(
        "{} ranks were started but cannot find each other: the launcher does "
        "not match {}, with which this program was built; use the mpirun of "
        "that library, or srun with another --mpi (srun --mpi=list)",
        started, Session::library_version());
}

std::string name_of_process(const std::string& process) {
    std::string name;
    std::getline(std::ifstream(process + "/comm"), name);
    return name;
}

}  // namespace

int parse_threads(const std::string& text) {
    const int automatic = available_cores();
    if (text == "auto") return automatic;
    int threads = 0;
    const char* end = text.data() + text.size();
    const auto [rest, failure] = std::from_chars(text.data(), end, threads);
    if (failure != std::errc() || rest != end || threads < 1 ||
        threads > most_threads)
        throw wrong_usage(
            "--threads: '{}' is not a number of threads; give 1 to {}, or auto "
            "({} here)",
            text, most_threads, automatic);
    return threads;
}

std::optional<std::string> process_of_mpirun() {
    std::string process = fmt::format("/proc/{}", getppid());
    if (name_of_process(process) == "hydra_pmi_proxy") {
        // The file begins with "PID (NAME) STATE PARENT ...".
        std::ifstream stat(process + "/stat");
        std::string word;
        for (int i = 0; i < 4; ++i) stat >> word;
        process = "/proc/" + word;
    }
    const std::string name = name_of_process(process);
    for (const char* each : {"mpirun", "mpiexec", "orterun", "prterun"})
        if (name.starts_with(each)) return process;
    return std::nullopt;
}

std::string launcher_of(const std::string& program) {
    if (!launch_of_this_process().is_launched) return "";
    const std::optional<std::string> mpirun = process_of_mpirun();
    if (!mpirun) return "";
    std::ifstream file(*mpirun + "/cmdline");
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) {
        if (word == program) return quoted(words);
        words.push_back(word);
    }
    return "";
}

Launch launch_of_this_process() {
    for (const Variables& names : variables)
        if (const char* rank = std::getenv(names.rank))
            return {true, number_in(rank, 0),
                    number_in(std::getenv(names.size), 1)};
    return {};
}

Session start_session() {
    const Launch launch = launch_of_this_process();
    if (!launch.is_launched) return Session::alone();
    Session session;
    require_all_ranks(session.size(), launch.size);
    return session;
}

ExitCode on_ranks(const Session& session, const Log& log,
                  const std::function<ExitCode()>& action) {
    try {
        return action();
    } catch (const std::exception& error) {
        const ExitCode code = report_error(error, log);
        const bool is_told = dynamic_cast<const Error*>(&error) != nullptr;
        if (session.rank() != 0 || (session.size() > 1 && !is_told))
            session.abort(static_cast<int>(code));
        return code;
    }
}

ExitCode share_work(const Session& session, const Evaluators& evaluators,
                    const StopFlag& stop, const AnswerRules& rules,
                    const std::function<ExitCode(Dispatcher&)>& direct) {
    if (session.rank() != 0) {
        serve(session, evaluators);
        return ExitCode::ok;
    }
    const auto dispatcher = make_dispatcher(session, evaluators, stop, rules);
    ExitCode code = ExitCode::ok;
    std::exception_ptr failure;
    try {
        code = direct(*dispatcher);
    } catch (...) {
        failure = std::current_exception();
    }
    // A hanging worker would block the end of the program.
    const bool all_answer = dispatcher->dismiss();
    try {
        if (failure) std::rethrow_exception(failure);
    } catch (const std::exception& error) {
        if (all_answer) throw;
        code = report_error(error);
    }
    if (!all_answer) session.abort(static_cast<int>(code));
    return code;
}

ExitCode start_run(const RunOptions& options) {
    StopFlag stop;
    const Session session = start_session();
    return on_ranks(session, Log(options.level),
                    [&] { return run(options, session, stop); });
}

}  // namespace ideotype
