#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>

/// The names of one picture, or of a sequence of them.
class FrameNames {
public:
    FrameNames(std::string before, int digits, std::string after)
        : m_before(std::move(before)), m_digits(digits), m_after(std::move(after)) {}

    bool is_sequence() const { return m_digits > 0; }
    std::filesystem::path name(int frame) const;

private:
    std::string m_before;
    int m_digits = 0;  // 0: one picture
    std::string m_after;
};

/// "out.png", or with one %d, %04d or the like: "out_%04d.png".
Result<FrameNames> parse_frame_names(const std::string& text);
