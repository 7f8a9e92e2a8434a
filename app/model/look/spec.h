#pragma once

#include "base/diagnostic.h"

#include <map>
#include <string>
#include <variant>

/// A signal or test pattern asked for by kind and settings: "lissajous:x=3,y=2".
/// What the kinds and their settings mean is the business of signals/.
struct Spec {
    using Setting = std::variant<double, std::string>;

    std::string kind;
    std::map<std::string, Setting> settings;

    bool operator==(const Spec&) const = default;
};

/// Whether a kind has a setting of that name.
using HasSetting = bool (*)(std::string_view kind, std::string_view key);

/// Reads "kind" or "kind:key=value,key=value"; the first setting may be a bare text, kept under the
/// key "" (`text:HELLO`, `audio:song.wav,mode=xy`). Its commas belong to it up to the first
/// `,key=value`. A value may stand in quotes: "..." with \" and \\ for these signs. `has_setting`
/// tells `a=b.wav`, a file, from a setting; null: both are settings. Only the grammar is checked.
Result<Spec> parse_spec(std::string_view text, HasSetting has_setting = nullptr);

/// The text that parse_spec reads as the same spec.
std::string to_string(const Spec& spec);
