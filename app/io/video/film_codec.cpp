#include "io/video/film_codec.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
// Small files for players.
std::vector<FilmCodec> player_codecs() {
    return {
        {.name = "h264",
         .label = "H.264",
         .endings = {".mp4", ".mov", ".mkv"},
         .pixels = "yuv420p",
         .encoder = {"-c:v", "libx264", "-preset", "medium"},
         .quality = {"-crf", "CRF", 1, 51, 18},
         .needs_even_sides = true},
        {.name = "h265",
         .label = "H.265 (10 bit)",
         .endings = {".mp4", ".mov", ".mkv"},
         .pixels = "yuv420p10le",
         .bits = 10,
         // Players of Apple need the tag.
         .encoder = {"-c:v", "libx265", "-preset", "medium", "-tag:v", "hvc1", "-x265-params",
                     "log-level=error"},
         .quality = {"-crf", "CRF", 1, 51, 20},
         .needs_even_sides = true,
         .min_side = 16},
        {.name = "av1",
         .label = "AV1 (10 bit)",
         .endings = {".mp4", ".mkv", ".webm"},
         .pixels = "yuv420p10le",
         .bits = 10,
         .encoder = {"-c:v", "libsvtav1", "-preset", "8"},
         .quality = {"-crf", "CRF", 1, 63, 28},
         .needs_even_sides = true,
         .min_side = 64},
        {.name = "vp9",
         .label = "VP9",
         .endings = {".webm", ".mkv"},
         .pixels = "yuv420p",
         .alpha_pixels = "yuva420p",
         .encoder = {"-c:v", "libvpx-vp9", "-b:v", "0", "-row-mt", "1", "-deadline", "good",
                     "-cpu-used", "4"},
         .quality = {"-crf", "CRF", 1, 63, 24}},
    };
}

// For editing and for web pages.
std::vector<FilmCodec> other_codecs() {
    return {
        {.name = "prores",
         .label = "ProRes 4444",
         .endings = {".mov", ".mkv"},
         .pixels = "yuv444p10le",
         .alpha_pixels = "yuva444p10le",
         .bits = 10,
         .encoder = {"-c:v", "prores_ks", "-profile:v", "4444", "-vendor", "apl0", "-alpha_bits",
                     "16"},
         .quality = {"-qscale:v", "quantiser", 1, 31, 6}},
        {.name = "ffv1",
         .label = "FFV1 (lossless)",
         .endings = {".mkv"},
         .pixels = "bgr0",
         .alpha_pixels = "bgra",
         .encoder = {"-c:v", "ffv1", "-level", "3", "-slicecrc", "1"},
         .is_lossless = true},
        {.name = "gif", .label = "GIF", .endings = {".gif"}, .pixels = "pal8", .encoder = {}},
        {.name = "avif",
         .label = "AVIF (10 bit)",
         .endings = {".avif"},
         .pixels = "yuv444p10le",
         .bits = 10,
         .encoder = {"-c:v", "libaom-av1", "-still-picture", "1", "-cpu-used", "6"},
         .quality = {"-crf", "CRF", 1, 63, 12}},
    };
}
}  // namespace

const std::vector<FilmCodec>& film_codecs() {
    static const std::vector<FilmCodec> codecs = [] {
        std::vector<FilmCodec> all = player_codecs();
        for (FilmCodec& codec : other_codecs())
            all.push_back(std::move(codec));
        return all;
    }();
    return codecs;
}

const std::vector<SoundCodec>& sound_codecs() {
    static const std::vector<SoundCodec> codecs{
        {.name = "aac",
         .label = "AAC",
         .endings = {".mp4", ".mov"},
         .encoder = {"-c:a", "aac", "-b:a", "320k"},
         .lead_in = 8192},
        {.name = "flac",
         .label = "FLAC (lossless)",
         .endings = {".mkv"},
         .encoder = {"-c:a", "flac", "-sample_fmt", "s32", "-bits_per_raw_sample", "24"},
         .is_lossless = true},
        {.name = "pcm",
         .label = "PCM (lossless)",
         .endings = {".mov", ".mkv"},
         .encoder = {"-c:a", "pcm_f32le"},
         .is_lossless = true},
        // Opus starts before the sound, for which WebM has a field. With additional negative
        // timestamps, ffmpeg 5 shows the pictures too late by that time.
        {.name = "opus",
         .label = "Opus",
         .endings = {".webm"},
         .encoder = {"-c:a", "libopus", "-b:a", "256k", "-bsf:a",
                     "setts=pts=PTS-STARTPTS:dts=DTS-STARTDTS"}},
    };
    return codecs;
}

const std::vector<FilmContainer>& film_containers() {
    static const std::vector<FilmContainer> containers{
        {.ending = ".mp4",
         .muxer = {"-movflags", "+faststart", "-f", "mp4"},
         .codec = "h264",
         .hdr_codec = "h265",
         .sound = "aac"},
        {.ending = ".mov",
         .muxer = {"-movflags", "+faststart", "-f", "mov"},
         .codec = "h264",
         .alpha_codec = "prores",
         .hdr_codec = "h265",
         .sound = "pcm"},
        {.ending = ".mkv",
         .muxer = {"-f", "matroska"},
         .codec = "h264",
         .alpha_codec = "ffv1",
         .hdr_codec = "h265",
         .sound = "flac"},
        {.ending = ".webm",
         .muxer = {"-f", "webm"},
         .codec = "vp9",
         .alpha_codec = "vp9",
         .hdr_codec = "av1",
         .sound = "opus"},
        {.ending = ".gif", .muxer = {"-f", "gif"}, .codec = "gif"},
        {.ending = ".avif", .muxer = {"-f", "avif"}, .codec = "avif", .is_still = true},
    };
    return containers;
}

namespace {
template <class Row>
std::vector<std::string> names_of(const std::vector<Row>& rows) {
    std::vector<std::string> names;
    for (const Row& row : rows)
        names.push_back(row.name);
    return names;
}

template <class Row>
const Row* find_row(const std::vector<Row>& rows, const std::string& name) {
    const auto found = std::ranges::find(rows, name, &Row::name);
    return found == rows.end() ? nullptr : &*found;
}

std::string ending_of(const fs::path& file) {
    return to_lower(file.extension().string());
}

const FilmContainer* find_container(const fs::path& file) {
    const auto& rows = film_containers();
    const auto found = std::ranges::find(rows, ending_of(file), &FilmContainer::ending);
    return found == rows.end() ? nullptr : &*found;
}

std::string joined(const std::vector<std::string>& words) {
    if (words.size() < 2)
        return words.empty() ? "" : words.front();
    return fmt::format("{} or {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

template <class Row>
bool holds(const FilmContainer& container, const Row& row) {
    return std::ranges::find(row.endings, container.ending) != row.endings.end();
}

// The row with this name, if the container can hold it.
template <class Row>
Result<const Row*> row_for(const FilmContainer& container, const std::vector<Row>& rows,
                           const std::string& name, const char* what) {
    const std::vector<std::string> names = names_of(rows);
    const Row* const row = find_row(rows, name);
    if (!row) {
        const std::string near = did_you_mean(name, names);
        return fail({{},
                     0,
                     fmt::format("unknown {} '{}'{}", what, name,
                                 near.empty() ? fmt::format(": use {}", joined(names)) : near)});
    }
    if (!holds(container, *row))
        return fail({{},
                     0,
                     fmt::format("'{}' can't hold {}. Use {}.", container.ending, row->label,
                                 joined(row->endings))});
    return row;
}

// HDR needs 10 bits.
Result<void> check_hdr(const FilmContainer& container, const FilmCodec& codec,
                       const FilmChoice& choice) {
    if (!choice.hdr)
        return {};
    if (codec.bits < 10)
        return fail({{},
                     0,
                     fmt::format("{} in '{}' has only {} bits, but HDR needs 10. Use .mp4 with "
                                 "H.265.",
                                 codec.label, container.ending, codec.bits)});
    return {};
}

Result<const FilmCodec*> codec_for(const FilmContainer& container, const FilmChoice& choice) {
    std::string name = choice.codec;
    if (name.empty() && choice.hdr && !container.hdr_codec.empty())
        name = container.hdr_codec;
    if (name.empty())
        name = choice.keeps_alpha && !container.alpha_codec.empty() ? container.alpha_codec
                                                                    : container.codec;
    auto codec = row_for(container, film_codecs(), name, "codec");
    if (!codec || !choice.keeps_alpha || !(*codec)->alpha_pixels.empty())
        return codec;
    std::vector<std::string> able;
    for (const FilmContainer& other : film_containers())
        if (!other.alpha_codec.empty())
            able.push_back(fmt::format("{} ({})", other.ending,
                                       find_row(film_codecs(), other.alpha_codec)->label));
    return fail({{},
                 0,
                 fmt::format("{} in '{}' has no transparency. Use {}.", (*codec)->label,
                             container.ending, joined(able))});
}

Result<const SoundCodec*> sound_for(const FilmContainer& container, const FilmChoice& choice) {
    if (choice.sound == no_sound || (choice.sound.empty() && container.sound.empty()))
        return nullptr;
    if (container.sound.empty())
        return fail({{}, 0, fmt::format("'{}' can't hold sound", container.ending)});
    return row_for(container, sound_codecs(), choice.sound.empty() ? container.sound : choice.sound,
                   "sound codec");
}

Result<double> quality_for(const FilmCodec& codec, const std::optional<double>& chosen) {
    const FilmQuality& quality = codec.quality;
    if (!chosen)
        return quality.usual;
    if (quality.option.empty())
        return fail({{},
                     0,
                     fmt::format("{} has no quality setting{}", codec.label,
                                 codec.is_lossless ? ": it keeps every pixel" : "")});
    if (*chosen >= quality.best && *chosen <= quality.worst)
        return *chosen;
    return fail(
        {{},
         0,
         fmt::format("the quality of {} is {} to {} ({}, lower is better), got {}", codec.label,
                     quality.best, quality.worst, quality.measure, format_number(*chosen))});
}
}  // namespace

Result<FilmEncoding> film_encoding(const fs::path& file, const FilmChoice& choice) {
    const FilmContainer* const container = find_container(file);
    if (!container)
        return fail({{},
                     0,
                     fmt::format("video files must end in {}, got '{}'", joined(film_endings()),
                                 file.filename().string())});
    if (choice.hdr && choice.keeps_alpha)
        return fail({{}, 0, "HDR videos have no transparency. Leave out one of both."});
    const auto codec = codec_for(*container, choice);
    if (!codec)
        return fail(codec.error());
    if (const auto fits = check_hdr(*container, **codec, choice); !fits)
        return fail(fits.error());
    const auto sound = sound_for(*container, choice);
    if (!sound)
        return fail(sound.error());
    const auto quality = quality_for(**codec, choice.quality);
    if (!quality)
        return fail(quality.error());
    return FilmEncoding{container, *codec, *sound, *quality, choice.keeps_alpha, choice.hdr};
}

Result<void> check_film_extent(const FilmEncoding& encoding, Extent extent) {
    const FilmCodec& codec = *encoding.codec;
    if (extent.width >= codec.min_side && extent.height >= codec.min_side)
        return {};
    return fail({{},
                 0,
                 fmt::format("{} needs at least {} x {} px, got {} x {}", codec.label,
                             codec.min_side, codec.min_side, extent.width, extent.height)});
}

namespace {
template <class Row>
std::vector<const Row*> held_by(const fs::path& file, const std::vector<Row>& rows) {
    const FilmContainer* const container = find_container(file);
    std::vector<const Row*> held;
    for (const Row& row : rows)
        if (container && holds(*container, row))
            held.push_back(&row);
    return held;
}
}  // namespace

std::vector<const FilmCodec*> codecs_for(const fs::path& file) {
    return held_by(file, film_codecs());
}

std::vector<const SoundCodec*> sound_codecs_for(const fs::path& file) {
    return held_by(file, sound_codecs());
}

bool is_film_name(const fs::path& file) {
    const FilmContainer* const container = find_container(file);
    return container && !container->is_still;
}

std::vector<std::string> film_endings() {
    std::vector<std::string> endings;
    for (const FilmContainer& container : film_containers())
        if (!container.is_still)
            endings.push_back(container.ending);
    return endings;
}
