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
#include <span>
#include <string_view>
#include <vector>

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

/// Settings of a low plot of a layer. Its quantity is written across the top.
struct LayerPlotLook {
    QString quantity;                   ///< including the unit
    std::optional<double> minimum{0.0}; ///< lower end of its axis
    std::optional<double> maximum{};
    bool legend = false;
};

/// Plots force and speed of every tool over the whole recording, one above the other, with critical errors as
/// crosses and the plots of the exercise's layer in between. All plots share one cursor and zoom together; a
/// click seeks. Pauses are hatched, the limit is a line, and a second session is a dash-dotted line.
/// Thread: GUI.
class PlaybackPlots : public QWidget {
    Q_OBJECT
public:
    /// `track` and `layer` outlive it. Without a layer, nothing specific to an exercise is drawn. `books`:
    /// also plot the energy balance, from which an expert sees whether the simulation generated energy.
    PlaybackPlots(const Theme& theme, const QLocale& locale, const session::PlaybackTrack& track,
                  const catalogue::ExerciseLevel& level, const PlaybackLayer* layer = nullptr,
                  bool books = true, QWidget* parent = nullptr);

    /// Redraws everything with or without the lines of the second session; `name` appears in the legend.
    void setGhost(const std::optional<session::GhostSeries>& ghost, const QString& name);
    void showCursor(double t_s);
    /// Changes the visible time span by `factor`, keeping the cursor's position on the screen. The span is at
    /// most the whole recording and at least half a second.
    void zoom(double factor);
    void zoomWhole();
    double from_s() const noexcept { return m_from_s; } ///< start and end of the visible span
    double to_s() const noexcept { return m_to_s; }
    const report::PlotView& force() const { return *m_force; }
    const report::PlotView& speed() const { return *m_speed; }

    // Accessors for the layers, for use in addPlots().
    const session::PlaybackTrack& track() const { return m_track; }
    const report::SampleSeries& series() const { return m_series; }
    const Theme& theme() const { return m_theme; }
    const QLocale& plotLocale() const { return m_locale; }
    bool books() const { return m_books; }
    /// A plot without lines; screen readers read `title`.
    std::unique_ptr<report::PlotView> empty(const QString& title) const;
    /// Adds a plot below the others.
    void add(std::unique_ptr<report::PlotView> view, const char* name, const LayerPlotLook& look);
    /// Adds the line of the second session, if there is one and it has the derived series with this id.
    void addSecond(report::PlotView& view, std::string_view derived, double factor) const;

signals:
    void seekAsked(double t_s);

private:
    QWidget* zoomRow();
    void showButtons();
    void showWindow(double from_s, double to_s);
    std::vector<report::PlotView*> views() const; ///< all plots
    double end_s() const;
    report::PlotView* laidOut(std::unique_ptr<report::PlotView> view, const char* name, int height_px);
    void put(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name,
             int height_px);
    /// Places a low plot, with its quantity across the top, because the word does not fit beside the axis in
    /// any language.
    void putLow(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name,
                const QString& quantity, bool last);
    void slim(report::PlotView& view, const QString& time);
    /// Adds the line of the second session, if there is one and it has these values.
    void addSecondLine(report::PlotView& view, std::span<const double> values, double factor) const;

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
    /// Force rendered to each of several tools; null if there is only one tool or no force was felt.
    report::PlotView* m_felt = nullptr;
    report::PlotView* m_speed = nullptr;
    std::vector<report::PlotView*> m_ofLayer;      ///< in drawing order
    const session::GhostSeries* m_ghost = nullptr; ///< set only while the plots are being drawn
    QString m_ghostName;
};

} // namespace chiron::desktop
