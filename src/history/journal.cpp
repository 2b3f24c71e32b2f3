// SPDX-License-Identifier: Apache-2.0
#include "journal.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "ideotype/core/contract.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

constexpr std::size_t reason_size = 64;
constexpr std::size_t message_size = 240;
constexpr hsize_t most_sessions = 1000;
constexpr hsize_t most_messages = 1000;

struct SessionColumn {
    const char* name;
    std::size_t size;
    const char* meaning;
    std::string SessionRecord::*member;
};

constexpr std::array session_columns{
    SessionColumn{"started", 32, "time of the start in UTC",
                  &SessionRecord::started},
    SessionColumn{"host", 64, "host of rank 0", &SessionRecord::host},
    SessionColumn{"command", longest_command,
                  "command that started the program", &SessionRecord::command},
    SessionColumn{"program", 64, "name and version of the program",
                  &SessionRecord::program},
    SessionColumn{"compiler", 64, "compiler that built the program",
                  &SessionRecord::compiler},
    SessionColumn{"libraries", 256, "name and version of each library",
                  &SessionRecord::libraries}};

// Counts the used rows, which precede the first empty row.
hsize_t count_used(const Dataset& texts) {
    const auto entries = texts.read_text(0, texts.rows());
    return static_cast<hsize_t>(std::find(entries.begin(), entries.end(), "") -
                                entries.begin());
}

}  // namespace

void Journal::create(hid_t file) {
    const Handle state = create_group(file, "state");
    create_dataset(state, {.name = "finished",
                           .type = bool_type(),
                           .meaning = "whether the case is finished"});
    create_dataset(state, {.name = "reason",
                           .type = string_type(reason_size),
                           .unit = "",
                           .meaning = "reason why the case finished"});
    create_dataset(state, {.name = "wall_time",
                           .type = H5T_IEEE_F64LE,
                           .unit = "s",
                           .meaning = "total wall time of all sessions"});
    const auto add = [&](hid_t group, const std::string& axis,
                         const std::string& name, hid_t type,
                         const std::string& unit, const std::string& meaning) {
        create_dataset(group, {.name = name,
                               .type = type,
                               .axes = {axis},
                               .unit = unit,
                               .meaning = meaning,
                               .room = Room::as_needed});
    };
    const Handle sessions = create_group(file, "sessions");
    create_axis(sessions,
                counted("session", "starts of the program", most_sessions));
    for (const SessionColumn& column : session_columns)
        add(sessions, "session", column.name, string_type(column.size), "",
            column.meaning);
    add(sessions, "session", "ranks", H5T_STD_I32LE, "1",
        "number of ranks of MPI");
    const Handle messages = create_group(file, "messages");
    create_axis(messages, counted("message", "oldest first", most_messages));
    add(messages, "message", "text", string_type(message_size), "",
        "message for the user");
}

Journal::Journal(hid_t file)
    : finished_(file, "state/finished"),
      reason_(file, "state/reason"),
      wall_time_(file, "state/wall_time"),
      ranks_(file, "sessions/ranks"),
      messages_(file, "messages/text") {
    for (const SessionColumn& column : session_columns)
        sessions_.emplace_back(file, std::string("sessions/") + column.name);
    sessions_used_ = count_used(sessions_[0]);
    messages_used_ = count_used(messages_);
    IDEOTYPE_ENSURE(sessions_used_ <= ranks_.rows());
}

void Journal::add(const SessionRecord& session) {
    IDEOTYPE_EXPECT(!session.started.empty() && session.ranks > 0);
    if (sessions_used_ == ranks_.rows()) return;
    ranks_.write_one(sessions_used_, std::int32_t{session.ranks});
    // Write the start time last, since it marks the row as used.
    for (std::size_t i = session_columns.size(); i-- > 0;)
        sessions_[i].write_text(sessions_used_,
                                session.*session_columns[i].member);
    ++sessions_used_;
}

void Journal::add(const std::string& message) {
    if (message.empty() || messages_used_ == messages_.rows()) return;
    messages_.write_text(messages_used_++, message);
}

std::optional<SessionRecord> Journal::last_session() const {
    if (sessions_used_ == 0) return std::nullopt;
    SessionRecord last;
    for (std::size_t i = 0; i < session_columns.size(); ++i)
        last.*session_columns[i].member =
            sessions_[i].read_text(sessions_used_ - 1, 1)[0];
    last.ranks = ranks_.read<std::int32_t>(sessions_used_ - 1, 1)[0];
    return last;
}

void Journal::set_reason(const std::string& reason) {
    IDEOTYPE_EXPECT(reason.size() <= reason_size);
    reason_.write_text(0, reason);
}

std::optional<std::string> Journal::finished() const {
    if (finished_.read<std::int8_t>(0, 1)[0] == 0) return std::nullopt;
    return reason_.read_text(0, 1)[0];
}

}  // namespace ideotype
