#include "base/text.h"
#include "cli/common.h"
#include "cli/frame_names.h"
#include "cli/progress.h"
#include "io/atomic_file.h"
#include "io/picture_file.h"
#include "lab/sharing.h"
#include "model/flash_log.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
struct RenderArguments {
    LookOptions look;
    std::string output;
    int frames = 0;  // 0: the look's settle_frames
    std::string pass;
    std::string all_passes;
    std::string moves;
};

Result<int> chosen_pass(const RenderArguments& arguments, const Look& look) {
    if (arguments.pass.empty())
        return static_cast<int>(look.passes.size()) - 1;
    std::vector<std::string> candidates;
    const std::vector<std::string> names = pass_names(look);
    if (const auto name = meant_name(names, arguments.pass, candidates))
        return *find_pass(look, *name);
    if (!candidates.empty())
        return fail({{},
                     0,
                     fmt::format("'{}' is a pass of several looks; write one of: {}",
                                 arguments.pass, fmt::join(candidates, ", "))});
    return fail({{},
                 0,
                 fmt::format("'{}' has no pass '{}'{}", look.id, arguments.pass,
                             did_you_mean(arguments.pass, names))});
}

Result<void> save_all_passes(const Offline& offline, const std::filesystem::path& folder) {
    const Look& look = offline.executor().look();
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        std::string name = look.passes[i].name;
        std::replace(name.begin(), name.end(), '/', '-');
        const auto file = folder / fmt::format("{:02}_{}.exr", i, name);
        if (auto saved = save_picture(offline.picture(static_cast<int>(i)), file); !saved)
            return saved;
    }
    return {};
}

// What cannot become a file is told before anything is drawn.
FrameNames output_names(const std::string& output) {
    auto names = parse_frame_names(output);
    if (!names)
        throw UsageError("--output: " + names.error().front().message);
    check_ending("--output", output, {".png", ".exr"});
    return std::move(*names);
}

Result<void> check_outputs(const RenderArguments& arguments, const FrameNames& names) {
    if (auto good = check_writable(names.name(0)); !good || arguments.all_passes.empty())
        return good;
    return check_writable(std::filesystem::path(arguments.all_passes) / "pass.exr");
}

/// Draws every frame; writes those that the output's name asks for.
Result<void> draw(const RenderArguments& arguments, const FrameNames& names, Offline& offline,
                  const RecentMedia& recent) {
    const auto pass = chosen_pass(arguments, offline.executor().look());
    if (!pass)
        return fail(pass.error());
    const int frames =
        arguments.frames > 0 ? arguments.frames : offline.document().look().settle_frames;
    const bool is_picture = *pass + 1 == static_cast<int>(offline.executor().look().passes.size());
    const double fps = arguments.look.request().fps;
    FlashLog flashes;  // of frames that all become files; one alone does not flash
    Progress progress("render", frames);
    for (int frame = 0; frame < frames; ++frame) {
        const bool is_seen = names.is_sequence() || frame + 1 == frames;
        is_seen ? offline.advance() : offline.advance_unseen();
        if (is_seen) {
            const Picture picture = offline.picture(*pass);
            if (names.is_sequence() && is_picture)
                flashes.add(picture, (frame + 1) / fps);
            const auto file = names.name(frame);
            auto saved = names.is_sequence()
                             ? save_picture(picture, file)
                             : save_picture_with_preset(picture, offline.document(), file, recent);
            if (!saved)
                return saved;
        }
        progress.show(frame + 1);
    }
    if (const auto warning = flashes.warning())
        warn({{{}, 0, *warning, Severity::warning}});
    if (!arguments.all_passes.empty())
        return save_all_passes(offline, arguments.all_passes);
    return {};
}

int render(const RenderArguments& arguments, const std::string& data) {
    RenderRequest request = arguments.look.request();
    request.moves = arguments.moves;
    const FrameNames names = output_names(arguments.output);
    const auto check = [&](const Prepared&) { return check_outputs(arguments, names); };
    const auto work = [&](Offline& offline, const Library& library) {
        return draw(arguments, names, offline, RecentMedia(library.roots()));
    };
    return run_drawing(request, data, {check, work});
}
}  // namespace

/// afterglow render LOOK -o OUT
Command add_render(CommandLine& program) {
    Options options = program.add_verb("render", "Draw a look from a fresh start on a fixed clock");
    auto arguments = std::make_shared<RenderArguments>();
    arguments->look.add_to(options, LookOptions::Take::drawing);
    options
        .add("-o,--output", arguments->output,
             "The picture's file, .png or .exr; with %04d in it every frame, the first 0000")
        .required();
    options
        .add("--frames", arguments->frames,
             "Frames to draw; the last is the picture (default: what the look needs to settle)")
        .between(1, 10000000);
    options.add("--moves", arguments->moves,
                "A file of lines 'seconds name value', as the window records them: what is turned "
                "when");
    options.add("--pass", arguments->pass, "This pass's target instead of the picture");
    options.add("--all-passes", arguments->all_passes,
                "A folder for every pass's target as EXR, after the last frame");
    return [arguments](const std::string& data) { return render(*arguments, data); };
}
