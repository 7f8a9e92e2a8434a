#pragma once

#include "lab/golden/golden_drawer.h"
#include "lab/golden/golden_request.h"
#include "lab/golden/golden_result.h"

#include <string>
#include <vector>

/// One comparison or update of the golden pictures of a folder.
class GoldenRun {
public:
    /// `request` must outlive the run.
    GoldenRun(const GoldenRequest& request, GoldenRecord record, GoldenDriver driver,
              GoldenDrawer drawer);

    /// Draws a look or preset, and compares or writes its picture. Fails if it can't be written.
    Result<GoldenResult> result_of(const GoldenItem& item);
    /// Reports a picture without a look or preset, or removes it in an update.
    Result<GoldenResult> orphan(const std::string& name);
    /// Writes golden.json.
    Result<void> save_record();
    const GoldenBounds& bounds() const { return m_bounds; }
    /// A warning if pictures of another driver were compared.
    Diagnostics warnings() const;

private:
    void start_record();
    void compare(const GoldenDrawing& drawing, GoldenResult& result) const;
    Result<void> write(const GoldenDrawing& drawing, GoldenResult& result);
    GoldenResult started(const GoldenItem& item) const;
    const GoldenDriver& driver_of(const std::string& name) const {
        const GoldenPicture& picture = m_record.pictures.at(name);
        return picture.driver ? *picture.driver : m_record.driver;
    }

    const GoldenRequest& m_request;
    GoldenRecord m_record;
    GoldenDriver m_driver;
    GoldenDrawer m_drawer;
    GoldenBounds m_bounds;
    std::vector<std::string> m_drawn_elsewhere;
};
