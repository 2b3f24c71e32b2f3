// SPDX-License-Identifier: Apache-2.0
#include <exception>
#include <numeric>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"
#include "messages.hpp"
#include "workers.hpp"

namespace ideotype {

namespace {

//! Makes an outcome that leaves the row proposed, so that another machine can
//! evaluate it.
Outcome make_unevaluated(const std::string& reason) {
    Outcome outcome;
    outcome.status = Status::proposed;
    outcome.message = fmt::format("on {}: {}", host_name(), reason);
    return outcome;
}

//! Evaluates work and catches errors. An error of the plant becomes a failed
//! outcome, any other error an unevaluated one.
Outcome evaluate_caught(Evaluator& evaluator, const Work& work,
                        const OutcomeSchema& schema) {
    try {
        return checked_outcome(schema,
                               evaluator.evaluate(work.task, work.genome));
    } catch (const Error& error) {
        return failed_outcome(schema, error.what());
    } catch (const std::exception& error) {
        return make_unevaluated(describe_exception(error));
    } catch (...) {
        return make_unevaluated("an exception of unknown type");
    }
}

//! Reads a message from rank 0: returns work, or nothing on dismissal.
std::optional<Work> read_work(const Envelope& letter, const Session& session) {
    if (letter.tag == Tag::stop) return std::nullopt;
    if (letter.tag != Tag::work)
        throw Error(fmt::format(
            "rank {} expected work but rank {} sent a reply; all ranks "
            "must run the same ideotype",
            session.rank_in_job(session.rank()),
            session.rank_in_job(letter.source)));
    return decode_work(letter.bytes);
}

void serve_alone(const Session& session, Evaluator& evaluator) {
    Mailbox mailbox(session);
    const int rank = session.rank_in_job(session.rank());
    while (const auto work = read_work(mailbox.wait(), session))
        mailbox.post(
            0, Tag::reply,
            encode_reply({work->task, evaluate_guarded(evaluator, *work, rank,
                                                       session.clock())}));
}

//! Evaluates with several threads, while the calling thread exchanges messages.
void serve_by_threads(const Session& session, const Evaluators& evaluators) {
    Mailbox mailbox(session);
    const auto threads = make_thread_workers(session, evaluators);
    std::vector<Task> tasks(evaluators.size());
    std::vector<int> idle(evaluators.size());
    std::iota(idle.begin(), idle.end(), 0);
    const auto patience = [&] { return idle.size() < tasks.size() ? 0. : 1.; };
    Backoff backoff;
    for (;;) {
        while (const auto letter = mailbox.wait(patience())) {
            const auto work = read_work(*letter, session);
            if (!work) return;
            IDEOTYPE_EXPECT(!idle.empty());
            tasks[static_cast<std::size_t>(idle.back())] = work->task;
            threads->give(idle.back(), *work);
            idle.pop_back();
        }
        if (auto answer = threads->wait(backoff.next())) {
            const auto worker = static_cast<std::size_t>(answer->worker);
            mailbox.post(0, Tag::reply,
                         encode_reply({tasks[worker], answer->outcome}));
            idle.push_back(answer->worker);
            backoff = {};
        }
    }
}

}  // namespace

Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock) {
    const OutcomeSchema& schema = evaluator.schema(work.task);
    const double start = clock.now();
    Outcome outcome = evaluate_caught(evaluator, work, schema);
    outcome.seconds = clock.now() - start;
    outcome.worker = static_cast<std::uint32_t>(rank);
    return outcome;
}

void serve(const Session& session, const Evaluators& evaluators) {
    IDEOTYPE_EXPECT(!evaluators.empty());
    if (evaluators.size() > 1)
        serve_by_threads(session, evaluators);
    else
        serve_alone(session, *evaluators.front());
}

}  // namespace ideotype
