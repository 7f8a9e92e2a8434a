#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <filesystem>
#include <string>
#include <string_view>

/// What the module of the picture formats does (app/pictures/). It is no part of the program: the
/// library behind it brings more than 200 others, and to load them takes longer than all else that
/// a start does. Nothing of these throws.
struct PictureCodec {
    /// A file whose format has this name (picture_kind); sizes, channels, alpha and turning as
    /// load_picture says.
    Result<Picture> (*read)(const std::filesystem::path& file, const std::string& kind);

    /// The bytes of an EXR of the stored values, 16-bit floats where `half`; errors carry no file.
    Result<std::string> (*encode_exr)(const Picture& picture, bool half);
    /// The same with the floats that the picture has, half or whole ones; not for bytes.
    Result<std::string> (*encode_raw_exr)(const RawPicture& picture);

    /// The bytes of an SVG, which may be compressed, as librsvg and Cairo draw them: an SVG of
    /// paths in absolute M, L, C and Z alone, what is not painted left out. Before it stands a line
    /// with the transform of its coordinates to those of the file's page. Only files in the folder
    /// of `file` or below are read. Bounds: 5 s, 1 GB, 256 MB of paths.
    Result<std::string> (*svg_paths)(std::string_view bytes, const std::filesystem::path& file);
};

/// Loads the module at the first call, 0.3 s; from any thread. The error says why it cannot be.
Result<const PictureCodec*> picture_codec();

/// What the module exports, and under which name.
extern "C" const PictureCodec* afterglow_picture_codec();
constexpr const char* picture_codec_symbol = "afterglow_picture_codec";
constexpr const char* picture_codec_file = "afterglow-pictures.so";
