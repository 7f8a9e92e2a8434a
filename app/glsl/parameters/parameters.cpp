#include "glsl/parameters/parameters.h"

#include "glsl/annotations/annotation.h"
#include "glsl/annotations/guess.h"
#include "glsl/compile/interface.h"
#include "glsl/parameters/pass_uniforms.h"
#include "glsl/text/include.h"
#include "model/look/orbit.h"
#include "model/picture/aliasing.h"
#include "model/plan/condition.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
Value zero_of(const NumberType& type) {
    return Value(std::vector<double>(static_cast<std::size_t>(type.size())));
}

/// All declarations of one parameter.
struct Candidate {
    std::string name;
    Uniform uniform;
    Hints hints;
    std::vector<Binding> bindings;
};

void disagree(const Candidate& first, const Uniform& second, std::string_view here,
              std::string_view there, Diagnostics& errors) {
    const Location& at = second.declared.front();
    add_new(errors, {at.file, at.line,
                     fmt::format("'{}' is {} here but {} in another pass{}", first.name, here,
                                 there, location_suffix(first.uniform.declared.front()))});
}

void merge(Candidate& first, const FreeUniform& second, Diagnostics& errors) {
    const Uniform& uniform = second.uniform;
    first.bindings.push_back(second.binding);
    if (first.uniform.type_name != uniform.type_name)
        return disagree(first, uniform, with_indefinite_article(uniform.type_name),
                        with_indefinite_article(first.uniform.type_name), errors);
    if (first.uniform.initial && uniform.initial && first.uniform.initial != uniform.initial)
        return disagree(first, uniform, to_string(*uniform.initial),
                        to_string(*first.uniform.initial), errors);
    if (!first.uniform.initial)
        first.uniform.initial = uniform.initial;
    Diagnostics found;
    merge_hints(first.hints, second.hints, first.name, found);
    add_new(errors, found);
}

Parameter parameter_from(const Candidate& candidate, Diagnostics& errors) {
    const Uniform& uniform = candidate.uniform;
    const bool is_image = uniform.kind == Uniform::Kind::sampler;
    Parameter parameter = guessed_parameter(candidate.name, uniform.type,
                                            uniform.initial.value_or(zero_of(uniform.type)));
    if (is_image) {
        parameter.control = Control::image;
        parameter.initial = Value::of_path("");
    }
    parameter.bindings = candidate.bindings;
    parameter.declared = uniform.declared.front();
    Diagnostics found;
    annotate(parameter, candidate.hints, found);
    add_new(errors, found);
    return parameter;
}

// `refusal`: {0} is the pass, {1} the parameter's name, {2} a similar name.
void check_count(const Pass& pass, const Count& count, const char* refusal,
                 const std::vector<std::string>& names, Diagnostics& errors) {
    const auto* const name = std::get_if<std::string>(&count);
    if (!name || std::ranges::find(names, *name) != names.end())
        return;
    errors.push_back(
        {pass.declared.file, pass.declared.line,
         fmt::format(fmt::runtime(refusal), pass.name, *name, did_you_mean(*name, names))});
}

// Reports uniforms with the name of a constant.
void check_names(const Look& look, const std::vector<Parameter>& parameters, Diagnostics& errors) {
    for (const Parameter& parameter : parameters)
        if (const Parameter* same = find_parameter(look, parameter.name); same && same->is_constant)
            add_new(errors, {{parameter.declared.file, parameter.declared.line,
                              fmt::format("'{}' is a uniform here but a constant elsewhere{}",
                                          parameter.name, location_suffix(same->declared))}});
}

void check_counts(const Look& look, const std::vector<Parameter>& parameters, Diagnostics& errors) {
    std::vector<std::string> names = parameter_names(look);
    for (const Parameter& parameter : parameters)
        names.push_back(parameter.name);
    const auto* const subframes = std::get_if<std::string>(&look.subframes);
    if (subframes && std::ranges::find(names, *subframes) == names.end())
        errors.push_back({look.manifest, 0,
                          fmt::format("'subframes' is '{0}', but no shader declares '{0}'{1}",
                                      *subframes, did_you_mean(*subframes, names))});
    for (const Pass& pass : look.passes) {
        check_count(pass, pass.repeat,
                    "pass '{0}' repeats '{1}' times, but no shader declares '{1}'{2}", names,
                    errors);
        if (pass.converge)
            check_count(pass, *pass.converge,
                        "pass '{0}' converges after '{1}' samples, but no shader declares '{1}'{2}",
                        names, errors);
    }
}

// A condition can name constants, and constants have conditions.
std::vector<Parameter> with_constants(const Look& look, std::vector<Parameter> parameters) {
    for (const Parameter& parameter : look.parameters)
        if (parameter.is_constant)
            parameters.push_back(parameter);
    return parameters;
}

/// The passes that declare the orbit matrices.
struct OrbitPasses {
    std::vector<int> view;
    std::vector<int> camera;

    void add(const PassUniforms& uniforms, int pass) {
        if (std::ranges::find(uniforms.built_in, "u_view") != uniforms.built_in.end())
            view.push_back(pass);
        if (std::ranges::find(uniforms.built_in, "u_camera") != uniforms.built_in.end())
            camera.push_back(pass);
    }
};

void add_orbit(const Look& look, const OrbitPasses& passes, std::vector<Parameter>& parameters,
               Diagnostics& errors) {
    std::vector<Parameter> orbit = orbit_parameters(passes.view, passes.camera);
    if (orbit.empty())
        add_new(errors, {look.manifest, 0,
                         "the look has an 'orbit', but no shader declares 'uniform mat4 u_view' "
                         "or 'uniform mat4 u_camera'"});
    for (Parameter& part : orbit) {
        const auto same = std::ranges::find(parameters, part.name, &Parameter::name);
        if (same != parameters.end())
            add_new(errors,
                    {same->declared.file, same->declared.line,
                     fmt::format("'{}' is reserved for a parameter of the orbit", part.name)});
        part.declared = {look.manifest, 0};
        parameters.push_back(std::move(part));
    }
}
}  // namespace

Result<std::vector<Parameter>> find_parameters(const Look& look, CheckCache* cache,
                                               Diagnostics& warnings) {
    Diagnostics errors;
    std::vector<Candidate> candidates;
    OrbitPasses orbit_passes;
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        PassUniforms pass = find_pass_uniforms(look.passes[i], static_cast<int>(i), cache);
        add_new(errors, pass.errors);
        add_new(warnings, pass.warnings);
        orbit_passes.add(pass, static_cast<int>(i));
        for (FreeUniform& free : pass.free) {
            const auto same = std::ranges::find(candidates, free.parameter, &Candidate::name);
            if (same != candidates.end())
                merge(*same, free, errors);
            else
                candidates.push_back({free.parameter, free.uniform, free.hints, {free.binding}});
        }
    }
    std::vector<Parameter> parameters;
    for (const Candidate& candidate : candidates)
        parameters.push_back(parameter_from(candidate, errors));
    check_names(look, parameters, errors);
    if (errors.empty() && look.has_orbit)
        add_orbit(look, orbit_passes, parameters, errors);
    if (errors.empty())
        check_counts(look, parameters, errors);
    if (errors.empty())
        add_new(errors, check_periods(parameters, look));
    if (errors.empty())
        add_new(errors, check_conditions(with_constants(look, parameters)));
    if (!errors.empty())
        return fail(std::move(errors));
    return parameters;
}
