#pragma once

#include "model/look/look.h"
#include "model/tuning/modulation.h"

#include <optional>
#include <string>

/// Values for a look's parameters, and the signal or source they were tuned with.
struct Preset {
    std::string look;    // id, or "a+b"
    std::string digest;  // look_digest when saved; "": unknown
    std::string name;
    std::string about;
    std::string author;
    std::optional<Spec> signal;
    std::string source;        // "pattern:smpte", the path of a picture, or "": the look's default
    std::string media_digest;  // of the user's file in `signal` or `source`; "" without one
    Values values;             // values that differ from the defaults, including orphans
    std::vector<std::string> bypass = {};  // keys of a stack's looks that are not drawn
    Modulations modulations = {};          // including orphans
    std::optional<Tempo> tempo = {};       // of modulations in beats; nullopt: the current one

    bool operator==(const Preset&) const = default;
};

/// Warnings if a preset was made for another version of the look; empty if it fits.
Diagnostics compare_with_look(const Preset& preset, const Look& look,
                              const std::filesystem::path& file);
