#pragma once

#include "base/diagnostic.h"
#include "model/look/extent.h"
#include "model/picture/hdr.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The quality setting of a picture codec. With CRF and ProRes, lower numbers are better.
struct FilmQuality {
    std::string option = {};   // of ffmpeg; "": the codec has no quality setting
    std::string measure = {};  // what the number is: "CRF"
    int best = 0;
    int worst = 0;
    int usual = 0;
};

/// How a film's pictures can be stored: one row of film_codecs().
struct FilmCodec {
    std::string name;                  // on the command line
    std::string label;                 // in the window
    std::vector<std::string> endings;  // of the files that can hold it, most suitable first
    std::string pixels;                // ffmpeg's pixel format
    std::string alpha_pixels = {};     // the same with alpha; "": it has no alpha
    int bits = 8;                      // per channel
    std::vector<std::string> encoder;  // ffmpeg's arguments
    FilmQuality quality = {};
    bool is_lossless = false;
    bool needs_even_sides = false;  // stores colour for 2 x 2 pixels
    int min_side = 1;               // px
};

/// How a film's sound can be stored: one row of sound_codecs().
struct SoundCodec {
    std::string name;
    std::string label;
    std::vector<std::string> endings;
    std::vector<std::string> encoder;
    bool is_lossless = false;
    /// Samples that the encoder gets before the film's start, where its output is not used. An AAC
    /// encoder that starts in a loud sound overshoots by up to 3 dB in its first blocks.
    int lead_in = 0;
};

/// A kind of film file: one row of film_containers().
struct FilmContainer {
    std::string ending;              // ".mp4"
    std::vector<std::string> muxer;  // ffmpeg's arguments
    std::string codec;               // the default
    std::string alpha_codec = {};    // the default with alpha; "": it can't hold alpha
    std::string hdr_codec = {};      // the default with HDR; "": as without
    std::string sound = {};          // the default; "": it can't hold sound
    bool is_still = false;           // one picture only
};

const std::vector<FilmCodec>& film_codecs();
const std::vector<SoundCodec>& sound_codecs();
const std::vector<FilmContainer>& film_containers();

/// The name of the sound codec for a film without sound.
inline constexpr const char* no_sound = "none";

/// The signal of a film for HDR displays: BT.2020 colours, BT.2100.
struct FilmHdr {
    HdrTransfer transfer = HdrTransfer::pq;
    HdrLight light = {};

    bool operator==(const FilmHdr&) const = default;
};

/// What the user chose for a film; the rest is the default of its file type.
struct FilmChoice {
    std::string codec = {};  // "": default
    std::string sound = {};  // "": default; no_sound: without
    std::optional<double> quality = std::nullopt;
    bool keeps_alpha = false;
    std::optional<FilmHdr> hdr = std::nullopt;

    bool operator==(const FilmChoice&) const = default;
};

/// How a film is encoded.
struct FilmEncoding {
    const FilmContainer* container;
    const FilmCodec* codec;
    const SoundCodec* sound = nullptr;  // null: no sound
    double quality = 0.0;
    bool keeps_alpha = false;
    std::optional<FilmHdr> hdr = std::nullopt;

    /// Of the pictures that the encoder gets: 3 or 4, and 8 or 16.
    int channels() const { return keeps_alpha ? 4 : 3; }
    int bits() const { return codec->bits > 8 ? 16 : 8; }
};

/// The encoding for a file with this name. Errors have no file and name what fits: "'.mp4' can't
/// hold FFV1. Use .mkv."
Result<FilmEncoding> film_encoding(const std::filesystem::path& file, const FilmChoice& choice);

/// Fails if pictures of this size are too small for the codec.
Result<void> check_film_extent(const FilmEncoding& encoding, Extent extent);

/// The codecs that a file with this name can hold, and its sound codecs.
std::vector<const FilmCodec*> codecs_for(const std::filesystem::path& file);
std::vector<const SoundCodec*> sound_codecs_for(const std::filesystem::path& file);

/// Whether the extension is that of a film that can be written.
bool is_film_name(const std::filesystem::path& file);
/// Their extensions: ".mp4, .mov, .mkv, .webm or .gif".
std::vector<std::string> film_endings();
