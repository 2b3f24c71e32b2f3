#include "ideotype/parallel/dispatcher.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "guard.hpp"
#include "ideotype/core/error.hpp"
#include "mailbox.hpp"

namespace ideotype {

namespace {

//! The only rank does all the work itself.
class Soloist : public Dispatcher {
  public:
    Soloist(const Session& session, Evaluator& evaluator, const StopFlag& stop)
        : session_(session), evaluator_(evaluator), stop_(stop) {}

    void evaluate(const std::vector<Work>& work,
                  const Record& record) override {
        for (const Work& item : work) {
            if (stop_.requested()) return;
            record(item, evaluate_guarded(evaluator_, item, session_.rank()));
        }
    }

    int width() const override { return 1; }

  private:
    const Session& session_;
    Evaluator& evaluator_;
    const StopFlag& stop_;
};

//! Rank 0 of several, which keeps all other ranks busy.
class Master : public Dispatcher {
  public:
    Master(const Session& session, const Evaluator& evaluator,
           const StopFlag& stop)
        : evaluator_(evaluator),
          stop_(stop),
          in_flight_(static_cast<std::size_t>(session.size())) {}

    ~Master() override {
        // The reply of a busy worker could not leave it if nobody took it.
        discard_in_flight();
        for (int rank = 1; rank <= width(); ++rank)
            mailbox_.post(rank, Tag::stop, {});
    }

    Master(const Master&) = delete;
    Master& operator=(const Master&) = delete;

    void evaluate(const std::vector<Work>& work,
                  const Record& record) override {
        // An exception in record() may have ended an earlier call.
        discard_in_flight();
        auto next = work.begin();
        for (;;) {
            while (next != work.end() && !stop_.requested() && hand_out(*next))
                ++next;
            if (busy() == 0) return;
            const auto [item, outcome] = collect();
            record(item, outcome);
        }
    }

    int width() const override {
        return static_cast<int>(in_flight_.size()) - 1;
    }

  private:
    struct Finished {
        Work work;
        Outcome outcome;
    };

    std::ptrdiff_t busy() const {
        return std::count_if(in_flight_.begin(), in_flight_.end(),
                             [](const auto& work) { return work.has_value(); });
    }

    //! Sends work to an idle worker, if there is one.
    bool hand_out(const Work& work) {
        const auto idle =
            std::find(in_flight_.begin() + 1, in_flight_.end(), std::nullopt);
        if (idle == in_flight_.end()) return false;
        *idle = work;
        mailbox_.post(static_cast<int>(idle - in_flight_.begin()), Tag::work,
                      encode_work(work));
        return true;
    }

    //! Waits for the next reply; its sender is idle from then on.
    Finished collect() {
        const Envelope letter = mailbox_.wait();
        auto& assigned = in_flight_[static_cast<std::size_t>(letter.source)];
        if (letter.tag != Tag::reply || !assigned)
            throw Error(fmt::format(
                "rank {} replied without having work; all ranks must run the "
                "same ideotype",
                letter.source));
        Work work = *std::exchange(assigned, std::nullopt);
        Reply reply = decode_reply(letter.bytes, evaluator_.schema(work.task));
        if (reply.task != work.task)
            throw Error(fmt::format(
                "rank {} replied for generation {} slot {} but had "
                "generation {} slot {}",
                letter.source, reply.task.generation, reply.task.slot,
                work.task.generation, work.task.slot));
        return {std::move(work), std::move(reply.outcome)};
    }

    void discard_in_flight() {
        while (busy() > 0) {
            const Envelope letter = mailbox_.wait();
            in_flight_[static_cast<std::size_t>(letter.source)].reset();
        }
    }

    const Evaluator& evaluator_;
    const StopFlag& stop_;
    std::vector<std::optional<Work>> in_flight_;  //!< by rank
    Mailbox mailbox_;
};

}  // namespace

std::unique_ptr<Dispatcher> make_dispatcher(const Session& session,
                                            Evaluator& evaluator,
                                            const StopFlag& stop) {
    if (session.size() == 1)
        return std::make_unique<Soloist>(session, evaluator, stop);
    return std::make_unique<Master>(session, evaluator, stop);
}

}  // namespace ideotype
