#pragma once

#include "formats/portable/exact_picture.h"
#include "formats/portable/source_notice.h"
#include "model/look/look.h"
#include "model/tuning/modulation.h"
#include "signals/signal/signal.h"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// A look with its values and content, to be described for other programs.
struct PortableLook {
    const Look& look;
    const Values& values;
    const Modulations& modulations;
    Tempo tempo;         // of the modulations
    Spec signal;         // completed; only of looks driven by a signal
    SignalMedia media;   // of the signal
    std::string source;  // only of looks driven by a picture
    Extent size;         // that it was exported for
};

/// A description in files. All paths are relative to its folder and contain neither ".." nor a
/// leading "/".
struct PortableFiles {
    std::map<std::string, std::string> texts;            // JSON and GLSL, by path
    std::map<std::string, PictureFile> generated;        // generated pictures, by path
    std::map<std::string, std::filesystem::path> media;  // files to copy, by path
};

/// What a portable folder contains: the main file and folders.
inline constexpr const char* portable_file = "portable.json";
inline constexpr const char* shader_folder = "shaders";
inline constexpr const char* copies_folder = "media";
inline constexpr const char* stages_folder = "stages";

/// The notices of source files by name. Files in several folders can have the same name.
using SourceNotices = std::vector<std::pair<std::string, SourceNotice>>;

/// The path of a pass's shaders without extension.
std::string shader_stem(const Look& look, std::size_t pass);

/// The complete description, docs/portable.md: `portable.json`, each shader as GLSL 4.10, and the
/// media.
Result<PortableFiles> portable_files(const PortableLook& described, const SourceNotices& notices);
