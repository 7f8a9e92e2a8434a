#pragma once

#include "lab/library/library.h"
#include "model/look/extent.h"

#include <filesystem>
#include <string>
#include <vector>

/// The result and cost of testing one file of a collection of looks.
struct CorpusResult {
    std::filesystem::path file;
    bool is_parsed = false;    // its texts were read
    bool is_compiled = false;  // glslang accepted its shaders
    bool is_linked = false;    // the driver linked them, and images were read
    bool has_drawn = false;    // without a driver error
    std::size_t passes = 0;
    std::size_t parameters = 0;
    std::size_t images = 0;
    double read_ms = 0.0;   // texts and glslang
    double link_ms = 0.0;   // including the context's creation
    double first_ms = 0.0;  // first frame, where drivers compile
    double frame_ms = 0.0;  // last frame
    Diagnostics warnings;
    std::string why;  // the error; "": drawn, or drawing was not requested
};

/// The test of each file.
struct CorpusTask {
    Extent size{320, 240};
    int frames = 4;  // 0: not drawn, works without GL
};

/// Tests a file in this process.
CorpusResult try_look(const std::filesystem::path& file, const CorpusTask& task,
                      const Library& library);

/// The selection of files in a folder.
struct CorpusChoice {
    std::string only;  // required part of the path
    int sample = 0;    // number of random files; 0: all
    int seed = 0;      // random seed
};

/// The foreign looks in a folder and its subfolders, by name, without hidden folders.
std::vector<std::filesystem::path> corpus_files(const std::filesystem::path& folder,
                                                const CorpusChoice& choice);
