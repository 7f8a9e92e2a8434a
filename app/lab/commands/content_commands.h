#pragma once

#include "lab/drawing/drawing_tool.h"
#include "lab/frame/comparison_view.h"
#include "lab/frame/workspace.h"
#include "lab/media/preset_content.h"

#include <filesystem>
#include <string>

/// Files and devices that drive the open look: sounds, drawings, scenes, pictures, videos.
class ContentCommands {
public:
    ContentCommands(Workspace& work, DrawingTool& drawing, ComparisonView& comparison)
        : m_work(work), m_drawing(drawing), m_comparison(comparison) {}

    /// Whether a file is content instead of a look or preset.
    static bool is_content(const std::filesystem::path& file);
    /// The look to open before this content can be used; "": the open look uses it.
    std::string look_for(const std::filesystem::path& file) const;
    /// Makes a file the signal, source, drawing or reference. It is read in the background. On
    /// failure nothing changes.
    void open(const std::filesystem::path& file);
    /// Makes a live source, as parse_source() reads it, the source. Reports why it can't.
    void show_live(const std::string& text);
    /// The same for the picture of an image parameter.
    void choose_picture(const std::string& parameter, const std::filesystem::path& file);
    /// Stops reading; the previous content stays.
    void cancel_loading();
    /// Applies content that has been read. Do not call it while a frame is unfinished.
    void update();

    /// Handles the content of a preset. While the user's own content is locked, a notice offers the
    /// preset's. Content outside the preset's folder needs confirmation.
    void offer(const CheckedPreset& checked);
    /// Content and locks for the first look.
    const Content& initial() const { return m_initial; }
    void set_initial(Content content) { m_initial = std::move(content); }

private:
    void take_content();
    void take_pictures();
    void offer_outside(const OutsideContent& content);
    void offer_own(const Preset& preset);

    Workspace& m_work;
    DrawingTool& m_drawing;
    ComparisonView& m_comparison;
    Content m_initial;
};
