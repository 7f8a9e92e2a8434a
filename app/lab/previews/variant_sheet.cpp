#include "lab/previews/variant_sheet.h"

#include "lab/document/parameter_edits.h"
#include "lab/offline/thumbnail.h"
#include "model/tuning/slider_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
std::string stops_text(const Parameter& parameter, int count) {
    std::vector<double> stops;
    if (parameter.control == Control::list) {
        for (const Item& item : parameter.items)
            stops.push_back(item.value);
    } else if (parameter.type.scalar == Scalar::boolean) {
        stops = {0.0, 1.0};
    } else {
        Range range = parameter.range;
        range.step = step_of(parameter);
        const auto steps = steps_in(range, parameter.range.low);
        for (int i = 0; i < count; ++i) {
            const double ratio = static_cast<double>(i) / std::max(count - 1, 1);
            const double value = value_at(range, parameter.scale, ratio);
            const double stop =
                steps ? steps->nearest(value) : readable(range, parameter.scale, value);
            if (stops.empty() || stops.back() != stop)
                stops.push_back(stop);
        }
    }
    std::string text;
    for (const double stop : stops)
        text += fmt::format("{}{}", text.empty() ? "" : ",", stop);
    return text;
}

// The state that all cells share. When it changes, a new sheet is needed.
DocumentState without_axes(const Document& document, const SheetRequest& request) {
    DocumentState state = document.state();
    state.values = document.values();
    state.values.erase(request.across);
    state.values.erase(request.down);
    state.origin = 0;
    return state;
}

double texels_of(Extent extent) {
    return std::max(1.0, static_cast<double>(extent.width) * extent.height);
}

PreviewSubject in_small(const PreviewSubject& subject) {
    return {subject.document, subject.player, subject.media,
            subject.shown,    subject.images, size_for_small_picture(subject.picture)};
}

Values values_with(const Document& document, const SweepCell& cell) {
    Values values = document.values();
    for (const auto& [name, value] : cell.values)
        values[name] = value;
    return values;
}
}  // namespace

Result<SweepAxis> axis_along(const Look& look, const Parameter& parameter, int count) {
    return parse_sweep_axis(parameter.name + "=" + stops_text(parameter, count), look);
}

void VariantSheet::stop() {
    m_request = {};
    m_cells.clear();
    m_next = 0;
    m_trial.reset();
    m_drawn_for.reset();
    m_problem.clear();
}

void VariantSheet::cancel() {
    m_trial.reset();
    m_cells.erase(m_cells.begin() + static_cast<std::ptrdiff_t>(m_next), m_cells.end());
    if (m_cells.empty())
        stop();
}

void VariantSheet::lay_out(const PreviewSubject& subject) {
    const Document& document = subject.document;
    m_trial.reset();
    m_cells.clear();
    m_next = 0;
    m_problem.clear();
    m_drawn_for = without_axes(document, m_request);
    m_settings = document.parameter_settings();
    std::vector<SweepAxis> axes;
    const auto add = [&](const std::string& name, int count) {
        const Parameter* parameter = find_parameter(document.look(), name);
        if (!parameter) {
            m_problem = fmt::format("This look has no parameter \"{}\"", name);
            return;
        }
        if (parameter->is_constant) {
            m_problem = preview_error(*parameter);
            return;
        }
        auto axis = axis_along(
            document.look(), with_ends(*parameter, setting_of(name, document.parameter_settings())),
            count);
        if (axis)
            axes.push_back(std::move(*axis));
        else
            m_problem = fmt::format("{}: {}", parameter->label, axis.error().front().message);
    };
    add(m_request.across, m_request.columns);
    if (!m_request.down.empty())
        add(m_request.down, m_request.rows);
    if (!m_problem.empty())
        return;
    m_columns = static_cast<int>(axes.front().stops.size());
    for (SweepCell& cell : sweep_cells(axes))
        m_cells.push_back({std::move(cell), std::nullopt});
}

Result<void> VariantSheet::start_cell(const PreviewSubject& subject) {
    const Values values = values_with(subject.document, m_cells[m_next].values);
    if (m_trial)
        return m_trial->start_again(values);
    constexpr double sample_budget_seconds = 0.3;  // per cell
    const double share = texels_of(subject.picture) / texels_of(m_shown_as);
    const std::size_t frames =
        affordable_frames(subject.document.look(), subject.shown, sample_budget_seconds, share);
    auto trial = PreviewRenderer::make(subject, values, nullptr, frames);
    if (!trial)
        return fail(trial.error());
    m_trial.emplace(std::move(*trial));
    return {};
}

Result<void> VariantSheet::keep_picture() {
    constexpr int height = 180;
    if (!m_viewer) {
        auto viewer = Viewer::make();
        if (!viewer)
            return fail(viewer.error());
        m_viewer.emplace(std::move(*viewer));
    }
    auto canvas = thumbnail(*m_viewer, m_trial->executor(), height);
    if (!canvas)
        return fail(canvas.error());
    m_cells[m_next].picture.emplace(std::move(*canvas));
    return {};
}

void VariantSheet::update(const PreviewSubject& whole, double slice_seconds) {
    const Document& document = whole.document;
    if (m_request.across.empty() || whole.player.transport().past().empty() ||
        document.history().is_in_gesture())
        return;
    if (m_drawn_for != without_axes(document, m_request) ||
        m_settings != document.parameter_settings())
        lay_out(whole);
    if (!is_running())
        return;
    const PreviewSubject subject = in_small(whole);
    m_shown_as = whole.picture;
    const bool is_drawing = m_trial && m_trial->is_running();
    Result<void> done = is_drawing ? Result<void>() : start_cell(subject);
    if (done && m_trial->update(subject, slice_seconds)) {
        done = keep_picture();
        ++m_next;
    }
    if (!done)
        m_problem = done.error().front().message;
    if (!is_running())
        m_trial.reset();
}

std::optional<std::size_t> VariantSheet::current(const Document& document) const {
    const auto is_present = [&](const Cell& cell) {
        return std::ranges::all_of(cell.values.values, [&](const auto& named) {
            const Parameter* parameter = find_parameter(document.look(), named.first);
            return parameter && document.value(*parameter) == named.second;
        });
    };
    const auto found = std::ranges::find_if(m_cells, is_present);
    return found == m_cells.end() ? std::nullopt
                                  : std::optional<std::size_t>(found - m_cells.begin());
}

void VariantSheet::apply(std::size_t number, Document& document) const {
    if (number >= cells().size())
        return;
    const SweepCell& cell = cells()[number].values;
    set_values(document, {cell.values.begin(), cell.values.end()},
               fmt::format("Apply {}", cell.caption));
    document.finish();
}
