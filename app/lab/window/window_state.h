#pragma once

#include "lab/window/dialog.h"
#include "lab/window/export_form.h"
#include "lab/window/file_dialog_kind.h"
#include "lab/window/first_steps.h"
#include "lab/window/frame_rate.h"
#include "lab/window/key_bindings.h"
#include "lab/window/look_browsing.h"
#include "lab/window/output_state.h"
#include "lab/window/parameter_listing.h"
#include "lab/window/preset_browsing.h"
#include "lab/window/probes.h"
#include "lab/window/view_state.h"
#include "lab/window/window_geometry.h"
#include "lab/window/window_layout.h"
#include "model/picture/flash_limit.h"
#include "model/picture/hdr.h"

#include <filesystem>
#include <string>
#include <vector>

/// The target of the keyboard, if it is not a panel, and the user's keys.
struct KeyboardFocus {
    bool is_in_menus = false;
    bool is_in_look = false;       // the look under the pointer
    bool has_focus = false;        // a control has the focus, see ui/window/focus_keys.h
    bool is_in_dialog = false;     // it is a control of the open dialog
    unsigned int wanted_pane = 0;  // id of the pane that gets the focus; 0: none
    KeyBindings bindings;
    Chord conflict;  // pressed for the action in the dialog's `subject`, but taken
};

/// Whether the user lets looks draw sub-frames, with which the display flickers.
enum class Flicker { not_asked, allowed, refused };

/// The flash meter, the flash limiter and flicker.
struct FlashDisplay {
    bool shows_meter = true;
    FlashLimit limit;
    Flicker flicker = Flicker::not_asked;
    bool has_asked = false;  // since the start
};

/// The picture as an HDR display would show it, tone-mapped for this one.
struct HdrPreview {
    bool is_on = false;
    HdrLight light;

    std::optional<HdrLight> drawn() const { return is_on ? std::optional(light) : std::nullopt; }
};

/// What the user chose last; the latest first.
struct RecentChoices {
    std::vector<std::string> commands;  // ids of palette entries
    std::vector<std::string> files;     // opened files
    std::vector<std::string> looks;     // arguments that open them
};

/// The history state to which the history panel was last scrolled.
struct HistoryScroll {
    std::size_t index = 0;
    std::size_t size = 0;

    bool operator==(const HistoryScroll&) const = default;
};

/// What keeps the rows of a list in place.
struct ListAnchor {
    std::string open;     // id of the open row that was last scrolled to
    std::string hovered;  // id of the row under the pointer; "": none
    float top = 0.0f;     // of that row within the list, in window pixels
    float scroll = 0.0f;  // of the list, while the pointer is over a row

    bool operator==(const ListAnchor&) const = default;
};

/// What the lists were last scrolled to.
struct ScrolledTo {
    HistoryScroll history;
    std::string pass;  // in the strip
    ListAnchor looks;
    ListAnchor presets;
};

/// The user's layout of the window and what it displays. A value; the session stores the layout.
struct WindowState {
    WindowGeometry geometry;
    FrameRate frame_rate;
    OutputState output;
    WindowLayout layout;
    KeyboardFocus keyboard;
    FlashDisplay flashes;
    HdrPreview hdr;
    ViewState views;
    Probes probes;
    ParameterListing parameters;
    LookBrowsing looks;
    PresetBrowsing presets;
    RecentChoices recent;
    ScrolledTo scrolled;
    ExportForm exporting;
    StillForm saving;
    LookExportForm look_export;
    SendForm sending;
    FileDialogChoices file_dialogs;
    FirstSteps first_steps;
    Dialog dialog;
    std::string copied;  // for the clipboard, until it is there; "": nothing
};
