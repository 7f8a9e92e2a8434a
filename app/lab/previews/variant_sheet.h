#pragma once

#include "graph/inspect/viewer.h"
#include "lab/offline/sweep.h"
#include "lab/previews/preview_renderer.h"

#include <optional>
#include <string>
#include <vector>

/// The axes of a sheet: a parameter for the columns, and optionally one for the rows.
struct SheetRequest {
    std::string across;  // "": no sheet
    int columns = 7;
    std::string down = {};  // "": a filmstrip of one row
    int rows = 5;

    bool operator==(const SheetRequest&) const = default;
};

/// Small pictures of the look along the range of one parameter, or over the grid of two. Each
/// update draws a slice. Other changes restart it.
class VariantSheet {
public:
    struct Cell {
        SweepCell values;
        std::optional<gpu::Canvas> picture;  // nullopt: not drawn yet
    };

    void begin(const SheetRequest& request) {
        stop();
        m_request = request;
    }
    void stop();
    /// Stops drawing and keeps the finished cells.
    void cancel();
    /// Call it in every update.
    void update(const PreviewSubject& subject, double slice_seconds);

    const SheetRequest& request() const { return m_request; }
    /// The first axis varies fastest.
    const std::vector<Cell>& cells() const { return m_cells; }
    int columns() const { return m_columns; }
    /// The error; "": no error.
    const std::string& problem() const { return m_problem; }
    bool is_running() const { return !m_request.across.empty() && m_problem.empty() && !is_done(); }
    std::size_t drawn() const { return m_next; }
    /// The cell with the document's values; nullopt: no such cell.
    std::optional<std::size_t> current(const Document& document) const;
    /// Sets the document to the values of a cell, as one undo step.
    void apply(std::size_t cell, Document& document) const;

private:
    bool is_done() const { return !m_cells.empty() && m_next == m_cells.size(); }
    void lay_out(const PreviewSubject& subject);
    Result<void> start_cell(const PreviewSubject& subject);
    Result<void> keep_picture();

    SheetRequest m_request;
    std::vector<Cell> m_cells;
    int m_columns = 1;
    std::size_t m_next = 0;  // the cell being drawn
    std::optional<PreviewRenderer> m_trial;
    std::optional<Viewer> m_viewer;
    std::optional<DocumentState> m_drawn_for;  // without the parameters of the axes
    ParameterSettings m_settings;
    Extent m_shown_as;  // size of the window's picture
    std::string m_problem;
};

/// Values spread evenly along a slider, at its steps if it has any. For a list or switch, all
/// values. Fails for a parameter that is not a single number.
Result<SweepAxis> axis_along(const Look& look, const Parameter& parameter, int count);
