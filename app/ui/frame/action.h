#pragma once

#include "lab/window/chord.h"
#include "lab/window/key_bindings.h"
#include "lab/window/open_panels.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class Edits;
struct Scene;

/// A command of a menu, a key or a button. All panels share an id.
enum class ActionId {
    open,
    restore_unsaved,
    new_look,
    duplicate_look,
    save_preset,
    save_preset_as,
    save_slangp,
    rename_preset,
    duplicate_preset,
    delete_preset,
    show_preset_in_folder,
    next_preset,
    previous_preset,
    morph_to_next,
    morph_to_previous,
    next_favourite,
    previous_favourite,
    copy_line,
    paste_line,
    save_picture,
    copy_picture,
    export_frames,
    export_look,
    send_to_retroarch,
    send_to_mpv,
    save_pack,
    use_desktop_dialog,
    quit,
    undo,
    redo,
    reset_all,
    draw,
    search,
    zoom_one,
    zoom_fit,
    zoom_in,
    zoom_out,
    show_panel,
    bypass_pass,
    solo_pass,
    stop_at_pass,
    freeze_pass,
    clear_pass,
    clear_passes,
    passes_as_usual,
    show_changed,
    picture_only,
    show_reference,
    wipe,
    side_by_side,
    difference,
    next_measure,
    equal_brightness,
    fit_gain,
    with_article,
    with_file,
    match_photo,
    store_a,
    store_b,
    store_c,
    recall_a,
    recall_b,
    recall_c,
    with_a,
    with_b,
    with_c,
    next_pass,
    previous_pass,
    pass_large,
    next_channels,
    brighter,
    darker,
    fit_levels,
    reset_levels,
    mark_flaws,
    mark_clipping,
    false_color,
    save_pass,
    pin,
    edit_pass,
    write_passes,
    passes_as_written,
    add_pass,
    remove_pass,
    move_pass_earlier,
    move_pass_later,
    show_look_in_folder,
    show_output,
    show_overlay,
    virtual_camera,
    next_output,
    blackout,
    wait_for_display,
    cap_display,
    cap_30,
    cap_60,
    cap_120,
    no_cap,
    larger_text,
    smaller_text,
    play_pause,
    step,
    step_back,
    seek_forward,
    seek_back,
    remove_loop_region,
    tap_tempo,
    set_downbeat,
    play_playlist,
    playlist_next,
    playlist_previous,
    open_cues,
    save_cues,
    save_cues_as,
    close_cues,
    play_cues,
    add_preset_cue,
    restart,
    slower,
    faster,
    normal_speed,
    record_automation,
    save_automation,
    remote,
    compare_rates,
    impulse,
    show_flashes,
    limit_flashes,
    allow_flicker,
    preview_hdr,
    palette,
    randomise,
    step_up,
    step_down,
    show_favourites,
    show_of_pass,
    next_parameter,
    previous_parameter,
    increase_parameter,
    decrease_parameter,
    type_parameter,
    reset_parameter,
    copy_parameter_name,
    keys,
    about,
    manual,
    writing_looks,
    whats_new,
    capture_frame,
    count,  // the number of ids
};

constexpr int action_count = static_cast<int>(ActionId::count);

enum class Menu { file, edit, parameter, view, output, frame_rate, compare, pass, playback, help };

/// One row of the action table: label, key and effect of a command.
/// Menus, shortcuts, tooltips, the palette and the help are made of these rows.
struct Action {
    ActionId id;
    Menu menu;
    const char* label;
    Chord chord;
    bool is_first = false;  // a separator is drawn above it
    std::function<void(const Scene& scene, Edits& edits)> act = {};
    std::function<bool(const Scene& scene)> is_enabled = {};  // null: always enabled
    std::function<bool(const Scene& scene)> is_on = {};       // null: no check mark
    std::function<void(const Scene& scene, Edits& edits)> on_release =
        {};  // on release of its key; null: ignored
    std::function<std::string(const Scene& scene)> current_label =
        {};                             // "Undo: Decay"; null: label
    std::optional<PanelId> panel = {};  // of show_panel
    const char* undo_notice = nullptr;  // shown with an Undo button if its key changed the document
    bool is_hidden = false;             // the machine lacks what it needs
};

/// All actions in the order of the menus. Each ActionId and each panel has exactly one row.
class ActionTable {
public:
    explicit ActionTable(std::vector<Action> rows);

    const std::vector<Action>& rows() const { return m_rows; }
    /// The actions as keys.json names them, with their initial keys, in the order of the rows.
    const std::vector<KeyedAction>& keyed_actions() const { return m_keyed; }
    /// Gives the rows the keys that the user chose.
    void bind(const KeyBindings& bindings);
    const Action& row(ActionId id) const;
    const Action& row(PanelId panel) const;
    /// "F4"; "": no key.
    std::string key(ActionId id) const;
    /// "Play or pause (Space)".
    std::string help(ActionId id) const { return help(row(id)); }
    std::string help(PanelId panel) const { return help(row(panel)); }

private:
    static std::string help(const Action& action);

    std::vector<Action> m_rows;
    std::vector<KeyedAction> m_keyed;
    KeyBindings m_bindings;
};

bool is_enabled(const Action& action, const Scene& scene);
/// The label with its current object: "Undo: Decay".
std::string label_of(const Action& action, const Scene& scene);

/// Runs the action if it is enabled.
void run(ActionId id, const Scene& scene, Edits& edits);
void run(PanelId panel, const Scene& scene, Edits& edits);
