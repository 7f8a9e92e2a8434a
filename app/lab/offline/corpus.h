#pragma once

#include "lab/library/library.h"
#include "model/look/extent.h"

#include <filesystem>
#include <string>
#include <vector>

/// How far one file of a collection of looks came, and what it took.
struct CorpusTrial {
    std::filesystem::path file;
    bool is_parsed = false;    // its texts were read
    bool is_compiled = false;  // glslang took its shaders
    bool is_linked = false;    // the driver took them, and its pictures were read
    bool has_drawn = false;    // without an error of the driver
    std::size_t passes = 0;
    std::size_t parameters = 0;
    std::size_t images = 0;
    double read_ms = 0.0;   // texts and glslang
    double link_ms = 0.0;   // with the context's start
    double first_ms = 0.0;  // frame; where drivers make their code
    double frame_ms = 0.0;  // the last one
    Diagnostics warnings;
    std::string why;  // it came no further; "": it has drawn, or nothing further was asked
};

/// What is asked of each file.
struct CorpusTask {
    Extent size{320, 240};
    int frames = 4;  // 0: nothing is drawn, and no GL is needed
};

/// Tries one file in this process.
CorpusTrial try_look(const std::filesystem::path& file, const CorpusTask& task,
                     const Library& library);

/// Which files of a folder are tried.
struct CorpusChoice {
    std::string only;  // a part of their paths that they must have
    int sample = 0;    // so many by chance; 0: all
    int seed = 0;      // another one draws others
};

/// The looks of other programs in a folder and below, by name; hidden folders are left out.
std::vector<std::filesystem::path> corpus_files(const std::filesystem::path& folder,
                                                const CorpusChoice& choice);
