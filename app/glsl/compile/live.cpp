#include "glsl/compile/live.h"

#include <glslang/MachineIndependent/LiveTraverser.h>
#include <glslang/Public/ShaderLang.h>

#include <map>
#include <set>

namespace {
class LiveReader : public glslang::TLiveTraverser {
public:
    explicit LiveReader(const glslang::TIntermediate& tree) : TLiveTraverser(tree) {}

    std::vector<std::string> read() {
        find_initial_values();
        pushFunction(intermediate.getEntryPointMangledName().c_str());
        while (!destinations.empty()) {
            TIntermNode* next = destinations.back();
            destinations.pop_back();
            next->traverse(this);
        }
        return std::move(m_names);
    }

    void visitSymbol(glslang::TIntermSymbol* symbol) override {
        if (symbol->getQualifier().storage == glslang::EvqGlobal)
            add_initial_value(*symbol);
        std::string name = symbol->getName().c_str();
        if (symbol->getQualifier().isUniformOrBuffer() && m_known.insert(name).second)
            m_names.push_back(std::move(name));
    }

private:
    // Unlike addGlobalReference(), also of variables that share a statement with others.
    void add_initial_value(const glslang::TIntermSymbol& variable) {
        const auto found = m_initial.find(variable.getId());
        if (found == m_initial.end())
            return;
        destinations.push_back(found->second);
        m_initial.erase(found);
    }

    // The statements that set global variables, by the variable.
    void find_initial_values() {
        for (TIntermNode* part : intermediate.getTreeRoot()->getAsAggregate()->getSequence()) {
            glslang::TIntermAggregate* const statement = part->getAsAggregate();
            if (!statement || statement->getOp() != glslang::EOpSequence)
                continue;
            for (TIntermNode* value : statement->getSequence())
                if (const glslang::TIntermBinary* const assignment = value->getAsBinaryNode())
                    if (const auto* const variable = assignment->getLeft()->getAsSymbolNode())
                        m_initial.emplace(variable->getId(), statement);
        }
    }

    std::map<long long, glslang::TIntermAggregate*>
        m_initial;  // of variables that are not read yet
    std::vector<std::string> m_names;
    std::set<std::string> m_known;
};
}  // namespace

std::vector<std::string> live_uniforms(glslang::TShader& shader) {
    const glslang::TIntermediate& tree = *shader.getIntermediate();
    return tree.getTreeRoot() ? LiveReader(tree).read() : std::vector<std::string>();
}
