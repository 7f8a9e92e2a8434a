#include "glsl/es/nested_arrays.h"

#include <spirv_cross/spirv.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace {
using Id = std::uint32_t;
using Words = std::vector<std::uint32_t>;

constexpr std::size_t header_words = 5;
constexpr std::size_t bound_at = 3;  // in the header: the smallest unused id

/// An instruction and its words after the first.
struct Instruction {
    spv::Op op;
    Words words;
};

std::vector<Instruction> instructions_of(const Words& code) {
    std::vector<Instruction> all;
    for (std::size_t at = header_words; at < code.size();) {
        const std::size_t count = std::max<std::size_t>(code[at] >> spv::WordCountShift, 1);
        const auto begin = code.begin() + static_cast<std::ptrdiff_t>(at);
        all.push_back({static_cast<spv::Op>(code[at] & spv::OpCodeMask),
                       Words(begin + 1, begin + static_cast<std::ptrdiff_t>(count))});
        at += count;
    }
    return all;
}

void append(const Instruction& instruction, Words& code) {
    const auto count = static_cast<std::uint32_t>(instruction.words.size() + 1);
    code.push_back((count << spv::WordCountShift) | static_cast<std::uint32_t>(instruction.op));
    code.insert(code.end(), instruction.words.begin(), instruction.words.end());
}

// Instructions that start with their type and id, and can have a composite or a pointer to one.
constexpr std::array typed{
    spv::OpUndef,
    spv::OpConstant,
    spv::OpConstantComposite,
    spv::OpConstantNull,
    spv::OpVariable,
    spv::OpFunctionParameter,
    spv::OpFunctionCall,
    spv::OpLoad,
    spv::OpAccessChain,
    spv::OpSelect,
    spv::OpPhi,
    spv::OpInBoundsAccessChain,
    spv::OpCopyObject,
    spv::OpCompositeInsert,
    spv::OpCompositeConstruct,
    spv::OpCompositeExtract,
};

/// The types of a module before the change.
class Types {
public:
    void note(const Instruction& one) {
        const Words& words = one.words;
        if (one.op == spv::OpTypeArray)
            m_arrays[words[0]] = words[1];
        else if (one.op == spv::OpTypeVector || one.op == spv::OpTypeMatrix)
            m_columns[words[0]] = words[1];
        else if (one.op == spv::OpTypePointer)
            m_pointers[words[0]] = words[2];
        else if (one.op == spv::OpTypeStruct)
            m_members[words[0]] = Words(words.begin() + 1, words.end());
        else if (one.op == spv::OpTypeInt && words[1] == 32)
            m_integer = words[0];
        else if (std::ranges::find(typed, one.op) != typed.end())
            m_values[words[1]] = words[0];
        if (one.op == spv::OpConstant)
            m_constants[words[1]] = words[2];
    }

    bool is_nested(Id type) const {
        const auto array = m_arrays.find(type);
        return array != m_arrays.end() && m_arrays.contains(array->second);
    }
    bool has_nested() const {
        return std::ranges::any_of(m_arrays,
                                   [&](const auto& array) { return is_nested(array.first); });
    }
    Id type_of(Id value) const { return found(m_values, value); }
    Id pointee(Id pointer) const { return found(m_pointers, type_of(pointer)); }
    Id element_of(Id array) const { return found(m_arrays, array); }
    /// The type of a part. Structures are indexed by a constant.
    Id part_of(Id type, std::uint32_t index) const {
        if (const auto members = m_members.find(type); members != m_members.end())
            return index < members->second.size() ? members->second[index] : 0;
        return m_arrays.contains(type) ? element_of(type) : found(m_columns, type);
    }
    std::uint32_t constant(Id id) const { return found(m_constants, id); }
    Id integer() const { return m_integer; }

private:
    static std::uint32_t found(const std::map<Id, std::uint32_t>& map, Id id) {
        const auto found = map.find(id);
        return found == map.end() ? 0 : found->second;
    }

    std::map<Id, Id> m_arrays;   // types of elements
    std::map<Id, Id> m_columns;  // of vectors and matrices
    std::map<Id, Id> m_pointers;
    std::map<Id, Words> m_members;
    std::map<Id, Id> m_values;
    std::map<Id, std::uint32_t> m_constants;
    Id m_integer = 0;  // with 32 bits
};

/// Writes a module with the changes.
class Unnester {
public:
    Unnester(const Types& types, Words header) : m_types(types), m_code(std::move(header)) {}

    void write(Instruction one) {
        switch (one.op) {
            case spv::OpTypeArray:
                wrap_element(one);
                break;
            case spv::OpConstantComposite:
            case spv::OpSpecConstantComposite:
            case spv::OpCompositeConstruct:
                wrap_parts(one);
                break;
            case spv::OpAccessChain:
            case spv::OpInBoundsAccessChain:
                lengthen(one, m_types.pointee(one.words[2]), 3, true);
                break;
            case spv::OpCompositeExtract:
                lengthen(one, m_types.type_of(one.words[2]), 3, false);
                break;
            case spv::OpCompositeInsert:
                lengthen(one, m_types.type_of(one.words[3]), 4, false);
                break;
            case spv::OpFunction:
                write_zero();
                break;
            default:
                break;
        }
        append(one, m_code);
    }
    Words code() && { return std::move(m_code); }

private:
    Id new_id() { return m_code[bound_at]++; }

    void wrap_element(Instruction& array) {
        if (!m_types.is_nested(array.words[0]))
            return;
        Id& structure = m_structures[array.words[1]];
        if (structure == 0) {
            structure = new_id();
            append({spv::OpTypeStruct, {structure, array.words[1]}}, m_code);
        }
        array.words[1] = structure;
    }

    // Of a constant or another value.
    void wrap_parts(Instruction& composite) {
        if (!m_types.is_nested(composite.words[0]))
            return;
        const Id structure = m_structures.at(m_types.element_of(composite.words[0]));
        for (std::size_t i = 2; i < composite.words.size(); ++i) {
            const Id wrapped = new_id();
            append({composite.op, {structure, wrapped, composite.words[i]}}, m_code);
            composite.words[i] = wrapped;
        }
    }

    // Adds the index of the only member after each index into an array of structures.
    void lengthen(Instruction& access, Id type, std::size_t first, bool has_ids) {
        const auto begin = access.words.begin() + static_cast<std::ptrdiff_t>(first);
        const Words indices(begin, access.words.end());
        access.words.erase(begin, access.words.end());
        for (const std::uint32_t index : indices) {
            access.words.push_back(index);
            if (m_types.is_nested(type))
                access.words.push_back(has_ids ? m_zero : 0);
            type = m_types.part_of(type, has_ids ? m_types.constant(index) : index);
        }
    }

    // Before the first function.
    void write_zero() {
        if (m_zero != 0)
            return;
        Id integer = m_types.integer();
        if (integer == 0) {
            integer = new_id();
            append({spv::OpTypeInt, {integer, 32, 1}}, m_code);
        }
        m_zero = new_id();
        append({spv::OpConstant, {integer, m_zero, 0}}, m_code);
    }

    const Types& m_types;
    Words m_code;
    std::map<Id, Id> m_structures;  // by the array that they contain
    Id m_zero = 0;
};
}  // namespace

std::vector<std::uint32_t> without_nested_arrays(std::vector<std::uint32_t> code) {
    const std::vector<Instruction> all = instructions_of(code);
    Types types;
    for (const Instruction& one : all)
        types.note(one);
    if (!types.has_nested())
        return code;
    code.resize(header_words);
    Unnester unnester(types, std::move(code));
    for (const Instruction& one : all)
        unnester.write(one);
    return std::move(unnester).code();
}
