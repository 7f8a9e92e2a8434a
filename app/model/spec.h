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

/// Reads "kind" or "kind:key=value,key=value"; the first setting may be a bare word, kept under the
/// key "" (`text:HELLO`, `audio:song.wav,mode=xy`). Only the grammar is checked.
Result<Spec> parse_spec(std::string_view text);

/// The text that parse_spec reads as the same spec.
std::string to_string(const Spec& spec);
