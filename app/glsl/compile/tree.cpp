#include "glsl/compile/tree.h"

#include "base/text.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ShaderLang.h>

#include <cmath>
#include <optional>
#include <set>

using glslang::TIntermSymbol;
using glslang::TType;

namespace {
std::optional<Scalar> scalar_of(const TType& type) {
    switch (type.getBasicType()) {
        case glslang::EbtFloat:
            return Scalar::floating;
        case glslang::EbtInt:
            return Scalar::integer;
        case glslang::EbtUint:
            return Scalar::unsigned_integer;
        case glslang::EbtBool:
            return Scalar::boolean;
        default:
            return std::nullopt;
    }
}

NumberType shape_of(const TType& type, Scalar scalar) {
    if (type.isMatrix())
        return {scalar, type.getMatrixRows(), type.getMatrixCols()};
    return {scalar, type.isVector() ? type.getVectorSize() : 1, 1};
}

std::string element_name(const TType& type) {
    if (const auto scalar = scalar_of(type))
        return glsl_name(shape_of(type, *scalar));
    if (type.getBasicType() == glslang::EbtDouble) {
        const NumberType shape = shape_of(type, Scalar::floating);
        return shape.size() == 1 ? "double" : 'd' + glsl_name(shape);
    }
    if (type.getBasicType() == glslang::EbtSampler)
        return type.getSampler().getString().c_str();
    if (type.isStruct())
        return fmt::format("{} {}", type.getBasicType() == glslang::EbtBlock ? "block" : "struct",
                           type.getTypeName().c_str());
    return type.getBasicString();
}

std::string type_name_of(const TType& type) {
    std::string name = element_name(type);
    if (type.isArray())
        name += type.isUnsizedArray() ? "[]" : fmt::format("[{}]", type.getOuterArraySize());
    return name;
}

// {} is the uniform's name, a second {} its type.
std::string_view why_no_control(const TType& type) {
    if (type.isArray())
        return "'{}' ({}) is an array; only single values have controls";
    switch (type.getBasicType()) {
        case glslang::EbtStruct:
            return "'{}' ({}) is a struct; only single values have controls";
        case glslang::EbtBlock:
            return "'{}' ({}) is a block; only plain uniforms have controls";
        case glslang::EbtDouble:
            return "'{}' ({}) is a double; use float to get a control";
        case glslang::EbtAtomicUint:
            return "'{}' ({}) is an atomic counter, which has no control";
        case glslang::EbtSampler:
            return "'{}' ({}) is a writable image; a pass can write only to its target";
        default:
            return "'{}' ({}) has a type without a control";
    }
}

// Numbers in the tree are doubles; a uniform holds floats. The shortest decimal of the float is the
// intended value, for 0.92 as well as 0.1 * 3.0.
std::optional<double> number_from(const glslang::TConstUnion& constant) {
    switch (constant.getType()) {
        case glslang::EbtInt:
            return constant.getIConst();
        case glslang::EbtUint:
            return constant.getUConst();
        case glslang::EbtBool:
            return constant.getBConst() ? 1.0 : 0.0;
        default:
            return parse_number(format_float(static_cast<float>(constant.getDConst())));
    }
}

class Reader : public glslang::TIntermTraverser {
public:
    Reader(const std::map<std::string, Location>& locations, Diagnostics& errors)
        : m_locations(locations), m_errors(errors) {}

    StageInterface interface() {
        for (auto* varyings : {&m_interface.inputs, &m_interface.outputs})
            for (Varying& varying : *varyings)
                varying.is_used = m_used.contains(varying.name);
        return std::move(m_interface);
    }

    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        if (node->getOp() != glslang::EOpLinkerObjects)
            return true;
        for (TIntermNode* object : node->getSequence())
            if (const TIntermSymbol* symbol = object->getAsSymbolNode())
                declare(*symbol);
        return false;
    }

    void visitSymbol(TIntermSymbol* symbol) override { m_used.insert(symbol->getName().c_str()); }

private:
    void declare(const TIntermSymbol& symbol) {
        const std::string name = symbol.getName().c_str();
        const TType& type = symbol.getType();
        const glslang::TQualifier& qualifier = type.getQualifier();
        if (name.starts_with("gl_"))
            return;
        const Varying varying{name, type_name_of(type), false, qualifier.hasLocation()};
        if (qualifier.storage == glslang::EvqVaryingIn)
            m_interface.inputs.push_back(varying);
        else if (qualifier.storage == glslang::EvqVaryingOut)
            m_interface.outputs.push_back(varying);
        else if (qualifier.storage == glslang::EvqUniform ||
                 qualifier.storage == glslang::EvqBuffer)
            m_interface.uniforms.push_back(uniform_from(symbol));
    }

    Uniform uniform_from(const TIntermSymbol& symbol) {
        const TType& type = symbol.getType();
        Uniform uniform;
        const bool is_block = type.getBasicType() == glslang::EbtBlock;
        uniform.name = is_block ? type.getTypeName().c_str() : symbol.getName().c_str();
        uniform.type_name = type_name_of(type);
        const auto found = m_locations.find(uniform.name);
        uniform.declared.push_back(found == m_locations.end() ? Location{} : found->second);
        const auto scalar = scalar_of(type);
        if (scalar && !type.isArray()) {
            uniform.kind = Uniform::Kind::number;
            uniform.type = shape_of(type, *scalar);
            uniform.initial = initial_of(symbol, uniform);
        } else if (type.getBasicType() == glslang::EbtSampler && !type.isArray() &&
                   !type.getSampler().isImage()) {
            uniform.kind = Uniform::Kind::sampler;
        } else {
            uniform.why_no_control =
                fmt::format(fmt::runtime(why_no_control(type)), uniform.name, uniform.type_name);
        }
        return uniform;
    }

    std::optional<Value> initial_of(const TIntermSymbol& symbol, const Uniform& uniform) {
        const glslang::TConstUnionArray& constants = symbol.getConstArray();
        if (constants.size() != uniform.type.size())
            return std::nullopt;
        Value value;
        for (int i = 0; i < constants.size(); ++i) {
            const auto number = number_from(constants[i]);
            if (!number) {
                const Location& at = uniform.declared.front();
                m_errors.push_back({at.file, at.line,
                                    fmt::format("the default of '{}' is not a finite 32-bit number",
                                                uniform.name)});
                return std::nullopt;
            }
            value.numbers.push_back(*number);
        }
        return value;
    }

    const std::map<std::string, Location>& m_locations;
    Diagnostics& m_errors;
    StageInterface m_interface;
    std::set<std::string> m_used;
};
}  // namespace

StageInterface read_tree(glslang::TShader& shader, const std::map<std::string, Location>& locations,
                         Diagnostics& errors) {
    Reader reader(locations, errors);
    if (TIntermNode* root = shader.getIntermediate()->getTreeRoot())
        root->traverse(&reader);
    return reader.interface();
}
