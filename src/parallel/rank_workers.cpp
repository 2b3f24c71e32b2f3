// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "messages.hpp"
#include "workers.hpp"

namespace ideotype {

namespace {

//! Workers of this rank's own come first, then those of the others. Which of
//! its threads does what a rank decides by itself.
class RankWorkers : public Workers {
  public:
    RankWorkers(const Session& session, const Evaluators& evaluators)
        : session_(session),
          evaluators_(evaluators),
          own_(evaluators.size() > 1 ? make_thread_workers(session, evaluators)
                                     : nullptr),
          mailbox_(session),
          given_(per_rank() * static_cast<std::size_t>(session.size() - 1)) {}

    int width() const override {
        return own_width() + static_cast<int>(given_.size());
    }
    int number(int worker) const override {
        if (worker < own_width()) return own_->number(worker);
        const auto threads = static_cast<int>(per_rank());
        return session_.rank_in_job(rank_of(worker)) * threads +
               (worker - own_width()) % threads;
    }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluators_.front()->schema(task);
    }

    void give(int worker, const Work& work) override {
        if (worker < own_width()) return own_->give(worker, work);
        given_[static_cast<std::size_t>(worker - own_width())] = work.task;
        mailbox_.post(rank_of(worker), Tag::work, encode_work(work));
    }

    std::optional<Answer> wait(double seconds) override {
        const RankClock& clock = session_.clock();
        const double end = clock.now() + seconds;
        Backoff backoff;
        for (;;) {
            if (const auto letter = mailbox_.wait(own_ ? 0 : seconds))
                return answer_in(*letter);
            if (!own_) return std::nullopt;
            if (auto answer = own_->wait(backoff.next())) return answer;
            if (clock.now() >= end) return std::nullopt;
        }
    }

    void dismiss() override {
        if (own_) own_->dismiss();
        for (int rank = 1; rank < session_.size(); ++rank)
            mailbox_.post(rank, Tag::stop, {});
    }

  private:
    std::size_t per_rank() const { return evaluators_.size(); }
    int own_width() const { return own_ ? own_->width() : 0; }
    int rank_of(int worker) const {
        return 1 + (worker - own_width()) / static_cast<int>(per_rank());
    }

    Answer answer_in(const Envelope& letter) {
        const int rank = session_.rank_in_job(letter.source);
        if (letter.tag != Tag::reply) refuse(rank);
        const Task task = task_of_reply(letter.bytes);
        const auto first =
            given_.begin() +
            static_cast<std::ptrdiff_t>(per_rank()) * (letter.source - 1);
        const auto last = first + static_cast<std::ptrdiff_t>(per_rank());
        const auto found = std::find(first, last, std::optional(task));
        if (found == last) refuse(rank);
        found->reset();
        return {own_width() + static_cast<int>(found - given_.begin()),
                decode_reply(letter.bytes, schema(task)).outcome};
    }

    [[noreturn]] static void refuse(int rank) {
        throw Error(
            fmt::format("rank {} replied without having that work; all ranks "
                        "must run the same ideotype",
                        rank));
    }

    const Session& session_;
    const Evaluators evaluators_;
    std::unique_ptr<Workers> own_;  //!< threads of this rank, if any
    Mailbox mailbox_;
    std::vector<std::optional<Task>> given_;  //!< to workers of other ranks
};

}  // namespace

std::unique_ptr<Workers> make_rank_workers(const Session& session,
                                           const Evaluators& evaluators) {
    return std::make_unique<RankWorkers>(session, evaluators);
}

}  // namespace ideotype
