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
    bool is_cut = false;  //!< whether it exceeded LineReader::longest
};

//! Reads lines from a pipe, a terminal or a file as they arrive. It reads only
//! on demand, so that the writer waits if it is faster (backpressure).
class LineReader {
  public:
    //! Length at which longer lines are cut [bytes].
    static constexpr std::size_t longest = 1 << 20;

    //! @param file file descriptor, which must stay open
    explicit LineReader(int file) : file_(file) {}

    //! Returns the next line, or nothing at the end of the input, after a
    //! number of seconds, or after a signal.
    //! @throws Error if the input cannot be read.
    std::optional<Line> next(double seconds);

    //! Returns whether the input is exhausted.
    bool has_ended() const { return is_closed_ && buffer_.empty() && !is_cut_; }

  private:
    std::optional<Line> take();
    bool read_more(double seconds);

    int file_;
    std::string buffer_;  //!< bytes that were read but not yet returned
    std::size_t searched_ =
        0;  //!< leading bytes of the buffer without a line break
    std::uint64_t lines_ = 0;  //!< number of returned lines
    //! Whether the beginning of the current line was discarded.
    bool is_cut_ = false;
    bool is_closed_ = false;
};

//! Writes lines to the standard output without buffering.
class LineWriter {
  public:
    LineWriter();
    ~LineWriter();
    LineWriter(const LineWriter&) = delete;
    LineWriter& operator=(const LineWriter&) = delete;

    //! @throws Error if the reader has closed the pipe or the disk is full.
    void write(const std::string& line) const;

  private:
    int file_;
};

}  // namespace ideotype
