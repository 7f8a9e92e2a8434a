#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>

/// The file name of one picture, or those of a sequence.
class FrameNames {
public:
    FrameNames(std::string before, int digits, std::string after)
        : m_before(std::move(before)), m_digits(digits), m_after(std::move(after)) {}

    bool is_sequence() const { return m_digits > 0; }
    std::filesystem::path name(int frame) const;
    /// Whether the picture, or any picture of the sequence, exists.
    bool exist() const;

private:
    std::string m_before;
    int m_digits = 0;  // 0: one picture
    std::string m_after;
};

/// Parses "out.png", or a path whose file name has one %d, %04d or similar: "out_%04d.png".
Result<FrameNames> parse_frame_names(const std::string& text);
