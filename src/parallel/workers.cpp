// SPDX-License-Identifier: Apache-2.0
#include "workers.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "guard.hpp"
#include "ideotype/core/error.hpp"
#include "mailbox.hpp"

namespace ideotype {

namespace {

class LocalWorker : public Workers {
  public:
    LocalWorker(Evaluator& evaluator, int rank)
        : evaluator_(evaluator), rank_(rank) {}

    int width() const override { return 1; }
    int rank(int) const override { return rank_; }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluator_.schema(task);
    }
    void give(int, const Work& work) override { work_ = work; }

    std::optional<Answer> wait(double) override {
        const Work work = *std::exchange(work_, std::nullopt);
        return Answer{
            0, evaluate_guarded(evaluator_, work, rank_, machine_clock())};
    }

    void dismiss() override {}

  private:
    Evaluator& evaluator_;
    int rank_;
    std::optional<Work> work_;
};

class RankWorkers : public Workers {
  public:
    RankWorkers(const Session& session, const Evaluator& evaluator)
        : session_(session),
          evaluator_(evaluator),
          mailbox_(session),
          given_(static_cast<std::size_t>(session.size()) - 1) {}

    int width() const override { return static_cast<int>(given_.size()); }
    int rank(int worker) const override {
        return session_.rank_in_job(worker + 1);
    }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluator_.schema(task);
    }

    void give(int worker, const Work& work) override {
        given_[static_cast<std::size_t>(worker)] = work.task;
        mailbox_.post(worker + 1, Tag::work, encode_work(work));
    }

    std::optional<Answer> wait(double seconds) override {
        const std::optional<Envelope> letter = mailbox_.wait(seconds);
        if (!letter) return std::nullopt;
        const int worker = letter->source - 1;
        auto& given = given_.at(static_cast<std::size_t>(worker));
        if (letter->tag != Tag::reply || !given)
            throw Error(fmt::format(
                "rank {} replied without having work; all ranks must run the "
                "same ideotype",
                rank(worker)));
        const Task task = *std::exchange(given, std::nullopt);
        Reply reply = decode_reply(letter->bytes, evaluator_.schema(task));
        if (reply.task != task)
            throw Error(
                fmt::format("rank {} replied for generation {} slot {} but had "
                            "generation {} slot {}",
                            rank(worker), reply.task.generation,
                            reply.task.slot, task.generation, task.slot));
        return Answer{worker, std::move(reply.outcome)};
    }

    void dismiss() override {
        for (int worker = 0; worker < width(); ++worker)
            mailbox_.post(worker + 1, Tag::stop, {});
    }

  private:
    const Session& session_;
    const Evaluator& evaluator_;
    Mailbox mailbox_;
    std::vector<std::optional<Task>> given_;  //!< by worker
};

}  // namespace

std::unique_ptr<Workers> make_local_worker(Evaluator& evaluator, int rank) {
    return std::make_unique<LocalWorker>(evaluator, rank);
}

std::unique_ptr<Workers> make_rank_workers(const Session& session,
                                           const Evaluator& evaluator) {
    return std::make_unique<RankWorkers>(session, evaluator);
}

}  // namespace ideotype
