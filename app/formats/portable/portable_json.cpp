#include "formats/portable/portable_json.h"

#include "formats/json/json_text.h"
#include "formats/json/value_json.h"
#include "formats/look/look_names.h"
#include "formats/look/parameter_json.h"
#include "formats/portable/media_names.h"
#include "formats/portable/portable_names.h"
#include "formats/portable/signal_paths.h"
#include "formats/preset/modulation_format.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/generated_picture.h"
#include "signals/signal_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

using Json = nlohmann::ordered_json;

namespace {
Json side_json(const Side& side) {
    switch (side.by) {
        case Side::By::viewport:
            return {{"of", "viewport"}, {"factor", side.factor}};
        case Side::By::source:
            return {{"of", "source"}, {"factor", side.factor}};
        case Side::By::before:
            return {{"of", "previous"}, {"factor", side.factor}};
        case Side::By::pixels:
            return {{"pixels", side.factor}};
        case Side::By::expression:
            return {{"expression", side.expression}};
    }
    return {};
}

void add_sampler(const Sampler& sampler, Json& json) {
    json["filter"] = name_of(filter_names(), sampler.filter);
    json["wrap"] = name_of(wrap_names(), sampler.wrap);
    json["mipmap"] = sampler.mipmap;
    if (sampler.between_levels)
        json["between_levels"] = name_of(filter_names(), *sampler.between_levels);
}

Json texture_json(const Input& input) {
    Json json{{"from", name_of(texture_names(), input.from)}};
    if (!input.name.empty())
        json["name"] = input.name;
    if (input.frames_ago > 0)
        json["frames_ago"] = input.frames_ago;
    return json;
}

Json input_json(const Input& input) {
    Json json{{"uniform", input.uniform}};
    json.update(texture_json(input));
    if (input.from == Input::From::sound) {
        json["holds"] = name_of(sound_names(), input.sound.holds);
        json["columns"] = input.sound.columns;
    }
    add_sampler(input.sampler, json);
    return json;
}

Json built_in_json(const BuiltInUniform& built_in) {
    Json json{{"uniform", built_in.name}, {"value", name_of(built_in_names(), built_in.kind)}};
    if (built_in.of)
        json["of"] = texture_json(*built_in.of);
    return json;
}

Json target_json(const Pass& pass, Encoding encoding) {
    Json json{{"format", name_of(format_names(), pass.format)},
              {"width", side_json(pass.size[0])},
              {"height", side_json(pass.size[1])},
              {"encoding", name_of(encoding_names(), encoding)},
              {"rows", name_of(row_order_names(), pass.rows)}};
    if (!pass.one_channel.empty())
        json["one_channel"] = pass.one_channel;
    if (!pass.half_floats.empty())
        json["half_floats"] = pass.half_floats;
    if (pass.has_alpha)
        json["alpha"] = true;
    if (pass.keeps_when_resized)
        json["keeps_when_resized"] = true;
    return json;
}

Json count_json(const Count& count) {
    if (const int* number = std::get_if<int>(&count))
        return *number;
    return std::get<std::string>(count);
}

// Adds members only where they differ from the default.
void add_rare_members(const Pass& pass, Json& json) {
    if (pass.onto)
        json["onto"] = {{"pass", pass.onto->pass}, {"where", pass.onto->where}};
    if (!pass.spot[0].empty() || !pass.spot[1].empty())
        json["spot"] = {pass.spot[0], pass.spot[1]};
    if (pass.accumulate)
        json["accumulate"] = true;
    if (pass.repeat != Count(1))
        json["repeat"] = count_json(pass.repeat);
    if (pass.converge)
        json["converge"] = count_json(*pass.converge);
    if (pass.frame_modulo > 0)
        json["frame_modulo"] = pass.frame_modulo;
    if (!pass.source.empty())
        json["source"] = pass.source;
    if (!pass.scope.empty())
        json["scope"] = pass.scope;
}

// The parameters that set uniforms of a pass.
Json bindings_json(const Look& look, int pass) {
    Json json = Json::array();
    for (const Parameter& parameter : look.parameters)
        for (const Binding& binding : parameter.bindings)
            if (binding.pass == pass)
                json.push_back({{"uniform", binding.uniform}, {"parameter", parameter.name}});
    return json;
}

Json pass_json(const Look& look, int index, PortableFiles& files) {
    const Pass& pass = look.passes[static_cast<std::size_t>(index)];
    const std::string stem = shader_stem(look, static_cast<std::size_t>(index));
    files.texts[stem + ".vert"] = std::string(pass.vertex.text);
    files.texts[stem + ".frag"] = std::string(pass.fragment.text);
    Json json{{"name", pass.name},
              {"draw", pass.draw == Draw::quad ? "quad" : name_of(draw_names(), pass.draw)},
              {"vertex", stem + ".vert"},
              {"fragment", stem + ".frag"},
              {"target", target_json(pass, encoding_of(look, index))},
              {"blend", name_of(blend_names(), pass.blend)},
              {"inputs", Json::array()},
              {"built_ins", Json::array()},
              {"parameters", bindings_json(look, index)},
              {"set", Json::object()}};
    for (const Input& input : pass.inputs)
        json["inputs"].push_back(input_json(input));
    for (const BuiltInUniform& built_in : pass.built_ins)
        json["built_ins"].push_back(built_in_json(built_in));
    for (const auto& [uniform, value] : pass.set)
        json["set"][uniform] = json_of(value);
    add_rare_members(pass, json);
    return json;
}

Result<Json> image_json(const Image& image, MediaNames& media) {
    Json json{{"name", image.name}};
    if (!image.made.empty()) {
        auto file = media.add_generated(image.made);
        if (!file)
            return fail(file.error());
        json["file"] = std::move(*file);
        json["generated"] = image.made;
    }
    for (const std::filesystem::path& face : image.faces)
        json["faces"].push_back(media.add(face));
    if (image.faces.empty() && !image.file.empty())
        json["file"] = media.add(image.file);
    add_sampler(image.sampler, json);
    json["linear"] = image.is_linear;
    if (image.encoding)
        json["encoding"] = name_of(encoding_names(), *image.encoding);
    json["rows"] = name_of(row_order_names(), image.rows);
    json["format"] = name_of(format_names(), image.format);
    json["shape"] = name_of(shape_names(), image.shape);
    json["needed"] = image.is_needed;
    return json;
}

Json notices_json(const SourceNotices& notices) {
    Json json = Json::array();
    for (const auto& [file, notice] : notices)
        json.push_back({{"file", file}, {"license", notice.license}, {"text", notice.text}});
    return json;
}

Json signal_json(const Spec& signal, MediaNames& media) {
    const std::string file = file_of(signal);
    Json settings = Json::object();
    for (const auto& [key, setting] : signal.settings) {
        const auto* text = std::get_if<std::string>(&setting);
        if (text && !file.empty() && *text == file)
            settings[key] = media.add_signal(*text);
        else if (text)
            settings[key] = *text;
        else
            settings[key] = std::get<double>(setting);
    }
    return {{"kind", signal.kind}, {"settings", std::move(settings)}};
}

// A source, with its name if the program generates it. Its file has the picture at time 0.
Result<void> add_source(const std::string& source, const char* key, MediaNames& media, Json& json) {
    auto copy = media.add_source(source);
    if (!copy)
        return fail(copy.error());
    if (const auto spec = parse_source(source); spec && made_name(spec->picture))
        json["generated"] = source;
    json[key] = std::move(*copy);
    return {};
}

Result<Json> source_json(const Look& look, const std::string& source, MediaNames& media) {
    Json json{{"encoding", name_of(encoding_names(), look.source_encoding)},
              {"rows", name_of(row_order_names(), look.source_rows)},
              {"format", name_of(format_names(), look.source_format)}};
    if (auto added = add_source(source, "content", media, json); !added)
        return fail(added.error());
    return json;
}

Result<void> add_content(const PortableLook& described, Json& json, MediaNames& media) {
    const Look& look = described.look;
    json["driven_by"] = name_of(driver_names(), look.driven_by);
    if (look.driven_by == Driver::signal) {
        json["signal"] = signal_json(described.signal, media);
        auto paths = signal_paths(described.signal, described.media);
        if (!paths)
            return fail(paths.error());
        if (!paths->is_null())
            json["signal"]["paths"] = std::move(*paths);
    }
    if (described.source.empty())
        return {};
    auto source = source_json(look, described.source, media);
    if (!source)
        return fail(source.error());
    json["source"] = std::move(*source);
    return {};
}

Result<Json> parameter_entry(const PortableLook& described, const Parameter& parameter,
                             MediaNames& media) {
    Json json = parameter_json(parameter, described.look, described.values);
    const Value& value = value_of(parameter, described.values);
    if (!value.path.empty() && parameter.control == Control::image) {
        if (auto added = add_source(value.path, "value", media, json); !added)
            return fail(added.error());
    } else if (!value.path.empty()) {
        json["value"] = media.add(value.path);
    }
    if (const auto moving = described.modulations.find(parameter.name);
        moving != described.modulations.end())
        json["modulation"] = json_of(moving->second);
    if (parameter.limit)
        json["limit"] = {parameter.limit->low, parameter.limit->high};
    if (parameter.orbit != OrbitPart::none)
        json["orbit"] = name_of(orbit_names(), parameter.orbit);
    return json;
}

Json heading_json(const PortableLook& described, const SourceNotices& notices) {
    const Look& look = described.look;
    return {{"format", "afterglow-portable"},
            {"version", 1},
            {"name", look.name},
            {"about", look.about},
            {"author", look.author},
            {"license", look.license.empty() ? "not stated" : look.license},
            {"notices", notices_json(notices)},
            {"size", {described.size.width, described.size.height}},
            {"output", name_of(encoding_names(), look.output)},
            {"source_encoding", name_of(encoding_names(), look.source_encoding)},
            {"tempo", json_of(described.tempo)},
            {"settle_frames", look.settle_frames}};
}

Result<void> add_images(const Look& look, Json& json, MediaNames& media) {
    json["images"] = Json::array();
    for (const Image& image : look.images) {
        auto entry = image_json(image, media);
        if (!entry)
            return fail(entry.error());
        json["images"].push_back(std::move(*entry));
    }
    return {};
}

Result<void> add_parameters(const PortableLook& described, Json& json, MediaNames& media) {
    json["parameters"] = Json::array();
    for (const Parameter& parameter : described.look.parameters) {
        auto entry = parameter_entry(described, parameter, media);
        if (!entry)
            return fail(entry.error());
        json["parameters"].push_back(std::move(*entry));
    }
    return {};
}
}  // namespace

std::string shader_stem(const Look& look, std::size_t pass) {
    return fmt::format("{}/{}-{}", shader_folder, pass, safe_name(look.passes[pass].name));
}

Result<PortableFiles> portable_files(const PortableLook& described, const SourceNotices& notices) {
    const Look& look = described.look;
    PortableFiles files;
    MediaNames media;
    Json json = heading_json(described, notices);
    if (auto added = add_content(described, json, media); !added)
        return fail(added.error());
    json["passes"] = Json::array();
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        json["passes"].push_back(pass_json(look, static_cast<int>(i), files));
    if (auto added = add_images(look, json, media); !added)
        return fail(added.error());
    if (auto added = add_parameters(described, json, media); !added)
        return fail(added.error());
    json["constants"] = Json::object();
    for (const auto& [name, value] : look.constants)
        json["constants"][name] = json_of(value);
    files.texts[portable_file] = json_text(json);
    files.generated = media.generated();
    files.media = media.files();
    return files;
}
