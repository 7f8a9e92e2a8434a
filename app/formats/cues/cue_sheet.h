#pragma once

#include "base/diagnostic.h"
#include "model/tuning/cue.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A line of a cue file.
struct CueLine {
    std::string text;        // without "\n"
    std::optional<Cue> cue;  // nullopt: empty or a comment

    bool operator==(const CueLine&) const = default;
};

/// A cue file: one cue per line, such as `1:23.5 preset "Amber P3" morph 2`. Empty lines and
/// comments (#) are kept. The order of the lines does not matter.
class CueSheet {
public:
    const std::vector<CueLine>& lines() const { return m_lines; }
    /// The text of the file. Lines that were not edited are unchanged.
    std::string text() const;

    /// The number of the line, from 1.
    using LineNumber = std::size_t;
    /// Inserts a line before the first cue that is later.
    void add(const Cue& cue);
    /// Rewrites a line; a comment at its end stays.
    void change(LineNumber line, const Cue& cue);
    void remove(LineNumber line);

private:
    friend Result<CueSheet> parse_cue_sheet(std::string_view, const std::filesystem::path&);

    std::vector<CueLine> m_lines;
    bool m_has_returns = false;  // lines end with "\r\n"
    bool m_ends_with_line_end = true;
};

/// Reads a cue file. All errors, each with its line: unknown commands, invalid times and numbers,
/// missing names. At most 10,000 lines.
Result<CueSheet> parse_cue_sheet(std::string_view text, const std::filesystem::path& file);

/// Parses one line of a cue file. A comment at its end is ignored. Errors have no line number.
Result<Cue> parse_cue(std::string_view line);

/// "1:23.5 preset "Amber P3" morph 2".
std::string cue_text(const Cue& cue);
/// "1:23.5", "1:02:03", with up to three decimals.
std::string cue_time_text(double seconds);
/// Minutes, or hours and minutes, before seconds: "83.5", "1:23.5", "1:02:03.25".
std::optional<double> parse_cue_time(std::string_view text);
