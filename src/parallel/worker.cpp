// SPDX-License-Identifier: Apache-2.0
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "backoff.hpp"
#include "guard.hpp"
#include "ideotype/core/error.hpp"
#include "mailbox.hpp"
#include "workers.hpp"

namespace ideotype {

namespace {

//! Reads a letter of rank 0: work, or none if there will be no more.
std::optional<Work> work_in(const Envelope& letter, const Session& session) {
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
    while (const auto work = work_in(mailbox.wait(), session))
        mailbox.post(
            0, Tag::reply,
            encode_reply({work->task, evaluate_guarded(evaluator, *work, rank,
                                                       session.clock())}));
}

//! Threads evaluate while this one looks after the messages.
void serve_by_threads(const Session& session, const Evaluators& evaluators) {
    Mailbox mailbox(session);
    const auto threads = make_thread_workers(session, evaluators);
    std::vector<Task> given(evaluators.size());
    std::vector<int> idle(evaluators.size());
    std::iota(idle.begin(), idle.end(), 0);
    const auto patience = [&] { return idle.size() < given.size() ? 0. : 1.; };
    Backoff backoff;
    for (;;) {
        while (const auto letter = mailbox.wait(patience())) {
            const auto work = work_in(*letter, session);
            if (!work) return;
            given.at(static_cast<std::size_t>(idle.back())) = work->task;
            threads->give(idle.back(), *work);
            idle.pop_back();
        }
        if (auto answer = threads->wait(backoff.next())) {
            const auto worker = static_cast<std::size_t>(answer->worker);
            mailbox.post(0, Tag::reply,
                         encode_reply({given[worker], answer->outcome}));
            idle.push_back(answer->worker);
            backoff = {};
        }
    }
}

}  // namespace

void serve(const Session& session, const Evaluators& evaluators) {
    if (evaluators.size() > 1)
        serve_by_threads(session, evaluators);
    else
        serve_alone(session, *evaluators.front());
}

}  // namespace ideotype
