// SPDX-License-Identifier: Apache-2.0
#include "launch.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sstream>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include "ideotype/core/error.hpp"
#include "ideotype/parallel/session.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! Its value is the path of the pipe of a LastWord.
constexpr const char* own_mark = "IDEOTYPE_LAUNCHED";

//! What root and few cores need, for Open MPI 4 and for the PRRTE of Open MPI
//! 5; MPICH needs nothing. What the user has set stays.
struct Variable {
    const char *name, *value;
};
constexpr std::array<Variable, 11> environment{{
    {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
    {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
    {"PRTE_ALLOW_RUN_AS_ROOT", "1"},
    {"PRTE_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
    {"OMPI_MCA_rmaps_base_oversubscribe", "1"},
    {"PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe"},
    {"OMPI_MCA_hwloc_base_binding_policy", "none"},
    {"PRTE_MCA_hwloc_default_binding_policy", "none"},
    {"OMPI_MCA_mpi_yield_when_idle", "1"},
    // All ranks are on this machine, which may have no network.
    {"OMPI_MCA_btl_tcp_if_include", "lo"},
    // Errors and exit codes are told by rank 0 and by watch().
    {"OMPI_MCA_orte_execute_quiet", "1"},
}};

bool is_program(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none) && access(path.c_str(), X_OK) == 0;
}

//! The launcher of the build, or else the one of that name on the PATH.
std::string find_launcher() {
    const fs::path built(IDEOTYPE_MPIEXEC);
    if (is_program(built)) return built.string();
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (const fs::path found = fs::path(folder) / built.filename();
            is_program(found))
            return found.string();
    throw Error(
        fmt::format("--ranks: there is no MPI launcher (neither {} nor "
                    "{} on the PATH); install Open MPI, or start "
                    "without --ranks",
                    IDEOTYPE_MPIEXEC, built.filename().string()));
}

sigset_t heard_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int each : {SIGINT, SIGTERM, SIGUSR1, SIGCHLD})
        sigaddset(&signals, each);
    return signals;
}

[[noreturn]] void become(char* const* words) {
    // Ctrl-C shall reach only the process that watches; should that be killed,
    // the ranks end too.
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int nothing = open("/dev/null", O_RDONLY);
    if (nothing >= 0) dup2(nothing, STDIN_FILENO);
    const sigset_t signals = heard_signals();
    sigprocmask(SIG_UNBLOCK, &signals, nullptr);
    execv(words[0], words);
    _exit(127);
}

//! Hears what rank 0 ends with: the launcher of MPICH 4.0 at times ends with 0
//! after it has passed a signal on.
class LastWord {
  public:
    LastWord() {
        if (pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK) != 0)
            throw Error(fmt::format("--ranks: cannot make a pipe: {}",
                                    std::strerror(errno)));
        setenv(own_mark,
               fmt::format("/proc/{}/fd/{}", getpid(), ends_[1]).c_str(), 1);
    }
    ~LastWord() {
        for (const int end : ends_) close(end);
    }
    LastWord(const LastWord&) = delete;
    LastWord& operator=(const LastWord&) = delete;

    std::optional<int> heard() const {
        unsigned char code = 0;
        if (read(ends_[0], &code, 1) != 1) return {};
        return code;
    }

  private:
    std::array<int, 2> ends_{};
};

//! How a launcher ended, and what the user had asked for.
struct End {
    int status = 0;      //!< of waitpid()
    int interrupts = 0;  //!< SIGINT
    bool was_asked = false;
};

//! Passes signals on until the launcher ends. Open MPI's own way with SIGINT
//! and SIGTERM would leave the ranks a second; MPICH's passes SIGTERM on to
//! ranks, which may work on, so it is killed if it does not end by that.
End watch(pid_t launcher) {
    constexpr timespec patience{3, 0};
    const sigset_t signals = heard_signals();
    End end;
    for (;;) {
        const bool is_to_end = end.interrupts > 1;
        const int signal = is_to_end
                               ? sigtimedwait(&signals, nullptr, &patience)
                               : sigwaitinfo(&signals, nullptr);
        if (waitpid(launcher, &end.status, WNOHANG) == launcher) return end;
        if (signal < 0 && is_to_end) kill(launcher, SIGKILL);
        if (signal < 0 || signal == SIGCHLD) continue;
        end.was_asked = true;
        if (signal == SIGINT) ++end.interrupts;
        kill(launcher, end.interrupts > 2   ? SIGKILL
                       : end.interrupts > 1 ? SIGTERM
                                            : SIGUSR1);
    }
}

constexpr int by_signal = 128;

//! As a shell tells it, 128 + n for signal n; for a rank's MPICH's launcher
//! ends with n alone.
int code_of(int status) {
    if (WIFSIGNALED(status)) return by_signal + WTERMSIG(status);
    const int code = WEXITSTATUS(status);
    const bool is_signal = code > static_cast<int>(ExitCode::stopped) &&
                           code < NSIG &&
                           Session::library_version().starts_with("MPICH");
    return is_signal ? by_signal + code : code;
}

int exit_code(const End& end, const std::optional<int>& last_word,
              const std::string& way_on) {
    const int code = code_of(end.status);
    const auto tell = [&](const std::string& what) {
        fmt::print(stderr,
                   "ideotype: {}; what was recorded is safe; go on with\n"
                   "  {}\n",
                   what, way_on);
    };
    // Open MPI's launcher ends with 1 when it was told to end, and at times
    // with a crash of its own.
    if (end.interrupts > 1 && (code == static_cast<int>(ExitCode::runtime) ||
                               WIFSIGNALED(end.status))) {
        tell("stopped at once");
        return by_signal + SIGINT;
    }
    if (code == 0 && end.was_asked && !last_word) {
        tell("stopped before the end");
        return static_cast<int>(ExitCode::stopped);
    }
    if (code == 0) return last_word.value_or(code);
    if (code <= static_cast<int>(ExitCode::stopped)) return code;
    if (end.was_asked && code == by_signal + SIGUSR1) {
        tell("stopped before the first evaluation");
        return static_cast<int>(ExitCode::stopped);
    }
    if (code > by_signal)
        tell(fmt::format("a rank was ended by signal {} ({})", code - by_signal,
                         strsignal(code - by_signal)));
    else
        tell(
            fmt::format("{} ended with {}; OMPI_MCA_orte_execute_quiet=0 "
                        "shows what Open MPI says",
                        IDEOTYPE_MPIEXEC, code));
    return code;
}

}  // namespace

bool is_own_launch() {
    return std::getenv(own_mark) != nullptr;
}

void tell_launcher(ExitCode code) {
    const char* pipe = std::getenv(own_mark);
    const int file = pipe != nullptr ? open(pipe, O_WRONLY | O_CLOEXEC) : -1;
    if (file < 0) return;
    const auto byte = static_cast<unsigned char>(code);
    // What cannot be told is left to the launcher of the ranks.
    [[maybe_unused]] const ssize_t told = write(file, &byte, 1);
    close(file);
}

int launch(int ranks, const std::vector<std::string>& words,
           const std::string& way_on) {
    std::vector<std::string> command{
        find_launcher(), IDEOTYPE_MPIEXEC_RANKS, std::to_string(ranks),
        fs::read_symlink("/proc/self/exe").string()};
    command.insert(command.end(), words.begin() + 1, words.end());
    std::vector<char*> pointers;
    for (std::string& word : command) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    for (const Variable& each : environment) setenv(each.name, each.value, 0);
    const LastWord last_word;

    const sigset_t signals = heard_signals();
    sigprocmask(SIG_BLOCK, &signals, nullptr);
    const pid_t launcher = fork();
    if (launcher == 0) become(pointers.data());
    if (launcher < 0)
        throw Error(fmt::format("--ranks: cannot start {}: {}", command[0],
                                std::strerror(errno)));
    const End end = watch(launcher);
    return exit_code(end, last_word.heard(), way_on);
}

}  // namespace ideotype
