// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/playback/playback_layer.h"
#include "desktop/theme/theme.h"
#include "report/plot_view.h"
#include "session/playback_ghost.h"
#include "session/playback_track.h"

#include <QLocale>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

/// A low plot of a layer: its quantity stands across the top.
struct LayerPlotLook {
    QString quantity;                   ///< with its unit
    std::optional<double> minimum{0.0}; ///< of its axis
    std::optional<double> maximum{};
    bool legend = false;
};

/// Force and speed of every tool over the whole recording with critical errors as crosses, and between them what the exercise's layer adds,
/// one above the other, under one cursor; a click seeks, and all of them zoom together. Pauses are hatched, the limit is a line, a second
/// session is a dash-dotted line. GUI thread.
class PlaybackPlots : public QWidget {
    Q_OBJECT
public:
    /// `track` and `layer` outlive it; without a layer nothing of one exercise is drawn. `books`: with those of energy, which tell an expert
    /// whether the simulation made any.
    PlaybackPlots(const Theme& theme, const QLocale& locale, const session::PlaybackTrack& track, const catalogue::ExerciseLevel& level,
                  const PlaybackLayer* layer = nullptr, bool books = true, QWidget* parent = nullptr);

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

    // What layers draw with, in addPlots().
    const session::PlaybackTrack& track() const { return m_track; }
    const report::SampleSeries& series() const { return m_series; }
    const Theme& theme() const { return m_theme; }
    const QLocale& plotLocale() const { return m_locale; }
    bool books() const { return m_books; }
    /// A plot without lines, which is read out as `title`.
    std::unique_ptr<report::PlotView> empty(const QString& title) const;
    /// Puts a plot below the others.
    void add(std::unique_ptr<report::PlotView> view, const char* name, const LayerPlotLook& look);
    /// Adds the line of the second session, where there is one and it has these values.
    void addSecond(report::PlotView& view, const std::vector<double> session::GhostSeries::*values, double factor) const;

signals:
    void seekAsked(double t_s);

private:
    QWidget* zoomRow();
    void showButtons();
    void showWindow(double from_s, double to_s);
    std::vector<report::PlotView*> views() const; ///< all that there are
    double end_s() const;
    report::PlotView* laidOut(std::unique_ptr<report::PlotView> view, const char* name, int height_px);
    void put(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name, int height_px);
    /// A low plot: its quantity across the top, because no language's word for it fits up its side.
    void putLow(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name, const QString& quantity, bool last);
    void slim(report::PlotView& view, const QString& time);

    const Theme& m_theme;
    QLocale m_locale;
    const session::PlaybackTrack& m_track;
    const PlaybackLayer* m_layer;
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
    std::vector<report::PlotView*> m_ofLayer; ///< in the order of drawing
    const session::GhostSeries* m_ghost = nullptr; ///< while all are drawn
    QString m_ghostName;
};

} // namespace chiron::desktop
