#pragma once

#include "lab/document/changes.h"
#include "lab/files/file_browser.h"
#include "lab/files/places.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The open modal dialog.
struct Dialog {
    enum class Kind {
        none,
        open_file,
        choose_file,  // for the parameter or signal in `subject`
        choose_reference,
        match_photo,
        choose_photo,  // to match
        choose_shown,  // the picture that a photo shows
        live_source,
        save_picture,
        save_pass,  // of the pass in `subject`
        load_drawing,
        save_drawing,
        save_automation,
        open_cues,
        save_cues,
        save_slangp,
        save_pack,
        save_preset_as,
        rename_preset,
        new_look,
        duplicate_look,
        add_pass,  // after the pass in `subject`
        palette,
        compare_preset,  // with the current values; `changes` has the differences
        remote,
        impulse,  // impulse response of every pass
        rates,    // comparison of frame rates
        keys,
        about,
        asked,  // a number or text for the choice with the id in `subject`
        export_frames,
        export_look,
        send_look,
        quit_exporting,  // asks whether to quit while exports run
    };
    enum class Host { undecided, own, desktop };

    Kind kind = Kind::none;
    std::string text = {};     // the typed name
    std::string problem = {};  // why the last attempt failed, shown below the name
    FileBrowser browser = {};  // of a file dialog
    std::vector<Place> places = {};
    Host host = Host::undecided;                       // whose file dialog is open
    std::optional<std::filesystem::path> answer = {};  // of the desktop's dialog
    std::string subject = {};                          // the object of the dialog
    int chosen = 0;                                    // selected row of a list
    std::vector<Change> changes = {};
    bool is_new = true;  // not drawn yet

    bool operator==(const Dialog&) const = default;
};
