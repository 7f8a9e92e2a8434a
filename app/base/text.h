#pragma once

#include "base/diagnostic.h"
#include "base/line_map.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The origin of line `line` (from 1) of an assembled text; the last origin if past the end.
Location origin_of(const LineMap& lines, int line);

/// The lines of a text without line ends; "\r\n" and "\n" both end a line.
std::vector<std::string_view> split_lines(std::string_view text);

/// Pieces between single separators, including empty pieces.
std::vector<std::string_view> split(std::string_view text, char separator);

std::string_view trim(std::string_view text);

/// A whole text parsed as a decimal number, with "." as the decimal point in every locale; never
/// infinite or NaN.
std::optional<double> parse_number(std::string_view text);
std::optional<int> parse_integer(std::string_view text);

/// The shortest decimal text that parses to the same number.
std::string format_number(double number);

/// As format_number, for a 32-bit float: 0.92, not 0.9200000166893005.
std::string format_float(float number);

/// The text with each `from` (not empty) replaced by `to`.
std::string replace_all(std::string_view text, std::string_view from, std::string_view to);

/// ASCII letters in lower case; other bytes unchanged.
std::string to_lower(std::string_view text);

/// A readable label: "scanline_strength" becomes "Scanline strength".
std::string label_from_name(std::string_view name);

/// The candidate with an edit distance of at most a third of the name's length; otherwise the first
/// that begins with the name. The name itself is skipped. For "did you mean".
std::optional<std::string> find_similar(std::string_view name,
                                        const std::vector<std::string>& candidates);

/// " (did you mean 'decay'?)", or "".
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// Both texts as sentences, each with a full stop: "file not found. 'noise' shows black."
std::string with_sentence(std::string text, std::string_view sentence);

/// A digest for comparing texts (FNV-1a, 64 bit); not for secrets.
std::uint64_t digest_of(std::string_view bytes);
