#pragma once

#include "base/diagnostic.h"
#include "graph/executor/executor.h"
#include "graph/programs/programs.h"
#include "graph/warm_up/first_draws.h"
#include "lab/library/open.h"

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// The static values that specialised programs have as constants.
struct SpecializationKey {
    Values values;
    Plan plan;
    std::set<std::string> moving;  // parameters that stay uniforms
};

/// A look with static values as constants, and its programs.
struct SpecializedLook {
    Look look;
    Programs programs;
    std::shared_ptr<const SpecializationKey> key;
};

/// The open look, to be specialised.
struct SpecializationRequest {
    Look look;
    std::shared_ptr<const SpecializationKey> key;
    ImageTextures images;
};

/// Kinds of jobs, in order of priority: a look is read; the open look gets other constants in its
/// texts, for the picture or its variant; the open look is specialised.
enum class JobKind { look, constants, variant_constants, specialization };
constexpr std::size_t job_kinds = 4;

/// The result of building a look.
struct BuiltLook {
    JobKind kind = JobKind::look;
    OpenRequest request = {};
    bool is_reload = false;  // of the open look
    std::optional<Look> look = {};
    std::optional<Programs> programs = {};
    std::optional<SpecializedLook> specialized = {};  // for the values that were static before
    ImageTextures images = {};  // of the look; those of unchanged files are shared
    Diagnostics problems = {};  // errors if look or programs are missing, else warnings
    std::vector<std::filesystem::path> files = {};
    std::function<void()> then = {};  // to be called when the look has opened; null: nothing
    bool is_warm = false;  // its programs have drawn in the context that will draw the look
    std::unique_ptr<Executor> executor = {};  // of a warm look, at the picture's size and values;
                                              // null: out of memory
};
