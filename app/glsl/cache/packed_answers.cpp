#include "glsl/cache/packed_answers.h"

#include "base/packed.h"

#include <bit>
#include <cstdint>

namespace {
constexpr std::uint64_t max_line = 0x7fffffff;
constexpr std::uint64_t max_side = 4;  // rows or columns of a matrix

void add(Packer& packer, const Location& at) {
    packer.add(at.file.string());
    packer.add(static_cast<std::uint64_t>(at.line));
}

Location read_location(Unpacker& read) {
    std::string file(read.text());
    return {std::move(file), static_cast<int>(read.number(max_line))};
}

void add(Packer& packer, const Diagnostics& diagnostics) {
    packer.add(std::uint64_t{diagnostics.size()});
    for (const Diagnostic& diagnostic : diagnostics) {
        add(packer, Location{diagnostic.file, diagnostic.line});
        packer.add(diagnostic.message);
        packer.add(std::uint64_t{diagnostic.severity == Severity::warning});
    }
}

Diagnostics read_diagnostics(Unpacker& read) {
    Diagnostics diagnostics;
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left) {
        const Location at = read_location(read);
        std::string message(read.text());
        const Severity severity = read.number(1) == 1 ? Severity::warning : Severity::error;
        diagnostics.push_back({at.file, at.line, std::move(message), severity});
    }
    return diagnostics;
}

void add(Packer& packer, const Stage& stage) {
    packer.add(stage.file.string());
    packer.add(stage.text);
    packer.add(std::uint64_t{stage.lines.stretches().size()});
    std::size_t start = 0;
    for (const LineMap::Stretch& stretch : stage.lines.stretches()) {
        add(packer, stretch.first);
        packer.add(std::uint64_t{stretch.end - start});
        start = stretch.end;
    }
}

Stage read_stage(Unpacker& read) {
    Stage stage{std::string(read.text()), std::string(read.text()), {}};
    const std::uint64_t max_lines = stage.text->size() + 1;
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left) {
        const Location first = read_location(read);
        if (const std::uint64_t count = read.number(max_lines); count > 0)
            stage.lines.append(first, static_cast<std::size_t>(count));
    }
    return stage;
}

void add(Packer& packer, const NumberType& type) {
    packer.add(static_cast<std::uint64_t>(type.scalar));
    packer.add(static_cast<std::uint64_t>(type.rows));
    packer.add(static_cast<std::uint64_t>(type.columns));
}

NumberType read_type(Unpacker& read) {
    const auto max_scalar = static_cast<std::uint64_t>(Scalar::boolean);
    const auto scalar = static_cast<Scalar>(read.number(max_scalar));
    const int rows = static_cast<int>(read.number(max_side));
    return {scalar, rows, static_cast<int>(read.number(max_side))};
}

template <class T, class Add>
void add_optional(Packer& packer, const std::optional<T>& perhaps, const Add& add_it) {
    packer.add(std::uint64_t{perhaps.has_value()});
    if (perhaps)
        add_it(*perhaps);
}

void add(Packer& packer, const Value& value) {
    packer.add(value.path);
    packer.add(std::uint64_t{value.numbers.size()});
    for (const double number : value.numbers)
        packer.add(std::bit_cast<std::uint64_t>(number));
}

Value read_value(Unpacker& read) {
    Value value;
    value.path = read.text();
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left)
        value.numbers.push_back(std::bit_cast<double>(read.number()));
    return value;
}

void add(Packer& packer, const Uniform& uniform) {
    packer.add(uniform.name);
    packer.add(static_cast<std::uint64_t>(uniform.kind));
    packer.add(uniform.type_name);
    add(packer, uniform.type);
    packer.add(uniform.why_no_control);
    add_optional(packer, uniform.initial, [&](const Value& value) { add(packer, value); });
    packer.add(std::uint64_t{uniform.declared.size()});
    for (const Location& at : uniform.declared)
        add(packer, at);
}

Uniform read_uniform(Unpacker& read) {
    Uniform uniform;
    uniform.name = read.text();
    uniform.kind =
        static_cast<Uniform::Kind>(read.number(static_cast<std::uint64_t>(Uniform::Kind::other)));
    uniform.type_name = read.text();
    uniform.type = read_type(read);
    uniform.why_no_control = read.text();
    if (read.number(1) == 1)
        uniform.initial = read_value(read);
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left)
        uniform.declared.push_back(read_location(read));
    return uniform;
}

void add(Packer& packer, const BlockMember& member) {
    packer.add(member.name);
    packer.add(member.uniform);
    add_optional(packer, member.type, [&](const NumberType& type) { add(packer, type); });
}

BlockMember read_member(Unpacker& read) {
    BlockMember member{std::string(read.text()), std::string(read.text()), {}};
    if (read.number(1) == 1)
        member.type = read_type(read);
    return member;
}
}  // namespace

std::string packed(const Reflection& reflection) {
    Packer packer;
    packer.add(std::uint64_t{reflection.uniforms.size()});
    for (const Uniform& uniform : reflection.uniforms)
        add(packer, uniform);
    packer.add(std::uint64_t{reflection.live.size()});
    for (const std::string& name : reflection.live)
        packer.add(name);
    add(packer, reflection.warnings);
    return packer.bytes();
}

std::optional<Reflection> unpacked_reflection(std::string_view bytes) {
    Unpacker read(bytes);
    Reflection reflection;
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left)
        reflection.uniforms.push_back(read_uniform(read));
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left)
        reflection.live.emplace_back(read.text());
    reflection.warnings = read_diagnostics(read);
    return read.is_at_end() ? std::optional(std::move(reflection)) : std::nullopt;
}

std::string packed(const Translation& translation) {
    Packer packer;
    add(packer, translation.vertex);
    add(packer, translation.fragment);
    packer.add(std::uint64_t{translation.members.size()});
    for (const BlockMember& member : translation.members)
        add(packer, member);
    packer.add(std::uint64_t{translation.samplers.size()});
    for (const NamedSampler& sampler : translation.samplers) {
        packer.add(sampler.name);
        packer.add(sampler.uniform);
    }
    add(packer, translation.warnings);
    return packer.bytes();
}

std::optional<Translation> unpacked_translation(std::string_view bytes) {
    Unpacker read(bytes);
    Translation translation;
    translation.vertex = read_stage(read);
    translation.fragment = read_stage(read);
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left)
        translation.members.push_back(read_member(read));
    for (std::size_t left = read.count(); left > 0 && read.is_good(); --left) {
        NamedSampler sampler{std::string(read.text()), std::string(read.text())};
        translation.samplers.push_back(std::move(sampler));
    }
    translation.warnings = read_diagnostics(read);
    return read.is_at_end() ? std::optional(std::move(translation)) : std::nullopt;
}
