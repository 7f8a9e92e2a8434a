#include "lab/menus/menu_sections.h"

#include "lab/commands/look_commands.h"
#include "lab/document/opened_preset.h"
#include "lab/drawing/drawing_tool.h"
#include "lab/editor/external_programs.h"
#include "lab/lab_parts.h"
#include "lab/menus/device_menu.h"
#include "lab/menus/inspector_menu.h"
#include "lab/menus/parameter_menu.h"
#include "lab/menus/preset_menu.h"
#include "lab/menus/signal_menu.h"
#include "lab/menus/source_menu.h"
#include "lab/menus/stack_menu.h"
#include "lab/menus/tempo_menu.h"
#include "lab/menus/window_menu.h"
#include "lab/playback/player.h"
#include "lab/previews/previews.h"
#include "lab/session.h"
#include "lab/storage/include_store.h"
#include "lab/window/window_state.h"

#include <fmt/format.h>

namespace {
Edit change_comparison(const std::function<void(Comparison&)>& change) {
    return [change](ComparisonView& comparison) {
        Comparison next = comparison.selection().chosen();
        change(next);
        comparison.choose(next);
    };
}

MenuSection comparison_section(const LabParts& lab) {
    MenuSection section{"Comparison", MenuSection::Menu::compare};
    const Comparison& chosen = lab.frames.comparison().selection().chosen();
    for (const auto& [measure, name] :
         {std::pair{DifferenceMeasure::absolute, "Absolute difference"},
          std::pair{DifferenceMeasure::relative, "Relative difference"},
          std::pair{DifferenceMeasure::squared, "Squared difference"}})
        section.entries.push_back(
            {.name = name,
             .commands = {change_comparison([to = measure](Comparison& next) {
                 next.measure = to;
                 next.mode = CompareMode::difference;
             })},
             .is_present = chosen.mode == CompareMode::difference && chosen.measure == measure});
    section.entries.push_back(
        {.name = "Difference gain…",
         .number = NumberPrompt{.current = chosen.gain_stops,
                                .unit = "stops",
                                .limit = {-16.0, 16.0},
                                .answer = [](double typed) -> std::vector<Edit> {
                                    return {change_comparison(
                                        [typed](Comparison& next) { next.gain_stops = typed; })};
                                }}});
    if (const auto& file = lab.frames.comparison().selection().reference().file();
        lab.frames.comparison().selection().reference().picture())
        section.entries.push_back({.name = fmt::format("With {}", file.filename().string()),
                                   .commands = {[file](ComparisonView& comparison) {
                                       comparison.compare_with({Other::Kind::file, 0, file});
                                   }}});
    section.entries.push_back(
        {.name = "Stop comparing",
         .commands = {[](ComparisonView& comparison) { comparison.set_mode(CompareMode::off); }},
         .is_present = chosen.mode == CompareMode::off});
    for (std::size_t i = 0; i < lab.frames.comparison().slots().size(); ++i)
        if (lab.frames.comparison().slots()[i])
            section.entries.push_back(
                {.name = fmt::format("Clear slot {}", slot_name(i)),
                 .commands = {[i](ComparisonView& comparison) { comparison.clear_slot(i); }}});
    return section;
}

Edit on_board(const std::function<void(DrawingBoard&, Document&)>& change) {
    return [change](DrawingTool& drawing) { drawing.edit(change); };
}

void add_pens(const Pen& pen, std::vector<MenuEntry>& entries) {
    const auto offer = [&](const char* name, const Pen& next) {
        entries.push_back({.name = name,
                           .commands = {on_board([next](DrawingBoard& board, Document& document) {
                               board.set_pen(next, document);
                           })},
                           .is_present = next == pen});
    };
    for (const auto& [tool, name] :
         {std::pair{PenTool::freehand, "Freehand"}, std::pair{PenTool::points, "Points"},
          std::pair{PenTool::edit, "Edit"}, std::pair{PenTool::erase, "Erase"}})
        offer(name, {pen.is_active, tool, pen.is_smooth});
    offer("Smooth lines", {pen.is_active, pen.tool, true});
    offer("Straight lines", {pen.is_active, pen.tool, false});
}

void add_keyframes(const DrawingBoard& board, std::vector<MenuEntry>& entries) {
    const auto on_keyframes = [](const KeyframeChange& change) {
        return Edit([change](DrawingTool& drawing) { drawing.edit_keyframes(change); });
    };
    const auto offer = [&](const char* name, const KeyframeChange& change) {
        entries.push_back({.name = name, .commands = {on_keyframes(change)}});
    };
    offer("New keyframe", &EditedDrawing::add_keyframe);
    offer("Duplicate keyframe", &EditedDrawing::duplicate_keyframe);
    offer("Remove keyframe", &EditedDrawing::remove_keyframe);
    offer("Clear keyframe", &EditedDrawing::clear_keyframe);
    offer("Move keyframe earlier",
          [](EditedDrawing& drawing, Document& document) { drawing.move_keyframe(-1, document); });
    offer("Move keyframe later",
          [](EditedDrawing& drawing, Document& document) { drawing.move_keyframe(1, document); });
    for (std::size_t i = 0; i < board.drawing()->keyframes.size(); ++i)
        entries.push_back({.name = fmt::format("Keyframe {}", i + 1),
                           .commands = {on_keyframes([i](EditedDrawing& drawing, Document&) {
                               drawing.choose_keyframe(i);
                           })},
                           .is_present = board.keyframe() == i});
}

MenuSection drawing_section(const DrawingBoard& board) {
    MenuSection section{"Draw"};
    if (!board.drawing())
        return section;
    if (board.has_pen()) {
        add_pens(board.pen(), section.entries);
        add_keyframes(board, section.entries);
    }
    for (const auto& [name, kind] : {std::pair{"Load SVG…", Dialog::Kind::load_drawing},
                                     std::pair{"Save SVG…", Dialog::Kind::save_drawing}})
        section.entries.push_back({.name = name, .commands = {[shown = kind](WindowState& window) {
                                                     window.dialog = {.kind = shown};
                                                 }}});
    return section;
}

// The menu displays them with pictures.
MenuSection unsaved_section(const SessionStash& sessions) {
    MenuSection section{"Unsaved changes"};
    for (const StashedSession& session : sessions.list())
        section.entries.push_back(
            {.name = session.preset.empty() ? session.look
                                            : fmt::format("{} – {}", session.look, session.preset),
             .commands = {
                 [file = session.file](Lab& changed) { restore_stashed(changed, file); }}});
    return section;
}

MenuSection include_section(const LabParts& lab) {
    MenuSection section{"Includes", MenuSection::Menu::edit};
    section.entries.push_back(
        {.name = "Folders, separated by ':'…",
         .text = TextPrompt{include_folders_text(lab.looks.include_folders()),
                            [](const std::string& typed) -> std::vector<Edit> {
                                return {
                                    [folders = parse_include_folders(typed)](LookCommands& looks) {
                                        looks.set_include_folders(folders);
                                    }};
                            }}});
    return section;
}

MenuSection editor_section(const ExternalPrograms& programs) {
    MenuSection section{"Editor", MenuSection::Menu::edit};
    const auto offer = [&](const std::string& name, const std::string& command) {
        section.entries.push_back(
            {.name = name,
             .commands = {[command](ExternalPrograms& changed) { changed.choose_editor(command); }},
             .is_present = programs.editor() == command});
    };
    offer("Desktop's default", {});
    for (const EditorInfo& editor : programs.installed())
        offer(editor.name, editor.command);
    section.entries.push_back(
        {.name = "Command with {file} and {line}…",
         .text = TextPrompt{programs.editor(), [](const std::string& typed) -> std::vector<Edit> {
                                return {[typed](ExternalPrograms& changed) {
                                    changed.choose_editor(typed);
                                }};
                            }}});
    return section;
}

// Actions for NaN or infinity, and for problems in files.
MenuSection nan_section(const LabParts& lab) {
    MenuSection section{"Problem"};
    if (lab.frames.nan_guard().found())
        for (const auto& [answer, name] : {std::pair{NonFiniteAction::clear, "Restart history"},
                                           std::pair{NonFiniteAction::clamp, "Clamp NaN/Inf"},
                                           std::pair{NonFiniteAction::ignore, "Ignore NaN/Inf"}})
            section.entries.push_back({.name = name, .commands = {[to = answer](FrameLoop& frames) {
                                                         frames.nan_guard().set_action(to);
                                                     }}});
    for (const Problem& problem : lab.messages.problems()) {
        const Diagnostic& said = problem.diagnostic;
        section.entries.push_back(
            {.name =
                 fmt::format("{}:{} {}", said.file.filename().string(), said.line, said.message),
             .commands = {[location = Location{said.file, said.line}](LookCommands& looks) {
                 looks.open_in_editor(location);
             }}});
    }
    return section;
}

using Sections = std::vector<MenuSection>;

void add_sections(Sections& all, Sections more) {
    for (MenuSection& section : more)
        all.push_back(std::move(section));
}

void add_of_look(const LabParts& lab, const WindowState& window,
                 const std::vector<ListedLook>& looks, Sections& all) {
    const Document& document = *lab.document;
    add_sections(all, signal_sections(document));
    add_sections(all, source_sections(document, open_source(lab.media)));
    all.push_back(stack_section(document.state().stack, looks));
    if (lab.renderer)
        add_sections(all, inspector_sections(
                              inspected_parts(lab.renderer->executor(), window.views.inspected),
                              window.views.inspected));
    all.push_back(comparison_section(lab));
    all.push_back(unsaved_section(lab.looks.stash()));
    add_sections(
        all, preset_sections(listed_presets(document, looks, lab.presets.navigation().stars(), {}),
                             window.presets));
    if (!preset_file(document).empty() && lab.presets.has_source_checkout())
        all.push_back(shipped_preset_section());
}

void add_further(const LabParts& lab, const WindowState& window, Sections& all) {
    const Document& document = *lab.document;
    const Parameter* selected =
        find_parameter(document.look(), window.parameters.revealed.parameter);
    if (selected)
        add_sections(all, parameter_sections(document, *selected));
    all.push_back(pass_setting_section(document, window.views.inspected.pass));
    const VariantSheet& sheet = lab.frames.previews().sheet();
    std::vector<SweepCell> cells;
    for (const VariantSheet::Cell& cell : sheet.cells())
        cells.push_back(cell.values);
    all.push_back(sheet_section(sheet.request(), cells, selected));
    add_sections(all, parameter_list_sections(document, window));
    all.push_back(drawing_section(lab.drawing.board()));
    all.push_back(tempo_section(lab.sequencer.tempo().tempo()));
}
}  // namespace

std::vector<MenuSection> menu_sections(const LabParts& lab, const WindowState& window,
                                       const std::vector<ListedLook>& looks) {
    Sections all;
    if (lab.document) {
        add_of_look(lab, window, looks, all);
        add_further(lab, window, all);
    }
    add_sections(all, window_sections(window, effective_size(lab.size)));
    const Player& player = lab.player;
    all.push_back(sound_section({.settings = player.devices().settings(),
                                 .devices = lab.audio.devices(),
                                 .level = player.devices().level(),
                                 .position = player.transport().time(),
                                 .sound_seconds = player.signal().sound_seconds()}));
    all.push_back(remote_section(lab.remote.settings(), lab.remote.osc().is_listening(),
                                 lab.remote.midi().is_listening()));
    all.push_back(include_section(lab));
    all.push_back(editor_section(lab.programs));
    all.push_back(nan_section(lab));
    all.push_back(lab.frames.heavy_pass().section());
    return all;
}

std::vector<MenuSection> sections_of_menu(const LabParts& lab, const WindowState& window,
                                          const std::vector<ListedLook>& looks,
                                          MenuSection::Menu menu) {
    Sections all;
    if (lab.document)
        add_of_look(lab, window, looks, all);
    all.push_back(include_section(lab));
    all.push_back(editor_section(lab.programs));
    std::erase_if(all, [menu](const MenuSection& section) {
        return section.menu != menu || section.entries.empty();
    });
    return all;
}
