#include "ui/frame/action_name.h"

#include <array>
#include <utility>

namespace {
constexpr std::string_view command_prefix = "action/";
constexpr std::string_view panel_prefix = "panel_";

using Named = std::pair<ActionId, std::string_view>;

// Other programs and users' files contain these names: add new ones, but keep the others.
constexpr auto names = std::to_array<Named>({
    {ActionId::open, "open"},
    {ActionId::restore_unsaved, "restore_unsaved"},
    {ActionId::new_look, "new_look"},
    {ActionId::duplicate_look, "duplicate_look"},
    {ActionId::save_preset, "save_preset"},
    {ActionId::save_preset_as, "save_preset_as"},
    {ActionId::save_slangp, "save_slangp"},
    {ActionId::rename_preset, "rename_preset"},
    {ActionId::duplicate_preset, "duplicate_preset"},
    {ActionId::delete_preset, "delete_preset"},
    {ActionId::show_preset_in_folder, "show_preset_in_folder"},
    {ActionId::next_preset, "next_preset"},
    {ActionId::previous_preset, "previous_preset"},
    {ActionId::morph_to_next, "morph_to_next"},
    {ActionId::morph_to_previous, "morph_to_previous"},
    {ActionId::copy_line, "copy_preset"},
    {ActionId::next_favourite, "next_favourite"},
    {ActionId::previous_favourite, "previous_favourite"},
    {ActionId::paste_line, "paste_preset"},
    {ActionId::save_picture, "save_picture"},
    {ActionId::copy_picture, "copy_picture"},
    {ActionId::export_frames, "export"},
    {ActionId::export_look, "export_look"},
    {ActionId::send_to_retroarch, "send_to_retroarch"},
    {ActionId::send_to_mpv, "send_to_mpv"},
    {ActionId::save_pack, "save_pack"},
    {ActionId::use_desktop_dialog, "use_desktop_dialog"},
    {ActionId::quit, "quit"},
    {ActionId::undo, "undo"},
    {ActionId::redo, "redo"},
    {ActionId::reset_all, "reset_all"},
    {ActionId::draw, "draw"},
    {ActionId::search, "find_parameter"},
    {ActionId::zoom_one, "zoom_one"},
    {ActionId::zoom_fit, "zoom_fit"},
    {ActionId::zoom_in, "zoom_in"},
    {ActionId::zoom_out, "zoom_out"},
    {ActionId::add_pass, "add_pass"},
    {ActionId::remove_pass, "remove_pass"},
    {ActionId::move_pass_earlier, "move_pass_earlier"},
    {ActionId::move_pass_later, "move_pass_later"},
    {ActionId::show_look_in_folder, "show_look_in_folder"},
    {ActionId::bypass_pass, "bypass_pass"},
    {ActionId::solo_pass, "solo_pass"},
    {ActionId::stop_at_pass, "stop_at_pass"},
    {ActionId::freeze_pass, "freeze_pass"},
    {ActionId::clear_pass, "clear_pass"},
    {ActionId::clear_passes, "clear_passes"},
    {ActionId::passes_as_usual, "reset_pass_switches"},
    {ActionId::show_changed, "show_changed"},
    {ActionId::picture_only, "full_screen"},
    {ActionId::show_reference, "show_reference"},
    {ActionId::wipe, "wipe"},
    {ActionId::side_by_side, "side_by_side"},
    {ActionId::difference, "difference"},
    {ActionId::next_measure, "next_metric"},
    {ActionId::equal_brightness, "equal_brightness"},
    {ActionId::fit_gain, "auto_gain"},
    {ActionId::with_article, "compare_with_article"},
    {ActionId::with_file, "compare_with_file"},
    {ActionId::match_photo, "match_photo"},
    {ActionId::store_a, "store_slot_a"},
    {ActionId::store_b, "store_slot_b"},
    {ActionId::store_c, "store_slot_c"},
    {ActionId::recall_a, "recall_slot_a"},
    {ActionId::recall_b, "recall_slot_b"},
    {ActionId::recall_c, "recall_slot_c"},
    {ActionId::with_a, "compare_with_slot_a"},
    {ActionId::with_b, "compare_with_slot_b"},
    {ActionId::with_c, "compare_with_slot_c"},
    {ActionId::next_pass, "next_pass"},
    {ActionId::previous_pass, "previous_pass"},
    {ActionId::pass_large, "show_pass_large"},
    {ActionId::next_channels, "next_channel"},
    {ActionId::brighter, "brighter"},
    {ActionId::darker, "darker"},
    {ActionId::fit_levels, "fit_levels"},
    {ActionId::reset_levels, "reset_levels"},
    {ActionId::mark_flaws, "mark_nan"},
    {ActionId::mark_clipping, "mark_clipping"},
    {ActionId::false_color, "false_color"},
    {ActionId::save_pass, "save_pass"},
    {ActionId::pin, "pin_pixel"},
    {ActionId::edit_pass, "edit_shader"},
    {ActionId::write_passes, "save_passes"},
    {ActionId::passes_as_written, "revert_passes"},
    {ActionId::show_output, "output_window"},
    {ActionId::show_overlay, "overlay"},
    {ActionId::virtual_camera, "virtual_camera"},
    {ActionId::next_output, "move_output"},
    {ActionId::blackout, "blackout"},
    {ActionId::wait_for_display, "vsync"},
    {ActionId::cap_display, "limit_to_display"},
    {ActionId::cap_30, "limit_to_30_fps"},
    {ActionId::cap_60, "limit_to_60_fps"},
    {ActionId::cap_120, "limit_to_120_fps"},
    {ActionId::no_cap, "unlimited_fps"},
    {ActionId::larger_text, "larger_text"},
    {ActionId::smaller_text, "smaller_text"},
    {ActionId::play_pause, "play_pause"},
    {ActionId::step, "step_frame"},
    {ActionId::step_back, "step_frame_back"},
    {ActionId::seek_forward, "seek_forward"},
    {ActionId::seek_back, "seek_back"},
    {ActionId::restart, "restart"},
    {ActionId::remove_loop_region, "remove_loop_region"},
    {ActionId::slower, "half_speed"},
    {ActionId::faster, "double_speed"},
    {ActionId::normal_speed, "normal_speed"},
    {ActionId::record_automation, "record_automation"},
    {ActionId::save_automation, "save_automation"},
    {ActionId::tap_tempo, "tap_tempo"},
    {ActionId::set_downbeat, "set_downbeat"},
    {ActionId::play_playlist, "play_playlist"},
    {ActionId::playlist_next, "next_in_playlist"},
    {ActionId::playlist_previous, "previous_in_playlist"},
    {ActionId::open_cues, "open_cues"},
    {ActionId::save_cues, "save_cues"},
    {ActionId::save_cues_as, "save_cues_as"},
    {ActionId::close_cues, "close_cues"},
    {ActionId::play_cues, "play_cues"},
    {ActionId::add_preset_cue, "add_preset_cue"},
    {ActionId::remote, "remote_control"},
    {ActionId::compare_rates, "compare_frame_rates"},
    {ActionId::impulse, "measure_impulse"},
    {ActionId::show_flashes, "flash_meter"},
    {ActionId::limit_flashes, "flash_limiter"},
    {ActionId::allow_flicker, "allow_flicker"},
    {ActionId::preview_hdr, "hdr_preview"},
    {ActionId::palette, "find_command"},
    {ActionId::randomise, "randomise"},
    {ActionId::step_up, "step_up"},
    {ActionId::step_down, "step_down"},
    {ActionId::show_favourites, "show_favourites"},
    {ActionId::show_of_pass, "show_pass_parameters"},
    {ActionId::next_parameter, "next_parameter"},
    {ActionId::previous_parameter, "previous_parameter"},
    {ActionId::increase_parameter, "increase_parameter"},
    {ActionId::decrease_parameter, "decrease_parameter"},
    {ActionId::type_parameter, "type_parameter"},
    {ActionId::reset_parameter, "reset_parameter"},
    {ActionId::copy_parameter_name, "copy_parameter_name"},
    {ActionId::keys, "keyboard_shortcuts"},
    {ActionId::about, "about"},
    {ActionId::manual, "manual"},
    {ActionId::writing_looks, "writing_looks"},
    {ActionId::whats_new, "whats_new"},
    {ActionId::capture_frame, "capture_with_renderdoc"},
});

constexpr int rows_of(ActionId id) {
    int rows = 0;
    for (const Named& named : names)
        rows += named.first == id ? 1 : 0;
    return rows;
}

constexpr bool is_complete() {
    for (int id = 0; id < action_count; ++id)
        if (static_cast<ActionId>(id) != ActionId::show_panel &&
            rows_of(static_cast<ActionId>(id)) != 1)
            return false;
    return true;
}
static_assert(is_complete(), "each ActionId needs one row in `names`");
}  // namespace

std::string action_name(const Action& action) {
    if (action.panel)
        return std::string(panel_prefix) + std::string(*action.panel);
    for (const auto& [id, name] : names)
        if (id == action.id)
            return std::string(name);
    return {};
}

const Action* find_action(std::string_view name, const ActionTable& actions) {
    for (const Action& action : actions.rows())
        if (action_name(action) == name)
            return &action;
    return nullptr;
}

std::string action_command(const Action& action) {
    return std::string(command_prefix) + action_name(action);
}

std::string command_label(std::string_view command, const ActionTable& actions) {
    const Action* action = command.starts_with(command_prefix)
                               ? find_action(command.substr(command_prefix.size()), actions)
                               : nullptr;
    return action ? action->label : std::string(command);
}
