#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

#include <string>
#include <vector>

/// What a menu, a key or a button can do.
enum class ActionId {
    open,
    take_up_unsaved,
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
    copy_line,
    paste_line,
    save_picture,
    export_frames,
    quit,
    undo,
    redo,
    show_history,
    reset_all,
    draw,
    search,
    zoom_one,
    zoom_fit,
    zoom_in,
    zoom_out,
    show_library,
    show_parameters,
    show_inspector,
    show_strip,
    show_problems,
    show_timings,
    show_pins,
    show_inputs,
    show_text,
    show_graph,
    bypass_pass,
    solo_pass,
    stop_at_pass,
    freeze_pass,
    clear_pass,
    clear_passes,
    passes_as_usual,
    show_changed,
    picture_only,
    flash,
    wipe,
    side_by_side,
    difference,
    next_measure,
    equal_brightness,
    fit_gain,
    with_article,
    with_file,
    keep_a,
    keep_b,
    keep_c,
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
    show_output,
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
    restart,
    slower,
    faster,
    normal_speed,
    record_moves,
    save_moves,
    remote,
    compare_rates,
    impulse,
    show_flashes,
    comfort,
    palette,
    randomise,
    step_up,
    step_down,
    show_sheet,
    show_waveform,
    show_presets,
    show_favourites,
    show_of_pass,
    next_knob,
    previous_knob,
    turn_up,
    turn_down,
    type_knob,
    reset_knob,
    copy_knob_name,
    keys,
    about,
};

enum class Menu { file, edit, knob, view, output, frame_rate, compare, pass, playback, help };

/// A key with what is held down with it.
struct Chord {
    int key = 0;  // as gpu::KeyEvent names it; 0: none
    bool control = false;
    bool shift = false;
};

/// One line of a menu: the only place where its words, its key and what it does are written.
struct Action {
    ActionId id;
    Menu menu;
    const char* label;
    Chord chord;
    bool is_first = false;  // a line is drawn above it
    void (*act)(const Scene& scene, Edits& edits);
    bool (*is_enabled)(const Scene& scene) = nullptr;  // null: always
    bool (*is_on)(const Scene& scene) = nullptr;       // null: no tick
    void (*let_go)(const Scene& scene,
                   Edits& edits) = nullptr;  // when its key comes up again; null: nothing
};

const std::vector<Action>& all_actions();

/// Runs the action if it can be run now.
void run(ActionId id, const Scene& scene, Edits& edits);

/// "Pause (Space)".
std::string help_of(ActionId id);
/// "Ctrl+Shift+S"; "" for none.
std::string chord_text(const Chord& chord);
/// The same of an action: "F4".
std::string key_of(ActionId id);
/// With what it is about now: "Undo Decay".
std::string label_of(const Action& action, const Scene& scene);

/// Runs what the keyboard asks for; letters belong to a text field while one is active.
void run_keys(const Scene& scene, Edits& edits);
