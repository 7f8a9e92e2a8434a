#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

/// The fields of the export dialog, as typed or chosen. "" is the default of a field.
struct ExportForm {
    std::string file;              // name or whole path
    std::filesystem::path folder;  // of a name without a path
    std::string size = "";         // "": the render size; a name such as "1080p", or "640x480"
    bool has_own_size = false;     // the size is typed
    std::string start = "0";       // s
    std::string length = "";       // s
    std::string fps = "60";
    std::string quality = "";
    std::string codec = "";
    std::string sound = "";
    bool keeps_alpha = false;
    std::size_t hdr = 0;      // index in hdr_choices()
    std::string paper_white;  // cd/m2
    std::string peak;         // cd/m2
    bool loops = false;
    bool has_subframes = false;  // each sub-frame is a frame

    bool operator==(const ExportForm&) const = default;
};

/// The fields of the dialog that saves a picture.
struct StillForm {
    std::string file;
    std::filesystem::path folder;
    std::string size = "1x";  // one of still_sizes()
    int format = 0;           // index in still_formats()

    bool operator==(const StillForm&) const = default;
};

/// The fields of the dialog that sends a look to a running program.
struct SendForm {
    std::size_t program = 0;                       // index of running_programs()
    std::map<std::string, std::string> addresses;  // typed, by the program's name
    bool follows = false;                          // send after each edit

    bool operator==(const SendForm&) const = default;
};

/// The fields of the dialog that exports a look.
struct LookExportForm {
    std::string file;
    std::filesystem::path folder;
    std::size_t target = 1;  // index of export_targets(): a web page
    bool verifies = true;

    bool operator==(const LookExportForm&) const = default;
};
