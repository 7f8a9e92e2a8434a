#include "formats/look/look_manifest.h"

#include "base/file.h"
#include "formats/json/spec_json.h"
#include "formats/look/look_folder.h"
#include "formats/look/look_names.h"
#include "formats/look/look_passes.h"
#include "glsl/text/shader_files.h"
#include "model/look/subframe.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"
#include "signals/signal_table.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr FileFormat look_file{"afterglow-look", 1};

void read_default_signal(ObjectReader& reader, LookFolder& folder, Look& look) {
    const JsonValue* member = reader.find("default_signal");
    if (!member)
        return;
    if (look.driven_by != Driver::signal && !look.has_other_driver)
        reader.problem(*member, "'default_signal' needs 'driven_by': 'signal'");
    auto spec = read_spec(*member, reader.file(), reader.problems());
    if (!spec)
        return;
    if (spec->kind == "socket" && (spec->settings.contains("path") || spec->settings.contains("")))
        return reader.problem(*member, "a look can't set the path of a socket; remove 'path'");
    const std::string file = file_of(*spec);
    if (!file.empty())
        if (const auto found = folder.find(file, *member, reader))
            spec->settings[find_kind(spec->kind)->file_setting] = found->string();
    look.default_signal = std::move(*spec);
}

void check_pattern(std::string_view pattern, const JsonValue& member, ObjectReader& reader) {
    const std::string_view name = pattern.substr(0, pattern.find(','));
    std::vector<std::string> names;
    for (const PatternInfo& known : all_patterns())
        names.push_back(known.name);
    if (std::find(names.begin(), names.end(), name) == names.end())
        reader.problem(member, fmt::format("unknown pattern '{}'{}; use one of: {}", name,
                                           did_you_mean(name, names), fmt::join(names, ", ")));
}

void read_default_source(ObjectReader& reader, LookFolder& folder, Look& look) {
    const JsonValue* driver = reader.find("driven_by");
    const JsonValue* member = reader.find("default_source");
    const bool has_source = look.driven_by == Driver::picture || look.has_other_driver;
    if (!member && has_source)
        reader.problem(*driver, fmt::format("'driven_by': '{}' needs a 'default_source' such as "
                                            "'pattern:smpte'",
                                            driver->text));
    if (!member || !reader.expect(*member, JsonValue::Kind::text))
        return;
    if (!has_source)
        reader.problem(*member, "'default_source' needs 'driven_by': 'picture'");
    constexpr std::string_view pattern = "pattern:";
    look.default_source = member->text;
    auto source = parse_source(member->text);
    if (!source)
        return reader.problem(*member, source.error().front().message);
    if (source->is_pattern()) {
        check_pattern(std::string_view(source->picture).substr(pattern.size()), *member, reader);
    } else if (source->is_live()) {
        reader.problem(*member, "'default_source' must be a file or a pattern");
    } else if (const auto found = folder.find(source->picture, *member, reader)) {
        source->picture = found->string();
        look.default_source = to_string(*source);
    }
}

std::optional<Image> read_image(const JsonValue& member, ObjectReader& parent, LookFolder& folder) {
    Image image;
    image.name = member.key;
    if (!is_look_name(member.key) || member.key == "source")
        parent.problem(member,
                       with_sentence(fmt::format("'{}' can't be the name of an image", member.key),
                                     look_name_rule()));
    if (member.is(JsonValue::Kind::text)) {
        image.file = folder.find(member.text, member, parent).value_or(fs::path());
        return image;
    }
    ObjectReader reader(member, parent.file(), parent.problems());
    const JsonValue* file = reader.require("file");
    if (file && reader.expect(*file, JsonValue::Kind::text))
        image.file = folder.find(file->text, *file, reader).value_or(fs::path());
    image.sampler = read_sampler(reader);
    image.is_linear = reader.boolean("linear", false);
    reader.report_unknown_keys();
    return image;
}

void read_images(ObjectReader& reader, LookFolder& folder, Look& look) {
    const JsonValue* images = reader.find("images");
    if (!images || !reader.expect(*images, JsonValue::Kind::object))
        return;
    for (const JsonValue& member : images->children)
        if (auto image = read_image(member, reader, folder))
            look.images.push_back(std::move(*image));
}

void read_fading(ObjectReader& reader, Look& look) {
    const JsonValue* member = reader.find("fading");
    if (!member || !reader.expect(*member, JsonValue::Kind::object))
        return;
    ObjectReader fading(*member, reader.file(), reader.problems());
    fading.require("time_constant");
    fading.require("peak");
    look.fading =
        Fading{fading.text("time_constant"), fading.text("peak"), {look.manifest, member->line}};
    fading.report_unknown_keys();
}

void read_groups(ObjectReader& reader, Look& look) {
    const JsonValue* groups = reader.find("groups");
    if (!groups || !reader.expect(*groups, JsonValue::Kind::array))
        return;
    for (const JsonValue& name : groups->children)
        if (reader.expect(name, JsonValue::Kind::text))
            look.groups.push_back({name.text, {look.manifest, name.line}});
}

void read_driver(ObjectReader& reader, Look& look, bool is_picture_driven) {
    enum class Named { signal, picture, either, nothing };
    const Choices<Named> names{{"signal", Named::signal},
                               {"picture", Named::picture},
                               {either_driver, Named::either},
                               {"nothing", Named::nothing}};
    const Named named = reader.choice("driven_by", names, Named::nothing);
    look.has_other_driver = named == Named::either;
    const bool has_picture =
        named == Named::picture || (look.has_other_driver && is_picture_driven);
    look.driven_by = has_picture               ? Driver::picture
                     : named == Named::nothing ? Driver::nothing
                                               : Driver::signal;
}

void read_look(ObjectReader& reader, LookFolder& folder, Look& look, bool is_picture_driven) {
    look.name = reader.text("name", look.id);
    look.about = reader.text("about");
    look.author = reader.text("author");
    look.license = reader.text("license");
    read_driver(reader, look, is_picture_driven);
    read_default_signal(reader, folder, look);
    read_default_source(reader, folder, look);
    look.source_encoding = reader.choice("source_encoding", encoding_names(), Encoding::linear);
    look.output = reader.choice("output", encoding_names(), Encoding::display);
    look.settle_frames = reader.whole("settle_frames", 1, 1, max_settle_frames);
    read_fading(reader, look);
    look.subframes = read_count(reader, "subframes", 1, {1, max_subframes});
    look.has_orbit = reader.boolean("orbit", false);
    read_groups(reader, look);
    read_images(reader, folder, look);
    read_passes(reader, folder, look);
    reader.report_unknown_keys();
}

}  // namespace

// Also for the folder "." and for links.
std::string look_id_of(const fs::path& manifest) {
    std::error_code error;
    return fs::absolute(manifest, error).lexically_normal().parent_path().filename().string();
}

Result<Look> load_manifest(const fs::path& manifest, std::vector<fs::path>& files,
                           ShaderFiles* disk, bool is_picture_driven) {
    files.push_back(manifest);
    const auto text = disk ? disk->read_plain(manifest) : read_text(manifest);
    if (!text)
        return fail(text.error());
    const auto document = parse_json(*text, manifest);
    if (!document)
        return fail(document.error());
    Look look;
    look.id = look_id_of(manifest);
    look.manifest = manifest;
    Diagnostics problems;
    ObjectReader reader(*document, manifest, problems);
    LookFolder folder(manifest.parent_path(), files);
    if (accept_header(reader, look_file))
        read_look(reader, folder, look, is_picture_driven);
    if (problems.empty())
        return look;
    std::ranges::stable_sort(problems, {}, &Diagnostic::line);
    return fail(std::move(problems));
}
