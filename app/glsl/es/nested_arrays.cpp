#include "glsl/es/nested_arrays.h"

#include "glsl/es/spirv_types.h"

#include <algorithm>
#include <map>
#include <utility>

namespace {
using Id = SpirvTypes::Id;
using Words = std::vector<std::uint32_t>;

constexpr std::size_t header_words = 5;
constexpr std::size_t bound_at = 3;  // in the header: the smallest unused id

/// Writes a module with one array instead of nested ones.
class ArrayFlattener {
public:
    ArrayFlattener(const SpirvTypes& types, Words header)
        : m_types(types), m_code(std::move(header)) {}

    void write(SpirvInstruction one);
    bool has_failed() const { return m_has_failed; }
    Words code() && { return std::move(m_code); }

private:
    Id new_id() { return m_code[bound_at]++; }
    Id integer();
    Id number(std::uint32_t number);
    Id leaf_type(Id type) const;
    std::uint32_t leaf_count(Id type) const;
    void flatten_type(SpirvInstruction& array);
    void note_constant(const SpirvInstruction& constant);
    void flatten_composite(SpirvInstruction& composite);
    void append_leaves(Id value, Id type, Words& leaves);
    void flatten_chain(SpirvInstruction& chain);
    void flatten_path(SpirvInstruction& access, Id type, std::size_t first);
    void write_numbers();

    const SpirvTypes& m_types;
    Words m_code;
    Id m_integer = 0;
    std::map<std::uint32_t, Id> m_numbers;  // constants by number
    std::map<Id, Words> m_leaves;           // elements of constant arrays
    bool m_is_in_functions = false;
    bool m_has_failed = false;
};

Id ArrayFlattener::leaf_type(Id type) const {
    while (const SpirvTypes::Array* const array = m_types.array(type))
        type = array->element;
    return type;
}

// Of all dimensions; 0 if a length is not known.
std::uint32_t ArrayFlattener::leaf_count(Id type) const {
    std::uint32_t count = 1;
    while (const SpirvTypes::Array* const array = m_types.array(type)) {
        count *= array->length;
        type = array->element;
    }
    return count;
}

Id ArrayFlattener::integer() {
    if (m_integer == 0)
        m_integer = m_types.integer();
    if (m_integer == 0) {
        m_integer = new_id();
        append({spv::OpTypeInt, {m_integer, 32, 1}}, m_code);
    }
    return m_integer;
}

// Known before the first function.
Id ArrayFlattener::number(std::uint32_t number) {
    Id& id = m_numbers[number];
    if (id == 0 && !m_is_in_functions) {
        const Id type = integer();
        id = new_id();
        append({spv::OpConstant, {type, id, number}}, m_code);
    }
    m_has_failed = m_has_failed || id == 0;
    return id;
}

void ArrayFlattener::flatten_type(SpirvInstruction& array) {
    if (!m_types.is_nested(array.words[0]))
        return;
    const std::uint32_t count = leaf_count(array.words[0]);
    m_has_failed = m_has_failed || count == 0;
    array.words[1] = leaf_type(array.words[0]);
    array.words[2] = number(count);
}

void ArrayFlattener::note_constant(const SpirvInstruction& constant) {
    if (!m_types.array(constant.words[0]))
        return;
    Words leaves;
    for (std::size_t i = 2; i < constant.words.size(); ++i)
        append_leaves(constant.words[i], m_types.array(constant.words[0])->element, leaves);
    m_leaves[constant.words[1]] = std::move(leaves);
}

// Of a value, which can be an array itself.
void ArrayFlattener::append_leaves(Id value, Id type, Words& leaves) {
    if (!m_types.array(type)) {
        leaves.push_back(value);
        return;
    }
    if (const auto known = m_leaves.find(value); known != m_leaves.end()) {
        leaves.insert(leaves.end(), known->second.begin(), known->second.end());
        return;
    }
    m_has_failed = m_has_failed || !m_is_in_functions;
    for (std::uint32_t i = 0; i < leaf_count(type); ++i) {
        leaves.push_back(new_id());
        append({spv::OpCompositeExtract, {leaf_type(type), leaves.back(), value, i}}, m_code);
    }
}

// Of a constant or another value.
void ArrayFlattener::flatten_composite(SpirvInstruction& composite) {
    if (!m_types.is_nested(composite.words[0]))
        return;
    Words leaves;
    for (std::size_t i = 2; i < composite.words.size(); ++i)
        append_leaves(composite.words[i], m_types.array(composite.words[0])->element, leaves);
    composite.words.resize(2);
    composite.words.insert(composite.words.end(), leaves.begin(), leaves.end());
}

// ((i * B) + j) * C + k for an array of A arrays of B arrays of C elements.
void ArrayFlattener::flatten_chain(SpirvInstruction& chain) {
    constexpr std::size_t first = 3;
    Words path(chain.words.begin() + first, chain.words.end());
    chain.words.resize(first);
    Id type = m_types.pointee(chain.words[2]);
    for (std::size_t at = 0; at < path.size(); ++at) {
        Id index = path[at];
        while (m_types.is_nested(type)) {
            type = m_types.part_of(type, 0);
            if (++at == path.size()) {
                m_has_failed = true;
                return;
            }
            const Id start = new_id();
            append({spv::OpIMul, {integer(), start, index, number(m_types.array(type)->length)}},
                   m_code);
            index = new_id();
            append({spv::OpIAdd, {integer(), index, start, path[at]}}, m_code);
        }
        chain.words.push_back(index);
        type = m_types.part_of(type, m_types.constant(path[at]));
    }
}

// The same with numbers instead of ids.
void ArrayFlattener::flatten_path(SpirvInstruction& access, Id type, std::size_t first) {
    Words path(access.words.begin() + static_cast<std::ptrdiff_t>(first), access.words.end());
    access.words.resize(first);
    for (std::size_t at = 0; at < path.size(); ++at) {
        std::uint32_t index = path[at];
        while (m_types.is_nested(type)) {
            type = m_types.part_of(type, 0);
            if (++at == path.size()) {
                m_has_failed = true;
                return;
            }
            index = index * m_types.array(type)->length + path[at];
        }
        access.words.push_back(index);
        type = m_types.part_of(type, path[at]);
    }
}

// The lengths that indices are multiplied with.
void ArrayFlattener::write_numbers() {
    for (const auto& [type, array] : m_types.arrays())
        number(array.length);
    m_is_in_functions = true;
}

void ArrayFlattener::write(SpirvInstruction one) {
    switch (one.op) {
        case spv::OpTypeArray:
            flatten_type(one);
            break;
        case spv::OpConstantComposite:
            note_constant(one);
            flatten_composite(one);
            break;
        case spv::OpCompositeConstruct:
            flatten_composite(one);
            break;
        case spv::OpAccessChain:
        case spv::OpInBoundsAccessChain:
            flatten_chain(one);
            break;
        case spv::OpCompositeExtract:
            flatten_path(one, m_types.type_of(one.words[2]), 3);
            break;
        case spv::OpCompositeInsert:
            flatten_path(one, m_types.type_of(one.words[3]), 4);
            break;
        case spv::OpFunction:
            if (!m_is_in_functions)
                write_numbers();
            break;
        default:
            break;
    }
    append(one, m_code);
}
}  // namespace

std::vector<std::uint32_t> without_nested_arrays(std::vector<std::uint32_t> code) {
    const std::vector<SpirvInstruction> all = spirv_instructions(code);
    const SpirvTypes types(all);
    if (std::ranges::none_of(types.arrays(),
                             [&](const auto& array) { return types.is_nested(array.first); }))
        return code;
    ArrayFlattener flattener(types, Words(code.begin(), code.begin() + header_words));
    for (const SpirvInstruction& one : all)
        flattener.write(one);
    return flattener.has_failed() ? code : std::move(flattener).code();
}
