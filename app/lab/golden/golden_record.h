#pragma once

#include "base/diagnostic.h"
#include "lab/golden/golden_bounds.h"
#include "model/look/extent.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

/// A driver as GL reports it.
struct GoldenDriver {
    std::string vendor;
    std::string renderer;
    std::string version;

    bool operator==(const GoldenDriver&) const = default;
};

/// "llvmpipe (LLVM 15.0.6, 256 bits), Mesa, 4.5 (Core Profile) Mesa 22.3.6".
std::string to_string(const GoldenDriver& driver);

/// How a golden picture was drawn.
struct GoldenPicture {
    Extent size;
    int frames = 1;
    std::optional<GoldenDriver> driver = {};  // nullopt: that of the record

    bool operator==(const GoldenPicture&) const = default;
};

/// The contents of golden.json, next to the golden pictures.
struct GoldenRecord {
    GoldenBounds bounds;
    Extent size{320, 180};           // of new pictures
    std::optional<int> frames = {};  // of new pictures; nullopt: as GoldenDrawer::draw
    GoldenDriver driver;             // that drew the pictures
    std::map<std::string, GoldenPicture> pictures = {};  // by name

    bool operator==(const GoldenRecord&) const = default;
};

/// "320x180".
std::string dimensions_text(Extent size);

/// Errors have the line. Names of pictures can't lead out of the folder.
Result<GoldenRecord> parse_golden_record(std::string_view text, const std::filesystem::path& file);
/// The defaults, without pictures, if the file does not exist.
Result<GoldenRecord> load_golden_record(const std::filesystem::path& file);
std::string golden_record_text(const GoldenRecord& record);
