#include "lab/offline/sheet.h"

#include "base/text.h"
#include "cli/common.h"
#include "cli/progress.h"
#include "io/pictures/picture_file.h"
#include "lab/document/opened_preset.h"

#include <array>

namespace {
constexpr std::array sheet_examples{
    "afterglow sheet phosphor -o phosphor.png",
    "afterglow sheet crt shadow-mask --columns 3 --size 320x180 -o tubes.png",
    "afterglow sheet mine.json yours.json -o both.png",
};

struct SheetArguments {
    std::vector<std::string> looks;
    std::string output;
    int columns = 4;
    std::string size = "480x270";
    double fps = 60.0;
};

// The name of the folder of its presets.
std::string id_of(const OpenRequest& request) {
    if (request.stack.size() > 1)
        return stack_id(request.stack);
    const std::filesystem::path& look = request.look;
    return (look.has_extension() ? look.parent_path() : look).filename().string();
}

/// One request per cell: a given preset, all presets of a look, or a look without presets.
Result<std::vector<RenderRequest>> requests_of(const SheetArguments& arguments,
                                               const Library& library) {
    std::vector<RenderRequest> requests;
    const Extent size = parse_size(arguments.size);
    for (const std::string& name : arguments.looks) {
        const auto found = resolve(name, library);
        if (!found)
            return fail(found.error());
        const auto presets =
            found->preset ? std::vector<PresetEntry>{} : library.presets(id_of(*found));
        for (const PresetEntry& preset : presets)
            requests.push_back(
                {.look = name, .preset = preset.file.string(), .size = size, .fps = arguments.fps});
        if (presets.empty())
            requests.push_back({.look = name, .size = size, .fps = arguments.fps});
    }
    return requests;
}

Result<SheetCell> drawn(const RenderRequest& request, const Library& library) {
    auto prepared = prepare(request, library);
    if (!prepared)
        return fail(prepared.error());
    warn(prepared->warnings);
    auto offline = Offline::create(std::move(*prepared), request.size, request.fps);
    if (!offline)
        return fail(offline.error());
    const Document& document = offline->document();
    const std::string& preset = preset_name(document);
    return SheetCell{document.look().name + (preset.empty() ? "" : ": " + preset),
                     offline->picture_after(document.look().settle_frames)};
}

Result<void> make_sheet(const SheetArguments& arguments, const Library& library) {
    const std::string ending =
        to_lower(std::filesystem::path(arguments.output).extension().string());
    if (ending != ".png" && ending != ".exr")
        return fail({arguments.output, 0,
                     "can't save the picture: the file name must end in .png or .exr"});
    const auto requests = requests_of(arguments, library);
    if (!requests)
        return fail(requests.error());
    std::vector<SheetCell> cells;
    Progress progress(Progress::Kind::rendering_pictures, static_cast<int>(requests->size()));
    for (const RenderRequest& request : *requests) {
        auto cell = drawn(request, library);
        if (!cell)
            return fail(cell.error());
        cells.push_back(std::move(*cell));
        progress.show(static_cast<int>(cells.size()));
    }
    const auto sheet = sheet_of(cells, arguments.columns);
    if (!sheet)
        return fail(sheet.error());
    return save_picture(*sheet, arguments.output);
}
}  // namespace

/// afterglow sheet LOOK... -o OUT
Command add_sheet(CommandLine& program) {
    Options options = program.add_verb("sheet", "Render all presets of looks as one contact sheet",
                                       sheet_examples);
    auto arguments = std::make_shared<SheetArguments>();
    options.add("LOOK", arguments->looks, "Looks (with all their presets) or single presets")
        .required();
    options.add("-o,--output FILE", arguments->output, "Save the sheet as .png or .exr").required();
    options.add("--columns N", arguments->columns, "Pictures per row")
        .show_default()
        .between(1, 100);
    options.add("--size WxH", arguments->size, "Size of each picture in pixels").show_default();
    options.add("--fps N", arguments->fps, "Frames per second of the fixed clock")
        .show_default()
        .between(1.0, 1000.0);
    return [arguments](const DataFolders& data) {
        const auto library = open_library(data);
        if (!library)
            return report(library.error());
        const auto done = make_sheet(*arguments, *library);
        return done ? exit_done : report(done.error());
    };
}
