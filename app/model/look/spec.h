#pragma once

#include "base/diagnostic.h"

#include <map>
#include <string>
#include <variant>

/// A signal or test pattern, given by its kind and settings: "lissajous:x=3,y=2". The kinds and
/// settings are defined in signals/.
struct Spec {
    using Setting = std::variant<double, std::string>;

    std::string kind;
    std::map<std::string, Setting> settings;

    bool operator==(const Spec&) const = default;
};

/// Whether a kind has a setting with this name.
using HasSetting = bool (*)(std::string_view kind, std::string_view key);

/// Parses "kind" or "kind:key=value,key=value". The first setting may be a bare text (`text:HELLO`,
/// `audio:song.wav,mode=xy`), stored with the key "". It includes its commas up to the first
/// `,key=value`. A value may be in quotes: "..." with \" and \\ for these characters. `has_setting`
/// distinguishes a file `a=b.wav` from a setting; null: both are settings. Checks only the grammar.
Result<Spec> parse_spec(std::string_view text, HasSetting has_setting = nullptr);

/// Formats a spec so that parse_spec reads the same spec.
std::string to_string(const Spec& spec);
