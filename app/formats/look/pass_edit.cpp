#include "formats/look/pass_edit.h"

#include "base/text.h"
#include "formats/json/json_edit.h"
#include "formats/look/look_names.h"
#include "formats/look/look_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

namespace fs = std::filesystem;

namespace {
// A reference of an input to a pass, an image or the source: "persistence@1".
struct Reference {
    std::string name;
    int frames_ago = 0;

    bool operator==(const Reference&) const = default;
};

Reference parse_reference(std::string_view text) {
    const std::size_t at = text.find('@');
    if (at == std::string_view::npos)
        return {std::string(text), 0};
    return {std::string(text.substr(0, at)),
            static_cast<int>(parse_integer(text.substr(at + 1)).value_or(0))};
}

std::string to_string(const Reference& reference) {
    return reference.frames_ago == 0 ? reference.name
                                     : fmt::format("{}@{}", reference.name, reference.frames_ago);
}

std::string text_of(const JsonValue& object, std::string_view key) {
    const JsonValue* member = find_member(object, key);
    return member && member->is(JsonValue::Kind::text) ? member->text : std::string();
}

// The texts that name what a pass reads, one for each input.
std::vector<const JsonValue*> references_of(const JsonValue& pass) {
    std::vector<const JsonValue*> found;
    const JsonValue* inputs = find_member(pass, "inputs");
    if (!inputs)
        return found;
    for (const JsonValue& input : inputs->children) {
        const JsonValue* from =
            input.is(JsonValue::Kind::object) ? find_member(input, "from") : &input;
        if (from && from->is(JsonValue::Kind::text))
            found.push_back(from);
    }
    return found;
}

/// The list of passes of a look.json.
struct PassList {
    JsonValue document;
    const JsonValue* passes = nullptr;  // within `document`
    fs::path file;

    const JsonValue& at(std::size_t index) const { return passes->children[index]; }
    std::size_t size() const { return passes->children.size(); }
    std::string name(std::size_t index) const { return text_of(at(index), "name"); }
    std::optional<std::size_t> find(std::string_view wanted) const {
        for (std::size_t i = 0; i < size(); ++i)
            if (name(i) == wanted)
                return i;
        return std::nullopt;
    }
    bool has_image(std::string_view wanted) const {
        const JsonValue* images = find_member(document, "images");
        return images && find_member(*images, wanted);
    }
    tl::unexpected<Diagnostics> refuse(std::size_t pass, std::string message) const {
        return fail({file, at(pass).line, std::move(message)});
    }
};

Result<PassList> parse_passes(std::string_view text, const fs::path& file) {
    auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    PassList list{std::move(*document), nullptr, file};
    list.passes = find_member(list.document, "passes");
    if (!list.passes || !list.passes->is(JsonValue::Kind::array) || list.passes->children.empty())
        return fail({file, 0, "the list 'passes' is missing"});
    return list;
}

Result<std::size_t> find_in(const PassList& list, std::string_view pass) {
    if (const auto index = list.find(pass))
        return *index;
    return fail({list.file, list.passes->line, fmt::format("pass '{}' is missing", pass)});
}

// The pass that this one is drawn onto, or "".
std::string host_of(const JsonValue& pass) {
    const JsonValue* onto = find_member(pass, "onto");
    return onto ? text_of(*onto, "pass") : std::string();
}

// The input that a bypassed pass shows, as in passed_input().
std::optional<Reference> first_input(const PassList& list, std::size_t pass) {
    std::optional<Reference> image;
    for (const JsonValue* from : references_of(list.at(pass))) {
        const Reference reference = parse_reference(from->text);
        if (list.has_image(reference.name)) {
            if (!image)
                image = reference;
        } else if (reference.name != list.name(pass)) {
            return reference;
        }
    }
    return image;
}

/// Rewrites the references of one pass.
class Rewiring {
public:
    Rewiring(const PassList& list, JsonEdit& edit, std::vector<std::string>& rewired)
        : m_list(list), m_edit(edit), m_rewired(rewired) {}

    /// `change` returns the new reference, or nullopt to keep it.
    void apply(std::size_t pass,
               const std::function<std::optional<Reference>(const Reference&)>& change) {
        bool has_changed = false;
        for (const JsonValue* from : references_of(m_list.at(pass)))
            if (const auto next = change(parse_reference(from->text))) {
                m_edit.replace(from->begin, from->end, json_word(to_string(*next)));
                has_changed = true;
            }
        if (has_changed)
            m_rewired.push_back(m_list.name(pass));
    }

private:
    const PassList& m_list;
    JsonEdit& m_edit;
    std::vector<std::string>& m_rewired;
};

bool has_integers(const JsonValue& pass) {
    const std::string format = text_of(pass, "format");
    for (const auto& [name, value] : format_names())
        if (name == format)
            return info_of(value).is_integer;
    return false;
}

Result<void> check_new_name(const PassList& list, const std::string& name) {
    if (!is_look_name(name) || name == "source")
        return fail({list.file, 0,
                     fmt::format("'{}' can't be the name of a pass. {}", name, look_name_rule())});
    if (list.find(name) || list.has_image(name))
        return fail({list.file, 0, fmt::format("the name '{}' is already used", name)});
    return {};
}

// The new pass in JSON. It keeps the size and precision of the pass that it reads.
std::string entry_of(const NewPass& pass, const JsonValue& after, const JsonEdit& edit) {
    std::string entry = fmt::format("{{ \"name\": {}, \"fragment\": {}", json_word(pass.name),
                                    json_word(pass.fragment));
    for (const char* key : {"scale", "scale_of", "size", "format"})
        if (const JsonValue* member = find_member(after, key))
            entry += fmt::format(", \"{}\": {}", key, edit.written(*member));
    return fmt::format("{}, \"inputs\": {{ \"image\": {} }} }}", entry, json_word(pass.after));
}
}  // namespace

Result<PassEdit> with_pass_added(std::string_view text, const NewPass& pass, const fs::path& file) {
    const auto list = parse_passes(text, file);
    if (!list)
        return fail(list.error());
    if (auto fine = check_new_name(*list, pass.name); !fine)
        return fail(fine.error());
    const auto after = find_in(*list, pass.after);
    if (!after)
        return fail(after.error());
    if (has_integers(list->at(*after)))
        return list->refuse(
            *after,
            fmt::format("'{}' has an integer format, which a new pass can't copy. Add the pass "
                        "after another one.",
                        pass.after));
    if (const std::string host = host_of(list->at(*after)); !host.empty())
        return list->refuse(*after, fmt::format("'{}' is drawn onto '{}'. Add the pass after '{}'.",
                                                pass.after, host, host));
    JsonEdit edit(text);
    PassEdit made;
    Rewiring rewiring(*list, edit, made.rewired);
    const Reference before{pass.after, 0};
    for (std::size_t i = *after + 1; i < list->size(); ++i)
        rewiring.apply(i, [&](const Reference& reference) {
            return reference == before ? std::optional(Reference{pass.name, 0}) : std::nullopt;
        });
    edit.insert_after(*list->passes, *after, entry_of(pass, list->at(*after), edit));
    made.text = edit.edited();
    return made;
}

namespace {
// The shaders that no other pass names.
std::vector<std::string> own_shaders(const PassList& list, std::size_t pass) {
    std::set<std::string> others;
    for (std::size_t i = 0; i < list.size(); ++i)
        for (const char* stage : {"vertex", "fragment"})
            if (i != pass)
                others.insert(text_of(list.at(i), stage));
    std::vector<std::string> own;
    for (const char* stage : {"vertex", "fragment"})
        if (const std::string file = text_of(list.at(pass), stage);
            !file.empty() && !others.contains(file))
            own.push_back(file);
    return own;
}

// What takes the place of a removed pass; images have no earlier frames.
Reference replacement(const PassList& list, const Reference& input, int frames_ago) {
    return {input.name, list.has_image(input.name) ? 0 : input.frames_ago + frames_ago};
}

Result<void> check_removable(const PassList& list, std::size_t pass) {
    if (list.size() == 1)
        return list.refuse(
            pass, fmt::format("'{}' is the only pass, and a look needs one", list.name(pass)));
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (host_of(list.at(i)) == list.name(pass))
            return list.refuse(
                i, fmt::format("'{}' is drawn onto '{}'. Remove 'onto' from '{}' first.",
                               list.name(i), list.name(pass), list.name(i)));
        if (i == pass || first_input(list, pass))
            continue;
        for (const JsonValue* from : references_of(list.at(i)))
            if (parse_reference(from->text).name == list.name(pass))
                return fail({list.file, from->line,
                             fmt::format("'{0}' reads '{1}', and '{1}' has no input that could "
                                         "take its place. Give '{0}' another input first.",
                                         list.name(i), list.name(pass))});
    }
    return {};
}
}  // namespace

Result<PassEdit> with_pass_removed(std::string_view text, std::string_view pass,
                                   const fs::path& file) {
    const auto list = parse_passes(text, file);
    if (!list)
        return fail(list.error());
    const auto index = find_in(*list, pass);
    if (!index)
        return fail(index.error());
    if (auto fine = check_removable(*list, *index); !fine)
        return fail(fine.error());
    const auto input = first_input(*list, *index);
    JsonEdit edit(text);
    PassEdit made;
    Rewiring rewiring(*list, edit, made.rewired);
    for (std::size_t i = 0; i < list->size(); ++i)
        if (i != *index && input)
            rewiring.apply(i, [&](const Reference& reference) {
                return reference.name == pass
                           ? std::optional(replacement(*list, *input, reference.frames_ago))
                           : std::nullopt;
            });
    edit.remove(*list->passes, *index);
    made.text = edit.edited();
    made.unused_shaders = own_shaders(*list, *index);
    return made;
}

namespace {
bool reads(const PassList& list, std::size_t pass, const Reference& wanted) {
    return std::ranges::any_of(references_of(list.at(pass)), [&](const JsonValue* from) {
        return parse_reference(from->text) == wanted;
    });
}

// Exchanges inputs and readers of a pass and the next one, which reads it.
Result<std::string> with_links_swapped(std::string_view text, const PassList& list,
                                       std::size_t first, std::vector<std::string>& rewired) {
    const Reference one{list.name(first), 0};
    const Reference other{list.name(first + 1), 0};
    const auto input = first_input(list, first);
    if (!input)
        return list.refuse(first + 1, fmt::format("'{}' reads '{}', which has no input. It must "
                                                  "stay after it.",
                                                  other.name, one.name));
    JsonEdit edit(text);
    Rewiring rewiring(list, edit, rewired);
    const auto to = [](const Reference& from, const Reference& next) {
        return [from, next](const Reference& reference) {
            return reference == from ? std::optional(next) : std::nullopt;
        };
    };
    rewiring.apply(first, to(*input, other));
    rewiring.apply(first + 1, to(one, *input));
    for (std::size_t i = first + 2; i < list.size(); ++i)
        rewiring.apply(i, [&](const Reference& reference) -> std::optional<Reference> {
            if (reference == one)
                return other;
            return reference == other ? std::optional(one) : std::nullopt;
        });
    return edit.edited();
}
}  // namespace

Result<PassEdit> with_pass_moved(std::string_view text, std::string_view pass, PassMove move,
                                 const fs::path& file) {
    auto list = parse_passes(text, file);
    if (!list)
        return fail(list.error());
    const auto index = find_in(*list, pass);
    if (!index)
        return fail(index.error());
    if (move == PassMove::earlier ? *index == 0 : *index + 1 == list->size())
        return list->refuse(*index, fmt::format("'{}' is already the {} pass", pass,
                                                *index == 0 ? "first" : "last"));
    const std::size_t first = move == PassMove::earlier ? *index - 1 : *index;
    for (const auto& [one, other] : {std::pair(first, first + 1), std::pair(first + 1, first)})
        if (host_of(list->at(one)) == list->name(other))
            return list->refuse(one, fmt::format("'{}' is drawn onto '{}' and must stay before it",
                                                 list->name(one), list->name(other)));
    PassEdit made{.text = std::string(text)};
    if (reads(*list, first + 1, {list->name(first), 0})) {
        auto swapped = with_links_swapped(text, *list, first, made.rewired);
        if (!swapped)
            return fail(swapped.error());
        made.text = std::move(*swapped);
        list = parse_passes(made.text, file);  // other positions in the text
        if (!list)
            return fail(list.error());
    }
    JsonEdit edit(made.text);
    edit.swap_with_next(*list->passes, first);
    made.text = edit.edited();
    return made;
}

Result<std::string> with_look_named(std::string_view text, std::string_view name,
                                    const fs::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    JsonEdit edit(text);
    edit.set(*document, "name", json_word(name));
    edit.set(*document, "about", json_word(""));
    return edit.edited();
}
