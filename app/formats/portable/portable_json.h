#pragma once

#include "formats/portable/source_notice.h"
#include "model/look/look.h"
#include "model/tuning/modulation.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// A look with its values and content, to be described for other programs.
struct PortableLook {
    const Look& look;
    const Values& values;
    const Modulations& modulations;
    Spec signal;         // completed; only of looks driven by a signal
    std::string source;  // only of looks driven by a picture
    Extent size;         // that it was exported for
};

/// A description in files. All paths are relative to its folder and contain neither ".." nor a
/// leading "/".
struct PortableFiles {
    std::map<std::string, std::string> texts;            // contents by path
    std::map<std::string, std::filesystem::path> media;  // files to copy, by path
};

/// The name of the main file.
inline constexpr const char* portable_file = "portable.json";

/// The complete description, docs/portable.md: `portable.json`, each shader as GLSL 4.10, and the
/// media. `notices` are those of the look's source files, by file name.
PortableFiles portable_files(const PortableLook& described,
                             const std::map<std::string, SourceNotice>& notices);
