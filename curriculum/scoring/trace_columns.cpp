// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_columns.h"

#include <array>

namespace chiron::scoring {

namespace {

constexpr double kLongest_s = 1e7; // 115 days
constexpr double kFurthest_mm = 1e6;
constexpr double kStrongest_N = 1e6;
constexpr std::string_view kTimeText = "seconds, -1e7 to 1e7";
constexpr std::string_view kLengthText = "millimetres, -1e6 to 1e6";
constexpr std::string_view kForceText = "newtons, -1e6 to 1e6";
constexpr double kStrongest_mNm = 1e6;
constexpr std::string_view kTorqueText = "millinewton metres, -1e6 to 1e6";
constexpr std::array<std::string_view, 5> kPhaseNames{"idle", "ready", "running", "between", "finished"};

#define CHIRON_ACCESS(expression)                                                                            \
    [](const TraceRow& row) -> double { return static_cast<double>(row.expression); },                       \
        [](TraceRow& row, double value) { row.expression = static_cast<decltype(row.expression)>(value); }
#define CHIRON_VECTOR_ACCESS(member, axis)                                                                   \
    [](const TraceRow& row) -> double { return row.member.axis(); },                                         \
        [](TraceRow& row, double value) { row.member.axis() = value; }
#define CHIRON_LENGTH(name, group, member, axis)                                                             \
    TraceColumn {                                                                                            \
        name, ColumnKind::length, group, -kFurthest_mm, kFurthest_mm, kLengthText,                           \
            CHIRON_VECTOR_ACCESS(member, axis)                                                               \
    }
#define CHIRON_FORCE(name, group, member, axis)                                                              \
    TraceColumn {                                                                                            \
        name, ColumnKind::force, group, -kStrongest_N, kStrongest_N, kForceText,                             \
            CHIRON_VECTOR_ACCESS(member, axis)                                                               \
    }
#define CHIRON_QUATERNION(name, axis)                                                                        \
    TraceColumn {                                                                                            \
        name, ColumnKind::number, &TraceColumns::orientation, -1.01, 1.01,                                   \
            "part of a unit quaternion, -1.01 to 1.01", CHIRON_VECTOR_ACCESS(q_WT, axis)                     \
    }
#define CHIRON_FLAG(name, group, member)                                                                     \
    TraceColumn {                                                                                            \
        name, ColumnKind::integer, group, 0.0, 1.0, "0 or 1", CHIRON_ACCESS(member)                          \
    }

#define CHIRON_TORQUE(name, axis)                                                                            \
    TraceColumn {                                                                                            \
        name, ColumnKind::torque, &TraceColumns::torque, -kStrongest_mNm, kStrongest_mNm, kTorqueText,       \
            CHIRON_VECTOR_ACCESS(tissueTorque_Nm, axis)                                                      \
    }
constexpr double kMostBits = 4294967295.0;

/// The columns that every exercise can have.
const auto kShared = std::to_array<TraceColumn>({
    {"t_s", ColumnKind::time, nullptr, -kLongest_s, kLongest_s, kTimeText, CHIRON_ACCESS(t_s)},
    CHIRON_LENGTH("x_mm", nullptr, p_WT_m, x),
    CHIRON_LENGTH("y_mm", nullptr, p_WT_m, y),
    CHIRON_LENGTH("z_mm", nullptr, p_WT_m, z),
    CHIRON_QUATERNION("qw", w),
    CHIRON_QUATERNION("qx", x),
    CHIRON_QUATERNION("qy", y),
    CHIRON_QUATERNION("qz", z),
    {"jaw_deg", ColumnKind::angle, &TraceColumns::jaw, -360.0, 360.0, "degrees, -360 to 360",
     CHIRON_ACCESS(jaw_rad)},
    {"buttons", ColumnKind::integer, &TraceColumns::buttons, 0.0, kMostBits,
     "a whole number, 0 to 4294967295", CHIRON_ACCESS(buttons)},
    {"tool", ColumnKind::integer, &TraceColumns::tool, 0.0, 3.0, "a whole number, 0 to 3",
     CHIRON_ACCESS(tool)},
    CHIRON_FORCE("fx_N", &TraceColumns::tissue, tissue_N, x),
    CHIRON_FORCE("fy_N", &TraceColumns::tissue, tissue_N, y),
    CHIRON_FORCE("fz_N", &TraceColumns::tissue, tissue_N, z),
    CHIRON_FORCE("commanded_fx_N", &TraceColumns::commanded, commanded_N, x),
    CHIRON_FORCE("commanded_fy_N", &TraceColumns::commanded, commanded_N, y),
    CHIRON_FORCE("commanded_fz_N", &TraceColumns::commanded, commanded_N, z),
    CHIRON_FORCE("measured_fx_N", &TraceColumns::measured, measured_N, x),
    CHIRON_FORCE("measured_fy_N", &TraceColumns::measured, measured_N, y),
    CHIRON_FORCE("measured_fz_N", &TraceColumns::measured, measured_N, z),
    {"trial", ColumnKind::integer, &TraceColumns::trial, 1.0, 65536.0, "a whole number, 1 to 65536",
     [](const TraceRow& row) -> double { return row.trial + 1.0; },
     [](TraceRow& row, double value) { row.trial = static_cast<std::int32_t>(value) - 1; }},
    {"phase", ColumnKind::word, &TraceColumns::phase, 0.0, 4.0, "idle, ready, running, between or finished",
     CHIRON_ACCESS(phase), kPhaseNames},
    CHIRON_FLAG("paused", &TraceColumns::paused, paused),
    CHIRON_FLAG("marked", &TraceColumns::mark, marked),
    CHIRON_FLAG("timed_out", &TraceColumns::mark, timedOut),
    CHIRON_FLAG("mark_in_contact", &TraceColumns::mark, markInContact),
    CHIRON_LENGTH("mark_x_mm", &TraceColumns::mark, p_WMark_m, x),
    CHIRON_LENGTH("mark_y_mm", &TraceColumns::mark, p_WMark_m, y),
    CHIRON_LENGTH("mark_z_mm", &TraceColumns::mark, p_WMark_m, z),
    CHIRON_LENGTH("target_x_mm", &TraceColumns::target, target_m, x),
    CHIRON_LENGTH("target_y_mm", &TraceColumns::target, target_m, y),
    {"target_radius_mm", ColumnKind::length, &TraceColumns::target, 1e-6, kFurthest_mm,
     "millimetres, 1e-6 to 1e6", CHIRON_ACCESS(targetRadius_m)},
    {"force_limit_N", ColumnKind::force, &TraceColumns::forceLimit, 0.001, kStrongest_N,
     "newtons, 0.001 to 1e6", CHIRON_ACCESS(forceLimit_N)},
    CHIRON_TORQUE("tx_mNm", x),
    CHIRON_TORQUE("ty_mNm", y),
    CHIRON_TORQUE("tz_mNm", z),
    CHIRON_FLAG("completed", &TraceColumns::completed, completed),
    CHIRON_FLAG("failed", &TraceColumns::failed, failed),
    CHIRON_FLAG("unfinished", &TraceColumns::unfinished, unfinished),
    {"trials_planned", ColumnKind::integer, &TraceColumns::planned, 1.0, 1e6, "a whole number, 1 to 1000000",
     CHIRON_ACCESS(plannedTrials)},
    {"contact", ColumnKind::integer, &TraceColumns::contact, 0.0, 7.0,
     "a whole number, 0 to 7: 1 beyond the checked range, 2 the tissue gave way, 4 through it",
     CHIRON_ACCESS(contact)},
});

/// Appends the columns of exercises that follow this shared column.
void appendOwn(std::vector<TraceColumn>& all, std::string_view after) {
    for (const OwnColumns* owner : ownColumns())
        for (std::size_t place = 0; place < owner->columns.size(); ++place) {
            const OwnColumn& own = owner->columns[place];
            if (own.after != after)
                continue;
            TraceColumn column{own.name, own.kind, nullptr, own.least, own.most, own.expected};
            column.words = own.words;
            column.owner = owner;
            column.place = place;
            all.push_back(column);
        }
}

std::vector<TraceColumn> withOwnColumns() {
    std::vector<TraceColumn> all;
    for (const TraceColumn& column : kShared) {
        all.push_back(column);
        appendOwn(all, column.name);
    }
    return all;
}

} // namespace

std::span<const TraceColumn> traceColumns() {
    static const std::vector<TraceColumn> all = withOwnColumns();
    return all;
}

int findTraceColumn(std::string_view name) {
    const std::span<const TraceColumn> all = traceColumns();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name == name)
            return static_cast<int>(i);
    return -1;
}

std::string_view namedColumnId(std::string_view name, std::string_view prefix) {
    constexpr std::size_t kLongest = 64;
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    if (!name.starts_with(prefix))
        return {};
    const std::string_view id = name.substr(prefix.size());
    return id.size() > kLongest || id.find_first_not_of(kLetters) != std::string_view::npos
               ? std::string_view{}
               : id;
}

} // namespace chiron::scoring
