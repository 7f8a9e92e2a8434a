#include "ui/dialogs/keys_dialog.h"

#include "base/text.h"
#include "gpu/input_event.h"
#include "lab/window/search_words.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/mouse_gestures.h"
#include "ui/frame/action.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/search_box.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

namespace {
/// One action of the list.
struct KeyRow {
    const Action* action;
    const KeyedAction* keyed;
};

/// The actions of one menu.
struct KeyGroup {
    const char* title;
    std::vector<KeyRow> rows;

    std::size_t lines() const { return rows.size() + 2; }  // includes the title and a gap
};

bool is_found(std::string_view search, std::initializer_list<std::string_view> texts) {
    return has_search_words(fmt::format("{}", fmt::join(texts, " ")), search);
}

std::vector<KeyGroup> key_groups(const Scene& scene) {
    std::vector<KeyGroup> groups;
    const std::vector<Action>& rows = scene.actions.rows();
    const std::string& search = scene.window.dialog.text;
    for (const auto& [menu, title] :
         {std::pair{Menu::file, "File"}, std::pair{Menu::edit, "Edit"},
          std::pair{Menu::parameter, "Parameter"}, std::pair{Menu::playback, "Playback"},
          std::pair{Menu::view, "View"}, std::pair{Menu::output, "Output"},
          std::pair{Menu::frame_rate, "Frame rate"}, std::pair{Menu::compare, "Compare"},
          std::pair{Menu::pass, "Pass"}, std::pair{Menu::help, "Help"}}) {
        KeyGroup group{title, {}};
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].menu == menu && !rows[i].is_hidden &&
                is_found(search, {rows[i].label, chord_text(rows[i].chord), title}))
                group.rows.push_back({&rows[i], &scene.actions.keyed_actions()[i]});
        if (!group.rows.empty())
            groups.push_back(std::move(group));
    }
    return groups;
}

// Distributes whole groups over at most `count` columns. Keeps their order and minimises the
// longest column.
std::vector<std::vector<KeyGroup>> in_columns(const std::vector<KeyGroup>& groups,
                                              std::size_t count) {
    const auto filled = [&](std::size_t maximum) {
        std::vector<std::vector<KeyGroup>> columns(1);
        std::size_t lines = 0;
        for (const KeyGroup& group : groups) {
            if (lines > 0 && lines + group.lines() > maximum) {
                columns.emplace_back();
                lines = 0;
            }
            lines += group.lines();
            columns.back().push_back(group);
        }
        return columns;
    };
    std::size_t maximum = 1;
    while (filled(maximum).size() > count)
        ++maximum;
    return filled(maximum);
}

// Sizes the area to its content, limited by the window height. Longer content scrolls.
void draw_in_room(const char* id, const std::function<void()>& draw) {
    // Title, search, conflict, close button and padding.
    const float around = 9.0f * ImGui::GetFrameHeightWithSpacing();
    const float maximum = ImGui::GetIO().DisplaySize.y - around;
    float& wanted = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(id), maximum);
    {  // only for this child: popups above it keep their own padding
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild(id, {0.0f, std::min(wanted, maximum)});
    }
    draw();
    wanted = ImGui::GetCursorPosY();
    ImGui::EndChild();
}

bool is_waiting_for_key(const Scene& scene) {
    return !scene.window.dialog.subject.empty();
}

void wait_for_key(const std::string& action, Edits& edits) {
    edits.arrange([action](WindowState& window) {
        window.dialog.subject = action;
        window.keyboard.conflict = {};
    });
}

// The chord that was pressed in this frame; nullopt: none.
std::optional<Chord> pressed_chord() {
    const ImGuiIO& io = ImGui::GetIO();
    for (int key = ' '; key <= gpu::key::last; ++key) {
        const bool is_modifier = key >= gpu::key::left_shift && key < gpu::key::last;
        if (!is_modifier && key != gpu::key::escape && ImGui::IsKeyPressed(key, false))
            return Chord{key, io.KeyCtrl, io.KeyShift};
    }
    return std::nullopt;
}

const KeyedAction* find_keyed(const Scene& scene, const std::string& name) {
    const auto& all = scene.actions.keyed_actions();
    const auto found = std::ranges::find(all, name, &KeyedAction::name);
    return found == all.end() ? nullptr : &*found;
}

void assign(const Scene& scene, const KeyedAction& action, const Chord& chord, Edits& edits) {
    edits.arrange([all = scene.actions.keyed_actions(), action, chord](WindowState& window) {
        window.keyboard.bindings.set(all, action, chord);
    });
    wait_for_key({}, edits);
}

// Takes the key that the user presses for the chosen action.
void take_key(const Scene& scene, Edits& edits) {
    const KeyedAction* action = find_keyed(scene, scene.window.dialog.subject);
    if (!action)
        return;
    if (ImGui::IsKeyPressed(gpu::key::escape, false))
        return wait_for_key({}, edits);
    const auto chord = pressed_chord();
    if (!chord || ImGui::GetIO().KeyAlt || ImGui::GetIO().KeySuper)
        return;
    const KeyBindings& bindings = scene.window.keyboard.bindings;
    const bool is_taken =
        bindings.find_conflict(scene.actions.keyed_actions(), *action, *chord) != nullptr;
    if (is_assignable(*chord) && !is_taken)
        assign(scene, *action, *chord, edits);
    else
        edits.arrange([chord = *chord](WindowState& window) { window.keyboard.conflict = chord; });
}

// What to do, or the action that already has the pressed key.
void draw_prompt(const Scene& scene, Edits& edits) {
    const KeyedAction* action = find_keyed(scene, scene.window.dialog.subject);
    ImGui::AlignTextToFramePadding();
    if (!action) {
        dim_text("Click a key to change it.");
        return;
    }
    const Chord conflict = scene.window.keyboard.conflict;
    const KeyBindings& bindings = scene.window.keyboard.bindings;
    const auto& all = scene.actions.keyed_actions();
    const KeyedAction* other = bindings.find_conflict(all, *action, conflict);
    if (other) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextUnformatted(
            fmt::format("{} is the key of \"{}\".", chord_text(conflict), other->label).c_str());
    } else if (conflict.key != 0) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextUnformatted("This key is reserved. Press another one.");
    } else {
        ImGui::TextUnformatted(
            fmt::format("Press the new key for \"{}\". Esc cancels.", action->label).c_str());
    }
    edits.mark("keys_prompt");
    if (other) {
        const std::string previous = chord_text(bindings.chord_of(*action));
        ImGui::SameLine();
        if (ImGui::Button(previous.empty() ? "Reassign key" : "Swap keys"))
            assign(scene, *action, conflict, edits);
        tooltip(previous.empty() ? fmt::format("\"{}\" loses its key.", other->label)
                                 : fmt::format("\"{}\" gets {}.", other->label, previous));
        edits.mark("keys_swap");
    }
    ImGui::SameLine();
    if (ImGui::Button("No key"))
        assign(scene, *action, {}, edits);
    edits.mark("keys_none");
    ImGui::SameLine();
    if (ImGui::Button("Cancel"))
        wait_for_key({}, edits);
}

void draw_key_button(const KeyRow& row, float width, const Scene& scene, Edits& edits) {
    const bool is_waiting = scene.window.dialog.subject == row.keyed->name;
    const std::string key = chord_text(row.action->chord);
    const std::string text = is_waiting ? "Press a key" : key.empty() ? "–" : key;
    const ScopedColor color(ImGuiCol_Text,
                            key.empty() && !is_waiting ? theme::faint : theme::accent);
    const ScopedColor back(ImGuiCol_Button, is_waiting ? theme::field_active : theme::none);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_FramePadding,
                                      {ImGui::GetFontSize() * 0.3f, ImGui::GetFontSize() * 0.06f});
    const ScopedStyle<ImVec2> align(ImGuiStyleVar_ButtonTextAlign, {0.0f, 0.5f});
    if (ImGui::Button((text + "##key").c_str(), {width, 0.0f}))
        wait_for_key(is_waiting ? std::string() : row.keyed->name, edits);
    edits.mark("key:" + row.keyed->name);
    tooltip("Click, then press the new key");
}

void draw_row(const KeyRow& row, float width, const Scene& scene, Edits& edits) {
    const ScopedId id(row.keyed->name);
    draw_key_button(row, width, scene, edits);
    ImGui::SameLine(0.0f, ImGui::GetFontSize() * 0.5f);
    const KeyBindings& bindings = scene.window.keyboard.bindings;
    const bool is_changed = bindings.is_changed(*row.keyed);
    const float button = is_changed ? ImGui::GetFrameHeight() : 0.0f;
    fitted_text(row.action->label, ImGui::GetContentRegionAvail().x - button,
                is_changed ? theme::text : theme::label);
    edits.mark("key_label:" + row.keyed->name);
    if (!is_changed)
        return;
    const std::string initial = chord_text(row.keyed->initial);
    ImGui::SameLine();
    if (icon_button("##reset", Icon::reset,
                    initial.empty() ? "Reset to no key" : fmt::format("Reset to {}", initial),
                    theme::dim))
        assign(scene, *row.keyed, row.keyed->initial, edits);
    edits.mark("key_reset:" + row.keyed->name);
}

void draw_groups(const Scene& scene, Edits& edits) {
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_CellPadding, ImVec2(4.0f * scene.scale, 0.0f));
    const ScopedStyle<ImVec2> spacing(ImGuiStyleVar_ItemSpacing,
                                      ImVec2(4.0f * scene.scale, 1.5f * scene.scale));
    constexpr std::size_t columns = 3;
    const std::vector<KeyGroup> groups = key_groups(scene);
    if (groups.empty() || !ImGui::BeginTable("##columns", static_cast<int>(columns)))
        return;
    const float width = ImGui::CalcTextSize("Ctrl+Shift+PageDown").x + ImGui::GetFontSize();
    for (const std::vector<KeyGroup>& column : in_columns(groups, columns)) {
        ImGui::TableNextColumn();
        for (const KeyGroup& group : column) {
            {
                const ScopedFont strong(scene.fonts.strong);
                ImGui::TextUnformatted(group.title);
            }
            for (const KeyRow& row : group.rows)
                draw_row(row, width, scene, edits);
            ImGui::Dummy({0.0f, ImGui::GetFontSize() * 0.5f});
        }
    }
    ImGui::EndTable();
}

void draw_mouse(const Scene& scene) {
    std::vector<MouseGesture> found;
    for (const MouseGesture& gesture : mouse_gestures)
        if (is_found(scene.window.dialog.text, {gesture.gesture, gesture.effect, "Mouse"}))
            found.push_back(gesture);
    if (found.empty())
        return;
    {
        const ScopedFont strong(scene.fonts.strong);
        ImGui::TextUnformatted("Mouse");
    }
    if (!ImGui::BeginTable("##mouse", 2))
        return;
    for (const MouseGesture& gesture : found) {
        ImGui::TableNextColumn();
        const float left = ImGui::GetCursorPosX();
        {
            const ScopedColor color(ImGuiCol_Text, theme::accent);
            ImGui::TextUnformatted(gesture.gesture);
        }
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + ImGui::GetFontSize() * 15.5f);  // SameLine() ignores columns
        fitted_text(gesture.effect, ImGui::GetContentRegionAvail().x, theme::label);
    }
    ImGui::EndTable();
}

void draw_search(const Scene& scene, Edits& edits) {
    std::string search = scene.window.dialog.text;
    const bool is_new = scene.window.dialog.is_new;
    if (draw_search_box({"keys_search", "Search commands, keys and gestures",
                         ImGui::GetFontSize() * 20.0f, is_new},
                        search, edits))
        edits.arrange([search](WindowState& window) { window.dialog.text = search; });
    if (is_new)
        edits.arrange([](WindowState& window) { window.dialog.is_new = false; });
}
}  // namespace

void draw_keys_dialog(const Scene& scene, Edits& edits) {
    const bool is_waiting = is_waiting_for_key(scene);
    const bool is_searching = !scene.window.dialog.text.empty();
    const DialogFrame frame("Keys and mouse", 76.0f, scene, edits, !is_waiting && !is_searching);
    if (!frame.is_open())
        return;
    if (is_waiting)
        take_key(scene, edits);
    draw_search(scene, edits);
    ImGui::Spacing();
    draw_in_room("##keys", [&] {
        draw_groups(scene, edits);
        draw_mouse(scene);
    });
    ImGui::Spacing();
    draw_prompt(scene, edits);
    if (!scene.window.keyboard.bindings.is_empty()) {
        const float width = ImGui::CalcTextSize("Reset all keys").x + ImGui::GetFontSize();
        same_line_right(width);
        if (ImGui::Button("Reset all keys", {width, 0.0f}))
            edits.arrange([](WindowState& window) { window.keyboard.bindings.reset_all(); });
        edits.mark("keys_reset_all");
    }
    draw_close_button("Close", edits, !is_waiting);
}
