// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/map_picture.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::scene3d {

using simulation::MapBand;
using simulation::SurfaceMap;
using simulation::SurfaceMapKind;

namespace {

constexpr int kBands = 6;
constexpr int kHatchEvery = 12; // pixels
constexpr int kDash = 6;

QColor between(const QColor& from, const QColor& to, double share, double opacity) {
    const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
    return {mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue()),
            static_cast<int>(255.0 * opacity)};
}

QRgb plain(const QColor& colour) {
    return qRgba(colour.red(), colour.green(), colour.blue(), colour.alpha());
}

/// The step of every cell, so that neighbours can be compared without querying the map again.
using Steps = std::array<std::array<MapBand, SurfaceMap::kColumns>, SurfaceMap::kRows>;

Steps stepsOf(const SurfaceMap& map, const simulation::MapBands& bands) {
    Steps steps{};
    for (int row = 0; row < SurfaceMap::kRows; ++row)
        for (int column = 0; column < SurfaceMap::kColumns; ++column)
            steps[std::size_t(row)][std::size_t(column)] = bands.of(map.force_N(column, row));
    return steps;
}

/// True if this pixel (x, y from the lower left) lies at the border between the searched and the unsearched
/// area.
bool atBorder(const Steps& steps, int x, int y) {
    const int column = x / kMapPixels;
    const int row = y / kMapPixels;
    const bool own = isSearched(steps[std::size_t(row)][std::size_t(column)]);
    const auto differs = [&](int c, int r) {
        return c >= 0 && c < SurfaceMap::kColumns && r >= 0 && r < SurfaceMap::kRows &&
               isSearched(steps[std::size_t(r)][std::size_t(c)]) != own;
    };
    const int across = x % kMapPixels;
    const int up = y % kMapPixels;
    return own &&
           ((across == 0 && differs(column - 1, row)) ||
            (across == kMapPixels - 1 && differs(column + 1, row)) || (up == 0 && differs(column, row - 1)) ||
            (up == kMapPixels - 1 && differs(column, row + 1)));
}

bool onRegionLine(int at, int size, int regions, int other) {
    if (other / kDash % 2 == 1)
        return false;
    for (int i = 1; i < regions; ++i)
        if (at == size * i / regions)
            return true;
    return false;
}

} // namespace

simulation::MapBands mapBandsOf(const SceneSetup& setup) {
    const auto* palpation = setup.parameters.find<simulation::PalpationParameters>();
    return palpation ? simulation::MapBands{palpation->coverForce_N, palpation->bandLow_N,
                                            palpation->bandHigh_N, palpation->maximumForce_N}
                     : simulation::MapBands{};
}

QColor mapColour(const SceneColours& colours, SurfaceMapKind kind, MapBand band) {
    const double firm = colours.highContrast ? 0.88 : 0.74;
    const QColor& from = colours.background;
    const QColor& to = colours.arrow;
    if (kind == SurfaceMapKind::coverage && isSearched(band))
        return between(from, to, 0.60, colours.highContrast ? 0.72 : 0.52);
    switch (band) {
    case MapBand::untouched:
        return between(from, to, 0.0, 0.0);
    case MapBand::light:
        return between(from, to, 0.12, 0.45);
    case MapBand::gentle:
        return between(from, to, 0.30, firm);
    case MapBand::inBand:
        return between(from, to, 0.62, firm);
    case MapBand::hard:
        return between(from, to, 1.0, firm);
    case MapBand::over:
        return between(colours.over, colours.over, 0.0, firm);
    }
    return {};
}

QColor mapHatch(const SceneColours& colours, bool over) {
    // Colours that are visible on tissue.
    QColor line = over ? colours.background : colours.highContrast ? QColor(Qt::black) : QColor(54, 20, 22);
    line.setAlphaF(over ? 0.95F : 0.62F);
    return line;
}

QImage mapPicture(const SurfaceMap& map, const SceneSetup& setup, SurfaceMapKind kind) {
    constexpr int kWide = SurfaceMap::kColumns * kMapPixels;
    constexpr int kHigh = SurfaceMap::kRows * kMapPixels;
    const Steps steps = stepsOf(map, mapBandsOf(setup));
    std::array<QRgb, kBands> colour{};
    for (int band = 0; band < kBands; ++band)
        colour[std::size_t(band)] = plain(mapColour(setup.colours, kind, static_cast<MapBand>(band)));
    const QRgb hatch = plain(mapHatch(setup.colours, false));
    const QRgb over = plain(mapHatch(setup.colours, true));
    const QRgb edge = setup.colours.highContrast ? qRgba(0, 0, 0, 255) : qRgba(16, 26, 36, 230);
    const QRgb region = setup.colours.highContrast ? qRgba(0, 0, 0, 170) : qRgba(40, 20, 24, 110);
    const auto* palpation = setup.parameters.find<simulation::PalpationParameters>();
    const int columns = palpation ? palpation->regionColumns : 1;
    const int rows = palpation ? palpation->regionRows : 1;
    QImage picture(kWide, kHigh, QImage::Format_ARGB32);
    for (int y = 0; y < kHigh; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(kHigh - 1 - y));
        for (int x = 0; x < kWide; ++x) {
            const MapBand band = steps[std::size_t(y / kMapPixels)][std::size_t(x / kMapPixels)];
            QRgb pixel = colour[std::size_t(band)];
            if (!isSearched(band) && (x - y + kHigh * kHatchEvery) % kHatchEvery < 1)
                pixel = hatch;
            else if (band == MapBand::over && kind == SurfaceMapKind::force &&
                     (x + y) % (kHatchEvery / 2) < 2)
                pixel = over;
            if (onRegionLine(x, kWide, columns, y) || onRegionLine(y, kHigh, rows, x))
                pixel = region;
            line[x] = atBorder(steps, x, y) ? edge : pixel;
        }
    }
    return picture;
}

} // namespace chiron::scene3d
