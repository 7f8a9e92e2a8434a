#include "lab/document/live_content.h"

#include "model/picture/source_spec.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

std::string why_not_repeatable(const Document& document) {
    if (document.look().driven_by == Driver::signal) {
        const std::string& name = document.state().signal.kind;
        const SignalKind* kind = find_kind(name);
        return kind && (kind->is_live || kind->is_sent)
                   ? fmt::format("the signal '{}' is different in every run", name)
                   : std::string();
    }
    const auto source = parse_source(document.state().source);
    return document.look().driven_by == Driver::picture && source && source->is_live()
               ? fmt::format("the source '{}' is different in every run", source->picture)
               : std::string();
}
