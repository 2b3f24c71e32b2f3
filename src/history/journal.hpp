// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataset.hpp"
#include "history.hpp"

namespace ideotype {

//! The tables /state, /sessions and /messages, which record events of a case
//! other than its generations.
class Journal {
  public:
    static void create(hid_t file);

    explicit Journal(hid_t file);

    //! Both functions ignore entries for which there is no room.
    void add(const SessionRecord& session);
    void add(const std::string& message);

    //! Returns the last session, or nothing if there was none.
    std::optional<SessionRecord> last_session() const;

    double wall_time() const { return wall_time_.read<double>(0, 1)[0]; }
    void set_wall_time(double seconds) { wall_time_.write_one(0, seconds); }

    //! Writes the reason why the case ended. Call it before set_finished().
    void set_reason(const std::string& reason);
    void set_finished() { finished_.write_one(0, std::int8_t{1}); }
    std::optional<std::string> finished() const;

  private:
    Dataset finished_;
    Dataset reason_;
    Dataset wall_time_;
    //! Datasets in the order of session_columns.
    std::vector<Dataset> sessions_;
    Dataset ranks_;
    Dataset messages_;
    hsize_t sessions_used_ = 0;
    hsize_t messages_used_ = 0;
};

}  // namespace ideotype
