#pragma once

#include "lab/document/changes.h"
#include "lab/storage/folder.h"
#include "lab/window/window_layout.h"
#include "model/look/extent.h"
#include "model/look/texture_choice.h"
#include "model/picture/flash_limit.h"
#include "model/picture/levels.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The position of a picture in its view. The zoom is in device pixels per pixel of the picture.
struct PictureView {
    enum class Fit {
        whole,
        all,
        free
    };  // whole: largest integer zoom that fits, or `all` if 1 does not fit

    Fit fit = Fit::whole;
    double zoom = 1.0;  // if free
    double x = 0.5;     // centre of the view, 0 left to 1 right
    double y = 0.5;     // 0 top to 1 bottom

    bool operator==(const PictureView&) const = default;
    /// The effective zoom of a picture in a view, both in device pixels.
    double zoom_for(Extent picture, Extent view) const;
    /// Sets the zoom to `next` and keeps the point (at_x, at_y) of the picture, 0..1, in place.
    void zoom_about(double at_x, double at_y, double present, double next);
};

/// The next zoom in (or out): 1/8 1/4 1/2 1 2 3 4 6 8 12 16 24 32 48 64 96 128.
double next_zoom(double zoom, bool is_in);

/// The position of a picture in a view, in device pixels from the top left.
struct PicturePosition {
    double left = 0.0;  // of the picture in the view; negative: cropped
    double top = 0.0;
    double zoom = 1.0;

    /// The pixel of the picture at a point of the view.
    std::array<double, 2> pixel_at(double x, double y) const {
        return {(x - left) / zoom, (y - top) / zoom};
    }
};
/// The corner of the picture is at a whole pixel of the view, so that 1:1 is exact.
PicturePosition position_of(const PictureView& view, Extent picture, Extent size);

/// The position of a wipe line, in device pixels from the left of the view. `share` is relative to
/// the visible part of the picture.
int wipe_column(const PicturePosition& place, Extent picture, Extent size, double share);
/// The share at a position of the line.
double wipe_share(const PicturePosition& place, Extent picture, Extent size, double column);

/// The displayed channels of a pass.
enum class Channels { color, red, green, blue, alpha, luminance };

/// The inspected texture and its display settings.
struct PassView {
    std::string pass;                    // the selected pass; "": not selected
    std::optional<TextureChoice> other;  // instead of its current picture
    Levels levels;                       // stored values that are displayed as black and white
    double exposure = 0.0;               // stops, relative to black
    Channels channels = Channels::color;
    bool marks_flaws = false;  // marks non-finite and negative values
    bool marks_clipping = false;
    bool is_false_color = false;
    PictureView view{PictureView::Fit::all};

    bool operator==(const PassView&) const = default;
    /// Inspects the current picture of a pass.
    void look_into(const std::string& name);
    /// Inspects any texture; that of a pass also selects the pass.
    void look_into(const TextureChoice& choice);
    /// The name of the inspected texture: "persistence", "noise mip 2".
    std::string label() const { return other ? other->label() : pass; }
    /// Fits black and white to the range of all finite values.
    void fit(const Statistics& statistics);
    /// Resets levels and exposure.
    void reset_levels();
    bool has_levels() const { return levels != Levels{} || exposure != 0.0; }
};

/// A pixel under the pointer, from the top left.
struct Probe {
    std::string pass;  // or another texture, as in TextureChoice::label()
    int x = 0;
    int y = 0;
    bool is_of_variant = false;  // of the reference of a comparison
    Extent extent = {};          // size in px of the probed texture

    bool operator==(const Probe&) const = default;
};

/// A position that is probed in every pass: 0..1 from the left and from the top.
struct Pin {
    double x = 0.5;
    double y = 0.5;

    bool operator==(const Pin&) const = default;
    /// The texel at this position in a target.
    std::array<int, 2> texel(Extent extent) const;
};

/// The centre of a probed pixel.
Pin pin_at(const Probe& probe);

/// The line over the picture for the waveform.
struct ScanLine {
    Pin start{0.0, 0.5};
    Pin end{1.0, 0.5};

    bool operator==(const ScanLine&) const = default;
    /// A horizontal line through the centre of a row of texels.
    static ScanLine along_row(int row, int height);
    /// The row of a horizontal line; nullopt: not horizontal.
    std::optional<int> row(Extent extent) const;
};

/// Sizes of the picture views in device pixels.
struct ViewSizes {
    Extent picture;
    Extent inspector;
    Extent output;  // empty while closed
    Extent cell;    // size of a texel that fits its numbers
    int thumbnail_height = 0;
};

/// The open modal dialog.
struct Dialog {
    enum class Kind {
        none,
        open_file,
        choose_file,  // for the parameter or signal in `subject`
        choose_reference,
        save_picture,
        save_pass,  // of the pass in `subject`
        load_drawing,
        save_drawing,
        save_automation,
        save_slangp,
        save_preset_as,
        rename_preset,
        new_look,
        duplicate_look,
        palette,
        compare_preset,  // with the current values; `changes` has the differences
        remote,
        impulse,  // impulse response of every pass
        rates,    // comparison of frame rates
        keys,
        about,
        asked,          // a number or text for the choice with the id in `subject`
        export_frames,  // destination and duration
        exporting,
    };

    Kind kind = Kind::none;
    std::string text = {};              // the typed name or path
    std::filesystem::path folder = {};  // the listed folder
    std::vector<FolderEntry> entries = {};
    std::string subject = {};  // the object of the dialog
    int chosen = 0;            // selected row of a list
    std::vector<Change> changes = {};
    bool is_new = true;  // not drawn yet

    bool operator==(const Dialog&) const = default;
};

/// The history state to which the history panel was last scrolled.
struct HistorySeen {
    std::size_t place = 0;
    std::size_t size = 0;

    bool operator==(const HistorySeen&) const = default;
};

/// The parameter and component under the pointer.
struct Pointed {
    std::string parameter;
    std::size_t component = 0;

    bool operator==(const Pointed&) const = default;
};

/// The revealed parameter in the panel, which the keys change.
struct Revealed {
    std::string parameter;        // "": not set
    bool is_new = false;          // not scrolled to yet
    std::size_t component = 0;    // the component that the keys change
    bool is_to_be_typed = false;  // focus its number field

    bool operator==(const Revealed&) const = default;
};

/// The filter of the parameter list.
enum class ParameterFilter { all, changed, favourites, of_pass };

/// The filter of the preset browser, and the duration of a morph.
struct PresetBrowsing {
    std::string search;
    bool only_starred = false;       // also for the next and previous preset keys
    bool shows_own_content = false;  // pictures show the user's signal or source
    double morph_seconds = 3.0;

    bool operator==(const PresetBrowsing&) const = default;
};

/// The frame rate limit of the window.
struct FrameRate {
    static constexpr double no_cap = 1000.0;

    bool waits_for_display = true;  // vertical synchronisation
    double cap = 0.0;               // frames/s; 0: the display's refresh rate

    bool operator==(const FrameRate&) const = default;
    /// The minimum seconds between frames for this refresh rate of the display.
    double frame_seconds(double display_rate) const;
    /// Whether the target is more than 30 frames/s.
    bool wants_30(double display_rate) const { return frame_seconds(display_rate) < 1.0 / 31.0; }
};

/// The full-screen window with only the picture.
struct OutputState {
    bool is_open = false;
    bool is_black = false;
    std::optional<std::size_t> monitor;  // chosen by the user; nullopt: another than the panels'

    bool operator==(const OutputState&) const = default;
    /// The display to use, of `count`, if the panels are on `panels`.
    std::size_t monitor_for(std::size_t count, std::size_t panels) const;
};

/// The tutorial on the first start: three steps, each marked when done.
struct FirstSteps {
    bool is_shown = false;
    bool has_turned = false;  // a parameter was changed
    bool has_driven = false;  // another signal or picture was used
    bool has_looked = false;  // a pass was inspected

    bool operator==(const FirstSteps&) const = default;
    bool are_done() const { return has_turned && has_driven && has_looked; }
};

/// Requested fits that wait for a measurement.
struct PendingFits {
    bool levels = false;  // black and white of the inspected texture
    bool gain = false;    // gain of the displayed difference

    bool operator==(const PendingFits&) const = default;
    bool is_any() const { return levels || gain; }
};

/// The user's layout of the window and what it displays. A value; the session stores the layout.
struct WindowState {
    Extent size{1440, 900};  // screen coordinates
    std::optional<std::array<int, 2>> position;
    bool is_maximised = false;
    double scale = 1.0;  // of text and controls, on top of the display's own
    FrameRate frame_rate;
    OutputState output;
    FirstSteps first_steps;
    bool has_offered_move = false;  // offered to move presets out of the program's folder

    WindowLayout layout;
    bool walks_menus = false;   // with the keyboard
    bool gives_keys = false;    // keys go to the look under the pointer
    bool shows_flashes = true;  // the flash meter
    FlashLimit comfort;

    PictureView picture;
    PassView inspected;
    PendingFits pending;
    bool shows_pass_large = false;  // the inspected pass instead of the picture
    double wipe_share = 0.5;        // position of the wipe line in the picture
    std::optional<Probe> probe;
    std::vector<Pin> pins;
    ScanLine scan_line;
    std::optional<double> scan_place;            // 0..1 along it, hovered in the plot
    bool plots_luminance = false;                // instead of red, green and blue
    double budget_milliseconds = 1000.0 / 60.0;  // GPU time budget of all passes
    ViewSizes views;
    std::string search;         // in the parameters panel
    std::string listed_look;    // the look listed last
    bool is_searching = false;  // focus the search box
    Revealed revealed;
    std::optional<Pointed> pointed;
    HistorySeen history_seen;
    std::string strip_seen;                 // pass to which the strip last scrolled
    std::vector<std::string> used;          // palette entry ids, last used first
    std::vector<std::string> recent_files;  // opened files, the latest first
    ParameterFilter filter = ParameterFilter::all;
    PresetBrowsing presets;
    Dialog dialog;
    std::filesystem::path last_folder;
    double export_fps = 60.0;
    double export_seconds = 0.0;  // 0: default

    /// The view of the picture, or of the pass that replaces it.
    PictureView& large_view() { return shows_pass_large ? inspected.view : picture; }
    const PictureView& large_view() const { return shows_pass_large ? inspected.view : picture; }
};
