#include "formats/look/manifest_edit.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/json/json_edit.h"
#include "formats/look/look_names.h"
#include "io/files/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
// The name that an input reads: "persistence" for "persistence@1".
std::string_view name_of(const JsonValue& reference) {
    return std::string_view(reference.text).substr(0, reference.text.find('@'));
}

void write_scale(JsonEdit& edit, const JsonValue& pass, double scale) {
    if (const JsonValue* size = find_member(pass, "size"))
        return edit.replace(size->key_begin, size->end, "\"scale\": " + format_number(scale));
    edit.set(pass, "scale", format_number(scale));
    if (find_member(pass, "scale_of"))
        edit.set(pass, "scale_of", json_word("viewport"));
}

void write_filters(JsonEdit& edit, const JsonValue& pass, const PassOverrides& overrides) {
    const JsonValue* inputs = find_member(pass, "inputs");
    if (!inputs)
        return;
    for (const JsonValue& input : inputs->children) {
        const JsonValue* from =
            input.is(JsonValue::Kind::object) ? find_member(input, "from") : &input;
        const auto read = from ? overrides.find(std::string(name_of(*from))) : overrides.end();
        if (read == overrides.end() || !read->second.filter)
            continue;
        const std::string filter = json_word(name_of(filter_names(), *read->second.filter));
        if (from == &input)
            edit.replace(
                input.begin, input.end,
                fmt::format("{{ \"from\": {}, \"filter\": {} }}", edit.written(input), filter));
        else
            edit.set(input, "filter", filter);
    }
}

void write_pass(JsonEdit& edit, const JsonValue& pass, const PassOverrides& overrides) {
    const JsonValue* name = find_member(pass, "name");
    const auto own = name ? overrides.find(name->text) : overrides.end();
    if (own != overrides.end() && own->second.format)
        edit.set(pass, "format", json_word(name_of(format_names(), *own->second.format)));
    if (own != overrides.end() && own->second.scale)
        write_scale(edit, pass, *own->second.scale);
    write_filters(edit, pass, overrides);
}

bool has_pass(const JsonValue& passes, const std::string& name) {
    return std::any_of(passes.children.begin(), passes.children.end(), [&](const JsonValue& pass) {
        const JsonValue* own = find_member(pass, "name");
        return own && own->text == name;
    });
}
}  // namespace

Result<std::string> with_overrides_written(std::string_view text, const PassOverrides& overrides,
                                           const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    const JsonValue* passes = find_member(*document, "passes");
    if (!passes || !passes->is(JsonValue::Kind::array))
        return fail({file, 0, "can't save the pass settings: the list 'passes' is missing"});
    for (const auto& [name, override] : overrides)
        if (!override.is_empty() && !has_pass(*passes, name))
            return fail({file, passes->line,
                         fmt::format("can't save the pass settings: pass '{}' is missing", name)});
    JsonEdit edit(text);
    for (const JsonValue& pass : passes->children)
        write_pass(edit, pass, overrides);
    return edit.edited();
}

Result<ManifestText> read_manifest(const std::filesystem::path& manifest) {
    if (!is_inside(manifest, manifest.has_parent_path() ? manifest.parent_path() : "."))
        return fail({manifest, 0,
                     "can't save through a link to a file outside the look's folder. Replace the "
                     "link with a copy of the file, or edit that file yourself."});
    const auto bytes = read_bytes(manifest);
    const auto text = read_text(manifest);
    if (!bytes || !text)
        return fail(text ? bytes.error() : text.error());
    const std::size_t mark = bytes->size() - std::min(bytes->size(), text->size());
    return ManifestText{bytes->substr(0, mark), *text};
}

Result<void> write_overrides(const std::filesystem::path& manifest,
                             const PassOverrides& overrides) {
    const auto text = read_manifest(manifest);
    if (!text)
        return fail(text.error());
    const auto edited = with_overrides_written(text->text, overrides, manifest);
    if (!edited)
        return fail(edited.error());
    return write_atomically(manifest, text->mark + *edited);
}
