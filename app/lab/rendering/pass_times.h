#pragma once

#include <cstddef>
#include <vector>

/// How long the GPU took for each pass in the latest frames.
class PassTimes {
public:
    static constexpr std::size_t length = 120;

    /// Of one frame, a number a pass; another number of passes begins anew.
    void add(const std::vector<double>& milliseconds);

    std::size_t passes() const { return m_frames.empty() ? 0 : m_frames.front().size(); }
    std::size_t frames() const { return m_frames.size(); }  // at most `length`
    /// `frame` from 0, the oldest.
    double milliseconds(std::size_t pass, std::size_t frame) const;
    double total(std::size_t frame) const;
    /// The mean of the last few frames, so that it can be read: of all passes together.
    double present_total() const;
    /// The longest total of the frames that are known.
    double longest_total() const;

private:
    std::vector<std::vector<double>> m_frames;  // a ring once it is full
    std::size_t m_oldest = 0;
};
