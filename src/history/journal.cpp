#include "journal.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "layout.hpp"
#include "types.hpp"

namespace ideotype {

namespace {

constexpr std::size_t reason_size = 64;
constexpr std::size_t message_size = 240;
constexpr hsize_t most_sessions = 1000;
constexpr hsize_t most_messages = 1000;

// A row of /sessions in memory and, without gaps, in the file.
struct StoredSession {
    char started[32] = {};
    char host[64] = {};
    char command[longest_command] = {};
    std::int32_t ranks = 0;
};

template <std::size_t size>
void store(char (&field)[size], const std::string& text) {
    const std::string start = fitted(text, size);
    std::copy(start.begin(), start.end(), field);
}

template <std::size_t size>
std::string stored_text(const char (&field)[size]) {
    return {field, strnlen(field, size)};
}

Handle session_type() {
    Handle type(H5Tcreate(H5T_COMPOUND, sizeof(StoredSession)), H5Tclose,
                "create a compound type");
    const auto add = [&](const char* name, std::size_t offset, hid_t member) {
        checked(H5Tinsert(type, name, offset, member), "fill a compound type");
    };
    add("started", offsetof(StoredSession, started),
        string_type(sizeof(StoredSession::started)));
    add("host", offsetof(StoredSession, host),
        string_type(sizeof(StoredSession::host)));
    add("command", offsetof(StoredSession, command),
        string_type(sizeof(StoredSession::command)));
    add("ranks", offsetof(StoredSession, ranks), H5T_STD_I32LE);
    return type;
}

// Rows that are not used yet are empty, which is how their number is found.
void create_list(hid_t file, const std::string& name, hid_t type,
                 hsize_t rows) {
    create_dataset(file, {.name = name,
                          .type = type,
                          .sizes = {rows},
                          .unit = "",
                          .room = Room::as_needed});
}

hsize_t used_rows(const std::vector<StoredSession>& sessions) {
    hsize_t count = 0;
    while (count < sessions.size() && sessions[count].started[0] != '\0')
        ++count;
    return count;
}

hsize_t used_rows(const std::vector<std::string>& messages) {
    hsize_t count = 0;
    while (count < messages.size() && !messages[count].empty()) ++count;
    return count;
}

}  // namespace

void Journal::create(hid_t file) {
    const Handle state = create_group(file, "state");
    const double none = 0;
    create_dataset(
        state,
        {.name = "finished", .type = bool_type(), .sizes = {}, .unit = "1"});
    create_dataset(state, {.name = "reason",
                           .type = string_type(reason_size),
                           .sizes = {},
                           .unit = ""});
    create_dataset(state, {.name = "wall_time",
                           .type = H5T_IEEE_F64LE,
                           .sizes = {},
                           .unit = "s",
                           .empty = &none});
    create_list(file, "sessions", session_type(), most_sessions);
    create_list(file, "messages", string_type(message_size), most_messages);
}

Journal::Journal(hid_t file)
    : finished_(file, "state/finished"),
      reason_(file, "state/reason"),
      wall_time_(file, "state/wall_time"),
      sessions_(file, "sessions"),
      messages_(file, "messages"),
      sessions_used_(
          used_rows(sessions_.read<StoredSession>(0, most_sessions))),
      messages_used_(used_rows(messages_.read_text(0, most_messages))) {}

void Journal::add(const SessionRecord& session) {
    StoredSession row;
    store(row.started, session.started);
    store(row.host, session.host);
    store(row.command, session.command);
    row.ranks = session.ranks;
    if (sessions_used_ == sessions_.rows()) return;
    sessions_.write_one(sessions_used_++, row);
}

void Journal::add(const std::string& message) {
    if (message.empty() || messages_used_ == messages_.rows()) return;
    messages_.write_text(messages_used_++, message);
}

std::optional<SessionRecord> Journal::last_session() const {
    if (sessions_used_ == 0) return std::nullopt;
    const auto row = sessions_.read<StoredSession>(sessions_used_ - 1, 1)[0];
    return SessionRecord{stored_text(row.started), stored_text(row.host),
                         stored_text(row.command), row.ranks};
}

double Journal::wall_time() const {
    return wall_time_.read<double>(0, 1)[0];
}

void Journal::set_wall_time(double seconds) {
    wall_time_.write_one(0, seconds);
}

void Journal::set_reason(const std::string& reason) {
    reason_.write_text(0, reason);
}

void Journal::set_finished() {
    finished_.write_one(0, std::int8_t{1});
}

std::optional<std::string> Journal::finished() const {
    if (finished_.read<std::int8_t>(0, 1)[0] == 0) return std::nullopt;
    return reason_.read_text(0, 1)[0];
}

}  // namespace ideotype
