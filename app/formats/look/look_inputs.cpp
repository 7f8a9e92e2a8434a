#include "formats/look/look_inputs.h"

#include "formats/look/look_passes.h"

#include <algorithm>

namespace {
constexpr int max_frames_ago = 64;
// The minimum that each GL 4.1 implementation provides to fragment shaders.
constexpr std::size_t max_inputs = 16;

// Reads one input of a pass.
class InputReading {
public:
    InputReading(ObjectReader& reader, const Look& look, std::size_t pass, const JsonValue& at)
        : m_reader(reader), m_look(look), m_pass(pass), m_at(at) {}

    // Parses "NAME", "NAME@n", "source", "source@n".
    void refer(std::string_view reference, Input& input) {
        const std::size_t at = reference.find('@');
        const std::string_view name = reference.substr(0, at);
        if (at != std::string_view::npos) {
            const auto frames = parse_integer(reference.substr(at + 1));
            if (!frames || *frames < 0 || *frames > max_frames_ago)
                return problem(
                    fmt::format("'{}': expected a number of frames from 0 to {} after '@'",
                                reference, max_frames_ago));
            input.frames_ago = *frames;
        }
        input.name = name;
        if (name == "source")
            refer_to_source(input);
        else if (const auto pass = find_pass(m_look, name); pass && !name.empty())
            refer_to_pass(static_cast<std::size_t>(*pass), input);
        else
            refer_to_image(input);
    }

private:
    void problem(std::string message) { m_reader.problem(m_at, std::move(message)); }

    void refer_to_source(Input& input) {
        input.from = Input::From::source;
        input.name.clear();
        if (m_look.driven_by != Driver::picture)
            problem("'source' needs a look with 'driven_by': 'picture'");
    }

    void refer_to_pass(std::size_t pass, Input& input) {
        input.from = Input::From::pass;
        if (input.frames_ago == 0 && pass == m_pass)
            problem(
                fmt::format("a pass can't read its own target while it draws; use '{}@1' for the "
                            "previous frame",
                            input.name));
        else if (input.frames_ago == 0 && pass > m_pass)
            problem(fmt::format(
                "pass '{0}' is drawn after this one; use '{0}@1' for its previous frame",
                input.name));
    }

    void refer_to_image(Input& input) {
        const auto image = std::find_if(m_look.images.begin(), m_look.images.end(),
                                        [&](const Image& each) { return each.name == input.name; });
        if (image == m_look.images.end())
            return problem(fmt::format("unknown pass or image '{}'{}", input.name,
                                       did_you_mean(input.name, known_names())));
        input.from = Input::From::image;
        input.sampler = image->sampler;
        if (input.frames_ago > 0)
            problem(fmt::format("'{}' is an image and has no previous frames; remove '@{}'",
                                input.name, input.frames_ago));
    }

    std::vector<std::string> known_names() const {
        std::vector<std::string> names;
        for (const Pass& pass : m_look.passes)
            names.push_back(pass.name);
        for (const Image& image : m_look.images)
            names.push_back(image.name);
        if (m_look.driven_by == Driver::picture)
            names.emplace_back("source");
        return names;
    }

    ObjectReader& m_reader;
    const Look& m_look;
    std::size_t m_pass;
    const JsonValue& m_at;
};

// Integer formats cannot be filtered; the driver would show black.
void check_texels(ObjectReader& reader, const Look& look, const JsonValue& member, Input& input) {
    const auto pass = find_pass(look, input.name);
    if (input.from != Input::From::pass || !pass ||
        !info_of(look.passes[static_cast<std::size_t>(*pass)].format).is_integer)
        return;
    const JsonValue* filter = find_member(member, "filter");
    if (!filter)
        input.sampler.filter = Filter::nearest;
    if (input.sampler.filter == Filter::linear)
        reader.problem(
            *filter,
            fmt::format("pass '{}' has an integer format; use 'filter': 'nearest'", input.name));
    if (input.sampler.mipmap)
        reader.problem(
            *find_member(member, "mipmap"),
            fmt::format("pass '{}' has an integer format, which can't have mipmaps", input.name));
}

// nullopt: an input for the other driver.
std::optional<Input> read_input(const JsonValue& member, ObjectReader& parent, const Look& look,
                                std::size_t pass) {
    Input input;
    input.uniform = member.key;
    if (member.is(JsonValue::Kind::text)) {
        InputReading(parent, look, pass, member).refer(member.text, input);
        check_texels(parent, look, member, input);
        return input;
    }
    ObjectReader reader(member, parent.file(), parent.problems());
    if (!is_for_driver(reader, look))
        return std::nullopt;
    const JsonValue* from = reader.require("from");
    if (from && reader.expect(*from, JsonValue::Kind::text))
        InputReading(reader, look, pass, *from).refer(from->text, input);
    const Sampler own = read_sampler(reader);
    input.sampler.filter = reader.find("filter") ? own.filter : input.sampler.filter;
    input.sampler.wrap = reader.find("wrap") ? own.wrap : input.sampler.wrap;
    input.sampler.mipmap = reader.find("mipmap") ? own.mipmap : input.sampler.mipmap;
    reader.report_unknown_keys();
    check_texels(reader, look, member, input);
    return input;
}
}  // namespace

void read_inputs(ObjectReader& reader, Look& look, std::size_t pass) {
    const JsonValue* inputs = reader.find("inputs");
    if (!inputs || !reader.expect(*inputs, JsonValue::Kind::object))
        return;
    if (inputs->children.size() > max_inputs)
        return reader.problem(*inputs, fmt::format("the pass has {} inputs; the limit is {}",
                                                   inputs->children.size(), max_inputs));
    for (const JsonValue& member : inputs->children)
        if (auto input = read_input(member, reader, look, pass))
            look.passes[pass].inputs.push_back(std::move(*input));
}
