// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset.hpp"
#include "history.hpp"

namespace ideotype {

//! /state, /sessions and /messages: what happens to the case besides its
//! evolution.
class Journal {
  public:
    static void create(hid_t file);

    explicit Journal(hid_t file);

    //! These drop what does not fit any more.
    void add(const SessionRecord& session);
    void add(const std::string& message);

    //! None if there was none yet.
    std::optional<SessionRecord> last_session() const;

    double wall_time() const;
    void set_wall_time(double seconds);

    //! To be written before set_finished().
    void set_reason(const std::string& reason);
    void set_finished();
    std::optional<std::string> finished() const;

  private:
    Dataset finished_;
    Dataset reason_;
    Dataset wall_time_;
    std::vector<Dataset> sessions_;  //!< in the order of session_columns
    Dataset ranks_;
    Dataset messages_;
    hsize_t sessions_used_ = 0;
    hsize_t messages_used_ = 0;
};

}  // namespace ideotype
