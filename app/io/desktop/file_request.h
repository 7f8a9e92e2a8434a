#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// A named group of file names that a dialog lists.
struct FileGroup {
    std::string label;                         // "Pictures"
    std::vector<std::string> extensions = {};  // ".png"; empty: all files

    bool operator==(const FileGroup&) const = default;
};

/// What a file dialog of the desktop is to choose.
struct FileRequest {
    enum class Kind { open, save };

    Kind kind = Kind::open;
    std::string title;
    std::vector<FileGroup> groups = {};  // the first one is selected
    std::filesystem::path folder = {};   // listed first; "": the desktop's choice
    std::string name = {};               // proposed for saving
    std::uint64_t parent_window = 0;     // the X11 window that the dialog belongs to; 0: none
};

/// How a file dialog of the desktop ended.
struct FileReply {
    enum class Kind { chosen, cancelled, failed };

    Kind kind = Kind::cancelled;
    std::vector<std::filesystem::path> files = {};
    std::string problem = {};  // why it failed

    bool operator==(const FileReply&) const = default;
};
