#pragma once

#include "model/look/look.h"
#include "model/tuning/modulation.h"

#include <optional>
#include <string>

/// Values for a look's parameters, and the signal or source they were judged on.
struct Preset {
    std::string look;    // id, or "a+b"
    std::string digest;  // look_digest at the time of saving; "": not known
    std::string name;
    std::string about;
    std::string author;
    std::optional<Spec> signal;
    std::string source;        // "pattern:smpte", a picture's path, or "": the look's own
    std::string media_digest;  // of the person's file that signal or source names; "": none
    Values values;             // what differs from the defaults, orphans included
    std::vector<std::string> bypass = {};  // keys of the looks of a stack that draw nothing
    Modulations modulations = {};          // what moves by itself, orphans included

    bool operator==(const Preset&) const = default;
};

/// What a person is told when a preset was made for another state of the look; empty when all fits.
Diagnostics compare_with_look(const Preset& preset, const Look& look,
                              const std::filesystem::path& file);
