#include "lab/window/parameter_list.h"

#include "base/text.h"
#include "lab/document/parameter_edits.h"
#include "model/plan/parameter_use.h"
#include "model/tuning/slider_range.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
/// Filters parameters by a query that is prepared once.
class Listing {
public:
    Listing(const Document& document, const ParameterQuery& query)
        : m_document(document),
          m_filter(query.filter),
          m_pass(find_pass(document.look(), query.pass)) {
        const std::string lower = to_lower(query.search);
        for (const std::string_view word : split(lower, ' '))
            if (!word.empty())
                m_words.emplace_back(word);
    }

    bool wants(const Parameter& parameter) const {
        return !parameter.is_hidden && passes_filter(parameter) && is_sought(parameter);
    }

private:
    bool passes_filter(const Parameter& parameter) const {
        switch (m_filter) {
            case ParameterFilter::all:
                return true;
            case ParameterFilter::changed:
                return is_changed(m_document, parameter);
            case ParameterFilter::favourites:
                return setting_of(parameter.name, m_document.parameter_settings()).is_favourite;
            case ParameterFilter::of_pass:
                return m_pass &&
                       is_used_by(m_document.look(), static_cast<std::size_t>(*m_pass), parameter);
        }
        return true;
    }

    bool is_sought(const Parameter& parameter) const {
        if (m_words.empty())
            return true;
        const std::string text = to_lower(parameter.name + ' ' + parameter.label + ' ' +
                                          heading_of(m_document.look(), parameter) + ' ' +
                                          parameter.unit + ' ' + parameter.help);
        return std::ranges::all_of(
            m_words, [&](const std::string& word) { return text.find(word) != std::string::npos; });
    }

    const Document& m_document;
    ParameterFilter m_filter;
    std::optional<int> m_pass;
    std::vector<std::string> m_words;
};
}  // namespace

std::vector<ParameterGroup> listed_parameters(const Document& document,
                                              const ParameterQuery& query) {
    const Listing listing(document, query);
    std::vector<ParameterGroup> groups;
    for (const Parameter& parameter : document.look().parameters) {
        if (!listing.wants(parameter))
            continue;
        std::string name = heading_of(document.look(), parameter);
        // Parameters of a group are mostly adjacent, so the search starts at the end.
        const auto found = std::find_if(groups.rbegin(), groups.rend(),
                                        [&](const auto& group) { return group.name == name; });
        ParameterGroup& group = found == groups.rend()
                                    ? groups.emplace_back(ParameterGroup{std::move(name), {}})
                                    : *found;
        group.parameters.push_back(&parameter);
    }
    return groups;
}

ParameterQuery query_of(const WindowState& window) {
    return {window.parameters.search, window.parameters.filter, window.views.inspected.pass};
}

std::optional<Pointed> listed_neighbour(const std::vector<ParameterGroup>& groups,
                                        const Pointed& current, int by) {
    std::vector<Pointed> lines;
    for (const ParameterGroup& group : groups)
        for (const Parameter* parameter : group.parameters) {
            const int parts = has_parts(*parameter) ? parameter->type.rows : 1;
            for (int i = 0; i < parts; ++i)
                lines.push_back({parameter->name, static_cast<std::size_t>(i)});
        }
    if (lines.empty())
        return std::nullopt;
    const auto last = static_cast<std::ptrdiff_t>(lines.size()) - 1;
    const auto found = std::ranges::find(lines, current);
    if (found == lines.end())
        return by > 0 ? lines.front() : lines.back();
    const std::ptrdiff_t line = std::clamp<std::ptrdiff_t>(found - lines.begin() + by, 0, last);
    return lines[static_cast<std::size_t>(line)];
}

std::string empty_list_text(const ParameterQuery& query) {
    if (!query.search.empty())
        return query.filter == ParameterFilter::all ? "No matches."
                                                    : "No matches among the filtered parameters.";
    switch (query.filter) {
        case ParameterFilter::all:
            break;
        case ParameterFilter::changed:
            return "No parameters are changed.";
        case ParameterFilter::favourites:
            return "No favourites yet. Hover over a label and click its star.";
        case ParameterFilter::of_pass:
            return query.pass.empty()
                       ? "No pass is selected. Click one in the pass strip."
                       : fmt::format("The pass \"{}\" uses no parameters.", query.pass);
    }
    return "This look has no parameters.";
}
