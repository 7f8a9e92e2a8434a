#include "io/video/film_command.h"

#include "base/text.h"
#include "io/system/child_process.h"

#include <fmt/format.h>

namespace {
using Arguments = std::vector<std::string>;

void add_arguments(Arguments& arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
}

std::string input_pixels(const FilmEncoding& encoding) {
    if (encoding.bits() == 16)
        return encoding.keeps_alpha ? "rgba64le" : "rgb48le";
    return encoding.keeps_alpha ? "rgba" : "rgb24";
}

// Colour for 2 x 2 pixels needs even sides: the last row and column are repeated.
std::string evened(Extent extent) {
    const int right = extent.width % 2;
    const int below = extent.height % 2;
    if (right + below == 0)
        return "";
    return fmt::format("pad={}:{},fillborders=right={}:bottom={}:mode=smear,", extent.width + right,
                       extent.height + below, right, below);
}

/// ffmpeg's names of the colours of a film.
struct Colors {
    const char* zscale_matrix = "709";  // as the filter "zscale" names it
    const char* matrix = "bt709";
    const char* primaries = "bt709";
    const char* transfer = "bt709";
};

Colors colors_of(const FilmEncoding& encoding) {
    if (!encoding.hdr)
        return {};
    const bool is_pq = encoding.hdr->transfer == HdrTransfer::pq;
    return {"2020_ncl", "bt2020nc", "bt2020", is_pq ? "smpte2084" : "arib-std-b67"};
}

// The filter "scale" makes 16-bit pictures 0.3 % too bright when it reduces them to 10 bits.
std::string conversion(const FilmEncoding& encoding, const Colors& colors) {
    if (encoding.bits() == 8)
        return "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+"
               "full_chroma_int+full_chroma_inp";
    return fmt::format("zscale=matrix={}:rangein=full:range=limited", colors.zscale_matrix);
}

// Static metadata of HDR10, SMPTE ST 2086: the colours are within BT.709, in units of 0.00002. The
// peak is in units of 0.0001 cd/m2.
Arguments mastering_arguments(const FilmEncoding& encoding) {
    const bool is_hdr10 = encoding.hdr && encoding.hdr->transfer == HdrTransfer::pq;
    if (!is_hdr10 || encoding.codec->name != "h265")
        return {};
    return {"-x265-params",
            fmt::format("log-level=error:hdr10=1:repeat-headers=1:master-display=G(15000,30000)"
                        "B(7500,3000)R(32000,16500)WP(15635,16450)L({:.0f},1)",
                        encoding.hdr->light.peak * 10000.0)};
}

Arguments picture_arguments(const FilmEncoding& encoding, Extent extent) {
    const FilmCodec& codec = *encoding.codec;
    if (codec.name == "gif")  // one palette per picture, so none waits for the last picture
        return {"-vf",
                "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither="
                "bayer:bayer_scale=3"};
    const std::string& pixels = encoding.keeps_alpha ? codec.alpha_pixels : codec.pixels;
    if (codec.is_lossless)  // RGB, so nothing is converted
        return {"-vf", "format=" + pixels};
    const std::string sides = codec.needs_even_sides ? evened(extent) : std::string();
    const Colors colors = colors_of(encoding);
    // Some encoders read the colours of the frames, others those of the stream.
    return {"-vf",
            fmt::format("{}{},format={},setparams=range=tv:color_primaries={}:color_trc={}:"
                        "colorspace={}",
                        sides, conversion(encoding, colors), pixels, colors.primaries,
                        colors.transfer, colors.matrix),
            "-colorspace",
            colors.matrix,
            "-color_primaries",
            colors.primaries,
            "-color_trc",
            colors.transfer,
            "-color_range",
            "tv"};
}

Arguments codec_arguments(const FilmEncoding& encoding) {
    Arguments arguments = encoding.codec->encoder;
    add_arguments(arguments, mastering_arguments(encoding));  // replaces earlier parameters
    if (!encoding.codec->quality.option.empty())
        add_arguments(arguments, {encoding.codec->quality.option, format_number(encoding.quality)});
    if (encoding.keeps_alpha && encoding.codec->name == "vp9")  // the encoder demands it
        add_arguments(arguments, {"-auto-alt-ref", "0"});
    return arguments;
}

// The lead-in has times before 0, which the file hides.
Arguments sound_input(const FilmEncoding& encoding, int rate) {
    Arguments arguments;
    if (encoding.sound->lead_in > 0)
        arguments = {"-itsoffset",
                     fmt::format("{:.9f}", -static_cast<double>(encoding.sound->lead_in) / rate)};
    add_arguments(arguments, {"-f", "f32le", "-ar", std::to_string(rate), "-ac", "2", "-i",
                              fmt::format("pipe:{}", ChildProcess::second_input)});
    return arguments;
}
}  // namespace

std::vector<std::string> film_command(const FilmEncoding& encoding, const FilmStreams& streams) {
    Arguments arguments{"ffmpeg",
                        "-v",
                        "error",
                        "-nostdin",
                        "-y",
                        "-f",
                        "rawvideo",
                        "-pixel_format",
                        input_pixels(encoding),
                        "-video_size",
                        fmt::format("{}x{}", streams.extent.width, streams.extent.height),
                        "-framerate",
                        streams.rate.text('/'),
                        "-i",
                        "pipe:0"};
    const bool has_sound = encoding.sound && streams.sound_rate > 0;
    if (has_sound)
        add_arguments(arguments, sound_input(encoding, streams.sound_rate));
    add_arguments(arguments, {"-map", "0:v"});
    if (has_sound) {
        add_arguments(arguments, {"-map", "1:a"});
        add_arguments(arguments, encoding.sound->encoder);
    }
    add_arguments(arguments, picture_arguments(encoding, streams.extent));
    add_arguments(arguments, codec_arguments(encoding));
    add_arguments(arguments, encoding.container->muxer);
    // Already open, so a cancelled film never creates a file.
    arguments.push_back(fmt::format("file:/dev/fd/{}", ChildProcess::given_output));
    return arguments;
}
