#include "formats/effect/effect_look.h"

#include "formats/effect/effect_files.h"
#include "formats/effect/effect_limits.h"
#include "formats/effect/effect_names.h"
#include "formats/stack/conversion_stage.h"
#include "glsl/text/include.h"
#include "glsl/text/tokens.h"
#include "model/picture/source_spec.h"
#include "model/plan/parameter_use.h"
#include "model/plan/plan.h"
#include "signals/patterns/generated_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>

namespace {
constexpr const char* source_name = "source";
constexpr const char* screen_name = "screen";

bool reads_source(const Look& look) {
    return std::ranges::any_of(look.passes, [](const Pass& pass) {
        return std::ranges::any_of(
            pass.inputs, [](const Input& input) { return input.from == Input::From::source; });
    });
}

// A pass that only copies.
Pass copy_pass(std::string name, Encoding from, Encoding to, Copied how, const Input& of) {
    Pass pass;
    pass.name = std::move(name);
    pass.vertex = fullscreen_vertex_stage();
    pass.fragment = conversion_stage(from, to, how);
    pass.inputs = {of};
    pass.inputs.front().uniform = "image";
    return pass;
}

// The pictures that parameters select become images of the look.
void add_chosen_pictures(Look& look, const Values& values) {
    for (const Parameter& parameter : look.parameters) {
        const std::string& path = value_of(parameter, values).path;
        const auto source = parse_source(path);
        if (parameter.control != Control::image || path.empty() || !source)
            continue;
        Image image;
        image.name = parameter.name;
        if (made_name(source->picture))
            image.made = source->picture;
        else
            image.file = source->picture;
        for (const Binding& binding : parameter.bindings) {
            std::vector<Input>& inputs = look.passes[static_cast<std::size_t>(binding.pass)].inputs;
            const auto known = std::ranges::find(inputs, binding.uniform, &Input::uniform);
            if (known == inputs.end())
                inputs.push_back({binding.uniform, Input::From::image, image.name, 0, {}});
        }
        const auto known = std::ranges::find(look.images, image.name, &Image::name);
        if (known == look.images.end()) {
            look.images.push_back(std::move(image));
        } else {
            known->file = image.file;
            known->made = image.made;
        }
    }
}

// A sampler reads black if its picture is not chosen.
void remove_missing_pictures(Look& look) {
    const auto is_missing = [&](const Input& input) {
        return input.from == Input::From::image &&
               std::ranges::find(look.images, input.name, &Image::name) == look.images.end();
    };
    std::erase_if(look.images,
                  [](const Image& image) { return image.file.empty() && image.made.empty(); });
    for (Pass& pass : look.passes)
        std::erase_if(pass.inputs, is_missing);
}

// Whether a pass's fragment shader uses a value, not only declares it. Files that can't be read are
// an error of the format's writer.
bool uses(const Look& look, const Pass& pass, std::initializer_list<BuiltIn> kinds) {
    const auto files = effect_files(look, pass);
    const std::string text = files ? joined_text(*files) : std::string();
    const Tokens tokens = scan(text);
    return std::ranges::any_of(pass.built_ins, [&](const BuiltInUniform& uniform) {
        return std::ranges::find(kinds, uniform.kind) != kinds.end() &&
               std::ranges::count(tokens.all, uniform.name, &Token::text) > 1;
    });
}

bool uses(const Look& look, std::initializer_list<BuiltIn> kinds) {
    return std::ranges::any_of(look.passes,
                               [&](const Pass& pass) { return uses(look, pass, kinds); });
}

// What a parameter loses although its shaders can be written; "" if it stays adjustable.
std::string loss_of(const Look& look, const Parameter& parameter) {
    if (parameter.bindings.empty())
        return {};
    const auto loss = [&](const char* reason) {
        return fmt::format("The control '{}'. {}", parameter.label, reason);
    };
    if (parameter.control == Control::image)
        return loss("Its picture is fixed.");
    if (parameter.control == Control::event)
        return loss("It is never pressed.");
    if (parameter.is_constant)
        return loss("It is a constant of the shaders, so its value is fixed.");
    if (drives_size(look, parameter))
        return loss("It sets the size of a pass, so its value is fixed.");
    return {};
}

/// Reduces a look, pass by pass.
class EffectMaker {
public:
    EffectMaker(const Look& look, const EffectHost& host, Extent size, Plan plan, Plan larger)
        : m_look(look),
          m_host(host),
          m_size(size),
          m_plan(std::move(plan)),
          m_larger(std::move(larger)) {}

    Effect make() {
        m_effect.look = m_look;
        m_effect.look.passes.clear();
        name_passes();
        for (std::size_t i = 0; i < m_look.passes.size(); ++i)
            if (!is_left_out(i))
                m_kept.push_back(i);
        if (reads_source(m_look) && needs_source_pass())
            add_source();
        for (const std::size_t i : m_kept)
            add(i);
        add_screen();
        if (m_host.has_feedback && !m_host.keeps_previous)
            copy_previous();
        if (m_host.samples_per_texture)
            separate_samplers();
        move_bindings();
        list_missing_values();
        return std::move(m_effect);
    }

private:
    bool is_left_out(std::size_t pass) const {
        return is_idle(m_look, pass, m_plan.targets[pass].extent) &&
               pass + 1 < m_look.passes.size();
    }

    // Parameters keep their names.
    void name_passes() {
        for (const Parameter& parameter : m_look.parameters)
            m_given.add(parameter.name);
        m_source = m_given.add(source_name);
        for (const Pass& pass : m_look.passes)
            m_names[pass.name] = m_given.add(pass.name);
        for (Image& image : m_effect.look.images)
            image.name = m_image_names[image.name] = m_given.add(image.name);
    }

    bool needs_source_pass() const {
        return m_host.is_on_screen || m_look.source_encoding == Encoding::linear ||
               m_look.source_rows != m_host.rows ||
               std::ranges::any_of(m_look.passes, [](const Pass& pass) {
                   return std::ranges::any_of(pass.inputs, [](const Input& input) {
                       return input.from == Input::From::source &&
                              (input.sampler.mipmap || input.frames_ago > 0);
                   });
               });
    }

    void add_source() {
        const bool flips = m_look.source_rows != m_host.rows;
        Pass pass = copy_pass(m_source, Encoding::display, m_look.source_encoding,
                              flips ? Copied::upside_down : Copied::whole,
                              {{}, Input::From::source, {}, 0, {.filter = Filter::nearest}});
        pass.format = m_look.source_format;
        pass.size.fill({Side::By::source, 1.0, {}});
        m_effect.look.passes.push_back(std::move(pass));
        m_effect.source_pass = m_source;
    }

    // Expressions become a factor of the viewport, or a number of pixels.
    Side plain_side(std::size_t pass, std::size_t axis) const {
        const Pass& from = m_look.passes[pass];
        if (from.size[axis].by != Side::By::expression)
            return from.size[axis].by == Side::By::before ? side_before(pass, axis)
                                                          : from.size[axis];
        const auto length = [axis](const Plan& plan, std::size_t index) {
            const Extent& extent = plan.targets[index].extent;
            return axis == 0 ? extent.width : extent.height;
        };
        const int own = length(m_plan, pass);
        if (own == length(m_larger, pass))
            return {Side::By::pixels, static_cast<double>(own), {}};
        const int whole = axis == 0 ? m_size.width : m_size.height;
        return {Side::By::viewport, static_cast<double>(own) / whole, {}};
    }

    // A factor of the previous pass becomes one of what that is relative to.
    Side side_before(std::size_t pass, std::size_t axis) const {
        Side side = pass == 0 ? Side{Side::By::source, 1.0, {}} : plain_side(pass - 1, axis);
        side.factor *= m_look.passes[pass].size[axis].factor;
        return side;
    }

    void add(std::size_t index) {
        Pass pass = m_look.passes[index];
        pass.name = m_names[pass.name];
        pass.format = m_plan.targets[index].format;
        pass.size = {plain_side(index, 0), plain_side(index, 1)};
        pass.one_channel.clear();
        pass.half_floats.clear();
        pass.onto.reset();
        pass.blend = Blend::replace;
        if (!pass.source.empty())
            pass.source = m_names[pass.source];
        for (Input& input : pass.inputs)
            redirect(input);
        for (BuiltInUniform& built_in : pass.built_ins)
            if (built_in.of)
                redirect(*built_in.of);
        m_effect.look.passes.push_back(std::move(pass));
    }

    void redirect(Input& input) {
        if (input.from == Input::From::source && !m_effect.source_pass.empty()) {
            input.from = Input::From::pass;
            input.name = m_source;
        } else if (input.from == Input::From::pass) {
            const auto pass = find_pass(m_look, input.name);
            if (pass && is_left_out(static_cast<std::size_t>(*pass)))
                redirect_idle(input);
            else
                input.name = m_names[input.name];
        } else if (input.from == Input::From::image) {
            input.name = m_image_names.at(input.name);
        }
        input.sampler.mipmap = input.sampler.mipmap && m_host.has_mipmaps;
    }

    // What is read from an unused pass has no effect.
    void redirect_idle(Input& input) {
        input.frames_ago = 0;
        input.sampler = {};
        if (m_effect.look.passes.empty())
            input.from = Input::From::source;
        else
            input.name = m_effect.look.passes.front().name;
    }

    void add_screen() {
        const Look& look = m_effect.look;
        const Pass& last = look.passes.back();
        const bool flips = last.rows != m_host.rows && !m_host.turns_last_pass;
        const Side whole{Side::By::viewport, 1.0, {}};
        const bool is_whole = last.size[0] == whole && last.size[1] == whole;
        const bool is_read = m_host.is_on_screen && !readers_of(last.name).empty();
        if (!flips && is_whole && m_look.output == Encoding::display && !is_read)
            return;
        Sampler sampler{.filter = is_whole ? Filter::nearest : Filter::linear};
        Pass pass = copy_pass(m_given.add(screen_name), m_look.output, Encoding::display,
                              flips ? Copied::upside_down : Copied::whole,
                              {{}, Input::From::pass, last.name, 0, sampler});
        pass.format = Format::rgba8;
        if (m_host.turns_last_pass)
            pass.rows = last.rows;
        m_effect.look.passes.push_back(std::move(pass));
        m_effect.look.output = Encoding::display;
    }

    // A picture of the previous frame is copied before its pass replaces it.
    void copy_previous() {
        std::vector<Pass>& passes = m_effect.look.passes;
        for (std::size_t i = 0; i < passes.size(); ++i) {
            std::vector<Input*> readers;
            for (std::size_t later = i + 1; later < passes.size(); ++later)
                for (Input& input : passes[later].inputs)
                    if (input.from == Input::From::pass && input.name == passes[i].name &&
                        input.frames_ago > 0)
                        readers.push_back(&input);
            if (readers.empty())
                continue;
            Pass copy = copy_of(passes[i], {.filter = Filter::nearest});
            copy.inputs.front().frames_ago = 1;
            for (Input* input : readers) {
                input->name = copy.name;
                input->frames_ago = 0;
            }
            passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(i), std::move(copy));
            ++i;
        }
    }

    Pass copy_of(const Pass& pass, const Sampler& sampler) {
        Pass copy =
            copy_pass(m_given.add(pass.name), Encoding::linear, Encoding::linear,
                      Copied::texel_by_texel, {{}, Input::From::pass, pass.name, 0, sampler});
        copy.format = pass.format;
        copy.size = pass.size;
        return copy;
    }

    // Readers with another sampler than the first get a copy.
    void separate_samplers() {
        std::vector<Pass>& passes = m_effect.look.passes;
        for (std::size_t i = 0; i < passes.size(); ++i) {
            std::vector<Input*> readers = readers_of(passes[i].name);
            if (readers.empty())
                continue;
            const Sampler first = readers.front()->sampler;
            std::erase_if(readers, [&](const Input* input) { return input->sampler == first; });
            if (readers.empty())
                continue;
            Pass copy = copy_of(passes[i], first);
            for (Input* input : readers)
                input->name = copy.name;  // its readers are separated next
            passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(i) + 1, std::move(copy));
        }
    }

    std::vector<Input*> readers_of(const std::string& name) {
        std::vector<Input*> readers;
        for (Pass& pass : m_effect.look.passes)
            for (Input& input : pass.inputs)
                if (input.from == Input::From::pass && input.name == name)
                    readers.push_back(&input);
        return readers;
    }

    void list_missing_values() {
        if (!m_host.has_mouse && uses(m_look, {BuiltIn::mouse, BuiltIn::press}))
            m_effect.losses.emplace_back("The mouse. Its position is always 0.");
        if (!m_host.has_date && uses(m_look, {BuiltIn::date, BuiltIn::date_from_0}))
            m_effect.losses.emplace_back("The date. It is always 0.");
    }

    // Bindings have the indices of the reduced look's passes.
    void move_bindings() {
        for (Parameter& parameter : m_effect.look.parameters) {
            const bool stays = parameter.is_constant && m_host.keeps_constants;
            if (std::string loss = loss_of(m_look, parameter); !loss.empty() && !stays) {
                m_effect.fixed.push_back(parameter.name);
                m_effect.losses.push_back(std::move(loss));
            }
            std::vector<Binding> bindings;
            for (const Binding& binding : parameter.bindings) {
                const std::string& name =
                    m_look.passes[static_cast<std::size_t>(binding.pass)].name;
                if (const auto there = find_pass(m_effect.look, m_names[name]))
                    bindings.push_back({*there, binding.uniform});
            }
            parameter.bindings = std::move(bindings);
        }
    }

    const Look& m_look;
    const EffectHost& m_host;
    Extent m_size;
    Plan m_plan;
    Plan m_larger;  // for a viewport of twice the size
    Effect m_effect;
    EffectNames m_given;
    std::string m_source;
    std::map<std::string, std::string> m_names;  // of passes
    std::map<std::string, std::string> m_image_names;
    std::vector<std::size_t> m_kept;
};
}  // namespace

Result<Effect> effect_of(const Look& look, const Values& values, Extent size, Extent source,
                         const EffectHost& host) {
    if (std::string obstacle = effect_obstacle(look, host); !obstacle.empty())
        return fail({{}, 0, std::move(obstacle)});
    auto plan = plan_targets(look, size, source, values);
    if (!plan)
        return fail(plan.error());
    auto larger = plan_targets(look, {2 * size.width, 2 * size.height}, source, values);
    if (!larger)
        return fail(larger.error());
    Look complete = look;
    add_chosen_pictures(complete, values);
    remove_missing_pictures(complete);
    return EffectMaker(complete, host, size, std::move(*plan), std::move(*larger)).make();
}
