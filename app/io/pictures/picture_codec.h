#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <filesystem>
#include <string>
#include <string_view>

/// The functions of the picture module (app/pictures/). It is not linked to the program: its
/// library loads more than 200 others, which takes longer than the rest of the start. None of the
/// functions throws.
struct PictureCodec {
    /// Reads a file of the format with this name (picture_kind). Sizes, channels, alpha and
    /// orientation as in load_picture.
    Result<Picture> (*read)(const std::filesystem::path& file, const std::string& kind);

    /// The bytes of an EXR of the stored values, 16-bit floats if `half`; errors have no file.
    Result<std::string> (*encode_exr)(const Picture& picture, bool half);
    /// As encode_exr, with the picture's own float type, half or single; not for bytes.
    Result<std::string> (*encode_raw_exr)(const RawPicture& picture);

    /// Converts the bytes of an SVG, optionally compressed, to paths as librsvg and Cairo draw
    /// them. The result is an SVG with only the absolute path commands M, L, C and Z, without
    /// unpainted elements. A line before it has the transform of its coordinates to those of the
    /// file's page. Reads only files in the folder of `file` or below. Limits: 5 s, 1 GB, 256 MB of
    /// paths.
    Result<std::string> (*svg_paths)(std::string_view bytes, const std::filesystem::path& file);
};

/// Loads the module on the first call, which takes 0.3 s; thread-safe.
Result<const PictureCodec*> picture_codec();

/// The function that the module exports, its symbol and the module's file name.
extern "C" const PictureCodec* afterglow_picture_codec();
constexpr const char* picture_codec_symbol = "afterglow_picture_codec";
constexpr const char* picture_codec_file = "afterglow-pictures.so";
