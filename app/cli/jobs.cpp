#include "cli/common.h"
#include "cli/film_options.h"
#include "io/files/atomic_file.h"
#include "lab/farm/farm_engine.h"
#include "lab/offline/export.h"
#include "lab/offline/frame_export.h"
#include "lab/offline/sheet.h"
#include "model/look/subframe.h"
#include "model/picture/source_spec.h"
#include "model/plan/lead_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>

namespace {
constexpr std::array jobs_examples{
    "afterglow jobs phosphor --frames-per-job 60 --for slurm --join a.mp4 -o farm",
    "afterglow jobs crt --seconds 60 --frames-per-job 600 --for parallel -o crt",
    "afterglow jobs crt --vary exposure=1:4:9 --frames-per-job 3 --for make -o exp",
};

struct JobsArguments {
    LookOptions look;
    std::string output;
    std::string engine;
    int per_job = 300;
    std::string join;  // "": none
    int frames = 0;    // 0: not given
    double start = 0.0;
    double seconds = 0.0;  // 0: not given
    std::vector<std::string> axes;
    std::string automation;
    std::string cues;
    bool has_subframes = false;
    FilmOptions film;
    DataFolders data;

    bool is_sweep() const { return !axes.empty(); }
};

const FarmEngine& engine_of(const std::string& name) {
    return *std::ranges::find(farm_engines(), name, &FarmEngine::name);
}

void check_sweep(const JobsArguments& arguments) {
    if (!arguments.join.empty())
        check_ending("--join", arguments.join, {".png", ".exr"});
    if (arguments.start > 0.0 || arguments.seconds > 0.0 || !arguments.automation.empty() ||
        !arguments.cues.empty() || arguments.has_subframes || arguments.film.keeps_alpha())
        throw UsageError(
            "--vary draws separate pictures: leave out --start, --seconds, --moves, --cues, "
            "--subframes and --alpha");
    arguments.film.check("sheet.png", false);
}

void check_film(const JobsArguments& arguments) {
    if (arguments.film.hdr())
        throw UsageError("--hdr: the parts are 8-bit pictures. Use 'afterglow render'.");
    if (!arguments.join.empty())
        check_ending("--join", arguments.join, film_endings());
    const bool has_film = !arguments.join.empty();
    arguments.film.check(has_film ? arguments.join : "frame_%04d.png", has_film);
}

// Pictures from other programs can't be drawn in parts, because they come only once.
Result<void> check_content(const PreparedLook& prepared) {
    const Document& document = prepared.document;
    const auto source = parse_source(document.state().source);
    if (draws_live_signal(document))
        return fail({{}, 0, "live input can't be drawn in parts. Choose another --signal."});
    if (document.look().driven_by == Driver::picture && source && source->is_live())
        return fail({{}, 0, "live input can't be drawn in parts. Choose another --source."});
    return {};
}

// What would otherwise fail only after all parts.
Result<void> check_join(const JobsArguments& arguments, const std::vector<SweepAxis>& axes) {
    if (arguments.join.empty())
        return {};
    if (auto good = check_writable(arguments.join); !good)
        return good;
    const Extent size = arguments.look.request().size;
    if (arguments.is_sweep())
        return check_sheet(size, static_cast<int>(sweep_cells(axes).size()), sheet_columns(axes));
    const auto encoding = film_encoding(arguments.join, arguments.film.choice());
    return encoding ? check_film_extent(*encoding, size) : fail(encoding.error());
}

// "afterglow render" or "afterglow sweep", with the arguments that all parts share.
std::vector<std::string> command_of(const JobsArguments& arguments) {
    std::vector<std::string> command{"afterglow"};
    add_argument(command, "--data", arguments.data.data);
    for (const std::string& folder : arguments.data.includes)
        add_argument(command, "--include", folder);
    for (const std::string& limit : arguments.data.limit_texts)
        add_argument(command, "--limit", limit);
    command.emplace_back(arguments.is_sweep() ? "sweep" : "render");
    for (std::string& argument : arguments.look.arguments())
        command.push_back(std::move(argument));
    for (const std::string& axis : arguments.axes)
        add_argument(command, "--vary", axis);
    add_argument(command, "--moves", arguments.automation);
    add_argument(command, "--cues", arguments.cues);
    if (arguments.has_subframes)
        command.emplace_back("--subframes");
    if (arguments.is_sweep() && arguments.frames > 0)
        add_argument(command, "--frames", std::to_string(arguments.frames));
    return command;
}

Result<FarmWork> start_of_work(const JobsArguments& arguments, const Look& look) {
    FarmWork work;
    for (const char letter : look.id)
        work.name += std::isalnum(static_cast<unsigned char>(letter)) ? letter : '-';
    work.name = "afterglow-" + work.name;
    std::error_code error;
    work.directory = std::filesystem::current_path(error);
    if (error)
        return fail({{}, 0, fmt::format("the current folder can't be read: {}", error.message())});
    work.command = command_of(arguments);
    if (arguments.join.empty())
        return work;
    work.join = work.command;
    for (const std::string& argument : arguments.film.arguments())
        work.join.push_back(argument);
    return work;
}

Result<ExportPart> whole_film(const JobsArguments& arguments, const Offline& offline) {
    const double fps = arguments.look.request().fps;
    double seconds = arguments.seconds;
    if (arguments.frames == 0 && seconds == 0.0) {
        const auto usual = default_video_seconds(offline, arguments.start);
        if (!usual)
            return fail(usual.error());
        seconds = *usual;
    }
    ExportPart whole = part_of(arguments.start, seconds, fps);
    if (arguments.frames > 0)
        whole.end = arguments.frames;
    if (whole.count() < 1)
        return fail({{}, 0, "--start is after the last of --frames"});
    return whole;
}

// --start and --frames of frames `first` to `end` - 1.
std::vector<std::string> range_of(const FarmPart& part, double fps) {
    std::vector<std::string> arguments;
    if (part.first > 0)
        add_argument(arguments, "--start",
                     fmt::format("{}", static_cast<double>(part.first) / fps));
    add_argument(arguments, "--frames", std::to_string(part.end));
    return arguments;
}

void split_film(FarmWork& work, const JobsArguments& arguments, const ExportPart& whole,
                const LeadIn& lead_in) {
    const double fps = arguments.look.request().fps;
    if (arguments.film.keeps_alpha())
        work.command.emplace_back("--alpha");
    work.parts = split(whole.first, whole.end, arguments.per_job);
    for (FarmPart& part : work.parts) {
        part.arguments = range_of(part, fps);
        if (lead_in.frames && part.first > *lead_in.frames)
            add_argument(part.arguments, "--lead-in",
                         fmt::format("{}", static_cast<double>(*lead_in.frames) / fps));
    }
    if (work.join.empty())
        return;
    for (std::string& argument : range_of({whole.first, whole.end, {}}, fps))
        work.join.push_back(std::move(argument));
}

void split_sweep(FarmWork& work, const JobsArguments& arguments, std::size_t pictures) {
    work.parts = split(0, static_cast<std::int64_t>(pictures), arguments.per_job);
    for (FarmPart& part : work.parts) {
        add_argument(part.arguments, "--first", std::to_string(part.first));
        add_argument(part.arguments, "--count", std::to_string(part.end - part.first));
    }
}

std::string lead_in_text(const LeadIn& lead_in) {
    if (!lead_in.frames)
        return fmt::format("Each part draws all earlier frames first: {}.", lead_in.reason);
    if (*lead_in.frames == 0)
        return "No frame depends on earlier ones.";
    return fmt::format("Each part draws {} earlier {} first.", *lead_in.frames,
                       *lead_in.frames == 1 ? "frame" : "frames");
}

Result<void> write_work(const JobsArguments& arguments, FarmWork work, const std::string& note) {
    constexpr std::size_t most_parts = 100'000;
    if (work.parts.size() > most_parts)
        return fail({{},
                     0,
                     fmt::format("{} parts are too many; the limit is {}. Raise --frames-per-job.",
                                 work.parts.size(), most_parts)});
    if (!work.join.empty())
        add_argument(work.join, "--output", arguments.join);
    const std::filesystem::path folder(arguments.output);
    if (auto done = write_farm_folder(folder, work, engine_of(arguments.engine)); !done)
        return done;
    std::cout << fmt::format("Pictures {} to {} in {} {}.{}\nStart with: {}\n",
                             work.parts.front().first, work.parts.back().end - 1, work.parts.size(),
                             work.parts.size() == 1 ? "part" : "parts",
                             note.empty() ? "" : " " + note, (folder / "run").string());
    return {};
}

int jobs(JobsArguments arguments, const DataFolders& data) {
    arguments.data = data;
    arguments.is_sweep() ? check_sweep(arguments) : check_film(arguments);
    RenderRequest request = arguments.look.request();
    request.automation = arguments.automation;
    request.cues = arguments.cues;
    request.draws_subframes = arguments.has_subframes;
    std::vector<SweepAxis> axes;
    std::set<std::string> moving;
    const auto check = [&](const PreparedLook& prepared) -> Result<void> {
        moving = moving_parameters(prepared);
        auto read = sweep_axes(arguments.axes, prepared.document.look());
        if (!read)
            return fail(read.error());
        axes = std::move(*read);
        if (auto good = check_content(prepared); !good)
            return good;
        return check_join(arguments, axes);
    };
    const auto work = [&](Offline& offline, const Library&) -> Result<void> {
        const Look& look = offline.executor().look();
        auto farm = start_of_work(arguments, look);
        if (!farm)
            return fail(farm.error());
        if (arguments.is_sweep()) {
            split_sweep(*farm, arguments, sweep_cells(axes).size());
            return write_work(arguments, std::move(*farm), "");
        }
        const auto whole = whole_film(arguments, offline);
        if (!whole)
            return fail(whole.error());
        const Values& values = offline.document().values();
        const int subframes = arguments.has_subframes ? subframes_of(look, values) : 1;
        const LeadIn lead_in = lead_in_of(look, values, request.fps, subframes, moving);
        split_film(*farm, arguments, *whole, lead_in);
        return write_work(arguments, std::move(*farm), lead_in_text(lead_in));
    };
    return run_drawing(request, data, {check, work});
}

std::vector<std::string> engine_names() {
    std::vector<std::string> names;
    for (const FarmEngine& engine : farm_engines())
        names.push_back(engine.name);
    return names;
}

void add_length(Options& options, JobsArguments& arguments) {
    Option frames = options.add("--frames N", arguments.frames,
                                "Number of frames, from t = 0; with --vary, drawn for each picture "
                                "(default: as in 'render' and 'sweep')");
    frames.between(1, 10000000);
    options.add("--start S", arguments.start, "Start of the film in seconds").between(0.0, 86400.0);
    options
        .add("--seconds S", arguments.seconds,
             "Duration of the film in seconds (default: as in 'render')")
        .between(0.001, 86400.0)
        .excludes(frames);
}
}  // namespace

/// afterglow jobs LOOK --for ENGINE -o FOLDER
Command add_jobs(CommandLine& program) {
    Options options = program.add_verb(
        "jobs",
        "Split a film or sweep into jobs for several cores or machines\n\n"
        "Writes a folder of scripts. Its script 'run' starts the jobs; they write "
        "frames/%04d.png in it. Parts that are complete are left out, so 'run' also goes on.",
        jobs_examples);
    auto arguments = std::make_shared<JobsArguments>();
    arguments->look.add_to(options, LookOptions::Take::drawing);
    options.add("-o,--output FOLDER", arguments->output, "Folder for the scripts; new or empty")
        .required();
    options
        .add("--for ENGINE", arguments->engine,
             "What runs the jobs: Slurm, GNU parallel, make or OpenCue (untested)")
        .required()
        .one_of(engine_names());
    options
        .add("--frames-per-job N", arguments->per_job,
             "Frames of a job; with --vary, pictures of a job")
        .show_default()
        .between(1, 10000000);
    options.add("--join FILE", arguments->join,
                "Then make a video of all frames, with sound; with --vary, a contact sheet");
    options.add("--vary NAME=VALUES", arguments->axes, "Draw a sweep, as in 'sweep'").repeated();
    add_length(options, *arguments);
    arguments->film.add_to(options, FilmOptions::Hdr::refused);
    options.add_flag("--subframes", arguments->has_subframes, "As in 'render'");
    options.add("--moves FILE", arguments->automation, "Automation file, as in 'render'");
    options.add("--cues FILE", arguments->cues, "Cue file, as in 'render'");
    return [arguments](const DataFolders& data) { return jobs(*arguments, data); };
}
