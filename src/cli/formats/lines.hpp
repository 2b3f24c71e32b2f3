// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ideotype {

//! A line of text without its end.
struct Line {
    std::uint64_t number = 0;  //!< from 1
    std::string text;
    bool is_cut = false;  //!< it was longer than any that is read
};

//! Lines from a pipe, a terminal or a file, as they arrive. Reads no further
//! than it is asked to, so that whoever writes much has to wait.
class LineReader {
  public:
    //! Longer lines are cut [bytes].
    static constexpr std::size_t longest = 1 << 20;

    //! @param file descriptor that others keep open
    explicit LineReader(int file) : file_(file) {}

    //! Returns the next line; nothing at the end, after a time [s] or a signal.
    //! @throws Error if it cannot be read.
    std::optional<Line> next(double seconds);

    //! Returns whether the input has no further line.
    bool has_ended() const { return is_closed_ && buffer_.empty() && !is_cut_; }

  private:
    std::optional<Line> take();
    bool read_more(double seconds);

    int file_;
    std::string buffer_;        //!< what has arrived and was not taken
    std::size_t searched_ = 0;  //!< bytes of it without the end of a line
    std::uint64_t lines_ = 0;   //!< taken
    bool is_cut_ = false;       //!< the beginning of a line was thrown away
    bool is_closed_ = false;
};

//! Lines to the standard output, each at once.
class LineWriter {
  public:
    LineWriter();
    ~LineWriter();
    LineWriter(const LineWriter&) = delete;
    LineWriter& operator=(const LineWriter&) = delete;

    //! @throws Error if nobody reads them any more, or the disk is full.
    void write(const std::string& line) const;

  private:
    int file_;
};

}  // namespace ideotype
