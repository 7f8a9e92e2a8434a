#include "cli/film_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
std::string codec_list() {
    std::vector<std::string> texts;
    for (const FilmCodec& codec : film_codecs())
        if (codec.endings.front() != ".avif")
            texts.push_back(fmt::format("{} ({})", codec.name, fmt::join(codec.endings, " ")));
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string sound_codec_list() {
    std::vector<std::string> texts;
    for (const SoundCodec& codec : sound_codecs())
        texts.push_back(fmt::format("{} ({})", codec.name, fmt::join(codec.endings, " ")));
    return fmt::format("{}, {}", fmt::join(texts, ", "), no_sound);
}

constexpr const char* hlg = "hlg";
}  // namespace

void FilmOptions::add_to(Options& options, Hdr hdr) {
    options.add("--codec NAME", m_choice.codec,
                fmt::format("Picture codec of a video: {} (default: by file type)", codec_list()));
    options
        .add("--quality N", m_quality,
             "Quality of the picture codec; lower is better: 1 to 51 (h264, h265), 1 to 63 (av1, "
             "vp9), 1 to 31 (prores)")
        .between(0.001, 1000.0);
    options.add(
        "--audio-codec NAME", m_choice.sound,
        fmt::format("Sound codec of a video: {} (default: by file type)", sound_codec_list()));
    std::vector<Option> light{
        options
            .add("--hdr NAME", m_hdr,
                 "HDR signal of a video with 10 bits and BT.2020 colours: hdr10 or hlg (default: "
                 "none)")
            .one_of({"hdr10", hlg}),
        options
            .add("--paper-white NITS", m_light.paper_white,
                 "With --hdr: light of white in cd/m2 (default: 203)")
            .between(hdr_paper_whites[0], hdr_paper_whites[1]),
        options
            .add("--peak NITS", m_light.peak,
                 "With --hdr: brightest light of the display in cd/m2 (default: 1000)")
            .between(hdr_peaks[0], hdr_peaks[1])};
    if (hdr == Hdr::refused)
        std::ranges::for_each(light, &Option::hidden);
    options.add_flag("--alpha", m_choice.keeps_alpha,
                     "Keep transparency. A look without its own becomes transparent where it is "
                     "black.");
}

FilmChoice FilmOptions::choice() const {
    FilmChoice choice = m_choice;
    if (m_quality > 0.0)
        choice.quality = m_quality;
    if (!m_hdr.empty())
        choice.hdr = FilmHdr{m_hdr == hlg ? HdrTransfer::hlg : HdrTransfer::pq, m_light};
    return choice;
}

std::optional<HdrLight> FilmOptions::hdr() const {
    return m_hdr.empty() ? std::nullopt : std::optional(m_light);
}

std::vector<std::string> FilmOptions::arguments() const {
    std::vector<std::string> arguments;
    add_argument(arguments, "--codec", m_choice.codec);
    if (m_quality > 0.0)
        add_argument(arguments, "--quality", fmt::format("{}", m_quality));
    add_argument(arguments, "--audio-codec", m_choice.sound);
    if (m_choice.keeps_alpha)
        arguments.emplace_back("--alpha");
    return arguments;
}

void FilmOptions::check(const std::string& output, bool is_film_file) const {
    const bool has_choice = !m_choice.codec.empty() || !m_choice.sound.empty() || m_quality > 0.0;
    if (has_choice && !is_film_file)
        throw UsageError("--codec, --audio-codec and --quality need a video file");
    if (!m_hdr.empty() && !is_film_file)
        throw UsageError("--hdr needs a video file. An .exr has all light as it is.");
    if (m_hdr.empty() && m_light != HdrLight{})
        throw UsageError("--paper-white and --peak need --hdr");
    if (m_light.peak < m_light.paper_white)
        throw UsageError("--peak must not be below --paper-white");
    if (is_film_file)
        if (const auto encoding = film_encoding(output, choice()); !encoding)
            throw UsageError(encoding.error().front().message);
}
