#pragma once

#include <spirv_cross/spirv.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

/// A SPIR-V instruction and its words after the first.
struct SpirvInstruction {
    spv::Op op;
    std::vector<std::uint32_t> words;
};

/// The instructions of a module after its header.
std::vector<SpirvInstruction> spirv_instructions(const std::vector<std::uint32_t>& code);
void append(const SpirvInstruction& instruction, std::vector<std::uint32_t>& code);

/// The composite types of a module, and the types of values that can have one.
class SpirvTypes {
public:
    using Id = std::uint32_t;

    struct Array {
        Id element = 0;
        std::uint32_t length = 0;  // 0: not a plain constant
    };

    explicit SpirvTypes(const std::vector<SpirvInstruction>& instructions);

    /// Null for other types.
    const Array* array(Id type) const;
    bool is_nested(Id type) const;
    const std::map<Id, Array>& arrays() const { return m_arrays; }
    /// The type of a part. `index` matters for structures only.
    Id part_of(Id type, std::uint32_t index) const;
    Id type_of(Id value) const { return found(m_values, value); }
    Id pointee(Id pointer) const { return found(m_pointers, type_of(pointer)); }
    /// The number of a constant with 32 bits, otherwise 0.
    std::uint32_t constant(Id id) const { return found(m_constants, id); }
    /// The first type of integers with 32 bits. 0: there is none.
    Id integer() const { return m_integer; }

private:
    static std::uint32_t found(const std::map<Id, std::uint32_t>& map, Id id);
    void note(const SpirvInstruction& one);

    std::map<Id, Array> m_arrays;
    std::map<Id, Id> m_columns;  // of vectors and matrices
    std::map<Id, Id> m_pointers;
    std::map<Id, std::vector<Id>> m_members;
    std::map<Id, Id> m_values;
    std::map<Id, std::uint32_t> m_constants;
    Id m_integer = 0;
};
