#include "glsl/compile/live.h"

#include <glslang/MachineIndependent/LiveTraverser.h>
#include <glslang/Public/ShaderLang.h>

#include <set>

namespace {
class LiveReader : public glslang::TLiveTraverser {
public:
    explicit LiveReader(const glslang::TIntermediate& tree) : TLiveTraverser(tree) {}

    std::vector<std::string> read() {
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
            addGlobalReference(symbol->getName());
        std::string name = symbol->getName().c_str();
        if (symbol->getQualifier().isUniformOrBuffer() && m_known.insert(name).second)
            m_names.push_back(std::move(name));
    }

private:
    std::vector<std::string> m_names;
    std::set<std::string> m_known;
};
}  // namespace

std::vector<std::string> live_uniforms(glslang::TShader& shader) {
    const glslang::TIntermediate& tree = *shader.getIntermediate();
    return tree.getTreeRoot() ? LiveReader(tree).read() : std::vector<std::string>();
}
