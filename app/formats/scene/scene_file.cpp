#include "formats/scene/scene_file.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/json/object_reader.h"
#include "formats/scene/obj_file.h"
#include "formats/scene/scene_items.h"
#include "formats/svg/svg_file.h"
#include "signals/drawing/shapes.h"

#include <fmt/format.h>

namespace {
constexpr FileFormat scene_file{"afterglow-scene", 1};

double positive(ObjectReader& reader, std::string_view key, double fallback, bool may_be_zero) {
    const double value = reader.number(key, fallback);
    if (value > 0.0 || (may_be_zero && value == 0.0))
        return value;
    if (const JsonValue* given = reader.find(key))
        reader.problem(*given,
                       may_be_zero
                           ? fmt::format("'{}' must be 0 or more, got {}", key, shown_json(*given))
                           : fmt::format("'{}' must be above 0, got {}", key, shown_json(*given)));
    return fallback;
}

// Stops at the first item beyond the limit: many small items could take gigabytes.
void read_items(const JsonValue& items, ObjectReader& reader, BeamScene& scene) {
    if (!reader.expect(items, JsonValue::Kind::array))
        return;
    if (items.children.empty())
        reader.problem(items, "the scene has nothing to draw; add items");
    std::size_t points = 0;
    for (const JsonValue& value : items.children) {
        ObjectReader item(value, reader.file(), reader.problems());
        scene.items.push_back(read_scene_item(item));
        for (const ScenePath& path : scene.items.back().paths)
            points += path.points.size();
        if (points > max_scene_points) {
            reader.problem(value,
                           fmt::format("too many points up to this item; the limit is {}. Remove "
                                       "or simplify items.",
                                       max_scene_points));
            return;
        }
    }
}

BeamScene read_scene(ObjectReader& reader) {
    const BeamScene defaults;
    BeamScene scene;
    reader.text("name");
    reader.text("about");
    scene.beam_speed = positive(reader, "beam_speed", defaults.beam_speed, false);
    scene.move_speed = positive(reader, "move_speed", defaults.move_speed, false);
    scene.refresh = positive(reader, "refresh", defaults.refresh, true);
    const bool is_visible =
        reader.choice<bool>("moves", {{"blanked", false}, {"visible", true}}, false);
    const double intensity = positive(reader, "move_intensity", 0.15, true);
    scene.move_current = is_visible ? intensity : 0.0;
    if (const JsonValue* items = reader.require("items"))
        read_items(*items, reader, scene);
    reader.report_unknown_keys();
    return scene;
}
}  // namespace

Result<BeamScene> parse_scene(std::string_view text, const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    BeamScene scene;
    if (accept_header(reader, scene_file))
        scene = read_scene(reader);
    if (!problems.empty())
        return fail(std::move(problems));
    return scene;
}

namespace {
bool is_obj_file(const std::filesystem::path& file) {
    return to_lower(file.extension().string()) == ".obj";
}

// A scene with a single centred model.
Result<BeamScene> scene_of_model(const std::filesystem::path& file) {
    constexpr double size = 1.5;  // half screens, for its longest side
    auto paths = load_obj(file);
    if (!paths)
        return fail(paths.error());
    BeamScene scene;
    scene.items.push_back({.paths = fitted_paths(std::move(*paths), size)});
    return scene;
}
}  // namespace

Result<BeamScene> load_scene(const std::filesystem::path& file) {
    if (is_obj_file(file))
        return scene_of_model(file);
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    return parse_scene(*text, file);
}

std::vector<std::filesystem::path> files_of_scene(const std::filesystem::path& scene) {
    std::vector<std::filesystem::path> files;
    const auto text = read_text(scene);
    const auto document = text ? parse_json(*text, scene) : fail(Diagnostics{});
    Diagnostics problems;
    if (!document || document->kind != JsonValue::Kind::object)
        return files;
    ObjectReader reader(*document, scene, problems);
    const JsonValue* items = reader.find("items");
    if (!items || items->kind != JsonValue::Kind::array)
        return files;
    for (const JsonValue& value : items->children) {
        ObjectReader item(value, scene, problems);
        if (const std::filesystem::path file = item.text("file"); is_in_scene_folder(file))
            files.push_back(file);
    }
    return files;
}

bool is_scene_file(const std::filesystem::path& file) {
    if (is_obj_file(file))
        return true;
    if (to_lower(file.extension().string()) != ".json")
        return false;
    const auto text = read_text(file);
    const auto document = text ? parse_json(*text, file) : fail(text.error());
    const JsonValue* format = document ? find_member(*document, "format") : nullptr;
    return format && format->text == scene_file.name;
}

bool is_svg_file(const std::filesystem::path& file) {
    const std::string ending = to_lower(file.extension().string());
    return ending == ".svg" || ending == ".svgz";
}

bool is_drawing_or_scene(const std::filesystem::path& file) {
    return is_svg_file(file) || is_obj_file(file) || to_lower(file.extension().string()) == ".json";
}
