// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <limits>

#include <gtest/gtest.h>

#include "fake_evaluator.hpp"
#include "ideotype/core/error.hpp"
#include "parallel/messages.hpp"

namespace ideotype {

namespace {

constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();

Reply sample_reply(std::string message = {}) {
    const Task task{3, 200, 99, 2, true};
    Outcome outcome = FakeEvaluator().evaluate(task, {0.5, -0.25});
    outcome.seconds = 1.25;
    outcome.worker = 17;
    outcome.message = std::move(message);
    return {task, outcome};
}

void expect_same_bits(const std::vector<Estimate>& a,
                      const std::vector<Estimate>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i].mean),
                  std::bit_cast<std::uint64_t>(b[i].mean));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i].standard_error),
                  std::bit_cast<std::uint64_t>(b[i].standard_error));
    }
}

}  // namespace

TEST(Messages, WorkIsDecodedUnchanged) {
    for (const Work& work :
         {Work{{1, 2, 3, 4, false}, {}}, Work{{0, 0, 0, 1, true}, {-0.0}},
          Work{{largest, largest, largest, largest, true}, Genome(5000, 0.1)}})
        EXPECT_EQ(decode_work(encode_work(work)), work);
}

TEST(Messages, WorkOfFortyGenesTakes392Bytes) {
    EXPECT_EQ(encode_work({{}, Genome(40)}).size(), 72u + 320u);
}

TEST(Messages, ReplyIsDecodedUnchanged) {
    const Reply reply = sample_reply("almost too dense");
    const Reply copy = decode_reply(encode_reply(reply), fake_schema());
    EXPECT_EQ(copy.task, reply.task);
    EXPECT_EQ(copy.outcome.status, Status::done);
    EXPECT_EQ(copy.outcome.seconds, 1.25);
    EXPECT_EQ(copy.outcome.worker, 17u);
    EXPECT_EQ(copy.outcome.message, "almost too dense");
    expect_same_bits(copy.outcome.objectives, reply.outcome.objectives);
    expect_same_bits(copy.outcome.quantities, reply.outcome.quantities);
    EXPECT_EQ(copy.outcome.randomisations, reply.outcome.randomisations);
    EXPECT_EQ(copy.outcome.violation, reply.outcome.violation);
}

TEST(Messages, FailureIsDecodedWithItsReason) {
    const Reply reply{{1, 2, 3}, failed_outcome(fake_schema(), "no leaves")};
    const Reply copy = decode_reply(encode_reply(reply), fake_schema());
    EXPECT_EQ(copy.outcome.status, Status::failed);
    EXPECT_EQ(copy.outcome.message, "no leaves");
    expect_same_bits(copy.outcome.objectives, reply.outcome.objectives);
    expect_same_bits(copy.outcome.quantities, reply.outcome.quantities);
}

TEST(Messages, FailedMachineSendsNoNumbers) {
    Outcome outcome;
    outcome.status = Status::proposed;
    outcome.message = "on node7: not enough memory";
    const Reply reply{{1, 2, 3}, outcome};
    const Bytes bytes = encode_reply(reply);
    EXPECT_LT(bytes.size(), encode_reply(sample_reply()).size());
    const Reply copy = decode_reply(bytes, fake_schema());
    EXPECT_EQ(copy.outcome.status, Status::proposed);
    EXPECT_EQ(copy.outcome.message, "on node7: not enough memory");
}

TEST(Messages, SizeOfAReplyDoesNotDependOnTheReason) {
    EXPECT_EQ(encode_reply(sample_reply()).size(),
              encode_reply(sample_reply(std::string(1000, 'x'))).size());
}

TEST(Messages, LongReasonIsCutBetweenCharacters) {
    const auto received = [](const std::string& message) {
        return decode_reply(encode_reply(sample_reply(message)), fake_schema())
            .outcome.message;
    };
    const std::string fitting(reply_message_capacity, 'a');
    EXPECT_EQ(received(fitting), fitting);
    EXPECT_EQ(received(fitting + "b"), fitting);
    // The limit splits the two bytes of this character.
    const std::string one_short(reply_message_capacity - 1, 'a');
    EXPECT_EQ(received(one_short + "\u00e4"), one_short);
    const std::string two_short(reply_message_capacity - 2, 'a');
    EXPECT_EQ(received(two_short + "\u00e4b"), two_short + "\u00e4");
}

TEST(Messages, OtherBytesAreAnError) {
    const Bytes work = encode_work({{1, 2, 3}, {0.5, 1.5}});
    const Bytes reply = encode_reply(sample_reply());
    EXPECT_THROW(decode_work({}), Error);
    EXPECT_THROW(decode_work(reply), Error);
    EXPECT_THROW(decode_work(Bytes(352)), Error);
    EXPECT_THROW(decode_reply({}, fake_schema()), Error);
    EXPECT_THROW(decode_reply(work, fake_schema()), Error);
    EXPECT_THROW(decode_reply(Bytes(5000), fake_schema()), Error);
}

TEST(Messages, WrongLengthIsAnError) {
    Bytes work = encode_work({{1, 2, 3}, {0.5, 1.5}});
    work.pop_back();
    EXPECT_THROW(decode_work(work), Error);
    work.resize(work.size() + 2);
    EXPECT_THROW(decode_work(work), Error);

    OutcomeSchema other = fake_schema();
    other.measured.quantities.push_back({"mass", "kg", ""});
    EXPECT_THROW(decode_reply(encode_reply(sample_reply()), other), Error);
}

}  // namespace ideotype
