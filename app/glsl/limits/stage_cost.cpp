#include "glsl/limits/stage_cost.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

using glslang::TIntermTyped;
using glslang::TType;

namespace {
/// The cost of one value of a type.
struct Size {
    double bytes = 0.0;
    double elements = 0.0;  // copied individually: vectors and scalars
    double names = 0.0;     // listed by a driver for a uniform
    double depth = 0.0;     // nesting of structs
};

/// Sizes of types. Each struct is measured once, because otherwise the time could double with each
/// level of nesting.
class Sizes {
public:
    Size of(const TType& type) {
        Size size = type.isStruct() ? of_struct(*type.getStruct()) : of_numbers(type);
        const double count = type.isSizedArray() ? std::max(type.getCumulativeArraySize(), 1) : 1;
        size.bytes *= count;
        size.elements *= count;
        if (type.isStruct())
            size.names *= count;
        return size;
    }

private:
    static Size of_numbers(const TType& type) {
        const int rows = type.isMatrix() ? type.getMatrixRows() : type.getVectorSize();
        const int columns = type.isMatrix() ? type.getMatrixCols() : 1;
        const double bytes = type.getBasicType() == glslang::EbtDouble ? 8.0 : 4.0;
        return {bytes * std::max(rows, 1) * columns, static_cast<double>(columns), 1.0, 0.0};
    }

    Size of_struct(const glslang::TTypeList& members) {
        if (const auto known = m_known.find(&members); known != m_known.end())
            return known->second;
        Size sum;
        for (const glslang::TTypeLoc& member : members) {
            const Size size = of(*member.type);
            sum.bytes += size.bytes;
            sum.elements += size.elements;
            sum.names += size.names;
            sum.depth = std::max(sum.depth, size.depth);
        }
        sum.depth += 1.0;
        return m_known[&members] = sum;
    }

    std::map<const glslang::TTypeList*, Size> m_known;
};

/// A figure, its limit, and the message for exceeding it: {0} is the figure, {1} the limit.
struct LimitedFigure {
    double ShaderLimits::*limit;
    StageCost::Figure StageCost::*figure;
    const char* refusal;
};

constexpr std::array figures{
    LimitedFigure{&ShaderLimits::depth, &StageCost::depth,
                  "the shader has {0:.0f} levels of nested structs or calls; the limit is {1:.0f}. "
                  "Simplify it, or raise the limit with --limit depth={0:.0f}"},
    LimitedFigure{
        &ShaderLimits::variable_bytes, &StageCost::variable_bytes,
        "the shader has {0:.0f} bytes of variables; the limit is {1:.0f}. Simplify it, or "
        "raise the limit with --limit variable-bytes={0:.0f}"},
    LimitedFigure{&ShaderLimits::indexed_bytes, &StageCost::indexed_bytes,
                  "the shader has {0:.0f} bytes of arrays with a computed index; the limit is "
                  "{1:.0f}. Simplify it, or raise the limit with --limit indexed-bytes={0:.0f}"},
    LimitedFigure{&ShaderLimits::uniforms, &StageCost::uniforms,
                  "the shader has {0:.0f} uniforms, counting the members of structs; the limit is "
                  "{1:.0f}. Simplify it, or raise the limit with --limit uniforms={0:.0f}"},
    LimitedFigure{
        &ShaderLimits::switch_cases, &StageCost::switch_cases,
        "the shader has {0:.0f} cases in one switch; the limit is {1:.0f}. Simplify it, or "
        "raise the limit with --limit switch-cases={0:.0f}"},
    LimitedFigure{&ShaderLimits::inlined_calls, &StageCost::inlined_calls,
                  "the shader has {0:.0f} calls after inlining; the limit is {1:.0f}. Simplify it, "
                  "or raise the limit with --limit inlined-calls={0:.0f}"},
    LimitedFigure{&ShaderLimits::compared_values, &StageCost::compared_values,
                  "the shader compares {0:.0f} values in arrays and structs; the limit is {1:.0f}. "
                  "Simplify it, or raise the limit with --limit compared-values={0:.0f}"},
    LimitedFigure{&ShaderLimits::instructions, &StageCost::instructions,
                  "the shader has {0:.0f} instructions after inlining; the limit is {1:.0f}. "
                  "Simplify it, or raise the limit with --limit instructions={0:.0f}"},
};

bool is_composite(const TType& type) {
    return type.isArray() || type.isStruct();
}

// The root of an access chain such as `a[i].b[j]`.
TIntermTyped& base_of(TIntermTyped& expression) {
    TIntermTyped* base = &expression;
    for (;;) {
        const glslang::TIntermBinary* binary = base->getAsBinaryNode();
        const bool is_part = binary && (binary->getOp() == glslang::EOpIndexDirect ||
                                        binary->getOp() == glslang::EOpIndexIndirect ||
                                        binary->getOp() == glslang::EOpIndexDirectStruct);
        if (!is_part)
            return *base;
        base = binary->getLeft();
    }
}

// Cost of one function, or of the code outside functions.
struct Part {
    double instructions = 0.0;
    double compared_values = 0.0;
    double number_bytes = 0.0;     // of variables other than arrays and structs
    double composite_bytes = 0.0;  // of arrays and structs
    double indexed_bytes = 0.0;
    int line = 0;
    std::vector<std::string> calls;  // one entry per call
};

/// Cost of a part with its calls inlined.
struct Inlined {
    double instructions = 0.0;
    double composite_bytes = 0.0;
    double indexed_bytes = 0.0;
    double compared_values = 0.0;
    double calls = 0.0;
    double depth = 0.0;  // call depth
};

class Reader : public glslang::TIntermTraverser {
public:
    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        switch (node->getOp()) {
            case glslang::EOpLinkerObjects:
                for (TIntermNode* object : node->getSequence())
                    if (const glslang::TIntermSymbol* symbol = object->getAsSymbolNode())
                        declare(*symbol);
                return false;
            case glslang::EOpFunction:
                m_part = &m_parts[node->getName().c_str()];
                m_part->line = node->getLoc().line;
                for (TIntermNode* child : node->getSequence())
                    child->traverse(this);
                m_part = &m_parts[{}];
                return false;
            case glslang::EOpSequence:
            case glslang::EOpParameters:
            case glslang::EOpNull:
                return true;
            case glslang::EOpFunctionCall:
                m_part->calls.emplace_back(node->getName().c_str());
                for (TIntermNode* argument : node->getSequence())
                    count_copy(*argument);
                break;
            default:
                break;
        }
        count(*node);
        return true;
    }

    bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
        if (node->getOp() == glslang::EOpIndexIndirect)
            note_index(*node);
        if (node->getOp() == glslang::EOpEqual || node->getOp() == glslang::EOpNotEqual)
            count_comparison(*node->getLeft());
        count(*node);
        return true;
    }

    bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
        count(*node);
        return true;
    }

    bool visitSelection(glslang::TVisit, glslang::TIntermSelection* node) override {
        count(*node);
        return true;
    }

    bool visitLoop(glslang::TVisit, glslang::TIntermLoop*) override {
        m_part->instructions += 1.0;
        return true;
    }

    bool visitBranch(glslang::TVisit, glslang::TIntermBranch* node) override {
        m_part->instructions += 1.0;
        if (node->getExpression())
            count_copy(*node->getExpression());
        return true;
    }

    bool visitSwitch(glslang::TVisit, glslang::TIntermSwitch* node) override {
        m_part->instructions += 1.0;
        double cases = 0.0;
        for (TIntermNode* part : node->getBody()->getSequence())
            if (const glslang::TIntermBranch* branch = part->getAsBranchNode())
                cases += branch->getFlowOp() == glslang::EOpCase ? 1.0 : 0.0;
        m_cost.switch_cases.raise(cases, node->getLoc().line);
        return true;
    }

    void visitSymbol(glslang::TIntermSymbol* symbol) override {
        const glslang::TQualifier& qualifier = symbol->getQualifier();
        const bool is_linked = qualifier.isUniformOrBuffer() || qualifier.isPipeInput() ||
                               qualifier.isPipeOutput();  // listed as linker objects
        if (!is_linked && m_known.insert(symbol->getId()).second)
            declare_variable(*symbol);
    }

    // Drivers inline within every function, even if main does not reach it.
    StageCost cost() {
        Inlined largest;
        for (const auto& [name, part] : m_parts) {
            const Inlined& inlined = this->inlined(name);
            m_cost.depth.raise(inlined.depth, part.line);
            m_cost.instructions.raise(inlined.instructions, part.line);
            m_cost.inlined_calls.raise(inlined.calls, part.line);
            m_cost.compared_values.raise(inlined.compared_values, part.line);
            m_cost.variable_bytes.value += part.number_bytes;
            largest.composite_bytes = std::max(largest.composite_bytes, inlined.composite_bytes);
            largest.indexed_bytes = std::max(largest.indexed_bytes, inlined.indexed_bytes);
        }
        const Part& outside = m_parts[{}];
        m_cost.variable_bytes.value += outside.composite_bytes + largest.composite_bytes;
        m_cost.indexed_bytes.value += outside.indexed_bytes + largest.indexed_bytes;
        return m_cost;
    }

private:
    void count(const TIntermTyped& node) {
        m_part->instructions += 1.0;
        const glslang::TIntermOperator* operation = const_cast<TIntermTyped&>(node).getAsOperator();
        const bool is_place = operation && (operation->getOp() == glslang::EOpIndexDirect ||
                                            operation->getOp() == glslang::EOpIndexIndirect ||
                                            operation->getOp() == glslang::EOpIndexDirectStruct);
        if (!is_place && is_composite(node.getType()))
            m_part->instructions += m_sizes.of(node.getType()).elements;
    }

    void count_copy(TIntermNode& value) {
        const TIntermTyped* typed = value.getAsTyped();
        if (typed && is_composite(typed->getType()))
            m_part->instructions += m_sizes.of(typed->getType()).elements;
    }

    // Arrays and structs are compared element by element.
    void count_comparison(TIntermTyped& value) {
        count_copy(value);
        constexpr double bytes_of_number = 4.0;
        if (is_composite(value.getType()))
            m_part->compared_values += m_sizes.of(value.getType()).bytes / bytes_of_number;
    }

    // Uniform blocks and the driver's own arrays are not variables of the program.
    void note_index(const glslang::TIntermBinary& node) {
        TIntermTyped& base = base_of(*node.getLeft());
        const glslang::TStorageQualifier storage = base.getType().getQualifier().storage;
        const bool is_variable = storage == glslang::EvqTemporary ||
                                 storage == glslang::EvqGlobal ||
                                 base.getType().getQualifier().isParamInput() ||
                                 base.getType().getQualifier().isParamOutput();
        if (const glslang::TIntermConstantUnion* constant = base.getAsConstantUnion()) {
            note_constant(*constant);
            return;
        }
        const glslang::TIntermSymbol* symbol = base.getAsSymbolNode();
        if (!is_variable || !base.getType().isArray())
            return;
        if (symbol && !m_indexed.insert(symbol->getId()).second)
            return;
        Part& part = storage == glslang::EvqGlobal ? m_parts[{}] : *m_part;
        part.indexed_bytes += m_sizes.of(base.getType()).bytes;
    }

    // A driver stores a constant table once, however often it is read.
    void note_constant(const glslang::TIntermConstantUnion& table) {
        const glslang::TConstUnionArray& numbers = table.getConstArray();
        if (numbers.empty() || !m_tables.insert(&numbers[0]).second)
            return;
        m_cost.variable_bytes.value += m_sizes.of(table.getType()).bytes;
    }

    // Declares a uniform, an input, an output or a global.
    void declare(const glslang::TIntermSymbol& symbol) {
        const TType& type = symbol.getType();
        if (!m_known.insert(symbol.getId()).second ||
            std::string_view(symbol.getName().c_str()).starts_with("gl_"))
            return;
        const Size size = m_sizes.of(type);
        const int line = symbol.getLoc().line;
        m_cost.depth.raise(size.depth, line);
        m_cost.variable_bytes.value += size.bytes;
        note_large(size.bytes, line);
        if (type.getQualifier().isUniformOrBuffer()) {
            m_cost.uniforms.value += size.names;
            m_cost.uniforms.line = line;
        }
    }

    void declare_variable(const glslang::TIntermSymbol& symbol) {
        const TType& type = symbol.getType();
        const Size size = m_sizes.of(type);
        m_cost.depth.raise(size.depth, symbol.getLoc().line);
        note_large(size.bytes, symbol.getLoc().line);
        Part& part = type.getQualifier().storage == glslang::EvqGlobal ? m_parts[{}] : *m_part;
        (is_composite(type) ? part.composite_bytes : part.number_bytes) += size.bytes;
    }

    void note_large(double bytes, int line) {
        if (bytes <= m_largest)
            return;
        m_largest = bytes;
        m_cost.variable_bytes.line = m_cost.indexed_bytes.line = line;
    }

    // glslang rejects recursion, but only when linking. Call chains too deep for this thread's
    // stack are also too deep for a driver.
    const Inlined& inlined(const std::string& name) {
        constexpr double deepest = 1024.0;
        const auto [known, is_new] = m_inlined.try_emplace(name);
        Inlined& sum = known->second;
        const auto part = m_parts.find(name);
        if (!is_new || part == m_parts.end())
            return sum;
        if (m_nested >= deepest) {
            sum.depth = deepest;
            return sum;
        }
        m_nested += 1.0;
        Inlined all{part->second.instructions, part->second.composite_bytes,
                    part->second.indexed_bytes, part->second.compared_values};
        for (const std::string& call : part->second.calls)
            add_call(inlined(call), all);
        m_nested -= 1.0;
        all.depth += 1.0;
        return sum = all;
    }

    static void add_call(const Inlined& called, Inlined& all) {
        all.instructions += called.instructions;
        all.composite_bytes += called.composite_bytes;
        all.indexed_bytes += called.indexed_bytes;
        all.compared_values += called.compared_values;
        all.calls += called.calls + 1.0;
        all.depth = std::max(all.depth, called.depth);
    }

    Sizes m_sizes;
    StageCost m_cost;
    double m_largest = 0.0;
    std::map<std::string, Part> m_parts;  // by mangled name; "": outside of functions
    Part* m_part = &m_parts[{}];
    std::map<std::string, Inlined> m_inlined;
    double m_nested = 0.0;          // current recursion depth of inlined()
    std::set<long long> m_known;    // symbols by id
    std::set<long long> m_indexed;  // symbols by id
    std::set<const glslang::TConstUnion*> m_tables;
};
}  // namespace

StageCost estimate_cost(glslang::TShader& shader) {
    Reader reader;
    const glslang::TIntermediate& tree = *shader.getIntermediate();
    if (TIntermNode* root = tree.getTreeRoot())
        root->traverse(&reader);
    return reader.cost();
}

std::optional<ExceededLimit> find_exceeded(const StageCost& cost, const ShaderLimits& limits) {
    for (const LimitedFigure& known : figures)
        if ((cost.*known.figure).value > limits.*known.limit)
            return ExceededLimit{known.limit, cost.*known.figure};
    return std::nullopt;
}

std::string refusal(const ExceededLimit& exceeded, const ShaderLimits& limits) {
    const auto* const exceeding = std::ranges::find(figures, exceeded.limit, &LimitedFigure::limit);
    return fmt::format(fmt::runtime(exceeding->refusal), std::ceil(exceeded.figure.value),
                       limits.*exceeded.limit);
}
