#pragma once

#include "graph/inspect/viewer.h"
#include "lab/offline/sweep.h"
#include "lab/trials/trial.h"

#include <optional>
#include <string>
#include <vector>

/// What is to be laid out: one slider along a row, and perhaps another one down.
struct SheetRequest {
    std::string across;  // "": nothing
    int columns = 7;
    std::string down = {};  // "": one row, a filmstrip
    int rows = 5;

    bool operator==(const SheetRequest&) const = default;
};

/// Small pictures of the look along the range of one slider, or over the grid of two, drawn beside
/// the picture a slice a turn; anew when something else is turned.
class VariantSheet {
public:
    struct Cell {
        SweepCell values;
        std::optional<gpu::Canvas> picture;  // none: yet to be drawn
    };

    void begin(const SheetRequest& request) {
        stop();
        m_request = request;
    }
    void stop();
    /// What is drawn stays.
    void cancel();
    /// To be called every turn.
    void update(const TrialSubject& subject, double slice_seconds);

    const SheetRequest& request() const { return m_request; }
    /// The first axis runs fastest.
    const std::vector<Cell>& cells() const { return m_cells; }
    int columns() const { return m_columns; }
    /// Why there is no sheet; "" when there is.
    const std::string& problem() const { return m_problem; }
    bool is_running() const { return !m_request.across.empty() && m_problem.empty() && !is_done(); }
    std::size_t drawn() const { return m_next; }
    /// The cell that has the document's values; none when none has.
    std::optional<std::size_t> present(const Document& document) const;

private:
    bool is_done() const { return !m_cells.empty() && m_next == m_cells.size(); }
    void lay_out(const TrialSubject& subject);
    Result<void> start_cell(const TrialSubject& subject);
    Result<void> keep_picture();

    SheetRequest m_request;
    std::vector<Cell> m_cells;
    int m_columns = 1;
    std::size_t m_next = 0;  // cell that is being drawn
    std::optional<Trial> m_trial;
    std::optional<Viewer> m_viewer;
    std::optional<DocumentState> m_drawn_for;  // without what the axes turn
    KnobSettings m_knobs;
    Extent m_shown_as;  // the window's picture
    std::string m_problem;
};

/// The values along a slider, spread evenly over its length, at its steps where it has some; of a
/// list or switch all there are. Fails for what is not a single number.
Result<SweepAxis> axis_along(const Look& look, const Parameter& parameter, int count);
