#include "lab/window/window_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace {
constexpr std::initializer_list<std::pair<const char*, float PaneSizes::*>> sizes{
    {"left_size", &PaneSizes::left},
    {"right_size", &PaneSizes::right},
    {"strip_size", &PaneSizes::strip},
    {"bottom_size", &PaneSizes::bottom},
    {"inspector_size", &PaneSizes::inspector}};

// Prefixes of palette entries, recent files and looks. The number is the position, 0 = last used.
constexpr std::string_view used_prefix = "used:";
constexpr std::string_view recent_prefix = "recent:";
constexpr std::string_view look_prefix = "look:";
// Prefix of the last folder of a kind of file dialog: "folder:KEY:PATH". The number has no meaning.
constexpr std::string_view folder_prefix = "folder:";
// Prefix of the address of a program that a look was sent to: "send:PROGRAM:ADDRESS".
constexpr std::string_view address_prefix = "send:";

std::vector<std::string> restored_use(const std::map<std::string, double>& numbers,
                                      std::string_view prefix) {
    std::vector<std::pair<double, std::string>> ranked;
    for (const auto& [name, rank] : numbers)
        if (name.starts_with(prefix))
            ranked.emplace_back(rank, name.substr(prefix.size()));
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::string> used;
    for (auto& [rank, id] : ranked)
        used.push_back(std::move(id));
    return used;
}

void remember_use(const std::vector<std::string>& used, std::string_view prefix,
                  std::map<std::string, double>& numbers) {
    for (std::size_t i = 0; i < used.size(); ++i)
        numbers[std::string(prefix) + used[i]] = static_cast<double>(i);
}

// A number within its bounds; nullopt: missing or out of bounds.
std::optional<double> number(const std::map<std::string, double>& numbers, const char* name,
                             double low, double high) {
    const auto found = numbers.find(name);
    if (found == numbers.end() || !(found->second >= low && found->second <= high))
        return std::nullopt;
    return found->second;
}

std::optional<int> whole(const std::map<std::string, double>& numbers, const char* name, double low,
                         double high) {
    const auto found = number(numbers, name, low, high);
    return found ? std::optional(static_cast<int>(std::lround(*found))) : std::nullopt;
}
}  // namespace

namespace {
// The panels that the session stores by their number, in this order.
std::vector<PanelId> bottom_panels(const OpenPanels& panels) {
    std::vector<PanelId> bottom;
    for (const PanelKind& kind : panels.kinds())
        if (kind.place == PanelPlace::bottom)
            bottom.push_back(kind.id);
    return bottom;
}

void remember_panels(const OpenPanels& panels, std::map<std::string, double>& numbers) {
    for (const PanelKind& kind : panels.kinds())
        if (kind.place != PanelPlace::bottom)
            numbers[std::string(kind.id)] = panels.is_open(kind.id) ? 1.0 : 0.0;
    const std::vector<PanelId> bottom = bottom_panels(panels);
    const auto shown = std::ranges::find_if(bottom, [&](PanelId id) { return panels.shows(id); });
    const bool is_open = shown != bottom.end();
    numbers["bottom"] = is_open ? 1.0 : 0.0;
    numbers["bottom_part"] = is_open ? static_cast<double>(shown - bottom.begin()) : 0.0;
}

void restore_panels(const std::map<std::string, double>& numbers, OpenPanels& panels) {
    const std::vector<PanelKind> kinds = panels.kinds();
    for (const PanelKind& kind : kinds) {
        const auto stored = kind.place == PanelPlace::bottom
                                ? std::nullopt
                                : number(numbers, std::string(kind.id).c_str(), 0.0, 1.0);
        if (stored)
            *stored != 0.0 ? panels.show(kind.id) : panels.hide(kind.id);
    }
    const std::vector<PanelId> bottom = bottom_panels(panels);
    if (bottom.empty() || number(numbers, "bottom", 0.0, 1.0).value_or(0.0) == 0.0)
        return;
    const auto last = static_cast<double>(bottom.size() - 1);
    panels.show(
        bottom[static_cast<std::size_t>(whole(numbers, "bottom_part", 0.0, last).value_or(0))]);
}

constexpr std::size_t max_pins = 9;

std::string pin_name(std::size_t index, const char* side) {
    return "pin" + std::to_string(index + 1) + side;
}

// The inspector settings, without the inspected pass.
void remember_looking(const WindowState& window, std::map<std::string, double>& numbers) {
    const PassView& view = window.views.inspected;
    numbers["black"] = view.levels.black;
    numbers["white"] = view.levels.white;
    numbers["exposure"] = view.exposure;
    numbers["channels"] = static_cast<int>(view.channels);
    numbers["plots_luminance"] = window.probes.plots_luminance ? 1.0 : 0.0;
    const ScanLine& line = window.probes.scan_line;
    numbers["line_start_x"] = line.start.x;
    numbers["line_start_y"] = line.start.y;
    numbers["line_end_x"] = line.end.x;
    numbers["line_end_y"] = line.end.y;
    for (std::size_t i = 0; i < std::min(window.probes.pins.size(), max_pins); ++i) {
        numbers[pin_name(i, "_x")] = window.probes.pins[i].x;
        numbers[pin_name(i, "_y")] = window.probes.pins[i].y;
    }
}

std::optional<Pin> pin_of(const std::map<std::string, double>& numbers, const std::string& x_name,
                          const std::string& y_name) {
    const auto x = number(numbers, x_name.c_str(), 0.0, 1.0);
    const auto y = number(numbers, y_name.c_str(), 0.0, 1.0);
    return x && y ? std::optional(Pin{*x, *y}) : std::nullopt;
}

void restore_looking(const std::map<std::string, double>& numbers, WindowState& window) {
    constexpr double maximum = 1e9;
    constexpr auto last_channels = static_cast<double>(Channels::luminance);
    PassView& view = window.views.inspected;
    const auto black = number(numbers, "black", -maximum, maximum);
    const auto white = number(numbers, "white", -maximum, maximum);
    if (black && white && *black < *white)
        view.levels = {*black, *white};
    view.exposure = number(numbers, "exposure", -60.0, 60.0).value_or(0.0);
    view.channels =
        static_cast<Channels>(whole(numbers, "channels", 0.0, last_channels).value_or(0));
    window.probes.plots_luminance =
        number(numbers, "plots_luminance", 0.0, 1.0).value_or(0.0) != 0.0;
    const auto start = pin_of(numbers, "line_start_x", "line_start_y");
    const auto end = pin_of(numbers, "line_end_x", "line_end_y");
    if (start && end)
        window.probes.scan_line = {*start, *end};
    for (std::size_t i = 0; i < max_pins; ++i)
        if (const auto pin = pin_of(numbers, pin_name(i, "_x"), pin_name(i, "_y")))
            window.probes.pins.push_back(*pin);
}
}  // namespace

namespace {
void remember_file_dialogs(const FileDialogChoices& choices,
                           std::map<std::string, double>& numbers) {
    numbers["file_order"] = static_cast<double>(choices.order.key);
    numbers["files_descending"] = choices.order.is_descending ? 1.0 : 0.0;
    numbers["hidden_files"] = choices.shows_hidden ? 1.0 : 0.0;
    numbers["desktop_files"] = choices.uses_desktop ? 1.0 : 0.0;
    for (const auto& [key, folder] : choices.folders)
        numbers[fmt::format("{}{}:{}", folder_prefix, key, folder.string())] = 0.0;
}

void remember_addresses(const SendForm& form, std::map<std::string, double>& numbers) {
    for (const auto& [program, address] : form.addresses)
        if (!address.empty())
            numbers[fmt::format("{}{}:{}", address_prefix, program, address)] = 0.0;
}
}  // namespace

std::map<std::string, double> serialized_window(const WindowState& window) {
    std::map<std::string, double> numbers{
        {"width", window.geometry.size.width},
        {"height", window.geometry.size.height},
        {"view_width", window.views.sizes.picture.width},
        {"view_height", window.views.sizes.picture.height},
        {"scale", window.geometry.scale},
        {"wipe_share", window.views.wipe_share},
        {"vsync", window.frame_rate.waits_for_display ? 1.0 : 0.0},
        {"frame_cap", window.frame_rate.cap},
        {"comfort", window.flashes.limit.is_on ? 1.0 : 0.0},
        {"random_strength", window.parameters.random_strength},
        {"comfort_rate", window.flashes.limit.max_per_second},
        {"budget_ms", window.frame_rate.budget_milliseconds},
        {"starred_presets", window.presets.only_starred ? 1.0 : 0.0},
        {"offered_move", window.presets.has_offered_move ? 1.0 : 0.0},
        {"presets_own_content", window.presets.shows_own_content ? 1.0 : 0.0},
        {"morph_seconds", window.presets.morph_seconds},
        {"flashes", window.flashes.shows_meter ? 1.0 : 0.0},
        {"hdr", window.hdr.is_on ? 1.0 : 0.0},
        {"hdr_paper_white", window.hdr.light.paper_white},
        {"hdr_peak", window.hdr.light.peak},
        {"flicker", static_cast<double>(window.flashes.flicker)},
        {"maximised", window.geometry.is_maximised ? 1.0 : 0.0}};
    if (window.geometry.position) {
        numbers["left"] = (*window.geometry.position)[0];
        numbers["top"] = (*window.geometry.position)[1];
    }
    if (window.output.monitor)
        numbers["output_monitor"] = static_cast<double>(*window.output.monitor);
    remember_panels(window.layout.panels, numbers);
    remember_looking(window, numbers);
    remember_file_dialogs(window.file_dialogs, numbers);
    remember_addresses(window.sending, numbers);
    remember_use(window.recent.commands, used_prefix, numbers);
    remember_use(window.recent.files, recent_prefix, numbers);
    remember_use(window.recent.looks, look_prefix, numbers);
    for (const auto& [name, size] : sizes)
        numbers[name] = static_cast<double>(window.layout.sizes.*size);
    return numbers;
}

namespace {
void restore(const std::map<std::string, double>& numbers, const char* name, Limit limit,
             double& value) {
    value = number(numbers, name, limit.low, limit.high).value_or(value);
}

void restore(const std::map<std::string, double>& numbers, const char* name, bool& value) {
    if (const auto stored = number(numbers, name, 0.0, 1.0))
        value = *stored != 0.0;
}

void restore_geometry(const std::map<std::string, double>& numbers, WindowGeometry& geometry) {
    const auto width = whole(numbers, "width", 320.0, 16384.0);
    const auto height = whole(numbers, "height", 240.0, 16384.0);
    if (width && height)
        geometry.size = {*width, *height};
    const auto left = whole(numbers, "left", -32768.0, 32768.0);
    const auto top = whole(numbers, "top", -32768.0, 32768.0);
    if (left && top)
        geometry.position = {*left, *top};
    restore(numbers, "maximised", geometry.is_maximised);
    restore(numbers, "scale", {0.75, 3.0}, geometry.scale);
}

void restore_presets(const std::map<std::string, double>& numbers, PresetBrowsing& presets) {
    restore(numbers, "starred_presets", presets.only_starred);
    restore(numbers, "offered_move", presets.has_offered_move);
    restore(numbers, "presets_own_content", presets.shows_own_content);
    restore(numbers, "morph_seconds", {0.1, 600.0}, presets.morph_seconds);
}

void restore_file_dialogs(const std::map<std::string, double>& numbers,
                          FileDialogChoices& choices) {
    constexpr auto last_key = static_cast<double>(FileOrder::Key::modified);
    choices.order.key =
        static_cast<FileOrder::Key>(whole(numbers, "file_order", 0.0, last_key).value_or(0));
    restore(numbers, "files_descending", choices.order.is_descending);
    restore(numbers, "hidden_files", choices.shows_hidden);
    restore(numbers, "desktop_files", choices.uses_desktop);
    for (const std::string& stored : restored_use(numbers, folder_prefix)) {
        const std::size_t colon = stored.find(':');
        if (colon != std::string::npos && stored.substr(colon + 1).starts_with('/'))
            choices.folders[stored.substr(0, colon)] = stored.substr(colon + 1);
    }
}

void restore_addresses(const std::map<std::string, double>& numbers, SendForm& form) {
    for (const std::string& stored : restored_use(numbers, address_prefix)) {
        const std::size_t colon = stored.find(':');
        if (colon != std::string::npos && colon + 1 < stored.size())
            form.addresses[stored.substr(0, colon)] = stored.substr(colon + 1);
    }
}
}  // namespace

WindowState restored_window(const std::map<std::string, double>& numbers,
                            std::vector<PanelKind> panels) {
    WindowState window;
    window.layout.panels = OpenPanels(std::move(panels));
    restore_geometry(numbers, window.geometry);
    const auto view_width = whole(numbers, "view_width", 1.0, 16384.0);
    const auto view_height = whole(numbers, "view_height", 1.0, 16384.0);
    if (view_width && view_height)
        window.views.sizes.picture = {*view_width, *view_height};
    restore(numbers, "wipe_share", {0.0, 1.0}, window.views.wipe_share);
    restore(numbers, "flashes", window.flashes.shows_meter);
    restore(numbers, "hdr", window.hdr.is_on);
    restore(numbers, "hdr_paper_white", {hdr_paper_whites[0], hdr_paper_whites[1]},
            window.hdr.light.paper_white);
    restore(numbers, "hdr_peak", {hdr_peaks[0], hdr_peaks[1]}, window.hdr.light.peak);
    window.hdr.light.peak = std::max(window.hdr.light.peak, window.hdr.light.paper_white);
    if (const auto flicker = whole(numbers, "flicker", 0.0, 2.0))
        window.flashes.flicker = static_cast<Flicker>(*flicker);
    restore(numbers, "comfort", window.flashes.limit.is_on);
    restore(numbers, "comfort_rate", {FlashLimit::lowest, FlashLimit::highest},
            window.flashes.limit.max_per_second);
    restore(numbers, "vsync", window.frame_rate.waits_for_display);
    restore(numbers, "frame_cap", {1.0, FrameRate::no_cap}, window.frame_rate.cap);
    restore(numbers, "budget_ms", {0.1, 1000.0}, window.frame_rate.budget_milliseconds);
    if (const auto monitor = whole(numbers, "output_monitor", 0.0, 63.0))
        window.output.monitor = static_cast<std::size_t>(*monitor);
    restore(numbers, "random_strength", {0.01, 1.0}, window.parameters.random_strength);
    restore_presets(numbers, window.presets);
    restore_panels(numbers, window.layout.panels);
    for (const auto& [name, size] : sizes)
        if (const auto stored = number(numbers, name, 60.0, 2000.0))
            window.layout.sizes.*size = static_cast<float>(*stored);
    restore_looking(numbers, window);
    restore_file_dialogs(numbers, window.file_dialogs);
    restore_addresses(numbers, window.sending);
    window.recent.commands = restored_use(numbers, used_prefix);
    window.recent.files = restored_use(numbers, recent_prefix);
    window.recent.looks = restored_use(numbers, look_prefix);
    return window;
}
