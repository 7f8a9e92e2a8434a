#pragma once

#include "cli/command_line.h"
#include "io/video/film_codec.h"

#include <optional>
#include <string>
#include <vector>

/// The options for how a video is stored.
class FilmOptions {
public:
    /// Whether the options for HDR are in the help, or are refused by the command.
    enum class Hdr { listed, refused };
    void add_to(Options& options, Hdr hdr = Hdr::listed);

    FilmChoice choice() const;
    /// The light that --hdr asks for; nullopt: without HDR.
    std::optional<HdrLight> hdr() const;
    /// The arguments that give the same choice, without HDR.
    std::vector<std::string> arguments() const;
    bool keeps_alpha() const { return m_choice.keeps_alpha; }
    /// Throws UsageError if an option needs a video file, and for other wrong usage.
    void check(const std::string& output, bool is_film_file) const;

private:
    FilmChoice m_choice;
    double m_quality = 0.0;  // 0: not given
    std::string m_hdr;       // "": SDR
    HdrLight m_light = {};
};
