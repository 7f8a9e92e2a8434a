#include "cli/common.h"
#include "cli/progress.h"
#include "io/files/atomic_file.h"
#include "io/pictures/frame_names.h"
#include "io/pictures/picture_file.h"
#include "lab/offline/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace {
constexpr std::array sweep_examples{
    "afterglow sweep phosphor --vary decay=0.5:0.98:5 -o decay.png",
    "afterglow sweep phosphor --vary beam_width=1:4:3 --columns 1 -o widths.png",
    "afterglow sweep crt --vary exposure=1:4:3 --vary tone_map=ACES,AgX -o crt.png",
    "afterglow sweep phosphor --vary decay=0.5:0.98:5 -o decay_%04d.png",
};

struct SweepArguments {
    LookOptions look{"320x180"};
    std::vector<std::string> axes;
    std::string output;
    int columns = usual_sheet_columns;
    int frames = 0;  // 0: the look's settle_frames
    int first = 0;
    int count = 0;  // 0: all
    std::string frames_from;
};

Result<Picture> drawn(const Document& start, const SweepCell& cell, int frames, Offline& offline) {
    Document document = start;
    for (const auto& [name, value] : cell.values)
        document.set_value(name, value);
    if (auto begun = offline.start_again(std::move(document)); !begun)
        return fail(begun.error());
    return offline.picture_after(frames);
}

// The pictures of --frames-from; nullopt: not given.
std::optional<FrameNames> stored_names(const SweepArguments& arguments) {
    if (arguments.frames_from.empty())
        return std::nullopt;
    auto names = parse_frame_names(arguments.frames_from);
    if (!names || !names->is_sequence())
        throw UsageError("--frames-from: give numbered pictures, such as frames/%04d.png");
    return std::move(*names);
}

int frames_of(const SweepArguments& arguments, const Document& document) {
    return arguments.frames > 0 ? arguments.frames : document.look().settle_frames;
}

Result<void> draw_sheet(const SweepArguments& arguments, const std::vector<SweepAxis>& axes,
                        Extent size, Offline& offline) {
    const Document start = offline.document();
    const int frames = frames_of(arguments, start);
    const int columns = sheet_columns(axes, arguments.columns);
    const std::vector<SweepCell> cells = sweep_cells(axes);
    const int count = static_cast<int>(cells.size());
    if (auto fits = check_sheet(size, count, columns); !fits)
        return fits;
    const auto stored = stored_names(arguments);
    std::vector<SheetCell> drawn_cells;
    Progress progress(Progress::Kind::rendering_pictures, count);
    for (const SweepCell& cell : cells) {
        auto picture = stored ? load_picture(stored->name(static_cast<int>(drawn_cells.size())))
                              : drawn(start, cell, frames, offline);
        if (!picture)
            return fail(picture.error());
        drawn_cells.push_back({cell.caption, std::move(*picture)});
        progress.show(static_cast<int>(drawn_cells.size()));
    }
    const auto sheet = sheet_of(drawn_cells, columns);
    if (!sheet)
        return fail(sheet.error());
    return save_picture(*sheet, arguments.output);
}

// Each picture of the sweep as a file.
Result<void> draw_pictures(const SweepArguments& arguments, const std::vector<SweepAxis>& axes,
                           const FrameNames& names, Offline& offline) {
    const Document start = offline.document();
    const std::vector<SweepCell> cells = sweep_cells(axes);
    const int all = static_cast<int>(cells.size());
    if (arguments.first >= all)
        return fail({{}, 0, fmt::format("--first: the sweep has pictures 0 to {}", all - 1)});
    const int rest = all - arguments.first;
    const int count = arguments.count > 0 ? std::min(arguments.count, rest) : rest;
    Progress progress(Progress::Kind::rendering_pictures, count);
    for (int i = 0; i < count; ++i) {
        const int number = arguments.first + i;
        const auto picture = drawn(start, cells[static_cast<std::size_t>(number)],
                                   frames_of(arguments, start), offline);
        if (!picture)
            return fail(picture.error());
        if (auto saved = save_picture(*picture, names.name(number)); !saved)
            return saved;
        progress.show(i + 1);
    }
    return {};
}

FrameNames checked_output(const SweepArguments& arguments) {
    check_ending("--output", arguments.output, {".png", ".exr"});
    auto names = parse_frame_names(arguments.output);
    if (!names)
        throw UsageError(fmt::format("--output: {}", names.error().front().message));
    if (!names->is_sequence() && (arguments.first > 0 || arguments.count > 0))
        throw UsageError("--first and --count need numbered pictures, such as -o decay_%04d.png");
    if (names->is_sequence() && !arguments.frames_from.empty())
        throw UsageError("--frames-from makes a sheet: leave out %04d in --output");
    return std::move(*names);
}

int sweep(const SweepArguments& arguments, const DataFolders& data) {
    const RenderRequest request = arguments.look.request();
    const FrameNames names = checked_output(arguments);
    static_cast<void>(stored_names(arguments));  // checks it
    std::vector<SweepAxis> axes;
    const auto check = [&](const PreparedLook& prepared) -> Result<void> {
        auto read = sweep_axes(arguments.axes, prepared.document.look());
        if (!read)
            return fail(read.error());
        axes = std::move(*read);
        return check_writable(names.name(0));
    };
    const auto work = [&](Offline& offline, const Library&) {
        return names.is_sequence() ? draw_pictures(arguments, axes, names, offline)
                                   : draw_sheet(arguments, axes, request.size, offline);
    };
    return run_drawing(request, data, {check, work});
}
}  // namespace

/// afterglow sweep LOOK --vary NAME=LOW:HIGH:COUNT -o OUT
Command add_sweep(CommandLine& program) {
    Options options = program.add_verb(
        "sweep", "Render a look with varied parameters as one contact sheet", sweep_examples);
    auto arguments = std::make_shared<SweepArguments>();
    arguments->look.add_to(options, LookOptions::Take::drawing);
    options
        .add("--vary NAME=VALUES", arguments->axes,
             "Vary a parameter over LOW:HIGH:COUNT or A,B,C; the second --vary goes down the sheet")
        .required()
        .repeated();
    options
        .add("-o,--output FILE", arguments->output,
             "Save the sheet as .png or .exr, or its pictures as numbered files (decay_%04d.png, "
             "from 0000)")
        .required();
    options.add("--columns N", arguments->columns, "Pictures per row, with one --vary")
        .show_default()
        .between(1, 100);
    options
        .add("--frames N", arguments->frames,
             "Frames to render for each picture (default: until the look has settled)")
        .between(1, 10000000);
    options
        .add("--first N", arguments->first,
             "With numbered files: start with picture N (default: 0)")
        .between(0, 10000000);
    options
        .add("--count N", arguments->count,
             "With numbered files: number of pictures (default: all)")
        .between(1, 10000000);
    options.add("--frames-from FILES", arguments->frames_from,
                "Make the sheet of such numbered files, without drawing");
    return [arguments](const DataFolders& data) { return sweep(*arguments, data); };
}
