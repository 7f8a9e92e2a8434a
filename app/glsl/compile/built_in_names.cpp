#include "glsl/compile/built_in_names.h"

#include "glsl/limits/start.h"
#include "glsl/text/shader_names.h"

#include <glslang/Include/Common.h>
#include <glslang/MachineIndependent/Initialize.h>

#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <tuple>

namespace {
/// Memory for glslang's strings on this thread, instead of the current shader's.
class PoolScope {
public:
    PoolScope() { glslang::SetThreadPoolAllocator(&m_pool); }
    ~PoolScope() { glslang::SetThreadPoolAllocator(&m_before); }
    PoolScope(const PoolScope&) = delete;
    PoolScope& operator=(const PoolScope&) = delete;

private:
    glslang::TPoolAllocator& m_before = glslang::GetThreadPoolAllocator();
    glslang::TPoolAllocator m_pool;
};

void add_names(std::string_view declarations, BuiltInNames& names, std::set<std::string>& known) {
    const ShaderNames found = names_at(declarations, std::numeric_limits<int>::max());
    for (const FunctionName& function : found.functions)
        if (known.insert(function.name).second)
            names.functions.push_back(function.name);
    for (const TypedName& variable : found.variables)
        if (known.insert(variable.name).second)
            names.variables.push_back(variable.name);
}

BuiltInNames read_names(const Dialect& dialect) {
    start_glslang();
    const PoolScope pool;
    glslang::SpvVersion target;
    if (dialect.is_vulkan) {
        target.spv = glslang::EShTargetSpv_1_0;
        target.vulkan = glslang::EShTargetVulkan_1_0;
        target.vulkanGlsl = 100;
    }
    glslang::TBuiltIns declarations;
    declarations.initialize(dialect.version, ECoreProfile, target);
    BuiltInNames names;
    std::set<std::string> known;
    add_names(declarations.getCommonString().c_str(), names, known);
    add_names(declarations.getStageString(dialect.stage).c_str(), names, known);
    return names;
}
}  // namespace

const BuiltInNames& find_built_in_names(const Dialect& dialect) {
    static std::mutex mutex;
    static std::map<std::tuple<EShLanguage, int, bool>, BuiltInNames> known;
    const std::scoped_lock lock(mutex);
    const std::tuple key(dialect.stage, dialect.version, dialect.is_vulkan);
    auto found = known.find(key);
    if (found == known.end())
        found = known.emplace(key, read_names(dialect)).first;
    return found->second;
}
