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
    // Some encoders read the colours of the frames, others those of the stream.
    return {"-vf",
            sides +
                "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+"
                "full_chroma_int+full_chroma_inp,format=" +
                pixels +
                ",setparams=range=tv:color_primaries=bt709:color_trc=bt709:colorspace=bt709",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-color_range",
            "tv"};
}

Arguments codec_arguments(const FilmEncoding& encoding) {
    Arguments arguments = encoding.codec->encoder;
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
