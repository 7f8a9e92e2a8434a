#pragma once

#include "formats/look_format.h"
#include "lab/library/library.h"
#include "model/preset/preset.h"

#include <optional>
#include <string>

/// A resolved argument of the command line or choice in the window, not yet read.
struct OpenRequest {
    std::filesystem::path look;    // folder or manifest
    std::optional<Preset> preset;  // to apply
    std::filesystem::path preset_file;
    Stack stack = {};             // instead of `look`: several looks, or one with settings
    Values constants = {};        // values of the constants in its texts; the preset overrides them
    bool brings_content = false;  // uses the preset's signal or source even if the user's is locked

    bool operator==(const OpenRequest&) const = default;
};

/// The looks of a request.
Stack stack_of(const OpenRequest& request);

/// The known parameter values before the look is read.
Values values_of(const OpenRequest& request);

/// Resolves a look's folder, manifest or name, several looks joined by '+', or a preset's file, PNG
/// or line. Errors name the missing item and the nearest match.
Result<OpenRequest> resolve(const std::string& argument, const Library& library);

/// A preset of the look by file name, displayed name, file, PNG or line.
Result<OpenRequest> resolve_preset(const std::string& argument, const std::string& look,
                                   const Library& library);

/// The names of its folders: "crt", "phosphor+crt".
std::string name_of(const OpenRequest& request);

/// Reads the look or stack of a request. Like load_look().
LoadedLook load_requested(const OpenRequest& request, const Library& library,
                          const LoadOptions& help = {});

/// The extensions of files that may be looks or presets, lower case.
std::vector<std::string> look_extensions();
/// The formats of other programs, for --help.
std::string other_programs();
