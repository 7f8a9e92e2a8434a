#include "glsl/es/spirv_types.h"

#include <algorithm>
#include <array>

namespace {
constexpr std::size_t header_words = 5;

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
    spv::OpCompositeConstruct,
    spv::OpCompositeExtract,
    spv::OpCompositeInsert,
};
}  // namespace

std::vector<SpirvInstruction> spirv_instructions(const std::vector<std::uint32_t>& code) {
    std::vector<SpirvInstruction> all;
    for (std::size_t at = header_words; at < code.size();) {
        const std::size_t count = std::max<std::size_t>(code[at] >> spv::WordCountShift, 1);
        const auto begin = code.begin() + static_cast<std::ptrdiff_t>(at);
        all.push_back({static_cast<spv::Op>(code[at] & spv::OpCodeMask),
                       {begin + 1, begin + static_cast<std::ptrdiff_t>(count)}});
        at += count;
    }
    return all;
}

void append(const SpirvInstruction& instruction, std::vector<std::uint32_t>& code) {
    const auto count = static_cast<std::uint32_t>(instruction.words.size() + 1);
    code.push_back((count << spv::WordCountShift) | static_cast<std::uint32_t>(instruction.op));
    code.insert(code.end(), instruction.words.begin(), instruction.words.end());
}

SpirvTypes::SpirvTypes(const std::vector<SpirvInstruction>& instructions) {
    for (const SpirvInstruction& one : instructions)
        note(one);
}

void SpirvTypes::note(const SpirvInstruction& one) {
    const auto& words = one.words;
    if (one.op == spv::OpTypeArray)
        m_arrays[words[0]] = {words[1], constant(words[2])};
    else if (one.op == spv::OpTypeVector || one.op == spv::OpTypeMatrix)
        m_columns[words[0]] = words[1];
    else if (one.op == spv::OpTypePointer)
        m_pointers[words[0]] = words[2];
    else if (one.op == spv::OpTypeStruct)
        m_members[words[0]] = {words.begin() + 1, words.end()};
    else if (one.op == spv::OpTypeInt && words[1] == 32 && m_integer == 0)
        m_integer = words[0];
    else if (std::ranges::find(typed, one.op) != typed.end())
        m_values[words[1]] = words[0];
    if (one.op == spv::OpConstant)
        m_constants[words[1]] = words[2];
}

const SpirvTypes::Array* SpirvTypes::array(Id type) const {
    const auto found = m_arrays.find(type);
    return found == m_arrays.end() ? nullptr : &found->second;
}

bool SpirvTypes::is_nested(Id type) const {
    const Array* const outer = array(type);
    return outer && array(outer->element);
}

SpirvTypes::Id SpirvTypes::part_of(Id type, std::uint32_t index) const {
    if (const auto members = m_members.find(type); members != m_members.end())
        return index < members->second.size() ? members->second[index] : 0;
    const Array* const elements = array(type);
    return elements ? elements->element : found(m_columns, type);
}

std::uint32_t SpirvTypes::found(const std::map<Id, std::uint32_t>& map, Id id) {
    const auto found = map.find(id);
    return found == map.end() ? 0 : found->second;
}
