#include "formats/isf/header.h"

#include "base/text.h"
#include "formats/json/json_document.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

namespace {
using JsonKind = JsonValue::Kind;

constexpr std::size_t max_passes = 64;
constexpr std::size_t max_inputs = 1024;
constexpr std::size_t max_imports = 64;
constexpr std::size_t max_values = 1024;

/// The content of the first block comment of a text.
struct HeaderComment {
    std::size_t begin = 0;
    std::size_t end = 0;
};

std::optional<HeaderComment> find_comment(std::string_view text) {
    for (const Token& token : scan(text).all) {
        const bool is_block = token.kind == Token::Kind::comment && token.text.starts_with("/*");
        if (!is_block)
            continue;
        if (token.text.size() < 4 || !token.text.ends_with("*/"))
            return std::nullopt;
        const auto begin = static_cast<std::size_t>(token.text.data() - text.data());
        return HeaderComment{begin + 2, begin + token.text.size() - 2};
    }
    return std::nullopt;
}

// Whether the text has only comments, #version and #extension, which the program adds itself.
bool says_nothing(std::string_view text) {
    const Tokens tokens = scan(text);
    std::string code(text);
    for (const Directive& directive : find_directives(text, tokens))
        if (directive.name == "version" || directive.name == "extension")
            blank_out(code, directive.begin, directive.end);
    for (const Token& token : scan(code).all)
        if (token.kind != Token::Kind::comment)
            return false;
    return true;
}

// Other parsers accept "[1, 2, ]".
void blank_commas_before_brackets(std::string& json) {
    bool is_text = false;
    std::size_t comma = std::string::npos;  // followed only by whitespace so far
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char letter = json[i];
        if (is_text) {
            if (letter == '\\')
                ++i;
            else if (letter == '"')
                is_text = false;
            continue;
        }
        if ((letter == ']' || letter == '}') && comma != std::string::npos)
            json[comma] = ' ';
        if (letter == ',')
            comma = i;
        else if (std::string_view(" \t\r\n").find(letter) == std::string_view::npos)
            comma = std::string::npos;
        is_text = letter == '"';
    }
}

// The comment alone, at its position, so that lines are those of the file.
std::string json_of(std::string_view text, const HeaderComment& comment) {
    std::string json(text.substr(0, comment.end));
    blank_out(json, 0, comment.begin);
    std::ranges::replace(json.begin(), json.begin() + static_cast<std::ptrdiff_t>(comment.begin),
                         '\\', ' ');
    blank_commas_before_brackets(json);
    return json;
}

std::string text_of(const JsonValue* value) {
    if (!value)
        return {};
    return value->is(JsonKind::number) ? format_number(value->number) : value->text;
}

// A number in any form: 1, true, "1", "true".
std::optional<double> written_number(const JsonValue& value) {
    if (value.is(JsonKind::number))
        return value.number;
    if (value.is(JsonKind::boolean))
        return value.boolean ? 1.0 : 0.0;
    if (!value.is(JsonKind::text))
        return std::nullopt;
    const std::string text = to_lower(trim(value.text));
    if (text == "true" || text == "yes")
        return 1.0;
    if (text == "false" || text == "no")
        return 0.0;
    return parse_number(text);
}

// True as in other hosts: true, a number other than 0, or a text with one of these.
bool is_truthy(const JsonValue* value) {
    return value && written_number(*value).value_or(0.0) != 0.0;
}

// The components of a colour "#ff8000", "#ff8000cc" or "#f80", 0 to 1.
std::vector<double> color_numbers(std::string_view text) {
    text = trim(text);
    if (!text.starts_with('#') || text.find_first_not_of("0123456789abcdefABCDEF", 1) != text.npos)
        return {};
    const std::string_view digits = text.substr(1);
    const bool is_short = digits.size() == 3 || digits.size() == 4;
    if (!is_short && digits.size() != 6 && digits.size() != 8)
        return {};
    std::vector<double> numbers;
    for (std::size_t i = 0; i < digits.size(); i += is_short ? 1 : 2) {
        const std::string pair =
            is_short ? std::string(2, digits[i]) : std::string(digits.substr(i, 2));
        numbers.push_back(static_cast<double>(std::stoi(pair, nullptr, 16)) / 255.0);
    }
    return numbers;
}

std::vector<double> numbers_of(const JsonValue* value) {
    if (!value)
        return {};
    if (value->is(JsonKind::text) && value->text.find('#') != std::string::npos)
        return color_numbers(value->text);
    if (const auto number = written_number(*value))
        return {*number};
    std::vector<double> numbers;
    for (const JsonValue& child : value->children)
        if (const auto number = written_number(child))
            numbers.push_back(*number);
    return numbers;
}

const std::map<std::string_view, IsfInput::Type>& input_types() {
    using Type = IsfInput::Type;
    static const std::map<std::string_view, Type> all{
        {"float", Type::floating}, {"bool", Type::boolean},       {"long", Type::integer},
        {"event", Type::event},    {"point2D", Type::point},      {"color", Type::color},
        {"image", Type::image},    {"audioFFT", Type::audio_fft}, {"audio", Type::audio},
        {"cube", Type::cube}};
    return all;
}

class HeaderReader {
public:
    HeaderReader(const std::filesystem::path& file, std::string_view json)
        : m_file(file), m_json(json) {}

    Result<IsfHeader> read(const JsonValue& json) {
        m_header.about = text_of(find_member(json, "DESCRIPTION"));
        m_header.credit = text_of(find_member(json, "CREDIT"));
        for (const JsonValue& input :
             few(list(json, "INPUTS"), max_inputs, "the header has {} inputs; the limit is {}"))
            read_input(input);
        for (const JsonValue& pass :
             few(list(json, "PASSES"), max_passes, "the header has {} passes; the limit is {}"))
            read_pass(pass);
        if (m_header.passes.empty())
            m_header.passes.push_back({{}, {}, {}, false, false, {m_file, 1}});
        read_imports(json);
        read_buffers_of_version_1(json);
        unite_targets();
        if (!m_problems.empty())
            return fail(std::move(m_problems));
        return std::move(m_header);
    }

private:
    void problem(const JsonValue& at, const std::string& message) {
        add_new(m_problems, {m_file, at.line, message + column_note(m_json, at.begin)});
    }

    // All elements if there are at most `maximum`; otherwise none, with an error. `refusal` has a
    // {} for the number and one for the limit.
    std::span<const JsonValue> few(const std::vector<JsonValue>& all, std::size_t maximum,
                                   std::string_view refusal) {
        if (all.size() <= maximum)
            return all;
        problem(all[maximum], fmt::format(fmt::runtime(refusal), all.size(), maximum));
        return {};
    }

    const std::vector<JsonValue>& list(const JsonValue& json, std::string_view key) {
        static const std::vector<JsonValue> none;
        const JsonValue* member = find_member(json, key);
        if (member && !member->is(JsonKind::array) && !member->is(JsonKind::null))
            problem(*member, fmt::format("'{}' must be a list, got {}", key, shown_json(*member)));
        return member && member->is(JsonKind::array) ? member->children : none;
    }

    // Checks that a name can be an identifier of the shader.
    bool can_be_name(const std::string& name, const JsonValue& at) {
        static const std::set<std::string_view> taken{"RENDERSIZE",
                                                      "TIME",
                                                      "TIMEDELTA",
                                                      "FRAMEINDEX",
                                                      "DATE",
                                                      "PASSINDEX",
                                                      "isf_FragNormCoord",
                                                      "isf_FragColor",
                                                      "isf_vertShaderInit",
                                                      "vv_FragNormCoord",
                                                      "vv_vertShaderInit",
                                                      "IMG_PIXEL",
                                                      "IMG_NORM_PIXEL",
                                                      "IMG_THIS_PIXEL",
                                                      "IMG_THIS_NORM_PIXEL",
                                                      "IMG_SIZE"};
        // Keywords since the first version. Later keywords are allowed as input names.
        static const std::set<std::string_view> keywords{
            "attribute", "bool",     "break",     "bvec2",  "bvec3",     "bvec4",       "centroid",
            "const",     "continue", "discard",   "do",     "else",      "false",       "float",
            "for",       "highp",    "if",        "in",     "inout",     "int",         "invariant",
            "ivec2",     "ivec3",    "ivec4",     "lowp",   "mat2",      "mat3",        "mat4",
            "mediump",   "out",      "precision", "return", "sampler2D", "samplerCube", "struct",
            "true",      "uniform",  "varying",   "vec2",   "vec3",      "vec4",        "void",
            "while"};
        const Tokens tokens = scan(name);
        const bool is_word = tokens.all.size() == 1 && tokens.all[0].text == name &&
                             tokens.all[0].kind == Token::Kind::word;
        if (name.empty())
            problem(at, "'NAME' is missing");
        else if (!is_word || name.starts_with("gl_") || keywords.contains(name))
            problem(at, fmt::format("'{}' isn't a valid GLSL identifier", name));
        else if (taken.contains(name))
            problem(at, fmt::format("'{}' is a reserved name in ISF", name));
        else
            return true;
        return false;
    }

    bool accept_name(const std::string& name, const JsonValue& at) {
        if (!can_be_name(name, at))
            return false;
        const bool is_new = m_names.insert(name).second;
        if (!is_new)
            problem(at, fmt::format("the name '{}' is used twice", name));
        return is_new;
    }

    void read_input(const JsonValue& json) {
        const JsonValue* type = find_member(json, "TYPE");
        const auto known = input_types().find(type ? std::string_view(type->text) : "");
        IsfInput input;
        input.declared = {m_file, json.line};
        input.name = text_of(find_member(json, "NAME"));
        if (known == input_types().end()) {
            problem(type ? *type : json,
                    fmt::format("input '{}' has unknown type '{}'; use float, bool, long, event, "
                                "point2D, color, image, cube, audio or audioFFT",
                                input.name, text_of(type)));
            return;
        }
        if (!accept_name(input.name, json))
            return;
        input.type = known->second;
        input.label = text_of(find_member(json, "LABEL"));
        read_numbers(json, input);
        if (const JsonValue* labels = find_member(json, "LABELS"))
            for (const JsonValue& label :
                 few(labels->children, max_values, "the input has {} labels; the limit is {}"))
                input.labels.push_back(text_of(&label));
        m_header.inputs.push_back(std::move(input));
    }

    void read_numbers(const JsonValue& json, IsfInput& input) {
        const bool is_integer = input.type == IsfInput::Type::integer;
        const double maximum = is_integer ? double{std::numeric_limits<int>::max()}
                                          : double{std::numeric_limits<float>::max()};
        const auto read = [&](std::string_view key, std::vector<double>& numbers) {
            const JsonValue* value = find_member(json, key);
            numbers = numbers_of(value);
            if (value && numbers.empty() && trim(value->text).starts_with('#'))
                problem(*value, fmt::format("'{}' isn't a colour; use #rrggbb or four numbers",
                                            value->text));
            if (numbers.size() > max_values)
                problem(*value, fmt::format("'{}' has {} numbers; the limit is {}", key,
                                            numbers.size(), max_values));
            for (const double number : numbers)
                if (std::abs(number) > maximum)
                    problem(*value,
                            fmt::format("{} is out of range for a GLSL {}", format_number(number),
                                        is_integer ? "int" : "float"));
        };
        read("DEFAULT", input.initial);
        read("MIN", input.low);
        read("MAX", input.high);
        read("IDENTITY", input.identity);
        read("VALUES", input.values);
    }

    void read_pass(const JsonValue& json) {
        if (const std::string target = text_of(find_member(json, "TARGET")); !target.empty())
            can_be_name(target, json);
        m_header.passes.push_back({text_of(find_member(json, "TARGET")),
                                   text_of(find_member(json, "WIDTH")),
                                   text_of(find_member(json, "HEIGHT")),
                                   is_truthy(find_member(json, "PERSISTENT")),
                                   is_truthy(find_member(json, "FLOAT")),
                                   {m_file, json.line}});
    }

    void read_import(const std::string& name, const JsonValue& json) {
        if (!accept_name(name, json))
            return;
        const JsonValue* path = find_member(json, "PATH");
        IsfImport import{name, text_of(path), {m_file, json.line}};
        import.is_cube = to_lower(text_of(find_member(json, "TYPE"))) == "cube";
        if (path && path->is(JsonKind::array)) {
            for (const JsonValue& face : path->children)
                import.faces.push_back(text_of(&face));
            import.is_cube = import.is_cube || import.faces.size() == 6;
            if (import.faces.size() != (import.is_cube ? 6 : 1))
                return problem(
                    *path,
                    fmt::format("'PATH' of '{}' lists {} pictures; use 1, or 6 for a cube map",
                                name, import.faces.size()));
            import.path = import.faces.front();
        }
        if (!import.is_cube)
            import.faces.clear();
        m_header.imports.push_back(std::move(import));
    }

    void read_imports(const JsonValue& json) {
        const JsonValue* imports = find_member(json, "IMPORTED");
        if (!imports)
            return;
        for (const JsonValue& import :
             few(imports->children, max_imports, "the header imports {} pictures; the limit is {}"))
            read_import(
                imports->is(JsonKind::object) ? import.key : text_of(find_member(import, "NAME")),
                import);
    }

    // Version 1: a list of names, or an object of names and sizes.
    void read_buffers_of_version_1(const JsonValue& json) {
        const JsonValue* buffers = find_member(json, "PERSISTENT_BUFFERS");
        if (!buffers)
            return;
        for (const JsonValue& buffer : buffers->children) {
            const std::string& name = buffers->is(JsonKind::object) ? buffer.key : buffer.text;
            for (IsfPass& pass : m_header.passes) {
                if (pass.target != name)
                    continue;
                pass.is_persistent = true;
                pass.is_float = pass.is_float || is_truthy(find_member(buffer, "FLOAT"));
                if (pass.width.empty())
                    pass.width = text_of(find_member(buffer, "WIDTH"));
                if (pass.height.empty())
                    pass.height = text_of(find_member(buffer, "HEIGHT"));
            }
        }
    }

    // Passes with the same target draw into one image. Flags apply to all of them; the last size is
    // used.
    void unite_targets() {
        std::map<std::string, IsfPass> united;
        for (const IsfPass& pass : m_header.passes) {
            IsfPass& target = united[pass.target];
            target.is_persistent = target.is_persistent || pass.is_persistent;
            target.is_float = target.is_float || pass.is_float;
            target.width = pass.width.empty() ? target.width : pass.width;
            target.height = pass.height.empty() ? target.height : pass.height;
        }
        for (IsfPass& pass : m_header.passes) {
            if (pass.target.empty())
                continue;
            const IsfPass& target = united[pass.target];
            pass = {pass.target,          target.width,    target.height,
                    target.is_persistent, target.is_float, pass.declared};
        }
    }

    const std::filesystem::path& m_file;
    std::string_view m_json;
    IsfHeader m_header;
    std::set<std::string> m_names;
    Diagnostics m_problems;
};
}  // namespace

IsfHeader::Kind IsfHeader::kind() const {
    const auto has = [this](std::string_view name, IsfInput::Type type) {
        const IsfInput* input = find_input(name);
        return input && input->type == type;
    };
    if (has("inputImage", IsfInput::Type::image))
        return Kind::filter;
    const bool is_transition = has("startImage", IsfInput::Type::image) &&
                               has("endImage", IsfInput::Type::image) &&
                               has("progress", IsfInput::Type::floating);
    return is_transition ? Kind::transition : Kind::generator;
}

const IsfInput* IsfHeader::find_input(std::string_view name) const {
    const auto found = std::ranges::find(inputs, name, &IsfInput::name);
    return found == inputs.end() ? nullptr : &*found;
}

bool has_isf_header(std::string_view text) {
    const auto comment = find_comment(text);
    return comment &&
           trim(text.substr(comment->begin, comment->end - comment->begin)).starts_with('{');
}

Result<IsfHeader> read_isf_header(std::string_view text, const std::filesystem::path& file) {
    const auto comment = find_comment(text);
    if (!comment || !has_isf_header(text))
        return fail(
            {file, 1,
             "not an ISF shader: the header comment /*{ ... }*/ with the inputs is missing"});
    const std::string json_text = json_of(text, *comment);
    const auto json = parse_json(json_text, file, DuplicateKeys::last_wins);
    if (!json)
        return fail(json.error());
    auto header = HeaderReader(file, json_text).read(*json);
    if (!header || !says_nothing(text.substr(0, comment->begin - 2)))
        return header;
    header->code_begin = comment->end + 2;
    header->code_line =
        1 + static_cast<int>(std::ranges::count(text.substr(0, comment->end), '\n'));
    return header;
}
