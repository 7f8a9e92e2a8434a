#pragma once

#include "base/diagnostic.h"
#include "model/plan/beam.h"
#include "signals/audio/channel_map.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What another program sends: the beam goes evenly on to x, y within `seconds`.
struct SentPoint {
    float x = 0.0f;        // -1 left .. 1 right
    float y = 0.0f;        // -1 bottom .. 1 top
    float current = 0.0f;  // on the way; 1 full, 0 blanked
    double seconds = 0.0;
    std::optional<BeamTint> tint = {};  // none: white

    bool operator==(const SentPoint&) const = default;
};

struct SentFormat {
    bool is_raw = false;                     // 32-bit floats, little-endian; else lines of text
    int channels = 3;                        // raw
    ChannelMap map = {.intensity = 3};       // raw: a channel beyond the last one is none
    double seconds = 1.0 / (4096.0 * 60.0);  // of a point that says no time of its own
};

/// Turns bytes into points as they come, however they are cut. What cannot be read is passed over.
class SentReader {
public:
    /// The name stands for the file in what is told.
    SentReader(const SentFormat& format, std::string name)
        : m_format(format), m_name(std::move(name)) {}

    void take(std::string_view bytes, std::vector<SentPoint>& points);
    /// Nothing more comes: a last line needs no end.
    void finish(std::vector<SentPoint>& points);

    /// The first thing that could not be read.
    const std::optional<Diagnostic>& problem() const { return m_problem; }
    /// How many lines, or raw points, could not be read.
    std::int64_t bad_count() const { return m_bad_count; }

    static constexpr std::size_t longest_line = 1000;

private:
    void take_text(std::string_view bytes, std::vector<SentPoint>& points);
    void take_raw(std::string_view bytes, std::vector<SentPoint>& points);
    void take_line(std::string_view line, std::vector<SentPoint>& points);
    void take_frame(std::string_view frame, std::vector<SentPoint>& points);
    void keep(std::string_view part);
    void pass_over(int line, std::string why);

    SentFormat m_format;
    std::string m_name;
    std::string m_rest;  // the beginning of a line or of a raw point
    bool m_is_too_long = false;
    std::int64_t m_number = 0;  // lines or raw points so far
    std::int64_t m_bad_count = 0;
    std::optional<Diagnostic> m_problem;
};
