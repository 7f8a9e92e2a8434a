#include "base/text.h"
#include "cli/common.h"
#include "cli/film_options.h"
#include "cli/progress.h"
#include "io/files/atomic_file.h"
#include "io/pictures/frame_names.h"
#include "io/pictures/picture_file.h"
#include "io/system/standard_streams.h"
#include "lab/document/sharing.h"
#include "lab/offline/export_output.h"
#include "lab/offline/loop.h"
#include "lab/offline/output_precision.h"
#include "model/look/readout_text.h"
#include "model/look/spec.h"
#include "model/look/subframe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr std::array render_examples{
    "afterglow render phosphor --preset amber-p3 -o amber.png",
    "afterglow render crt --source screenshot.png --set exposure=1.5 -o crt.png",
    "afterglow render phosphor --signal audio:song.flac --cues show.txt -o show.mp4",
    "afterglow render vector-beam --size 640x360 --seconds 1 -o frame_%04d.png",
};

struct RenderArguments {
    LookOptions look;
    std::string output;
    int frames = 0;         // 0: not given
    double start = 0.0;     // s, start of the output
    double lead_in = -1.0;  // s; below 0: not given
    double seconds = 0.0;   // duration of the output; 0: not given
    std::string pass;
    std::string all_passes;
    std::string frames_from;
    std::string automation;
    std::string cues;
    bool joins = false;
    double timeout = 0.0;  // s; 0: not given
    FilmOptions film;
    bool loops = false;
    bool has_subframes = false;  // each sub-frame is a frame of the output
};

Result<int> chosen_pass(const RenderArguments& arguments, const Look& look) {
    if (arguments.pass.empty())
        return static_cast<int>(look.passes.size()) - 1;
    std::vector<std::string> candidates;
    const std::vector<std::string> names = pass_names(look);
    if (const auto name = resolve_name(names, arguments.pass, candidates))
        return *find_pass(look, *name);
    if (!candidates.empty())
        return fail({{},
                     0,
                     fmt::format("several looks have a pass '{}'; use one of: {}", arguments.pass,
                                 fmt::join(candidates, ", "))});
    return fail({{},
                 0,
                 fmt::format("'{}' has no pass '{}'{}", look.id, arguments.pass,
                             did_you_mean(arguments.pass, names))});
}

Result<void> save_stored(const Offline& offline, int pass, const std::filesystem::path& file) {
    RawPicture raw;
    offline.read(pass, raw);
    const auto bytes = encode_picture(raw, ".exr");
    return bytes ? write_atomically(file, *bytes) : fail({file, 0, bytes.error().front().message});
}

Result<void> save_all_passes(const Offline& offline, const std::filesystem::path& folder) {
    const Look& look = offline.executor().look();
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        std::string name = look.passes[i].name;
        std::replace(name.begin(), name.end(), '/', '-');
        const auto file = folder / fmt::format("{:02}_{}.exr", i, name);
        if (auto saved = save_stored(offline, static_cast<int>(i), file); !saved)
            return saved;
    }
    return {};
}

std::vector<std::string> output_endings() {
    std::vector<std::string> endings{".png", ".exr"};
    for (std::string& ending : film_endings())
        endings.push_back(std::move(ending));
    return endings;
}

// Wrong usage of the options for videos.
void check_film_options(const RenderArguments& arguments, const FrameNames& names) {
    const std::string& output = arguments.output;
    const bool is_film = is_film_output(output);
    arguments.film.check(output, is_film && !is_stream_output(output));
    const bool can_have_alpha = is_film ? !is_stream_output(output)
                                        : names.is_sequence() && to_lower(output).ends_with(".png");
    if (arguments.film.keeps_alpha() && !can_have_alpha)
        throw UsageError("--alpha needs a video file or numbered PNG files");
    if (is_virtual_camera(output) && !arguments.all_passes.empty() && arguments.frames == 0 &&
        arguments.seconds == 0.0)
        throw UsageError("--all-passes with a virtual camera needs --frames or --seconds");
    if (arguments.loops && (is_stream_output(output) || (!is_film && !names.is_sequence())))
        throw UsageError("--loop needs a video file or an image sequence");
    if (arguments.loops && (arguments.start > 0.0 || arguments.frames > 0))
        throw UsageError(
            "--loop finds its first frame and its length: leave out --start and "
            "--frames");
    if (arguments.lead_in >= 0.0 && arguments.start == 0.0)
        throw UsageError("--lead-in needs --start");
    if (arguments.loops && !arguments.automation.empty())
        throw UsageError("--loop: an automation file does not repeat. Leave out --moves.");
    if (arguments.loops && !arguments.cues.empty())
        throw UsageError("--loop: a cue file does not repeat. Leave out --cues.");
    if (arguments.loops && arguments.has_subframes)
        throw UsageError("--loop writes whole source frames. Leave out --subframes.");
    if (arguments.loops && arguments.joins)
        throw UsageError("--loop takes one sound. Leave out --join.");
    if (arguments.loops)
        if (const auto fits = check_loop_rate(output, arguments.look.request().fps); !fits)
            throw UsageError(fits.error().front().message);
}

// The frames of --frames-from; nullopt: not given.
std::optional<FrameNames> stored_frames(const RenderArguments& arguments) {
    if (arguments.frames_from.empty())
        return std::nullopt;
    if (!is_film_output(arguments.output) || is_stream_output(arguments.output) || arguments.loops)
        throw UsageError("--frames-from needs a video file, without --loop");
    if (!arguments.all_passes.empty() || !arguments.pass.empty())
        throw UsageError("--frames-from draws nothing: leave out --pass and --all-passes");
    if (arguments.film.hdr())
        throw UsageError("--frames-from has 8-bit pictures: leave out --hdr");
    auto names = parse_frame_names(arguments.frames_from);
    if (!names || !names->is_sequence())
        throw UsageError("--frames-from: give numbered pictures, such as frames/%04d.png");
    return std::move(*names);
}

// Checks the output before anything is drawn.
FrameNames output_names(const RenderArguments& arguments) {
    const std::string& output = arguments.output;
    if (is_virtual_camera(output))
        if (const auto camera = parse_virtual_camera(output); !camera)
            throw UsageError(fmt::format("--output: {}", camera.error().front().message));
    auto names = parse_frame_names(is_stream_output(output) ? export_pipe : output);
    if (!names)
        throw UsageError(fmt::format("--output: {}", names.error().front().message));
    if (output == export_pipe && is_terminal(standard_output))
        throw UsageError("--output: '-' writes video data; pipe it to another program");
    if (!is_stream_output(output))
        check_ending("--output", output, output_endings());
    if (is_film_output(arguments.output) && names->is_sequence())
        throw UsageError("--output: a video is one file; use %04d with .png or .exr only");
    if (!is_film_output(arguments.output) && !names->is_sequence() && arguments.start > 0.0)
        throw UsageError("--start needs a video or an image sequence, such as frame_%04d.png");
    check_film_options(arguments, *names);
    return std::move(*names);
}

Result<void> check_outputs(const RenderArguments& arguments, const FrameNames& names) {
    if (!is_stream_output(arguments.output))
        if (auto good = check_writable(names.name(0)); !good)
            return good;
    if (arguments.all_passes.empty())
        return {};
    return check_writable(std::filesystem::path(arguments.all_passes) / "pass.exr");
}

Result<ExportPart> part_to_write(const RenderArguments& arguments, const Offline& offline) {
    const double fps = arguments.look.request().fps;
    if (arguments.frames == 0 && arguments.seconds == 0.0) {
        if (is_virtual_camera(arguments.output))
            return ExportPart{part_of(arguments.start, 0.0, fps).first, endless_frames};
        const auto seconds = is_film_output(arguments.output)
                                 ? default_video_seconds(offline, arguments.start)
                                 : offline.document().look().settle_frames / fps;
        if (!seconds)
            return fail(seconds.error());
        return part_of(arguments.start, *seconds, fps);
    }
    ExportPart part = part_of(arguments.start, arguments.seconds, fps);
    if (arguments.frames > 0)
        part.end = arguments.frames;
    if (part.count() < 1)
        return fail({{}, 0, "--start is after the last of --frames"});
    return part;
}

/// Draws all frames up to the last one and saves it.
Result<void> draw_picture(const std::filesystem::path& file, const ExportPart& part, int pass,
                          Offline& offline, const RecentMedia& recent) {
    Progress progress(Progress::Kind::rendering_frames, static_cast<int>(part.end));
    for (std::int64_t frame = offline.frame_number() + 1; frame <= part.end; ++frame) {
        frame < part.end ? offline.advance_unseen() : offline.advance();
        progress.show(static_cast<int>(frame));
    }
    if (to_lower(file.extension().string()) == ".exr")
        return save_stored(offline, pass, file);
    return save_picture_with_preset(offline.picture(pass), offline.drawn_document(), file, recent);
}

/// Finds one period and saves its frames.
Result<void> draw_loop(const RenderArguments& arguments, ExportJob job, Offline& offline) {
    Diagnostics warnings;
    {
        std::optional<Progress> progress;
        const LoopSearch search{.extent = arguments.look.request().size,
                                .fps = job.fps,
                                .seconds = arguments.seconds,
                                .should_continue = [&](std::int64_t drawn, std::int64_t of) {
                                    if (!progress)
                                        progress.emplace(Progress::Kind::finding_period,
                                                         static_cast<int>(of));
                                    progress->show(static_cast<int>(drawn));
                                    return true;
                                }};
        const auto part = find_loop(offline.document(), search);
        offline.make_current();
        if (!part)
            return fail(part.error());
        job.part = part->value_or(ExportPart{});
    }
    Progress progress(Progress::Kind::rendering_frames, static_cast<int>(job.part.end));
    job.should_continue = [&](std::int64_t drawn) {
        progress.show(static_cast<int>(std::min(drawn, job.part.end)));
        return true;
    };
    const auto done = export_loop(arguments.output, offline, job, warnings);
    if (!done)
        return fail(done.error());
    warn(warnings);
    return {};
}

/// Draws all frames of the part and saves them.
Result<void> draw_frames(const RenderArguments& arguments, ExportJob job, Offline& offline) {
    const bool is_endless = job.part.end == endless_frames;
    Progress progress(
        is_endless ? Progress::Kind::showing_frames : Progress::Kind::rendering_frames,
        static_cast<int>(job.part.end));
    job.should_continue = [&](std::int64_t drawn) {
        progress.show(static_cast<int>(drawn));
        return true;
    };
    Diagnostics warnings;
    if (const auto done = export_to(arguments.output, offline, std::move(job), warnings); !done)
        return fail(done.error());
    warn(warnings);
    return {};
}

// The readouts of the last frame, one line each.
void print_readouts(const Offline& offline) {
    const Look& look = offline.executor().look();
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (const auto& readout = look.passes[i].readout) {
            const Picture picture = offline.picture(static_cast<int>(i));
            const std::size_t last_row = picture.index(0, picture.extent.height - 1);
            fmt::print(stderr, "{}\n",
                       readout_text(*readout, static_cast<double>(picture.pixels[last_row])));
        }
}

// Names of the passes whose targets are read.
std::vector<std::string> seen_passes(const RenderArguments& arguments, const Look& look, int pass) {
    if (!arguments.all_passes.empty())
        return pass_names(look);
    std::vector<std::string> names{look.passes[static_cast<std::size_t>(pass)].name};
    for (const Pass& one : look.passes)
        if (one.readout)
            names.push_back(one.name);
    return names;
}

// Whether specialised programs are worth their compilation, which takes as long as a few frames.
// Every film and sequence gets them, so that a part has the same bytes as the whole film.
bool draws_many(const RenderArguments& arguments, const FrameNames& names, const Look& look) {
    constexpr double many = 60;
    if (is_film_output(arguments.output) || names.is_sequence())
        return true;
    const int frames = arguments.frames > 0 ? arguments.frames : look.settle_frames;
    return arguments.seconds * arguments.look.request().fps >= many || frames >= many;
}

// The frames before the output that are not drawn.
std::int64_t skipped_frames(const RenderArguments& arguments) {
    if (arguments.lead_in < 0.0)
        return 0;
    const double fps = arguments.look.request().fps;
    const auto lead_in = static_cast<std::int64_t>(std::ceil(arguments.lead_in * fps - 1e-6));
    return std::max<std::int64_t>(0, part_of(arguments.start, 0.0, fps).first - lead_in);
}

int drawn_subframes(const RenderArguments& arguments, const Offline& offline) {
    const Document& document = offline.document();
    return arguments.has_subframes ? subframes_of(document.look(), document.values()) : 1;
}

Result<void> draw(const RenderArguments& arguments, const FrameNames& names, Offline& offline,
                  const RecentMedia& recent) {
    const auto pass = chosen_pass(arguments, offline.executor().look());
    if (!pass)
        return fail(pass.error());
    const auto part =
        arguments.loops ? Result<ExportPart>(ExportPart{}) : part_to_write(arguments, offline);
    if (!part)
        return fail(part.error());
    if (draws_many(arguments, names, offline.executor().look()))
        if (auto specialized =
                offline.specialize(seen_passes(arguments, offline.executor().look(), *pass));
            !specialized)
            return specialized;
    ExportJob job{.part = *part,
                  .pass = *pass,
                  .fps = arguments.look.request().fps,
                  .film = arguments.film.choice(),
                  .subframes = drawn_subframes(arguments, offline),
                  .stored = stored_frames(arguments)};
    auto done = arguments.loops ? draw_loop(arguments, std::move(job), offline)
                : is_film_output(arguments.output) || names.is_sequence()
                    ? draw_frames(arguments, std::move(job), offline)
                    : draw_picture(names.name(0), *part, *pass, offline, recent);
    if (done && arguments.frames_from.empty())
        print_readouts(offline);
    if (!done || arguments.all_passes.empty())
        return done;
    return save_all_passes(offline, arguments.all_passes);
}

int render_film(const RenderArguments& arguments, RenderRequest request, const DataFolders& data) {
    request.automation = arguments.automation;
    request.cues = arguments.cues;
    request.draws_subframes = arguments.has_subframes;
    request.start_frame = skipped_frames(arguments);
    request.hdr = arguments.film.hdr();
    request.raises_precision = (arguments.all_passes.empty() || arguments.film.hdr()) &&
                               is_deep_film(arguments.output, arguments.film.choice());
    if (arguments.timeout > 0.0)
        request.sender_seconds = arguments.timeout;
    const FrameNames names = output_names(arguments);
    static_cast<void>(stored_frames(arguments));  // checks it
    const auto check = [&](const PreparedLook&) { return check_outputs(arguments, names); };
    const auto work = [&](Offline& offline, const Library& library) {
        return draw(arguments, names, offline, RecentMedia(library.roots()));
    };
    const auto displayed =
        [&](const PreparedLook& prepared) -> std::optional<std::vector<std::string>> {
        const Look& look = prepared.document.look();
        const auto pass = chosen_pass(arguments, look);
        if (!pass || !draws_many(arguments, names, look))
            return std::nullopt;
        return seen_passes(arguments, look, *pass);
    };
    return run_drawing(request, data, {check, work, displayed});
}

// "song" of audio:music/song.flac,mode=xy.
std::string sound_name(const std::string& signal) {
    const auto spec = parse_spec(signal);
    if (!spec || spec->kind != "audio")
        throw UsageError(
            fmt::format("--signal: several signals must be sounds (audio:FILE), got '{}'", signal));
    const auto file = spec->settings.find(spec->settings.contains("file") ? "file" : "");
    const auto* path =
        file == spec->settings.end() ? nullptr : std::get_if<std::string>(&file->second);
    return path ? std::filesystem::path(*path).stem().string() : std::string();
}

// The output for a sound: {name} is replaced, and in a folder NAME.mp4 is written.
std::string output_for(const std::string& output, const std::string& name) {
    constexpr const char* place = "{name}";
    std::error_code error;
    if (output.find(place) != std::string::npos)
        return replace_all(output, place, name);
    if (output.ends_with('/') || std::filesystem::is_directory(output, error))
        return (std::filesystem::path(output) / (name + ".mp4")).string();
    throw UsageError(
        "--output: several sounds need a folder or {name} in the output, such as "
        "films/{name}.mp4. Use --join for one film.");
}

// One film for each sound. All are tried, also if one fails.
int render_each(const RenderArguments& arguments, const DataFolders& data) {
    const std::vector<std::string>& signals = arguments.look.signals();
    std::vector<std::string> outputs;
    for (const std::string& signal : signals) {
        outputs.push_back(output_for(arguments.output, sound_name(signal)));
        if (std::ranges::count(outputs, outputs.back()) > 1)
            throw UsageError(
                fmt::format("--output: two sounds would write '{}'. Rename one of the sounds.",
                            outputs.back()));
        if (const std::string name = sound_name(signal); name.find('%') != std::string::npos)
            throw UsageError(fmt::format(
                "--output: '%' in '{}' would be a frame number. Rename the sound.", name));
    }
    if (!arguments.all_passes.empty())
        throw UsageError("--all-passes: not for several sounds. Render one sound at a time.");
    int code = exit_done;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        RenderArguments one = arguments;
        one.output = outputs[i];
        RenderRequest request = arguments.look.request();
        request.signal = signals[i];
        code = std::max(code, render_film(one, std::move(request), data));
    }
    return code;
}

int render(const RenderArguments& arguments, const DataFolders& data) {
    RenderRequest request = arguments.look.request();
    const std::vector<std::string>& signals = arguments.look.signals();
    if (arguments.joins && signals.size() < 2)
        throw UsageError("--join: give at least two sounds with --signal audio:FILE");
    if (!arguments.joins && signals.size() > 1)
        return render_each(arguments, data);
    if (arguments.joins)
        for (const std::string& signal : signals)
            static_cast<void>(sound_name(signal));  // each must be a sound
    for (std::size_t i = 1; i < signals.size(); ++i)
        request.joined.push_back(signals[i]);
    return render_film(arguments, std::move(request), data);
}

// Which frames are drawn.
void add_length(Options& options, RenderArguments& arguments) {
    Option frames = options.add("--frames N", arguments.frames,
                                "Number of frames to render, from t = 0 (default: until the look "
                                "has settled, or for a video the default of --seconds)");
    frames.between(1, 10000000);
    options.add("--start S", arguments.start, "Skip the first S seconds (they are still simulated)")
        .between(0.0, 86400.0);
    options
        .add("--lead-in S", arguments.lead_in,
             "With --start: draw only this much before it, from an empty history (default: all "
             "from t = 0)")
        .between(0.0, 86400.0);
    options
        .add("--seconds S", arguments.seconds,
             "Duration of the output in seconds (default for a video: the length of the sound or "
             "of the video that is drawn, else 10)")
        .between(0.001, 86400.0)
        .excludes(frames);
}
}  // namespace

/// afterglow render LOOK -o OUT
Command add_render(CommandLine& program) {
    Options options =
        program.add_verb("render",
                         "Render a look to a picture, an image sequence or a video"
                         "\n\nRendering starts at t = 0 on a fixed clock, so the same "
                         "command gives the same bytes.",
                         render_examples);
    auto arguments = std::make_shared<RenderArguments>();
    arguments->look.add_to(options, LookOptions::Take::several);
    options
        .add("-o,--output FILE", arguments->output,
             "Picture of the last frame (.png, .exr), image sequence (frame_%04d.png or .exr, from "
             "0000), video (.mp4, .mov, .mkv, .webm, .gif), - for y4m on standard output, or a "
             "virtual camera (pipewire:NAME, v4l2:/dev/videoN), which runs until Ctrl+C")
        .required();
    add_length(options, *arguments);
    arguments->film.add_to(options);
    options.add_flag(
        "--loop", arguments->loops,
        "Write exactly one period, after the look has settled. With --seconds, that is "
        "the period.");
    options.add_flag("--subframes", arguments->has_subframes,
                     "Write each sub-frame of the look as a frame; --fps counts them. Without it, "
                     "each frame is a whole source frame");
    options.add("--moves FILE", arguments->automation,
                "Automation file, as recorded in the window, with lines of 'seconds name value'");
    options.add("--cues FILE", arguments->cues,
                "Cue file, as edited in the window, with lines such as '1:23.5 preset "
                "\"Amber P3\" morph 2'");
    options.add_flag("--join", arguments->joins,
                     "Join several sounds (--signal audio:A --signal audio:B) to one film. Without "
                     "it, each sound gets a film: -o is a folder or contains {name}");
    options
        .add("--timeout S", arguments->timeout,
             "Fail after S seconds without a point from stdin or a socket (default: no limit)")
        .between(0.001, 86400.0);
    options.add("--pass NAME", arguments->pass,
                "Save the target of this pass instead of the picture");
    options.add("--all-passes FOLDER", arguments->all_passes,
                "Also save the targets of all passes as EXR in this folder, after the last frame");
    options.add("--frames-from FILES", arguments->frames_from,
                "Make the video of pictures that exist, such as frames/%04d.png, with the sound of "
                "the signal or source. Frame numbers are as in -o frames/%04d.png");
    return [arguments](const DataFolders& data) { return render(*arguments, data); };
}
