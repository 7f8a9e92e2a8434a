#pragma once

#include "lab/document/changes.h"
#include "lab/storage/folder.h"
#include "model/look/extent.h"
#include "model/look/texture_choice.h"
#include "model/picture/comfort_clamp.h"
#include "model/picture/levels.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// How a picture lies in its view. The zoom is in device pixels of the screen a pixel of the
/// picture.
struct PictureView {
    enum class Fit {
        whole,
        all,
        free
    };  // whole: the largest whole zoom that shows all; where 1 is too large, what shows all

    Fit fit = Fit::whole;
    double zoom = 1.0;  // when free
    double x = 0.5;     // what lies in the middle, 0 left .. 1 right
    double y = 0.5;     // 0 top .. 1 bottom

    bool operator==(const PictureView&) const = default;
    /// The zoom in force for a picture in a view, both in device pixels.
    double zoom_for(Extent picture, Extent view) const;
    /// Zooms to `next` so that the point of the picture at (at_x, at_y), 0..1, stays where it is.
    void zoom_about(double at_x, double at_y, double present, double next);
};

/// The zoom one notch further in (or out): 1/8 1/4 1/2 1 2 3 4 6 8 12 16 24 32 48 64 96 128.
double next_zoom(double zoom, bool is_in);

/// Where a picture lies in a view: both in device pixels, from the top left.
struct PicturePlace {
    double left = 0.0;  // of the picture in the view; below 0 when it is cut there
    double top = 0.0;
    double zoom = 1.0;

    /// The pixel of the picture under a point of the view.
    std::array<double, 2> pixel_at(double x, double y) const {
        return {(x - left) / zoom, (y - top) / zoom};
    }
};
/// The picture's corner falls on a whole pixel of the view, so that 1:1 is 1:1.
PicturePlace place_of(const PictureView& view, Extent picture, Extent size);

/// Where the line of a wipe stands in a view, in device pixels from its left: `share` of the way
/// over what of the picture can be seen.
int wipe_column(const PicturePlace& place, Extent picture, Extent size, double share);
/// The share at which the line stands there.
double wipe_share(const PicturePlace& place, Extent picture, Extent size, double column);

/// What of a pass's numbers is shown.
enum class Channels { color, red, green, blue, alpha, luminance };

/// What a person looks into, and how.
struct PassView {
    std::string pass;                    // that is chosen; "": none
    std::optional<TextureChoice> other;  // in the place of its present picture
    Levels levels;                       // stored numbers that are seen as black and as white
    double exposure = 0.0;               // stops, from black on
    Channels channels = Channels::color;
    bool marks_flaws = false;  // what is not finite, and what is negative
    bool marks_clipping = false;
    bool is_false_color = false;
    PictureView view{PictureView::Fit::all};

    bool operator==(const PassView&) const = default;
    /// Into the present picture of a pass.
    void look_into(const std::string& name);
    /// Into anything: a pass's pictures choose the pass too.
    void look_into(const TextureChoice& choice);
    /// What it is looked into: "persistence", "noise mip 2".
    std::string label() const { return other ? other->label() : pass; }
    /// So that every finite number is seen.
    void fit(const Statistics& statistics);
    /// Levels and exposure as at first.
    void reset_levels();
    bool has_levels() const { return levels != Levels{} || exposure != 0.0; }
};

/// A pixel under the pointer, from the top left.
struct Probe {
    std::string pass;  // or what else is looked into, as TextureChoice::label says it
    int x = 0;
    int y = 0;
    bool is_of_variant = false;  // what is compared with
    Extent extent = {};          // px of what it is a pixel of

    bool operator==(const Probe&) const = default;
};

/// A point that is looked at in every pass: 0..1 from the left and from the top.
struct Pin {
    double x = 0.5;
    double y = 0.5;

    bool operator==(const Pin&) const = default;
    /// The texel of a target that it lies in.
    std::array<int, 2> texel(Extent extent) const;
};

/// The middle of a probed pixel.
Pin pin_at(const Probe& probe);

/// A line over the picture along which numbers are plotted.
struct ScanLine {
    Pin start{0.0, 0.5};
    Pin end{1.0, 0.5};

    bool operator==(const ScanLine&) const = default;
    /// From the left to the right through the middle of a row of texels.
    static ScanLine along_row(int row, int height);
    /// The row that it lies in from end to end; none where it goes up or down.
    std::optional<int> row(Extent extent) const;
};

/// What the pane at the bottom holds.
enum class BottomPart { problems, timings, pins, inputs, text, graph, sheet, waveform, presets };

/// Device pixels that the panels have for pictures.
struct ViewSizes {
    Extent picture;
    Extent inspector;
    Extent output;  // empty while it is closed
    Extent cell;    // that a texel needs for its numbers
    int thumbnail_height = 0;
};

/// Widths and heights of the panes in pixels at a scale of 1.
struct PaneSizes {
    float left = 252.0f;
    float right = 344.0f;
    float strip = 132.0f;
    float bottom = 150.0f;
    float inspector = 330.0f;

    bool operator==(const PaneSizes&) const = default;
};

/// What is asked or told above everything else.
struct Dialog {
    enum class Kind {
        none,
        open_file,
        choose_file,  // for the parameter or signal in `subject`
        choose_reference,
        save_picture,
        save_pass,  // of the name in `subject`
        load_drawing,
        save_drawing,
        save_moves,
        save_slangp,
        save_preset_as,
        rename_preset,
        new_look,
        duplicate_look,
        palette,
        compare_preset,  // with what is open; `changes` has the differences
        remote,
        impulse,  // how a flash falls in every pass
        rates,    // how far pictures of several frame rates are apart
        keys,
        about,
        asked,          // a number or words for the choice of the id in `subject`
        export_frames,  // where to, and how much
        exporting,
    };

    Kind kind = Kind::none;
    std::string text = {};              // a name or path as typed so far
    std::filesystem::path folder = {};  // that is listed
    std::vector<FolderEntry> entries = {};
    std::string subject = {};  // what the answer is for
    int chosen = 0;            // row of a list
    std::vector<Change> changes = {};
    bool is_new = true;  // has not been drawn yet

    bool operator==(const Dialog&) const = default;
};

/// Where the list of the history was when it was last scrolled to the present state.
struct HistorySeen {
    std::size_t place = 0;
    std::size_t size = 0;

    bool operator==(const HistorySeen&) const = default;
};

/// The parameter under the pointer, and which of its numbers.
struct Pointed {
    std::string parameter;
    std::size_t component = 0;

    bool operator==(const Pointed&) const = default;
};

/// The parameter that a person asked to see in its panel; keys turn it.
struct Revealed {
    std::string parameter;        // "": none
    bool is_new = false;          // it is yet to be scrolled to
    std::size_t component = 0;    // which of its parts keys turn
    bool is_to_be_typed = false;  // its number is to have the keyboard

    bool operator==(const Revealed&) const = default;
};

/// Which parameters are listed.
enum class ParameterFilter { all, changed, favourites, of_pass };

/// Which presets are listed as pictures, and how long a morph to one takes.
struct PresetBrowsing {
    std::string search;
    bool only_starred = false;       // also what the keys for the next and previous one go through
    bool shows_own_content = false;  // the pictures show the user's signal or source
    double morph_seconds = 3.0;

    bool operator==(const PresetBrowsing&) const = default;
};

/// How many frames a second the window draws.
struct FrameRate {
    static constexpr double no_cap = 1000.0;

    bool waits_for_display = true;  // a frame is shown whole, when the display begins a new one
    double cap = 0.0;               // frames/s; 0: as many as the display shows

    bool operator==(const FrameRate&) const = default;
    /// The least seconds from one frame to the next on a display that shows so many a second.
    double frame_seconds(double display_rate) const;
    /// Whether frames are to come more than 30 times a second.
    bool wants_30(double display_rate) const { return frame_seconds(display_rate) < 1.0 / 31.0; }
};

/// The window that shows the picture alone, over all of a display.
struct OutputState {
    bool is_open = false;
    bool is_black = false;
    std::optional<std::size_t>
        monitor;  // as the person chose; none: another than the panels are on

    bool operator==(const OutputState&) const = default;
    /// The display it belongs on, of `count`, while the panels are on `panels`.
    std::size_t monitor_for(std::size_t count, std::size_t panels) const;
};

/// What is shown at the very first start: three things to do, each ticked off once done.
struct FirstSteps {
    bool is_shown = false;
    bool has_turned = false;  // a parameter
    bool has_driven = false;  // the look, by another signal or picture
    bool has_looked = false;  // into a pass

    bool operator==(const FirstSteps&) const = default;
    bool are_done() const { return has_turned && has_driven && has_looked; }
};

/// What the user asked to be fitted, and waits for a measurement.
struct PendingFits {
    bool levels = false;  // black and white of the inspected texture
    bool gain = false;    // of the difference that is shown

    bool operator==(const PendingFits&) const = default;
    bool is_any() const { return levels || gain; }
};

/// How a person has arranged the window, and what they look at. A value; the session keeps the
/// arrangement.
struct WindowState {
    Extent size{1440, 900};  // screen coordinates
    std::optional<std::array<int, 2>> position;
    bool is_maximised = false;
    double scale = 1.0;  // of text and controls, on top of the display's own
    FrameRate frame_rate;
    OutputState output;
    FirstSteps first_steps;
    bool has_offered_move = false;  // of the user's presets out of the program's folder

    PaneSizes panes;
    bool shows_library = true;
    bool shows_history = false;  // in the place of looks and signal
    bool shows_parameters = true;
    bool shows_inspector = true;
    bool shows_strip = true;
    bool shows_bottom = false;
    BottomPart bottom_part = BottomPart::problems;
    bool is_picture_only = false;
    bool walks_menus = false;   // by keys
    bool gives_keys = false;    // to the look, whose picture the pointer is over
    bool shows_flashes = true;  // how often the picture does
    ComfortClamp comfort;

    PictureView picture;
    PassView inspected;
    PendingFits pending;
    bool shows_pass_large = false;  // the inspected pass, in the picture's place
    double wipe_share = 0.5;        // how far over the picture the line of a wipe stands
    std::optional<Probe> probe;
    std::vector<Pin> pins;
    ScanLine scan_line;
    std::optional<double> scan_place;            // 0..1 along it, under the pointer in its plot
    bool plots_luminance = false;                // in the place of red, green and blue
    double budget_milliseconds = 1000.0 / 60.0;  // that all passes of a frame may take the GPU
    ViewSizes views;
    std::string search;         // among the parameters
    std::string listed_look;    // the one whose parameters were listed last
    bool is_searching = false;  // the search box is to have the keyboard
    Revealed revealed;
    std::optional<Pointed> pointed;
    HistorySeen history_seen;
    std::string strip_seen;                 // the pass that the strip was last scrolled to
    std::vector<std::string> used;          // ids of the palette's entries, the last used first
    std::vector<std::string> recent_files;  // that were opened, the last one first
    ParameterFilter filter = ParameterFilter::all;
    PresetBrowsing presets;
    Dialog dialog;
    std::filesystem::path last_folder;
    double export_fps = 60.0;
    double export_seconds = 0.0;  // 0: what is usual

    bool sees(BottomPart part) const {
        return shows_bottom && bottom_part == part && !is_picture_only;
    }
    /// How what lies in the picture's place is seen.
    PictureView& large_view() { return shows_pass_large ? inspected.view : picture; }
    const PictureView& large_view() const { return shows_pass_large ? inspected.view : picture; }
};
