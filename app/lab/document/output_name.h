#pragma once

#include "lab/document/document.h"
#include "model/devices/date.h"

#include <filesystem>
#include <functional>
#include <string>

/// The default name of an exported file without its ending: look, preset and date, such as
/// "phosphor-amber-p3-2026-11-26". Only letters that every file system takes.
std::string output_stem(const Document& document, const Date& date);

/// Whether something else is going to write a file.
using IsTaken = std::function<bool(const std::filesystem::path&)>;

/// A name in the folder that neither a file nor an image sequence has, and that is not taken:
/// STEM.ENDING, or with -2, -3, … after the stem.
std::string unused_name(
    const std::filesystem::path& folder, const std::string& stem, const std::string& ending,
    const IsTaken& is_taken = [](const std::filesystem::path&) { return false; });

/// The folder of the last file, or the current one if it no longer exists.
std::filesystem::path usual_folder(const std::filesystem::path& last);

/// Whether a typed text is a whole path, so that no folder is used.
bool has_own_folder(const std::string& text);

/// The file of a typed name or path: "~" is the home folder, a name is in `folder`.
std::filesystem::path typed_file(const std::string& text, const std::filesystem::path& folder);
