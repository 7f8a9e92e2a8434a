#include "ui/playback/source_panel.h"

#include "lab/document/content_edits.h"
#include "lab/menus/signal_menu.h"
#include "lab/menus/source_menu.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"
#include "ui/playback/content_lock.h"
#include "ui/widgets/form.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/problem_list.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>

namespace {
void set_source(const SourceSpec& source, Edits& edits, bool continues_step = false) {
    edits.change([text = to_string(source), continues_step](Document& document) {
        set_source(document, text, continues_step);
    });
}

// The label of the pattern, or the file name.
std::string label_of(const SourceSpec& source) {
    if (source.is_live())
        return source.picture;
    if (!source.is_pattern())
        return std::filesystem::path(source.picture).filename().string();
    std::string name = name_of_pattern(source);
    for (const PatternInfo& pattern : all_patterns())
        if (name == pattern.name)
            return pattern.label;
    return name;
}

// Only for a look that a signal or a picture can drive.
void draw_signal_choice(const Document& document, Edits& edits) {
    const std::vector<MenuEntry> drivers = driver_entries(document);
    if (drivers.empty())
        return;
    ImGui::Separator();
    if (ImGui::Selectable(drivers.front().name.c_str(), false))
        run(drivers.front().commands, edits);
    edits.mark("use_signal");
    tooltip("A beam draws a signal instead of the picture.");
}

void draw_choice(const SourceSpec& source, const Scene& scene, Edits& edits) {
    const std::string label = label_of(source);
    const std::string current = name_of_pattern(source);
    if (begin_combo("##source", label, form_width())) {
        for (const PatternInfo& pattern : all_patterns()) {
            if (ImGui::Selectable(pattern.label.c_str(), pattern.name == current))
                set_source(with_pattern(source, pattern.name), edits);
            focus_list_item(pattern.label, pattern.name == current);
            edits.mark("pattern:" + pattern.name);
            tooltip(pattern.help);
        }
        draw_signal_choice(*scene.lab.document, edits);
        ImGui::EndCombo();
    }
    edits.mark("source");
    draw_file_problems(scene, edits);
    if (ImGui::Button("Open picture or video…"))
        edits.show({.kind = Dialog::Kind::open_file});
    tooltip("For an image sequence, type the file name with %04d for the number.");
    if (ImGui::Button("Show live source…"))
        edits.show({.kind = Dialog::Kind::live_source,
                    .text = source.is_live() ? to_string(source) : std::string()});
    edits.mark("live_source");
    tooltip("A window of another program, the screen, a camera or a pipe.");
}

struct NamedList {
    const char* mark;
    const char* label;
    const char* help;
    std::string other = {};  // text if no entry is chosen
};

void draw_named(const NamedList& list, const std::vector<NamedSource>& choices,
                const SourceSpec& source, Edits& edits) {
    if (choices.empty())
        return;
    const FormColumns columns = form_columns();
    const auto current = std::ranges::find(choices, source, &NamedSource::source);
    form_label(list.label, columns, current != choices.begin());
    tooltip(list.help);
    form_control(columns);
    std::vector<const char*> labels;
    for (const NamedSource& choice : choices)
        labels.push_back(choice.name.c_str());
    int chosen = static_cast<int>(current - choices.begin());
    if (form_list((std::string("##") + list.mark).c_str(), labels.data(),
                  static_cast<int>(labels.size()), chosen, columns.control_and_number(),
                  list.other.c_str()))
        set_source(choices[static_cast<std::size_t>(chosen)].source, edits);
    edits.mark(list.mark);
}

// The size in a pattern's text, set by a preset or the command line.
std::string own_size(const SourceSpec& source) {
    return source.picture.substr(std::min(source.picture.find("size="), source.picture.size()));
}

void draw_fit(SourceSpec source, Edits& edits) {
    constexpr std::array labels{"Stretch", "Fit", "Fill (crop)", "Integer scale"};
    const FormColumns columns = form_columns();
    form_label("Scaling", columns, source.fit != Fit::stretch);
    tooltip(
        "How the source is scaled to the picture.\nStretch: fills the picture and changes the "
        "aspect ratio.\nFit: shows all of the source, with black bars.\nFill (crop): fills the "
        "picture and crops the source.\nInteger scale: scales by a whole number.");
    form_control(columns);
    int chosen = static_cast<int>(source.fit);
    if (form_list("##fit", labels.data(), static_cast<int>(labels.size()), chosen,
                  columns.control_and_number())) {
        source.fit = static_cast<Fit>(chosen);
        set_source(source, edits);
    }
    edits.mark("source_fit");
}

struct Setting {
    const char* id;
    const char* label;
    const char* help;
    double SourceSpec::*number;
    SliderInfo info;
};

void draw_setting(const Setting& setting, const SourceSpec& current, const Scene& scene,
                  Edits& edits) {
    const ScopedId id{std::string(setting.id)};
    const FormColumns columns = form_columns();
    form_label(setting.label, columns, setting.info.is_changed);
    tooltip(setting.help);
    form_control(columns);
    double value = current.*setting.number;
    const ValueEdit edited = form_slider("##value", value, setting.info, columns, scene.fonts);
    if (edited.is_changed) {
        SourceSpec source = current;
        source.*setting.number = value;
        set_source(source, edits, true);
    }
    if (edited.is_finished)
        edits.finish();
    edits.mark(setting.id);
}

void draw_loop(SourceSpec source, Edits& edits) {
    const FormColumns columns = form_columns();
    form_label("At end", columns, !source.loops);
    form_control(columns);
    constexpr std::array labels{"Loop", "Hold"};
    int chosen = source.loops ? 0 : 1;
    if (form_list("##loop", labels.data(), 2, chosen, columns.control_and_number())) {
        source.loops = chosen == 0;
        set_source(source, edits);
    }
    edits.mark("source_loop");
}

// Only if no aspect ratio of the whole picture is chosen.
void draw_own_aspect(const SourceSpec& source, const Scene& scene, Edits& edits) {
    if (source.shape)
        return;
    draw_setting({.id = "source_aspect",
                  .label = "Pixel aspect",
                  .help = "Width of a source pixel divided by its height. Use 1.143 (8:7) for 256 "
                          "pixels per line on a television.",
                  .number = &SourceSpec::aspect,
                  .info = {.low = 0.5,
                           .high = 2.0,
                           .scale = Scale::logarithmic,
                           .initial = 1.0,
                           .is_changed = source.aspect != 1.0,
                           .limit = Limit{1.0 / 16.0, 16.0}}},
                 source, scene, edits);
}

void draw_film_settings(const Source& open, const SourceSpec& source, const Scene& scene,
                        Edits& edits) {
    SourceSpec with_rate = source;
    with_rate.rate = open.rate();
    draw_setting({.id = "source_rate",
                  .label = "Frame rate",
                  .help = "Frames of the source per second.",
                  .number = &SourceSpec::rate,
                  .info = {.low = 1.0,
                           .high = 120.0,
                           .initial = open.own_rate(),
                           .is_changed = source.rate != 0.0,
                           .unit = "fps",
                           .limit = Limit{0.125, 960.0}}},
                 with_rate, scene, edits);
    draw_loop(source, edits);
}
}  // namespace

void draw_source(const Scene& scene, Edits& edits) {
    draw_content_heading("Source", scene, edits);
    const SourceSpec source =
        parse_source(scene.lab.document->state().source).value_or(SourceSpec{});
    draw_choice(source, scene, edits);
    const OpenSource open = open_source(scene.lab.media);
    draw_named({.mark = "source_size",
                .label = "Size",
                .help = "Pixel size of the pattern, as consoles and computers sent it to a CRT.",
                .other = own_size(source)},
               source_sizes(source), source, edits);
    draw_named(
        {.mark = "source_prescaled",
         .label = "Pre-scaled",
         .help = "Scale factor that is already in the file, as in emulator screenshots. The look "
                 "gets the original pixels. Auto detects integer factors up to 8."},
        source_prescales(source, open.prescale), source, edits);
    draw_fit(source, edits);
    draw_named(
        {.mark = "source_shape",
         .label = "Shape",
         .help = "Aspect ratio of the source on screen. Consoles sent non-square pixels to a "
                 "4:3 CRT."},
        source_shapes(source, open.extent), source, edits);
    draw_own_aspect(source, scene, edits);
    const Source* read = scene.lab.media.source().get();
    if (read && read->is_film())
        draw_film_settings(*read, source, scene, edits);
}
