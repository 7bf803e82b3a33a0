// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/row_digest.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <sodium.h>

namespace chiron::database {
namespace {

class Hasher {
public:
    Hasher() { crypto_generichash_init(&m_state, nullptr, 0, sizeof(RowDigest)); }
    void bytes(const void* data, std::size_t count) {
        crypto_generichash_update(&m_state, static_cast<const unsigned char*>(data), count);
    }
    void tag(std::uint8_t value) { bytes(&value, 1); }
    void number(std::uint64_t value) {
        std::array<std::uint8_t, 8> little{};
        for (std::size_t i = 0; i < little.size(); ++i) {
            little[i] = static_cast<std::uint8_t>(value >> (8 * i));
        }
        bytes(little.data(), little.size());
    }
    void text(std::string_view text) {
        number(text.size());
        bytes(text.data(), text.size());
    }
    RowDigest result() {
        RowDigest digest{};
        crypto_generichash_final(&m_state, digest.data(), digest.size());
        return digest;
    }

private:
    crypto_generichash_state m_state{};
};

void add(Hasher& hasher, const Value& value) {
    hasher.tag(static_cast<std::uint8_t>(value.type()));
    switch (value.type()) {
    case Value::Type::null:
        return;
    case Value::Type::integer:
        return hasher.number(static_cast<std::uint64_t>(value.integer()));
    case Value::Type::real:
        return hasher.number(std::bit_cast<std::uint64_t>(value.real()));
    case Value::Type::text:
    case Value::Type::blob:
        return hasher.text(value.bytes());
    }
}

std::vector<DigestedTable> makeTables() {
    return {
        {"person", {"id"}, {"id", "kind", "name", "name_key", "display_name", "roles", "enabled", "created_utc"}},
        {"person_code", {"person_id"}, {"person_id", "code"}},
        {"credential",
         {"person_id"},
         {"person_id", "password_hash", "recovery_hash", "must_change", "failures", "wait_boot", "wait_until_ns"}},
        {"content", {"id"}, {"id", "sha256", "json"}},
        {"session",
         {"id"},
         {"id", "person_id", "exercise", "level", "content_id", "seed", "operator_name", "felt", "device_json",
          "mapping_json", "supervisor_json", "versions_json", "build_id", "cpu_class", "force_limit_n",
          "planned_trials", "familiarisation", "realtime", "demonstration", "ring_file", "channel_table",
          "started_utc", "utc_offset_min", "state", "ended_utc", "ticks", "frames", "dropped", "chunks",
          "recording_bytes", "loop_json", "seal", "archived", "recording_erased", "void_reason_hash", "voided_by",
          "state_before_void"},
         "void_reason",
         "void_reason_hash",
         "EXISTS (SELECT 1 FROM erasure WHERE person_id IN (session.person_id, session.voided_by))"},
        {"trial",
         {"session_id", "ordinal"},
         {"session_id", "ordinal", "seed", "state", "first_tick", "last_tick", "marked", "timed_out", "scene_json"}},
        {"chunk",
         {"session_id", "sequence"},
         {"id", "session_id", "sequence", "first_tick", "frames", "payload_hash", "payload_digest", "force_hash"},
         "payload",
         "payload_hash",
         "EXISTS (SELECT 1 FROM session WHERE id = chunk.session_id AND recording_erased = 1)"},
        {"second_summary",
         {"session_id", "second", "tool"},
         {"session_id", "second", "tool", "frames", "path_length_m", "maximum_force_n", "mean_force_n", "impulse_ns",
          "time_over_limit_s", "events"}},
        {"event",
         {"session_id", "ordinal"},
         {"session_id", "ordinal", "tick", "time_s", "tool", "kind", "detail_json"}},
        {"score_set", {"id"}, {"id", "session_id", "ordinal", "utc", "passed", "trials", "scores", "seal"}},
        {"score",
         {"score_set_id", "trial", "metric"},
         {"score_set_id", "trial", "ordinal", "metric", "version", "unit", "value", "reason", "passed"}},
        {"session_comment", {"id"}, {"id", "session_id", "author_id", "utc", "text_hash"},
         "text",
         "text_hash",
         "EXISTS (SELECT 1 FROM erasure WHERE person_id IN (session_comment.author_id, (SELECT person_id FROM session "
         "WHERE id = session_comment.session_id)))"},
        {"erasure",
         {"person_id"},
         {"person_id", "utc", "reason", "administrator_id", "recordings_withdrawn", "digests_json"}},
    };
}

} // namespace

const std::vector<DigestedTable>& digestedTables() {
    static const std::vector<DigestedTable> tables = makeTables();
    return tables;
}

const DigestedTable& digestedTable(std::string_view name) {
    const auto& tables = digestedTables();
    const auto found = std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return t.name == name; });
    assert(found != tables.end());
    return *found;
}

RowDigest rowDigest(std::string_view table, std::span<const Value> values) {
    Hasher hasher;
    hasher.text("chiron-row-1");
    hasher.text(table);
    hasher.number(values.size());
    for (const Value& value : values) {
        add(hasher, value);
    }
    return hasher.result();
}

RowDigest bytesDigest(std::span<const std::uint8_t> bytes) {
    RowDigest digest{};
    crypto_generichash(digest.data(), digest.size(), bytes.data(), bytes.size(), nullptr, 0);
    return digest;
}

RowDigest textDigest(std::string_view text) {
    return bytesDigest({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string rawSelectList(const DigestedTable& table) {
    std::string list;
    for (const std::string_view name : table.columns) {
        const std::string column(name);
        list += (list.empty() ? "" : ", ");
        list += "typeof(" + column + "), CASE typeof(" + column + ") WHEN 'text' THEN CAST(" + column +
                " AS BLOB) ELSE " + column + " END";
    }
    return list;
}

} // namespace chiron::database
