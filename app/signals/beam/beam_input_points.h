#pragma once

#include "base/diagnostic.h"
#include "model/plan/beam.h"
#include "signals/audio/channel_map.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A point from another program: the beam moves to x, y at constant speed within `seconds`.
struct BeamInputPoint {
    float x = 0.0f;        // -1 left .. 1 right
    float y = 0.0f;        // -1 bottom .. 1 top
    float current = 0.0f;  // during the movement; 1 full, 0 blanked
    double seconds = 0.0;
    std::optional<BeamTint> tint = {};  // nullopt: white

    bool operator==(const BeamInputPoint&) const = default;
};

struct BeamInputFormat {
    bool is_raw = false;                     // 32-bit floats, little-endian; otherwise lines of
                                             // text
    int channels = 3;                        // raw
    ChannelMap map = {.intensity = 3};       // raw: a channel above `channels` is unused
    double seconds = 1.0 / (4096.0 * 60.0);  // duration of a point that has none
};

/// Parses a byte stream into points, in chunks of any size. Skips what it cannot parse.
class BeamInputReader {
public:
    /// `name` is used as the file in diagnostics.
    BeamInputReader(const BeamInputFormat& format, std::string name)
        : m_format(format), m_name(std::move(name)) {}

    void take(std::string_view bytes, std::vector<BeamInputPoint>& points);
    /// End of input; the last line needs no line end.
    void finish(std::vector<BeamInputPoint>& points);

    /// The first parse error.
    const std::optional<Diagnostic>& problem() const { return m_problem; }
    /// Number of lines or raw points with errors.
    std::int64_t bad_count() const { return m_bad_count; }

    static constexpr std::size_t longest_line = 1000;

private:
    void take_text(std::string_view bytes, std::vector<BeamInputPoint>& points);
    void take_raw(std::string_view bytes, std::vector<BeamInputPoint>& points);
    void take_line(std::string_view line, std::vector<BeamInputPoint>& points);
    void take_frame(std::string_view frame, std::vector<BeamInputPoint>& points);
    void keep(std::string_view part);
    void pass_over(int line, std::string why);

    BeamInputFormat m_format;
    std::string m_name;
    std::string m_rest;  // start of an incomplete line or raw point
    bool m_is_too_long = false;
    std::int64_t m_number = 0;  // number of lines or raw points read
    std::int64_t m_bad_count = 0;
    std::optional<Diagnostic> m_problem;
};
