#include "model/plan/pass_switches.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
void toggle(std::set<std::string>& names, const std::string& name) {
    if (names.erase(name) == 0)
        names.insert(name);
}

void toggle(std::string& chosen, const std::string& name) {
    chosen = chosen == name ? std::string() : name;
}
}  // namespace

bool PassSwitches::has(PassSwitch which, const std::string& pass) const {
    switch (which) {
        case PassSwitch::bypass:
            return bypassed.contains(pass);
        case PassSwitch::freeze:
            return frozen.contains(pass);
        case PassSwitch::solo:
            return solo == pass;
        case PassSwitch::stop:
            return last == pass;
    }
    return false;
}

const Input* passed_input(const Pass& pass) {
    const auto reads_other = [&pass](const Input& input) {
        return input.from == Input::From::source ||
               (input.from == Input::From::pass && input.name != pass.name);
    };
    const auto other = std::ranges::find_if(pass.inputs, reads_other);
    const auto found = other != pass.inputs.end()
                           ? other
                           : std::ranges::find(pass.inputs, Input::From::image, &Input::from);
    return found == pass.inputs.end() ? nullptr : &*found;
}

Result<PassSwitches> switched(const Look& look, PassSwitches switches, PassSwitch which,
                              const std::string& pass) {
    const auto found = find_pass(look, pass);
    if (!found)
        return fail({{}, 0, fmt::format("there is no pass '{}'", pass)});
    const Pass& chosen = look.passes[static_cast<std::size_t>(*found)];
    switch (which) {
        case PassSwitch::bypass:
            if (!passed_input(chosen))
                return fail(
                    {{},
                     0,
                     chosen.inputs.empty()
                         ? fmt::format("'{}' can't be bypassed: it has no inputs", pass)
                         : fmt::format("'{}' can't be bypassed: it reads only its own output",
                                       pass)});
            toggle(switches.bypassed, pass);
            break;
        case PassSwitch::freeze:
            toggle(switches.frozen, pass);
            break;
        case PassSwitch::solo:
            toggle(switches.solo, pass);
            switches.last.clear();
            break;
        case PassSwitch::stop:
            toggle(switches.last, pass);
            switches.solo.clear();
            break;
    }
    return switches;
}

PassSwitches known_switches(const Look& look, PassSwitches switches) {
    const auto is_unknown = [&look](const std::string& name) { return !find_pass(look, name); };
    std::erase_if(switches.bypassed, [&](const std::string& name) {
        const auto pass = find_pass(look, name);
        return !pass || !passed_input(look.passes[static_cast<std::size_t>(*pass)]);
    });
    std::erase_if(switches.frozen, is_unknown);
    for (std::string* name : {&switches.solo, &switches.last})
        if (is_unknown(*name))
            name->clear();
    return switches;
}

std::size_t picture_pass(const Look& look, const PassSwitches& switches) {
    for (const std::string& name : {switches.solo, switches.last})
        if (const auto pass = find_pass(look, name))
            return static_cast<std::size_t>(*pass);
    return look.passes.size() - 1;
}

std::vector<PassRun> runs_of(const Look& look, const PassSwitches& switches) {
    if (switches.bypassed.empty() && switches.frozen.empty() && switches.last.empty())
        return {};
    std::vector<PassRun> runs(look.passes.size(), PassRun::drawn);
    const auto last = find_pass(look, switches.last);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Pass& pass = look.passes[i];
        if (switches.frozen.contains(pass.name))
            runs[i] = PassRun::frozen;
        else if (last && i > static_cast<std::size_t>(*last))
            runs[i] = PassRun::left_out;
        else if (switches.bypassed.contains(pass.name) && passed_input(pass))
            runs[i] = PassRun::bypassed;
    }
    return runs;
}
