// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/playback/grasp_replay.h"
#include "desktop/theme/theme.h"
#include "report/plot_view.h"
#include "session/playback_ghost.h"
#include "session/playback_track.h"

#include <QLocale>
#include <QWidget>
#include <array>
#include <optional>

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

/// Force and speed of every tool over the whole recording with critical errors as crosses, off-centre and alignment where there is a canal, tension with its band or squeeze with
/// its limit and the books of energy where something is grasped, lean and depth where something is palpated, one above the other, under one
/// cursor; a click seeks, and all of them zoom together. Pauses are hatched, the limit is a line, a second session is a dash-dotted line. GUI thread.
class PlaybackPlots : public QWidget {
    Q_OBJECT
public:
    /// `track` and `grasp` outlive it. `books`: with those of energy, which tell an expert whether the simulation made any.
    PlaybackPlots(const Theme& theme, const QLocale& locale, const session::PlaybackTrack& track, const catalogue::ExerciseParameters& level,
                  const GraspReplay* grasp = nullptr, bool books = true, QWidget* parent = nullptr);

    /// Draws all again, with the second session's lines or without; `name` is in the legend.
    void setGhost(const std::optional<session::GhostSeries>& ghost, const QString& name);
    void showCursor(double t_s);
    /// Shows `factor` times as much time as now, with the cursor where it was; never more than all, nor less than half a second.
    void zoom(double factor);
    void zoomWhole();
    double from_s() const noexcept { return m_from_s; } ///< ends of what is shown
    double to_s() const noexcept { return m_to_s; }
    const report::PlotView& force() const { return *m_force; }
    const report::PlotView& speed() const { return *m_speed; }

signals:
    void seekAsked(double t_s);

private:
    QWidget* zoomRow();
    void showButtons();
    void showWindow(double from_s, double to_s);
    std::array<report::PlotView*, 10> views() const { return {m_force, m_felt, m_offset, m_alignment, m_held, m_retraction, m_energy, m_lean, m_depth, m_speed}; }
    double end_s() const;
    void put(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name, int height_px);
    /// A low plot: its quantity across the top, because no language's word for it fits up its side.
    void putLow(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name, const QString& quantity, bool last);
    void slim(report::PlotView& view, const QString& time);
    void putGrasp();
    void putRetraction();
    void putEnergy();
    void putPalpation();
    /// A line a finger of its recorded quantity "<before><finger><after>"; false where none was recorded.
    bool addFingers(report::PlotView& view, const char* before, const char* after, double factor) const;
    std::unique_ptr<report::PlotView> empty(const QString& title) const;

    const Theme& m_theme;
    QLocale m_locale;
    const session::PlaybackTrack& m_track;
    const GraspReplay* m_grasp;
    report::SampleSeries m_series;
    double m_limit_N;
    QPushButton* m_zoomIn = nullptr;
    QPushButton* m_zoomOut = nullptr;
    QPushButton* m_zoomWhole = nullptr;
    bool m_books;
    double m_cursor_s = 0.0;
    double m_from_s = 0.0;
    double m_to_s = 0.0;
    QVBoxLayout* m_column;
    report::PlotView* m_force = nullptr;
    report::PlotView* m_felt = nullptr;     ///< what each of several tools was given; null where there is one alone, or nothing was felt
    report::PlotView* m_speed = nullptr;
    report::PlotView* m_offset = nullptr;    ///< null without a canal
    report::PlotView* m_alignment = nullptr; ///< the same
    report::PlotView* m_held = nullptr;      ///< tension or squeeze; null where nothing is grasped
    report::PlotView* m_retraction = nullptr; ///< null where no fold is held back
    report::PlotView* m_energy = nullptr;    ///< the same
    report::PlotView* m_lean = nullptr;      ///< null where nothing is palpated
    report::PlotView* m_depth = nullptr;     ///< the same
};

} // namespace chiron::desktop
