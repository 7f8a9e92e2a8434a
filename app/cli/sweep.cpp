#include "lab/offline/sweep.h"

#include "cli/common.h"
#include "cli/progress.h"
#include "io/files/atomic_file.h"
#include "io/pictures/picture_file.h"
#include "lab/offline/sheet.h"

#include <fmt/format.h>

#include <array>

namespace {
constexpr std::array sweep_examples{
    "afterglow sweep phosphor --vary decay=0.5:0.98:5 -o decay.png",
    "afterglow sweep phosphor --vary beam_width=1:4:3 --columns 1 -o widths.png",
    "afterglow sweep crt --vary exposure=1:4:3 --vary tone_map=ACES,AgX -o crt.png",
};

struct SweepArguments {
    LookOptions look{"320x180"};
    std::vector<std::string> axes;
    std::string output;
    int columns = 5;
    int frames = 0;  // 0: the look's settle_frames
};

Result<std::vector<SweepAxis>> axes_of(const SweepArguments& arguments, const Look& look) {
    std::vector<SweepAxis> axes;
    Diagnostics problems;
    for (const std::string& text : arguments.axes) {
        auto axis = parse_sweep_axis(text, look);
        if (axis)
            axes.push_back(std::move(*axis));
        else
            problems.insert(problems.end(), axis.error().begin(), axis.error().end());
    }
    if (!problems.empty())
        return fail(std::move(problems));
    if (axes.size() == 2 && axes[0].parameter == axes[1].parameter)
        return fail({{}, 0, fmt::format("'{}' is varied twice", axes[0].parameter)});
    return axes;
}

Result<Picture> drawn(const Document& start, const SweepCell& cell, int frames, Offline& offline) {
    Document document = start;
    for (const auto& [name, value] : cell.values)
        document.set_value(name, value);
    if (auto begun = offline.start_again(std::move(document)); !begun)
        return fail(begun.error());
    return offline.picture_after(frames);
}

Result<void> draw_sheet(const SweepArguments& arguments, const std::vector<SweepAxis>& axes,
                        Extent size, Offline& offline) {
    const Document start = offline.document();
    const int frames = arguments.frames > 0 ? arguments.frames : start.look().settle_frames;
    const int columns =
        axes.size() > 1 ? static_cast<int>(axes[0].stops.size()) : arguments.columns;
    const std::vector<SweepCell> cells = sweep_cells(axes);
    const int count = static_cast<int>(cells.size());
    if (auto fits = check_sheet(size, count, columns); !fits)
        return fits;
    std::vector<SheetCell> drawn_cells;
    Progress progress(Progress::Kind::rendering_pictures, count);
    for (const SweepCell& cell : cells) {
        auto picture = drawn(start, cell, frames, offline);
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

int sweep(const SweepArguments& arguments, const DataFolders& data) {
    const RenderRequest request = arguments.look.request();
    check_ending("--output", arguments.output, {".png", ".exr"});
    if (arguments.axes.size() > 2)
        throw UsageError("--vary can be given at most twice: one parameter across and one down");
    std::vector<SweepAxis> axes;
    const auto check = [&](const PreparedLook& prepared) -> Result<void> {
        auto read = axes_of(arguments, prepared.document.look());
        if (!read)
            return fail(read.error());
        axes = std::move(*read);
        return check_writable(arguments.output);
    };
    const auto work = [&](Offline& offline, const Library&) {
        return draw_sheet(arguments, axes, request.size, offline);
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
    options.add("-o,--output FILE", arguments->output, "Save the sheet as .png or .exr").required();
    options.add("--columns N", arguments->columns, "Pictures per row, with one --vary")
        .show_default()
        .between(1, 100);
    options
        .add("--frames N", arguments->frames,
             "Frames to render for each picture (default: until the look has settled)")
        .between(1, 10000000);
    return [arguments](const DataFolders& data) { return sweep(*arguments, data); };
}
