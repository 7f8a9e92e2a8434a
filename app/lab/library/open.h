#pragma once

#include "formats/look_format.h"
#include "lab/library/library.h"
#include "model/preset/preset.h"

#include <optional>
#include <string>

/// What a person named on the command line or chose in the window, found but not yet read.
struct OpenRequest {
    std::filesystem::path look;    // folder or manifest
    std::optional<Preset> preset;  // to be applied to it
    std::filesystem::path preset_file;
    Stack stack = {};       // instead of `look`: several looks, or one with its settings
    Values constants = {};  // what numbers in its texts are turned to, before those of the preset
    bool brings_content = false;  // the preset's own signal or source, also where one is locked

    bool operator==(const OpenRequest&) const = default;
};

/// The looks that a request names.
Stack stack_of(const OpenRequest& request);

/// What is known of its parameters before it is read.
Values values_of(const OpenRequest& request);

/// Finds what `argument` means: a look's folder, manifest or name, or several joined by '+'; a
/// preset's file, PNG or line.
/// Errors say what was looked for and what is nearest.
Result<OpenRequest> resolve(const std::string& argument, const Library& library);

/// A preset of the look by name, file, PNG or line.
Result<OpenRequest> resolve_preset(const std::string& argument, const std::string& look,
                                   const Library& library);

/// As its folders are called: "crt", "phosphor+crt".
std::string name_of(const OpenRequest& request);

/// Reads the look or stack that a request names. As load_look.
LoadedLook load_requested(const OpenRequest& request, const Library& library,
                          const ReadingHelp& help = {});
