// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "guard.hpp"
#include "ideotype/core/error.hpp"
#include "mailbox.hpp"

namespace ideotype {

void serve(const Session& session, Evaluator& evaluator) {
    Mailbox mailbox(session);
    const int rank = session.rank_in_job(session.rank());
    for (;;) {
        const Envelope letter = mailbox.wait();
        if (letter.tag == Tag::stop) return;
        if (letter.tag != Tag::work)
            throw Error(fmt::format(
                "rank {} expected work but rank {} sent a reply; all ranks "
                "must run the same ideotype",
                rank, session.rank_in_job(letter.source)));
        const Work work = decode_work(letter.bytes);
        mailbox.post(
            letter.source, Tag::reply,
            encode_reply({work.task, evaluate_guarded(evaluator, work, rank,
                                                      session.clock())}));
    }
}

}  // namespace ideotype
