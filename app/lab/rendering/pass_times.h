#pragma once

#include <cstddef>
#include <vector>

/// The GPU times of the passes in the latest frames.
class PassTimes {
public:
    static constexpr std::size_t length = 120;

    /// Adds a frame, one number per pass. Another number of passes discards the previous frames.
    void add(const std::vector<double>& milliseconds);

    std::size_t passes() const { return m_frames.empty() ? 0 : m_frames.front().size(); }
    std::size_t frames() const { return m_frames.size(); }  // at most `length`
    /// `frame` from 0, the oldest.
    double milliseconds(std::size_t pass, std::size_t frame) const;
    double total(std::size_t frame) const;
    /// The mean total of the last 20 frames, steady enough to read.
    double current_total() const;
    /// The longest total of the stored frames.
    double longest_total() const;

private:
    std::vector<std::vector<double>> m_frames;  // a ring once it is full
    std::size_t m_oldest = 0;
};
