#include "formats/scene/scene_items.h"

#include "formats/scene/obj_file.h"
#include "formats/svg/svg_file.h"
#include "io/pictures/picture_file.h"
#include "signals/drawing/shapes.h"
#include "signals/drawing/stroke_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace {
constexpr double largest_number = 1e6;

std::optional<std::vector<double>> numbers_of(ObjectReader& reader, const JsonValue& value,
                                              std::size_t fewest, std::size_t maximum) {
    std::vector<double> numbers;
    bool is_good = value.is(JsonValue::Kind::array);
    if (is_good)
        for (const JsonValue& child : value.children) {
            is_good = is_good && child.is(JsonValue::Kind::number) &&
                      std::abs(child.number) <= largest_number;
            numbers.push_back(child.number);
        }
    if (is_good && numbers.size() >= fewest && numbers.size() <= maximum)
        return numbers;
    const char* words = "expected a list of {1} or {2} numbers";  // for a point in a list
    if (!value.key.empty())
        words = fewest == maximum ? "'{0}' must be a list of {1} numbers"
                                  : "'{0}' must be a list of {1} or {2} numbers";
    reader.problem(value, fmt::format(fmt::runtime(words), value.key, fewest, maximum));
    return std::nullopt;
}

double bounded(ObjectReader& reader, std::string_view key, double fallback, double low,
               double high) {
    const double value = reader.number(key, fallback);
    if (value >= low && value <= high)
        return value;
    if (const JsonValue* given = reader.find(key))
        reader.problem(
            *given, fmt::format("'{}' must be between {} and {}, got {}", key, format_number(low),
                                format_number(high), format_number(value)));
    return fallback;
}

ScenePoint point_of(ObjectReader& reader, const JsonValue& value) {
    const auto numbers = numbers_of(reader, value, 2, 3);
    if (!numbers)
        return {};
    return {(*numbers)[0], (*numbers)[1], numbers->size() > 2 ? (*numbers)[2] : 0.0};
}

ScenePoint required_point(ObjectReader& reader, std::string_view key) {
    const JsonValue* value = reader.require(key);
    return value ? point_of(reader, *value) : ScenePoint{};
}

std::array<double, 2> pair_of(ObjectReader& reader, std::string_view key,
                              std::array<double, 2> fallback) {
    const JsonValue* value = reader.find(key);
    const auto numbers = value ? numbers_of(reader, *value, 2, 2) : std::nullopt;
    return numbers ? std::array{(*numbers)[0], (*numbers)[1]} : fallback;
}

// A rotation: one angle in degrees in the screen plane, or three about x, y and z.
std::array<double, 3> turn_of(ObjectReader& reader, std::string_view key) {
    const JsonValue* value = reader.find(key);
    if (!value)
        return {};
    if (value->is(JsonValue::Kind::number) && std::abs(value->number) <= largest_number)
        return {0.0, 0.0, value->number};
    if (!value->is(JsonValue::Kind::array)) {
        reader.problem(*value,
                       fmt::format("'{}' must be an angle in degrees or a list of 3 angles", key));
        return {};
    }
    const auto numbers = numbers_of(reader, *value, 3, 3);
    return numbers ? std::array{(*numbers)[0], (*numbers)[1], (*numbers)[2]}
                   : std::array<double, 3>{};
}

std::vector<ScenePath> read_points(ObjectReader& reader, bool is_closed) {
    const JsonValue* value = reader.require("points");
    if (!value || !reader.expect(*value, JsonValue::Kind::array))
        return {};
    ScenePath path;
    for (const JsonValue& point : value->children)
        path.points.push_back(point_of(reader, point));
    if (path.points.size() < 2)
        reader.problem(*value, "'points' must have at least two points");
    else if (is_closed)
        path.points.push_back(path.points.front());
    return {path};
}

std::vector<ScenePath> read_line(ObjectReader& reader) {
    const ScenePoint from = required_point(reader, "from");
    return {{{from, required_point(reader, "to")}}};
}

std::vector<ScenePath> read_polyline(ObjectReader& reader) {
    return read_points(reader, reader.boolean("closed", false));
}

std::vector<ScenePath> read_polygon(ObjectReader& reader) {
    if (reader.find("points"))
        return read_points(reader, true);
    const int sides = reader.whole("sides", 6, 2, 1000);
    const int skip = reader.whole("skip", 1, 1, 1000);
    return polygon_paths(bounded(reader, "radius", 0.5, 1e-6, 1000), sides, skip);
}

std::vector<ScenePath> read_circle(ObjectReader& reader) {
    return {arc_path(bounded(reader, "radius", 0.5, 1e-6, 1000), 0.0, 360.0)};
}

std::vector<ScenePath> read_arc(ObjectReader& reader) {
    const double radius = bounded(reader, "radius", 0.5, 1e-6, 1000);
    const double from = bounded(reader, "from", 0.0, -3600, 3600);
    return {arc_path(radius, from, bounded(reader, "to", 90.0, -3600, 3600))};
}

std::vector<ScenePath> read_dot(ObjectReader&) {
    return {{{{0.0, 0.0}}}};
}

std::vector<ScenePath> read_text(ObjectReader& reader) {
    reader.require("text");
    std::string text = reader.text("text");
    constexpr std::size_t max_letters = 16'384;
    if (text.size() > max_letters) {
        reader.problem(
            *reader.find("text"),
            fmt::format("'text' has {} bytes; the limit is {}. Split it into several items.",
                        text.size(), max_letters));
        text.clear();
    }
    const double height = bounded(reader, "height", 0.2, 1e-6, 1000);
    const auto align = reader.choice<TextAlign>(
        "align",
        {{"left", TextAlign::left}, {"middle", TextAlign::middle}, {"right", TextAlign::right}},
        TextAlign::middle);
    return text_paths(text, height, align);
}

std::vector<ScenePath> read_grid(ObjectReader& reader) {
    const auto size = pair_of(reader, "size", {1.8, 1.8});
    const int columns = reader.whole("columns", 10, 1, 200);
    return grid_paths(size[0], size[1], columns, reader.whole("rows", 10, 1, 200));
}

// The file named by an item, relative to the scene; "" if it is missing or outside the folder.
std::filesystem::path sibling_file(ObjectReader& reader) {
    const JsonValue* value = reader.require("file");
    if (!value || !reader.expect(*value, JsonValue::Kind::text))
        return {};
    const std::filesystem::path name(value->text);
    if (!is_in_scene_folder(name)) {
        reader.problem(*value, "'file' must be in the scene's folder or in a folder below it");
        return {};
    }
    return reader.file().parent_path() / name;
}

// The value, or nullopt with its errors, at the scene's line if they have no line.
template <class T>
std::optional<T> taken(ObjectReader& reader, Result<T> read) {
    if (read)
        return std::move(*read);
    const JsonValue& name = *reader.find("file");
    for (const Diagnostic& reason : read.error())
        if (reason.line > 0)
            reader.problems().push_back(reason);
        else
            reader.problem(name, fmt::format("can't read '{}': {}", name.text, reason.message));
    return std::nullopt;
}

std::vector<ScenePath> read_svg(ObjectReader& reader) {
    const double size = bounded(reader, "size", 1.0, 1e-6, 1000);
    const auto file = sibling_file(reader);
    auto paths = file.empty() ? std::nullopt : taken(reader, load_svg(file));
    return paths ? fitted_paths(std::move(*paths), size) : std::vector<ScenePath>();
}

std::vector<ScenePath> read_wireframe(ObjectReader& reader) {
    const double size = bounded(reader, "size", 1.0, 1e-6, 1000);
    const auto file = sibling_file(reader);
    auto paths = file.empty() ? std::nullopt : taken(reader, load_obj(file));
    return paths ? fitted_paths(std::move(*paths), size) : std::vector<ScenePath>();
}

std::vector<ScenePath> read_raster(ObjectReader& reader) {
    const double height = bounded(reader, "height", 1.0, 1e-6, 1000);
    const int lines = reader.whole("lines", 60, 1, 1024);
    const auto file = sibling_file(reader);
    const auto picture = file.empty() ? std::nullopt : taken(reader, load_picture(file));
    return picture ? raster_paths(*picture, height, lines) : std::vector<ScenePath>();
}

using ReadShape = std::vector<ScenePath> (*)(ObjectReader&);
const Choices<ReadShape>& shapes() {
    static const Choices<ReadShape> known{
        {"line", read_line},           {"polyline", read_polyline}, {"polygon", read_polygon},
        {"circle", read_circle},       {"arc", read_arc},           {"dot", read_dot},
        {"text", read_text},           {"grid", read_grid},         {"svg", read_svg},
        {"wireframe", read_wireframe}, {"raster", read_raster}};
    return known;
}
}  // namespace

bool is_in_scene_folder(const std::filesystem::path& name) {
    return !name.empty() && name.is_relative() &&
           std::ranges::find(name, std::filesystem::path("..")) == name.end();
}

SceneItem read_scene_item(ObjectReader& reader) {
    SceneItem item;
    item.at = pair_of(reader, "at", {0.0, 0.0});
    item.scale = bounded(reader, "scale", 1.0, 1e-6, 1e6);
    item.turn = turn_of(reader, "turn");
    item.spin = turn_of(reader, "spin");
    item.perspective = bounded(reader, "perspective", 0.0, 0.0, 1e6);
    item.current = bounded(reader, "intensity", 1.0, 0.0, 16.0);
    item.speed = bounded(reader, "speed", 1.0, 1e-3, 1e3);
    reader.require("shape");
    const auto read = reader.choice<ReadShape>("shape", shapes(), nullptr);
    // A dot is only the beam's dwell.
    const double dwell_us = read == read_dot ? 100.0 : 0.0;
    item.dwell_seconds = 1e-6 * bounded(reader, "dwell", dwell_us, 0.0, 1e6);
    if (!read)
        return item;
    item.paths = read(reader);
    reader.report_unknown_keys();
    return item;
}
