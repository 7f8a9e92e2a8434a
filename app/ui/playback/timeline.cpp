#include "ui/playback/timeline.h"

#include "lab/sequencer/sequencer.h"
#include "lab/sequencer/sound_region.h"
#include "ui/playback/sound_controls.h"
#include "ui/playback/timeline_axis.h"
#include "ui/playback/timeline_cues.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace {
using DragKind = TimelineDrag::Kind;

void change_timeline(std::function<void(TimelineView&)> change, Edits& edits) {
    edits.arrange(
        [change = std::move(change)](WindowState& window) { change(window.views.timeline); });
}

void scrub_to(const TimelineAxis& axis, double time, Edits& edits) {
    // Without a sound, time goes on after the end of the axis.
    const double last = axis.part ? axis.length : std::max(axis.length, time);
    edits.change([clock = axis.clock_at(std::clamp(time, 0.0, last))](Sequencer& sequencer) {
        sequencer.scrubber().scrub(clock);
    });
}

// The edge of the region in the ruler that a pointer at `x` takes; nullopt: none.
std::optional<DragKind> edge_at(const TimelineAxis& axis, const ImVec2& pointer,
                                const Scene& scene) {
    if (!has_region(scene.lab.player.signal()) || pointer.y > axis.low.y + axis.ruler)
        return std::nullopt;
    const float reach = ImGui::GetFontSize() * 0.4f;
    const float to_start = std::abs(pointer.x - axis.x(axis.part->start));
    const float to_end = std::abs(pointer.x - axis.x(axis.part->end));
    if (std::min(to_start, to_end) > reach)
        return std::nullopt;
    return to_start < to_end ? DragKind::region_start : DragKind::region_end;
}

DragKind kind_of_press(const TimelineAxis& axis, const ImVec2& pointer, const Scene& scene) {
    if (cue_under(axis, pointer, scene))
        return DragKind::cue;
    if (const auto edge = edge_at(axis, pointer, scene))
        return *edge;
    const bool is_in_ruler = pointer.y <= axis.low.y + axis.ruler;
    return axis.part && (is_in_ruler || ImGui::GetIO().KeyShift) ? DragKind::region
                                                                 : DragKind::scrub;
}

void press_timeline(const TimelineAxis& axis, const Scene& scene, Edits& edits) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const TimelineDrag drag{.kind = kind_of_press(axis, pointer, scene),
                            .from = std::clamp(axis.time(pointer.x), 0.0, axis.length),
                            .line = cue_under(axis, pointer, scene).value_or(0)};
    change_timeline([drag](TimelineView& view) { view.drag = drag; }, edits);
    if (drag.kind == DragKind::scrub)
        scrub_to(axis, drag.from, edits);
}

void continue_timeline_drag(const TimelineAxis& axis, const TimelineDrag& drag, Edits& edits) {
    if (!drag.has_moved && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f))
        change_timeline(
            [](TimelineView& view) {
                if (view.drag)
                    view.drag->has_moved = true;
            },
            edits);
    if (drag.kind == DragKind::scrub && ImGui::GetIO().MouseDelta.x != 0.0f)
        scrub_to(axis, axis.time(ImGui::GetIO().MousePos.x), edits);
}

// A region takes effect on release, as one undo step. A click in the ruler seeks.
void release_timeline(const TimelineAxis& axis, const TimelineDrag& drag, Edits& edits) {
    change_timeline([](TimelineView& view) { view.drag.reset(); }, edits);
    if (drag.kind == DragKind::scrub)
        return;
    if (drag.kind == DragKind::cue)
        return drag.has_moved ? move_cue(axis, drag, edits) : void();
    if (!drag.has_moved)
        return drag.kind == DragKind::region ? scrub_to(axis, drag.from, edits) : void();
    double start = drag.from;
    double end = axis.time(ImGui::GetIO().MousePos.x);
    if (drag.kind == DragKind::region_start)
        start = axis.part->end;
    if (drag.kind == DragKind::region_end)
        start = axis.part->start;
    edits.change([start, end](Document& document, Player& player) {
        set_region(document, player, start, end);
    });
}

void handle_timeline_wheel(const TimelineAxis& axis, Edits& edits) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetItemUsingMouseWheel();  // the panel must not scroll
    const double share = axis.range.share(axis.time(io.MousePos.x));
    const double length = axis.length;
    const float pan = io.KeyShift ? io.MouseWheel : io.MouseWheelH;
    if (io.MouseWheel != 0.0f && !io.KeyShift)
        change_timeline([length, share, factor = std::exp2(io.MouseWheel * 0.5f)](
                            TimelineView& view) { view.zoom(length, factor, share); },
                        edits);
    if (pan != 0.0f)
        change_timeline([length, by = -0.15 * pan](TimelineView& view) { view.pan(length, by); },
                        edits);
}

void draw_timeline_menu(const TimelineAxis& axis, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginPopupContextItem("##timeline_menu"))
        return;
    const bool has_part = has_region(scene.lab.player.signal());
    if (ImGui::MenuItem("Remove loop region", nullptr, false, has_part))
        run(ActionId::remove_loop_region, scene, edits);
    if (ImGui::MenuItem("Zoom to loop region", nullptr, false, has_part))
        change_timeline(
            [length = axis.length, part = *axis.part](TimelineView& view) {
                view.show(length, {part.start, part.end});
            },
            edits);
    if (ImGui::MenuItem("Show all", nullptr, false, scene.window.views.timeline.is_zoomed()))
        change_timeline([](TimelineView& view) { view.show_all(); }, edits);
    draw_cue_items(axis, scene, edits);
    ImGui::EndPopup();
}

void follow_playback(const TimelineAxis& axis, const Scene& scene, Edits& edits) {
    const Transport& transport = scene.lab.player.transport();
    const double position = axis.time_at(transport.time());
    const TimelineView& view = scene.window.views.timeline;
    if (!transport.is_playing() || view.is_hovered || !view.is_zoomed() ||
        (position >= axis.range.start && position < axis.range.end))
        return;
    change_timeline([length = axis.length,
                     position](TimelineView& changed) { changed.follow(length, position); },
                    edits);
}

void handle_timeline_pointer(const TimelineAxis& axis, const Scene& scene, Edits& edits) {
    const auto& drag = scene.window.views.timeline.drag;
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_hovered || ImGui::IsItemActive())
        change_timeline([](TimelineView& view) { view.is_hovered = true; }, edits);
    if (is_hovered)
        handle_timeline_wheel(axis, edits);
    if (is_hovered && edge_at(axis, ImGui::GetIO().MousePos, scene))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (is_hovered && type_cue_on_double_click(axis, scene, edits))
        return;
    const bool is_in_ruler = axis.is_in_ruler(ImGui::GetIO().MousePos.y);
    if (is_hovered && is_in_ruler && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) &&
        has_region(scene.lab.player.signal()))
        return run(ActionId::remove_loop_region, scene, edits);
    if (ImGui::IsItemActivated())
        press_timeline(axis, scene, edits);
    else if (drag && ImGui::IsItemActive())
        continue_timeline_drag(axis, *drag, edits);
    else if (drag && ImGui::IsItemDeactivated())
        release_timeline(axis, *drag, edits);
}

const char* timeline_help(const TimelineAxis& axis) {
    return axis.part ? "Drag in the waveform to scrub. Drag in the ruler, or Shift-drag, to set a "
                       "loop region. Double-click the ruler to remove it. Right-click to add a "
                       "cue. The wheel zooms, Shift+wheel scrolls, Left and Right seek 5 s."
                     : "Drag to scrub. The wheel zooms, Shift+wheel scrolls, Left and Right seek "
                       "5 s.";
}
}  // namespace

void draw_timeline(const char* mark, const ImVec2& size, const Scene& scene, Edits& edits) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(mark, ImMax(size, {1.0f, 1.0f}));
    edits.mark(mark);
    TimelineAxis axis = timeline_axis(low, {low.x + size.x, low.y + size.y}, scene);
    axis.mark = mark;
    handle_timeline_pointer(axis, scene, edits);
    follow_playback(axis, scene, edits);
    draw_axis(axis, scene);
    const std::string cue = cue_help(axis, scene);
    if (!scene.window.views.timeline.drag)
        tooltip(cue.empty() ? timeline_help(axis) : cue);
    draw_timeline_menu(axis, scene, edits);
    draw_cue_typing(mark, scene, edits);
}

namespace {
std::string beat_text(const Tempo& tempo, double time) {
    const double beats = tempo.beats_at(time);
    const double bar = std::floor(beats / tempo.beats_per_bar);
    return fmt::format("{:.0f}.{:.0f}", bar + 1.0,
                       std::floor(beats - bar * tempo.beats_per_bar) + 1.0);
}

void draw_tempo(const Scene& scene, Edits& edits) {
    const TempoControl& control = scene.lab.sequencer.tempo();
    const Tempo tempo = control.tempo();
    double bpm = tempo.bpm;
    const ScopedDisabled disabled(control.follows_midi());
    {
        const ScopedFont font(scene.fonts.numbers);
        const ValueEdit edited = draw_number("##bpm", bpm, ImGui::GetFontSize() * 6.0f,
                                             {.unit = "BPM", .limit = Limit{min_bpm, max_bpm}});
        edits.mark("tempo");
        if (edited.is_changed)
            edits.change([bpm](Sequencer& sequencer) { sequencer.tempo().set_bpm(bpm); });
    }
    tooltip(control.follows_midi()
                ? "Tempo of the MIDI clock."
                : "Tempo of modulations in beats and playlists in bars. Click to type a number.");
    ImGui::SameLine();
    if (ImGui::Button("Tap"))
        run(ActionId::tap_tempo, scene, edits);
    edits.mark("tap_tempo");
    tooltip(scene.actions.help(ActionId::tap_tempo));
    ImGui::SameLine();
    if (ImGui::Button("Downbeat"))
        run(ActionId::set_downbeat, scene, edits);
    edits.mark("downbeat");
    tooltip(scene.actions.help(ActionId::set_downbeat));
    ImGui::SameLine();
    const ScopedFont font(scene.fonts.numbers);
    ImGui::AlignTextToFramePadding();
    dim_text(beat_text(tempo, scene.lab.player.transport().time()) +
             (control.follows_midi() ? " · MIDI clock" : ""));
}
}  // namespace

void draw_timeline_panel(const Scene& scene, Edits& edits) {
    const TimelineAxis axis = timeline_axis({}, {}, scene);
    const double position = axis.time_at(scene.lab.player.transport().time());
    std::string text = fmt::format("{} / {}", clock_text(position), clock_text(axis.length));
    if (has_region(scene.lab.player.signal()))
        text += fmt::format(" · loop {} to {}", clock_text(axis.part->start),
                            clock_text(axis.part->end));
    draw_tempo(scene, edits);
    ImGui::SameLine(0.0f, ImGui::GetFontSize() * 2.0f);
    {
        const ScopedFont font(scene.fonts.numbers);
        dim_text(text);
    }
    draw_cue_line(scene, edits);
    const float least = ImGui::GetFontSize() * 4.0f;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    draw_timeline("timeline", {room.x, std::max(room.y, least)}, scene, edits);
}

void seek_by_seconds(double seconds, const Scene& scene, Edits& edits) {
    const TimelineAxis axis = timeline_axis({}, {}, scene);
    scrub_to(axis, axis.time_at(scene.lab.player.transport().time()) + seconds, edits);
}
