#pragma once

#include "base/diagnostic.h"
#include "base/line_map.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The place where line `line` (from 1) of an assembled text was written; past the end the last
/// one.
Location origin_of(const LineMap& lines, int line);

/// The lines of a text without their ends; "\r\n" and "\n" both end a line.
std::vector<std::string_view> split_lines(std::string_view text);

/// Pieces between single separators; empty pieces are kept.
std::vector<std::string_view> split(std::string_view text, char separator);

std::string_view trim(std::string_view text);

/// A whole text read as a decimal number, "." as the decimal point in every locale; never infinite
/// or NaN.
std::optional<double> parse_number(std::string_view text);
std::optional<int> parse_integer(std::string_view text);

/// The shortest decimal text that reads back as the same number.
std::string format_number(double number);

/// As format_number, for a value that is kept as a 32-bit float: 0.92, not 0.9200000166893005.
std::string format_float(float number);

/// The text with `to` in each place of `from`, which is not empty.
std::string with_each(std::string_view text, std::string_view from, std::string_view to);

/// Lower-case ASCII letters, all else as it is.
std::string to_lower(std::string_view text);

/// "scanline_strength" as a person reads it: "Scanline strength".
std::string label_from_name(std::string_view name);

/// Of the other candidates, the one that is at most a third of its letters away, else the first
/// that begins with the name; to say "did you mean".
std::optional<std::string> find_similar(std::string_view name,
                                        const std::vector<std::string>& candidates);

/// " (did you mean 'decay'?)", or nothing.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// Both texts as sentences, each with its full stop: "file not found. 'noise' shows black."
std::string with_sentence(std::string text, std::string_view sentence);

/// A digest of bytes for telling texts apart (FNV-1a, 64 bit); not for secrets.
std::uint64_t digest_of(std::string_view bytes);
